"""Balls that contain the value of an expression, from python-flint's complex arithmetic.

A ball can show that two numbers differ, or in which order they lie; it never shows that they
are equal.  That is left to :mod:`symhaptic.proof.normal`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from decimal import Decimal
from fractions import Fraction
from math import ceil, floor
from typing import TypeAlias

import sympy as sp
from flint import acb, acb_poly, arb, ctx
from sympy import Expr

from symhaptic.notation.exact import fraction, from_leading
from symhaptic.notation.fresh import fresh
from symhaptic.notation.terms import symbols_in
from symhaptic.proof.normal import Field, is_zero
from symhaptic.proof.program import CALLS, raised
from symhaptic.proof.rewriting import Unsupported, conjugated

PRECISIONS = (64, 256, 1024)
"""Bits tried one after the other until a question is decided."""

NARROW = 1e-30
"""The width of a root's ball next to the circle."""

_CONSTANTS: dict[type, Callable[[], acb]] = {
    type(sp.I): lambda: acb(0, 1),
    type(sp.pi): lambda: acb(arb.pi()),
    type(sp.E): lambda: acb(1).exp(),
}

At: TypeAlias = Mapping[Expr, Expr | acb | arb]
"""Values of symbols: exact numbers, or balls that contain them."""


def ball(expr: Expr, at: At | None = None, bits: int = 64) -> acb:
    """A ball that contains the value of ``expr`` where its symbols have the values ``at``.

    Raises :class:`Unsupported` for a function that it does not know.  A ball that is not
    finite says that the expression is undefined or that the precision is too low.

    >>> print(ball(sp.sqrt(2) - 1).real.str(15))
    [0.414213562373095 +/- 4.89e-17]
    """
    before = ctx.prec
    ctx.prec = bits
    try:
        return _ball(sp.sympify(expr, strict=True), dict(at or {}))
    finally:
        ctx.prec = before


def _ball(expr: Expr, at: dict[Expr, Expr | acb | arb]) -> acb:
    """The same; what ``at`` does not have yet, it has afterwards, so that no part is met twice."""
    if expr.is_Rational:
        return acb(fraction(expr))
    value = at.get(expr)
    if value is None:
        value = _found(expr, at)
    elif not isinstance(value, acb):
        value = acb(value) if isinstance(value, arb) else _ball(sp.sympify(value, strict=True), {})
    else:
        return value
    at[expr] = value
    return value


def _found(expr: Expr, at: dict[Expr, Expr | acb | arb]) -> acb:
    kind = type(expr)
    if kind is sp.Pow:
        base, power = expr.args
        if power.is_Integer:
            found = _ball(base, at)
            return found ** int(power) if power else 0 * found + 1  # of nothing it is nothing
        if power == sp.S.Half:
            return _ball(base, at).sqrt()
        return raised(_ball(base, at), _ball(power, at))
    args = [_ball(a, at) for a in expr.args]
    if kind is sp.Add:
        return sum(args[1:], args[0])
    if kind is sp.Mul:
        product = args[0]
        for factor in args[1:]:
            product *= factor
        return product
    if kind in CALLS and len(args) == 1:
        found = CALLS[kind](args[0])
        assert isinstance(found, acb)
        return found
    if kind in _CONSTANTS:
        return _CONSTANTS[kind]()
    raise Unsupported(f"no ball for {kind.__name__}: {expr}")


def largest_root(polynomial: Expr, keep: Callable[[acb], bool] = lambda root: True) -> arb:
    """A ball that contains the largest modulus of the roots of a polynomial in one symbol.

    Of its roots only those are looked at whose ball is one to ``keep``.  Its coefficients are
    numbers; python-flint isolates the roots of every polynomial whose coefficients lie in their
    balls.  Raises :class:`Unsupported` where roots are too close to be told apart.

    >>> z = sp.Symbol("z")
    >>> bool(largest_root(z**2 - sp.exp(-2)) < 0.37)
    True
    """
    variable, named = set(polynomial.free_symbols), dict[Expr, Expr]()
    coefficients = sp.Poly(_by_name(polynomial, variable, named), *variable).all_coeffs()
    if coefficients == [0]:
        raise Unsupported(f"{polynomial} is zero, and every number a root of it")
    if not named and all(c.is_Rational for c in coefficients):
        exact = from_leading(coefficients)
        return _largest([abs(root) for root, _ in exact.complex_roots() if keep(root)])
    before, found = ctx.prec, None
    for bits in PRECISIONS:
        ctx.prec = bits
        try:
            values: dict[Expr, Expr | acb | arb] = {n: _ball(v, {}) for v, n in named.items()}
            balls = [_ball(c, values) for c in reversed(coefficients)]
            # SymPy may have cancelled a constant that has no value
            if balls[-1].contains(0) or not all(_ball(v, values).is_finite() for v in named):
                continue
            isolated = acb_poly(balls)
            # next to the circle isolated roots are not told from it, narrow ones are
            roots = isolated.roots(tol=NARROW) if found is not None else isolated.complex_roots()
            found = _largest([abs(root) for root in roots if keep(root)])
            if not found.contains(1):
                return found
        except ValueError:  # not isolated at this precision
            continue
        finally:
            ctx.prec = before
    if found is None:
        raise Unsupported(f"roots not isolated: {polynomial}")
    return found


