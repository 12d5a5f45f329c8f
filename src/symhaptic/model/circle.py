"""Laurent polynomials in z on the unit circle, where 1/z is the conjugate of z."""

from __future__ import annotations

import sympy as sp
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
    try:
        terms = sp.ring(names, sp.QQ)[0].from_expr(moved).as_expr()
    except ValueError:  # with other numbers than rational ones
        return sp.expand(expr)
    return terms.xreplace({_BACK: 1 / z})


def powers(expr: Expr) -> dict[int, Expr]:
    """The coefficients of a Laurent polynomial, by power of z."""
    found: dict[int, Expr] = {}
    for term in sp.Add.make_args(expanded(expr)):
        coefficient, rest = term.as_independent(z)
        power = int(rest.as_base_exp()[1]) if rest != 1 else 0
        found[power] = found.get(power, sp.S.Zero) + coefficient
    return found


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
