"""Corner, tip and every other wall of the envelope leave all angles a margin, for N >= 2.

Without delay, N = 2, the envelope is a single wall, which leaves no margin at any angle.
"""

from symhaptic.book.lemmas.chords import sine, size, width
from symhaptic.book.lemmas.envelope import damping, divisor, line, stiffness
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
    here = Given(N > 2, psi > 0, N * psi < pi)
    inside = Given(N > 2, phi < pi / N).closed(touches())
    near = tends(line(stiffness(phi), damping(phi)), phi, S.Zero, line(*CORNER))
    found = show(AT_CORNER, in_the_limit(inside, phi, S.Zero, pi / N, near))
    wave = here.show((N**2 - 1) * sin(psi) > 0, sine())
    turned = [
        factor(claim.left, wave, -I * exp(-I * (N + 1) * psi) / 8)
        for claim in found.hypotheses
        if isinstance(claim, Relation) and claim.left.has(I)
    ]
    return here.closed(closed(found, *turned), size(), sine())


def undelayed(goal: Any, *divisors: Theorem) -> Theorem:
    """F = 0 at N = 2, and so for every N that is 2."""
    claim = proposition(goal).at({N: x})
    two = {x: S(2)}
    there = claim.at(two)
    return subst(claim, x, closed(show(there), *divisors), show(Eq(S(2), N), Eq(N, 2)))


def either_delay(delayed: Theorem, undelayed: Theorem) -> Theorem:
    """What holds for N > 2 and for N = 2 holds for N >= 2."""
    more = strictly(assume(N >= 2), combined(Ne(S(2), N), [assume(Ne(N, 2))]))
    return disj_cases(decided(N, 2), undelayed, closed(delayed, more))


WIDE = Given(N >= 2, psi > 0, N * psi < pi).about(psi)
single, twice = WIDE(sin(psi) > 0), WIDE(sin(2 * psi) > 0)


@cache
def divisors(angle: Expr = psi) -> tuple[Theorem, ...]:
    """What F and the envelope divide by is not zero, for N = 2."""
    known = single(angle), twice(angle)
    return tuple(show(Ne(e, 0), *known, degree=3) for e in (sin(angle), divisor(angle).subs(N, 2)))


@cache
def wide(angle: Expr = psi) -> Theorem:
    """0 < N sin 2 psi - sin 2 N psi, for N >= 2."""
    claim = proposition(divisor(angle).subs(N, x) > 0)
    product = show(divisor(angle).subs(N, 2) > 0, single(angle), twice(angle), degree=3)
    return either_delay(width(angle), subst(claim, x, product, show(Eq(S(2), N), Eq(N, 2))))


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