def zeros_inside(polynomial: Expr, variable: sp.Symbol) -> bool:
    """Whether all zeros of a polynomial with numbers for coefficients are shown to lie in |z| < 1.

    By Schur's reduction: they do if and only if |c| < 1, c = p(0)/conj p_n, and those of the
    polynomial (p - c p*)/z do, p* = z^n conj p(1/conj z), which has one zero less.

    >>> z = sp.Symbol("z")
    >>> zeros_inside(2*z**2 - z + 1, z), zeros_inside(z**2 - z + 1, z)
    (True, False)
    """
    most = 4 * PRECISIONS[-1]
    for bits in (*PRECISIONS, most):
        with ctx.workprec(bits):
            rising = _in_balls(polynomial, variable, {}).coeffs()
            enough = bits == most or 2 * len(rising) <= bits  # each step loses some
            if rising and enough and _reduced_inside(rising):
                return True
    return False


def _in_balls(expr: Expr, variable: sp.Symbol, at: dict[Expr, Expr | acb | arb]) -> acb_poly:
    """A polynomial with balls for coefficients; a leading one that contains 0 decides nothing."""
    if expr == variable:
        return acb_poly([0, 1])
    if variable not in symbols_in(expr):
        return acb_poly([_ball(expr, at)])
    if expr.is_Pow and expr.args[1].is_Integer and expr.args[1] > 0:
        return _in_balls(expr.args[0], variable, at) ** int(expr.args[1])
    if not (expr.is_Add or expr.is_Mul):
        raise Unsupported(f"{expr} is no polynomial in {variable}")
    first, *more = (_in_balls(part, variable, at) for part in expr.args)
    for part in more:
        first = first + part if expr.is_Add else first * part
    return first


def _reduced_inside(rising: list[acb] | list[arb]) -> bool:
    """Schur's reduction in balls, down to a constant, which is not zero: all is a zero of 0."""
    if all(c.imag.is_zero() for c in rising):
        rising = [c.real for c in rising]
    while len(rising) > 1:
        mirrored = [c.conjugate() if isinstance(c, acb) else c for c in reversed(rising)]
        share = rising[0] / mirrored[0]
        if not abs(share) < 1:
            return False
        rising = [p - share * q for p, q in zip(rising[1:], mirrored[1:], strict=True)]
    return not rising[0].contains(0)


def _by_name(expr: Expr, variable: set[Expr], named: dict[Expr, Expr]) -> Expr:
    """A polynomial with a name for each of its constants, so that none of them is expanded."""
    if expr.is_Rational or expr in variable:
        return expr
    if symbols_in(expr).isdisjoint(variable):
        return named.setdefault(expr, fresh(variable))
    return expr.func(*(_by_name(part, variable, named) for part in expr.args))


def _largest(sizes: list[arb]) -> arb:
    largest = arb(0)
    for size in sizes:
        largest = largest.max(size)
    return largest


def bound(number: arb, above: bool) -> str:
    """A decimal not below (or not above) a ball, of four places or as many as tell it from 1.

    >>> bound(1 - arb(2)**-15, above=True), bound(1 + arb(2)**-3, above=False)
    ('0.99996949', '1.1250')
    """
    mantissa, exponent = (number.upper() if above else number.lower()).man_exp()
    exact = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    for places in (4, 8, 16):
        scaled = exact * 10**places
        whole = ceil(scaled) if above else floor(scaled)
        if whole != 10**places:
            break
    return f"{Decimal(whole).scaleb(-places):f}"


def differs_from_zero(expr: Expr, at: Mapping[Expr, Expr] | None = None) -> bool | None:
    """True where a ball excludes zero; None where no precision decides it."""
    for bits in PRECISIONS:
        value = ball(expr, at, bits)
        if value.is_finite() and not value.contains(acb(0)):
            return True
    return None


def is_real(expr: Expr) -> bool:
    """Whether the normal form shows that a value is real wherever the symbols are.

    The expression is its own mirror image, and no root in it may be one of a negative number.

    >>> x = sp.Symbol("x")
    >>> is_real(sp.exp(sp.I*x) + sp.exp(-sp.I*x)), is_real(sp.exp(sp.I*x)), is_real(sp.sqrt(x))
    (True, False, False)
    """
    for power in expr.atoms(sp.Pow):
        if not (power.exp.is_Integer or (power.base.is_Rational and power.base.is_positive)):
            return False
    try:
        mirrored = conjugated(expr, real=expr.free_symbols)
        return bool(mirrored == expr) or is_zero(expr - mirrored)
    except Unsupported:
        return False


def sign(expr: Expr) -> int | None:
    """The sign of a real number given by an expression without symbols, or None if undecided.

    Zero is recognised by the normal form, a sign by a ball.

    >>> sign(sp.cos(sp.pi/8)**2 - sp.Rational(1, 2) - sp.sqrt(2)/4), sign(sp.pi - 3)
    (0, 1)
    """
    expr = sp.sympify(expr, strict=True)
    real = is_real(expr)
    for bits in PRECISIONS:
        value = ball(expr, None, bits)
        if value.is_finite() and (real or value.imag.is_zero()):
            if value.real > 0:
                return 1
            if value.real < 0:
                return -1
    field = Field([expr])
    return 0 if field.is_zero(expr) else None
