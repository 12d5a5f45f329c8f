"""Theorems on the zeros of polynomials: when do all of them lie inside the unit circle?

They are applied and not proved: with those of ``analysis`` and ``energy`` they are the list of what
has to be believed beside logic and the deciders.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.model.jury import determinant, half_planes, inner
from symhaptic.notation.proposition import (
    And,
    ForAll,
    Iff,
    Implies,
    Not,
    Predicate,
    Proposition,
    Relation,
    whole,
)
from symhaptic.notation.terms import term
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.definedness import conditions, differs, real
from symhaptic.proof.theorems.definitions import loop_polynomial
from symhaptic.proof.theorems.kernel import (
    Judgement,
    NotShown,
    Theorem,
    predicate,
    relation,
    rule,
    without,
)

SOURCES = {
    "roots_stay": "zeros of a polynomial are continuous in its coefficients; Marden, Geometry of "
    "Polynomials, Theorem 1.4",
    "none_enters": "the same; zeros of a real polynomial come in conjugate pairs",
    "all_inside": "zeros of a product are those of its factors",
    "zero_on_circle": "definition of a zero",
    "last_coefficient": "f(0) is, up to its sign, the product of the zeros of f (Vieta)",
    "jury": "half of Jury's inner determinants, and half planes, are sufficient; Anderson and "
    "Jury, A simplified Schur-Cohn test, IEEE Trans. Automatic Control 18(2), 1973",
    "first_minors": "z = (1+s)/(1-s) maps the left half plane to the unit disc, and 1/s to itself; "
    "Gantmacher, The Theory of Matrices, vol. 2, ch. XV, Theorem 4 (Routh-Hurwitz)",
    "hurwitz": "Gantmacher, The Theory of Matrices, vol. 2, ch. XV, Theorem 4 (Routh-Hurwitz)",
    "outpaces": "each zero a adds z/(z - a) to z p'/p, and Re z/(z - a) > 1/2 for |a| < |z| = 1; "
    "Marden, Geometry of Polynomials, Section 1",
    "opposite": "definition of a zero",
    "pole_at": "definition of a pole",
    "degree": "definition of the degree",
    "not_of_degree": "different powers are linearly independent",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def zero_on_circle(polynomial: Any, variable: Symbol, angle: Any, zero: Theorem) -> Judgement:
    """If p(exp(j theta)) = 0 for a real theta, not all zeros lie inside the unit circle."""
    polynomial, angle = term(polynomial), term(angle)
    if not real(angle):
        raise NotShown(f"{angle} is not real by its form")
    _says(zero, "=", _at(polynomial, variable, sp.I * angle))
    hypotheses = zero.hypotheses | conditions(angle) | _whole(_powers(polynomial, variable))
    return hypotheses, Not((_zeros(polynomial, variable),))


def _says(theorem: Theorem, sign: str, value: Expr) -> None:
    """Nothing, where a theorem concludes that a value is, or is not, zero, or is positive."""
    claim = relation(theorem, sign)
    side, zero = (claim.right, claim.left) if sign == "<" else (claim.left, claim.right)
    if zero != 0 or not is_zero(side - value):
        raise NotShown(f"{claim} is not said of {value}")


def divisors(variable: Symbol, *terms: Expr, apart: Iterable[Expr] = ()) -> frozenset[Proposition]:
    """Conditions of terms that divide by no other term with the variable than by itself.

    And by those that are known to differ from zero (``apart``).  Another might vanish for all z at
    some values of its parameters, as q z - q/2 does at q = 0, and nothing could ask for that: the
    variable is bound.
    """
    found = conditions(*terms) - {Relation(t, "!=", _ZERO) for t in (variable, *apart)}
    without([variable], found)
    return found


def _zeros(polynomial: Expr, variable: Symbol) -> Predicate:
    return Predicate("stable", (variable,), (polynomial,))


def coefficients(polynomial: Expr, variable: Symbol) -> list[Expr]:
    """Coefficients of a polynomial of a degree that is a number, highest power first."""
    try:
        return [sp.sympify(c) for c in sp.Poly(polynomial, variable).all_coeffs()]
    except sp.PolynomialError:
        raise NotShown(f"{polynomial} is no polynomial in {variable} of a known degree") from None


@rule
def all_inside(variable: Symbol, power: Any, *factors: Theorem) -> Judgement:
    """All zeros of z^m f g lie inside the unit circle if those of f and of g do; m is whole."""
    product = term(variable) ** term(power)
    hypotheses = _whole([term(power)])
    for theorem in factors:
        polynomial = _stable(theorem, variable)
        product *= polynomial
        hypotheses |= theorem.hypotheses
    return hypotheses, _zeros(product, variable)


@rule
def last_coefficient(inside: Theorem, power: Any = _ZERO) -> Judgement:
    """If all zeros of a monic z^m f lie inside the unit circle, -1 < f(0) < 1.

    f is real and of degree 1 at least.  That the exponents and m (``power``) are whole is a
    hypothesis.
    """
    claim, lowest = predicate(inside, "stable"), sp.expand(term(power))
    [polynomial], [variable] = claim.of, claim.over
    powers = _powers(polynomial, variable)
    last = powers.get(lowest, _ZERO)
    _, hypotheses = _leading(polynomial, variable**lowest, variable)
    for exponent in powers.keys() - {lowest}:
        hypotheses |= _not_negative(exponent - lowest - 1)
    return inside.hypotheses | hypotheses, And(
        (Relation(-sp.S.One, "<", last), Relation(last, "<", sp.S.One))
    )


@rule
def jury(polynomial: Any, variable: Symbol) -> Judgement:
    """All zeros of a monic real p lie inside the unit circle <=> n + 1 expressions are positive.

    They are the coefficients c_0 and c_n, c_(n-2), ... of (1 - s)^n p((1 + s)/(1 - s)), and
    Jury's inner determinants |X - Y| of orders r = n-1, n-3, ...  If p is the sum of a_k z^k, the
    entry in row i and column j (i, j = 1 to r) is a_(n-j+i) in X and a_(i+j-r-1) in Y, or 0 if
    there is no such coefficient.  X is 0 below its diagonal.  The degree n is a number.
    """
    polynomial = term(polynomial)
    falling = coefficients(polynomial, variable)
    degree = len(falling) - 1
    if falling[0] != 1 or degree < 1 or not all(real(c) for c in falling):
        raise NotShown(f"{polynomial} is not monic and real by its form")
    inners = [inner(falling, order) for order in range(1 + degree % 2, degree, 2)]
    positive = [*half_planes(falling[::-1]), *map(determinant, inners)]
    wanted = And(tuple(Relation(_ZERO, "<", sp.expand(p)) for p in positive))
    return divisors(variable, polynomial), Iff((_zeros(polynomial, variable), wanted))


@rule
def hurwitz(polynomial: Any, variable: Symbol) -> Judgement:
    """All zeros of a real polynomial have negative real parts <=> n determinants are positive.

    They are the leading minors of Hurwitz' matrix, which has a_(n+i-2j) in row i and column j.
    That the leading coefficient is positive is a hypothesis.  The degree n is a number.
    """
    polynomial = term(polynomial)
    falling = coefficients(polynomial, variable)
    degree = len(falling) - 1
    if degree < 1 or not all(real(c) for c in falling):
        raise NotShown(f"{polynomial} has no zeros, or is not real by its form")
    hypotheses = conditions(polynomial)
    without([variable], hypotheses)
    hypotheses |= {Relation(_ZERO, "<", falling[0])}
    zeros = Predicate("hurwitz", (variable,), (polynomial,))
    return hypotheses, Iff((zeros, And(_minors(falling, degree))))


def _minors(falling: Sequence[Expr], count: int) -> tuple[Proposition, ...]:
    """The first leading minors of Hurwitz' matrix are positive."""

    def entry(row: int, column: int) -> Expr:
        place = 2 * column - row + 1
        return falling[place] if 0 <= place < len(falling) else _ZERO

    minors = [sp.Matrix(n, n, entry).det(method="berkowitz") for n in range(1, count + 1)]
    return tuple(Relation(_ZERO, "<", sp.expand(m)) for m in minors)


