"""Sums, products and quotients of numbers that are kept to twice the precision of a float."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.export.routine import ProductError, Steps, difference, quotient


@dataclass(frozen=True)
class Twice:
    """A float and what it misses, as names of steps; other numbers are exact."""

    do: Steps
    high: Expr
    low: Expr = sp.S.Zero

    def __add__(self, other: Twice) -> Twice:
        """The sum, whichever is larger."""
        return self - Twice(self.do, -other.high, -other.low)

    def __sub__(self, other: Twice) -> Twice:
        """The difference, whichever is larger."""
        total, lost = difference(self.do, self.high, other.high)
        return Twice(self.do, total, self.do("low", lost + (self.low - other.low)))

    def __mul__(self, other: Twice) -> Twice:
        """The product."""
        total = self.do("total", self.high * other.high)
        rest = self.high * other.low + other.high * self.low
        return Twice(self.do, total, self.do("low", ProductError(self.high, other.high) + rest))

    def __truediv__(self, other: Twice) -> Twice:
        """The quotient."""
        return Twice(self.do, *quotient(self.do, self.high, other.high, self.low, other.low))

    def rounded(self, name: str) -> Symbol:
        """The float nearest to it, all but always."""
        return self.do(name, self.high + self.low)
