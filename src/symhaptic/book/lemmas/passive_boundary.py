"""Walls of (7) are on the boundary of the passive ones, behind whole delays."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, not_zero
from symhaptic.book.lemmas.corners import on_envelope, single, wide
from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.linear_part import shares
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    bordering,
    limits,
    measured,
    needed,
    on_first_half,
    sufficient,
)
from symhaptic.notation import b
from symhaptic.proof.theorems.familiar import bounded

TWICE = {N: 2 * d + 2, phi: omega * T / 2}
ANGLE = omega * T / 2


@cache
def _place() -> list[Theorem]:
    """2 <= 2 (d+1), 0 < omega T/2 and (d+1) omega T < pi below the end of the envelope."""
    more, end = shares()[0], assume(omega < pi / (T * (d + 1)))
    size = positive(T * (d + 1) > 0, [T > 0, more])
    below = positive(ANGLE * (2 * d + 2) < pi, [size, end])
    return [
        positive(2 * d + 2 >= 2, [2, d >= 0]),
        positive(ANGLE > 0, [HALF, omega > 0, T > 0]),
        closed(below, not_zero(size)),
    ]


def inside(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (7) with 0 < omega T < pi/(d+1) is on the boundary."""
    found = closed(inst(on_envelope(), {**TWICE, psi: phi}), *_place())
    margin = measured(stiffness, damping, [assume(b >= 0), found])
    always = on_first_half(margin)
    shared = closed(inst(wide(phi), TWICE), *_place())
    full = ANGLE * (2 * d + 2)
    more = shares()[0]
    low = positive(full >= 0, [_place()[1], positive(2 * d + 2 > 0, [2, more])])
    up = closed(weak_sine(full), low, positive(full <= pi, full < pi), *_place())
    above = 8 * (d + 1) * sin(ANGLE) ** 2 * sin(full)
    below = T * ((2 * d + 2) * sin(omega * T) - sin(2 * full))
    top = positive(above >= 0, [8, more, square(sin(ANGLE)), up])
    bottom = positive(below > 0, [T > 0, shared])
    slope = over(above / below >= 0, top, bottom)
    pushes = combined(K >= 0, [assume(b >= 0), slope], [stiffness, -S.One])
    apart = not_zero(shared), not_zero(bottom)
    passive = closed(sufficient(), always, closed(pushes, *apart))
    there = at(inst(needed(), {b: x}), {phi: ANGLE}, *_place()[1:])
    return bordering(passive, closed(_least(there, stiffness, damping), *apart))


def _least(there: Theorem, stiffness: Theorem, damping: Theorem) -> Theorem:
    """b <= x for the damping x of a passive wall of (7), from its margin at its own angle."""
    full = ANGLE * (2 * d + 2)
    of_stiffness = T / 2 * (cos(full) - cos(ANGLE) * sin(full) / sin(ANGLE))
    found = combined(b <= x, [there], [stiffness, of_stiffness], [damping, cos(full)])
    return closed(found, *map(not_zero, (_sine(),)))


def _sine() -> Theorem:
    """0 < sin(omega T/2)."""
    wave = inst(single(phi), TWICE)
    return closed(wave, *_place())


def of_the_end(stiffness: Expr, damping: Expr, equation: Theorem) -> tuple[Theorem, Theorem]:
    """What (7) gives for omega T = pi/(d+1) is 0 and b."""
    turn, angle = (d + 1) * omega * T, omega * T
    half = combined(Eq(pi, turn), [equation, -T * (d + 1)])
    zero, one = identity(S.Zero, S.Zero), identity(S.NegativeOne, S.NegativeOne)
    none = subst(Eq(sin(phi), 0), phi, zero, half)
    low = subst(Eq(cos(phi), -1), phi, one, half)
    bottom = 1 / (sin((2 * d + 2) * angle) - (2 * d + 2) * sin(angle))
    rest = 2 * d - 2 * (d + 1) * cos(angle) - 2 * cos(turn)
    spring = combined(Eq(stiffness, 0), [none, 4 * b * (d + 1) * (cos(angle) - 1) * bottom / T])
    damper = combined(
        Eq(damping, b),
        [none, b * rest * bottom],
        [low, 2 * b * (d + 1) * sin(angle) * bottom],
    )
    wave = closed(
        sign_of(sin, angle),
        positive(angle > 0, [omega > 0, T > 0]),
        closed(positive(angle < pi, [T > 0, omega < pi / T]), not_zero(assume(T > 0))),
    )
    more = positive(2 * d + 2 > 0, [2, shares()[0]])
    apart = combined(Ne(1 / bottom, 0), [more, wave], [none, 2 * cos(turn)])
    return closed(spring, apart), closed(damper, apart)


def at_the_end(stiffness: Theorem, damping: Theorem, equation: Theorem) -> Theorem:
    """The wall of (7) with omega T = pi/(d+1) is (0, b), which is on the boundary."""
    lines: Any = stiffness.conclusion, damping.conclusion
    none, full = of_the_end(lines[0].right, lines[1].right, equation)
    spring = combined(Eq(K, 0), [stiffness, S.One], [none, S.One])
    damper = combined(Eq(B, b), [damping, S.One], [full, S.One])
    wave = cos(phi * (2 * d + 2))
    up = combined(1 + wave >= 0, [HALF, square(1 + wave)], [HALF, bounded(cos, phi * (2 * d + 2))])
    margin = measured(spring, damper, [assume(b >= 0), up])
    pushes = combined(K >= 0, [spring, -S.One])
    passive = closed(sufficient(), on_first_half(margin), pushes)
    least = combined(b <= x, [inst(limits()[0], {b: x})], [spring, -T / 2], [damper, -S.One])
    return closed(bordering(passive, least), not_zero(assume(T > 0)))


def on_boundary(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (7) with 0 < omega T <= pi/(d+1) is on the boundary."""
    end = pi / (T * (d + 1))
    before = strictly(assume(omega <= end), assume(Ne(omega, end)))
    beside = at_the_end(stiffness, damping, assume(Eq(omega, end)))
    found = disj_cases(decided(omega, end), beside, closed(inside(stiffness, damping), before))
    divisors = not_zero(assume(T > 0)), not_zero(shares()[0])
    return closed(found, not_zero(positive(T * (d + 1) > 0, [T > 0, shares()[0]])), *divisors)
