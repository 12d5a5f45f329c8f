"""The claims on the ratio of stable to passive stiffness, Sec. V-B and VI.

No stable wall is the stiffest one, because the region is open. The largest stable stiffness is more
than c times the largest passive one if some stable wall is more than c times as stiff as every
passive wall. It is less than c times as large if, for some passive wall, every stable wall is less
than c times as stiff. All claims are in the units of Table I, with m = T = 1, and for integer
delays.
"""

from __future__ import annotations

import itertools

import sympy as sp

from symhaptic.notation import x, y
from symhaptic.notation.proposition import Terms, whole
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.digits import number, quoted
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.stability import DEVICE, HEAVIER, LATER, NUMBERS, on_boundary
from symhaptic.paper.ranges import DAMPED

WALL, BEST = (alpha, beta), (x, y)
ARM: Terms = {gamma: STIFF, delta: DAMPED}
"""The arm of Figs. 11 and 12, with the spring."""


def stable(delay: sp.Expr | int, wall: Sequence[sp.Expr] = WALL) -> Proposition:
    """A wall is stable with an arm of gamma and delta."""
    return STABLE.at({alpha: wall[0], beta: wall[1], d: S(delay)})


def passive(delay: sp.Expr | int, wall: Sequence[sp.Expr] = WALL) -> Proposition:
    """A wall is passive with a damper of delta."""
    return PASSIVE.at({K: wall[0], B: wall[1], b: delta, T: S.One, d: S(delay)})


def outdoes(best: Proposition, others: Proposition, *bounds: sp.Expr) -> Proposition:
    """There is a wall (x, y) such that these bounds hold for all other walls (alpha, beta)."""
    return Exists(BEST, both([best, ForAll(WALL, implied([others], both(bounds)))]))


def stiffer(delay: int, *bounds: sp.Expr) -> Proposition:
    """Compare a stable wall with all passive walls."""
    return outdoes(stable(delay, BEST), passive(delay), *bounds)


def not_stiffer(delay: int, *bounds: sp.Expr) -> Proposition:
    """Compare a passive wall with all stable walls, for the arm of the figures."""
    return outdoes(passive(delay, BEST), stable(delay), *bounds).at(ARM)


def on_the_range(*then: Proposition) -> Proposition:
    """For all gamma and delta of (23)."""
    return ForAll((gamma, delta), implied(transcribed("eq23"), both(then)))


@claims("s5b-eta-d0")
def _without_delay(printed: Printed) -> Proposition:
    """More than 17.8 times as stiff, eta < 0.0562, on all of (23).

    In the figures, from which both numbers are read, the ratio is less than 17.9, and eta > 0.0561.
    """
    times, eta = quoted("s5b-eta-d0")
    more = stiffer(0, number(times) * alpha < x, alpha < number(eta) * x)
    digits = not_stiffer(0, alpha < number(times, 1) * x, number(eta, -1) * alpha < x)
    return on_the_range(more, digits)


@claims("s5b-eta-d1")
def _one_period_late(printed: Printed) -> Proposition:
    """More than 9.3 times as stiff, eta < 0.1074, on all of (23).

    In the figures, from which both numbers are read, the ratio is less than 9.4, and eta > 0.1073.
    """
    times, eta = quoted("s5b-eta-d1")
    more = stiffer(1, number(times) * alpha < x, alpha < number(eta) * x)
    digits = not_stiffer(1, alpha < number(times, 1) * x, number(eta, -1) * alpha < x)
    return on_the_range(more, digits)


@claims("s6-stable-22")
def _stiffness_left_by_one_period(printed: Printed) -> Proposition:
    """For some wall that is stable without delay, all stable walls with d = 1 are below 22 % of it.

    The claim is for (23). In the figures, from which the number is read, the share rounds to 22 %:
    it is more than 21.5 %.
    """
    [share] = quoted("s6-stable-22")
    nearest = number(share) - Rational(str(share.unit)) / 2
    below = outdoes(stable(0, BEST), stable(1), alpha < number(share) * x)
    digits = outdoes(stable(1, BEST), stable(0), nearest * alpha < x).at(ARM)
    return on_the_range(below, digits)


END, RATE = Symbol("D"), Symbol("rho")
SPRINGS = (S.Zero, STIFF)
"""The springs of Fig. 12, whose damping is 0.02."""


def below(share: Expr, delay: Expr | int) -> Proposition:
    """eta(d) < share: some stable wall, times this share, is stiffer than all passive walls."""
    return outdoes(stable(delay, BEST), passive(delay), alpha < share * x)


