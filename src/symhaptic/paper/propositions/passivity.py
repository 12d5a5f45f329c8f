"""The claims of Sec. III: passivity."""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import x, y
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions.digits import bounds, quoted
from symhaptic.paper.propositions.prelude import *
from symhaptic.paper.tables import DELAYS

WALL = (K, B, b, T, d)
LOOP = (T > 0, b >= 0, d >= 0)
PASSIVE = Predicate("passive_wall", (), WALL)


[FIVE] = STATEMENTS["eq5"].printed


def at_every_frequency(*conditions: sp.Expr | Proposition) -> Proposition:
    """The condition for 0 < omega < omega_N."""
    return ForAll((omega,), implied([omega > 0, omega < sp.pi / T], both(conditions)))


TAPS = sp.symbols("h_0:3")
"""The response of an environment to a unit pulse after d, d + 1 and d + 2 periods."""
ANSWER = sum(tap * z ** -(d + k) for k, tap in enumerate(TAPS))


@claims("eq4")
def _condition_guarantees_passivity(printed: Printed) -> Proposition:
    """No motion gains energy from H(z) = (h_0 + h_1/z + h_2/z^2) z^-d if it meets (4).

    The text says "guarantees". Whether (4) is also necessary is part of the claim of (5). The paper
    does not restrict H(z), and uses (1) with a delay, which has two of these three terms.
    """
    met = [at_given(c) for c in printed]
    energy = Predicate("passive", (z,), (ANSWER, b / T))
    given = [T > 0, b >= 0, Predicate("whole", (), (d,)), at_every_frequency(*met)]
    return ForAll((*TAPS, b, T, d), implied(given, energy))


def at_given(condition: sp.Expr) -> sp.Expr:
    """A condition on H(z) for a given environment, at z = exp(w), so that z^-n = exp(-n w)."""

    def answer(at: sp.Expr) -> sp.Expr:
        return sum(tap * sp.exp(-(d + k) * at.exp) for k, tap in enumerate(TAPS))

    return condition.replace(sp.Function("H"), answer)


@claims("eq5")
def _condition_decides(printed: Printed) -> Proposition:
    """A wall is passive if and only if it meets (5) at every frequency.

    That (5) is sufficient follows from the claim of (4). The boundaries, which are derived from
    (5), also require that no other wall is passive.
    """
    return ForAll(WALL, implied(LOOP, Iff((at_every_frequency(*printed), PASSIVE))))


@claims("s3a-mass-free")
def _mass_does_not_matter(printed: Printed) -> Proposition:
    """If two devices differ only in their mass, x and y, both are passive or neither is."""
    one, other = (Predicate("passive_device", (v,), (mass * v**2 / 2, *WALL)) for mass in (x, y))
    return ForAll((x, y, *WALL), implied([x > 0, y > 0, *LOOP], Iff((one, other))))


@claims("s3a-undelayed")
def _summary_of_the_undelayed_form(printed: Printed) -> Proposition:
    """(5) is the form for d = 0 at each frequency; this form is equivalent to (6), its summary."""
    [form] = map(proposition, printed)
    same = at_every_frequency(Iff((proposition(FIVE).at({d: sp.S.Zero}), form)))
    return ForAll(WALL[:-1], implied(LOOP[:-1], both([same, _summed_up(printed)])))


@claims("eq6")
def _condition_without_delay(printed: Printed) -> Proposition:
    """(6) is equivalent to the form for d = 0, and a wall is passive if and only if (6) holds."""
    [six] = map(proposition, printed)
    decides = Iff((six, PASSIVE.at({d: sp.S.Zero})))
    return ForAll(WALL[:-1], implied(LOOP[:-1], both([_summed_up((UNDELAYED,), six), decides])))


UNDELAYED = b > K * T / 2 - B * sp.cos(omega * T)
SIX = b > K * T / 2 + sp.Abs(B)


def _summed_up(printed: Printed, six: sp.Expr | Proposition = SIX) -> Proposition:
    return Iff((at_every_frequency(*printed), proposition(six)))


LITTLE = d * b / (2 * d + 3) >= B
"""The damping of a wall is at most that of the end of the line (8)."""

ABOVE = (d > 0, d * b / (2 * d + 3) < B)
"""There is a delay, and the damping of a wall exceeds that of the end of the line (8)."""

