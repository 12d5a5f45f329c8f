"""Certificates checked again, by another and simpler routine than the one that found them.

An expression becomes a short program over balls; every piece is put through it once.
Nothing is searched for, and nothing is shared with the search but the ball arithmetic itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import lru_cache, reduce
from operator import add, mul
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, acb_series, arb, ctx, fmpq
from sympy import Expr

from symhaptic.proof.ball import is_real
from symhaptic.proof.certificate import Balls, Certificate, Given, Largest, Positive, Zero


class Uncheckable(ValueError):
    """An expression for which there is no program."""


class Unconfirmed(ValueError):
    """A certificate that does not show what it says."""


def confirm(certificates: Iterable[Certificate]) -> None:
    """Check each of them again; raises :class:`Unconfirmed`."""
    for certificate in {id(c): c for c in certificates}.values():
        if not recheck(certificate):
            raise Unconfirmed(f"a certificate is not confirmed: {certificate}")


def recheck(certificate: Certificate) -> bool:
    """Whether a certificate shows what it says.

    >>> from symhaptic.proof.box import positive
    >>> x = sp.Symbol("x")
    >>> [certificate] = positive(x**2 - x + sp.Rational(1, 2), {x: (0, 1)}).certificates
    >>> recheck(certificate)
    True
    """
    match certificate:
        case Positive():
            return _positive(certificate)
        case Zero():
            return _zero(certificate)
        case Largest():
            return _largest(certificate)
    raise TypeError(f"recheck: {certificate!r} is no certificate")


def _positive(claim: Positive) -> bool:
    known = set(claim.box) | set(claim.given.meanings if claim.given else ())
    if not claim.expr.free_symbols <= known or (claim.expr.has(sp.I) and not is_real(claim.expr)):
        return False
    with ctx.workprec(claim.bits):
        value = _on(claim)
        pieces = [[(_number(low), _number(high)) for low, high in claim.box.values()]]
        for cut in claim.cuts:
            if not pieces:
                return False
            piece = pieces.pop()
            if cut == ".":
                if not value([low.union(high) for low, high in piece]) > 0:
                    return False
            elif cut == ":":
                if claim.given is not None or not _by_slopes(claim, value, piece) > 0:
                    return False
            elif cut.isdecimal() and int(cut) < len(piece):
                i = int(cut)
                low, high = piece[i]
                middle = ((low + high) / 2).mid()
                pieces.append([*piece[:i], (middle, high), *piece[i + 1 :]])
                pieces.append([*piece[:i], (low, middle), *piece[i + 1 :]])
            else:
                return False
    return not pieces


def _by_slopes(claim: Positive, value: Callable[[list[arb]], arb], piece: list[Interval]) -> arb:
    """The value in the middle, and the slopes from series of first order times the way there."""
    symbols = sorted(claim.expr.free_symbols, key=str)
    run = program(claim.expr, symbols)
    at = dict(zip(claim.box, piece, strict=True))
    total = value([((low + high) / 2).mid() for low, high in piece])
    for moving in symbols:
        series = [
            acb_series([acb(at[s][0].union(at[s][1])), 1 if s == moving else 0], 2) for s in symbols
        ]
        low, high = at[moving]
        total += run(*series)[1].real * (low.union(high) - ((low + high) / 2).mid())
    return total


def _on(claim: Positive) -> Callable[[list[arb]], arb]:
    """The expression as a function of balls of the symbols of its box."""
    own = list(claim.box)
    given = _given(claim.given) if claim.given else lambda balls: {}
    symbols = sorted(claim.expr.free_symbols, key=str)
    run, complex_parts = program(claim.expr, symbols), claim.expr.has(sp.I)

    def value(at: list[arb]) -> arb:
        balls = {s: acb(x) for s, x in zip(own, at, strict=True)}
        balls |= given(balls)
        found = run(*(balls[s] for s in symbols))
        real = found.imag.contains(0) if complex_parts else found.imag.is_zero()
        return found.real if real else arb("nan")

    return value


def _given(given: Given) -> Callable[[Balls], Balls]:
    """Balls of further symbols, computed once for an interval of those they depend on."""
    needs = {s: sorted(expr.free_symbols, key=str) for s, expr in given.meanings.items()}
    programs = {s: program(expr, needs[s]) for s, expr in given.meanings.items()}
    known: dict[tuple[object, ...], Balls] = {}

    def values(balls: Balls) -> Balls:
        ends = [end for s in given.of for end in (balls[s].real.lower(), balls[s].real.upper())]
        key = tuple(end.man_exp() for end in ends)
        if key not in known:
            basis = {**balls, **given.numbers(balls)}
            known[key] = {s: run(*(basis[x] for x in needs[s])) for s, run in programs.items()}
        return known[key]

    return values


def _zero(claim: Zero) -> bool:
    with ctx.workprec(claim.bits):
        run = program(claim.expr, [claim.variable, *claim.at])
        others = [acb(x) if isinstance(x, (acb, arb)) else _value(x) for x in claim.at.values()]
        low, high = (_number(end) for end in claim.between)
        found = claim.ball
        if not (found.lower() >= low.upper() and found.upper() <= high.lower()):
            return False
        values = [run(acb(end), *others) for end in (found.lower(), found.upper())]
        if not all(value.imag.is_zero() for value in values):
            return False
        ends = [value.real for value in values]
        if not ((ends[0] > 0 and ends[1] < 0) or (ends[0] < 0 and ends[1] > 0)):
            return False
        still = [acb_series([x], 2) for x in others]
        slope = run(acb_series([low.union(high), 1], 2), *still)[1].real
        return bool(slope > 0 or slope < 0)


def _largest(claim: Largest) -> bool:
    """The bound from above is of the same expression, and a value of the box reaches the other."""
    below = claim.below
    if below.expr != claim.upper - claim.expr or set(claim.where) != set(below.box):
        return False
    with ctx.workprec(below.bits):
        point = [_number(claim.where[s]) for s in below.box]
        for x, (low, high) in zip(point, below.box.values(), strict=True):
            if not (x >= _number(low) and x <= _number(high)):
                return False
        reached = _on(replace(below, expr=claim.expr))(point)
        return bool(reached >= _number(claim.lower)) and _positive(below)


# -- programs ------------------------------------------------------------------------------


Interval: TypeAlias = tuple[arb, arb]

Ball: TypeAlias = acb | acb_series
"""A ball, or the first terms of a series with such coefficients."""


def _sum(*terms: Ball) -> Ball:
    return reduce(add, terms)


def _product(*factors: Ball) -> Ball:
    return reduce(mul, factors)


def _sinh(x: Ball) -> Ball:
    return x.sinh() if isinstance(x, acb) else (x.exp() - (-x).exp()) / 2


def _cosh(x: Ball) -> Ball:
    return x.cosh() if isinstance(x, acb) else (x.exp() + (-x).exp()) / 2


def _tanh(x: Ball) -> Ball:
    return x.tanh() if isinstance(x, acb) else _sinh(x) / _cosh(x)


def _cot(x: Ball) -> Ball:
    return x.cot() if isinstance(x, acb) else x.cos() / x.sin()


def _power(x: Ball, y: Ball) -> Ball:
    return x.pow(y) if isinstance(x, acb) and isinstance(y, acb) else (x.log() * y).exp()


def _plain(function: Callable[[acb], acb]) -> Callable[[Ball], Ball]:
    """A function that has no series."""

    def apply(x: Ball) -> Ball:
        if not isinstance(x, acb):
            raise Uncheckable("a slope of a function that has none")
        return function(x)

    return apply


_CALLS: dict[type, Callable[..., Ball]] = {
    sp.Add: _sum,
    sp.Mul: _product,
    sp.exp: lambda x: x.exp(),
    sp.sin: lambda x: x.sin(),
    sp.cos: lambda x: x.cos(),
    sp.tan: lambda x: x.tan(),
    sp.cot: _cot,
    sp.sinh: _sinh,
    sp.cosh: _cosh,
    sp.tanh: _tanh,
    sp.Abs: _plain(lambda x: acb(abs(x))),
    sp.re: _plain(lambda x: acb(x.real)),
    sp.im: _plain(lambda x: acb(x.imag)),
    sp.conjugate: _plain(lambda x: acb(x.real, -x.imag)),
}


def _value(number: Expr) -> acb:
    """A number in a ball of the precision in force."""
    found: acb = program(sp.sympify(number), [])()
    return found


def _number(number: Expr) -> arb:
    """A real number in a ball."""
    return _value(number).real


def program(expr: Expr, symbols: Sequence[Expr]) -> Callable[..., Any]:
    """A function of balls or of their series, each subexpression computed once.

    >>> x = sp.Symbol("x")
    >>> print(program(sp.sin(x)**2 + 1, [x])(acb(0)).real)
    1.00000000000000
    """
    return _program(expr, tuple(symbols), ctx.prec)


@lru_cache(maxsize=1024)
def _program(expr: Expr, symbols: tuple[Expr, ...], bits: int) -> Callable[..., Any]:
    """The same for the precision in force, in which its numbers are."""
    place: dict[Expr, int] = {symbol: i for i, symbol in enumerate(symbols)}
    steps: list[tuple[Callable[..., Ball], tuple[int, ...]]] = []

    def put(part: Expr) -> int:
        if part not in place:
            operation, operands = _operation(part)
            at = tuple(put(operand) for operand in operands)
            place[part] = len(symbols) + len(steps)
            steps.append((operation, at))
        return place[part]

    last = put(expr)

    def run(*values: Ball) -> Ball:
        known = list(values)
        for operation, at in steps:
            known.append(operation(*[known[i] for i in at]))
        return known[last]

    return run


def _operation(part: Expr) -> tuple[Callable[..., Ball], tuple[Expr, ...]]:
    """What is done, and to which parts."""
    if part.is_Rational:
        number = acb(fmpq(int(part.p), int(part.q)))
        return lambda: number, ()
    if part is sp.pi:
        pi = acb(arb.pi())
        return lambda: pi, ()
    if part is sp.E:
        number = acb(1).exp()
        return lambda: number, ()
    if part is sp.I:
        return (lambda: acb(0, 1)), ()
    if part.is_Pow and part.args[1].is_Integer:
        power = int(part.args[1])
        return (lambda x: x**power), (part.args[0],)
    if part.is_Pow and part.args[1] == sp.Rational(1, 2):
        return (lambda x: x.sqrt()), (part.args[0],)
    if part.is_Pow:
        return _power, part.args
    if part.func in _CALLS:
        return _CALLS[part.func], part.args
    raise Uncheckable(f"no program for {type(part).__name__}: {part}")
