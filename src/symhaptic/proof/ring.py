"""Quotients of polynomials over the rationals, in generators that may obey a relation each."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from math import comb, prod

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, nmod_mpoly, nmod_mpoly_ctx
from sympy import Expr

from symhaptic.notation.exact import fraction
from symhaptic.proof.budget import spend

_ONE, _ZERO = fmpq(1), fmpq(0)


@dataclass(slots=True)
class Fractional:
    """A quotient of polynomials in the generators of :class:`symhaptic.proof.normal.Field`."""

    num: fmpq_mpoly
    den: fmpq_mpoly

    def __mul__(self, other: Fractional) -> Fractional:
        spend(len(self.num) * len(other.num) + len(self.den) * len(other.den))
        den = self.den if other.den.is_one() else self.den * other.den
        return Fractional(self.num * other.num, den)

    def __pow__(self, n: int) -> Fractional:
        for poly in (self.num, self.den):
            terms = max(len(poly), 1)
            plain = terms == 1 and all(abs(c) == 1 for c in poly.coeffs())
            if not plain:
                spend(abs(n) * terms)
                spend(comb(abs(n) + terms - 1, terms - 1) * (1 + abs(n) * _bits(poly) // _DIGIT))
        if n < 0:
            return Fractional(self.den ** (-n), self.num ** (-n))
        return Fractional(self.num**n, self.den**n)


_DIGIT = 256
"""Numbers of so many bits are as dear as short ones."""

_FEW = 32
"""So many times, dividing by a relation is quicker than looking at each term."""


def _bits(poly: fmpq_mpoly) -> int:
    """Each time that a power of it is multiplied by it, a coefficient may grow by so many bits."""
    return max((c.height_bits() for c in poly.coeffs()), default=1) + len(poly).bit_length()


@cache
def _polynomials(count: int) -> tuple[fmpq_mpoly_ctx, tuple[fmpq_mpoly, ...], fmpq_mpoly]:
    """The polynomials in so many generators, of which flint wants one at least; these, and 1."""
    ctx = fmpq_mpoly_ctx.get([f"g{i}" for i in range(count)], "degrevlex")
    return ctx, ctx.gens(), ctx.constant(1)


class Ring:
    """Polynomials over the rationals in named generators, with one relation for some of them."""

    def __init__(self, names: list[Expr]) -> None:
        self.names = names
        self.ctx, generators, self.one = _polynomials(max(1, len(names)))
        self.gen = dict(zip(names, generators, strict=False))
        self._index = {name: i for i, name in enumerate(names)}
        self.relations: list[tuple[int, dict[int, fmpq_mpoly]]] = []
        self.moduli: dict[int, fmpq_mpoly] = {}
        """The relations that are monic and have numbers as coefficients, by their generator."""
        self.folds: dict[int, tuple[int, fmpq]] = {}
        """A power of a generator, and the number that it is by its relation."""
        self.small: int | None = None
        """Index of the variable in which polynomials are cut off, in a series."""
        self.turn: tuple[int, int] | None = None
        """Index and order of the root of unity, if there is one."""

    def sum(self, left: Fractional, right: Fractional) -> Fractional:
        """Over a common divisor; in a series nothing that vanishes with the variable is shared,
        since dividing by it would lose orders of the cut-off polynomials."""
        if left.den == right.den:
            return Fractional(left.num + right.num, left.den)
        if left.den.is_one():
            left, right = right, left
        if right.den.is_one():
            spend(len(right.num) * len(left.den))
            return Fractional(left.num + right.num * left.den, left.den)
        spend(len(left.den) * len(right.den))
        common = self.gcd(left.den, right.den)
        if self.small is not None and any(m[self.small] for m in common.to_dict()):
            common = self.one
        ours, theirs = right.den / common, left.den / common
        spend(len(left.num) * len(ours) + len(right.num) * len(theirs) + len(left.den) * len(ours))
        return Fractional(left.num * ours + right.num * theirs, left.den * ours)

    def gcd(self, one: fmpq_mpoly, other: fmpq_mpoly) -> fmpq_mpoly:
        """The largest common divisor; of more than single terms it may have one for each power."""
        if min(len(one), len(other)) > 1:
            spend(max(*one.degrees(), *other.degrees()))
        return one.gcd(other)

    def constant(self, value: sp.Rational) -> Fractional:
        """A rational number as an element."""
        return Fractional(self.ctx.constant(fraction(value)), self.one)

    def polynomial(self, terms: Iterable[Expr]) -> tuple[fmpq_mpoly, list[Expr]]:
        """The sum of those that are a number times powers of generators, and the other terms."""
        found: dict[tuple[int, ...], fmpq] = {}
        others = []
        for term in terms:
            powers, coefficient, rest = self.monomial(term.args if term.is_Mul else (term,))
            if rest:
                others.append(term)
            else:
                found[powers] = found[powers] + coefficient if powers in found else coefficient
        spend(len(found))
        return self.ctx.from_dict(found), others

    def monomial(self, factors: Iterable[Expr]) -> tuple[tuple[int, ...], fmpq, list[Expr]]:
        """The product of those that are numbers and powers of generators, and the other factors."""
        powers = [0] * max(1, len(self.names))
        coefficient, others = _ONE, []
        for part in factors:
            if part.is_Rational:
                coefficient *= fraction(part)
                continue
            base, power = part, 1
            if part.is_Pow and part.args[1].is_Integer and part.args[1].p > 0:
                base, power = part.args[0], int(part.args[1].p)
            index = None if base.is_Add or base.is_Mul else self._index.get(base)
            if index is None:
                others.append(part)
            else:
                powers[index] += power
        return tuple(powers), coefficient, others

    def relate(self, name: Expr, coefficients: dict[int, fmpq_mpoly]) -> None:
        """Impose sum of coefficient times name**power = 0."""
        index = self.names.index(name)
        self.relations.append((index, coefficients))
        monic = coefficients[max(coefficients)] == self.one
        if monic and all(c.is_constant() for c in coefficients.values()):
            places = range(max(1, len(self.names)))
            terms = {p: tuple(p * (i == index) for i in places) for p in coefficients}
            numbers = {p: c.leading_coefficient() for p, c in coefficients.items()}
            self.moduli[index] = self.ctx.from_dict({terms[p]: c for p, c in numbers.items()})
            if len(numbers) == 2 and 0 in numbers:
                self.folds[index] = max(numbers), -numbers[0]

    def reduce(self, poly: fmpq_mpoly) -> fmpq_mpoly:
        """The polynomial modulo all relations, up to a factor that is not zero."""
        for index, relation in reversed(self.relations):
            degree = max(relation)
            main = self.gen[self.names[index]]
            if index in self.moduli:
                poly = self._remainder(poly, index)
                continue
            while True:
                parts = self.by_power(poly, index)
                top = max(parts, default=0)
                if top < degree:
                    break
                rest = sum(
                    (c * main ** (p + top - degree) for p, c in relation.items() if p < degree),
                    self.ctx.constant(0),
                )
                spend(50 + 10 * len(poly) * len(relation[degree]) + len(parts[top]) * len(rest))
                lower = poly - parts[top] * main**top
                poly = relation[degree] * lower - parts[top] * rest
        return poly

    def _remainder(self, poly: fmpq_mpoly, index: int) -> fmpq_mpoly:
        """The polynomial modulo a monic relation; each term is divided once for each power."""
        modulus = self.moduli[index]
        if index in self.folds:
            poly = self._folded(poly, index, *self.folds[index])
        powers = poly.degrees()[index] - modulus.degrees()[index] + 1
        if powers < 1:
            return poly
        spend(len(poly) * (len(modulus) + powers))
        return poly % modulus

    def _folded(self, poly: fmpq_mpoly, index: int, degree: int, number: fmpq) -> fmpq_mpoly:
        """With a number for a power of a generator, wherever that is a factor of a term."""
        times = poly.degrees()[index] // degree
        if times < 1:
            return poly
        spend(len(poly) * (1 + times * number.height_bits() // _DIGIT))
        if times <= _FEW:
            return poly % (self.gen[self.names[index]] ** degree - number)
        found: dict[tuple[int, ...], fmpq] = {}
        for monomial, value in poly.to_dict().items():
            turns, left = divmod(int(monomial[index]), degree)
            rest = (*monomial[:index], left, *monomial[index + 1 :])
            found[rest] = found.get(rest, _ZERO) + value * number**turns
        return self.ctx.from_dict(found)

    def shortened(self, quotient: Fractional) -> Fractional:
        """An equal quotient, of remainders modulo the monic relations where its divisor has one."""
        num, den = quotient.num, quotient.den
        for index in reversed(self.moduli):
            num, den = self._remainder(num, index), self._remainder(den, index)
        return quotient if den.is_zero() else Fractional(num, den)

    def by_power(self, poly: fmpq_mpoly, index: int) -> dict[int, fmpq_mpoly]:
        """The coefficients of the powers of one generator."""
        split: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for monomial, value in poly.to_dict().items():
            rest = (*monomial[:index], 0, *monomial[index + 1 :])
            split.setdefault(int(monomial[index]), {})[rest] = value
        return {power: self.ctx.from_dict(part) for power, part in split.items()}

    # -- zero divisors ------------------------------------------------------------------

    def invertible(self, poly: fmpq_mpoly) -> bool:
        """Whether a reduced polynomial is shown to have an inverse modulo the relations.

        A relation such as w^2 = x^2 has a reducible polynomial: w - x is not zero, and
        (w - x)(w + x) is.  A polynomial has an inverse if its norm is not zero.  The norm is
        computed modulo a prime, with numbers for the generators without a relation: what is not
        zero there is not zero.  False where there are too many roots for that.
        """
        roots = [(i, r) for i, r in self.relations if self.turn is None or i != self.turn[0]]
        used, left = set[int](), [poly]
        for part in left:
            new = {i for i, _ in roots if part.degrees()[i] > 0} - used
            used |= new
            left += (c for i, relation in roots if i in new for c in relation.values())
        relations = [(i, relation) for i, relation in roots if i in used]
        if poly.is_zero() or not relations:
            return not poly.is_zero()
        if prod(max(relation) for _, relation in relations) > _LARGEST:
            return False
        divisors = [poly, *(relation[max(relation)] for _, relation in relations)]
        try:
            return any(
                all(self._norm(d, relations, random.Random(seed)) for d in divisors)
                for seed in range(2)
            )
        except ValueError:  # a denominator is zero modulo the prime
            return False

    def _norm(
        self,
        poly: fmpq_mpoly,
        relations: list[tuple[int, dict[int, fmpq_mpoly]]],
        dice: random.Random,
    ) -> bool:
        """Whether the norm over the roots is not zero for some numbers."""
        prime, turn = _prime(self.turn[1] if self.turn else 1)
        numbers = [dice.randrange(2, prime) for _ in self.names]
        if self.turn:
            numbers[self.turn[0]] = turn
        place = {i: k for k, (i, _) in enumerate(relations)}
        roots = nmod_mpoly_ctx.get(("w", len(relations)), modulus=prime, ordering="lex")

        def at(poly: fmpq_mpoly) -> nmod_mpoly:
            found: dict[tuple[int, ...], int] = {}
            for monomial, value in poly.to_dict().items():
                number, powers = int(value.p) * pow(int(value.q), -1, prime), [0] * len(place)
                for i, n in enumerate(monomial):
                    if i in place:
                        powers[place[i]] = int(n)
                    elif n:
                        number = number * pow(numbers[i], int(n), prime) % prime
                found[tuple(powers)] = (found.get(tuple(powers), 0) + number) % prime
            return roots.from_dict(found)

        norm = at(poly)
        for i, relation in reversed(relations):
            spend(_DIGIT * (1 + len(norm)))
            root = roots.gen(place[i])
            modulus = sum((at(c) * root**n for n, c in relation.items()), roots.constant(0))
            norm = modulus.resultant(norm, place[i])
        return not norm.is_zero()


_LARGEST = 64
"""Zero divisors are looked for in extensions up to this degree."""


@cache
def _prime(order: int) -> tuple[int, int]:
    """A prime number of 62 bits, and a root of unity of this order modulo it."""
    prime = 2**61 // order * order + 1
    while not sp.isprime(prime):
        prime += order
    for base in range(2, prime):
        root = pow(base, (prime - 1) // order, prime)
        if all(pow(root, order // factor, prime) != 1 for factor in sp.primefactors(order)):
            return prime, root
    raise AssertionError("a prime number has primitive roots")
