"""Signs of sines and chords for 0 < N psi < pi and N > 2: what makes the envelope rise and fall.

Each theorem is about psi, and given at any angle, under N > 2, 0 < psi and N psi < pi there.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.analysis import grows

PI = number(Relation(S.Zero, "<", pi))
HERE = Given(N > 2, psi > 0, N * psi < pi)
BEFORE = Given(N > 2, phi > 0, phi < psi, N * psi < pi)
lemma = HERE.about(psi)

size = lemma(N > 0)
quarter = lemma(psi < pi / 2)
sine = lemma(sin(psi) > 0)
cosine = lemma(cos(psi) > 0)
sine_of_larger = lemma(sin(N * psi) > 0)
falls = lemma(cos(psi) - cos(N * psi) > 0, lambda: rising(cos, psi, N * psi))


def _from_zero(rest: Expr, *uses: Theorem, before: Given = BEFORE) -> Theorem:
    """0 < f(psi), for f(0) = 0 and a positive slope before."""
    return grows(rest, phi, S.Zero, psi, before.show(derivative(rest, phi) > 0, *uses, degree=4))


def _chord(step: int, angle: Expr) -> Expr:
    """sin N psi - N sin psi cos (N + step) psi."""
    return sin(N * angle) - N * sin(angle) * cos((N + step) * angle)


def _flat(angle: Expr) -> Expr:
    return N * sin(angle) - sin(N * angle)


flatter = lemma(_flat(psi) > 0, lambda: _from_zero(_flat(phi), falls(phi)))
width = lemma(N * sin(2 * psi) - sin(2 * N * psi) > 0, flatter, cosine, sine_of_larger, falls)
"""The divisor of (7)."""
chord_before = lemma(
    _chord(-1, psi) > 0, lambda: _from_zero(_chord(-1, phi), sine(phi), sign_of(sin, (N - 1) * phi))
)


def _chord_after() -> Theorem:
    """Before (N+1) psi = pi and after."""
    room, more = (N + 1) * psi, sign_of(sin, (N + 1) * phi)
    early = _from_zero(_chord(1, phi), sine(phi), more, before=BEFORE.and_(room < pi))
    late = HERE.and_(room >= pi)
    known = size(), sine(), sine_of_larger(), sign_of(cos, room - pi)
    return disj_cases(ordered(room, pi), early, late.show(_chord(1, psi) > 0, *known, degree=3))


chord_after = lemma(_chord(1, psi) > 0, _chord_after)


def _bent(angle: Expr) -> Expr:
    wave = sin(N * angle)
    return N * sin(2 * angle) + sin(2 * N * angle) - 4 * wave**2 * cos(angle) / (N * sin(angle))


def _rises() -> Theorem:
    """It rises from zero."""
    inside = Given(N > 2, phi > 0, phi < pi / N)
    turns = inside.have(N * phi < pi), chord_before(phi), chord_after(phi), sine(phi)
    slope = inside.show(derivative(_bent(phi), phi) > 0, *turns)
    rises = increases(_bent(phi), phi, S.Zero, pi / N, slope, inside.show(Ne(sin(phi), 0), *turns))
    return inst(above_its_start(rises, tends(_bent(phi), phi, S.Zero, S.Zero)), {phi: psi})


bend = lemma(_bent(psi) > 0, _rises)


def lowest_coefficients(theorem: Theorem, sine_: Theorem, angle: Expr) -> list[Theorem]:
    """That multiples of 0 < sin x and powers of exp(j x), as series leave them, are not zero."""
    found = []
    for claim in theorem.hypotheses:
        if isinstance(claim, Relation) and claim.left.has(I):
            for other in (s * HALF * exp(-n * I * angle) for s in (1, -1) for n in range(5)):
                if is_zero(claim.left * other - sin(angle)):
                    found.append(factor(claim.left, sine_, other))
    return found
