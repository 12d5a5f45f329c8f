"""Rational numbers of SymPy's as flint's, and back."""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq, fmpq_poly
from sympy import Rational


def fraction(number: Rational) -> fmpq:
    """A number of SymPy's as one of flint's."""
    return fmpq(int(number.p), int(number.q))


def rational(number: fmpq) -> Rational:
    """And back.

    >>> rational(fraction(Rational(-2, 3)) ** 2)
    4/9
    """
    return Rational(int(number.p), int(number.q))


def from_leading(coefficients: Sequence[Rational]) -> fmpq_poly:
    """The polynomial with these coefficients, of which the first leads.

    >>> print(from_leading([Rational(1, 2), Rational(0), Rational(3)]))
    1/2*x^2 + 3
    """
    return fmpq_poly([fraction(c) for c in reversed(coefficients)])
