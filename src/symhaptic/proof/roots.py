"""Roots enclosed by balls, and algebraic numbers with their minimal polynomials.

A root of a polynomial lies in a ball that flint certifies, the zero of any other function in one
that a step of Newton's interval method does.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from flint import arb, arb_poly, ctx, fmpq, fmpq_mat, fmpq_poly, fmpz_poly
from sympy import Expr

from symhaptic.proof.ball import At, ball

BITS = 256
"""Precision of the balls that are found here."""


class NoSuchRoot(ValueError):
    """A root that is not where it should be, or that is not the only one there."""


@dataclass(frozen=True)
class Algebraic:
    """A real algebraic number."""

    minimal: Expr
    """Its minimal polynomial over the rationals, primitive over the integers."""
    ball: arb
    positive_roots_below: int
    """How many positive roots of the minimal polynomial are smaller."""


def rational_polynomial(expr: Expr) -> fmpq_poly:
    """An expression in at most one symbol as a polynomial over the rationals.

    >>> x = sp.Symbol("x")
    >>> print(rational_polynomial((x - 1)*(x + sp.Rational(1, 2))))
    x^2 + (-1/2)*x + (-1/2)
    """
    symbols = sorted(expr.free_symbols, key=str) or [sp.Dummy()]
    coefficients = sp.Poly(expr, *symbols, domain=sp.QQ).all_coeffs()
    return fmpq_poly([fmpq(int(c.p), int(c.q)) for c in reversed(coefficients)])


def root_between(polynomial: Expr, lower: Expr, upper: Expr) -> arb:
    """A ball around the only real root of a rational polynomial between two real numbers.

    Raises :class:`NoSuchRoot` where there is none, several, or one too close to an end.

    >>> x = sp.Symbol("x")
    >>> print(root_between(x**2 - 2, sp.S.Zero, sp.pi).str(20))
    [1.4142135623730950488 +/- 1.69e-21]
    """
    with ctx.workprec(BITS):
        ends = ball(lower, bits=BITS).real, ball(upper, bits=BITS).real
        found = []
        for root, count in rational_polynomial(polynomial).complex_roots():
            if not root.imag.is_zero():  # flint isolates real roots as real balls
                continue
            if root.real > ends[0] and root.real < ends[1]:
                found += [root.real] * count
            elif not (root.real < ends[0] or root.real > ends[1]):
                raise NoSuchRoot(f"a root of {polynomial} at an end of the interval")
    if len(found) != 1:
        raise NoSuchRoot(f"{len(found)} roots of {polynomial} between {lower} and {upper}")
    return found[0]


def zero_between(
    expr: Expr, variable: sp.Symbol, lower: Expr, upper: Expr, at: At | None = None
) -> arb:
    """A ball around the only zero of a function between two numbers, by Newton's interval step.

    A step that ends inside the interval it started from proves that there is one zero in it, for
    any values of further symbols in the balls given by ``at``.
    Raises :class:`NoSuchRoot` where the first step does not.

    >>> x = sp.Symbol("x")
    >>> print(zero_between(sp.cos(x), x, sp.S.One, sp.Integer(2)).str(20))
    [1.5707963267948966192 +/- 3.14e-20]
    """
    slope, known = sp.diff(expr, variable), dict(at or {})

    def newton(wide: arb) -> arb:
        middle = wide.mid()
        value = ball(expr, {**known, variable: middle}, BITS)
        rises = ball(slope, {**known, variable: wide}, BITS)
        return middle - value.real / rises.real

    with ctx.workprec(BITS):
        wide = ball(lower, bits=BITS).real.union(ball(upper, bits=BITS).real)
        narrow = newton(wide)
        if not wide.contains_interior(narrow):
            raise NoSuchRoot(f"no zero of {expr} is shown between {lower} and {upper}")
        while narrow.rad() < wide.rad():
            wide, narrow = narrow, newton(narrow)
    return wide


def algebraic(
    value: Expr, modulus: Expr, variable: sp.Symbol, name: sp.Symbol, lower: Expr, upper: Expr
) -> Algebraic:
    """The value of a rational function at the only root of ``modulus`` between two numbers.

    Multiplication by the value, in the rationals with a root of the modulus adjoined, is a
    linear map; its characteristic polynomial has the value as a root, and is the minimal one
    if it is irreducible.  Raises :class:`NoSuchRoot` where it is not, or the root is not unique.

    >>> x, y = sp.symbols("x y")
    >>> algebraic(1/(1 + x), x**2 - 2, x, y, sp.S.Zero, sp.S(2)).minimal
    y**2 + 2*y - 1
    """
    root = root_between(modulus, lower, upper)
    polynomial = _characteristic(value, rational_polynomial(modulus))
    if [count for _, count in polynomial.factor()[1]] != [1]:
        raise NoSuchRoot(f"{value} has a minimal polynomial of lower degree")
    minimal = sum(int(c) * name**k for k, c in enumerate(polynomial.coeffs()))
    with ctx.workprec(BITS):
        top, bottom = (arb_poly(p)(root) for p in _parts(value))
        enclosed = top / bottom
        roots = [r.real for r, _ in polynomial.complex_roots() if r.imag.is_zero()]
    if sum(r.overlaps(enclosed) for r in roots) != 1:
        raise NoSuchRoot(f"which root of {minimal} is meant is not decided")
    below = sum(bool(r > 0 and r < enclosed) for r in roots)
    return Algebraic(sp.sympify(minimal), enclosed, below)


def _parts(value: Expr) -> tuple[fmpq_poly, fmpq_poly]:
    """Numerator and denominator."""
    top, bottom = sp.fraction(sp.together(value))
    return rational_polynomial(top), rational_polynomial(bottom)


def _characteristic(value: Expr, modulus: fmpq_poly) -> fmpz_poly:
    """Characteristic polynomial of the multiplication by ``value`` modulo a polynomial."""
    top, bottom = _parts(value)
    shared, inverse, _ = bottom.xgcd(modulus)
    if shared.degree() != 0:
        raise NoSuchRoot(f"the denominator of {value} vanishes at a root of the modulus")
    size = modulus.degree()
    column, matrix = top * inverse % modulus, fmpq_mat(size, size)
    for j in range(size):
        for i in range(size):
            matrix[i, j] = column[i]
        column = column * fmpq_poly([0, 1]) % modulus
    integral = matrix.charpoly().numer()
    return integral / integral.content()


def decimals(value: arb, places: int = 24) -> str:
    """The first decimals of a positive number that a ball encloses, cut off, not rounded.

    Raises :class:`NoSuchRoot` where the ball is too wide to know them.

    >>> with ctx.workprec(128):
    ...     decimals(arb(2).sqrt(), 10)
    '1.4142135623'
    """
    with ctx.workprec(BITS):
        digits = (value * arb(10) ** places).floor().unique_fmpz()
    if digits is None or digits < 0:
        raise NoSuchRoot(f"{value} is not known to {places} places")
    text = str(digits).rjust(places + 1, "0")
    return f"{text[:-places]}.{text[-places:]}"
