"""An inequality on a whole box of parameters, by ball arithmetic on ever smaller pieces.

A ball around the middle of a piece, as wide as the piece, goes through the expression and comes
out as a ball that contains all its values there.  A piece that this does not decide is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr

from symhaptic.proof.ball import ball
from symhaptic.proof.sign import Fact, NotShown, rule

_BITS = 96
"""Working precision."""

_PIECES = 100_000
"""So many are tried before giving up."""

Box = Mapping[sp.Symbol, tuple[Expr, Expr]]
"""Closed interval of each symbol; its ends are numbers."""


Piece = dict[sp.Symbol, tuple[arb, arb]]

Given = Callable[[Mapping[sp.Symbol, acb]], Mapping[sp.Symbol, acb]]
"""Balls of further symbols, from balls of those of the box."""


@rule
def positive(expr: Expr, box: Box, given: Given | None = None) -> Fact:
    """``expr > 0`` everywhere in the box; ``given`` finds balls of its other symbols there.

    Raises :class:`NotShown` where a piece has a value that is not positive, or where the pieces
    become too many.  The expression must be real there, and so written that balls see it: an
    interval may not meet a division by zero, removable or not.

    >>> x = sp.Symbol("x")
    >>> positive(x**2 - x + sp.Rational(1, 2), {x: (0, 1)}).reason
    'ball arithmetic on 5 pieces'
    """
    expr = sp.sympify(expr)
    unbound = expr.free_symbols - set(box)
    if unbound and given is None:
        raise NotShown(f"the box has no interval for {', '.join(sorted(map(str, unbound)))}")

    def value(piece: Piece) -> acb:
        values = {s: acb(low.union(high)) for s, (low, high) in piece.items()}
        return ball(expr, {**values, **(given(values) if given else {})}, _BITS)

    before = ctx.prec
    ctx.prec = _BITS
    try:
        pieces: list[Piece] = [{s: (_number(low), _number(high)) for s, (low, high) in box.items()}]
        decided = 0
        while pieces:
            piece = pieces.pop()
            found = value(piece)
            if found.is_finite() and found.real > 0:
                decided += 1
                continue
            if found.is_finite() and found.real <= 0:
                near = ", ".join(
                    f"{s} near {float(low.mid()):.6g}" for s, (low, _) in piece.items()
                )
                raise NotShown(f"{expr} is not positive for {near}")
            if decided + len(pieces) >= _PIECES:
                raise NotShown(f"{expr}: undecided after {_PIECES} pieces")
            pieces += _halved(piece, value)
    finally:
        ctx.prec = before
    domain = [(s - low, high - s) for s, (low, high) in box.items()]
    rests = frozenset((sp.sympify(end), False) for pair in domain for end in pair)
    plural = "piece" if decided == 1 else "pieces"
    return Fact(expr, True, f"ball arithmetic on {decided} {plural}", rests)


def _number(value: Expr) -> arb:
    return ball(sp.sympify(value), None, _BITS).real


def _halved(piece: Piece, value: Callable[[Piece], acb]) -> list[Piece]:
    """The piece cut across the symbol without whose width the value is known best."""

    def left(symbol: sp.Symbol) -> float:
        low, high = piece[symbol]
        middle = ((low + high) / 2).mid()
        found = value({**piece, symbol: (middle, middle)})
        return float(found.real.rad()) if found.is_finite() else float("inf")

    best = min(piece, key=left) if len(piece) > 1 else next(iter(piece))
    low, high = piece[best]
    middle = ((low + high) / 2).mid()
    return [{**piece, best: (low, middle)}, {**piece, best: (middle, high)}]