@rule
def first_minors(inside: Theorem, count: int) -> Judgement:
    """If a monic real p has all zeros inside the circle, p(1) and Hurwitz' minors are positive.

    The minors are those of c_0 s^n + c_1 s^(n-1) + ..., where (1 - s)^n p((1 + s)/(1 - s)) is the
    sum of c_k s^k.  Only the first ones are stated, at most as many as the degree n.  That
    exponents are whole is a hypothesis.
    """
    claim = predicate(inside, "stable")
    [polynomial], [variable] = claim.of, claim.over
    powers = _powers(polynomial, variable)
    degree, hypotheses = _leading(polynomial, _ZERO, variable)
    if count < 0:
        raise NotShown(f"{count} is no number of minors")
    hypotheses |= _not_negative(degree - count)

    def weight(k: int, e: Expr) -> Expr:
        ways = range(k + 1)
        return sp.Add(*((-1) ** (k - j) * _choose(e, j) * _choose(degree - e, k - j) for j in ways))

    rising = [sp.Add(*(c * weight(k, e) for e, c in powers.items())) for k in range(2 * count)]
    start = Relation(_ZERO, "<", sp.Add(*powers.values()))
    hypotheses |= inside.hypotheses | conditions(*powers.values())
    return hypotheses, And((start, *_minors(rising, count)))


