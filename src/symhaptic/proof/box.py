"""An inequality on a whole box of parameters, by ball arithmetic on ever smaller pieces.

A ball around the middle of a piece, as wide as the piece, goes through the expression and comes
out as a ball that contains all its values there.  A piece that this does not decide is halved.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import count

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr

from symhaptic.proof.ball import ball
from symhaptic.proof.sign import Fact, NotShown

_BITS = 96
"""Working precision."""

_PIECES = 100_000
"""So many are tried before giving up."""

Box = Mapping[sp.Symbol, tuple[Expr, Expr]]
"""Closed interval of each symbol; its ends are numbers."""


def positive(expr: Expr, box: Box) -> Fact:
    """``expr > 0`` everywhere in the box.

    Raises :class:`NotShown` where a piece has a value that is not positive, or where the pieces
    become too many.  The expression must be real there, and so written that balls see it: an
    interval may not meet a division by zero, removable or not.

    >>> x = sp.Symbol("x")
    >>> positive(x**2 - x + sp.Rational(1, 2), {x: (0, 1)}).reason
    'ball arithmetic on 5 pieces'
    """
    expr = sp.sympify(expr)
    unbound = expr.free_symbols - set(box)
    if unbound:
        raise NotShown(f"the box has no interval for {', '.join(sorted(map(str, unbound)))}")
    before = ctx.prec
    ctx.prec = _BITS
    try:
        start = {s: (_number(low), _number(high)) for s, (low, high) in box.items()}
        pieces, decided = [start], 0
        for tried in count(1):
            piece = pieces.pop()
            value = ball(expr, {s: _interval(*ends) for s, ends in piece.items()}, _BITS)
            if value.is_finite() and value.real > 0:
                decided += 1
                if not pieces:
                    break
                continue
            if value.is_finite() and value.real <= 0:
                where = ", ".join(
                    f"{s} near {float(ends[0].mid()):.6g}" for s, ends in piece.items()
                )
                raise NotShown(f"{expr} is not positive for {where}")
            if tried >= _PIECES:
                raise NotShown(f"{expr}: undecided after {tried} pieces")
            pieces += _halved(piece)
    finally:
        ctx.prec = before
    domain = [(s - low, high - s) for s, (low, high) in box.items()]
    rests = frozenset((sp.sympify(end), False) for pair in domain for end in pair)
    plural = "piece" if decided == 1 else "pieces"
    return Fact(expr, True, f"ball arithmetic on {decided} {plural}", rests)


def _number(value: Expr) -> arb:
    return ball(sp.sympify(value), None, _BITS).real


def _interval(low: arb, high: arb) -> acb:
    return acb(low.union(high))


def _halved(piece: dict[sp.Symbol, tuple[arb, arb]]) -> list[dict[sp.Symbol, tuple[arb, arb]]]:
    """The piece cut across the symbol with the widest interval."""
    widest = max(piece, key=lambda s: float((piece[s][1] - piece[s][0]).mid()))
    low, high = piece[widest]
    middle = ((low + high) / 2).mid()
    return [{**piece, widest: (low, middle)}, {**piece, widest: (middle, high)}]
