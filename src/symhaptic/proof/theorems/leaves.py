"""What the deciders know: identities, arithmetic of signs, numbers, boxes, series and roots.

A leaf asks one decider and states all that it assumed: where a divisor may vanish, that it does not
is a hypothesis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeAlias

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation import a, delta, e, gamma, n_0, n_1
from symhaptic.notation.fresh import fresh
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Implies,
    Not,
    Predicate,
    Proposition,
    Relation,
    proposition,
    whole,
)
from symhaptic.notation.terms import symbols_in, term
from symhaptic.proof.ball import largest_root, sign, zeros_inside
from symhaptic.proof.certificate import Positive
from symhaptic.proof.normal import Field, is_zero
from symhaptic.proof.plants import AT_ONE, BALLS, LOSS, NUMBERS, SLOPES, TOGETHER, Named
from symhaptic.proof.recheck import recheck
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.series import limit, lowest_term, shortened
from symhaptic.proof.theorems.definedness import beyond, conditions, differs, mirrors, needed, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule

_ZERO = sp.S.Zero


@rule
def identity(left: Any, right: Any) -> Judgement:
    """left = right where both are defined, by the normal form of their difference."""
    left, right = term(left), term(right)
    if not _same(left, right):
        raise NotShown(f"{left} = {right} is not shown by a normal form")
    return conditions(left, right), Relation(left, "=", right)


def _same(left: Expr, right: Expr) -> bool:
    """Whether both are the same where they are defined, as an expression is that it is."""
    if left == right:
        return True
    try:
        return Field([left, right]).are_equal(left, right)
    except (Unsupported, Undefined) as wrong:
        raise NotShown(str(wrong)) from None


@rule
def number(claim: Any) -> Judgement:
    """A relation between numbers, by ball arithmetic; equality by the normal form."""
    claim = proposition(claim)
    if not isinstance(claim, Relation) or claim.free:
        raise NotShown(f"{claim} is no relation between numbers")
    if claim.sign == "!=" and differs(claim.right - claim.left):
        return conditions(claim.left, claim.right), claim
    found = sign(claim.right - claim.left)
    holds = {"=": (0,), "!=": (1, -1), "<": (1,), "<=": (0, 1)}[claim.sign]
    if found not in holds or not (claim.sign in ("=", "!=") or real(claim.left)):
        raise NotShown(f"{claim} is not shown by balls")
    return conditions(claim.left, claim.right), claim


Product: TypeAlias = "Sequence[Theorem | Expr | int]"
"""Theorems and positive rationals; with an equation any terms may stand beside it."""


@rule
def combined(claim: Any, *products: Product) -> Judgement:
    """A relation whose two sides differ by a sum of products of known relations.

    Each known relation is written as e > 0, e >= 0, e = 0 or e != 0.  A product of positive
    rationals and such e > 0 or e >= 0 is not negative.  A product with an equation is zero,
    whatever its other factors are.  ``!=`` requires a single product of factors that are not zero,
    and equations.

    >>> from symhaptic.proof.theorems.kernel import assume
    >>> x, y = sp.symbols("x y")
    >>> combined(y > 0, [assume(x > 0)], [assume(y >= x)]).conclusion == proposition(y > 0)
    True
    """
    claim = proposition(claim)
    if not isinstance(claim, Relation):
        raise NotShown(f"{claim} is no relation")
    total, strict, nonzero, open_ = _ZERO, False, 0, 0
    hypotheses: set[Proposition] = set()
    known: set[Expr] = set()
    for product in products:
        value, zero, positive, apart, signed = sp.S.One, False, True, True, True
        for factor in product:
            if isinstance(factor, Theorem):
                relation = factor.conclusion
                if not isinstance(relation, Relation):
                    raise NotShown(f"{relation} is no relation")
                hypotheses |= factor.hypotheses
                known |= {relation.left, relation.right}
                value *= relation.right - relation.left
                zero = zero or relation.sign == "="
                positive = positive and relation.sign == "<"
                apart = apart and relation.sign in ("<", "!=")
                signed = signed and relation.sign in ("<", "<=")
            else:
                number_ = term(factor)
                rational = bool(number_.is_Rational and number_ > 0)
                signed, positive = signed and rational, positive and rational
                apart = apart and bool(number_.is_Rational and number_ != 0)
                hypotheses |= conditions(number_)
                value *= number_
        total += value
        if not zero:
            if not signed and claim.sign != "!=":
                raise NotShown(f"{value} has no sign")
            strict, nonzero, open_ = strict or positive, nonzero + apart, open_ + 1
    if claim.sign == "=" and open_:
        raise NotShown("an equation follows from equations only")
    if claim.sign == "!=" and not (open_ == nonzero == 1 or (strict and _signed(products))):
        raise NotShown("it follows from one product of what is not zero")
    if claim.sign == "<" and not strict:
        raise NotShown("nothing in it is strict")
    if claim.sign in ("<", "<=") and not (real(claim.left) or real(claim.right)):
        raise NotShown(f"neither side of {claim} is real by its form")
    difference = claim.right - claim.left
    if not _same(difference, total) and not (claim.sign == "!=" and _same(difference, -total)):
        raise NotShown(f"{difference} is not {total}")
    return hypotheses | beyond(claim.terms, known), claim


def _signed(products: Sequence[Product]) -> bool:
    """Whether all of a sum's products are known not to be negative."""
    return all(
        isinstance(f, Theorem) and isinstance(f.conclusion, Relation) and f.conclusion.sign != "!="
        if isinstance(f, Theorem)
        else bool(term(f).is_Rational and term(f) > 0)
        for product in products
        for f in product
    )


