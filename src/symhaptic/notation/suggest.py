"""What somebody may have meant who misspelt a name."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

_FEW = 8
"""Names that a line can list whole."""


def suggested(name: object, known: Iterable[str], listing: str = "") -> str:
    """The names that look like this one, and all of them or what lists them.

    >>> suggested("no-dely", ["no-damping", "no-delay"])
    "did you mean 'no-delay'? give one of no-damping, no-delay"
    >>> suggested("eq111", [f"eq{n}" for n in range(1, 32)], "`symhaptic verify --list` lists all")
    "did you mean 'eq11', 'eq1', 'eq31', 'eq21'? `symhaptic verify --list` lists all"
    """
    names = list(known)
    folded = {each.casefold(): each for each in reversed(names)}
    close = [folded[each] for each in get_close_matches(str(name).casefold(), folded, 4, 0.6)]
    question = f"did you mean {', '.join(map(repr, close))}? " if close else ""
    every = f"give one of {', '.join(names)}"
    return question + (every if len(names) <= _FEW or not listing else listing)
