"""Corner, tip and every other wall of the envelope leave all angles a margin, for N >= 2.

Without delay, N = 2, the envelope is a single wall, which leaves no margin at any angle.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero, sine, size, width
from symhaptic.book.lemmas.envelope import damping, divisor, line, stiffness
from symhaptic.book.lemmas.extent import sine as sine_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.tip import ITS_DAMPING, STIFFEST, tip
from symhaptic.book.lemmas.touching import GOAL, touches

CORNER = 3 * N / (2 * (N**2 - 1)), (N**2 + 2) / (2 * (N**2 - 1))
"""Where the envelope begins, at phi -> 0."""

AT_CORNER = line(*CORNER) >= 0
AT_TIP = line(STIFFEST, ITS_DAMPING) >= 0


@cache
def corner_delayed() -> Theorem:
    """0 <= F of the corner, for N > 2."""
    below = closed(positive(N * phi < pi, [size(), phi < pi / N]), not_zero(size()))
    inside = closed(touches(), below)
    near = tends(line(stiffness(phi), damping(phi)), phi, S.Zero, line(*CORNER))
    found = positive(AT_CORNER, [in_the_limit(inside, phi, S.Zero, pi / N, near)])
    more = positive(N**2 - 1 > 0, [N > 2, N > 2], [4, N > 2], [3])
    cubic = positive(4 * N**3 / 3 - 4 * N / 3 > 0, [Rational(4, 3), size(), more])
    double = positive(2 * N**2 - 2 > 0, [2, more])
    wave = positive((N**2 - 1) * sin(psi) > 0, [more, sine()])
    turned = [
        factor(claim.left, wave, -I * exp(-I * (N + 1) * psi) / 8)
        for claim in found.hypotheses
        if isinstance(claim, Relation) and claim.left.has(I)
    ]
    divisors = map(not_zero, (sine(), cubic, double, size()))
    return closed(found, *divisors, *turned, over(pi / N > 0, PI, size()))


def undelayed(goal: Any, *divisors: Theorem) -> Theorem:
    """F = 0 at N = 2, and so for every N that is 2."""
    claim = proposition(goal).at({N: x})
    two = {x: S(2)}
    there = claim.at(two)
    zero = closed(identity(there.right, S.Zero), *divisors)  # type: ignore[attr-defined]
    weak = combined(there, [zero, S.NegativeOne])
    equation = combined(Eq(S(2), N), [assume(Eq(N, 2)), S.NegativeOne])
    return subst(claim, x, weak, equation)


def either_delay(delayed: Theorem, undelayed: Theorem) -> Theorem:
    """What holds for N > 2 and for N = 2 holds for N >= 2."""
    more = strictly(assume(N >= 2), combined(Ne(S(2), N), [assume(Ne(N, 2))]))
    return disj_cases(decided(N, 2), undelayed, closed(delayed, more))


@cache
def waves(angle: Expr = psi) -> tuple[Theorem, ...]:
    """0 < sin 2 psi and twice 0 < sin psi, for N >= 2."""
    up, low = assume(N * angle < pi), assume(angle > 0)
    quarter = positive(angle < pi / 2, [HALF, up], [HALF, N >= 2, low])
    wave = closed(sine_below(angle), quarter)
    inside = positive(2 * angle > 0, [2, low]), positive(2 * angle < pi, [2, quarter])
    return closed(sign_of(sin, 2 * angle), *inside), wave, wave


@cache
def divisors(angle: Expr = psi) -> tuple[Theorem, ...]:
    """What F and the envelope divide by is not zero, for N = 2."""
    twice, wave, _ = waves(angle)
    product = positive(divisor(angle).subs(N, 2) > 0, [4, twice, wave, wave])
    return not_zero(wave), not_zero(product)


@cache
def wide(angle: Expr = psi) -> Theorem:
    """0 < N sin 2 psi - sin 2 N psi, for N >= 2."""
    claim = proposition(divisor(angle).subs(N, x) > 0)
    product = positive(divisor(angle).subs(N, 2) > 0, [4, *waves(angle)])
    equation = combined(Eq(S(2), N), [assume(Eq(N, 2)), S.NegativeOne])
    return either_delay(width(angle), subst(claim, x, product, equation))


@cache
def corner() -> Theorem:
    """0 <= F of the corner, for N >= 2."""
    return either_delay(corner_delayed(), closed(undelayed(AT_CORNER), *divisors()))


@cache
def stiffest() -> Theorem:
    """0 <= F of the tip, for N >= 2."""
    return either_delay(tip(), closed(undelayed(AT_TIP), *divisors()))


@cache
def on_envelope() -> Theorem:
    """0 <= F of the wall (U, W)(phi), for N >= 2."""
    return either_delay(touches(), closed(undelayed(GOAL), *divisors(), *divisors(phi)))
