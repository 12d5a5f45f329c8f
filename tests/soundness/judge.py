"""What a formula is worth at a point, by mpmath and the tree alone: none of our own arithmetic."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

DIGITS = 50
NEAR = mpmath.mpf(10) ** -30


class Undefined(ArithmeticError):
    """Not defined at the point."""


class Unclear(ArithmeticError):
    """Next to a branch cut or a pole, where rounding decides."""


FUNCTIONS = {
    sp.exp: mp.exp,
    sp.sin: mp.sin,
    sp.cos: mp.cos,
    sp.tan: mp.tan,
    sp.cot: mp.cot,
    sp.sinh: mp.sinh,
    sp.cosh: mp.cosh,
    sp.tanh: mp.tanh,
    sp.re: mp.re,
    sp.im: mp.im,
    sp.Abs: abs,
    sp.conjugate: mp.conj,
    sp.log: mp.log,
    sp.asin: mp.asin,
    sp.acos: mp.acos,
    sp.atan: mp.atan,
    sp.acosh: mp.acosh,
    sp.asinh: mp.asinh,
    sp.atanh: mp.atanh,
    sp.LambertW: mp.lambertw,
    sp.gamma: mp.gamma,
    sp.sign: mp.sign,
    sp.coth: mp.coth,
    sp.atan2: mp.atan2,
    sp.arg: mp.arg,
}
CUT = (
    sp.log,
    sp.asin,
    sp.acos,
    sp.atan,
    sp.acosh,
    sp.asinh,
    sp.atanh,
    sp.LambertW,
    sp.sign,
    sp.arg,
)


def value(expr, at: Mapping, unknown=None):
    """Its value where symbols are numbers (by name), and unknown functions are ``unknown``."""
    with mp.workdps(DIGITS + 20):
        found = _value(expr, at, unknown)
        if not mp.isfinite(found):
            raise Undefined(str(expr))
        return found


def truth(relation, at: Mapping, unknown=None) -> bool:
    """Whether a relation holds; Unclear where its sides are about equal."""
    if relation in (sp.true, sp.false):
        return bool(relation)
    left, right = (value(side, at, unknown) for side in relation.args)
    equal = close(left, right)
    if isinstance(relation, (sp.Eq, sp.Ne)):
        if equal and left != right:
            raise Unclear(str(relation))
        return equal == isinstance(relation, sp.Eq)
    for side in (left, right):
        if not is_real(side):
            raise Undefined(f"{side} has no order")
    if equal and left != right:
        raise Unclear(str(relation))
    return bool(relation.func(sp.sign(sp.Float(mp.nstr(mp.re(left - right), 20))), 0))


def is_real(number) -> bool:
    return abs(mp.im(number)) <= NEAR * (1 + abs(number))


def close(one, other) -> bool:
    with mp.workdps(DIGITS + 20):
        return abs(one - other) <= NEAR * (1 + abs(one) + abs(other))


def alike(left, right, at: Mapping, unknown=None) -> bool:
    """Whether two expressions or relations say the same at a point."""
    if isinstance(left, Relational) or isinstance(right, Relational):
        return truth(left, at, unknown) == truth(right, at, unknown)
    return close(value(left, at, unknown), value(right, at, unknown))


def _value(expr, at, unknown):
    if expr.is_Symbol:
        return mp.mpmathify(at[expr.name])
    if expr.is_Rational:
        return mp.mpf(int(expr.p)) / int(expr.q)
    if expr is sp.I:
        return mp.mpc(0, 1)
    if expr is sp.pi:
        return +mp.pi
    if expr is sp.E:
        return +mp.e
    if not expr.args:
        raise Undefined(str(expr))
    args = [_value(a, at, unknown) for a in expr.args]
    if not all(map(mp.isfinite, args)):
        raise Undefined(str(expr))
    try:
        if expr.is_Add:
            total = mp.fsum(args)
            if total != 0 and abs(total) < NEAR * max(map(abs, args)):
                raise Unclear(str(expr))  # a zero, by all that rounding tells
            return total
        if expr.is_Mul:
            return mp.fprod(args)
        if expr.is_Pow:
            return _power(*args, whole=expr.args[1].is_Integer)
        if isinstance(expr, AppliedUndef):
            return unknown(expr.func.__name__, args)
        if isinstance(expr, CUT):
            _clear(args[0])
        return FUNCTIONS[expr.func](*args)
    except (ZeroDivisionError, OverflowError, ValueError) as wrong:
        raise Undefined(str(expr)) from wrong


def _power(base, power, whole):
    if base == 0:
        if power == 0:
            return mp.mpf(1)
        if mp.re(power) <= 0:
            raise Undefined("0 to a power that is not positive")
        return mp.mpf(0)
    if whole:
        return base ** int(mp.nint(mp.re(power)))
    _clear(base)
    return mp.power(base, power)


def _clear(number) -> None:
    imag = mp.im(number)
    if imag != 0 and abs(imag) <= NEAR * abs(number):
        raise Unclear(str(number))
