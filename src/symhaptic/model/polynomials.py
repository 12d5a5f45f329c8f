"""Polynomials with integer coefficients: the minors of a matrix of them, and how one is written.

The wall's alpha and beta come first among the symbols, so that a factor is a short polynomial in
them whose coefficients are factored themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import gcd, lcm
from typing import Any

import sympy as sp
from flint import fmpz_mpoly, fmpz_mpoly_ctx
from sympy import Expr, Symbol

from symhaptic.notation import alpha, beta


def integers(coefficients: Sequence[Expr]) -> tuple[tuple[Symbol, ...], list[fmpz_mpoly]]:
    """Symbols and coefficients over the integers, the lowest power first."""
    given = [sp.sympify(c) for c in coefficients]
    if len(given) < 2:
        raise ValueError(f"coefficients: {given}; give a degree of 1 or more")
    lead = given[0]
    if not (lead.is_Rational and lead > 0):
        raise ValueError(f"coefficients: {lead} leads; give a positive rational number")
    free = {s for c in given for s in c.free_symbols}
    symbols = tuple(sorted(free, key=lambda s: (s not in (alpha, beta), str(s))))
    names = symbols or (sp.Dummy(),)
    polynomials = [_terms(c, names) for c in given]
    common = lcm(*(int(n.q) for p in polynomials for n in p.values()))
    ring = fmpz_mpoly_ctx.get([f"g{i}" for i in range(len(names))], "lex")
    rising = [
        ring.from_dict({m: int(n * common) for m, n in p.items() if n}) for p in polynomials[::-1]
    ]
    return symbols, rising


def _terms(coefficient: Expr, names: tuple[Symbol, ...]) -> dict[tuple[int, ...], Expr]:
    """The number of each monomial."""
    if coefficient.is_Rational:
        return {(0,) * len(names): coefficient}
    if not coefficient.is_polynomial(*names):
        raise ValueError(
            f"coefficients: {coefficient} is no polynomial; put its number in afterwards"
        )
    polynomial = sp.Poly(coefficient, *names)
    if not polynomial.domain.is_QQ and not polynomial.domain.is_ZZ:
        raise ValueError(f"coefficients: {coefficient} has a number that is not rational")
    return dict(polynomial.terms())


def minors(rows: list[list[fmpz_mpoly]]) -> list[fmpz_mpoly]:
    """Leading minors, by elimination without fractions.

    After a minor that is zero identically no further one matters: it is never positive.
    """
    found: list[fmpz_mpoly] = []
    before: Any = 1
    while rows:
        pivot = rows[0][0]
        found.append(pivot)
        if pivot.is_zero():
            break
        first, *others = rows
        rows = [
            [(pivot * row[j] - row[0] * first[j]) / before for j in range(1, len(row))]
            for row in others
        ]
        before = pivot
    return found


def primitive(polynomial: fmpz_mpoly) -> fmpz_mpoly:
    """Without the greatest common divisor of its coefficients."""
    content = gcd(*(int(c) for c in polynomial.coeffs()))
    return polynomial / content if content else polynomial


def factored(polynomial: fmpz_mpoly, symbols: tuple[Symbol, ...]) -> Expr:
    """As a product of irreducible factors, of which an odd power keeps no minus in front."""
    number, factors = polynomial.factor()
    written = [(_collected(f, symbols), int(k)) for f, k in factors]
    if number == -1 and factors and factors[0][1] % 2:
        number, written[0] = 1, (_collected(-factors[0][0], symbols), int(factors[0][1]))
    return int(number) * sp.Mul(*(f**k for f, k in written))


def _collected(polynomial: fmpz_mpoly, symbols: tuple[Symbol, ...]) -> Expr:
    """Powers of alpha and beta with factored coefficients, so that no sum is very long."""
    walls = sum(symbol in (alpha, beta) for symbol in symbols)
    if not 0 < walls < len(symbols):
        return _expanded(polynomial, symbols)
    parts: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
    for monomial, value in polynomial.to_dict().items():
        parts.setdefault(monomial[:walls], {})[(0,) * walls + monomial[walls:]] = value
    terms = []
    for powers, part in parts.items():
        number, factors = polynomial.context().from_dict(part).factor()
        coefficient = sp.Mul(*(_expanded(f, symbols) ** int(k) for f, k in factors))
        wall = _monomial(symbols, tuple(map(int, powers)))
        terms.append(int(number) * coefficient * wall)
    return sp.Add(*terms)


def _expanded(polynomial: fmpz_mpoly, symbols: tuple[Symbol, ...]) -> Expr:
    terms = polynomial.to_dict().items()
    return sp.Add(*(int(c) * _monomial(symbols, tuple(map(int, m))) for m, c in terms))


@lru_cache(maxsize=4096)
def _monomial(symbols: tuple[Symbol, ...], powers: tuple[int, ...]) -> Expr:
    return sp.Mul(*(s**k for s, k in zip(symbols, powers, strict=False) if k))
