"""Laurent polynomials in z on the unit circle, where 1/z is the conjugate of z."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cmp_to_key, reduce
from operator import add, mul
from typing import TypeAlias

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Basic, Expr

from symhaptic.notation import z
from symhaptic.notation.exact import fraction, rational

MIRRORED = {z: 1 / z}
"""The conjugate, for expressions whose other symbols are real."""

Monomial: TypeAlias = tuple[tuple[Expr, int], ...]
"""Symbols with their powers, none of which is zero."""


def expanded(expr: Expr) -> Expr:
    """The sum of the terms of a Laurent polynomial, faster than by SymPy.

    >>> a = sp.Symbol("a")
    >>> expanded((z + a / z) ** 2)
    a**2/z**2 + 2*a + z**2
    """
    try:
        return _sum(_terms(expr))
    except ValueError:  # with other numbers than rational ones
        return sp.expand(expr)


def powers(expr: Expr, of: sp.Symbol = z) -> dict[int, Expr]:
    """The coefficients of a Laurent polynomial by power of a symbol."""
    try:
        terms = _terms(expr)
    except ValueError:
        return _powers_of_sum(sp.expand(expr), of)
    found: dict[int, dict[Monomial, fmpq]] = {}
    for monomial, c in terms.items():
        rest = tuple((s, n) for s, n in monomial if s != of)
        found.setdefault(dict(monomial).get(of, 0), {})[rest] = c
    return {power: _sum(part) for power, part in found.items()} or {0: sp.S.Zero}


def quotient(expr: Expr, by: Expr) -> Expr:
    """A polynomial over one that divides it, expanded.

    >>> a = sp.Symbol("a")
    >>> quotient(z**2 - a**2, z + a)
    -a + z
    """
    names = sorted(expr.free_symbols | by.free_symbols, key=str)
    context = fmpq_mpoly_ctx.get([f"g{i}" for i in range(len(names))], "lex")
    known = dict(zip(names, context.gens(), strict=True))
    whole, share = (_polynomial(part, context, known) for part in (expr, by))
    found, rest = divmod(whole, share)
    if not rest.is_zero():
        raise ValueError(f"{by} does not divide {expr}")
    return _sum({_monomial(names, exponents): c for exponents, c in found.to_dict().items()})


def _powers_of_sum(expr: Expr, of: sp.Symbol) -> dict[int, Expr]:
    """The same of a sum of terms that is written as one."""
    found: dict[int, list[Expr]] = {}
    for term in sp.Add.make_args(expr):
        coefficient, rest = term.as_independent(of)
        power = int(rest.as_base_exp()[1]) if rest != 1 else 0
        found.setdefault(power, []).append(coefficient)
    return {power: sp.Add(*parts) for power, parts in found.items()}


def _terms(expr: Expr) -> dict[Monomial, fmpq]:
    """The terms that a Laurent polynomial is the sum of."""
    below = [p for p in expr.atoms(sp.Pow) if p.base.is_Symbol and p.exp.is_Integer and p.exp.p < 0]
    inverse = {p.base: sp.Dummy("1/") for p in below}
    moved = expr.xreplace({p: inverse[p.base] ** -p.exp for p in below})
    names = sorted(moved.free_symbols | inverse.keys() | {z}, key=str)
    context = fmpq_mpoly_ctx.get([f"g{i}" for i in range(len(names))], "lex")
    polynomial = _polynomial(moved, context, dict(zip(names, context.gens(), strict=True)))
    terms: dict[Monomial, fmpq] = {}
    for exponents, c in polynomial.to_dict().items():
        factors = dict(zip(names, exponents, strict=True))
        for symbol, inverted in inverse.items():
            factors[symbol] -= factors.pop(inverted, 0)
        monomial = _monomial(factors.keys(), factors.values())
        terms[monomial] = terms.get(monomial, 0) + c
    return {monomial: c for monomial, c in terms.items() if c != 0}


def _monomial(symbols: Iterable[Expr], exponents: Iterable[int]) -> Monomial:
    return tuple((s, int(n)) for s, n in zip(symbols, exponents, strict=True) if n)


def _sum(terms: Mapping[Monomial, fmpq]) -> Expr:
    """A sum of numbers times powers of symbols, each in the order in which SymPy has it.

    Nothing is left in it that SymPy could combine, and it is not asked to look for that.
    """
    powers = {(s, n): s**n for monomial in terms for s, n in monomial}
    ordered = sorted(powers.items(), key=lambda item: _ORDER(item[1]))
    rank = {factor: i for i, (factor, _) in enumerate(ordered)}
    found = []
    for monomial, c in terms.items():
        factors = [powers[factor] for factor in sorted(monomial, key=rank.__getitem__)]
        if c != 1 or not factors:
            factors.insert(0, rational(c))
        found.append(sp.Mul(*factors, evaluate=False))
    return sp.Add(*sorted(found, key=_ORDER), evaluate=False)


_ORDER = cmp_to_key(Basic.compare)


def _polynomial(expr: Expr, context: fmpq_mpoly_ctx, names: dict[Expr, fmpq_mpoly]) -> fmpq_mpoly:
    """A polynomial with rational coefficients in these names."""
    if expr in names:
        return names[expr]
    if expr.is_Rational:
        return context.constant(fraction(expr))
    if expr.is_Add or expr.is_Mul:
        parts = (_polynomial(part, context, names) for part in expr.args)
        return reduce(add if expr.is_Add else mul, parts)
    if expr.is_Pow and expr.exp.is_Integer and expr.exp.p > 0:
        return _polynomial(expr.base, context, names) ** int(expr.exp.p)
    raise ValueError(f"{expr} is no polynomial with rational coefficients")


def square(expr: Expr) -> Expr:
    """|expr|^2.

    >>> a = sp.Symbol("a")
    >>> square(z + a)
    a**2 + a*z + a/z + 1
    """
    return expanded(expr * expr.xreplace(MIRRORED))


def real(expr: Expr) -> Expr:
    """The real part."""
    return expanded((expr + expr.xreplace(MIRRORED)) / 2)


def height(expr: Expr) -> Expr:
    """The imaginary part over sin theta, that is (expr - its conjugate)/(z - 1/z).

    >>> height(z**2)
    z + 1/z
    """
    total = sp.S.Zero
    for power, coefficient in powers(expr).items():
        size = abs(power)
        chain = sum((z ** (size - 1 - 2 * k) for k in range(size)), sp.S.Zero)
        total += sp.sign(power) * coefficient * chain
    return expanded(total)


def in_chord(expr: Expr, y: sp.Symbol) -> Expr:
    """A Laurent polynomial with expr(z) = expr(1/z) as a polynomial in y = 2 - z - 1/z.

    y is the square of the distance from 1, 4 sin(theta/2)^2.

    >>> in_chord(z**2 + 1/z**2, sp.Symbol("y"))
    y**2 - 4*y + 2
    """
    total = sp.S.Zero
    for power, coefficient in powers(expr).items():
        total += coefficient * sp.chebyshevt_poly(abs(power), 1 - y / 2)
    return expanded(total)
