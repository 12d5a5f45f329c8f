"""When is a wall passive that is late by a fraction of a period?  The condition at each angle."""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Ne

from symhaptic.book.lemmas.passivity import INSIDE, at_every_angle
from symhaptic.model import fractional
from symhaptic.notation import B, K, T, b, epsilon, l, theta, z
from symhaptic.notation.proposition import And, Predicate, proposition, whole
from symhaptic.proof.theorems.energy import toeplitz
from symhaptic.proof.theorems.familiar import axiom
from symhaptic.proof.theorems.kernel import (
    Theorem,
    assume,
    conjoined,
    part,
)
from symhaptic.proof.theorems.leaves import is_whole
from symhaptic.proof.theorems.tactics import (
    at,
    chained,
    closed,
    either_way,
    for_all,
    one,
    over,
    positive,
    sine_of_half,
)

WALL = (K, B, b, T, l, epsilon)
LATE = Predicate("passive_wall", (), (K, B, b, T, l + epsilon))
"""The wall is passive, l + epsilon periods late."""
GIVEN = tuple(map(proposition, (T > 0, b > 0, whole(l), epsilon >= 0, epsilon <= 1)))
MARGIN = fractional.margin()
EVERY_MARGIN = at_every_angle(MARGIN >= 0)


@cache
def passive_late() -> Theorem:
    """passive <=> 0 <= K and 0 <= b (b - n) - epsilon (1 - epsilon) T^2 |H|^2/4 at every angle."""
    energy = axiom("passive late wall", *WALL)
    sampled = energy.conclusion.parts[1]
    form = toeplitz(sampled.terms[0], z, sampled.terms[1], theta)
    wanted = And((proposition(K >= 0), EVERY_MARGIN))
    static, always = form.conclusion.parts[1].parts
    raw = always.body.of[1]  # type: ignore[attr-defined]
    half = sine_of_half(theta)
    apart = [
        positive(Ne(sp.sin(theta / 2), 0), [half]),
        positive(Ne(2 - 2 * sp.cos(theta), 0), [4, half, half]),
        positive(Ne(T, 0), T > 0),
        positive(Ne(b, 0), b > 0),
    ]
    known = And((static, always))
    inside = [assume(p) for p in INSIDE]
    here = at(part(assume(known), always), {theta: theta}, *inside)
    there = closed(positive(MARGIN >= 0, [here, T > 0, b > 0]), *apart)
    period, damper = over(1 / T > 0, one(), T > 0), over(1 / b > 0, one(), b > 0)
    margin = at(part(assume(wanted), EVERY_MARGIN), {theta: theta}, *inside)
    back = closed(positive(raw, [margin, period, damper]), *apart)
    spring, sums = part(assume(wanted), K >= 0), part(assume(known), static)
    same = either_way(
        conjoined(positive(K >= 0, [sums]), for_all([theta], INSIDE, there)),
        conjoined(positive(static, [spring]), for_all([theta], INSIDE, back)),
        known,
        wanted,
    )
    found = chained(energy, chained(form, same))
    steps = [is_whole(l + n, assume(whole(l))) for n in (1, 2)]
    steps += [is_whole(sp.Integer(n)) for n in (0, 1)]
    return closed(found, *apart, *steps)
