"""What a chapter's process sends, read as data: nothing in it is run but what makes data of ours.

A pickle names functions and calls them.  Here it may name the classes of this package, the one
function by which a theorem is derived anew, and what terms are made of; no text is given to SymPy,
which would run it.
"""

from __future__ import annotations

import io
import pickle
from collections import Counter
from functools import cache
from pathlib import Path, PosixPath, WindowsPath
from typing import Any

import sympy as sp
from sympy import Basic

from symhaptic.book.chapters import BadChapter
from symhaptic.notation.proposition import FUNCTIONS
from symhaptic.proof.theorems import kernel

_NAMED = {sp.Symbol, sp.Dummy}
_ATOMS = (sp.pi, sp.E, sp.I, sp.S.Zero, sp.S.One, sp.S.NegativeOne, sp.S.Half)
_TERMS = {sp.Add, sp.Mul, sp.Pow, sp.Integer, sp.Rational, *FUNCTIONS, *map(type, _ATOMS)}
_PLAIN = {Counter, Path, PosixPath, WindowsPath, set, frozenset}
_WRONG = (pickle.UnpicklingError, AttributeError, ImportError, LookupError, TypeError, ValueError)


def arrived(sent: bytes, path: Path) -> Any:
    """The result of a chapter, its theorems derived anew; or what is wrong with what was sent."""
    try:
        return _Reader(io.BytesIO(sent)).load()
    except _WRONG as wrong:
        said = " ".join(str(wrong).split())
        return BadChapter(path, f"what its process sent is no result: {said}")


class _Reader(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        if (module, name) == (kernel.__name__, "_arrived"):
            return kernel._arrived
        found = super().find_class(module, name)
        if found in _NAMED or found in _PLAIN:
            return found
        if found in _TERMS:
            return _of_terms(found)
        ours = isinstance(found, type) and module.startswith("symhaptic.")
        if ours and (found.__module__, found.__name__) == (module, name):
            return found
        raise pickle.UnpicklingError(f"{module}.{name} is not allowed in it")


@cache
def _of_terms(kind: type[Basic]) -> type:
    """Makes the same of anything but text."""

    def made(cls: type, *args: Any) -> Basic:
        if any(isinstance(arg, (str, bytes)) for arg in args):
            raise pickle.UnpicklingError(f"{kind.__name__} of text is not allowed in it")
        return kind.__new__(kind, *args)

    return type(kind.__name__, (), {"__new__": made})
