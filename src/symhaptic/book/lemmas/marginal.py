"""How little damper and spring of (23) change without delay, and how much behind a long one.

Fifty periods late, d = 49, the spring (pi/100)^2, which (23) allows, excludes each wall that does
not pull if there is no damper.
"""

from __future__ import annotations

from typing import Any

from sympy import Eq, Expr, Rational, S, pi

from symhaptic.book.lemmas.stiffest_stable import no_stiffer, numbers_known, stable_wall
from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, beside, linear
from symhaptic.book.lemmas.undamped_robust import excluded
from symhaptic.notation import alpha, beta, d, delta, gamma, x, y
from symhaptic.notation.proposition import Exists, Proposition, Relation, conjuncts
from symhaptic.paper.propositions.conclusion import HARDLY
from symhaptic.paper.propositions.ratio import WALL
from symhaptic.paper.ranges import RANGES
from symhaptic.proof.theorems.kernel import (
    Theorem,
    assume,
    chosen,
    placed,
    substituted,
)
from symhaptic.proof.theorems.leaves import combined
from symhaptic.proof.theorems.tactics import at, closed, fact, positive, reductio

LIMIT = Rational("0.6899") + Rational("1.2") * delta
"""A little stiffer than every stable wall without delay, for all springs of (23)."""
NEAR = UNDELAYED[1]
AT_ONCE = Eq(d, 0)
LONG = {gamma: (pi / 100) ** 2, d: S(49)}


def behind(delay: int, claim: Proposition, theorem: Theorem) -> Theorem:
    """What holds for one delay, with d in its place, under d = that."""
    place = d
    equal = combined(Relation(S(delay), "=", d), [assume(Eq(d, delay)), -1])
    return substituted(claim, place, theorem, equal)


def hardly(claim: Proposition, best: dict[Any, Expr], others: dict[Any, Expr]) -> Theorem:
    """Without delay there is a wall of one device that no wall of the other exceeds by much."""
    undelayed = claim.at({d: S.Zero})
    wall = tuple(v.subs(best) for v in UNDELAYED)
    stable = _there(stable_wall(0, UNDELAYED, RANGES), best)
    limit = _there(no_stiffer(0, (LIMIT, NEAR), RANGES), others)
    rest = HARDLY * wall[0] - LIMIT.subs(others)

    def bound(wanted: Any) -> Theorem:
        return positive(wanted, [limit], *linear(rest, RANGES[delta]))

    return behind(0, claim, beside(undelayed, stable, wall, bound))


def _there(theorem: Theorem, values: dict[Any, Expr]) -> Theorem:
    """For one spring or one damper of the range."""
    found = placed(theorem, values)
    return numbers_known(found)


def none_pushes(claim: Exists, wall: tuple[Expr, Expr], stable: Theorem) -> Theorem:
    """No wall of the undamped device is hardly exceeded by ``wall``, which is stable and pushes."""
    best, others = (assume(p) for p in conjuncts(claim.body))
    below = at(others, dict(zip(WALL, wall, strict=True)), stable)
    share = 1 / HARDLY
    least = combined(Relation(S.Zero, "<=", x), [share, below], [share * wall[0]])
    false = placed(excluded(), {alpha: x, beta: y, d: S(49)})
    false = closed(false, least, best, *(fact(p) for p in false.hypotheses if not p.free))
    return reductio(chosen(assume(claim), false), claim)