RANGE = (-b <= B, LITTLE)
"""The range of damping in (9)."""

MINIMAL = ForAll((x,), implied([x >= 0, x < b], Not((PASSIVE.at({b: x}),))))
"""With less damping of the device the wall is not passive."""

BORDER = both([PASSIVE, MINIMAL])
"""The wall is passive, and not passive with less damping of the device."""

STIFFEST = both([PASSIVE, ForAll((x, y), implied([PASSIVE.at({K: x, B: y})], x <= K))])
"""The wall is passive, and no passive wall is stiffer."""


@claims("eq7")
def _envelope_is_the_boundary(printed: Printed) -> Proposition:
    """Each wall of (7) is on the boundary, and with a delay no other wall is.

    The second part is for walls with more damping than the end of the line (8). With less damping,
    the boundary is this line. Without delay (7) is one wall, and the upper boundary is that of (6);
    see Fig. 4.
    """
    curve = [omega > 0, omega < sp.pi / T, *printed]
    others = implied([BORDER, *ABOVE], Exists((omega,), both(curve)))
    return ForAll((*WALL, omega), implied(LOOP, both([implied(curve, BORDER), others])))


@claims("eq8")
def _line_is_the_lower_boundary(printed: Printed) -> Proposition:
    """Up to the damping of its end, the boundary consists of the walls of the line."""
    on_line = Exists((y,), both([y >= 0, y <= 1, *printed]))
    return ForAll(WALL, implied(LOOP, Iff((both([BORDER, LITTLE]), on_line))))


@claims("eq9", "eq10")
def _linear_condition_decides(printed: Printed) -> Proposition:
    """In its range of damping a wall is passive if and only if it meets (9); (10) is equivalent."""
    return ForAll(WALL, implied([*LOOP, *RANGE], Iff((both(printed), PASSIVE))))


@claims("eq11")
def _wall_is_the_stiffest(printed: Printed) -> Proposition:
    return ForAll(WALL, implied([*LOOP, *printed], STIFFEST))


def tends(expr: sp.Expr, variable: sp.Symbol, at: object, to: sp.Expr) -> Predicate:
    """The limit of an expression."""
    return Predicate("limit", (variable,), (expr, sp.sympify(at), to))


@claims("s3c-lower-part")
def _lower_part(printed: Printed) -> Proposition:
    """On the line (8), (5) holds with equality at low frequencies, and (7) tends to its points."""
    curve, line = (transcribed(id) for id in ("eq7", "eq8"))
    limits = [tends(c.rhs, omega, 0, e.rhs) for c, e in zip(curve, line, strict=True)]
    along = [proposition(e).at({y: x}) for e in line]
    margin = b - FIVE.rhs
    met = [at_every_frequency(margin >= 0), tends(margin, omega, 0, sp.S.Zero)]
    straight = ForAll((K, B, x), implied([x >= 0, x <= 1, *along], both(met)))
    given = [T > 0, b >= 0, d >= 0, y >= 0, y <= 1]
    return ForAll((b, T, d, y), implied(given, both([straight, *limits])))


@claims("s3c-kmax-frequency")
def _damping_does_nothing(printed: Printed) -> Proposition:
    """The coefficient of B first vanishes at this frequency, where (11) attains (5)."""
    need = FIVE.rhs
    coefficient = sp.diff(need, B)
    none = proposition(sp.Eq(coefficient, 0))
    first = ForAll((x,), implied([x > 0, x < omega], sp.Ne(coefficient.subs(omega, x), 0)))
    largest = transcribed("eq11")[0]
    touched = ForAll((K, B, b), implied([b >= 0, largest], sp.Eq(b, need)))
    inside = omega > 0, omega < sp.pi / T
    given = [T > 0, d >= 0, *printed]
    return ForAll((T, d, omega), implied(given, both([*inside, none, first, touched])))


def largest_stiffness(stiffness: sp.Expr, delay: int) -> list[Proposition]:
    """Some wall of this stiffness is passive, and no stiffer wall is."""
    here, other = PASSIVE.at({K: stiffness, d: sp.S(delay)}), PASSIVE.at({K: w, d: sp.S(delay)})
    return [Exists((B,), here), ForAll((w, B), implied([other], w <= stiffness))]