def above(share: Expr, delay: Expr | int) -> Proposition:
    """eta(d) > share: some passive wall is stiffer than all stable walls times this share."""
    return outdoes(passive(delay, BEST), stable(delay), share * alpha < x)


def grows(delay: Expr | int, later: Expr | int) -> Proposition:
    """eta(d) < rho < eta(d') for some rho."""
    return Exists((RATE,), both([below(RATE, delay), above(RATE, later)]))


def springs() -> Proposition:
    """The spring is one of those of Fig. 12."""
    return Or(tuple(proposition(sp.Eq(gamma, spring)) for spring in SPRINGS))


@claims("s5a-smaller-delta")
def _less_damping_sets_them_further_apart(printed: Printed) -> Proposition:
    """On (23), the ratio of passive to stable stiffness is smaller with less damping.

    Size is read as the largest stiffness: eta(delta) < rho < eta(delta') for some rho, with the
    same spring. The passive walls vanish with the damper, so 0 < delta. The claim is for every
    integer delay.
    """
    more = above(RATE, d).at({delta: HEAVIER})
    ranges = [p.subs(delta, HEAVIER) for p in transcribed("eq23")]
    given = [*ranges, delta > 0, delta < HEAVIER, whole(d)]
    further = Exists((RATE,), both([below(RATE, d), more]))
    return ForAll((gamma, delta, HEAVIER, d), implied(given, further))


@claims("s5b-eta-grows")
def _until_it_is_one(printed: Printed) -> Proposition:
    """For some integer delay no stable wall is stiffer than a passive one; until then eta grows.

    The claim is for both springs of Fig. 12, to which the sentence refers.
    """
    same = outdoes(passive(END, BEST), stable(END), alpha <= x)
    before = [whole(d), whole(LATER), d < LATER, LATER <= END]
    growing = ForAll((d, LATER), implied(before, grows(d, LATER)))
    some = Exists((END,), both([whole(END), same, growing])).at({delta: DAMPED})
    return ForAll((gamma,), implied([springs()], some))


SHOWN = (0, 1, 2, 4, 8)
"""The delays of Fig. 12 (a) and (b), whose walls Fig. 11 also shows."""
PEAKS = {S.Zero: (16, 32, 64, 122), STIFF: (16, 32, 40)}
"""The delays of (c) up to the peak of eta, for each spring."""
NEAR = Rational(9998, 10**4)
"""A ratio that looks like 1 in print."""
FALLEN = {S.Zero: Rational(91, 100), STIFF: Rational(6, 100)}
"""Upper bounds of eta at the right end of (c), d = 1000."""
FINE = Rational(1, 1000)
"""The thickness of a line, as a share of the stiffness."""
OTHER = sp.symbols("alpha_1 beta_1")


def rightmost() -> Proposition:
    """Stable walls are as stiff as a wall of the boundary, to within the thickness of a line."""
    curve = on_boundary().at(dict(zip(WALL, BEST, strict=True)))
    most = ForAll(WALL, implied([stable(d)], alpha < (1 + FINE) * x))
    near = Exists(OTHER, both([stable(d, OTHER), OTHER[0] > (1 - FINE) * x]))
    tip = Exists((theta, *BEST), both([theta > 0, theta < sp.pi, curve, most, near]))
    return ForAll(NUMBERS, implied([DEVICE], tip))


@claims("fig12")
def _largest_stiffnesses(printed: Printed) -> Proposition:
    """For both springs and delta = 0.02: the curves of (a), and their ratio in (b) and (c).

    At five delays the largest stable stiffness is that of a wall of the boundary, as Sec. V-B says,
    to a thousandth; the passive one is that of (11), which is another statement. From one delay of
    a list to the next the ratio grows, until it looks like 1 in print, at 122 periods without a
    spring and 40 with it. At the right end of (c), d = 1000, it has fallen.
    """
    one = Or(tuple(proposition(sp.Eq(d, n)) for n in SHOWN))
    tips = ForAll((gamma, d), implied([springs(), one], rightmost()))
    runs = []
    for spring, later in PEAKS.items():
        delays = (*SHOWN, *later)
        steps = [grows(a, b) for a, b in itertools.pairwise(delays)]
        ends = [above(NEAR, later[-1]), below(FALLEN[spring], 1000)]
        runs += [p.at({gamma: spring}) for p in (*steps, *ends)]
    return both([tips, *runs]).at({delta: DAMPED})
