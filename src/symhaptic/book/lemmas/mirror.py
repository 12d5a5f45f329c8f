"""At the Nyquist frequency the device turns into its mirror image: a pole that no wall moves."""

from __future__ import annotations

from functools import cache

from sympy import Expr, I, Ne, S, exp, pi

from symhaptic.model import plant
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, delta, gamma, l, z
from symhaptic.notation.proposition import Predicate, Relation, whole
from symhaptic.paper.propositions.comparison import LATE, MIRROR, q
from symhaptic.proof.theorems.familiar import (
    rising,
    sign_of,
    square,
)
from symhaptic.proof.theorems.kernel import Theorem, assume
from symhaptic.proof.theorems.leaves import (
    combined,
    factor,
    identity,
    is_whole,
    number,
)
from symhaptic.proof.theorems.roots import pole_at
from symhaptic.proof.theorems.tactics import closed, positive


@cache
def mirrored_pole(damping: Expr) -> Theorem:
    """-exp(-delta/2) is a pole for gamma = pi^2 + delta^2/4, for every wall and l/q periods."""
    spring, damped = pi**2 + damping**2 / 4, damping != 0
    device = plant.sampled(plant.normalised(Parts(damping=damped)), split=2 * I * pi)
    turn = -damping / 2 + I * pi
    there = exp(turn)
    values = {gamma: spring, delta: damping, z: there}
    wall = (alpha + beta) * there - beta
    loop = exp((LATE + 1) * turn) * device.denominator + device.numerator * wall
    zero = identity(loop.xreplace(values), S.Zero)
    parts = {"damping": damped}
    found = pole_at((alpha, beta, spring, damping, LATE), z, q, turn, zero, **parts)
    numbers = [assume(whole(n)) for n in (l, q)]
    sums = [
        is_whole(claim.of[0], *numbers)
        for claim in found.hypotheses
        if isinstance(claim, Predicate) and claim.of[0] not in (l, q)
    ]
    stiff = combined(
        Relation(S.Zero, "<", spring),
        [number(Relation(S.Zero, "<", pi**2))],
        [S.One / 4, square(damping)],
    )
    apart = combined(Relation(spring, "!=", S.Zero), [stiff])
    stiffer = closed(found, *sums, apart, positive(Ne(q, 0), q > 0))
    if not damped:
        return stiffer
    other = -damping / 2 - I * pi
    return closed(stiffer, factor(turn, stiff, other), factor(other, stiff, turn))


@cache
def inside() -> tuple[Theorem, Theorem]:
    """-1 < -exp(-delta/2) and -exp(-delta/2) < 1, for delta > 0."""
    low = closed(rising(exp, -delta / 2, S.Zero), positive(-delta / 2 < 0, [S.Half, delta > 0]))
    high = positive(MIRROR < 1, [sign_of(exp, -delta / 2)], [S.One])
    return positive(MIRROR > -1, [low]), high