def _share(delay: int, *bounds: Callable[[sp.Expr], sp.Expr]) -> Proposition:
    """Ratio of the largest passive stiffness y with a delay to that without delay, x."""
    given = [T > 0, b > 0, *largest_stiffness(x, 0), *largest_stiffness(y, delay)]
    return ForAll((b, T, x, y), implied(given, both([bound(y / x) for bound in bounds])))


@claims("s3c-kmax-41")
def _about_41_percent(printed: Printed) -> Proposition:
    """Rounded to two decimals, the ratio is 0.41."""
    [share] = quoted("s3c-kmax-41")
    return _share(1, *bounds(share))


@claims("s3c-kmax-27")
def _below_27_percent(printed: Printed) -> Proposition:
    [share] = quoted("s3c-kmax-27")
    return _share(2, *bounds(share))


@claims("s3c-limit-points")
def _damping_ends_at_that_of_the_device(printed: Printed) -> Proposition:
    """The damping of a wall that meets (5) lies between these points, which attain (5)."""
    point = [proposition(e).at({K: x, B: y}) for e in printed]
    met = at_every_frequency(b - FIVE.rhs >= 0).at({K: x, B: y})
    ends = [implied(point[:2], both([met, y >= B])), implied(point[2:], both([met, y <= B]))]
    return ForAll((*WALL, x, y), implied([*LOOP, at_every_frequency(FIVE)], both(ends)))


@claims("s3c-bmax-frequency")
def _upper_part(printed: Printed) -> Proposition:
    """At this frequency (5) is a linear condition, and the largest damping attains it."""
    frequency, linear = printed
    reached = sp.Eq(FIVE.rhs.subs({K: 0, B: b}), b)
    inside = omega > 0, omega < sp.pi / T
    then = both([*inside, Iff((proposition(FIVE), proposition(linear))), reached])
    return ForAll((*WALL, omega), implied([*LOOP, frequency], then))


@claims("s3c-upper-part")
def _upper_part_without_delay(printed: Printed) -> Proposition:
    """For B >= 0, (6) is the linear condition of this frequency."""
    same = Iff((proposition(SIX), proposition(b > K * T / 2 + B)))
    return ForAll(WALL[:-1], implied([*LOOP[:-1], B >= 0], same))


def scaled(period: sp.Expr) -> Proposition:
    """The walls of (5) are proportional to b, and their stiffness changes by y with the period."""
    walls = at_every_frequency(FIVE)
    damped = Iff((walls, walls.at({K: y * K, B: y * B, b: y * b})))
    slower = Iff((walls, walls.at({K: y * K, T: period})))
    return ForAll((*WALL, y), implied([*LOOP, y > 0], both([damped, slower])))


@claims("s3b-linear-in-T")
def _linear_in_the_period(printed: Printed) -> Proposition:
    """Twice the damping gives twice the region, and twice the period gives twice the stiffness."""
    return scaled(y * T)


UPPER = both([sp.Eq(d, 0), K >= 0, B >= 0, sp.Eq(b, K * T / 2 + B)])
"""The upper part of (6), without delay, as an equation."""


@claims("fig4")
def _curves_of_the_figure(printed: Printed) -> Proposition:
    """For seven delays the boundary is (7) up to its end and the line (8), with the tip (11).

    Without delay the upper part is that of (6), and (7) is one of its walls.
    """
    delays = Or(tuple(proposition(sp.Eq(d, sp.Rational(text))) for text in DELAYS))
    curve, line, tip = (transcribed(id) for id in ("eq7", "eq8", "eq11"))
    arc = both([omega > 0, omega < sp.pi / T, omega <= sp.pi / (T * (d + 1)), *curve])
    straight = both([y >= 0, y <= 1, *line])
    then = [
        *(implied([of], BORDER) for of in (arc, straight, UPPER)),
        implied([BORDER], Or((Exists((omega,), arc), Exists((y,), straight), UPPER))),
        implied(tip, STIFFEST),
    ]
    return ForAll((*WALL, omega, y), implied([*LOOP, delays], both(then)))


@claims("fig5")
def _stiffness_over_delay(printed: Printed) -> Proposition:
    """The curve is KT/b of (11), and the wall of (11) is the stiffest passive wall."""
    height = sp.Eq(K * T, 2 * b * sp.tan(sp.pi / (4 * (d + 1))))
    given = [*LOOP, *transcribed("eq11")]
    return ForAll(WALL, implied(given, both([height, STIFFEST])))
