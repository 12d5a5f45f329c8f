"""How Rocq is shown that two terms are equal: which functions are variables, under which relations.

The sines and cosines of sums of angles are written in those of the angles, exponentials likewise;
then both sides are rational functions of variables that obey s^2 = 1 - c^2 and r^2 = x, by which
Rocq's ``ring`` rewrites them to a normal form.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from math import lcm
from typing import TypeAlias

import sympy as sp
from sympy import Expr

from symhaptic.notation.terms import is_complex
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.terms import Names, NotPrinted, complex_, imaginary, real_text

_AS_OTHERS: dict[type[Expr], Callable[[Expr], Expr]] = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sinh: lambda x: (sp.exp(x) - sp.exp(-x)) / 2,
    sp.cosh: lambda x: (sp.exp(x) + sp.exp(-x)) / 2,
    sp.tanh: lambda x: (sp.exp(x) - sp.exp(-x)) / (sp.exp(x) + sp.exp(-x)),
}
_MOST_TURNS = 12

Made: TypeAlias = dict[Expr, list[tuple[Expr, int]]]
"""Angles, or exponents, as sums: units, and how often each stands there."""


class _Parts:
    """Angles and exponents over a basis, and the variables that stand for their functions."""

    def __init__(self, terms: Sequence[Expr]) -> None:
        powers, turns = {sp.S.One for t in terms if t.has(sp.E)}, set[Expr]()
        for exponential in {a for t in terms for a in t.atoms(sp.exp)}:
            size, angle = polar(exponential)
            powers.add(size)
            turns |= {sp.cos(angle), sp.sin(angle)}
        angles = {a.args[0] for t in {*terms, *turns} for a in t.atoms(sp.sin, sp.cos)}
        self.angles = _fewest(_counted(angles, sp.pi / 2))
        self.exponents = _counted(powers, None)
        self.values: dict[Expr, Expr] = {}
        """Variables for the functions of the units."""
        self.made: dict[Expr, Expr] = {}
        """Each function, in the variables."""

    def variable(self, of: Expr) -> Expr:
        if of not in self.values:
            self.values[of] = sp.Dummy(f"v{len(self.values)}")
        return self.values[of]

    def turn(self, angle: Expr) -> tuple[Expr, Expr]:
        """Cosine and sine of an angle, in the variables."""
        c, s = sp.S.One, sp.S.Zero
        for unit, count in _found(angle, self.angles):
            if abs(count) > _MOST_TURNS:
                raise NotPrinted(f"the sine of {count} times an angle")
            known = sp.cos(unit * count), sp.sin(unit * count)
            if not any(value.atoms(sp.sin, sp.cos) for value in known):
                one = self.image(known[0]), self.image(known[1])
            else:
                c1, s1 = self.variable(sp.cos(unit)), self.variable(sp.sin(unit))
                one = _multiple(c1, s1, count)
            c, s = sp.expand(c * one[0] - s * one[1]), sp.expand(s * one[0] + c * one[1])
        return c, s

    def image(self, expr: Expr) -> Expr:
        """A term as a rational function of variables."""
        if expr in self.made:
            return self.made[expr]
        found = self._image(expr)
        self.made[expr] = found
        return found

    def _image(self, expr: Expr) -> Expr:
        if expr.is_Rational or expr.is_Symbol:
            return expr
        if expr in (sp.pi, sp.I):
            return self.variable(expr)
        if isinstance(expr, (sp.sin, sp.cos)):
            c, s = self.turn(expr.args[0])
            return c if isinstance(expr, sp.cos) else s
        if isinstance(expr, sp.exp) and complex_(expr):
            size, angle = polar(expr)
            turn = self.image(sp.cos(angle)) + self.image(sp.I) * self.image(sp.sin(angle))
            return self.image(sp.exp(size)) * turn
        if expr is sp.E or isinstance(expr, sp.exp):
            found = sp.S.One
            for unit, count in _found(_exponent(expr), self.exponents):
                found *= self.variable(sp.exp(unit)) ** count
            return found
        if isinstance(expr, sp.re) and not any(map(is_complex, expr.free_symbols)):
            j = self.image(sp.I)
            whole = sp.rem(sp.expand(self.image(expr.args[0])), j**2 + 1, j)
            return whole.as_independent(j, as_Add=True)[0]
        if expr.is_Add or expr.is_Mul:
            return expr.func(*(self.image(a) for a in expr.args))
        if expr.is_Pow and expr.exp.is_Integer:
            return self.image(expr.base) ** expr.exp
        if expr.is_Pow and expr.exp.is_Rational and expr.exp.q == 2:
            self.image(expr.base)
            return self.variable(sp.sqrt(expr.base)) ** expr.exp.p
        return self.variable(expr)


def _exponent(function: Expr) -> Expr:
    """What a function is of; SymPy has e for exp(1)."""
    return sp.S.One if function is sp.E else function.args[0]


def polar(exponential: Expr) -> tuple[Expr, Expr]:
    """Real and imaginary part of an exponent."""
    exponent = sp.expand(exponential.args[0])
    size, turned = exponent.as_independent(sp.I, as_Add=True)
    angle = sp.expand(-sp.I * turned)
    if complex_(size, angle):
        raise NotPrinted("an exponential of a complex symbol")
    return size, angle


def _counted(of: set[Expr], quarter: Expr | None) -> Made:
    """What each is made of, over one unit for each product of symbols, and how often."""
    parts = {one: _monomials(one) for one in sorted(of, key=str)}
    shares: dict[Expr, list[Expr]] = {}
    for some in parts.values():
        for monomial, share in some.items():
            shares.setdefault(monomial, []).append(share)
    units = {m: m / lcm(*(int(s.q) for s in some)) for m, some in shares.items()}
    if quarter is not None and units.get(sp.pi) in (sp.pi, quarter):
        units[sp.pi] = quarter
    return {
        one: [(units[m], int(n * m / units[m])) for m, n in sorted(some.items(), key=str) if n != 0]
        for one, some in parts.items()
    }


def _found(of: Expr, made: Made) -> list[tuple[Expr, int]]:
    """What one is made of that may be written, or signed, in another way."""
    for known, counts in {of: made[of]}.items() if of in made else made.items():
        for sign in (1, -1):
            if sp.expand(known - sign * of) == 0:
                return [(unit, sign * count) for unit, count in counts]
    raise NotPrinted(f"the argument {of}")


def _fewest(made: Made) -> Made:
    """The same angles, of fewer units: one is added to another as long as that helps.

    a u + b v is (a - b) u + b (u + v). Multiples of pi alone stay what they are.

    >>> u, v = sp.symbols("u v")
    >>> _fewest({2 * (u + v): [(u, 2), (v, 2)], v: [(v, 1)]})
    {2*u + 2*v: [(u + v, 2)], v: [(v, 1)]}
    """
    units = sorted({u for counts in made.values() for u, _ in counts}, key=str)
    counts = {angle: [dict(some).get(u, 0) for u in units] for angle, some in made.items()}
    free = [i for i, u in enumerate(units) if u.free_symbols]

    def less(i: int, j: int, k: int) -> dict[Expr, list[int]]:
        """With k times as many of unit i less as there are of unit j."""
        return {of: [*n[:i], n[i] - k * n[j], *n[i + 1 :]] for of, n in counts.items()}

    ways = [(i, j, k) for i in free for j in free if i != j for k in (1, -1)]
    while ways:
        best = min(ways, key=lambda way: _size(less(*way)))
        if _size(less(*best)) >= _size(counts):
            break
        i, j, k = best
        counts, units[j] = less(i, j, k), sp.expand(units[j] + k * units[i])
    for i in free:
        same = [n[i] * of for of, n in counts.items() if sum(map(abs, n)) == abs(n[i]) == 1]
        units[i] = same[0] if same else units[i]
        if units[i].could_extract_minus_sign():
            counts, units[i] = less(i, i, 2), -units[i]
    return {of: [(u, k) for u, k in zip(units, n, strict=True) if k] for of, n in counts.items()}


def _size(counts: Mapping[Expr, Sequence[int]]) -> int:
    return sum(abs(n) for some in counts.values() for n in some)


def _monomials(of: Expr) -> Mapping[Expr, Expr]:
    """What a sum is made of, with how often; of a quotient the whole part and the rest apart."""
    above, below = sp.fraction(sp.together(of))
    if not below.free_symbols:
        return dict(sp.expand(above / below).as_coefficients_dict())
    number, divisor = sp.expand(below).as_content_primitive()
    number = -number if divisor.could_extract_minus_sign() else number
    below, above, symbols = sp.expand(below / number), above / number, below.free_symbols
    one = len(symbols) == 1 and all(t.is_polynomial(*symbols) for t in (above, below))
    whole, rest = sp.div(above, below, *symbols) if one else (sp.S.Zero, above)
    parts = dict(sp.expand(whole).as_coefficients_dict())
    for monomial, share in sp.expand(rest).as_coefficients_dict().items():
        parts[monomial / below] = parts.get(monomial / below, sp.S.Zero) + share
    return parts


def _multiple(c: Expr, s: Expr, count: int) -> tuple[Expr, Expr]:
    """Cosine and sine of a whole multiple."""
    real, imaginary = sp.S.One, sp.S.Zero
    for _ in range(abs(count)):
        real, imaginary = sp.expand(real * c - imaginary * s), sp.expand(imaginary * c + real * s)
    return real, imaginary if count >= 0 else -imaginary


def plain(expr: Expr) -> Expr:
    """Without tangents, hyperbolic functions and roots of negative numbers."""
    expr = imaginary(expr)
    changes = {f: _AS_OTHERS[f.func](f.args[0]) for f in expr.atoms(*_AS_OTHERS)}
    return plain(expr.xreplace(changes)) if changes else expr


Image = Callable[[Expr], Expr]
PARTS = (
    "repeat match goal with |- context [Re ?z] => let x := eval cbv beta iota zeta delta "
    "[Re fst snd Cmult Cplus Copp Cminus RtoC Ci] in (Re z) in change (Re z) with x end."
)
"""A tactic that writes the real part of a product in the parts of its factors."""


def script(terms: Sequence[Expr], difference: Callable[[Image], Expr], names: Names) -> list[str]:
    """Tactics that show that a difference vanishes, given as it is made of the images of terms.

    What the terms divide by is known not to be zero.
    """
    of_complex = complex_(*terms)
    if _rational(terms, difference):
        return ["Cpushed; Csame_field." if of_complex else "same_field."]
    lines = []
    if any(t.has(*_AS_OTHERS) for t in terms):
        lines.append("unfold tan, cot, sinh, cosh, tanh in *.")
    parts = _Parts([plain(t) for t in terms])
    for t in terms:
        parts.image(plain(t))
    write = complex_text if of_complex else real_text
    names.spelled |= {v: write(f, names) for f, v in parts.values.items()}
    lines += _turned(parts, names) + _expansions(parts, names)
    if not of_complex:
        return [*lines, "by_squares."]
    raised = any(p.exp.free_symbols for t in terms for p in t.atoms(sp.Pow))
    lines += [PARTS] * any(t.has(sp.re) for t in terms)
    lines.append("Clifted; Csums." if raised else "Clifted.")
    rules = _rules(parts, names)
    lines += [rule.replace("{}", f"Sq{i}") for i, rule in enumerate(rules, 1)]
    by = f" [{' '.join(f'Sq{i}' for i in range(1, len(rules) + 1))}]" if rules else ""
    divided = any(sp.denom(p).free_symbols for t in terms for p in sp.Mul.make_args(sp.together(t)))
    ways = [f"solve [ring{by}]", f"solve [field{by}; Cnz]"]
    ways = ways[::-1] if divided else ways
    return [*lines, f"cbn [Cpower]; undivided; first [{' | '.join(ways)}]."]


def same(left: Expr, right: Expr, names: Names) -> list[str]:
    """Tactics that show ``left = right``."""
    return script([left, right], lambda of: of(left) - of(right), names)


_prime = cache(sp.prime)


def _rational(terms: Sequence[Expr], difference: Callable[[Image], Expr]) -> bool:
    """Whether it vanishes with each function for a variable."""
    outer = set[Expr]().union(*(t.atoms(sp.Function, sp.Pow) for t in terms))
    names = {
        f: sp.Dummy()
        for f in outer
        if not (f.is_Pow and not isinstance(f, sp.exp) and f.exp.is_Integer)
    }
    names |= {c: sp.Dummy() for c in (sp.pi, sp.E, sp.I)}
    bare = difference(lambda t: t.xreplace(names))
    symbols = sorted(bare.free_symbols, key=sp.default_sort_key)
    # Rocq decides; here a point with large primes for coordinates tells which tactic to try.
    return bool(bare.xreplace({s: _prime(1000 + 7 * i) for i, s in enumerate(symbols)}) == 0)


def powers_of_few(functions: Sequence[Expr], names: Names) -> list[str]:
    """What real exponentials are as powers of few of them, each with how that is shown."""
    parts = _Parts([f for f in functions if not complex_(f)])
    for f in functions:
        if not complex_(f):
            parts.image(f)
    names.spelled |= {v: real_text(f, names) for f, v in parts.values.items()}
    shown = [line for line in _expansions(parts, names) if line.startswith("assert")]
    return [line.removeprefix("assert (E : ").removesuffix(".") for line in shown]


def _expansions(parts: _Parts, names: Names) -> list[str]:
    """Each function of a sum written in those of its parts."""
    lines = []
    for function, image in parts.made.items():
        if not (isinstance(function, (sp.sin, sp.cos, sp.exp)) or function is sp.E):
            continue
        if complex_(function) or image == parts.values.get(function):
            continue
        turning = isinstance(function, (sp.sin, sp.cos))
        argument = _exponent(function)
        pieces = [
            f"{'(- ' if count < 0 else ''}({real_text(unit, names)}){')' if count < 0 else ''}"
            for unit, count in _found(argument, parts.angles if turning else parts.exponents)
            for _ in range(abs(count))
        ]
        said, wanted = real_text(function, names), real_text(image, names)
        name = said[: said.index("(")]
        sum_ = f"{name} ({' + '.join(pieces) or '0'})"
        lines += [
            f"assert (E : {said} = {wanted}) by by_parts ({sum_}).",
            "rewrite ?E in *; clear E.",
        ]
    return lines


def _turned(parts: _Parts, names: Names) -> list[str]:
    """Each complex exponential by its size and angle."""
    lines = []
    for function in parts.made:
        if isinstance(function, sp.exp) and complex_(function):
            size, angle = polar(function)
            parts_ = [real_text(f, names) for f in (sp.exp(size), sp.cos(angle), sp.sin(angle))]
            at = f"(Cexp_turned _ ({real_text(size, names)}) ({real_text(angle, names)}))"
            wanted = f"({parts_[0]}) * (({parts_[1]}) + Ci * ({parts_[2]}))"
            lines += [
                f"assert (E : ({complex_text(function, names)} = {wanted} :> C)%C) "
                f"by (apply {at}; [Ccompared | Cangle | Cangle | Cangle]).",
                "rewrite ?E in *; clear E.",
            ]
    return lines


def _rules(parts: _Parts, names: Names) -> list[str]:
    """Tactics that show what the square of a complex variable is, under a name left open."""
    found = []
    for function in parts.values:
        if function == sp.I:
            found.append("pose proof Ci_square as {}.")
        elif isinstance(function, sp.sin) and sp.cos(function.args[0]) in parts.values:
            angle = real_text(function.args[0], names)
            found.append(f"pose proof (Csine_square ({angle})) as {{}}.")
        elif function.is_Pow and function.exp == sp.S.Half:
            base, root = complex_text(function.base, names), real_text(function, names)
            as_products = "; cbn [Cpower] in {}" if function.base.has(sp.pi**2) else ""
            found.append(
                f"assert ({{}} : ({root} * {root} = {base} :> C)%C) "
                f"by (apply Croot_square; [rooted | Cpushed; Csame_field]){as_products}."
            )
    return found
