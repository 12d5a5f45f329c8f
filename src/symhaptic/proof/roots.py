"""Roots enclosed by balls, and algebraic numbers with their minimal polynomials.

A root of a polynomial lies in a ball that flint certifies, the zero of any other function in one
that a step of Newton's interval method does.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import Decimal

import sympy as sp
from flint import acb, acb_poly, arb, arb_poly, ctx, fmpq_mat, fmpq_poly, fmpz_poly
from sympy import Expr

from symhaptic.notation.exact import from_leading
from symhaptic.proof.ball import At, ball
from symhaptic.proof.certificate import Zero
from symhaptic.proof.derivative import derivative

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
    return from_leading(coefficients)


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


def zero(expr: Expr, variable: sp.Symbol, lower: Expr, upper: Expr, at: At | None = None) -> Zero:
    """The only zero of a function between two numbers, in a ball, by Newton's interval step.

    A step that ends inside the interval it started from proves that there is one zero in it, for
    any values of further symbols in the balls given by ``at``.
    Raises :class:`NoSuchRoot` where the first step does not.

    >>> x = sp.Symbol("x")
    >>> print(zero(sp.cos(x), x, sp.S.One, sp.Integer(2)).ball.str(20))
    [1.5707963267948966192 +/- 3.14e-20]
    """
    slope, known = derivative(expr, variable), dict(at or {})

    def newton(wide: arb) -> arb:
        middle = wide.mid()
        value = ball(expr, {**known, variable: middle}, BITS)
        rises = ball(slope, {**known, variable: wide}, BITS)
        if not value.imag.is_zero():
            raise NoSuchRoot(f"{expr} is not shown to be real")
        return middle - value.real / rises.real

    with ctx.workprec(BITS):
        wide = ball(lower, bits=BITS).real.union(ball(upper, bits=BITS).real)
        narrow = newton(wide)
        if not wide.contains_interior(narrow):
            raise NoSuchRoot(f"no zero of {expr} is shown between {lower} and {upper}")
        while narrow.rad() < wide.rad():
            wide, narrow = narrow, newton(narrow)
        # twice as wide, and not narrower than a last bit, so that the signs at its ends can be seen
        least = arb(2) ** (8 - BITS) * (1 + abs(wide.mid()))
        found = arb(wide.mid(), arb.max(2 * wide.rad(), least))
    return Zero(expr, variable, (lower, upper), found, BITS, known)


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


def real_roots(coefficients: Sequence[arb]) -> list[arb]:
    """Balls around all real roots of a real polynomial, the lowest coefficient first.

    Flint finds disjoint balls with one root each.  One that meets no mirror image but its own has
    a real root.  Raises :class:`NoSuchRoot` where the roots are not told apart, and where the
    coefficients may all be zero, or the highest one, so that some are not known.

    >>> [float(root) for root in real_roots([arb(-1), arb(0), arb(0), arb(1)])]
    [1.0]
    """
    if not coefficients or coefficients[-1].contains(0):
        raise NoSuchRoot("the highest coefficient may be zero, and the roots are not known")
    with ctx.workprec(BITS):
        try:
            found = acb_poly(list(coefficients)).roots(tol=arb(2) ** (64 - BITS))
        except ValueError as close:
            raise NoSuchRoot("roots too close to be told apart") from close
        real = []
        for root in found:
            mirror = acb(root.real, -root.imag)
            meets = [other for other in found if other.overlaps(mirror)]
            if root.overlaps(mirror) and len(meets) == 1:
                real.append(root.real)
            elif root.overlaps(mirror):
                raise NoSuchRoot(f"whether {root} is real is not decided")
        return sorted(real, key=lambda root: float(root.mid()))


def rounded(value: arb, digits: int = 15, power: int = 0) -> str:
    """A number times 10^power, rounded to so many significant digits, the last one certain.

    Raises :class:`NoSuchRoot` where the ball is too wide to round it.

    >>> rounded(-arb.pi() / 10**4, 6)
    '-0.000314159'
    """
    with ctx.workprec(BITS):
        if value.contains(0):
            raise NoSuchRoot(f"{value} may be zero")
        value = value * arb(10) ** power
        places = digits
        while not abs(value) * arb(10) ** places >= arb(10) ** (digits - 1):
            places += 1
        while abs(value) * arb(10) ** places >= arb(10) ** digits:
            places -= 1
        whole = (abs(value) * arb(10) ** places + arb("0.5")).floor().unique_fmpz()
    if whole is None:
        raise NoSuchRoot(f"{value} is not known to {digits} digits")
    text = str(whole).rjust(places + 1, "0")
    sign = "-" if value < 0 else ""
    return f"{sign}{text[:-places]}.{text[-places:]}"


def between_decimals(
    value: Callable[[sp.Rational], arb], lower: Expr, upper: Expr, places: int = 24
) -> arb:
    """The interval between two neighbouring decimals at which a function has opposite signs.

    A continuous function has a zero in it.  Found by the secant method; only the two signs at the
    end are claimed.  Raises :class:`NoSuchRoot` where it does not end at such decimals.

    >>> print(between_decimals(lambda x: ball(sp.cos(x), None, BITS).real, 1, 2).str(20))
    [1.5707963267948966192 +/- 3.14e-20]
    """
    scale = 10**places
    one, two = sp.Rational(lower), sp.Rational(upper)
    with ctx.workprec(BITS):
        first, second = value(one), value(two)
        for _ in range(30):
            near, far = ball(two, None, BITS).real, ball(one, None, BITS).real
            guess = near - second * (near - far) / (second - first)
            count = int((guess.mid() * scale).floor().unique_fmpz() or 0)
            three = sp.Rational(count, scale)
            if three in (one, two):
                break
            one, first, two, second = two, second, three, value(three)
        for low in (count, count - 1, count + 1):
            ends = sp.Rational(low, scale), sp.Rational(low + 1, scale)
            if value(ends[0]) * value(ends[1]) < 0:
                return ball(ends[0], None, BITS).real.union(ball(ends[1], None, BITS).real)
    raise NoSuchRoot(f"no neighbouring decimals with opposite signs from {lower} and {upper}")


def is_minimal(number: Algebraic) -> bool:
    """Whether a number's polynomial is irreducible, and it is the smallest positive root."""
    polynomial = rational_polynomial(number.minimal)
    if [count for _, count in polynomial.factor()[1]] != [1]:
        return False
    with ctx.workprec(BITS):
        roots = [r.real for r, _ in polynomial.complex_roots() if r.imag.is_zero()]
    found = [r for r in roots if r > 0 and not r > number.ball]
    return len(found) == 1 and bool(found[0].overlaps(number.ball))


def begins_with(value: arb, text: str) -> bool:
    """Whether the decimals of a number begin with this text, by the ball around it."""
    unit = Decimal(1).scaleb(int(Decimal(text).as_tuple().exponent))
    with ctx.workprec(BITS):
        lower, upper = arb(text), arb(str(Decimal(text) + unit))
        return bool(value >= lower.lower() and value < upper.upper())
