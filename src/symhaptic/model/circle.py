"""Laurent polynomials in z on the unit circle, where 1/z is the conjugate of z."""

from __future__ import annotations

from functools import reduce
from operator import add, mul

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Expr

from symhaptic.notation import z

MIRRORED = {z: 1 / z}
"""The conjugate, for expressions whose other symbols are real."""

_BACK = sp.Dummy("1/z")


def expanded(expr: Expr) -> Expr:
    """The sum of the terms of a polynomial, or a Laurent polynomial in z, faster than by SymPy.

    >>> a = sp.Symbol("a")
    >>> expanded((z + a / z) ** 2)
    a**2/z**2 + 2*a + z**2
    """
    back = {
        p: _BACK**-p.exp
        for p in expr.atoms(sp.Pow)
        if p.base == z and p.exp.is_Integer and p.exp < 0
    }
    moved = expr.xreplace(back)
    names = sorted(moved.free_symbols | {z}, key=str)
    context = fmpq_mpoly_ctx.get([f"g{i}" for i in range(len(names))], "lex")
    try:
        found = _polynomial(moved, context, dict(zip(names, context.gens(), strict=True)))
    except ValueError:  # with other numbers than rational ones
        return sp.expand(expr)
    symbols = [1 / z if name == _BACK else name for name in names]
    terms = []
    for exponents, c in found.to_dict().items():
        factors = (s ** int(n) for s, n in zip(symbols, exponents, strict=True) if n)
        terms.append(sp.Mul(sp.Rational(int(c.p), int(c.q)), *factors))
    return sp.Add(*terms)


def _polynomial(expr: Expr, context: fmpq_mpoly_ctx, names: dict[Expr, fmpq_mpoly]) -> fmpq_mpoly:
    """A polynomial with rational coefficients in these names."""
    if expr in names:
        return names[expr]
    if expr.is_Rational:
        return context.constant(fmpq(int(expr.p), int(expr.q)))
    if expr.is_Add or expr.is_Mul:
        parts = (_polynomial(part, context, names) for part in expr.args)
        return reduce(add if expr.is_Add else mul, parts)
    if expr.is_Pow and expr.exp.is_Integer and expr.exp > 0:
        return _polynomial(expr.base, context, names) ** int(expr.exp)
    raise ValueError(f"{expr} is no polynomial with rational coefficients")


def powers(expr: Expr, of: sp.Symbol = z) -> dict[int, Expr]:
    """The coefficients of a Laurent polynomial in z, or a polynomial, by power of a symbol."""
    found: dict[int, list[Expr]] = {}
    for term in sp.Add.make_args(expanded(expr)):
        coefficient, rest = term.as_independent(of)
        power = int(rest.as_base_exp()[1]) if rest != 1 else 0
        found.setdefault(power, []).append(coefficient)
    return {power: sp.Add(*parts) for power, parts in found.items()}


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
