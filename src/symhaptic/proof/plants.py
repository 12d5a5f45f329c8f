"""The sampled plant's numbers in balls, where the plant's parameters are intervals.

From the exponential of the plant's matrix, an entire function: nothing is divided, so that no
interval of parameters is a hard one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property

import sympy as sp
from flint import acb, arb, arb_mat, ctx
from sympy import Expr

from symhaptic.model import plant
from symhaptic.model.parts import FULL
from symhaptic.notation import a, delta, e, gamma, n_1
from symhaptic.proof.ball import ball
from symhaptic.proof.certificate import Balls, Given

LOSS, TOGETHER, LATE, AT_ONE = NUMBERS = sp.symbols("L S n_0 q")
"""1 - e, n_1 + n_0, n_0 and 1 - a + e."""

BALLS = {n_1: TOGETHER - LATE, e: 1 - LOSS, a: 2 - LOSS - AT_ONE}
"""The plant's numbers by these four."""

SLOPES = sp.symbols("L' S' n_0' q'")
"""Their derivatives with respect to delta."""


def numbers(at: Mapping[sp.Symbol, acb], sloped: bool) -> dict[sp.Symbol, acb]:
    """Balls of the four numbers, and of their derivatives, for balls of gamma and delta.

    n_0 is the response to the first of two periods of force (chapter s4a_discretisation has the
    samples).
    """
    key = (sloped, ctx.prec, *(end for s in (gamma, delta) for end in _ends(at[s])))
    if key not in _KNOWN:
        found = with_slopes(at[gamma].real, at[delta].real, (delta,) if sloped else ())
        names = zip(NUMBERS, SLOPES, strict=True)
        _KNOWN[key] = {
            name: acb(value)
            for symbols, values in zip(names, found, strict=True)
            for name, value in zip(symbols, values, strict=False)
        }
    return _KNOWN[key]


_KNOWN: dict[tuple[object, ...], dict[sp.Symbol, acb]] = {}
"""Numbers of plants, by precision and intervals; many questions ask for the same ones."""


def _ends(value: acb) -> tuple[object, object]:
    return value.real.mid().man_exp(), value.real.rad().man_exp()


def with_slopes(g: arb, dl: arb, by: tuple[sp.Symbol, ...]) -> tuple[tuple[arb, ...], ...]:
    """L, S, n_0 and q, each followed by its derivatives with respect to gamma or delta.

    n_0 is exp(-delta) times n_1 of the plant whose time runs backwards, that is with -delta.
    """
    fall = (-dl).exp()
    falls = [-fall if s == delta else arb(0) for s in by]
    first, *rise = _held(g, dl, by)
    back, *rise_back = _held(g, -dl, by)
    late, both = fall * back, first + fall * back
    by_late = [
        f * back + (-fall if s == delta else fall) * r
        for s, f, r in zip(by, falls, rise_back, strict=True)
    ]
    by_both = [r + s for r, s in zip(rise, by_late, strict=True)]
    by_one = [g * b + both if s == gamma else g * b for s, b in zip(by, by_both, strict=True)]
    return (
        (1 - fall, *(-f for f in falls)),
        (both, *by_both),
        (late, *by_late),
        (g * both, *by_one),
    )


_ENTRIES = (gamma, -gamma, delta, -delta)


@cache
def _motion(by: tuple[sp.Symbol, ...]) -> list[list[int | arb]]:
    """exp([[X, X', ...], [0, X, 0], ...]) has exp(X) and its slopes in its first rows.

    An entry is a number, or a place in gamma, -gamma, delta, -delta.
    """
    device = plant.normalised(FULL)
    whole = sp.zeros(3, 3)
    whole[:2, :2], whole[:2, 2] = device.state_matrix, device.input_matrix
    large = sp.diag(*[whole] * (len(by) + 1))
    for i, symbol in enumerate(by, 1):
        large[:3, 3 * i : 3 * i + 3] = whole.diff(symbol)
    return [
        [_ENTRIES.index(x) if x.free_symbols else arb(int(x)) for x in large.row(i)]
        for i in range(large.rows)
    ]


def _held(g: arb, dl: arb, by: tuple[sp.Symbol, ...]) -> tuple[arb, ...]:
    """Position after a period of unit force, and its derivatives."""
    entries = (g, -g, dl, -dl)
    rows = [[entries[x] if isinstance(x, int) else x for x in row] for row in _motion(by)]
    grown = arb_mat(rows).exp()
    return tuple(grown[0, 3 * i + 2] for i in range(len(by) + 1))


@dataclass(frozen=True)
class Named:
    """Balls of expressions in the plant's numbers, computed once for an interval of the plant."""

    meanings: Mapping[sp.Symbol, Expr]
    _known: dict[tuple[object, ...], dict[sp.Symbol, acb]] = field(
        default_factory=dict, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        object.__setattr__(self, "meanings", dict(self.meanings))  # read once

    @cached_property
    def of(self) -> Sequence[sp.Symbol]:
        """Gamma, delta and what else the expressions are made of."""
        return gamma, delta, *sorted(self._made - {gamma, delta, *NUMBERS, *SLOPES}, key=str)

    @cached_property
    def _made(self) -> frozenset[sp.Symbol]:
        return frozenset().union(*(expr.free_symbols for expr in self.meanings.values()))

    def numbers(self, at: Balls) -> Balls:
        """Balls of the plant's numbers, and of their slopes where an expression has them."""
        return numbers(at, not self._made.isdisjoint(SLOPES))

    def __call__(self, at: Balls) -> Balls:
        """Balls of the expressions, for balls of gamma, delta and what else occurs in them."""
        key = tuple(end for s in self.of for end in _ends(at[s]))
        if key not in self._known:
            values = {**at, **self.numbers(at)}
            named = {s: ball(expr, values, ctx.prec) for s, expr in self.meanings.items()}
            self._known[key] = named
        return self._known[key]

    def __reduce__(self) -> tuple[type[Named], tuple[Mapping[sp.Symbol, Expr]]]:
        return Named, (self.meanings,)  # what is known is not part of a certificate


def named(meanings: Mapping[sp.Symbol, Expr]) -> Given:
    """What :class:`Named` finds, for an inequality on a box of plants."""
    return Named(meanings)
