"""Signs in the units of a device and an arm within the paper's range (23)."""

from symhaptic.book.lemmas.prelude import *

FIFTIETH = Rational(1, 50)
"""The largest delta of (23)."""
SHARE = b * T / m
"""delta of Table I."""


def above(large: Expr | int, small: Expr | int) -> Theorem:
    """One number is larger than another."""
    return number(Relation(S.Zero, "<", S.Zero + large - small))


@cache
def divisors() -> tuple[Theorem, ...]:
    """m != 0 and T != 0."""
    return positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)


@cache
def rate() -> Theorem:
    """0 < 1/T."""
    return over(1 / T > 0, one(), T > 0)


@cache
def scale() -> Theorem:
    """0 < m/T^2."""
    return over(m / T**2 > 0, m > 0, positive(T**2 > 0, [T > 0, T > 0]))


@cache
def damped() -> Theorem:
    """0 <= b, from that of delta."""
    return positive(b >= 0, [SHARE >= 0, m > 0, rate()])


@cache
def weak(share: Expr = delta) -> Theorem:
    """delta^2 <= 0.0004 inside (23)."""
    more = positive(share + FIFTIETH > 0, [share >= 0], [above(FIFTIETH, 0)])
    return positive(share**2 <= FIFTIETH**2, [share <= FIFTIETH, more])