@rule
def factor(of: Any, product: Theorem, other: Any) -> Judgement:
    """p != 0 from p q != 0, p q > 0 or p q < 0."""
    of, other, claim = term(of), term(other), product.conclusion
    if not (isinstance(claim, Relation) and claim.sign in ("<", "!=")):
        raise NotShown(f"{claim} does not say that something is not zero")
    if not _same(of * other, claim.right - claim.left):
        raise NotShown(f"{of} is no factor of {claim.right - claim.left}")
    return product.hypotheses | conditions(of, other), Relation(of, "!=", _ZERO)


@rule
def mirrored(theorem: Theorem) -> Judgement:
    """The conjugate of an equation in real symbols: -j replaces j."""
    claim = theorem.conclusion
    if not (isinstance(claim, Relation) and claim.sign in ("=", "!=")):
        raise NotShown(f"{claim} is no equation")
    if not (mirrors(claim.left) and mirrors(claim.right)):
        raise NotShown(f"the conjugate of {claim} is not found by exchanging j and -j")
    left, right = (side.xreplace({sp.I: -sp.I}) for side in (claim.left, claim.right))
    return theorem.hypotheses | conditions(left, right), Relation(left, claim.sign, right)


# -- whole numbers ---------------------------------------------------------------------


@rule
def is_whole(value: Any, *known: Theorem) -> Judgement:
    """A sum of products of whole numbers with whole coefficients, zero included, is whole."""
    value = term(value)
    allowed: set[Expr] = set()
    hypotheses: set[Proposition] = set()
    for theorem in known:
        claim = theorem.conclusion
        if not (isinstance(claim, Predicate) and claim.name == "whole"):
            raise NotShown(f"{claim} does not say that something is whole")
        hypotheses |= theorem.hypotheses
        allowed.add(claim.of[0])
    hypotheses |= conditions(value) - needed(*allowed)
    names = {w: fresh(value.free_symbols) for w in sorted(allowed - {value}, key=str)}
    poly = value.xreplace(names)
    try:
        coefficients = sp.Poly(poly, *names.values(), domain=sp.QQ).coeffs() if names else [poly]
    except (sp.PolynomialError, sp.CoercionFailed):
        raise NotShown(f"{value} is not made of whole numbers") from None
    if value not in allowed and not all(c.is_Integer and c >= 0 for c in coefficients):
        raise NotShown(f"{value} is not made of whole numbers")
    return hypotheses, whole(value)


@rule
def broken(value: Any) -> Judgement:
    """A rational number that is no whole number, zero included, is not whole."""
    value = term(value)
    if not value.is_Rational or (value.is_Integer and value >= 0):
        raise NotShown(f"{value} is not seen not to be whole")
    return (), Not((whole(value),))


# -- boxes, series, roots --------------------------------------------------------------


@rule
def on_box(certificate: Positive) -> Judgement:
    """0 < f on a box, by a certificate that is checked again; finite balls show f is defined."""
    if not isinstance(certificate, Positive) or certificate.given is not None:
        raise NotShown("a certificate of a box without further symbols is wanted")
    return on_certificate(certificate, term(certificate.expr))