@rule
def outpaces(inside: Theorem, angle: Any) -> Judgement:
    """If p has all zeros inside the circle, n |p|^2 < 2 Re conj(p) z p' at z = exp(j theta).

    p is monic and real, and its degree n is 1 at least.  That exponents are whole is a hypothesis.
    """
    claim, angle = predicate(inside, "stable"), term(angle)
    [polynomial], [variable] = claim.of, claim.over
    degree, hypotheses = _leading(polynomial, _ZERO, variable)
    if not real(angle) or variable in angle.free_symbols:
        raise NotShown(f"{angle} is not real by its form")
    hypotheses |= _not_negative(degree - 1)
    powers = _powers(polynomial, variable)

    def there(way: Expr, share: Any) -> Expr:
        return sp.Add(*(share(e) * c * sp.exp(way * angle * e) for e, c in powers.items()))

    value, mirror = (there(way, lambda e: sp.S.One) for way in (sp.I, -sp.I))
    speed, back = (there(way, lambda e: e - degree / 2) for way in (sp.I, -sp.I))
    hypotheses |= inside.hypotheses | conditions(angle, *powers.values())
    return hypotheses, Relation(_ZERO, "<", speed * mirror + back * value)


@rule
def opposite(inside: Theorem) -> Judgement:
    """If a monic real p has all zeros inside the circle, so does p(-z), made monic.

    For each exponent the rule decides whether its difference from the degree is even or odd.  That
    exponents are whole is a hypothesis.
    """
    claim = predicate(inside, "stable")
    [polynomial], [variable] = claim.of, claim.over
    degree, hypotheses = _leading(polynomial, _ZERO, variable)
    turned = _ZERO
    for exponent, coefficient in _powers(polynomial, variable).items():
        gap = sp.expand(degree - exponent)
        odd = int(gap.xreplace(dict.fromkeys(gap.free_symbols, _ZERO)) % 2)
        hypotheses |= _not_negative((gap - odd) / 2)
        turned += (-1) ** odd * coefficient * variable**exponent
    return inside.hypotheses | hypotheses, _zeros(turned, variable)


def _choose(of: Expr, count: int) -> Expr:
    """The binomial coefficient, a polynomial."""
    return sp.Mul(*((of - i) / (i + 1) for i in range(count)))


@rule
def roots_stay(
    start: Any,
    change: Any,
    variable: Symbol,
    share: Symbol,
    angle: Symbol,
    crossing: Theorem,
    static: Theorem,
    begin: Theorem,
    *inwards: Theorem,
) -> Judgement:
    """All zeros of f + g lie inside the circle if those of f do and none of f + y g crosses it.

    Here 0 < y <= 1.  f is monic and of higher degree than g.  Both are real polynomials in z, whose
    exponents may contain symbols (that these are whole is a hypothesis).  The premises show that
    f + y g is not zero at exp(j theta) for 0 < theta <= pi (``crossing``), nor at 1 (``static``),
    and that all zeros of f lie inside (``begin``).  If f = (z - 1) h, it is sufficient that all
    zeros of h lie inside and that 0 < g(1) and 0 < h(1) (``inwards``): the zero at 1 moves to
    smaller z.
    """
    f, g = term(start), term(change)
    circle = {Relation(_ZERO, "<", angle), Relation(angle, "<=", sp.pi)}
    spots = (crossing, (sp.I * angle, circle)), (static, (_ZERO, ()))
    hypotheses = begin.hypotheses | _unmoved(f, g, variable, share, angle, spots)
    inside = _stable(begin, variable)
    if not is_zero(inside - f):
        if not is_zero((variable - 1) * inside - f) or len(inwards) != 2:
            raise NotShown(f"{inside} is not where the path begins")
        for theorem, polynomial in zip(inwards, (g, inside), strict=True):
            _says(theorem, "<", _at(polynomial, variable, _ZERO))
            hypotheses |= theorem.hypotheses
    return hypotheses, _zeros(f + g, variable)


