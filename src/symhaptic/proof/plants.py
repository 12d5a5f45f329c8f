"""The sampled plant's numbers in balls, where the plant's parameters are intervals.

From the exponential of the plant's matrix, an entire function: nothing is divided, so that no
interval of parameters is a hard one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TypeAlias

import sympy as sp
from flint import acb, arb_mat, ctx
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

Dual: TypeAlias = tuple[acb, acb]
"""Value and derivative with respect to delta."""


def numbers(at: Mapping[sp.Symbol, acb]) -> dict[sp.Symbol, acb]:
    """Balls of the four numbers and of their derivatives, for balls of gamma and delta.

    n_0 is the response to the first of two periods of force: exp(-delta) times n_1 of the plant
    whose time runs backwards, that is with -delta (chapter s4a_discretisation has the samples).
    """
    key = (ctx.prec, *(end for s in (gamma, delta) for end in _ends(at[s])))
    if key not in _KNOWN:
        _KNOWN[key] = _numbers(at)
    return _KNOWN[key]


_KNOWN: dict[tuple[object, ...], dict[sp.Symbol, acb]] = {}
"""Numbers of plants, by precision and intervals; many questions ask for the same ones."""


def _ends(value: acb) -> tuple[object, object]:
    return value.real.mid().man_exp(), value.real.rad().man_exp()


def _numbers(at: Mapping[sp.Symbol, acb]) -> dict[sp.Symbol, acb]:
    first = _held(at)
    fall = (-at[delta]).exp()
    back = _held({**at, delta: -at[delta]})
    late = (fall * back[0], -fall * back[0] - fall * back[1])
    together = (first[0] + late[0], first[1] + late[1])
    found: tuple[Dual, ...] = (
        (1 - fall, fall),
        together,
        late,
        (at[gamma] * together[0], at[gamma] * together[1]),
    )
    values = dict(zip(NUMBERS, (v for v, _ in found), strict=True))
    return values | dict(zip(SLOPES, (slope for _, slope in found), strict=True))


@cache
def _motion() -> tuple[tuple[Expr, ...], ...]:
    """The rows whose exponential has the response to a held force, and its slope, in them."""
    device = plant.normalised(FULL)
    whole = sp.zeros(3, 3)
    whole[:2, :2], whole[:2, 2] = device.state_matrix, device.input_matrix
    twice = sp.zeros(6, 6)  # exp([[X, X'], [0, X]]) has exp(X)' in its upper right block
    twice[:3, :3] = twice[3:, 3:] = whole
    twice[:3, 3:] = whole.diff(delta)
    return tuple(tuple(twice.row(i)) for i in range(6))


def _held(at: Mapping[sp.Symbol, acb]) -> Dual:
    """Position after a period of unit force, and its derivative with respect to delta."""
    known = {entry: ball(entry, at, ctx.prec).real for row in _motion() for entry in set(row)}
    grown = arb_mat([[known[entry] for entry in row] for row in _motion()]).exp()
    return acb(grown[0, 2]), acb(grown[0, 5])


@dataclass(frozen=True)
class Named:
    """Balls of expressions in the plant's numbers, computed once for an interval of the plant."""

    meanings: Mapping[sp.Symbol, Expr]
    _known: dict[tuple[object, ...], dict[sp.Symbol, acb]] = field(
        default_factory=dict, repr=False, compare=False
    )
    of: Sequence[sp.Symbol] = (gamma, delta)

    def numbers(self, at: Balls) -> Balls:
        """Balls of the plant's numbers and of their slopes."""
        return numbers(at)

    def __call__(self, at: Balls) -> Balls:
        """Balls of the expressions, for balls of gamma, delta and what else occurs in them."""
        key = tuple(end for s in self.of for end in _ends(at[s]))
        if key not in self._known:
            values = {**at, **numbers(at)}
            named = {s: ball(expr, values, ctx.prec) for s, expr in self.meanings.items()}
            self._known[key] = named
        return self._known[key]

    def __reduce__(self) -> tuple[type[Named], tuple[Mapping[sp.Symbol, Expr]]]:
        return Named, (self.meanings,)  # what is known is not part of a certificate


def named(meanings: Mapping[sp.Symbol, Expr]) -> Given:
    """What :class:`Named` finds, for an inequality on a box of plants."""
    return Named(meanings)
