"""What a stable form is, and where its arguments may be: said once, for people and for code.

Every argument is a finite number; how large it may be depends on the floats that compute with it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import sympy as sp
from sympy import And, Expr, Rational, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.forms.implicit import FractionalPart, SomePart, WholePart
from symhaptic.forms.response import closed
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, d, delta, epsilon, gamma, l, theta

HALF = Rational(1, 2)


class NoForm(ValueError):
    """The scene lacks what the form is about; the message says what."""


Pairs = tuple[tuple[Expr, Expr], ...]


@dataclass(frozen=True)
class Form:
    """One function to compute."""

    name: str
    title: str
    """What it gives, in a line of plain text."""
    arguments: tuple[Symbol, ...]
    results: tuple[tuple[str, Expr], ...]
    """Each result's name and its stable form."""
    derived: Callable[[], Pairs] = field(compare=False, repr=False)
    """Derives ``equal``; who only computes need not wait for it."""
    domain: tuple[str, ...]
    """Where it is meant, one condition each."""
    held: tuple[str, ...] = ()
    """Results that are largest at an angle that is searched for; the others are found there."""
    smooth: tuple[Expr, ...] = ()
    """The results in terms whose derivatives keep their digits; empty where ``results`` are."""
    plain: Form | None = None
    """The form without the derivatives that are among the results."""
    outside: sp.Basic = sp.nan
    """What every result is outside the domain: NaN, of a count -1, of a truth value false."""
    whole: bool = False
    """Whether it is for whole delays alone."""

    @property
    def truth(self) -> bool:
        """Whether it says yes or no: its expression is 1 or 0 then."""
        return self.outside is sp.false

    @property
    def within(self) -> tuple[Boolean, ...]:
        """For each argument, what is true inside its range alone."""
        found = map(within, self.arguments)
        return tuple(sp.And(c, sp.Eq(sp.floor(d), d)) if self.whole and c.has(d) else c
                     for c in found)  # fmt: skip

    @cached_property
    def equal(self) -> Pairs:
        """Pairs, stable and derived from physics, that together make it the same formula."""
        return self.derived()

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """The stable forms alone."""
        return tuple(expr for _, expr in self.results)

    @property
    def differentiated(self) -> tuple[Expr, ...]:
        """The same in terms whose derivatives keep their digits."""
        return tuple(map(closed, self.smooth or self.expressions))


def present(parts: Parts, *symbols: Symbol) -> tuple[Symbol, ...]:
    """Those of the symbols that the scene has."""
    missing = {
        gamma: not parts.stiffness,
        delta: not parts.damping,
        beta: not parts.virtual_damping,
        d: not parts.delay,
    }
    return tuple(s for s in symbols if not missing.get(s, False))


def either(whole: Expr, late: Expr) -> Expr:
    """One form for whole delays, another one for those with a fraction."""
    found = late.xreplace({epsilon: SomePart(d), l: WholePart(d)})
    return sp.Piecewise((whole, sp.Eq(FractionalPart(d), 0)), (found, True))


def undelayed(parts: Parts, expr: Expr) -> Expr:
    """Without the delay that the scene has not."""
    return expr if parts.delay else expr.subs(d, 0)


def steps_of(parts: Parts, delay: int | None, name: str) -> int:
    """The periods that a form for one delay is made for."""
    if not parts.delay:
        if delay:
            raise NoForm(f"{name}: the scene has no delay, and {delay} periods are asked for")
        return 0
    if delay is None:
        raise NoForm(f"{name}: is made for one whole delay, which has to be given")
    return delay


__all__ = [
    "HALF", "Form", "NoForm", "Pairs", "domain", "either", "present", "steps_of", "undelayed",
]  # fmt: skip


# -- Where the arguments of a form may be: each said once, for people and for code ----------------


LARGEST, STIFFEST, LONGEST, BELOW_PI = sp.symbols("LARGEST STIFFEST LONGEST BELOW_PI")
"""The largest size of a number, the stiffest plant, the longest delay, the last float before pi."""

_RANGES: dict[Symbol, tuple[str, Boolean]] = {
    alpha: ("", sp.Abs(alpha) <= LARGEST),
    beta: ("", sp.Abs(beta) <= LARGEST),
    gamma: ("gamma >= 0", And(gamma >= 0, gamma <= STIFFEST)),
    delta: ("delta >= 0", And(delta >= 0, delta <= LARGEST)),
    d: ("d >= 0", And(d >= 0, d <= LONGEST)),
    epsilon: ("0 <= epsilon < 1", And(epsilon >= 0, epsilon < 1)),
    theta: ("0 < theta < pi", And(theta > 0, theta <= BELOW_PI)),
}
"""In words, where not every finite number is allowed, and as what is true inside alone.

NaN makes a comparison false: a condition is never to be turned round into what is true outside.
"""


def domain(symbols: tuple[Symbol, ...], *more: str) -> tuple[str, ...]:
    """Where these symbols may be, and more conditions."""
    return (*(_RANGES[s][0] for s in symbols if _RANGES[s][0]), *more)


def within(symbol: Symbol) -> Boolean:
    """What is true of an argument inside its range, and false for NaN and infinities.

    >>> within(alpha)
    Abs(alpha) <= LARGEST
    """
    return _RANGES[symbol][1]