def _unmoved(
    f: Expr, g: Expr, variable: Symbol, share: Symbol, place: Symbol, spots: Iterable[Any]
) -> set[Proposition]:
    """What is left to show so that f + y g, 0 < y <= 1, is not zero at exp(w): of each spot a
    theorem that says so, w, and what is known of the place there."""
    if {share, place} & (f.free_symbols | g.free_symbols) or share == place:
        raise NotShown(f"{share} or {place} is no symbol of its own")
    part_way = {Relation(_ZERO, "<", share), Relation(share, "<=", sp.S.One)}
    _, hypotheses = _leading(f, g, variable)
    for theorem, (w, within) in spots:
        _says(theorem, "!=", _at(f, variable, w) + share * _at(g, variable, w))
        hypotheses |= theorem.hypotheses.difference(within, part_way)
    without([share, place], hypotheses)
    return hypotheses | divisors(variable, f, g)


@rule
def none_enters(begin: Theorem, change: Any, over: Sequence[Symbol], *shown: Theorem) -> Judgement:
    """p(v^2) + g(v) != 0 for v = x + j y, 0 < x and 1 <= x^2 + y^2, if the zeros of p lie inside.

    No zero of p(v^2) + q g(v), 0 < q <= 1, crosses the border of this region: the premises show
    that this is not zero at exp(j t), 0 < t <= pi/2, at 1, and at j exp(t), 0 < t.  p is monic,
    both are real, and p(v^2) is of higher degree than g.  That exponents are whole is a hypothesis.
    """
    g, (variable, share, place, x, y) = term(change), over
    powers = _powers(_stable(begin, variable), variable)
    f = sp.Add(*(c * variable ** (2 * e) for e, c in powers.items()))
    if x == y or not (real(x) and real(y)) or {x, y} & (f.free_symbols | g.free_symbols):
        raise NotShown(f"{x} and {y} are no two real symbols of their own")
    ahead, quarter = Relation(_ZERO, "<", place), Relation(place, "<=", sp.pi / 2)
    border = (sp.I * place, {ahead, quarter}), (_ZERO, ()), (place + sp.I * sp.pi / 2, {ahead})
    found = _unmoved(f, g, variable, share, place, zip(shown, border, strict=True))
    outside = And((Relation(_ZERO, "<", x), Relation(sp.S.One, "<=", x**2 + y**2)))
    apart = Relation((f + g).xreplace({variable: x + sp.I * y}), "!=", _ZERO)
    return found | begin.hypotheses | _whole(powers), ForAll((x, y), Implies((outside, apart)))


@rule
def pole_at(
    values: Sequence[Any],
    variable: Symbol,
    share: Any,
    exponent: Any,
    zero: Theorem,
    stiffness: bool = True,
    damping: bool = True,
) -> Judgement:
    """exp(s) is a pole of (18) if exp(s/q) is a zero of its polynomial in w, with z = w^q.

    q (``share``) is whole and positive.  The premise (``zero``) is that the polynomial vanishes
    there, with its powers written as exp(s n/q).
    """
    share, exponent = term(share), term(exponent)
    divisors, zeros = loop_polynomial(values, variable, share, stiffness, damping)
    if variable in share.free_symbols | exponent.free_symbols or not real(share):
        raise NotShown(f"{variable} is bound")
    powers = _powers(zeros.of[0], variable, real_only=False)
    _says(zero, "=", sp.Add(*(c * sp.exp(exponent * n / share) for n, c in powers.items())))
    found = tuple(term(v) for v in values)
    hypotheses = zero.hypotheses | divisors | conditions(exponent)
    hypotheses |= _whole([*powers, share, sp.expand(share * found[4])])
    if not share.is_number:
        hypotheses |= {Relation(_ZERO, "<", share)}
    return hypotheses, Predicate("pole", (), (*found, sp.exp(exponent)))


@rule
def degree(polynomial: Any, variable: Symbol, power: Any) -> Judgement:
    """The degree of a polynomial is the power that exceeds all others by whole numbers.

    That exponents are whole and that its coefficient is not zero are hypotheses.
    """
    polynomial, power = term(polynomial), sp.expand(term(power))
    powers = _powers(polynomial, variable, real_only=False)
    if power not in powers:
        raise NotShown(f"{power} is no power in it")
    hypotheses = _whole(powers)
    for exponent in powers.keys() - {power}:
        hypotheses |= _not_negative(power - exponent - 1)
    hypotheses |= {Relation(powers[power], "!=", _ZERO), *divisors(variable, polynomial)}
    return hypotheses, Predicate("degree", (variable,), (polynomial, power))


