"""What the deciders know: identities, arithmetic of signs, numbers, boxes, series and roots.

A leaf asks one decider and states all that it assumed: where a divisor may vanish, that it does not
is a hypothesis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import (
    And,
    Exists,
    Not,
    Predicate,
    Proposition,
    Relation,
    proposition,
    term,
)
from symhaptic.proof.ball import largest_root, sign
from symhaptic.proof.certificate import Positive
from symhaptic.proof.normal import Field, is_zero
from symhaptic.proof.recheck import recheck
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.series import limit, lowest_term
from symhaptic.proof.theorems.definedness import conditions, differs, mirrors, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, rule, whole

_ZERO = sp.S.Zero


@rule
def identity(left: Any, right: Any) -> Judgement:
    """left = right where both are defined, by the normal form of their difference."""
    left, right = term(left), term(right)
    if not _same(left, right):
        raise NotShown(f"{left} = {right} is not shown by a normal form")
    return conditions(left, right), Relation(left, "=", right)


def _same(left: Expr, right: Expr) -> bool:
    try:
        return Field([left, right]).are_equal(left, right)
    except (Unsupported, Undefined) as wrong:
        raise NotShown(str(wrong)) from None


@rule
def number(claim: Any) -> Judgement:
    """A relation between numbers, by balls; equality by the normal form."""
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


@rule
def square(of: Any) -> Judgement:
    """0 <= x^2 for a real x."""
    of = term(of)
    if not real(of):
        raise NotShown(f"{of} is not real by its form")
    return conditions(of), Relation(_ZERO, "<=", of**2)


Product: TypeAlias = "Sequence[Theorem | Expr | int]"
"""Theorems and positive rationals; with an equation any terms may stand beside it."""


@rule
def combined(claim: Any, *products: Product) -> Judgement:
    """A relation whose two sides differ by a sum of products of what is known.

    A product of theorems e > 0 or e >= 0 (each relation read with its smaller side taken to the
    other) and positive rationals is not negative; one with an equation is zero, whatever else
    stands in it.  ``!=`` needs a single product of what is not zero, and equations.

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
    known: set[Proposition] = set()
    for product in products:
        value, zero, positive, apart, signed = sp.S.One, False, True, True, True
        for factor in product:
            if isinstance(factor, Theorem):
                relation = factor.conclusion
                if not isinstance(relation, Relation):
                    raise NotShown(f"{relation} is no relation")
                hypotheses |= factor.hypotheses
                known |= conditions(relation.left, relation.right)
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
    return hypotheses | (conditions(claim.left, claim.right) - known), claim


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
def divided(claim: Any, numerator: Theorem, denominator: Theorem) -> Judgement:
    """0 < p/q from 0 < p and 0 < q, and 0 <= p/q from 0 <= p and 0 < q.

    >>> from symhaptic.proof.theorems.kernel import assume
    >>> x = sp.Symbol("x")
    >>> positive = number(sp.Gt(1, 0, evaluate=False))
    >>> len(divided(1/x > 0, positive, assume(x > 0)).hypotheses)
    1
    """
    claim = proposition(claim)
    top, bottom = numerator.conclusion, denominator.conclusion
    if not all(isinstance(r, Relation) and r.sign in ("<", "<=") for r in (claim, top, bottom)):
        raise NotShown("a quotient of signs is wanted")
    assert isinstance(claim, Relation)
    assert isinstance(top, Relation)
    assert isinstance(bottom, Relation)
    if bottom.sign != "<" or (claim.sign == "<" and top.sign != "<"):
        raise NotShown("the divisor may vanish, or the quotient")
    if not (real(claim.left) or real(claim.right)):
        raise NotShown(f"neither side of {claim} is real by its form")
    quotient = (top.right - top.left) / (bottom.right - bottom.left)
    if not _same(claim.right - claim.left, quotient):
        raise NotShown(f"{claim.right - claim.left} is not {quotient}")
    shown: set[Proposition] = {Relation(bottom.right - bottom.left, "!=", _ZERO)}
    shown |= conditions(top.left, top.right, bottom.left, bottom.right)
    left = conditions(claim.left, claim.right) - shown
    return numerator.hypotheses | denominator.hypotheses | left, claim


@rule
def strictly(weak: Theorem, apart: Theorem) -> Judgement:
    """a <= b and a != b give a < b."""
    claim, other = weak.conclusion, apart.conclusion
    if not (isinstance(claim, Relation) and isinstance(other, Relation) and claim.sign == "<="):
        raise NotShown("a <= b and a != b are wanted")
    if other not in (
        Relation(claim.left, "!=", claim.right),
        Relation(claim.right, "!=", claim.left),
    ):
        raise NotShown(f"{other} is not about the two sides of {claim}")
    return weak.hypotheses | apart.hypotheses, Relation(claim.left, "<", claim.right)


