"""The claims of Sec. IV-D: stability.

Stable is what the paper calls so, every zero of (18) inside the circle, with z = w^q for a delay of
d = p/q periods.  A region is larger than another where it holds all of its walls.
"""

from __future__ import annotations

from sympy import Expr, Symbol

from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, k, m
from symhaptic.notation.proposition import ForAll, Proposition, implied
from symhaptic.paper.propositions.comparison import LOOP, STABLE
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

PLANT = (gamma >= 0, delta >= 0)
LATER = Symbol("d'")


@claims("s4d-delay-shrinks")
def _delay_shrinks_the_region(printed: Printed) -> Proposition:
    """What is stable with a larger delay is stable with a smaller one."""
    given = [*PLANT, d >= 0, d <= LATER, STABLE.at({d: LATER})]
    return ForAll((*LOOP, LATER), implied(given, STABLE))


PHYSICAL = (K, B, T, m, b, k, d)
MORE = tuple(Symbol(f"{s}'") for s in (m, b, k))
"""Mass, damper and spring of another arm."""

LOOPS = (T > 0, m > 0, b >= 0, k >= 0, d >= 0)


def in_units(
    stiffness: Expr, damping: Expr, period: Expr, mass: Expr, damper: Expr, spring: Expr
) -> Proposition:
    """A loop in SI units is stable, by Table I."""
    units = {
        alpha: stiffness * period**2 / mass,
        beta: damping * period / mass,
        gamma: spring * period**2 / mass,
        delta: damper * period / mass,
    }
    return STABLE.at(units)


@claims("s4d-all-stabilising")
def _more_of_each_part_is_stable(printed: Printed) -> Proposition:
    """A wall that is stable stays so with more mass, more damping and a stiffer spring."""
    mass, damper, spring = MORE
    before, after = in_units(K, B, T, m, b, k), in_units(K, B, T, mass, damper, spring)
    more = [mass >= m, damper >= b, spring >= k]
    return ForAll((*PHYSICAL, *MORE), implied([*LOOPS, *more, before], after))
