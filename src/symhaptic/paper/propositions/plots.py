"""The claims of the plots of stable walls, and of the conclusions that the text draws from them.

A wall is stable in the sense of the paper, as for Sec. IV-D. Plots have curves and no numbers: a
claim says what each curve is, and how close two curves are that look the same.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from symhaptic.paper.propositions.comparison import COMES_TO_REST, PASSIVE_WALL, STABLE
from symhaptic.paper.propositions.linear import on_the_line_of_25
from symhaptic.paper.propositions.passivity import ABOVE, BORDER
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.propositions.stability import (
    DEVICE,
    NUMBERS,
    START,
    WAY,
    at_angle,
    explicit,
    on_boundary,
)
from symhaptic.paper.ranges import DAMPED
from symhaptic.paper.tables import DELAYS

OTHER = Symbol("gamma'")
"""Another spring."""
BESIDE = sp.symbols("alpha_1 beta_1")
"""A wall near (alpha, beta)."""
THICK = Rational(2, 1000)
"""The thickness of a line, in the units of Fig. 7, whose regions are 0.7 wide and 2 high."""

ARMS = tuple(map(proposition, transcribed("eq23")))
"""The ranges of gamma and delta."""
SPRINGS = tuple(p.at({gamma: OTHER}) for p in ARMS if gamma in p.free)


def undelayed(wall: tuple[Expr, ...] = (alpha, beta), spring: Expr = gamma) -> Proposition:
    """A wall is stable without delay."""
    return Predicate("stable_substituted", (), (*wall, spring, delta, sp.S.Zero))


def near(reach: Expr = THICK) -> list[Expr]:
    """(alpha_1, beta_1) and (alpha, beta) differ by at most ``reach`` in each coordinate."""
    ways = [other - here for other, here in zip(BESIDE, (alpha, beta), strict=True)]
    return [relation for way in ways for relation in (-reach <= way, way <= reach)]


def alike() -> Proposition:
    """Two springs have the same stable walls to within the thickness of a line.

    Near each wall that is stable with one spring, some wall is stable with the other one. If all
    walls near a wall are stable with the other spring, this wall is stable with the first one.
    """
    other = undelayed(BESIDE, OTHER)
    kept = implied([undelayed()], Exists(BESIDE, both([*near(), other])))
    filled = implied([ForAll(BESIDE, implied(near(), other))], undelayed())
    walls = ForAll((alpha, beta), both([kept, filled]))
    return ForAll((gamma, OTHER, delta), implied([*ARMS, *SPRINGS], walls))


CURVE = (1 - e + (n_1 - n_0 + a * n_0) * beta - n_0 * (n_0 + n_1) * beta**2) / (
    n_0 * (1 + n_1 * beta)
)
"""The parabola-like curve without delay, a graph over beta."""


def between_line_and_curve() -> Proposition:
    """The stable walls are those above beta = -1 between alpha = -gamma and the curve."""
    between = both([beta > -1, alpha > -gamma, alpha < CURVE])
    symbols = (gamma, delta, *NUMBERS, alpha, beta)
    return ForAll(symbols, implied([*ARMS, DEVICE], Iff((undelayed(), between))))


@claims("fig7")
def _boundary_without_delay(printed: Printed) -> Proposition:
    """The regions end on the left at alpha = -gamma and on the right at a parabola-like curve.

    The curve is the exact one for the coefficients of the arm. The effect of gamma is not visible:
    for the same damper, the regions of two springs of (23) agree to within 0.002 in each
    coordinate, the thickness of a line. The claim is for all arms of (23); the figure shows its
    four corners.
    """
    return both([between_line_and_curve(), alike()])


@claims("s4d-gamma-invisible")
def _springs_hardly_matter(printed: Printed) -> Proposition:
    """For the same damper the regions of two springs of (23) agree to within 0.002.

    This is a third of a percent of the width of Fig. 7, and a thousandth of its height.
    """
    return alike()


FINE, FRAME = Rational(1, 10**4), (Rational(3, 1000), Rational(25, 1000))
"""The thickness of a line in Fig. 8, and the ends of its axes around the origin."""


@claims("fig8")
def _close_up_without_delay(printed: Printed) -> Proposition:
    """Near the origin the stable walls are those with alpha > -gamma above one line for all gamma.

    The line is beta = alpha/2 - delta, to within 0.0001 in beta, a three-hundredth of the height.
    The claim is for all arms of (23), of which the figure shows five springs, and for alpha <=
    0.003 and -0.025 <= beta <= 0.025.
    """
    above = beta - (alpha / 2 - delta)
    wide, high = FRAME
    given = [*ARMS, alpha <= wide, -high <= beta, beta <= high]
    inside = implied([undelayed()], both([alpha > -gamma, above > -FINE]))
    filled = implied([alpha > -gamma, above > FINE], undelayed())
    return ForAll((alpha, beta, gamma, delta), implied(given, both([inside, filled])))


# -- one and two periods late ---------------------------------------------------------------

CORNERS = {gamma: (sp.S.Zero, STIFF), delta: (sp.S.Zero, DAMPED), d: (sp.S.One, sp.S(2))}
"""The limits of (23) and the two panels of Fig. 9."""
THIN = Rational(1, 5000)
"""The thickness of a line in Fig. 9, whose regions are 0.15 and 0.07 wide."""
SEEN = 70
"""For d = 2 the region right of the origin is less than this many times as wide as the spring."""


def either(symbol: Symbol) -> Proposition:
    """The symbol has one of its values in Fig. 9."""
    return Or(tuple(proposition(sp.Eq(symbol, value)) for value in CORNERS[symbol]))


@claims("fig9")
def _boundaries_with_delay(printed: Printed) -> Proposition:
    """For d = 1 and d = 2 and the four limits of (23): curve, left bound and tip of the region.

    The walls of the curve, alpha(theta) and beta(theta), have a zero at exp(j theta), and none of
    them is stable. A wall that the curve encloses together with a stable wall is stable. The stable
    walls lie to the right of alpha = -gamma and come within the thickness of a line of it. One of
    them is as stiff as all stable walls, to within this thickness. The spring 0.001 is visible: for
    d = 2 it is more than a seventieth of the width right of the origin.
    """
    other = STABLE.at(dict(zip((alpha, beta), BESIDE, strict=True)))
    walls = [
        ForAll((alpha, beta), implied([STABLE], alpha > -gamma)),
        Exists(BESIDE, both([other, BESIDE[0] < THIN - gamma])),
        Exists(
            BESIDE,
            both([other, ForAll((alpha, beta), implied([STABLE], alpha < BESIDE[0] + THIN))]),
        ),
    ]
    given = [either(s) for s in CORNERS]
    region = ForAll(tuple(CORNERS), implied(given, both([solid(), enclosed(), *walls])))
    late = STABLE.at({d: sp.S(2), gamma: STIFF})
    visible = implied([either(delta), late], alpha < SEEN * STIFF)
    return both([region, ForAll((alpha, beta, delta), visible)])


# -- the linear condition beside the boundary -------------------------------------------------

LINED = {d: (sp.S.Zero, sp.S.One), delta: tuple(Rational(k, 200) for k in range(5))}
"""The delays and dampings of Fig. 10, whose spring is 0.001."""
LEVELS = (sp.S.Zero, Rational(2, 100), Rational(5, 100))
"""The errors of the circles, triangles and squares."""
BEFORE = ((sp.S.Zero, Rational(4, 200)), (sp.S.One, Rational(3, 200)), (sp.S.One, Rational(4, 200)))
"""Delays and dampings with a second triangle, before the line crosses the boundary."""
READ = Rational(1, 10**4)
"""The tolerance of an error at its mark."""


def marked(level: Expr) -> Proposition:
    """A wall of the boundary has this signed error (26), to within READ.

    With alpha_lin of the wall on the line (25) with the same beta, (alpha_lin - alpha) is level
    times (alpha + gamma), which is positive.
    """
    wall, (right, up) = (theta, *BESIDE), BESIDE
    gap = on_the_line_of_25(alpha).subs(beta, up) - right - level * (right + gamma)
    near = [right + gamma > 0, gap <= READ * (right + gamma), gap >= -READ * (right + gamma)]
    on_it = on_boundary().at(dict(zip((alpha, beta), BESIDE, strict=True)))
    some = Exists(wall, both([theta > 0, theta < sp.pi, on_it, *near]))
    return ForAll(NUMBERS, implied([DEVICE], some))


@claims("fig10")
def _linear_condition_beside_the_boundary(printed: Printed) -> Proposition:
    """For gamma = 0.001, five dampings, no delay and one period: the solid curves and their marks.

    The walls of a curve have a zero at exp(j theta), and none of them is stable. No wall to the
    left of alpha = -gamma or on this line is stable. A wall that they enclose together with a
    stable wall is stable; without delay these are all walls between this line and the curve, as for
    Fig. 7. On each curve some walls have the errors 0, 2 and 5 percent (26), to a hundredth of a
    percent, and on three curves a wall has the error -2 percent.
    """
    left = ForAll((alpha, beta), implied([STABLE], alpha > -gamma))
    given = [Or(tuple(proposition(sp.Eq(s, v)) for v in values)) for s, values in LINED.items()]
    curves = implied(given, both([solid(), enclosed(), left, *map(marked, LEVELS)]))
    more = [marked(-LEVELS[1]).at({d: late, delta: damper}) for late, damper in BEFORE]
    marks = both([ForAll(tuple(LINED), curves), *more]).at({gamma: STIFF})
    return both([marks, between_line_and_curve()])


# -- springs at the Nyquist frequency ------------------------------------------------------

NYQUIST = sp.pi**2 + delta**2 / 4
"""The spring of (30) as an equation."""
LEFT = sp.exp(-delta / 2)
"""The factor by which a period reduces the amplitude of the oscillation."""
DAMPERS = (delta > 0, *(p for p in ARMS if delta in p.free))
TIMES = 13


def triangle() -> list[Expr]:
    """The three sides of the triangle."""
    half = NYQUIST / (1 + LEFT)
    return [alpha > -NYQUIST, beta > -half, alpha + 2 * beta < half * (1 - LEFT)]


@claims("s5c-shape")
def _other_shape_and_size(printed: Printed) -> Proposition:
    """A region between a line and a parabola-like curve becomes a triangle, thirteen times as wide.

    The claim is without delay. With a spring of (23), the stable walls are as in Fig. 7. With the
    spring of the Nyquist frequency they fill a triangle, and one of its walls is 13 times as stiff
    as every wall that is stable with a spring of (23).
    """
    there = undelayed(spring=NYQUIST)
    shape = ForAll((alpha, beta, delta), implied(DAMPERS, Iff((there, both(triangle())))))
    others = ForAll((alpha, beta, gamma), implied([*ARMS, undelayed()], TIMES * alpha < BESIDE[0]))
    size = Exists(BESIDE, both([undelayed(BESIDE, NYQUIST), others]))
    return both([between_line_and_curve(), shape, ForAll((delta,), implied(DAMPERS, size))])


def moved_sides() -> list[Expr]:
    """The sides lie within 0.05 of those without a damper."""
    half = NYQUIST / (1 + LEFT)
    ways = (NYQUIST - sp.pi**2, half - sp.pi**2 / 2, half * (1 - LEFT))
    least = Rational(5, 100)
    return [relation for way in ways for relation in (way > -least, way < least)]


WIDTH = 19
"""The triangle is wider than this."""


@claims("s5c-delta-hardly-visible")
def _damping_hardly_moves_the_triangle(printed: Printed) -> Proposition:
    """For d = 0 and the spring of the Nyquist frequency, the triangle for all dampers of (23).

    The sides move by less than 0.05; the corners are more than WIDTH apart in alpha.
    """
    shape = Iff((undelayed(spring=NYQUIST), both(triangle())))
    corner = NYQUIST * (3 - LEFT) / (1 + LEFT)
    wide = corner + NYQUIST > WIDTH
    sides = ForAll((delta,), implied(DAMPERS, both([*moved_sides(), wide])))
    return both([ForAll((alpha, beta, delta), implied(DAMPERS, shape)), sides])


# -- passive and stable walls in one plane -------------------------------------------------


def one_of(*delays: str) -> Proposition:
    """The delay is one of these."""
    return Or(tuple(proposition(sp.Eq(d, Rational(text))) for text in delays))


def dashed() -> Proposition:
    """Each wall of (27), for delta = 0.02 up to its end, is on the boundary of the passive walls.

    With a delay no other wall with more damping than the end of (8) is on the boundary.
    """
    units = {K: alpha, B: beta, b: DAMPED, T: sp.S.One}
    curve = [proposition(line).at({delta: DAMPED}) for line in transcribed("eq27")]
    arc, end = [omega_hat > 0, omega_hat < sp.pi, *curve], omega_hat <= sp.pi / (d + 1)
    border = BORDER.at(units)
    above = [proposition(p).at(units) for p in ABOVE]
    others = implied([border, *above], Exists((omega_hat,), both(arc)))
    return both([implied([end, *arc], border), others])


def solid() -> Proposition:
    """The walls of the curve have a zero at exp(j theta), and none of them is stable.

    This is for the principal sheet, z^d = exp(j d theta).
    """
    given = [DEVICE, theta > 0, theta < sp.pi, at_angle()]
    unstable = ForAll((alpha, beta, *NUMBERS, theta), implied(given, Not((STABLE,))))
    return both([explicit(), unstable])


def enclosed() -> Proposition:
    """All walls that no boundary separates from a stable wall are stable.

    No boundary separates them if no wall on the straight line between them has a zero at exp(j
    theta), from theta = 0, which is the line alpha = -gamma, along the curve to theta = pi. So the
    walls that the boundaries enclose together with a stable one are stable.
    """
    on_way = {
        end: begin + WAY * (end - begin) for begin, end in zip(START, (alpha, beta), strict=True)
    }
    root: Any = at_angle().at(on_way)
    within = [WAY > 0, WAY <= 1, theta >= 0, theta <= sp.pi]
    free = ForAll((WAY, theta), implied(within, Relation(root.left, "!=", sp.S.Zero)))
    begin = STABLE.at(dict(zip((alpha, beta), START, strict=True)))
    walls = (*START, alpha, beta, *NUMBERS)
    return ForAll(walls, implied([DEVICE, begin, free], STABLE))


WHOLE = tuple(text for text in DELAYS if "." not in text)
"""The integer delays among those of Fig. 11."""


@claims("fig11")
def _both_in_one_plane(printed: Printed) -> Proposition:
    """For gamma = 0.001 and delta = 0.02: dashed and solid curves, and their regions.

    For the five integer delays: a wall of a dashed curve, (27) up to its end, is on the boundary of
    the passive walls. With a delay, no other wall with more damping than the end of (8) is. The
    walls of a solid curve, alpha(theta) and beta(theta), have a zero at exp(j theta), and none of
    them is stable. No wall to the left of alpha = -gamma or on this line is stable. The walls that
    the boundaries enclose together with a stable one are stable. For all seven delays: the passive
    walls are stable with the held force and this delay. The text does not say which polynomial the
    solid curves of the other two delays belong to. The dash-dotted line of the largest stiffness is
    part of the claim of Fig. 12.
    """
    arm = {gamma: STIFF, delta: DAMPED}
    left = ForAll((alpha, beta), implied([STABLE.at(arm)], alpha > -STIFF))
    curves = both([dashed(), solid().at(arm), enclosed().at(arm), left])
    region = implied([one_of(*DELAYS), PASSIVE_WALL.at(arm)], COMES_TO_REST.at(arm))
    drawn = ForAll((alpha, beta, d, omega_hat), implied([one_of(*WHOLE)], curves))
    return both([drawn, ForAll((alpha, beta, d), region)])


PANELS = ("0", "0.5", "1", "2")
"""Delays of the rows of Fig. 13."""


@claims("fig13")
def _springs_up_to_nyquist(printed: Printed) -> Proposition:
    """For delta = 0.02 and delta = 0, and all springs up to that of (30).

    For the three integer delays: the walls of a curve have a zero at exp(j theta), and none of them
    is stable; the walls that the boundaries enclose together with a stable one are stable. For all
    four delays: the passive walls for delta = 0.02 with alpha > 0, the green region, are stable
    with every such spring, with the held force and this delay; see Fig. 11.
    """
    springs = [gamma >= 0, gamma <= NYQUIST]
    shown = both([solid(), enclosed()])
    curves = [
        ForAll((gamma,), implied([p.subs(delta, at) for p in springs], shown.at({delta: at})))
        for at in (DAMPED, sp.S.Zero)
    ]
    whole_ones = (text for text in PANELS if "." not in text)
    drawn = ForAll((d,), implied([one_of(*whole_ones)], both(curves)))
    damped = [p.subs(delta, DAMPED) for p in springs]
    robust = ForAll((gamma,), implied(damped, COMES_TO_REST.at({delta: DAMPED})))
    given = [one_of(*PANELS), alpha > 0, PASSIVE_WALL.at({delta: DAMPED})]
    return both([drawn, ForAll((alpha, beta, d), implied(given, robust))])


@claims("s5c-robust-vanishes")
def _nothing_is_left_without_damping(printed: Printed) -> Proposition:
    """For delta = 0 and every delay d >= 0, no wall is stable with every spring.

    The springs are those below the Nyquist frequency, 0 < gamma < pi^2. With the spring of the
    Nyquist frequency itself no wall is stable, and without a spring no wall with alpha <= 0 is. At
    the origin the device oscillates without a wall and is only limit stable.
    """
    held = ForAll((gamma,), implied([gamma > 0, gamma < sp.pi**2], STABLE.at({delta: sp.S.Zero})))
    return ForAll((alpha, beta, d), implied([d >= 0], Not((held,))))
