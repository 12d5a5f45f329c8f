"""The claims of Sec. V: comparison of passivity and stability.

The passive region is that of condition (5) in the parameters of Table I, at every frequency below
the Nyquist frequency. A wall is stable in the sense of the paper: the zeros of (18) lie inside,
with z = w^q for d = p/q. Both are exact for integer delays. For other delays the claims are about
the held force.
"""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import x, y
from symhaptic.notation.proposition import whole
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.digits import bounds, example, number, quoted
from symhaptic.paper.propositions.passivity import ABOVE, BORDER, WALL, at_every_frequency
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.ranges import DAMPED as DAMPED_MOST

LOOP = (alpha, beta, gamma, delta, d)
q = sp.Symbol("q")
STABLE = Predicate("stable_substituted", (), LOOP)


def passive(scale: sp.Expr = sp.S.One) -> Proposition:
    """(5) at every frequency, for ``scale`` times the wall and the damping."""
    [five] = STATEMENTS["eq5"].printed
    units = {K: scale * alpha, B: scale * beta, b: scale * delta, T: sp.S.One}
    return at_every_frequency(five).at(units)


PASSIVE_WALL = Predicate("passive_wall", (), (alpha, beta, delta, sp.S.One, d))
COMES_TO_REST = Predicate("stable_loop", (), LOOP)
"""The loop with the held force is stable, for every real delay d."""


@claims("s5a-subset")
def _passive_is_stable(printed: Printed) -> Proposition:
    """With the arm of Fig. 11, gamma = 0.001 and delta = 0.02, passive walls are stable.

    There are two claims. The first is about the held force with its delay, for every d >= 0. The
    second is about the paper's computation, (5) and (18), for alpha >= 0 and integer delays, for
    which (18) is exact.
    """
    walls, arm = (alpha, beta, d), {gamma: STIFF, delta: DAMPED_MOST}
    exact = ForAll(walls, implied([d >= 0, PASSIVE_WALL], COMES_TO_REST))
    computed = ForAll(walls, implied([whole(d), alpha >= 0, passive()], STABLE))
    return both([exact.at(arm), computed.at(arm)])


@claims("s6-subset")
def _passive_is_stable_with_every_arm(printed: Printed) -> Proposition:
    """For every arm and every delay of the held force, a passive wall is stable."""
    given = [gamma >= 0, delta >= 0, d >= 0, PASSIVE_WALL]
    return ForAll(LOOP, implied(given, COMES_TO_REST))


@claims("s5c-robust-subset")
def _passive_is_robust(printed: Printed) -> Proposition:
    """For every damper and delay of the held force, a passive wall is stable with every spring."""
    robust = ForAll((gamma,), implied([gamma >= 0], COMES_TO_REST))
    walls = tuple(s for s in LOOP if s != gamma)
    return ForAll(walls, implied([delta >= 0, d >= 0, PASSIVE_WALL], robust))


@claims("eq27")
def _envelope_in_its_plane(printed: Printed) -> Proposition:
    """Each wall of (27) is on the boundary, and no other wall is, as for (7).

    By Table I, such a wall stands for walls in SI units with every mass and period.
    """
    curve = [omega_hat > 0, omega_hat < sp.pi, *printed]
    others = implied([BORDER, *ABOVE], Exists((omega_hat,), both(curve)))
    given = [T > 0, m > 0, b >= 0, d >= 0, *normalised(alpha, beta, delta)]
    then = both([implied(curve, BORDER), others])
    return ForAll((*WALL, m, alpha, beta, delta, omega_hat), implied(given, then))


@claims("s5a-proportional")
def _passive_region_scales(printed: Printed) -> Proposition:
    """With y times the damping, y times each passive wall is passive."""
    walls = (alpha, beta, delta, d, y)
    return ForAll(walls, implied([delta >= 0, d >= 0, y > 0], Iff((passive(), passive(y)))))


@claims("s5b-soft-contacts")
def _stiffness_turned_down(printed: Printed) -> Proposition:
    """A stable wall with alpha >= 0 is stable with any share y of its stiffness.

    The damping stays the same. The claim is for integer delays, for which (18) is a polynomial.
    """
    given = [gamma >= 0, delta >= 0, whole(d), alpha >= 0, y >= 0, y <= 1, STABLE]
    return ForAll((*LOOP, y), implied(given, STABLE.at({alpha: y * alpha})))


