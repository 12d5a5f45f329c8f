"""The stiffest passive wall behind a whole delay: the tip of the envelope."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.corners import stiffest
from symhaptic.book.lemmas.linear_part import shares
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    measured,
    needed,
    on_first_half,
    sufficient,
)
from symhaptic.notation import b

TURN = pi / (4 * (d + 1))
"""Half the angle at which damping does nothing, theta = pi/(2 (d+1))."""


@cache
def waves() -> dict[str, Theorem]:
    """0 < sine and cosine of TURN and of twice it; d >= 0."""
    more = shares()[0]
    quarter = over(TURN > 0, number(Relation(S.Zero, "<", pi / 4)), more)
    rest = positive(pi * d / 2 + pi / 4 > 0, [HALF, PI, d >= 0], [HALF / 2, PI])
    below = positive(pi / 2 > TURN, [over(pi / 2 - TURN > 0, rest, more)])
    less = positive(pi > TURN, [below], [HALF, PI])
    found = {
        "sine": closed(sign_of(sin, TURN), quarter, less),
        "cosine": closed(
            sign_of(cos, TURN), positive(-pi / 2 < TURN, [quarter], [HALF, PI]), below
        ),
        "turn": quarter,
        "below": below,
    }
    found["double"] = positive(sin(2 * TURN) > 0, [2, found["sine"], found["cosine"]])
    return {name: closed(t, not_zero(more)) for name, t in found.items()}


@cache
def divisors() -> tuple[Theorem, ...]:
    """What (11) and the tip divide by is not zero."""
    known = waves()
    co = positive(cos(pi * d / (2 * (d + 1))) > 0, [known["double"]])
    found = [known[n] for n in ("sine", "cosine", "double")]
    more = shares()[0]
    product = positive((d + 1) * sin(2 * TURN) > 0, [more, known["double"]])
    found += [co, *shares(), assume(T > 0), product]
    found += [positive(4 * d + 4 > 0, [4, more]), positive(2 * d + 2 > 0, [2, more])]
    return tuple(map(not_zero, found))


def stiffest_wall(stiffness: Theorem, damping: Theorem) -> Theorem:
    """The wall of (11) is passive, and no passive one is stiffer; d is whole."""
    found = inst(stiffest(), {psi: phi, N: 2 * d + 2})
    found = closed(found, positive(2 * d + 2 >= 2, [2, d >= 0]))
    always = on_first_half(measured(stiffness, damping, [assume(b >= 0), found]))
    pushes = combined(K >= 0, [assume(b >= 0), slope()], [stiffness, -S.One])
    passive = closed(sufficient(), always, pushes, *divisors())
    return conj(passive, largest(stiffness))


def per_damping() -> Expr:
    """The largest stiffness per damping, 2/T tan(pi/(4 (d+1)))."""
    return 2 * (1 - cos(2 * TURN)) / (T * sin(2 * TURN))


@cache
def slope() -> Theorem:
    """0 < 2/T tan(pi/(4 (d+1)))."""
    known = waves()
    top = positive(2 * (1 - cos(2 * TURN)) > 0, [4, known["sine"], known["sine"]])
    bottom = positive(T * sin(2 * TURN) > 0, [T > 0, known["double"]])
    return closed(over(per_damping() > 0, top, bottom), not_zero(bottom))


@cache
def bound() -> Theorem:
    """K <= 2b/T tan(pi/(4 (d+1))) for every passive wall; d is whole."""
    more = shares()[0]
    half = over((2 * d + 2) * TURN < pi, positive(pi * (d + 1) / 2 > 0, [HALF, PI, more]), more)
    there = at(needed(), {phi: TURN}, waves()["turn"], half)
    found = positive(b * per_damping() >= K, [slope(), there])
    return closed(found, *divisors())


def largest(stiffness: Theorem) -> Theorem:
    """No passive wall is stiffer than that of (11)."""
    other = inst(bound(), {K: x, B: y})
    found = combined(x <= K, [other], [stiffness, -S.One])
    return for_all([x, y], [PASSIVE.at({K: x, B: y})], closed(found, *divisors()))


def largest_of(printed: Any, delay: int) -> tuple[Theorem, Theorem, Expr]:
    """The largest stiffness of a delay: its wall is passive, none is stiffer, and its value."""
    wall = stiffest_wall(*map(assume, printed))
    at_delay = {d: S(delay)}
    values = {line.lhs: line.rhs.xreplace(at_delay) for line in printed}
    there = inst(wall, at_delay | values)
    known = [identity(value, value) for value in values.values()]
    passive = conjunct(closed(there, *known, *_at(delay)), PASSIVE.at(at_delay | values))
    least = closed(inst(bound(), at_delay), *_at(delay))
    return passive, least, values[K]


def _at(delay: int) -> list[Theorem]:
    """A delay that is a number is whole, and not negative."""
    return [is_whole(S(delay)), number(Relation(S.Zero, "<=", S(delay)))]
