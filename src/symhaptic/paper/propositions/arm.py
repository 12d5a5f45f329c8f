"""The claims of Sec. IV-C: the arm that holds the device, Table II and the ranges (23)."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from symhaptic.notation import second
from symhaptic.paper import tables
from symhaptic.paper.propositions.prelude import *

ARM = (T, m_D, m_H, b_D, b_H, k_H)
GIVEN = (T > 0, m_D > 0, m_H > 0, b_D >= 0, b_H >= 0, k_H >= 0)
"""Arms and devices with a mass; without a mass (20) divides by zero."""
LONGEST = Rational(1, 1000)
"""The longest sampling period of the paper, in s."""
x, y, y_D, y_H, k_1, k_2 = sp.symbols("x y y_D y_H k_1 k_2")


@claims("eq19")
def _numbers_of_the_arm(printed: Printed) -> Proposition:
    """The parameters (19) follow from Table I and the mass, damper and spring of (2).

    A device without an arm, m_H = b_H = k_H = 0, is included.
    """
    parts = [T > 0, m_D > 0, *(part >= 0 for part in (m_H, b_D, b_H, k_H))]
    rules = [rule for rule in transcribed("tab1") if rule.lhs in (gamma, delta)]
    given = [*parts, *transcribed("eq2"), *rules]
    return ForAll((*ARM, m, b, k, gamma, delta), implied(given, both(printed)))


@claims("eq20")
def _bounds_of_the_numbers(printed: Printed) -> Proposition:
    """The bounds (20) of the parameters (19), "assuming positive masses and dampers".

    The spring may be zero.
    """
    given = [*[part > 0 for part in (T, m_D, m_H, b_D, b_H)], k_H >= 0, *transcribed("eq19")]
    return ForAll((*ARM, gamma, delta), implied(given, both(printed)))


@claims("s4c-independent-limits")
def _limits_on_their_own(printed: Printed) -> Proposition:
    """Limits x, y_H and y_D of the ratios of arm and device limit gamma and delta.

    Here x limits the stiffness per mass of the arm, y_H its damping per mass, and y_D the damping
    per mass of the device. With (20) they limit gamma and delta. If one limit y holds for both
    dampings, y also limits delta.
    """
    mine = [k_H / m_H <= x, b_D / m_D <= y_D, b_H / m_H <= y_H]
    then = [gamma <= T**2 * x, delta <= T * (y_D + y_H)]
    shared = implied([y_D <= y, y_H <= y], delta <= T * y)
    given = [*GIVEN, *transcribed("eq19"), *mine]
    return ForAll((*ARM, gamma, delta, x, y, y_D, y_H), implied(given, both([*then, shared])))


@claims("s4c-series")
def _joints_in_series(printed: Printed) -> Proposition:
    """Two springs in series have the stiffness k: the same force, and displacements that add up.

    One of the two springs may stand for all joints but one, so the claim covers any number of
    joints.
    """
    given = [k_1 > 0, k_2 > 0, k > 0, sp.Eq(1 / k, 1 / k_1 + 1 / k_2)]
    return ForAll((k, k_1, k_2), implied(given, both([k < k_1, k < k_2])))


# -- Table II -------------------------------------------------------------------------------


def rows(excluded: bool = False) -> Iterator[dict[Symbol, Expr]]:
    """The arms of Table II in kg and s: all but the row that is left out, or only that row."""
    for row in tables.TABLE_II:
        if (row.authors == tables.EXCLUDED) is excluded:
            numbers = [Rational(n) for n in (row.mass, row.stiffness, row.damping)]
            yield {m_H: numbers[0], k_H: numbers[1] / second**2, b_H: numbers[2] / second}


RATIOS = (k_H / m_H, b_H / m_H)


@claims("eq21")
def _largest_ratios(printed: Printed) -> Proposition:
    """Each row that is kept meets the bound, and one row attains it to the last digit."""
    stiff, slow = (proposition(line) for line in printed)
    bounds = [line.at(row) for row in rows() for line in (stiff, slow)]
    closest = [
        Or(tuple(proposition(row_ratio > line.rhs - unit) for row_ratio in ratios))
        for line, unit, ratios in zip(
            printed,
            (1 / second**2, Rational(1, 10) / second),
            ([r.xreplace(row) for row in rows()] for r in RATIOS),
            strict=True,
        )
    ]
    return ForAll((second,), implied([second > 0], both([*bounds, *closest])))


def compared(times: Expr = sp.S.One) -> Iterator[tuple[Expr, Expr]]:
    """Compare ``times`` the ratios of each other arm with those of the arm that is left out."""
    [hand] = rows(excluded=True)
    for row in rows():
        for ratio in RATIOS:
            yield (
                (times * ratio).xreplace(row).subs(second, 1),
                ratio.xreplace(hand).subs(second, 1),
            )


@claims("s4c-outlier")
def _far_above(printed: Printed) -> Proposition:
    """The ratios exceed those of every other arm by a factor of at least three."""
    return both(sp.StrictLessThan(low, high, evaluate=False) for low, high in compared(sp.S(3)))


def in_range(row: dict[Symbol, Expr]) -> list[Expr]:
    """Compare gamma and delta of an arm alone, at the longest period, with the ends of (23)."""
    _, spring, _, damper = transcribed("eq23")
    at = {second: sp.S.One}
    numbers = [ratio.xreplace(row).xreplace(at) for ratio in RATIOS]
    return [
        end.func(LONGEST**power * number, end.rhs, evaluate=False)
        for end, power, number in zip((spring, damper), (2, 1), numbers, strict=True)
    ]


OUTSIDE = Rational(66, 10), Rational(25, 10)
"""The ratios of stiffness and damping of the arm that is left out to the ends of (23)."""


@claims("fig6")
def _arms_in_the_plane(printed: Printed) -> Proposition:
    """At 1 ms the arms of (21) lie in the ranges (23), and the arm that is left out lies outside.

    The stiffness and damping of this arm are at least OUTSIDE times the ends of the ranges.
    """
    [hand] = rows(excluded=True)
    outside = [
        sp.GreaterThan(limit.lhs, times * limit.rhs, evaluate=False)
        for limit, times in zip(in_range(hand), OUTSIDE, strict=True)
    ]
    return both([*(p for row in rows() for p in in_range(row)), *outside])


def extended(stiffer: tuple[str, str], slower: tuple[str, str]) -> Proposition:
    """Ratios of the ends of (23) to those of (22) at the longest period, as intervals."""
    limits = [line.rhs.xreplace({second: sp.S.One}) for line in transcribed("eq22")[1::2]]
    ends = [line.rhs for line in transcribed("eq23")[1::2]]
    parts = []
    for end, limit, (low, high) in zip(ends, limits, (stiffer, slower), strict=True):
        parts += [Rational(low) <= end / limit, end / limit < Rational(high)]
    return ForAll((T,), implied([sp.Eq(T, LONGEST)], both(parts)))


@claims("s4c-extension-30")
def _wider_by_thirty(printed: Printed) -> Proposition:
    """The extension is 30 % if it is rounded to the nearest ten per cent."""
    return extended(("1.25", "1.35"), ("1.25", "1.35"))
