r"""The numbers behind a theorem, so that a reader can check them with a calculator.

A theorem that rests on the zeros of a numerical polynomial shows the polynomial,
:math:`p(z)=z^n+c_1z^{n-1}+\ldots`, and the zero that decides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

import sympy as sp
from flint import acb, acb_poly, arb, ctx
from sympy import Expr

from symhaptic.book.rests import Said, Shown, said
from symhaptic.notation.latex import joined, latex
from symhaptic.proof.ball import NARROW, ball
from symhaptic.proof.theorems.kernel import Theorem

DEGREE = 5
"""Polynomials of a higher degree are too long for a line."""

MOST = 3
"""If there are more polynomials than this, only their number is given."""

_BITS = 256
_NOTHING = Decimal("1e-30")


def leaves(theorem: Theorem, shown: Mapping[Said, Shown], rules: frozenset[str]) -> list[Theorem]:
    """The basic steps of these kinds that a theorem uses, except through other theorems shown."""
    own, seen, found, stack = said(theorem), set(), [], [theorem]
    while stack:
        one = stack.pop()
        if id(one) in seen or (said(one) in shown and said(one) != own):
            continue
        seen.add(id(one))
        if one.rule in rules:
            found.append(one)
        stack += one.premises
    return found


def evidence(theorem: Theorem, shown: Mapping[Said, Shown]) -> str:
    """The numbers on which a theorem rests, as a sentence; empty where there are none."""
    roots = leaves(theorem, shown, frozenset({"roots_inside", "root_outside"}))
    told = list(dict.fromkeys(_zeros(*_polynomial(leaf)) for leaf in reversed(roots)))
    if len(told) > MOST:
        told = [f"the zeros of {len(told)} numerical polynomials are enclosed"]
    boxes = leaves(theorem, shown, frozenset({"on_box", "on_plants", "more_damped"}))
    pieces = [leaf.given[0].pieces for leaf in boxes]
    if pieces:
        functions = "a function is" if len(pieces) == 1 else f"{len(pieces)} functions are"
        cut = "one piece" if sum(pieces) == 1 else f"{sum(pieces)} pieces"
        told.append(f"{functions} positive on a box, by ball arithmetic on {cut}")
    return "; ".join(told)


def _polynomial(leaf: Theorem) -> tuple[Expr, sp.Symbol]:
    """The polynomial of such a leaf, and its variable."""
    polynomial, variable, *given = leaf.given
    return sp.sympify(polynomial).xreplace(dict(given[0]) if given else {}), variable


def _zeros(polynomial: Expr, variable: sp.Symbol) -> str:
    r"""A polynomial in decimals, and its zero farthest out.

    >>> z = sp.Symbol("z")
    >>> _zeros(z**2 - sp.sqrt(2) * z / 2 + sp.Rational(1, 4), z)
    '$z^2-0.7071067812z+0.25$ has the zeros $0.3535533906\\pm0.3535533906j$ farthest out, $|z|=0.5$'
    """
    before, ctx.prec = ctx.prec, _BITS
    try:
        given = list(_coefficients(polynomial, variable))
        coefficients = [c / given[0] for c in given]
        zeros = acb_poly(coefficients[::-1]).roots(tol=NARROW)
        far = max(zeros, key=lambda zero: float(abs(zero).mid()))
        where, size, degree = _complex(far), _size(far), len(coefficients) - 1
        of = (
            f"${_written(coefficients, variable)}$"
            if degree <= DEGREE
            else f"a polynomial of degree {degree}"
        )
    finally:
        ctx.prec = before
    zero = "zeros" if r"\pm" in where else "zero"
    return f"{of} has the {zero} ${where}$ farthest out, $|{latex(variable)}|={size}$"


def _coefficients(polynomial: Expr, variable: sp.Symbol) -> Iterator[acb]:
    """Balls of the coefficients, the highest power's first."""
    constants: dict[Expr, Expr] = {}

    def named(part: Expr) -> Expr:
        if part.is_Rational or part == variable:
            return part
        if variable not in part.free_symbols:
            return constants.setdefault(part, sp.Dummy())
        return part.func(*map(named, part.args))

    found = sp.Poly(named(polynomial), variable).all_coeffs()
    balls = {name: ball(part, bits=_BITS) for part, name in constants.items()}
    return (ball(c, balls, bits=_BITS) for c in found)


def _written(coefficients: list[acb], variable: sp.Symbol) -> str:
    name, degree = latex(variable), len(coefficients) - 1
    terms = []
    for power, c in zip(range(degree, -1, -1), coefficients, strict=True):
        digits = _decimal(c.real)
        if digits == "0":
            continue
        of = {0: "", 1: name}.get(power, f"{name}^{power}")
        terms.append(
            of if digits == "1" and of else f"-{of}" if digits == "-1" and of else digits + of
        )
    return joined(terms)


def _complex(zero: acb) -> str:
    real, imag = _decimal(zero.real), _decimal(abs(zero.imag))
    return real if imag == "0" else rf"{real}\pm{imag}j" if real != "0" else rf"\pm{imag}j"


def _size(zero: acb) -> str:
    """Its modulus, with enough digits to distinguish it from 1."""
    size = abs(zero)
    for digits in range(8, 60, 2):
        text = _decimal(size, digits)
        if text != "1":
            return text
    raise ValueError(f"{zero} is not told from the circle")


def _decimal(value: arb, digits: int = 10) -> str:
    """The value in this many digits, without trailing zeros; a tiny value is zero."""
    text = format(Decimal(value.mid().str(digits, radius=False)), "f")
    if abs(Decimal(text)) < _NOTHING:
        return "0"
    return text.rstrip("0").rstrip(".") if "." in text else text