# -- springs up to the Nyquist frequency ------------------------------------------------

DEVICE = (m, b, k, omega)
SWINGS = Predicate("swings", (), DEVICE)
"""The device m x'' + b x' + k x = 0 oscillates with the frequency omega."""


@claims("eq28")
def _frequency(printed: Printed) -> Proposition:
    """An underdamped device oscillates with this frequency and with no other."""
    given = [m > 0, b >= 0, k > b**2 / (4 * m), omega > 0]
    return ForAll(DEVICE, implied(given, Iff((both(printed), SWINGS))))


@claims("eq29")
def _frequency_in_units(printed: Printed) -> Proposition:
    """(28) in the parameters of Table I, b = delta m/T and k = gamma m/T^2."""
    given = [m > 0, T > 0, delta >= 0, gamma > delta**2 / 4, omega > 0]
    device = SWINGS.at({b: delta * m / T, k: gamma * m / T**2})
    return ForAll((m, T, gamma, delta, omega), implied(given, Iff((both(printed), device))))


@claims("eq30")
def _up_to_nyquist(printed: Printed) -> Proposition:
    """A real frequency (29) is at most the Nyquist frequency if and only if (30) holds.

    Without an oscillation, for gamma < delta^2/4, (30) also holds.
    """
    given = [T > 0, delta >= 0, gamma >= 0]
    swings = [gamma >= delta**2 / 4, *transcribed("eq29")]
    same = implied(swings, Iff((both(printed), proposition(omega <= sp.pi / T))))
    calm = implied([gamma < delta**2 / 4], both(printed))
    return ForAll((T, gamma, delta, omega), implied(given, both([same, calm])))


@claims("s5c-nyquist-spring")
def _undamped_at_nyquist(printed: Printed) -> Proposition:
    """By (29), an undamped device is at the Nyquist frequency if and only if gamma = pi^2."""
    [turns] = transcribed("eq29")
    given = [T > 0, gamma >= 0, turns.xreplace({delta: sp.S.Zero})]
    reached, spring = sp.Eq(omega * T, sp.pi), sp.Eq(gamma, sp.pi**2)
    return ForAll(
        (T, omega, gamma), implied(given, Iff((proposition(reached), proposition(spring))))
    )


EXAMPLE = example("eq31")
"""Example 5.1."""
DAMPED = tuple(r.subs(delta, b * T / m) for r in transcribed("eq23") if delta in r.free_symbols)
"""The damper is within (23)."""
[SPRING] = (r.rhs for r in transcribed("eq31"))


def rounds_as_printed() -> Proposition:
    """The stiffness (31) of Example 5.1 rounds to the published number."""
    [about] = quoted("eq31")
    given = [sp.Eq(symbol, value) for symbol, value in EXAMPLE.items()]
    return implied(given, both(bound(SPRING) for bound in bounds(about)))


@claims("eq31")
def _spring_of_nyquist(printed: Printed) -> Proposition:
    """The device oscillates at the Nyquist frequency if and only if it has this spring.

    In Example 5.1, with a damper of (23), the stiffness rounds to the published number.
    """
    there = SWINGS.at({omega: sp.pi / T})
    given = [m > 0, b >= 0, T > 0]
    same = Iff((both(printed), there))
    rounds = implied(DAMPED, rounds_as_printed())
    return ForAll((m, b, k, T), implied(given, both([same, rounds])))


LATE = l / q
"""A delay of l/q periods, for which (18) is a polynomial in w with z = w^q."""
MIRROR = -sp.exp(-delta / 2)
"""The pole at the Nyquist frequency, which is -1 without damping."""


def at_nyquist(of: Proposition) -> Proposition:
    """The claim for a delay of l/q periods and the spring with equality in (30)."""
    return of.at({gamma: sp.pi**2 + delta**2 / 4, d: LATE})


NUMBERS = (n_1, n_0, a, e)
TURNED = 2 / sp.pi**2
"""The coefficients n_1 = n_0 of the device without damping."""
WALLS = (alpha + beta) * z - beta
LOOSE = (z + 1) * z ** (d + 1) + TURNED * WALLS
"""The characteristic polynomial divided by z + 1."""