def on_certificate(certificate: Positive, expr: Expr) -> Judgement:
    """That the symbols lie in the box, and 0 < expr, where the certificate says so of it."""
    if not real(expr) or not recheck(certificate):
        raise NotShown(f"the certificate does not show that {expr} is positive")
    return on_sides(certificate), Relation(_ZERO, "<", expr)


def on_sides(certificate: Positive) -> set[Proposition]:
    """That the symbols lie in the box."""
    return {
        Relation(x, "<=", y)
        for s, (low, high) in certificate.box.items()
        for x, y in ((term(low), s), (s, term(high)))
    }


@rule
def on_plants(certificate: Positive) -> Judgement:
    """0 < f on a box of plants, for an f of their numbers n1, n0, a and e and of other symbols.

    The certificate encloses the exponential of the device's matrix (:mod:`symhaptic.proof.plants`)
    for each piece of gamma and delta.  It is checked again.
    """
    given = certificate.given if isinstance(certificate, Positive) else None
    if type(given) is not Named:
        raise NotShown("a certificate of a box of plants is wanted")
    plant = {LOSS: 1 - e, TOGETHER: n_1 + n_0, AT_ONE: 1 - a + e}
    numbers = {gamma, delta, n_1, n_0, a, e}
    meanings = {s: term(m).xreplace(plant) for s, m in given.meanings.items()}
    if set(certificate.box) & (numbers - {gamma, delta} | set(meanings)):
        raise NotShown("a number of the plant is no side of the box")
    expr = term(certificate.expr).xreplace({s: m for s, m in meanings.items() if s != m})
    allowed = set(certificate.box) | numbers
    if not {gamma, delta} <= set(certificate.box) or not symbols_in(expr) <= allowed:
        raise NotShown(f"{expr} is not made of the plant's numbers and the sides of the box")
    device = Predicate("device", (), (gamma, delta, n_1, n_0, a, e))
    fresh = replace(certificate, given=Named(dict(given.meanings)))
    ends, claim = on_certificate(fresh, expr)
    return {device, *ends}, claim


@rule
def more_damped(
    certificate: Positive, expr: Any, larger: Symbol, numbers: Sequence[Symbol]
) -> Judgement:
    """f(delta) < f(delta') for two devices with one spring, from 0 < df/ddelta on a box of plants.

    f is a polynomial in the numbers n1, n0, a and e, in gamma, delta and the other sides of the
    box; the other device (``numbers``) has the larger damping delta' (``larger``).  The
    certificate encloses the derivatives, too; mean value theorem, Rudin, 5.10.
    """
    given = certificate.given if isinstance(certificate, Positive) else None
    if type(given) is not Named:
        raise NotShown("a certificate of a box of plants is wanted")
    expr, sides, plant = term(expr), set(certificate.box), (n_1, n_0, a, e)
    names, meant = {*plant, *SLOPES, *NUMBERS}, set(given.meanings)
    if sides & (names | meant) or not {gamma, delta} <= sides or meant & (set(plant) - {n_0}):
        raise NotShown("a number of the plant is no side of the box")
    if not expr.free_symbols <= sides | set(plant) or not expr.is_polynomial(*expr.free_symbols):
        raise NotShown(f"{expr} is no polynomial in the plant's numbers and the sides of the box")
    other = (larger, *numbers)
    named = all(isinstance(s, Symbol) and real(s) for s in other) and len(set(other)) == 5
    if not named or set(other) & (sides | names | meant) or not real(expr):
        raise NotShown("the other device has names of its own, of real numbers")
    by_balls = expr.xreplace(BALLS)
    slope = sp.diff(by_balls, delta) + sp.Add(
        *(sp.diff(by_balls, x) * dx for x, dx in zip(NUMBERS, SLOPES, strict=True))
    )
    fresh = replace(certificate, given=Named(dict(given.meanings)))
    claimed = term(certificate.expr).xreplace(dict(given.meanings))
    if not is_zero(sp.expand(claimed - slope)) or not recheck(fresh):
        raise NotShown(f"the certificate is not of the slope {slope}")
    ends = on_sides(certificate)
    ends |= {p.at({delta: larger}) for p in ends}
    devices = (
        Predicate("device", (), (gamma, *some)) for some in ((delta, *plant), (larger, *numbers))
    )
    after = expr.xreplace({delta: larger, **dict(zip(plant, numbers, strict=True))})
    known = {*ends, *devices, *conditions(expr, after), Relation(delta, "<", larger)}
    return known, Relation(expr, "<", after)


