r"""Is an expression zero?  Decided by a normal form, never by simplification.

Exponentials, sines and cosines, powers with symbolic exponents and roots are replaced by
generators, after which every expression of the paper is a quotient of two polynomials over
the rationals.  Exponents are written over a basis of the space that they span over the
rationals, modulo :math:`j\pi`, so that :math:`e^{jd\theta}` and :math:`e^{j(d+2)\theta}`
share generators; sines of different multiples of one angle need no table of identities.
Roots, :math:`j` and roots of unity obey a polynomial relation each.

A normal form of zero proves the identity wherever both sides are defined.  A normal form
that is not zero proves nothing by itself: :mod:`symhaptic.proof.decide` then looks for a
point where the two sides differ.

Everything that is divided by must have an inverse in this ring.  What is zero has none
(:class:`Undefined`), and neither has what is zero for one value of a root: sqrt(x^2) - x is not
zero, but its product with sqrt(x^2) + x is (:class:`Unsupported`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import lcm

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpz_poly
from sympy import Expr
from sympy.core.function import Application

from symhaptic.notation.exact import rational
from symhaptic.notation.fresh import made_before, mark
from symhaptic.proof.budget import spend
from symhaptic.proof.rewriting import Undefined, Unsupported, as_exponentials
from symhaptic.proof.ring import Fractional, Ring

Exponents = dict[tuple[int, ...], fmpq]

_ZERO = fmpq(0)

_NO_NUMBERS = (sp.nan, sp.zoo, sp.oo, -sp.oo, sp.AccumBounds)

_TURN = sp.I * sp.pi
"""The exponent modulo which all are counted."""


@dataclass(frozen=True)
class Small:
    """A variable in which exponentials become Taylor polynomials, of this many terms."""

    variable: sp.Symbol
    order: int


class Field:
    """The field that a set of expressions lives in, and their images there.

    >>> from sympy.abc import d, x
    >>> from sympy import sin, cos
    >>> Field([f := sin((d + 2)*x) + sin(d*x) - 2*sin((d + 1)*x)*cos(x)]).is_zero(f)
    True
    """

    def __init__(self, exprs: Iterable[Expr], small: Small | None = None) -> None:
        self._small = small
        self._series: dict[Expr, tuple[Expr, Expr]] = {}
        """Of what depends on the small variable: e^(u + v) by e^u and v, which vanishes with it."""
        self._mark = mark()
        """What its own symbols have numbers above."""
        self._exprs = {e: as_exponentials(sp.sympify(e, strict=True)) for e in exprs}
        self._radicals: dict[tuple[Expr, int], Expr] = {}
        self._logs: dict[Expr, Expr] = {}
        self._opaque: dict[Expr, Expr] = {}
        self._exponents: list[Expr] = []
        self._inside: list[Expr] = []
        """The same, without the logarithm of a base."""
        self._divides = False
        """Whether an exponent has a divisor."""
        self._divisors: list[fmpq_mpoly] | None = []
        """Those that are met before all relations are known, and None afterwards."""
        self._turns = False
        """Whether roots of unity are wanted, for j or an exponential."""
        everywhere: set[Expr] = set()
        outside: set[Expr] = set()
        for e in self._exprs.values():
            self._collect(e, everywhere, outside, set())
        self._symbols = sorted(everywhere, key=_name)
        self._outside = sorted(outside, key=_name)
        self._images: dict[Expr, Fractional] = {}
        """Images of sums, which an expression may hold several times."""
        self._basis: list[tuple[Expr, Exponents]] = []
        self._coordinates: dict[Expr, dict[int, Fraction]] = {}
        self._span()
        self._build()

    # -- what occurs -----------------------------------------------------------------

    def _collect(
        self, expr: Expr, symbols: set[Expr], outside: set[Expr] | None, seen: set[int]
    ) -> None:
        """Symbols everywhere and those ``outside`` exponents, None within one; exponents, roots,
        unknown functions."""
        spend(1)
        self._turns = self._turns or expr is sp.I
        if expr.is_Rational or expr is sp.I or expr is sp.pi or id(expr) in seen:
            return
        seen.add(id(expr))
        if expr.is_Symbol:
            _check_commutes(expr)
            if not made_before(expr, self._mark):
                raise Unsupported(f"the symbol {expr} has a number by hand")
            symbols.add(expr)
            if outside is not None:
                outside.add(expr)
        elif expr.is_Add or expr.is_Mul:
            for arg in expr.args:
                self._collect(arg, symbols, outside, seen)
        elif self._small is not None and self._expanded(expr, self._small.variable):
            for part in self._series[expr]:
                self._collect(part, symbols, outside, seen)
        elif isinstance(expr, sp.exp) or expr is sp.E:
            if outside is None:  # of a sine of a sine there are more than one may count, or print
                raise Unsupported("an exponential inside an exponent")
            exponent = expr.args[0] if expr.args else sp.S.One
            self._exponents.append(exponent)
            self._inside.append(exponent)
            self._collect(exponent, symbols, None, set())
        elif expr.is_Pow:
            base, power = expr.args
            self._collect(base, symbols, outside, seen)
            if power.is_Integer:
                return
            if power.is_Rational:
                self._radicals.setdefault((base, int(power.q)), sp.Dummy("r"))
                return
            if outside is None:
                raise Unsupported("a symbolic power inside an exponent")
            self._collect(power, symbols, None, set())
            log = self._logs.setdefault(base, sp.Dummy("log"))
            self._exponents.append(power * log)
            self._inside.append(power)
        elif isinstance(expr, Application):
            _check_commutes(expr)
            if expr.has(*_NO_NUMBERS):
                raise Unsupported(f"no normal form for {expr}, of what is no number")
            self._opaque.setdefault(expr, sp.Dummy("f"))
        else:
            _check_commutes(expr)
            raise Unsupported(f"no normal form for {type(expr).__name__}: {expr}")

    def _expanded(self, expr: Expr, small: sp.Symbol) -> bool:
        """Whether a series is taken of a power or a function; refused where there is none."""
        if (expr.is_Pow and expr.args[1].is_Integer) or small not in expr.free_symbols:
            return False
        if not isinstance(expr, sp.exp) and not expr.is_Pow:
            raise Unsupported(f"no series of {type(expr).__name__} of {small}")
        if expr.is_Pow and small in expr.args[0].free_symbols:
            raise Unsupported(f"a root or power of {expr.args[0]}, which depends on {small}")
        exponent = sp.expand(expr.args[-1])
        still, moving = exponent.as_independent(small, as_Add=True)
        if not moving.is_polynomial(small):
            raise Unsupported(f"the exponent {exponent} is no polynomial in {small}")
        if expr.is_Pow:  # a fixed base
            self._series[expr] = expr.args[0] ** still, moving * sp.log(expr.args[0])
        else:
            self._series[expr] = sp.exp(still), moving
        return True

    # -- a basis of the exponents over the rationals, modulo j pi ---------------------

    def _span(self) -> None:
        if not (self._exponents or self._logs):
            self._basis = [(_TURN, {})]
            self._coordinates = {_TURN: {0: Fraction(1)}}
            return
        names = [
            sp.I,
            sp.pi,
            *self._symbols,
            *self._radicals.values(),
            *self._logs.values(),
            *self._opaque.values(),
        ]
        ring = Ring(names)
        ring.relate(sp.I, {0: ring.one, 2: ring.one})
        images: dict[Expr, Fractional] = {}
        seeds = [_TURN, *self._logs.values()]
        common = ring.one
        for exponent in [*seeds, *self._exponents]:
            image = self._image(exponent, ring, None)
            if self._depends(image.den, ring, sp.I):
                raise Unsupported(f"the exponent {exponent} has a complex denominator")
            shared = common.gcd(image.den)
            common = common * (image.den / shared)
            images[exponent] = image
        echelon: list[tuple[tuple[int, ...], Exponents, dict[int, fmpq]]] = []
        for exponent in images:
            image = images[exponent]
            poly = ring.reduce(image.num * (common / image.den))
            vector = poly.to_dict()
            coordinates: dict[int, fmpq] = {}
            for pivot, row, combination in echelon:
                if vector.get(pivot):
                    factor = vector[pivot] / row[pivot]
                    for m, c in row.items():
                        vector[m] = vector.get(m, _ZERO) - factor * c
                    for i, c in combination.items():
                        coordinates[i] = coordinates.get(i, _ZERO) + factor * c
            vector = {m: c for m, c in vector.items() if c}
            if vector:
                index = len(self._basis)
                self._basis.append((exponent, vector))
                combination = {i: -c for i, c in coordinates.items()}
                combination[index] = fmpq(1)
                echelon.append((next(iter(vector)), vector, combination))
                coordinates = {index: fmpq(1)}
            self._coordinates[exponent] = {
                i: Fraction(int(c.p), int(c.q)) for i, c in coordinates.items()
            }

    @staticmethod
    def _depends(poly: fmpq_mpoly, ring: Ring, name: Expr) -> bool:
        if poly.is_constant():
            return False
        index = ring.names.index(name)
        return any(monomial[index] for monomial in poly.to_dict())

    # -- generators and relations -----------------------------------------------------

    def _build(self) -> None:
        used = [self._coordinates[e] for e in self._exponents]
        denominators = [
            lcm(1, *(c[i].denominator for c in used if i in c)) for i in range(len(self._basis))
        ]
        # the roots of unity: exp(j pi p/q) and j itself
        self._turns = self._turns or bool(self._exponents)
        self._order = lcm(4, 2 * denominators[0])
        if self._turns:
            spend(20 * self._order)
        self._zeta = sp.Dummy("zeta")
        self._generator: dict[int, Expr] = {}
        self._denominators = denominators
        names: list[Expr] = [*self._symbols, sp.pi, *self._opaque.values()]
        names += list(self._radicals.values())
        log_of = {log: base for base, log in self._logs.items()}
        for i, (exponent, _) in enumerate(self._basis):
            if i == 0:
                continue
            if exponent in log_of and denominators[i] == 1:
                continue
            self._generator[i] = sp.Dummy(f"g{i}")
            names.append(self._generator[i])
        if self._turns:
            names.append(self._zeta)
        self._ring = ring = Ring(names)
        ring.small = None if self._small is None else names.index(self._small.variable)
        if self._turns:
            ring.turn = names.index(self._zeta), self._order
            cyclotomic = fmpz_poly.cyclotomic(self._order).coeffs()
            ring.relate(
                self._zeta, {i: ring.ctx.constant(fmpq(c)) for i, c in enumerate(cyclotomic) if c}
            )
            ring.folds[names.index(self._zeta)] = self._order // 2, fmpq(-1)
        self._bases: dict[int, Expr] = {}
        for i, (exponent, _) in enumerate(self._basis):
            if exponent in log_of:
                self._bases[i] = log_of[exponent]
        roots = {root: (base, q) for (base, q), root in self._radicals.items()}
        for i, base in self._bases.items():
            if i in self._generator:
                roots[self._generator[i]] = base, denominators[i]
        self._relate_roots(roots)
        for base in self._logs:
            image = self._image(base, ring, self._exponential)
            if ring.reduce(image.num).is_zero():
                raise Unsupported(f"a power of {base}, which is zero")
            self._divide(image.num)
        if self._divides:
            for exponent in self._inside:
                self._image(exponent, ring, self._exponential)
        divisors, self._divisors = self._divisors or [], None
        for divisor in divisors:
            self._divide(divisor)

    def _relate_roots(self, roots: dict[Expr, tuple[Expr, int]]) -> None:
        """The relation of each root, after those of all roots of which its base is made."""
        ring = self._ring
        images = {r: self._image(base, ring, self._exponential) for r, (base, _) in roots.items()}
        while images:
            known = [r for r, image in images.items() if not _holds(image, images, ring)]
            if not known:
                raise Unsupported("roots that are made of each other")
            for root in known:
                image = images.pop(root)
                if ring.reduce(image.num).is_zero():
                    ring.relate(root, {1: ring.one})
                else:
                    ring.relate(root, {0: -image.num, roots[root][1]: image.den})

    def _divide(self, divisor: fmpq_mpoly) -> None:
        """Raise unless a polynomial has an inverse, or put it off until the relations are known."""
        if self._divisors is not None:
            self._divisors.append(divisor)
            return
        reduced = self.reduced(divisor)
        if reduced.is_zero():
            raise Undefined("division by an expression that is identically zero")
        if not self._ring.invertible(reduced):
            raise Unsupported("division by an expression that may be zero for one value of a root")

    def _exponential(self, exponent: Expr) -> Fractional:
        ring = self._ring
        result = Fractional(ring.one, ring.one)
        for i, coordinate in self._coordinates[exponent].items():
            power = coordinate * self._denominators[i]
            if i == 0:
                step = Fraction(self._order, 2) * coordinate
                result *= Fractional(ring.gen[self._zeta] ** int(step % self._order), ring.one)
            elif i in self._generator:
                result *= Fractional(ring.gen[self._generator[i]], ring.one) ** int(power)
            else:
                image = self._image(self._bases[i], ring, self._exponential)
                result *= image ** int(power)
        return result

    # -- the image of an expression ----------------------------------------------------

    def _image(
        self, expr: Expr, ring: Ring, exponential: Callable[[Expr], Fractional] | None
    ) -> Fractional:
        if expr.is_Rational:
            return ring.constant(expr)
        if expr is sp.I and exponential is not None:
            return Fractional(ring.gen[self._zeta] ** (self._order // 4), ring.one)
        if expr.is_Symbol or expr is sp.pi or expr is sp.I:
            return Fractional(ring.gen[expr], ring.one)
        if expr.is_Add:
            known = self._images if exponential is not None else {}
            if expr not in known:
                plain, others = ring.polynomial(expr.args)
                total = Fractional(plain, ring.one)
                for arg in others:
                    total = ring.sum(total, self._image(arg, ring, exponential))
                known[expr] = total
            return known[expr]
        if expr.is_Mul:
            powers, coefficient, others = ring.monomial(expr.args)
            product = Fractional(ring.ctx.from_dict({powers: coefficient}), ring.one)
            for arg in others:
                product = product * self._image(arg, ring, exponential)
            return product
        if expr in self._opaque:
            return Fractional(ring.gen[self._opaque[expr]], ring.one)
        if expr in self._series:
            still, moving = (self._image(part, ring, exponential) for part in self._series[expr])
            return still * self._taylor(moving, ring)
        if isinstance(expr, sp.exp) or expr is sp.E:
            if exponential is None:
                raise Unsupported(f"an exponential inside an exponent: {expr}")
            return exponential(expr.args[0] if expr.args else sp.S.One)
        if expr.is_Pow:
            base, power = expr.args
            if power.is_Integer:
                image = self._image(base, ring, exponential)
                return self._power(image, int(power), ring, exponential is None)
            if power.is_Rational:
                root = self._radicals.get((base, int(power.q)))
                if root is None:  # of an exponent that SymPy has written anew
                    raise Unsupported(f"a root that was not met before: {expr}")
                image = Fractional(ring.gen[root], ring.one)
                return self._power(image, int(power.p), ring, exponential is None)
            if exponential is None:
                raise Unsupported(f"a symbolic power inside an exponent: {expr}")
            return exponential(power * self._logs[base])
        raise Unsupported(f"no normal form for {type(expr).__name__}: {expr}")

    def _taylor(self, moving: Fractional, ring: Ring) -> Fractional:
        """1 + v + v^2/2 + ..., by Horner's rule."""
        assert self._small is not None
        one = total = ring.constant(sp.S.One)
        for k in range(self._small.order - 1, 0, -1):
            total = ring.sum(one, moving * total * ring.constant(sp.Rational(1, k)))
        return total

    def _power(self, image: Fractional, n: int, ring: Ring, inside: bool) -> Fractional:
        """A power; ``inside`` an exponent of which only the divisors' zeros are looked for here."""
        if n < 0 and inside:
            self._divides = True
            if ring.reduce(image.num).is_zero():
                raise Undefined("division by an expression that is identically zero")
        elif n < 0:
            self._divide(image.num)
        return image**n

    def image(self, expr: Expr) -> Fractional:
        """The quotient of polynomials that stands for one of the field's expressions."""
        return self._image(self._exprs[expr], self._ring, self._exponential)

    def reduced(self, poly: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial modulo the field's relations, up to a factor that is not zero."""
        return self._ring.reduce(poly)

    def is_zero(self, expr: Expr) -> bool:
        """Whether the expression vanishes identically (where it is defined)."""
        return bool(self.reduced(self.image(expr).num).is_zero())

    def are_equal(self, left: Expr, right: Expr) -> bool:
        """Whether two of the field's expressions are the same wherever both are defined."""
        ours, theirs = (self._ring.shortened(self.image(side)) for side in (left, right))
        difference = self._ring.sum(ours, Fractional(-theirs.num, theirs.den))
        return bool(self.reduced(difference.num).is_zero())

    def lowest(self, expr: Expr, nonzero: Callable[[Expr], bool]) -> tuple[int, Expr] | None:
        """Order and coefficient of the lowest power of the small variable; None if beyond.

        A coefficient is passed over where its normal form is zero, and taken only where
        ``nonzero`` shows that it is not; else :class:`Unsupported` is raised.
        """
        assert self._small is not None
        variable, upto = self._small.variable, self._small.order
        image = self.image(expr)
        one = self._ring.one
        monic = all(relation[max(relation)] == one for _, relation in self._ring.relations)
        found: list[tuple[int, Expr]] = []
        for poly in (image.num, image.den):
            parts = self._ring.by_power(poly, self._ring.names.index(variable))
            for power in sorted(p for p in parts if p < upto):
                part = self.reduced(parts[power])
                if part.is_zero():
                    continue
                coefficient = self.expression(part if monic else parts[power])
                if not nonzero(coefficient):
                    raise Unsupported(f"cannot tell whether {coefficient} is zero")
                found.append((power, coefficient))
                break
            else:
                return None
        (top, num), (bottom, den) = found
        return top - bottom, num / den

    def expression(self, poly: fmpq_mpoly) -> Expr:
        """A polynomial in the generators, written as a SymPy expression again."""
        back: dict[Expr, Expr] = {v: k for k, v in self._opaque.items()}
        for (base, q), root in self._radicals.items():
            back[root] = sp.Pow(base, sp.Rational(1, q), evaluate=False)
            if not base.free_symbols and back[root] != base ** sp.Rational(1, q):
                raise Unsupported(f"SymPy would choose a branch of {back[root]} by decimals")
        back[self._zeta] = sp.exp(2 * sp.pi * sp.I / self._order)
        for i, g in self._generator.items():
            exponent = self._basis[i][0] / self._denominators[i]
            base = self._bases.get(i)
            back[g] = (
                sp.exp(exponent) if base is None else base ** sp.Rational(1, self._denominators[i])
            )
            for b, log in self._logs.items():
                if exponent.has(log):
                    back[g] = b ** (exponent / log)
        terms = []
        for monomial, value in poly.to_dict().items():
            factors = [
                back.get(name, name) ** int(n)
                for name, n in zip(self._ring.names, monomial, strict=False)
                if n
            ]
            terms.append(rational(value) * sp.Mul(*factors))
        return sp.Add(*terms)

    def generators(self) -> list[Expr]:
        """The field's generators as expressions: symbols, exponentials, roots."""
        logs = {log: base for base, log in self._logs.items()}
        shown: list[Expr] = list(self._outside)
        for i in self._generator:
            exponent = _tidied(self._basis[i][0] / self._denominators[i])
            bases = [base for log, base in logs.items() if exponent.has(log)]
            log = next((log for log in logs if exponent.has(log)), None)
            shown.append(bases[0] ** (exponent / log) if log is not None else sp.exp(exponent))
        # as they stand: SymPy does not get on with a root of a product of 0
        roots = [sp.Pow(base, sp.Rational(1, q), evaluate=False) for base, q in self._radicals]
        return [*shown, *self._opaque, *roots]


@lru_cache(maxsize=1 << 8)
def _tidied(exponent: Expr) -> Expr:
    """An exponent as it is shown, expanded and without a sign in front."""
    if not exponent.is_polynomial():
        exponent = sp.cancel(exponent)
    exponent = sp.expand(exponent)
    return -exponent if exponent.could_extract_minus_sign() else exponent


def _check_commutes(expr: Expr) -> None:
    if not expr.is_commutative:
        raise Unsupported(f"no normal form for {expr}, which does not commute")


def _holds(image: Fractional, names: Iterable[Expr], ring: Ring) -> bool:
    """Whether a quotient contains one of some generators."""
    at = [ring.names.index(name) for name in names]
    return any(poly.degrees()[i] > 0 for poly in (image.num, image.den) for i in at)


def _name(symbol: sp.Symbol) -> str:
    """What a symbol is printed as."""
    return f"_{symbol.name}" if symbol.is_Dummy else str(symbol.name)


def is_zero(expr: Expr) -> bool:
    """Whether an expression vanishes identically, wherever it is defined.

    >>> from sympy.abc import x
    >>> from sympy import sin, cos
    >>> is_zero(sin(x)**2 + cos(x)**2 - 1), is_zero(sin(2*x) - 2*sin(x))
    (True, False)
    """
    expr = sp.sympify(expr, strict=True)
    return Field([expr]).is_zero(expr)