def kept_at_minus_one() -> Proposition:
    """For every wall and every delay of l/q periods, -1 is a pole, so that no wall is stable."""
    pole = Predicate("pole", (), (*LOOP, -sp.S.One))
    both_ = both([pole, Not((STABLE,))])
    given = [whole(l), whole(q), q > 0]
    return ForAll((alpha, beta, l, q), implied(given, at_nyquist(both_).at({delta: sp.S.Zero})))


def split_off() -> Proposition:
    """The polynomial is z + 1 times LOOSE, and one of the two poles of the device at -1 cancels.

    The claim is for integer delays. LOOSE is zero at -1 if and only if alpha + 2 beta = 0.
    """
    device = Predicate("device", (), (sp.pi**2, sp.S.Zero, *NUMBERS))
    below, above = z**2 - a * z + e, n_1 * z + n_0
    turned = sp.Eq(z ** (d + 1) * below + above * WALLS, (z + 1) * LOOSE, evaluate=False)
    left = sp.Eq(above / below, TURNED / (z + 1), evaluate=False)
    seen = ForAll((z,), both([implied([sp.Ne(z, 0)], turned), implied([sp.Ne(z, -1)], left)]))
    once = Iff((proposition(sp.Eq(LOOSE.subs(z, -1), 0)), proposition(sp.Eq(alpha + 2 * beta, 0))))
    return ForAll((alpha, beta, d, *NUMBERS), implied([whole(d), device], both([seen, once])))


def limit_stable_undelayed() -> Proposition:
    """Without delay all zeros except -1 lie inside if and only if the wall lies in a triangle."""
    inside = Predicate("stable", (z,), (sp.expand(LOOSE.subs(d, 0)),))
    triangle = [alpha > -(sp.pi**2), beta > -(sp.pi**2) / 2, alpha + 2 * beta < 0]
    return ForAll((alpha, beta), Iff((inside, both(triangle))))


@claims("s5c-undamped-limit")
def _limit_stable_at_best(printed: Printed) -> Proposition:
    """For every wall and delay a pole lies at -1, so that the loop is at most limit stable.

    It is a pole of the device that the samples do not show. It is simple except for alpha + 2 beta
    = 0. Without delay the other zeros lie inside for the walls of a triangle.
    """
    return both([kept_at_minus_one(), split_off(), limit_stable_undelayed()])


@claims("s5c-pole-inside")
def _mirrored_pole(printed: Printed) -> Proposition:
    """For every wall and delay the pole at -exp(-delta/2) lies inside."""
    pole = at_nyquist(Predicate("pole", (), (*LOOP, MIRROR)))
    inside = [proposition(MIRROR > -1), proposition(MIRROR < 1)]
    given = [delta > 0, whole(l), whole(q), q > 0]
    return ForAll((alpha, beta, delta, l, q), implied(given, both([pole, *inside])))


STIFFEST = next(r.rhs for r in transcribed("eq23") if r.lhs == gamma)
"""The largest gamma of (23)."""
ABOUT = sp.Rational(95, 100), sp.Rational(105, 100)
"""The interval of factors that round to 1: 9500 and 10500 are about 10000."""


@claims("s5c-marginal-b")
def _damping_hardly_matters(printed: Printed) -> Proposition:
    """The damper adds at most 1.02 10^-5 of the stiffness, and does not change 987 000 N/m."""
    free = SPRING.subs(b, 0)
    share = proposition(SPRING - free <= sp.Rational(102, 10**7) * free)
    given = [m > 0, T > 0, *DAMPED]
    return ForAll((m, b, T), implied(given, both([share, rounds_as_printed()])))


@claims("s5c-human-10000")
def _far_stiffer_than_an_arm(printed: Printed) -> Proposition:
    """If (30) is an equation, gamma is nearly 10000 times x, the largest gamma of (23).

    Nearly means at least 9500 times and less than 10000 times.
    """
    [limit] = transcribed("eq30")
    damped = [r for r in transcribed("eq23") if delta in r.free_symbols]
    [about] = quoted("s5c-human-10000")
    times = number(about)
    near = [ABOUT[0] * times <= gamma / x, gamma / x < times]
    given = [*damped, sp.Eq(*limit.args), sp.Eq(x, STIFFEST)]
    return ForAll((gamma, delta, x), implied(given, both(near)))
