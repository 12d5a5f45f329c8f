"""Walls of (7) are on the boundary of the passive ones, with integer delays."""

from symhaptic.book.lemmas.corners import on_envelope, single, wide
from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    DELAY,
    bordering,
    limits,
    measured,
    needed,
    on_first_half,
    sufficient,
)

TWICE = {N: 2 * d + 2, phi: omega * T / 2}
ANGLE = omega * T / 2


BELOW = DELAY.and_(omega > 0, omega < pi / (T * (d + 1)))
"""Below the end of the envelope."""
TURNS = ANGLE * (2 * d + 2)


def inside(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (7) with 0 < omega T < pi/(d+1) is on the boundary."""
    turn = BELOW.show(pi > TURNS, degree=3)
    here = BELOW.and_(turn)
    found = here.closed(inst(on_envelope(), {**TWICE, psi: phi}))
    always = on_first_half(measured(stiffness, damping, [assume(b >= 0), found]))
    shared = here.closed(inst(wide(phi), TWICE))
    up = here.closed(weak_sine(TURNS))
    above = 8 * (d + 1) * sin(ANGLE) ** 2 * sin(TURNS)
    below = T * ((2 * d + 2) * sin(omega * T) - sin(2 * TURNS))
    slope = here.show(above / below >= 0, up, square(sin(ANGLE)), shared)
    pushes = combined(K >= 0, [assume(b >= 0), slope], [stiffness, -S.One])
    passive = closed(sufficient(), always, here.closed(pushes, shared))
    there = at(inst(needed(), {b: x}), {phi: ANGLE}, here.show(ANGLE > 0), turn)
    least = here.closed(_least(there, stiffness, damping), _sine(), shared)
    return bordering(passive, least)


def _least(there: Theorem, stiffness: Theorem, damping: Theorem) -> Theorem:
    """b <= x for the damping x of a passive wall of (7), from its margin at its own angle."""
    of_stiffness = T / 2 * (cos(TURNS) - cos(ANGLE) * sin(TURNS) / sin(ANGLE))
    return combined(b <= x, [there], [stiffness, of_stiffness], [damping, cos(TURNS)])


def _sine() -> Theorem:
    """0 < sin(omega T/2)."""
    return BELOW.closed(inst(single(phi), TWICE))


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
        Eq(damping, b), [none, b * rest * bottom], [low, 2 * b * (d + 1) * sin(angle) * bottom]
    )
    here = DELAY.and_(omega > 0, omega < pi / T)
    wave = here.show((2 * d + 2) * sin(angle) > 0)
    apart = combined(Ne(1 / bottom, 0), [wave], [none, 2 * cos(turn)])
    return here.closed(closed(spring, apart)), here.closed(closed(damper, apart))


def at_the_end(stiffness: Theorem, damping: Theorem, equation: Theorem) -> Theorem:
    """The wall of (7) with omega T = pi/(d+1) is (0, b), which is on the boundary."""
    lines: Any = stiffness.conclusion, damping.conclusion
    none, full = of_the_end(lines[0].right, lines[1].right, equation)
    spring, damper = show(Eq(K, 0), stiffness, none), show(Eq(B, b), damping, full)
    wave = cos(phi * (2 * d + 2))
    up = show(1 + wave >= 0, square(1 + wave), bounded(cos, phi * (2 * d + 2)))
    margin = measured(spring, damper, [assume(b >= 0), up])
    passive = closed(sufficient(), on_first_half(margin), show(K >= 0, spring))
    least = show(b <= x, inst(limits()[0], {b: x}), spring, damper)
    return DELAY.closed(bordering(passive, least))


def on_boundary(stiffness: Theorem, damping: Theorem) -> Theorem:
    """A wall of (7) with 0 < omega T <= pi/(d+1) is on the boundary."""
    end = pi / (T * (d + 1))
    before = strictly(assume(omega <= end), assume(Ne(omega, end)))
    beside = at_the_end(stiffness, damping, assume(Eq(omega, end)))
    found = disj_cases(decided(omega, end), beside, closed(inside(stiffness, damping), before))
    return DELAY.closed(found)
