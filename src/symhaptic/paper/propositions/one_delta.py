"""The claim of Sec. V that one delta describes a device with an arm, for passivity and stability.

By (2), the mass and damping of Table I are those of device and arm. By (3), only the damping of the
device counts for passivity.
"""

from __future__ import annotations

from symhaptic.notation import x, y
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions.comparison import STABLE, passive
from symhaptic.paper.propositions.digits import number, quoted
from symhaptic.paper.propositions.passivity import FIVE, PASSIVE, at_every_frequency
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.ratio import BEST, WALL, outdoes, stable
from symhaptic.paper.ranges import DAMPED

MASS = m_D + m_H
OWN, WHOLE = T * b_D / MASS, T * (b_D + b_H) / MASS
"""The damping of the device alone, and of device and arm, in the parameters of Table I."""
SPRING = T**2 * k_H / MASS
UNITS = {alpha: K * T**2 / MASS, beta: B * T / MASS}
"""The wall in the parameters of Table I, with the mass of (2)."""
HAND = (T, m_D, m_H, b_D, b_H)
HELD = [T > 0, m_D > 0, *(part >= 0 for part in (m_H, b_D, b_H)), d >= 0]
"""A device and an arm; without an arm m_H = b_H = 0."""

MEETS = at_every_frequency(FIVE).at({b: b_D})
"""The wall meets (5) with the damping b_D of the device alone, by (3)."""


def drawn(damping: Expr = WHOLE, scale: Expr = S.One) -> Proposition:
    """``scale`` times the wall meets (5) in the parameters of Table I with this delta."""
    return passive().at({s: scale * v for s, v in UNITS.items()}).at({delta: damping})


@claims("one-delta")
def _one_delta(printed: Printed) -> Proposition:
    """A wall meets (5) with the delta of device and arm if and only if it meets (5) with (3)."""
    return ForAll((*HAND, K, B, d), implied(HELD, Iff((drawn(), MEETS))))


def instead() -> Proposition:
    """The claim is true with delta_D of the device alone, and passive walls stay stable."""
    right = ForAll((*HAND, K, B, d), implied(HELD, Iff((drawn(OWN), MEETS))))
    return both([right, kept(), outdone()])


def kept() -> Proposition:
    """For an integer d, a wall with K > 0 that meets (5) with (3) is stable with every arm."""
    loop = STABLE.at({**UNITS, gamma: SPRING, delta: WHOLE})
    given = [*HELD, k_H >= 0, whole(d), K > 0, MEETS]
    return ForAll((*HAND, k_H, K, B, d), implied(given, loop))


def outdone() -> Proposition:
    """Some wall that is stable with the arm is 1 + b_H/b_D times as stiff as all passive walls.

    A passive wall is passive with the device alone. The claim is for every integer delay.
    """
    loop = STABLE.at({alpha: x, beta: y, gamma: SPRING, delta: WHOLE})
    softer = (b_D + b_H) * UNITS[alpha] <= b_D * x
    others = ForAll((K, B), implied([PASSIVE.at({b: b_D})], softer))
    given = [*HELD, k_H >= 0, whole(d), b_D + b_H > 0]
    return ForAll((*HAND, k_H, d), implied(given, Exists(BEST, both([loop, others]))))


# -- one arm in numbers ------------------------------------------------------------------------

LIMITS = {
    T: Rational(1, 1000),
    m_D: S.One,
    m_H: S.One,
    b_D: Rational("0.625"),
    b_H: Rational("14.6"),
    k_H: S(710),
}
"""A device and an arm of one kilogram each, at the limits of (21) and of Sec. IV-C, at 1 kHz."""
ARM = {gamma: SPRING.subs(LIMITS), delta: WHOLE.subs(LIMITS)}
DEVICE = OWN.subs(LIMITS)
RATIOS = {"one": (Rational("45.7"), Rational("45.8")), "own": (S(1114), S(1115))}
"""Intervals of the ratio of the two stiffnesses, with one delta and with delta_D."""


def beside(damping: Expr) -> Proposition:
    """Some wall is passive without delay with this damping of the device."""
    return PASSIVE.at({K: alpha, B: beta, b: damping, T: S.One, d: S.Zero})


def ratios() -> Proposition:
    """The ratio of the largest stable to the largest passive stiffness, for the arm at the limits.

    The claim is without delay, with the damping of both in (5) and with that of the device alone.
    """
    parts = []
    for damping, (low, high) in ((ARM[delta], RATIOS["one"]), (DEVICE, RATIOS["own"])):
        other, best = beside(damping), beside(damping).at(dict(zip(WALL, BEST, strict=True)))
        parts += [
            outdoes(stable(0, BEST), other, low * alpha < x),
            outdoes(best, stable(0), alpha < high * x),
        ]
    return both(parts).at(ARM)


FIGURES = 32
"""Ratio of 0.02 to the largest delta_D of a device of Sec. IV-C, at 1 ms."""


def oversized() -> Proposition:
    """32 times a wall that meets (5) with (3) meets (5) with the delta of Figs. 11 and 13.

    The claim is for devices of Sec. IV-C, b_D/m_D <= 0.625 1/s, and periods up to 1 ms.
    """
    slow = [LIMITS[T] >= T, Relation(b_D, "<=", LIMITS[b_D] * m_D)]
    given = [*HELD, *slow, MEETS]
    return ForAll((*HAND, K, B, d), implied(given, drawn(DAMPED, S(FIGURES))))


def still_true() -> Proposition:
    """The ratios of Sec. V-B hold for every device and arm whose gamma and delta lie in (23).

    If only the damping of the device counts for passivity, some stable wall is more than 17.8 times
    as stiff as all passive walls without delay, and more than 9.3 times with one period of delay.
    """
    parts = []
    for id, delay in (("s5b-eta-d0", 0), ("s5b-eta-d1", 1)):
        times, _ = quoted(id)
        walls = PASSIVE.at({K: alpha, B: beta, T: S.One, d: S(delay)})
        parts.append(outdoes(stable(delay, BEST), walls, number(times) * alpha < x))
    given = [*map(proposition, transcribed("eq23")), b >= 0, b <= delta]
    return ForAll((gamma, delta, b), implied(given, both(parts)))
