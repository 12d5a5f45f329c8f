"""Derivatives of stable forms, which are stable forms again.

Some products have a derivative that loses digits when it is taken factor by factor, such as
gamma Together = 1 - a + e; these are differentiated as a whole.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import sympy as sp
from sympy import Expr, Symbol, exp, sin

from symhaptic.model.entire import Chord, CosNext, Decay, Entire, Fade, Gap, Lag, S, Sinc, SinNext
from symhaptic.model.entire_device import Apart, Fall, Together
from symhaptic.model.slopes import STABLE, ApartDrop, Echo, Kick, Ripple
from symhaptic.model.stable import Form, NoForm
from symhaptic.notation import delta, gamma

_PLAIN = (sp.exp, sp.sin, sp.cos, sp.tan, Entire)

_WHOLE: tuple[tuple[Expr, dict[Symbol, Expr]], ...] = (
    (
        gamma * Together(gamma, delta),
        {gamma: Kick(gamma, delta), delta: -gamma * Fall(gamma, delta)},
    ),
    (
        delta * Apart(gamma, delta),
        {
            gamma: -delta * ApartDrop(gamma, delta),
            delta: Fall(gamma, delta) - 2 * Echo(gamma, delta),
        },
    ),
    (delta * Decay(delta), {delta: exp(-delta)}),
    (delta * Lag(delta), {delta: Fade(delta) - 2 * Lag(delta)}),
    (gamma * S(-gamma / 4) ** 2, {gamma: S(-gamma)}),
)
"""Products and their derivatives: 1 - a + e, n1 - n0, 1 - e, and these without spring or damper."""


class _By:
    """Derivatives by one symbol, each subexpression done once."""

    def __init__(self, by: Symbol) -> None:
        self.by = by
        self.known: dict[Expr, Expr] = {by: sp.S.One}
        self.whole = [(whole, slopes[by]) for whole, slopes in _WHOLE if by in slopes]

    def __call__(self, expr: Expr) -> Expr:
        """The derivative of an expression."""
        if expr not in self.known:
            self.known[expr] = self._found(expr) if expr.has(self.by) else sp.S.Zero
        return self.known[expr]

    def _found(self, expr: Expr) -> Expr:
        if expr.is_Add:
            return sp.Add(*map(self, expr.args))
        if expr.is_Mul:
            return self._product(expr)
        if expr.is_Pow:
            base, power = expr.args
            return power * base ** (power - 1) * self(base)
        if isinstance(expr, Entire) and type(expr) not in STABLE:
            raise NoForm(f"no stable derivative of {type(expr).__name__} is known")
        return sp.Add(*(expr.fdiff(i + 1) * self(arg) for i, arg in enumerate(expr.args)))

    def _product(self, expr: Expr) -> Expr:
        powers = expr.as_powers_dict()
        for whole, slope in (*self.whole, *self._waves(expr)):
            parts = whole.as_powers_dict()
            times = min(powers.get(base, 0) / power for base, power in parts.items())
            if times >= 1:
                rest, times = expr / whole ** int(times), int(times)
                return whole ** (times - 1) * (times * slope * rest + whole * self(rest))
        first, *others = expr.args
        rest = sp.Mul(*others)
        return self(first) * rest + first * self(rest)

    def _waves(self, expr: Expr) -> Iterator[tuple[Expr, Expr]]:
        """sin((k + 1) x) over sin(x) or over x, with its derivative."""
        for wave in expr.args:
            if isinstance(wave, SinNext):
                k, x = wave.args
                turned = CosNext(k, x)
                yield wave / sin(x), self(k) * x * turned / sin(x) + self(x) * Ripple(k, x)
                flat = (wave * Gap(x) - x * Chord(k, x) / 2) / Sinc(x)
                yield wave / x, self(k) * turned + self(x) * flat


def derivative(expr: Expr, by: Symbol) -> Expr:
    """The derivative of a stable form, again a stable form.

    >>> derivative(delta * Decay(delta), delta)
    exp(-delta)
    >>> derivative(gamma * Together(gamma, delta), gamma)
    Kick(gamma, delta)
    """
    return _By(by)(expr)


def counting(form: Form) -> list[str]:
    """What a form is made of that is not smooth."""
    functions = {f for e in form.expressions for f in e.atoms(sp.Function)}
    return sorted({type(f).__name__ for f in functions if not isinstance(f, _PLAIN)})


def with_derivatives(form: Form, by: tuple[str, ...]) -> Form:
    """The form with, beside each result r, its derivative r_by_x for every argument x asked for.

    Raises :class:`NoForm` for what is no argument, and for what counts.
    """
    symbols = {s.name: s for s in form.arguments}
    for name in by:
        if name not in symbols:
            raise NoForm(f"{form.name}: has no argument {name!r}; it has {', '.join(symbols)}")
    if rough := counting(form):
        raise NoForm(f"{form.name}: has no derivative, since {', '.join(rough)} counts or searches")
    every = {name: _By(symbols[name]) for name in by}
    slopes = tuple(
        (f"{result}_by_{name}", every[name](expr))
        for name, (result, expr) in product(by, form.results)
    )
    return replace(
        form,
        name=f"{form.name}_and_derivatives",
        title=f"{form.title}; and its derivatives with respect to {', '.join(by)}",
        results=(*form.results, *slopes),
        plain=form,
    )
