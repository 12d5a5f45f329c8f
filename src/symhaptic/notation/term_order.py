"""In which order an engineer writes the terms of a sum and the factors of a product."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp
from sympy import Expr

_WRITTEN_FIRST = (
    "N K B k b m a e n_1 n_0 alpha beta gamma delta F F_E x v u Omega c c_1 c_2 c_3 y d "
    "omega omega_hat t T t_d t_e theta phi psi z s"
)
_ORDER = {name: rank for rank, name in enumerate(_WRITTEN_FIRST.split())}
_RANK_IN_SUMS = _ORDER | {"b": -3, "k": -2, "m": -4} | {"a": 50, "e": 51, "n_1": 52, "n_0": 53}
NAMED = {
    sp.sin: r"\sin",
    sp.cos: r"\cos",
    sp.tan: r"\tan",
    sp.cot: r"\cot",
    sp.sinh: r"\sinh",
    sp.cosh: r"\cosh",
    sp.tanh: r"\tanh",
    sp.log: r"\ln",
}
"""Functions with a name of their own in LaTeX."""

_ANGLES = {"omega", "omega_hat", "t", "T", "theta", "phi", "psi", "s"}


def ordered_terms(expr: Expr) -> list[Expr]:
    """The terms of a sum in the order they are written: falling in z, a positive one first."""
    terms = sorted(expr.args, key=_term_key)
    for i, term in enumerate(terms):
        if not term.could_extract_minus_sign():
            return [term, *terms[:i], *terms[i + 1 :]]
    return terms


def factors(expr: Expr) -> tuple[bool, list[Expr], list[Expr]]:
    """Sign, and factors above and below the fraction line, in the order they are written."""
    coefficient, rest = expr.as_coeff_Mul()
    negative = coefficient < 0
    coefficient = abs(coefficient)
    top: list[Expr] = []
    bottom: list[Expr] = []
    for factor in sp.Mul.make_args(rest):
        base, exponent = factor.as_base_exp() if factor.is_Pow else (factor, sp.S.One)
        if factor.is_Pow and exponent.is_Rational and exponent < 0:
            bottom.append(base ** (-exponent))
        elif factor != 1:
            top.append(factor)
    lone_sum = len(top) == 1 and top[0].is_Add and not negative
    if lone_sum and all(t.could_extract_minus_sign() for t in top[0].args):
        negative, top = True, [-top[0]]
    for side, power in ((top, 1), (bottom, -1)):
        for i, factor in enumerate(side):
            if factor.is_Add:
                content, primitive = factor.primitive()
                shared = all(t.as_coeff_Mul()[0].q == content.q for t in factor.args)
                if content.is_Integer or shared:
                    side[i] = primitive
                    coefficient *= content**power
    period = 4 if {sp.Symbol("omega"), sp.Symbol("s")} & set(top) else 2
    top.sort(key=lambda f: _factor_key(f, period))
    bottom.sort(key=lambda f: _factor_key(f, period))
    if coefficient.p != 1 or not top:
        top.insert(0, sp.Integer(coefficient.p))
    if coefficient.q != 1:
        bottom.insert(0, sp.Integer(coefficient.q))
    if len(top) > 1 and top[0] == 1:
        top.pop(0)
    return negative, top, bottom


def base_of(expr: Expr) -> Expr:
    """What is raised to a power."""
    return expr.args[0] if expr.is_Pow else expr


@lru_cache(maxsize=4096)
def _factor_key(expr: Expr, period: int) -> tuple[int, float, str]:
    """Numbers, symbols, sums, angles, functions; the period T is an angle's only beside omega."""
    base = base_of(expr)
    if base.is_Symbol and base.name == "T":
        return (period, _ORDER["T"], "T")
    if base.is_number:
        rank = 0
    elif base.is_Symbol:
        place = _ORDER.get(base.name, 90)
        rank = 6 if base.name == "z" else 4 if base.name in _ANGLES else 2
        return (rank, place, base.name)
    elif base.is_Add:
        rank = 3
    elif isinstance(base, sp.exp):
        rank = 7
    elif base.func in NAMED:
        rank = 5
        return (rank, _weight(base.args[0]), str(base.func))
    else:
        rank = 5
    return (rank, float(len(str(base))), str(base))


@lru_cache(maxsize=4096)
def _term_key(expr: Expr) -> tuple[float, bool, bool, float, tuple[int, ...]]:
    """Falling powers of z (or s), plain terms before quotients, numbers last, then by size."""
    pairs = [factor.as_base_exp() for factor in sp.Mul.make_args(expr)]
    degree, z = 0.0, sp.Symbol("z")
    for base, exponent in pairs:
        if base.is_Symbol and base.name in ("z", "s"):
            sized = {s: sp.Rational(27, 10) for s in exponent.free_symbols}
            degree += float(exponent.subs(sized))
        elif base.is_Add and exponent == 1 and z in base.free_symbols and base.is_polynomial(z):
            degree += float(sp.degree(base, z))
    quotient = any(exponent.could_extract_minus_sign() for _, exponent in pairs)
    functions = expr.atoms(*NAMED, sp.exp)
    if functions:
        size = min(_weight(f.args[0]) for f in functions)
    else:
        size = -10.0 - float(sum(n for base, n in pairs if base.is_Symbol and n.is_Integer))
    names = tuple(sorted(_RANK_IN_SUMS.get(s.name, 90) for s in expr.free_symbols))
    return (-degree, quotient, not expr.free_symbols, size, names)


@lru_cache(maxsize=4096)
def _weight(expr: Expr) -> float:
    """A rough size of an angle, to put d theta before (d+1) theta."""
    values = {s: sp.Rational(13, 10) for s in expr.free_symbols}
    number = expr.subs(values).evalf(6)
    return float(abs(sp.re(number)) + abs(sp.im(number))) if number.is_number else 0.0
