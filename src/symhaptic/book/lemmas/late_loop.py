"""The polynomial z^(l+2) A + M W of a loop that is late by a fraction of a period."""

from symhaptic.book.lemmas.late_device import BOTTOM, TOP
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.axioms import LATE_DEVICE, LATE_NUMBERS
from symhaptic.proof.theorems.roots import degree

WALL = (alpha + beta) * z - beta
POLYNOMIAL = z ** (l + 2) * BOTTOM + TOP * WALL
LATE_STABLE = Predicate("stable_loop", (), (alpha, beta, gamma, delta, l + epsilon))
GIVEN = (whole(l), proposition(epsilon >= 0), proposition(epsilon <= 1))
LOOP = (alpha, beta, gamma, delta, epsilon, l)
DEVICES = (LATE_DEVICE, DEVICE)
ALL_NUMBERS = (*LATE_NUMBERS, *NUMBERS)


def whole_polynomial(delay: Expr) -> Expr:
    """z^(d+1) A + N W of an integer delay."""
    return z ** (delay + 1) * BOTTOM + (n_1 * z + n_0) * WALL


ENDS = (z * whole_polynomial(l), whole_polynomial(l + 1))
"""What the polynomial is without a fraction, and at a full period."""


def late_polynomial() -> Proposition:
    """The loop is stable where all zeros lie inside; the degree is l + 4; and at the ends it is
    z times that of the delay l, and that of the delay l + 1."""
    claims = (
        Iff((LATE_STABLE, Predicate("stable", (z,), (POLYNOMIAL,)))),
        Predicate("degree", (z,), (POLYNOMIAL, l + 4)),
        *(
            implied([Eq(epsilon, end)], every([z], [Ne(z, 0)], Relation(POLYNOMIAL, "=", value)))
            for end, value in enumerate(ENDS)
        ),
    )
    return every(LOOP, GIVEN, every(ALL_NUMBERS, DEVICES, both(claims)))


@cache
def polynomial_of_a_late_loop() -> Theorem:
    """That."""
    loop = axiom("loop of a late device", *LOOP[:4], l, epsilon, *LATE_NUMBERS, a, e)
    steps = [is_whole(l + n, assume(whole(l))) for n in (2, 3, 4)]
    highest = closed(degree(POLYNOMIAL, z, l + 4), *steps, fact(Relation(S.One, "!=", S.Zero)))
    found = conj(loop, highest, _end(0), _end(1))
    found = for_all(ALL_NUMBERS, DEVICES, add_assum(found, *DEVICES))
    return for_all(LOOP, GIVEN, add_assum(found, *GIVEN))


@cache
def numbers_of_a_late_device() -> tuple[Theorem, ...]:
    """m_2 + m_1 + m_0 = n_1 + n_0, and the numbers at the fractions 0 and 1."""
    found = axiom("late device and device", gamma, delta, epsilon, *LATE_NUMBERS, *NUMBERS)
    return tuple(conjunct(found, claim) for claim in found.conclusion.parts)


def _end(end: int) -> Theorem:
    there = numbers_of_a_late_device()[1 + end]
    given = assume(Eq(epsilon, end))
    equal = mp(there, given)
    numbers = [conjunct(equal, claim) for claim in conjuncts(equal.conclusion)]
    shares = [[t, z**n * WALL] for t, n in zip(numbers, (2, 1, 0), strict=True)]
    same = combined(Relation(POLYNOMIAL, "=", ENDS[end]), *shares)
    return disch(for_all([z], [Ne(z, 0)], same), Eq(epsilon, end))
