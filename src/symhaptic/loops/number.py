"""Polynomials whose coefficients are floats, arrays or SymPy's expressions."""

from __future__ import annotations

from typing import Any, TypeAlias

Number: TypeAlias = Any
"""A float, an array of NumPy's or an expression of SymPy's: one formula serves all three, and no
type names what their sums and products have in common."""

Polynomial: TypeAlias = tuple[Number, ...]
"""Coefficients of 1, w, w^2, ..., with w = z - 1."""


def product(one: Polynomial, other: Polynomial) -> Polynomial:
    """The product of two polynomials.

    >>> product((1, 1), (1, 1))
    (1, 2, 1)
    """
    found: list[Number] = [0] * (len(one) + len(other) - 1)
    for i, left in enumerate(one):
        for j, right in enumerate(other):
            found[i + j] = found[i + j] + left * right
    return tuple(found)


def total(one: Polynomial, other: Polynomial) -> Polynomial:
    """The sum of two polynomials.

    >>> total((1, 1), (1,))
    (2, 1)
    """
    longer, shorter = sorted((one, other), key=len, reverse=True)
    return (*(a + b for a, b in zip(longer, shorter, strict=False)), *longer[len(shorter) :])


def scaled(factor: Number, one: Polynomial) -> Polynomial:
    """A polynomial times a number."""
    return tuple(factor * each for each in one)


def power_of_z(exponent: int) -> Polynomial:
    """z^n = (1 + w)^n.

    >>> power_of_z(3)
    (1, 3, 3, 1)
    """
    found: Polynomial = (1,)
    for _ in range(exponent):
        found = product(found, (1, 1))
    return found


def all_inside(falling: list[Number]) -> bool | None:
    """Whether all roots of a polynomial in z lie in |z| < 1, by Schur's reduction.

    The coefficients begin with the highest power.  They are fractions or balls; None if balls
    cannot decide.

    >>> from fractions import Fraction
    >>> all_inside([Fraction(1), Fraction(-1)]), all_inside([Fraction(2), Fraction(1)])
    (False, True)
    """
    while len(falling) > 1:
        share = falling[-1] / falling[0]
        if abs(share) >= 1:
            return False
        if not abs(share) < 1:
            return None
        mirrored = zip(falling, reversed(falling), strict=True)
        falling = [one - share * other for one, other in mirrored][:-1]
    return True
