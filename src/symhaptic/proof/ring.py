"""Quotients of polynomials over the rationals, in generators that may obey a relation each."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Expr


@dataclass(frozen=True)
class Fractional:
    """A quotient of polynomials in the generators of :class:`symhaptic.proof.normal.Field`."""

    num: fmpq_mpoly
    den: fmpq_mpoly

    def __mul__(self, other: Fractional) -> Fractional:
        return Fractional(self.num * other.num, self.den * other.den)

    def __pow__(self, n: int) -> Fractional:
        if n < 0:
            return Fractional(self.den ** (-n), self.num ** (-n))
        return Fractional(self.num**n, self.den**n)


class Ring:
    """Polynomials over the rationals in named generators, with one relation for some of them."""

    def __init__(self, names: list[Expr]) -> None:
        self.names = names
        # flint wants at least one generator
        labels = [f"g{i}" for i in range(max(1, len(names)))]
        self.ctx = fmpq_mpoly_ctx.get(labels, "degrevlex")
        self.gen = dict(zip(names, self.ctx.gens(), strict=False))
        self.one = self.ctx.constant(1)
        self.relations: list[tuple[int, dict[int, fmpq_mpoly]]] = []
        self.small: int | None = None
        """Index of the variable in which polynomials are cut off, in a series."""

    def sum(self, left: Fractional, right: Fractional) -> Fractional:
        """Over a common divisor; in a series nothing that vanishes with the variable is shared,
        since dividing by it would lose orders of the cut-off polynomials."""
        common = left.den.gcd(right.den)
        if self.small is not None and any(m[self.small] for m in common.to_dict()):
            common = self.one
        ours, theirs = right.den / common, left.den / common
        return Fractional(left.num * ours + right.num * theirs, left.den * ours)

    def constant(self, value: sp.Rational) -> Fractional:
        """A rational number as an element."""
        return Fractional(self.ctx.constant(fmpq(int(value.p), int(value.q))), self.one)

    def relate(self, name: Expr, coefficients: dict[int, fmpq_mpoly]) -> None:
        """Impose sum of coefficient times name**power = 0."""
        self.relations.append((self.names.index(name), coefficients))

    def reduce(self, poly: fmpq_mpoly) -> fmpq_mpoly:
        """The polynomial modulo all relations, up to a factor that is not zero."""
        for index, relation in reversed(self.relations):
            degree = max(relation)
            main = self.gen[self.names[index]]
            while True:
                parts = self.by_power(poly, index)
                top = max(parts, default=0)
                if top < degree:
                    break
                rest = sum(
                    (c * main ** (p + top - degree) for p, c in relation.items() if p < degree),
                    self.ctx.constant(0),
                )
                lower = poly - parts[top] * main**top
                poly = relation[degree] * lower - parts[top] * rest
        return poly

    def by_power(self, poly: fmpq_mpoly, index: int) -> dict[int, fmpq_mpoly]:
        """The coefficients of the powers of one generator."""
        split: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for monomial, value in poly.to_dict().items():
            rest = (*monomial[:index], 0, *monomial[index + 1 :])
            split.setdefault(int(monomial[index]), {})[rest] = value
        return {power: self.ctx.from_dict(part) for power, part in split.items()}
