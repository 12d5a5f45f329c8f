"""Symbols that are nobody else's: SymPy counts those that it makes, and a count can be made up."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp
from sympy import Expr


def mark() -> int:
    """A number that lies above those of all symbols made so far, and below those of all to come."""
    return int(sp.Dummy().dummy_index)


def made_before(symbol: Expr, mark: int) -> bool:
    """Whether no symbol that is made from now on can be the same one.

    >>> before, count = sp.Dummy(), mark()
    >>> made_before(before, count), made_before(sp.Dummy("x", dummy_index=count), count)
    (True, False)
    """
    if not isinstance(symbol, sp.Dummy):
        return True
    index = symbol.dummy_index
    return type(index) is int and index < mark


def fresh(apart: Iterable[Expr], name: str | None = None) -> sp.Dummy:
    """Make a symbol that is none of these, whatever numbers they have.

    >>> mine = sp.Dummy("x", dummy_index=mark() + 1)
    >>> fresh([mine], "x") == mine
    False
    """
    known = set(apart)
    while (made := sp.Dummy(name)) in known:
        pass
    return made