@rule
def both_ways(one: Theorem, other: Theorem) -> Judgement:
    """a <= b and b <= a give a = b."""
    claim, back = one.conclusion, other.conclusion
    if not (isinstance(claim, Relation) and claim.sign == "<="):
        raise NotShown("a <= b and b <= a are wanted")
    if back != Relation(claim.right, "<=", claim.left):
        raise NotShown(f"{back} is not the converse of {claim}")
    return one.hypotheses | other.hypotheses, Relation(claim.left, "=", claim.right)


@rule
def factor(of: Any, product: Theorem, other: Any) -> Judgement:
    """p != 0 from p q != 0, or from a p q of either sign."""
    of, other, claim = term(of), term(other), product.conclusion
    if not (isinstance(claim, Relation) and claim.sign in ("<", "!=")):
        raise NotShown(f"{claim} does not say that something is not zero")
    if not _same(of * other, claim.right - claim.left):
        raise NotShown(f"{of} is no factor of {claim.right - claim.left}")
    return product.hypotheses | conditions(of, other), Relation(of, "!=", _ZERO)


@rule
def mirrored(theorem: Theorem) -> Judgement:
    """The conjugate of an equation, whose symbols are real: with -j for j."""
    claim = theorem.conclusion
    if not (isinstance(claim, Relation) and claim.sign in ("=", "!=")):
        raise NotShown(f"{claim} is no equation")
    if not (mirrors(claim.left) and mirrors(claim.right)):
        raise NotShown(f"the conjugate of {claim} is not found by exchanging j and -j")
    left, right = (side.xreplace({sp.I: -sp.I}) for side in (claim.left, claim.right))
    return theorem.hypotheses | conditions(left, right), Relation(left, claim.sign, right)


# -- elementary functions --------------------------------------------------------------


def _about(function: type, x: Expr) -> tuple[list[Proposition], Relation]:
    """What is known of an elementary function at a real x, and on which hypotheses."""
    low, high = Relation(_ZERO, "<", x), Relation(x, "<", sp.pi)
    inside: list[Proposition] = [Relation(-sp.pi / 2, "<", x), Relation(x, "<", sp.pi / 2)]
    if function is sp.sin:
        return [low, high], Relation(_ZERO, "<", sp.sin(x))
    if function is sp.cos:
        return inside, Relation(_ZERO, "<", sp.cos(x))
    if function is sp.exp:
        return [], Relation(_ZERO, "<", sp.exp(x))
    if function is sp.cosh:
        return [], Relation(sp.S.One, "<=", sp.cosh(x))
    if function is sp.Abs:
        return [], Relation(_ZERO, "<=", sp.Abs(x))
    if function is sp.sqrt:
        return [Relation(_ZERO, "<=", x)], Relation(_ZERO, "<=", sp.sqrt(x))
    raise NotShown(f"nothing is known of {function}")


@rule
def sign_of(function: Any, of: Any) -> Judgement:
    """0 < sin x on (0, pi), 0 < cos x on (-pi/2, pi/2), 0 < exp x, 1 <= cosh x, 0 <= |x|."""
    of = term(of)
    if not real(of):
        raise NotShown(f"{of} is not real by its form")
    hypotheses, claim = _about(function, of)
    return conditions(of).union(hypotheses), claim


@rule
def rising(function: Any, smaller: Any, larger: Any) -> Judgement:
    """x < y gives f(x) < f(y): exp, sinh, atan, sin on [-pi/2, pi/2] and -cos on [0, pi]."""
    x, y = term(smaller), term(larger)
    if not (real(x) and real(y)):
        raise NotShown(f"{x} or {y} is not real by its form")
    hypotheses: list[Proposition] = [Relation(x, "<", y)]
    if function is sp.cos:
        hypotheses += [Relation(_ZERO, "<=", x), Relation(y, "<=", sp.pi)]
        return conditions(x, y).union(hypotheses), Relation(sp.cos(y), "<", sp.cos(x))
    if function is sp.sin:
        hypotheses += [Relation(-sp.pi / 2, "<=", x), Relation(y, "<=", sp.pi / 2)]
    elif function not in (sp.exp, sp.sinh, sp.atan):
        raise NotShown(f"{function} is not known to rise")
    return conditions(x, y).union(hypotheses), Relation(function(x), "<", function(y))


@rule
def bounded(function: Any, of: Any) -> Judgement:
    """f(x)^2 <= 1 for the sine and the cosine of a real x."""
    of = term(of)
    if function not in (sp.sin, sp.cos) or not real(of):
        raise NotShown(f"{function} of {of} is not known to be bounded")
    return conditions(of), Relation(function(of) ** 2, "<=", sp.S.One)