@rule
def tends(expr: Any, variable: Symbol, at: Any, value: Any) -> Judgement:
    """The limit by exact series, if no divisor vanishes next to the point.

    That the coefficient of the lowest power of each divisor is not zero is a hypothesis.
    """
    expr, at, value = term(expr), term(at), term(value)
    try:
        found = limit(expr, variable, at)
        if not is_zero(found - value):
            raise NotShown(f"the limit is {found}")
        # what it has a value under is read from its lowest terms
        found = shortened(found) if conditions(found) else found
        near = set(conditions(found, value, at))
        for condition in conditions(expr):
            assert isinstance(condition, Relation)
            near |= _not_nearby(condition.left, variable, at)
    except (Unsupported, Undefined) as wrong:
        raise NotShown(str(wrong)) from None
    return near, Predicate("limit", (variable,), (expr, at, value))


def _not_nearby(divisor: Expr, variable: Symbol, at: Expr) -> set[Proposition]:
    """That a divisor does not vanish next to a point: its lowest coefficient is not zero."""
    if variable not in divisor.free_symbols:
        return set(conditions(1 / divisor))
    _, coefficient = lowest_term(divisor, variable, at)
    return set(conditions(1 / coefficient))


@rule
def roots_inside(polynomial: Any, variable: Symbol, given: Mapping[Expr, Expr]) -> Judgement:
    """All zeros of a polynomial with numerical coefficients lie inside the circle, by balls."""
    expr = term(polynomial).xreplace({s: term(value) for s, value in given.items()})
    polynomial_in = expr.free_symbols == {variable} and expr.is_polynomial(variable)
    if not polynomial_in or not zeros_inside(expr, variable):
        raise NotShown("a zero is not shown to be inside")
    return (), Predicate("stable", (variable,), (expr,))


@rule
def root_outside(polynomial: Any, variable: Symbol) -> Judgement:
    """A zero of a polynomial with numerical coefficients lies outside the circle, by balls."""
    expr = term(polynomial)
    if expr.free_symbols != {variable} or not largest_root(expr) > 1:
        raise NotShown("no zero is shown to be outside")
    return (), Not((Predicate("stable", (variable,), (expr,)),))


@rule
def none_right(polynomial: Any, variable: Symbol, along: Symbol, across: Symbol) -> Judgement:
    """p(x + j y) != 0 for 0 < x and 1 <= x^2 + y^2, for a p with numerical coefficients.

    Balls around the zeros show that each lies inside the unit circle or has a negative real part.
    """
    expr, outside, value = _outside_right(polynomial, variable, along, across)
    if not largest_root(expr, keep=lambda zero: not zero.real < 0) < 1:
        raise NotShown("a zero may lie outside, to the right")
    never = Implies((outside, Relation(value, "!=", _ZERO)))
    return (), ForAll((along, across), never)


@rule
def one_right(polynomial: Any, variable: Symbol, along: Symbol, across: Symbol) -> Judgement:
    """The contrary: a zero with a positive real part lies outside the unit circle, by balls."""
    expr, outside, value = _outside_right(polynomial, variable, along, across)
    if not largest_root(expr, keep=lambda zero: zero.real > 0) > 1:
        raise NotShown("no zero is shown to lie outside, to the right")
    never = Implies((outside, Relation(value, "!=", _ZERO)))
    return (), Not((ForAll((along, across), never),))


def _outside_right(
    polynomial: Any, variable: Symbol, along: Symbol, across: Symbol
) -> tuple[Expr, Proposition, Expr]:
    """A polynomial in numbers, 0 < x and 1 <= x^2 + y^2, and its value at x + j y."""
    expr = term(polynomial)
    if expr.free_symbols != {variable} or not expr.is_polynomial(variable):
        raise NotShown(f"{expr} is no polynomial in {variable} with numbers for coefficients")
    if along == across or not (real(along) and real(across)):
        raise NotShown(f"{along} and {across} are no two real symbols")
    outside = And((Relation(_ZERO, "<", along), Relation(sp.S.One, "<=", along**2 + across**2)))
    return expr, outside, expr.xreplace({variable: along + sp.I * across})
