"""Inequalities and maxima on a whole box of parameters, by ball arithmetic on ever smaller pieces.

A ball around the middle of a piece, as wide as the piece, goes through the expression and comes
out as a ball that contains all its values there.  Near a value that is hardly positive the mean
value theorem does better: the value in the middle, and the slopes times the way from there.  A
piece that neither decides is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from heapq import heappop, heappush

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr

from symhaptic.notation.terms import symbols_in
from symhaptic.proof.ball import ball, is_real
from symhaptic.proof.budget import size_of
from symhaptic.proof.certificate import Box, Given, Largest, Positive
from symhaptic.proof.derivative import derivative
from symhaptic.proof.points import Point
from symhaptic.proof.program import WITHOUT_SERIES, Uncheckable, program
from symhaptic.proof.recheck import recheck
from symhaptic.proof.rewriting import Unsupported

_BITS = 96
"""Working precision."""

_PIECES = 100_000
"""So many are tried before giving up."""

_DEPTH = 160
"""So often a piece is halved across each symbol; narrower ones tell nothing at this precision."""

_SYMBOLS = 10
"""So many have a digit in a certificate."""

_WORK = 10_000_000
"""So many operations are done before giving up, whatever the number of pieces."""

_PATIENCE = 32
"""So many pieces are halved before the slopes, which are dear, are asked."""

Interval = tuple[arb, arb]
Piece = tuple[Interval, ...]
"""An interval for each symbol of the box, in its order."""

Value = Callable[[Sequence[arb]], arb]
"""Balls of an expression's values, from balls of the box's symbols."""


class NotShown(ValueError):
    """An inequality or a bound that ball arithmetic does not show."""


class Exhausted(NotShown):
    """Too many pieces, or too much work."""


@dataclass
class _Work:
    """Counts what is done for one question."""

    left: int

    def spend(self, operations: int) -> None:
        self.left -= operations
        if self.left < 0:
            raise Exhausted("too much work")


@dataclass(frozen=True)
class Denied:
    """A point of the box where the expression is not positive."""

    point: Point
    touches: bool
    """Whether it may be zero there."""


def positive(expr: Expr, box: Box, given: Given | None = None) -> Positive:
    """A certificate that ``expr > 0`` on the box; ``given`` finds balls of its other symbols there.

    Raises :class:`NotShown` where a piece has a value that is not positive, or where the pieces
    become too many.  The expression must be written so that balls see its values: an interval may
    not meet a division by zero, removable or not, and no root of a negative number; one with an
    imaginary unit is real by its normal form.

    >>> x = sp.Symbol("x")
    >>> positive(x**2 - x + sp.Rational(1, 2), {x: (0, 1)}).pieces
    5
    """
    found = search(expr, box, given)
    if found is None:
        raise NotShown(f"{expr}: undecided, for it needs too many pieces")
    if isinstance(found, Denied):
        near = ", ".join(f"{s} = {float(v):.6g}" for s, v in found.point.items())
        raise NotShown(f"{expr} is not positive for {near}")
    return found


def search(
    expr: Expr,
    box: Box,
    given: Given | None = None,
    defined: tuple[Expr, ...] = (),
    steps: int = _WORK,
) -> Positive | Denied | None:
    """A certificate that ``expr > 0`` on the box, a point that denies it, or neither.

    Wherever it is positive, the expression and all that is to be ``defined`` has real values.
    """
    try:
        return _search(sp.sympify(expr, strict=True), box, given, defined, _Work(steps))
    except Exhausted:
        return None


def _search(
    expr: Expr, box: Box, given: Given | None, defined: tuple[Expr, ...], work: _Work
) -> Positive | Denied:
    with ctx.workprec(_BITS):
        value, slopes = _values(expr, box, given, work), _slopes(expr, box, given, work)
        sides = [_values(side, box, given, work) for side in defined]
        pieces, cuts, tried = [(_whole(box), 0)], "", 0
        while pieces:
            piece, depth = pieces.pop()
            wide = _wide(piece)
            plain = value(wide)
            certain = all(side(wide).is_finite() for side in sides)
            if certain and plain > 0:
                cuts += "."
                continue
            middle = [_middle(interval) for interval in piece]
            there = value(middle)
            sloped = certain and tried >= _PATIENCE and plain.is_finite()
            if sloped and there + _away(piece, middle, slopes) > 0:
                cuts += ":"
                continue
            if _inside(box, middle):
                if sides and not all(side(middle).is_finite() for side in sides):
                    raise Exhausted("a side is not defined or not real in the middle of a piece")
                if there <= 0:
                    return Denied(_point(box, middle), touches=not there < 0)
            tried += 1
            if tried >= _PIECES or depth >= _DEPTH * len(piece):
                raise Exhausted("too many pieces, or too narrow ones")
            across = _best(piece, middle, value)
            cuts += str(across)
            halves = _halved(piece, across, middle[across])
            pieces += [(half, depth + 1) for half in reversed(halves)]
    return Positive(expr, dict(box), cuts, _BITS, given, defined)


def maximum(
    expr: Expr, box: Box, radius: Expr, given: Given | None = None, steps: int = _WORK
) -> Largest:
    """The largest value on a box between two bounds not further apart than ``radius``.

    Branch and bound: the piece with the largest bound is halved until no piece can exceed the best
    value found by more than half the radius.  Raises :class:`NotShown` where the pieces become too
    many.

    >>> x = sp.Symbol("x")
    >>> found = maximum(x*(1 - x), {x: (0, 1)}, sp.Rational(1, 1000))
    >>> found.lower <= sp.Rational(1, 4) <= found.upper, found.where
    (True, {x: 1/2})
    """
    expr = sp.sympify(expr, strict=True)
    with ctx.workprec(_BITS):
        work = _Work(steps)
        value, slopes = _values(expr, box, given, work), _slopes(expr, box, given, work)
        near = ball(sp.sympify(radius, strict=True), None, _BITS).real / 2
        best, where = arb("-inf"), [_middle(interval) for interval in _whole(box)]
        heap: list[tuple[float, int, int, Piece]] = []
        pieces, count, depth = [_whole(box)], 0, 0
        while True:
            for piece in pieces:
                middle = [_middle(interval) for interval in piece]
                there = value(middle)
                if there.lower() > best and _inside(box, middle):
                    best, where = there.lower(), middle
                plain = value(_wide(piece))
                above = plain.upper()
                sloped = count >= _PATIENCE and plain.is_finite()
                if sloped and not above <= best + near:
                    above = above.min((there + _away(piece, middle, slopes)).upper())
                if not above <= best + near:
                    count += 1
                    first = -float(above) if above.is_finite() else -float("inf")
                    heappush(heap, (first, count, depth, piece))
            if not heap:
                break
            _, _, depth, piece = heappop(heap)
            if count >= _PIECES or depth >= _DEPTH * len(piece):
                raise NotShown(f"{expr}: no maximum after {count} pieces")
            depth += 1
            middle = [_middle(interval) for interval in piece]
            across = _best(piece, middle, value)
            low, high = piece[across]
            if not low < middle[across] < high:
                near = ", ".join(f"{s} = {float(m):.6g}" for s, m in zip(box, middle, strict=True))
                raise NotShown(f"{expr}: no maximum to so many digits next to {near}")
            pieces = _halved(piece, across, middle[across])
        lower, upper = _exact(best), _exact(best + near * 1.5)
    below = search(upper - expr, box, given, steps=steps)
    if not isinstance(below, Positive):
        raise NotShown(f"{expr}: the bound {upper} is not shown")
    found = Largest(expr, below, _point(box, where), lower, upper)
    if not recheck(found):
        raise NotShown(f"{expr}: the bounds {lower} and {upper} are not confirmed")
    return found


def _values(expr: Expr, box: Box, given: Given | None, work: _Work) -> Value:
    unbound = symbols_in(expr) - set(box)
    if unbound and given is None:
        raise NotShown(f"the box has no interval for {', '.join(sorted(map(str, unbound)))}")
    if len(box) > _SYMBOLS:
        raise NotShown(f"a box of {len(box)} symbols; give at most {_SYMBOLS}")
    complex_parts = expr.has(sp.I)
    if complex_parts and not is_real(expr):
        raise NotShown(f"{expr} is not shown to be real")

    size, symbols = size_of(expr), sorted(symbols_in(expr), key=str)
    try:
        run = program(expr, symbols)
    except Uncheckable as wrong:
        raise Unsupported(str(wrong)) from None

    def value(at: Sequence[arb]) -> arb:
        work.spend(size)
        values = dict(zip(box, map(acb, at), strict=True))
        further = given(values) if given else {}
        if not further.keys().isdisjoint(values):
            raise NotShown("a symbol of the box is given a meaning as well")
        if not further.keys() >= unbound:
            raise Unsupported(f"no ball for {', '.join(sorted(map(str, unbound)))}")
        values.update(further)
        found = run(*(acb(values[s]) for s in symbols))
        real = found.imag.contains(0) if complex_parts else found.imag.is_zero()
        return found.real if real and found.is_finite() else arb("nan")

    return value


def _slopes(expr: Expr, box: Box, given: Given | None, work: _Work) -> Callable[[], list[Value]]:
    """The derivatives, found when they are first asked for."""

    @cache
    def slopes() -> list[Value]:
        return [_values(derivative(expr, s), box, None, work) for s in box]

    return (lambda: []) if given or expr.has(*WITHOUT_SERIES) else slopes


def _away(piece: Piece, middle: Sequence[arb], slopes: Callable[[], list[Value]]) -> arb:
    """A ball of what values in a piece differ by from that in its middle."""
    if not slopes():
        return arb("nan")
    wide = _wide(piece)
    steps = (x - m for x, m in zip(wide, middle, strict=True))
    return sum((f(wide) * step for f, step in zip(slopes(), steps, strict=True)), arb(0))


def _wide(piece: Piece) -> list[arb]:
    return [low.union(high) for low, high in piece]


def _whole(box: Box) -> Piece:
    return tuple((_number(low), _number(high)) for low, high in box.values())


def _number(value: Expr) -> arb:
    return ball(sp.sympify(value, strict=True), None, _BITS).real


def _best(piece: Piece, middle: Sequence[arb], value: Value) -> int:
    """The number of the symbol without whose width the value is known best."""

    def left(i: int) -> float:
        wide = _wide(piece)
        found = value([*wide[:i], middle[i], *wide[i + 1 :]])
        return float(found.rad()) if found.is_finite() else float("inf")

    return min(range(len(piece)), key=left) if len(piece) > 1 else 0


def _halved(piece: Piece, across: int, middle: arb) -> list[Piece]:
    low, high = piece[across]
    halves: tuple[Interval, Interval] = ((low, middle), (middle, high))
    return [(*piece[:across], half, *piece[across + 1 :]) for half in halves]


def _middle(interval: Interval) -> arb:
    """A number in the middle, or the ball of a single one."""
    low, high = interval
    return low.union(high) if low.overlaps(high) else ((low + high) / 2).mid()


def _inside(box: Box, point: Sequence[arb]) -> bool:
    """Whether a point lies in the box, whose ends may be known in balls only."""
    ends = _whole(box)
    return all(
        bool(low <= x <= high) or (low.overlaps(high) and x.overlaps(low))
        for x, (low, high) in zip(point, ends, strict=True)
    )


def _point(box: Box, numbers: Sequence[arb]) -> dict[sp.Symbol, Expr]:
    """A point of the box in rational numbers, and in its own where the box has but one."""
    return {
        symbol: sp.sympify(low, strict=True) if low == high else _exact(x)
        for (symbol, (low, high)), x in zip(box.items(), numbers, strict=True)
    }


def _exact(number: arb) -> Expr:
    """A ball without width as a rational number."""
    mantissa, exponent = number.mid().man_exp()
    return sp.Integer(int(mantissa)) * sp.Integer(2) ** int(exponent)
