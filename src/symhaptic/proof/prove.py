"""Questions of a user's own: are two formulas the same, does an inequality hold on a box?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

import sympy as sp
from sympy import Expr
from sympy.core.relational import Relational

from symhaptic.proof import box as boxes
from symhaptic.proof.certificate import Box, Positive
from symhaptic.proof.decide import Form, compare, named
from symhaptic.proof.rewriting import Unsupported
from symhaptic.proof.sign import NotShown
from symhaptic.proof.verdict import Kind, Verdict

Ends: TypeAlias = Mapping[sp.Symbol, tuple[object, object]]
"""Closed interval of each symbol."""


def prove(lhs: Form, rhs: Form | Ends) -> Verdict:
    r"""Decide whether two formulas are the same, or whether an inequality holds on a box.

    ``prove(lhs, rhs)`` compares formulas, vectors or relations; equality holds wherever both sides
    are defined, for real values of the symbols and any real exponent.  ``prove(relation, box)``
    takes an inequality and a closed interval for each of its symbols, ``{x: (0, 1)}``.

    Returns a :class:`Verdict` that is true only for what is settled: *proved* with the field in
    which the difference is zero, *enclosed* with a ``certificate`` that
    :func:`symhaptic.recheck` checks again.  What is false is *refuted*, with a point;
    *undecided* is neither, and not true.  An inequality that is touched, such as
    :math:`x^2\ge0` on [-1, 1], is undecided: balls cannot see an equality.  Raises
    :class:`TypeError` and :class:`ValueError` for what is no formula, relation or box.

    >>> from sympy.abc import x
    >>> bool(prove(sp.tan(x/2), sp.sin(x)/(1 + sp.cos(x))))
    True
    >>> print(prove(sp.sin(2*x), 2*sp.sin(x)).counterexample)
    {'x': '1'}
    >>> print(prove(sp.sin(x) < x - x**3/8, {x: (1, 2)}))
    enclosed: ball arithmetic on 20 pieces
    """
    if isinstance(rhs, Mapping):
        return _on_box(lhs, rhs)
    for side in (lhs, rhs):
        if isinstance(side, str) or not isinstance(
            side, (sp.Basic, sp.MatrixBase, Sequence, int, float)
        ):
            raise TypeError(
                f"prove: {side!r} is no formula; SymPy expressions, relations and "
                "sequences of them are allowed"
            )
    result = compare(lhs, rhs)
    if result.equal:
        return Verdict(Kind.PROVED, result.method)
    if result.equal is None:
        return Verdict(Kind.UNDECIDED, result.method)
    return Verdict(Kind.REFUTED, result.method, counterexample=named(result.point))


def _on_box(relation: Form, ends: Ends) -> Verdict:
    if relation in (True, False):
        raise TypeError(
            f"prove: the inequality is {relation} already: SymPy decided it when it was written; "
            "evaluate=False keeps it as it is"
        )
    if not isinstance(relation, Relational) or isinstance(relation, (sp.Eq, sp.Ne)):
        raise TypeError(f"prove: {relation!r} is no inequality; one of <, <=, >, >= is allowed")
    floats = sorted(relation.atoms(sp.Float))
    if floats:
        raise ValueError(f"prove: {floats[0]} is no exact number; Rational(1, 10) is one, say")
    smaller, larger = relation.lhs, relation.rhs
    if isinstance(relation, (sp.StrictGreaterThan, sp.GreaterThan)):
        smaller, larger = larger, smaller
    box = checked("prove", ends)
    missing = relation.free_symbols - set(box)
    if missing:
        names = ", ".join(sorted(map(str, missing)))
        raise ValueError(f"prove: box: no interval for {names}; one for each symbol is needed")
    try:
        found = boxes.search(larger - smaller, box)
    except (Unsupported, NotShown) as wrong:
        return Verdict(Kind.UNDECIDED, str(wrong))
    if found is None:
        return Verdict(Kind.UNDECIDED, "the pieces of the box became too many")
    if isinstance(found, Positive):
        pieces = f"{found.pieces} piece" + ("s" if found.pieces > 1 else "")
        return Verdict(Kind.ENCLOSED, f"ball arithmetic on {pieces}", certificate=found)
    point = named(found.point)
    if found.touches and not isinstance(relation, (sp.StrictLessThan, sp.StrictGreaterThan)):
        return Verdict(Kind.UNDECIDED, "both sides are equal somewhere")
    return Verdict(Kind.REFUTED, "ball arithmetic at a point", counterexample=point)


def checked(caller: str, ends: Ends) -> Box:
    """A box with exact ends; :class:`ValueError` names what is wrong with it."""
    if not isinstance(ends, Mapping):
        raise TypeError(f"{caller}: box: {ends!r} is no mapping of symbols to intervals")
    box: dict[sp.Symbol, tuple[Expr, Expr]] = {}
    for symbol, pair in ends.items():
        if not isinstance(symbol, sp.Symbol):
            raise TypeError(f"{caller}: box: {symbol!r} is no symbol")
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise ValueError(f"{caller}: box: {pair!r} of {symbol} is no pair (lower, upper)")
        low, high = (sp.sympify(end) for end in pair)
        for end in (low, high):
            if (
                not isinstance(end, Expr)
                or end.free_symbols
                or end.has(sp.Float)
                or not end.is_finite
                or not end.is_real
            ):
                raise ValueError(
                    f"{caller}: box: {end} of {symbol} is not allowed; an exact real number is, "
                    "such as Rational(1, 10)"
                )
        if (high - low).is_negative:
            raise ValueError(f"{caller}: box: ({low}, {high}) of {symbol} is empty")
        beyond = (low.is_negative and symbol.is_extended_nonnegative) or (
            high.is_positive and symbol.is_extended_nonpositive
        )
        if beyond or symbol.is_integer or symbol.is_real is False:
            raise ValueError(
                f"{caller}: box: ({low}, {high}) has numbers that {symbol} is assumed not to be"
            )
        box[symbol] = (low, high)
    return box