@rule
def magnitude(of: Any, negative: bool = False) -> Judgement:
    """|x| = x where 0 <= x, and |x| = -x where x <= 0."""
    of = term(of)
    if not real(of):
        raise NotShown(f"{of} is not real by its form")
    side = Relation(of, "<=", _ZERO) if negative else Relation(_ZERO, "<=", of)
    value = Relation(sp.Abs(of, evaluate=False), "=", -of if negative else of)
    return conditions(of) | {side}, value


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
    names = {w: sp.Dummy() for w in sorted(allowed - {value}, key=str)}
    poly = value.xreplace(names)
    try:
        coefficients = sp.Poly(poly, *names.values(), domain=sp.QQ).coeffs() if names else [poly]
    except (sp.PolynomialError, sp.CoercionFailed):
        raise NotShown(f"{value} is not made of whole numbers") from None
    if value not in allowed and not all(c.is_Integer and c >= 0 for c in coefficients):
        raise NotShown(f"{value} is not made of whole numbers")
    return hypotheses, whole(value)


@rule
def not_negative(of: Theorem) -> Judgement:
    """A whole number is not negative."""
    claim = of.conclusion
    if not (isinstance(claim, Predicate) and claim.name == "whole"):
        raise NotShown(f"{claim} does not say that something is whole")
    return of.hypotheses, Relation(_ZERO, "<=", claim.of[0])


@rule
def broken(value: Any) -> Judgement:
    """A rational number that is no whole number, zero included, is not whole."""
    value = term(value)
    if not value.is_Rational or (value.is_Integer and value >= 0):
        raise NotShown(f"{value} is not seen not to be whole")
    return (), Not((whole(value),))


@rule
def full_turns(angle: Any, turns: Theorem) -> Judgement:
    """sin (x + 2 pi k) = sin x and cos (x + 2 pi k) = cos x for a whole k."""
    x, claim = term(angle), turns.conclusion
    if not (isinstance(claim, Predicate) and claim.name == "whole"):
        raise NotShown(f"{claim} does not say that something is whole")
    further = x + 2 * sp.pi * claim.of[0]
    same = tuple(Relation(f(further), "=", f(x)) for f in (sp.sin, sp.cos))
    return turns.hypotheses | conditions(x), And(same)


@rule
def with_rest(of: Any, divisor: Any, turns: Symbol) -> Judgement:
    """For 0 <= a and 0 < p there is a whole k with k p <= a < (k + 1) p.

    Archimedes; Rudin, Principles of Mathematical Analysis, 3rd ed., 1.20.
    """
    of, divisor = term(of), term(divisor)
    if not (real(of) and real(divisor)) or turns in of.free_symbols | divisor.free_symbols:
        raise NotShown(f"{of} or {divisor} is not real by its form, or {turns} is taken")
    between = Relation(turns * divisor, "<=", of), Relation(of, "<", (turns + 1) * divisor)
    given = Relation(_ZERO, "<=", of), Relation(_ZERO, "<", divisor)
    return conditions(of, divisor).union(given), Exists((turns,), And((whole(turns), *between)))


# -- boxes, series, roots --------------------------------------------------------------


@rule
def on_box(certificate: Positive) -> Judgement:
    """0 < f on a box, by a certificate checked again; its finite balls show that f is defined."""
    if not isinstance(certificate, Positive) or certificate.given is not None:
        raise NotShown("a certificate of a box without further symbols is wanted")
    return on_certificate(certificate, term(certificate.expr))


def on_certificate(certificate: Positive, expr: Expr) -> Judgement:
    """That the symbols lie in the box, and 0 < expr, where the certificate says so of it."""
    if not real(expr) or not recheck(certificate):
        raise NotShown(f"the certificate does not show that {expr} is positive")
    ends = [
        Relation(x, "<=", y)
        for s, (low, high) in certificate.box.items()
        for x, y in ((term(low), s), (s, term(high)))
    ]
    return ends, Relation(_ZERO, "<", expr)


@rule
def tends(expr: Any, variable: Symbol, at: Any, value: Any) -> Judgement:
    """The limit by exact series, where no divisor vanishes on the way to ``at``.

    That the coefficient of the lowest power of each divisor is not zero is a hypothesis.
    """
    expr, at, value = term(expr), term(at), term(value)
    try:
        found = limit(expr, variable, at)
        if not is_zero(found - value):
            raise NotShown(f"the limit is {found}")
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
    """All zeros of a polynomial with numbers for coefficients lie inside the circle, by balls."""
    expr = term(polynomial).xreplace(dict(given))
    if expr.free_symbols != {variable} or not largest_root(expr) < 1:
        raise NotShown("a zero is not shown to be inside")
    return (), Predicate("stable", (variable,), (expr,))


@rule
def root_outside(polynomial: Any, variable: Symbol) -> Judgement:
    """A zero of a polynomial with numbers for coefficients lies outside the circle, by balls."""
    expr = term(polynomial)
    if expr.free_symbols != {variable} or not largest_root(expr) > 1:
        raise NotShown("no zero is shown to be outside")
    return (), Not((Predicate("stable", (variable,), (expr,)),))
