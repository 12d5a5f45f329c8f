"""The claims of Sec. IV-E: the linear condition.

It is derived for a loop in continuous time in which hold and delay are a first-order lag, with t_e
= t_d + T/2. This loop is stable if all zeros of its polynomial lie in the left half plane. The
claims on the sampled loop are about the exact boundary.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from symhaptic.notation import t_e, x
from symhaptic.notation.proposition import whole
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.paper.propositions.prelude import *

LAGGING = Predicate("hurwitz", (s,), ((m * s**2 + b * s + k) * (1 + t_e * s) + K + B * s,))
"""The loop with the lag is stable."""
SLOW = LAGGING.at({t_e: t_d + T / 2})
"""The loop with the lag is stable, with the effective delay of hold and t_d."""
LOOP = (K, B, m, b, k, T, t_d)
GIVEN = (m > 0, b >= 0, k >= 0, T > 0, t_d >= 0)
PULLED = -k < K
"""The lower limit of the stiffness in Sec. IV-E."""


@claims("eq24")
def _condition_of_the_lag(printed: Printed) -> Proposition:
    """For K > -k, the loop with the lag is stable if and only if (24) holds."""
    return ForAll(LOOP, implied(GIVEN, Iff((both([PULLED, *printed]), SLOW))))


@claims("eq25")
def _condition_of_the_lag_in_table_1(printed: Printed) -> Proposition:
    """The claim of (24) in the parameters of Table I."""
    table = normalised(d, alpha, beta, gamma, delta)
    walls = both([alpha > -gamma, *printed])
    symbols = (*LOOP, alpha, beta, gamma, delta, d)
    return ForAll(symbols, implied([*GIVEN, *table], Iff((walls, SLOW))))


@claims("s4e-stiffness-free")
def _spring_does_not_matter(printed: Printed) -> Proposition:
    """Above both lower limits, the loop with the lag has the same stable walls for two springs."""
    above = [PULLED, -x < K, x >= 0]
    return ForAll((*LOOP, x), implied([*GIVEN, *above], Iff((SLOW, SLOW.at({k: x})))))


@claims("s4e-same-as-passive")
def _same_as_the_linear_part(printed: Printed) -> Proposition:
    """(24) is equivalent to (9), with t_d = d T and the same damping."""
    linear, passive = (both(transcribed(id)) for id in ("eq24", "eq9"))
    return ForAll(
        (K, B, b, T, d, t_d), implied([T > 0, d >= 0, sp.Eq(t_d, d * T)], Iff((linear, passive)))
    )


def on_or_below_the_line() -> Relation:
    """(25), or equality in (25)."""
    [line] = transcribed("eq25")
    return Relation(line.rhs, "<=", line.lhs)


LATE = (0, 1)
"""The delays of Fig. 10."""


@cache
def on_the_line_of_25(symbol: Symbol) -> Expr:
    """The value of alpha or beta for which both sides of (25) are equal."""
    [line] = transcribed("eq25")
    found, value = sp.solve_linear(*line.args, [symbol])
    if found != symbol:
        raise ValueError(f"(25) is not linear in {symbol}")
    return sp.sympify(sp.factor_terms(sp.cancel(value)))


def on_the_line(stiffness: Expr, delay: int) -> Expr:
    """The damping beta of the wall on the line."""
    return on_the_line_of_25(beta).subs({alpha: stiffness, d: delay})


def on_line(stiffness: Expr, delay: int) -> Proposition:
    """The wall on the line is stable."""
    return STABLE.at({alpha: stiffness, beta: on_the_line(stiffness, delay), d: sp.S(delay)})


@claims("s4e-unstable-side")
def _unstable_from_some_stiffness_on(printed: Printed) -> Proposition:
    """If a wall on the line is stable, every less stiff wall on it is; none with alpha = 1 is.

    So the line is unstable above one stiffness, at which it crosses the boundary. The claim is for
    -gamma < alpha, on (23), without delay and with one period of delay.
    """
    stays = [
        implied([on_line(alpha, n)], both([on_line(x, n), proposition(alpha < 1)])) for n in LATE
    ]
    given = [*transcribed("eq23"), -gamma < x, x < alpha]
    return ForAll((alpha, gamma, delta, x), implied(given, both(stays)))


def safe() -> Proposition:
    """Every wall with (25) and at most the damping of a stable wall on the line is stable.

    The claim is for -gamma < alpha, on (23), without delay and with one period of delay.
    """
    every = []
    for n in LATE:
        wall = [r.subs(d, n) for r in transcribed("eq25")]
        below = [on_line(x, n), *wall, beta <= on_the_line(x, n)]
        every.append(implied(below, STABLE.at({d: sp.S(n)})))
    given = [*transcribed("eq23"), -gamma < alpha]
    return ForAll((alpha, beta, gamma, delta, x), implied(given, both(every)))


@claims("s4e-passive-range")
def _line_is_passive(printed: Printed) -> Proposition:
    """A wall with (25), or with equality, is passive for the range of damping in the paper.

    Table I has the damping b = b_D + b_H of (2). For passivity only b_D counts, by (3).
    """
    damping = both([-delta <= beta, d / (2 * d + 3) * delta >= beta])
    table = [rule.xreplace({b: b_D + b_H}) for rule in normalised(d, alpha, beta, delta)]
    given = [m > 0, b_D >= 0, b_H >= 0, T > 0, t_d >= 0, *table, damping, on_or_below_the_line()]
    symbols = (K, B, m, b_D, b_H, T, t_d, alpha, beta, delta, d)
    return ForAll(symbols, implied(given, PASSIVE.at({b: b_D})))


def of_a_free_mass() -> Proposition:
    """For a free mass every stable wall satisfies (25), and no wall with equality is stable."""
    [line] = (r.subs(delta, 0) for r in transcribed("eq25"))
    free = STABLE.at({gamma: sp.S.Zero, delta: sp.S.Zero})
    border = implied([sp.Eq(*line.args)], Not((free,)))
    return ForAll((alpha, beta, d), implied([whole(d)], both([implied([free], line), border])))


def lagging(*walls: Expr) -> Proposition:
    """Walls that are stable in the loop with the lag, for every spring."""
    [linear] = map(proposition, transcribed("eq24"))
    given = [m > 0, b >= 0, T > 0, t_d >= 0, PULLED, linear]
    return ForAll(LOOP, implied([*given, *walls], SLOW))


def decides(damping: Expr = beta, physical: Expr = delta) -> Proposition:
    """A wall is stable if and only if (25) holds."""
    return Iff((both(transcribed("eq25")), STABLE)).at({beta: damping, delta: physical})


EXCHANGED = {beta: beta - x, delta: delta + x}
"""The damping x becomes physical instead of virtual."""
SMALL = sp.Rational(3, 100)


@claims("s6-linear-dissipation")
def _one_damping_for_the_other(printed: Printed) -> Proposition:
    """Exchanging virtual for physical damping does not change stability.

    The linear approximation is for the small alpha of Sec. IV-E, up to 0.03, with arms of (23)
    before and after the exchange.
    """
    arms = [proposition(r) for r in transcribed("eq23")]
    arms += [p.at(EXCHANGED) for p in arms if delta in p.free]
    given = [*arms, d >= 0, alpha >= 0, alpha <= SMALL]
    symbols = (alpha, beta, gamma, delta, d, x)
    return ForAll(symbols, implied(given, Iff((STABLE, STABLE.at(EXCHANGED)))))
