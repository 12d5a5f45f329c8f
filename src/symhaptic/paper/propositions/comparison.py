"""The claims of Sec. V: passivity beside stability.

The passive region is that of condition (5) in the units of Table I, at every frequency below
Nyquist's, for any delay; stable is what the paper calls so, zeros of (18) inside, with z = w^q for
d = p/q.
"""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, gamma, y
from symhaptic.notation.proposition import ForAll, Iff, Predicate, Proposition, implied
from symhaptic.paper.equations import EQUATIONS
from symhaptic.paper.propositions.passivity import at_every_frequency
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed

LOOP = (alpha, beta, gamma, delta, d)
STABLE = Predicate("stable_substituted", (), LOOP)


def passive(scale: sp.Expr = sp.S.One) -> Proposition:
    """(5) at every frequency, of the wall and the damping times ``scale``."""
    [five] = next(s for s in EQUATIONS if s.id == "eq5").printed
    units = {K: scale * alpha, B: scale * beta, b: scale * delta, T: sp.S.One}
    return at_every_frequency(five).at(units)


@claims("s5a-subset")
def _passive_is_stable(printed: Printed) -> Proposition:
    """For all d >= 0 a passive wall is stable, for every arm."""
    return ForAll(LOOP, implied([gamma >= 0, delta >= 0, d >= 0, passive()], STABLE))


@claims("s5c-robust-subset")
def _passive_is_robust(printed: Printed) -> Proposition:
    """A passive wall is stable with every spring: robustly stable."""
    robust = ForAll((gamma,), implied([gamma >= 0], STABLE))
    walls = tuple(s for s in LOOP if s != gamma)
    return ForAll(walls, implied([delta >= 0, d >= 0, passive()], robust))


@claims("s5a-proportional")
def _passive_region_scales(printed: Printed) -> Proposition:
    """With y times the damping, the walls that are y times as large are passive."""
    walls = (alpha, beta, delta, d, y)
    return ForAll(walls, implied([delta >= 0, d >= 0, y > 0], Iff((passive(), passive(y)))))