@rule
def not_of_degree(polynomial: Any, variable: Symbol, power: Any) -> Judgement:
    """A sum of powers is not of this degree if an exponent is not whole, or this one is missing."""
    polynomial, power = term(polynomial), term(power)
    powers = _powers(polynomial, variable, real_only=False)
    if any(e.free_symbols or not e.is_Rational for e in (*powers, power)):
        raise NotShown(f"{polynomial} has powers that are no rational numbers")
    broken = [c for e, c in powers.items() if not (e.is_Integer and e >= 0)]
    lead = powers.get(power, _ZERO)
    if not any(differs(c) for c in broken) and not (not lead.free_symbols and is_zero(lead)):
        raise NotShown(f"{polynomial} may have the degree {power}")
    wrong = Predicate("degree", (variable,), (polynomial, power))
    return conditions(*powers.values()), Not((wrong,))


def _stable(theorem: Theorem, variable: Symbol) -> Expr:
    """The polynomial of which a theorem says that all its zeros lie inside."""
    claim = predicate(theorem, "stable")
    without([variable], [claim])
    return claim.of[0].xreplace({claim.over[0]: variable})


def _powers(polynomial: Expr, variable: Symbol, real_only: bool = True) -> dict[Expr, Expr]:
    """Exponents of a polynomial, which may hold symbols, with their coefficients."""
    found: dict[Expr, Expr] = {}
    for exponent, coefficient in summands(polynomial, variable, real_only):
        found[exponent] = found.get(exponent, _ZERO) + coefficient
    return {e: c for e, c in found.items() if c != 0}


def summands(of: Expr, variable: Symbol, real_only: bool = True) -> Iterator[tuple[Expr, Expr]]:
    """Exponents and coefficients, real by their form, of a sum of multiples of powers."""
    for summand in sp.Add.make_args(sp.expand(of)):
        coefficient, powers = summand.as_independent(variable, as_Add=False)
        factors = [f.as_base_exp() for f in sp.Mul.make_args(powers) if summand != 0 and f != 1]
        if any(base != variable or variable in e.free_symbols for base, e in factors):
            raise NotShown(f"{summand} is no multiple of a power of {variable}")
        if real_only and not real(coefficient):
            raise NotShown(f"{coefficient} is not real by its form")
        yield sp.expand(sp.Add(*(e for _, e in factors))), coefficient


def _whole(exponents: Iterable[Expr]) -> set[Proposition]:
    """That exponents are whole; of numbers it is seen."""
    for exponent in exponents:
        if exponent.is_number and not (exponent.is_Integer and exponent >= 0):
            raise NotShown(f"the exponent {exponent} is not whole")
    return {whole(e) for e in exponents if not e.is_number}


def _at(polynomial: Expr, variable: Symbol, w: Expr) -> Expr:
    """Its value at exp(w), for whole exponents."""
    return sp.Add(*(c * sp.exp(w * e) for e, c in _powers(polynomial, variable).items()))


def _leading(f: Expr, g: Expr, variable: Symbol) -> tuple[Expr, set[Proposition]]:
    """The degree of a monic f above that of g, and what shows it: that exponents are whole, and
    the highest larger than all others by whole numbers."""
    ours, theirs = _powers(f, variable), _powers(g, variable)
    hypotheses = _whole([*ours, *theirs])
    for lead in (e for e, coefficient in ours.items() if coefficient == 1):
        try:
            gaps = (lead - e - 1 for e in (*(ours.keys() - {lead}), *theirs))
            return lead, hypotheses.union(*map(_not_negative, gaps))
        except NotShown:
            continue
    raise NotShown(f"{f} is not monic, or {g} not of lower degree")


def _not_negative(gap: Expr) -> set[Proposition]:
    """Under what a number is whole: it is a sum of whole numbers and of multiples and products of
    symbols, and these are whole."""
    gap = sp.expand(gap)
    poly = gap.as_poly(*gap.free_symbols) if gap.free_symbols else None
    if not all(c.is_Integer and c >= 0 for c in (poly.coeffs() if poly else [gap])):
        raise NotShown(f"{gap} may be negative")
    return {whole(s) for s in gap.free_symbols}
