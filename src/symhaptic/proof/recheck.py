"""Certificates checked again, by another and simpler routine than the one that found them.

Every piece is put once through the program that an expression becomes, and nothing is searched for.
That program is shared with the search; a test holds it against :func:`symhaptic.proof.ball.ball`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, acb_series, arb, ctx
from sympy import Expr

from symhaptic.notation.terms import symbols_in
from symhaptic.proof.ball import is_real
from symhaptic.proof.certificate import (
    Balls,
    Box,
    Certificate,
    Given,
    Known,
    Largest,
    Positive,
    Zero,
)
from symhaptic.proof.plants import Named
from symhaptic.proof.program import CALLS, Uncheckable, program, real, value
from symhaptic.proof.rewriting import Undefined, Unsupported

Interval: TypeAlias = tuple[arb, arb]
Numbers: TypeAlias = Callable[[Balls], Balls]
"""Balls of further symbols, for balls of those of a box."""

_BITS = 1 << 20
"""Certificates of a higher precision are not looked at."""


_NOT_COMPUTED = (
    *(Uncheckable, Unsupported, Undefined, sp.SympifyError, RecursionError),
    ZeroDivisionError,  # SymPy's, of a number that nobody has evaluated
)
"""What is raised where there is nothing to be computed."""


class Unconfirmed(ValueError):
    """A certificate that does not show what it says."""


def confirm(certificates: Iterable[Certificate]) -> None:
    """Check each of them again; raises :class:`Unconfirmed`."""
    for certificate in {id(c): c for c in certificates}.values():
        if not recheck(certificate):
            raise Unconfirmed(f"a certificate is not confirmed: {certificate}")


def recheck(certificate: Certificate) -> bool:
    """Check a certificate again, by a second and simpler routine.

    Parameters
    ----------
    certificate : Certificate
        The ``certificate`` of a :class:`symhaptic.Verdict`, or what
        :func:`symhaptic.enclose_maximum` returns.

    Returns
    -------
    bool
        Whether the certificate proves its claim.

    Examples
    --------
    >>> from symhaptic.proof.box import positive
    >>> x = sp.Symbol("x")
    >>> recheck(positive(x**2 - x + sp.Rational(1, 2), {x: (0, 1)}))
    True
    """
    if type(certificate) not in _CHECKS:
        raise TypeError(f"recheck: {certificate!r} is no certificate")
    try:
        return _plain(certificate) and _CHECKS[type(certificate)](certificate)
    except _NOT_COMPUTED:
        return False


_NUMBERS = (int, Fraction, arb, acb)

_PARTS = frozenset({
    *(sp.Symbol, sp.Dummy, sp.Add, sp.Mul, sp.Pow, *CALLS, sp.Integer, sp.Rational),
    *map(type, (sp.S.Zero, sp.S.One, sp.S.NegativeOne, sp.S.Half, sp.pi, sp.E, sp.I)),
})  # fmt: skip
"""Classes for which there is a program.  An object of another class may return other parts each
time it is asked."""


def _plain(claim: Any) -> bool:
    """Whether a certificate is made of formulas, numbers and symbols, and of no other classes."""
    match claim:
        case Positive():
            sides, given = claim.defined, claim.given
            return (
                type(claim.cuts) is str
                and type(claim.bits) is int
                and isinstance(sides, tuple)
                and all(map(_formula, (claim.expr, *sides)))
                and type(claim.box) is dict
                and all(map(_symbol, claim.box))
                and all(map(_pair, claim.box.values()))
                and (given is None or _means_numbers(given, claim.box))
            )
        case Zero():
            return (
                type(claim.ball) is arb
                and type(claim.bits) is int
                and _formula(claim.expr)
                and _pair(claim.between)
                and type(claim.at) is dict
                and all(map(_symbol, (claim.variable, *claim.at)))
                and all(map(_number, claim.at.values()))
            )
    return (
        type(claim.below) is Positive
        and _plain(claim.below)
        and all(map(_formula, (claim.expr, claim.lower, claim.upper)))
        and type(claim.where) is dict
        and all(map(_symbol, claim.where))
        and all(map(_number, claim.where.values()))
    )


def _formula(of: Any) -> bool:
    left, seen = [of], set[int]()
    while left:
        part = left.pop()
        if type(part) not in _PARTS:
            return False
        if id(part) not in seen:
            seen.add(id(part))
            left += part.args
    return True


def _number(of: Any) -> bool:
    return type(of) in _NUMBERS or _formula(of)


def _symbol(of: Any) -> bool:
    return type(of) in (sp.Symbol, sp.Dummy)


def _pair(of: Any) -> bool:
    return type(of) is tuple and len(of) == 2 and all(map(_number, of))


def _means_numbers(given: Any, box: Box) -> bool:
    """Whether symbols mean expressions in what has a ball on a box."""
    if type(given) is Known:
        balls = given.balls
        return (
            type(balls) is dict
            and all(map(_symbol, balls))
            and all(type(ball) is arb for ball in balls.values())
            and not given.of
        )
    return (
        type(given) is Named
        and type(given.meanings) is dict
        and all(map(_symbol, given.meanings))
        and all(map(_formula, given.meanings.values()))
        and set(given.of) <= set(box)
    )


def _positive(claim: Positive) -> bool:
    if not _sound(claim):
        return False
    with ctx.workprec(claim.bits):
        given = _given(claim.given)
        value, *sides = (_on(expr, claim.box, given) for expr in (claim.expr, *claim.defined))
        whole = [_interval(ends) for ends in claim.box.values()]
        if None in whole:
            return False
        pieces = [[interval for interval in whole if interval]]
        for cut in claim.cuts:
            if not pieces:
                return False
            piece = pieces.pop()
            wide = [low.union(high) for low, high in piece]
            if cut in (".", ":") and not all(side(wide).is_finite() for side in sides):
                return False
            if cut == ".":
                if not value(wide) > 0:
                    return False
            elif cut == ":":
                if claim.given is not None or not value(wide).is_finite():
                    return False
                if not _by_slopes(claim, value, piece) > 0:
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


def _sound(claim: Positive) -> bool:
    """Whether it speaks of real numbers, of which the box alone says where they lie."""
    meanings = claim.given.meanings if claim.given else {}
    known = set(claim.box) | set(meanings)
    return (
        _sensible(claim.bits)
        and not set(claim.box) & set(meanings)
        and all(
            isinstance(expr, Expr)
            and symbols_in(expr) <= known
            and (not expr.has(sp.I) or is_real(expr))
            for expr in (claim.expr, *claim.defined)
        )
    )


def _sensible(bits: int) -> bool:
    return isinstance(bits, int) and 2 <= bits <= _BITS


def _interval(ends: tuple[Expr, Expr]) -> Interval | None:
    """Its ends in balls; None where they are not real numbers, or in the wrong order."""
    low, high = (value(end) for end in ends)
    for end in (low, high):
        if not (end.is_finite() and end.imag.is_zero()):
            return None
    return None if low.real > high.real else (low.real, high.real)


def _by_slopes(claim: Positive, value: Callable[[list[arb]], arb], piece: list[Interval]) -> arb:
    """The value in the middle, and the slopes from series of first order times the way there."""
    symbols = sorted(symbols_in(claim.expr), key=str)
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


def _on(expr: Expr, box: Box, given: Numbers) -> Callable[[list[arb]], arb]:
    """An expression as a function of balls of the symbols of a box."""
    symbols = sorted(symbols_in(expr), key=str)
    run, complex_parts = program(expr, symbols), expr.has(sp.I)

    def value(at: list[arb]) -> arb:
        balls = {s: acb(x) for s, x in zip(box, at, strict=True)}
        balls |= given(balls)
        found = run(*(balls[s] for s in symbols))
        real = found.imag.contains(0) if complex_parts else found.imag.is_zero()
        return found.real if real and found.is_finite() else arb("nan")

    return value


def _given(given: Given | None) -> Numbers:
    """Balls of further symbols, computed once for an interval of those they depend on."""
    if given is None:
        return lambda balls: {}
    needs = {s: sorted(symbols_in(expr), key=str) for s, expr in given.meanings.items()}
    programs = {s: program(expr, needs[s]) for s, expr in given.meanings.items()}
    known: dict[tuple[object, ...], Balls] = {}
    made = {*given.of, *(s for some in needs.values() for s in some)}

    def values(balls: Balls) -> Balls:
        of = (balls[s].real for s in balls if s in made)
        ends = [end for x in of for end in (x.lower(), x.upper())]
        key = tuple(end.man_exp() for end in ends)
        if key not in known:
            numbers = given.numbers(balls)
            if set(numbers) & set(balls):
                raise Uncheckable("a symbol of the box is given a number as well")
            basis = {**balls, **numbers}
            known[key] = {s: run(*(basis[x] for x in needs[s])) for s, run in programs.items()}
        return known[key]

    return values


def _zero(claim: Zero) -> bool:
    # of anything but symbols the expression would be taken for another one
    symbols = all(isinstance(s, sp.Symbol) for s in (claim.variable, *claim.at))
    if claim.variable in claim.at or not symbols or not _sensible(claim.bits):
        return False
    with ctx.workprec(claim.bits):
        run = program(claim.expr, [claim.variable, *claim.at])
        others = [acb(x) if isinstance(x, (acb, arb)) else value(x) for x in claim.at.values()]
        between = _interval(claim.between)
        if between is None:
            return False
        low, high = between
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
        slope = run(acb_series([low.union(high), 1], 2), *still)[1]
        return bool(slope.imag.is_zero() and (slope.real > 0 or slope.real < 0))


def _largest(claim: Largest) -> bool:
    """The bound from above is of the same expression, and a value of the box reaches the other."""
    if any(not isinstance(x, Expr) or x.free_symbols for x in (claim.upper, claim.lower)):
        return False
    below = replace(claim.below, defined=(*claim.below.defined, claim.expr))
    if below.expr != claim.upper - claim.expr or set(claim.where) != set(below.box):
        return False
    if not _positive(below):
        return False
    with ctx.workprec(below.bits):
        numbers = [value(claim.where[s]) for s in below.box]
        if not all(x.imag.is_zero() for x in numbers):
            return False
        point = [x.real for x in numbers]
        for x, (s, (low, high)) in zip(point, below.box.items(), strict=True):
            at = claim.where[s]
            if not ((at == low or x >= real(low)) and (at == high or x <= real(high))):
                return False
        reached = _on(claim.expr, below.box, _given(below.given))(point)
        lower = value(claim.lower)
        return bool(lower.imag.is_zero() and reached >= lower.real)


_CHECKS: dict[type, Callable[[Any], bool]] = {
    Positive: _positive, Zero: _zero, Largest: _largest,
}  # fmt: skip
