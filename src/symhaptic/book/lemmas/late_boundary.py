"""The walls that put a zero of a loop on the circle that is late by a fraction of a period."""

from symhaptic.book.lemmas.boundary import explicit_wall
from symhaptic.book.lemmas.late_device import BOTTOM, TOP
from symhaptic.book.lemmas.late_loop import (
    ALL_NUMBERS,
    DEVICES,
    GIVEN,
    LOOP,
    POLYNOMIAL,
    numbers_of_a_late_device,
)
from symhaptic.book.lemmas.prelude import *

TURN = exp(I * theta)
A, M = (p.subs(z, TURN) for p in (BOTTOM, TOP))
"""A and M at exp(j theta)."""
ROOT = Relation(exp(I * (l + 2) * theta) * A + M * ((alpha + beta) * TURN - beta), "=", S.Zero)
"""The loop has a zero there."""
SQUARE = (
    m_2**2 + m_1**2 + m_0**2 + 2 * m_1 * (m_2 + m_0) * cos(theta) + 2 * m_2 * m_0 * cos(2 * theta)
)
"""|M|^2."""
TERMS = {3: m_0, 2: m_1 - a * m_0, 1: m_2 - a * m_1 + e * m_0, 0: e * m_1 - a * m_2, -1: e * m_2}
"""z A times the conjugate of M, by powers of z."""


def _sum(function: type[Expr], shift: Expr = S.Zero) -> Expr:
    return -sum((c * function((l + k + shift) * theta) for k, c in TERMS.items()), S.Zero)


def on_boundary() -> And:
    """alpha = Re Q - beta (1 - cos theta) and beta = Im Q/sin theta, with Q = -z^(l+1) A/M."""
    across = _sum(cos, S.Half) / (cos(theta / 2) * SQUARE)
    up = _sum(sin) / (sin(theta) * SQUARE)
    return And((Relation(alpha, "=", across), Relation(beta, "=", up)))


LINES = (
    (S.One, (n_1 + n_0) * (alpha + gamma)),
    (-S.One, (-S.One) ** l * (1 + a + e) - (m_2 - m_1 + m_0) * (alpha + 2 * beta)),
)
"""The polynomial at 1 and at -1."""


def late_boundary() -> Proposition:
    """A zero at exp(j theta) asks for one wall, where M is not zero, and for none where it is,
    unless A is zero; and the polynomial at 1 and -1 is linear in the wall."""
    angles = both(
        (
            implied([Relation(M, "!=", S.Zero)], Iff((ROOT, on_boundary()))),
            implied([Relation(M, "=", S.Zero)], Iff((ROOT, Relation(A, "=", S.Zero)))),
        )
    )
    lines = (Relation(POLYNOMIAL.subs(z, end), "=", value) for end, value in LINES)
    claims = both((every([theta], INSIDE, angles), *lines))
    return every(LOOP, GIVEN, every(ALL_NUMBERS, DEVICES, claims))


@cache
def boundary_is_explicit() -> Theorem:
    """That."""
    found = conj(
        for_all([theta], INSIDE, add_assum(conj(_one_wall(), _no_wall()), *INSIDE)), *_lines()
    )
    found = for_all(ALL_NUMBERS, DEVICES, add_assum(found, *DEVICES))
    return for_all(LOOP, GIVEN, add_assum(found, *GIVEN))


def _one_wall() -> Theorem:
    moved = assume(Ne(M, 0))
    apart = combined(Relation(SQUARE, "!=", S.Zero), [moved, mirrored(moved)])
    return disch(closed(explicit_wall(ROOT, on_boundary(), M, SQUARE), apart), Ne(M, 0))


def _no_wall() -> Theorem:
    still, alone = assume(Relation(M, "=", S.Zero)), Relation(A, "=", S.Zero)
    turn, wall = exp(I * (l + 2) * theta), (alpha + beta) * TURN - beta
    there = combined(alone, [assume(ROOT), 1 / turn], [still, -wall / turn])
    here = combined(ROOT, [assume(alone), turn], [still, wall])
    return disch(either_way(there, here, ROOT, alone), still.conclusion)


def _lines() -> tuple[Theorem, Theorem]:
    total = numbers_of_a_late_device()[0]
    (one, value), (other, last) = LINES
    return (
        combined(
            Relation(POLYNOMIAL.subs(z, one), "=", value),
            [total, alpha],
            [device_static(assume(DEVICE)), S.One],
        ),
        identity(POLYNOMIAL.subs(z, other), last),
    )
