"""The claims of the slips of Sec. II-C and V-C, and what is meant instead."""

from __future__ import annotations

from sympy import Eq, Expr, Rational, S, pi

from symhaptic.notation import T, delta, gamma, omega, omega_N, t_d
from symhaptic.notation.proposition import ForAll, Iff, Or, Proposition, both, implied, proposition
from symhaptic.paper.propositions.device import transcribed
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

END = Rational(1, 50)
"""Largest delta of (23)."""
ENDS = pi**2, pi**2 + Rational(1, 10000)
"""The interval of the print."""
SPRINGS = (gamma >= 0, delta >= 0, delta <= END)


@claims("s2c-positive-delay")
def _positive(printed: Printed) -> Proposition:
    """A delay that is not negative is positive, in periods too."""
    return ForAll((t_d, T), implied([t_d >= 0, T > 0], t_d / T > 0))


NOT_NEGATIVE = ForAll((t_d, T), implied([t_d >= 0, T > 0], t_d / T >= 0))


def below(end: Expr) -> Proposition:
    """(30) says that gamma is at most ``end``, for the dampers of (23)."""
    [thirty] = transcribed("eq30")
    return ForAll(
        (gamma, delta), implied(SPRINGS, Iff((proposition(thirty), proposition(gamma <= end))))
    )


@claims("s5c-interval")
def _below_an_interval(printed: Printed) -> Proposition:
    """A number below an interval: below its lower end, or below its upper end."""
    return Or(tuple(below(end) for end in ENDS))


def within() -> Proposition:
    """(30) bounds gamma by a number in the interval."""
    [thirty] = transcribed("eq30")
    limit = pi**2 + delta**2 / 4
    then = [
        Iff((proposition(thirty), proposition(gamma <= limit))),
        ENDS[0] <= limit,
        limit <= ENDS[1],
    ]
    return ForAll((gamma, delta), implied(SPRINGS, both(then)))


@claims("s5c-nyquist-spring")
def _frequency_of_nyquist(printed: Printed) -> Proposition:
    """The Nyquist frequency is pi^2, in units of 1/T as gamma is in its own."""
    given = [T > 0, Eq(omega_N, pi / T)]
    return ForAll((T, omega_N), implied(given, Eq(omega_N * T, pi**2)))


def spring_of_nyquist() -> Proposition:
    """An undamped device turns at the Nyquist frequency, by (29), just if gamma is pi^2."""
    [turns] = transcribed("eq29")
    given = [T > 0, gamma >= 0, turns.xreplace({delta: S.Zero})]
    reached = Eq(omega * T, pi)
    return ForAll(
        (T, omega, gamma),
        implied(given, Iff((proposition(reached), proposition(Eq(gamma, pi**2))))),
    )
