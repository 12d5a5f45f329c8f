"""What is the package's own and wanted by several chapters: imported and derived once for all.

A theorem is its derivation.  One that is derived here, before any chapter has run, is the same for
the processes that are forked from this one as if each had derived it.
"""

from __future__ import annotations

import ast
import importlib
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from inspect import signature
from pathlib import Path
from typing import Any

from symhaptic.book import lemmas


class Beforehand:
    """What chapters take from the package: imported at once, and derived lemma by lemma."""

    def __init__(self, paths: Sequence[Path]) -> None:
        self._wanted = [
            {below for name in _imported(path) for below in _lemmas_of(name)} for path in paths
        ]
        several = Counter(name for names in self._wanted for name in sorted(names))
        self._left = {
            name: list(_without_arguments(name)) for name, number in several.items() if number > 1
        }

    def ready(self, number: int) -> bool:
        """Whether nothing is left to derive of what this chapter shares with others."""
        return not self._missing(number)

    def _missing(self, number: int) -> list[str]:
        """The modules of which a chapter waits for a lemma."""
        return sorted(name for name in self._wanted[number] if self._left.get(name))

    def derive(self) -> bool:
        """Derive a lemma of the chapter that waits for the fewest; False where none is left."""
        waiting = [n for n in map(self._missing, range(len(self._wanted))) if n]
        if not waiting:
            return False
        name = min(waiting, key=lambda names: sum(len(self._left[name]) for name in names))[0]
        with suppress(ValueError):  # told by the chapters that need it
            self._left[name].pop(0)()
        return True


def prepare(paths: Sequence[Path]) -> None:
    """Import what the chapters take from the package, and derive the lemmas of several of them."""
    beforehand = Beforehand(paths)
    while beforehand.derive():
        pass


def _imported(path: Path) -> list[str]:
    """The modules of the package that a chapter takes something from; they are imported."""
    try:
        tree = ast.parse(path.read_bytes())
    except (OSError, SyntaxError, ValueError):
        return []  # told when it is run
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("symhaptic."):
            with suppress(ImportError):  # the same
                found.append(importlib.import_module(str(node.module)).__name__)
    return found


def _lemmas_of(name: str) -> set[str]:
    """A module of lemmas, and those that it takes something from itself."""
    found, stack = set[str](), [name]
    while stack:
        module = stack.pop()
        if module.startswith(f"{lemmas.__name__}.") and module not in found:
            found.add(module)
            stack += _homes(vars(sys.modules[module]).values())
    return found


def _homes(values: Iterable[object]) -> Iterator[str]:
    for value in values:
        home = getattr(value, "__module__", None)
        if isinstance(home, str):
            yield home


def _without_arguments(name: str) -> Iterator[Callable[[], Any]]:
    """The lemmas that a module keeps once they are derived, and that need not be told of what."""
    for value in list(vars(sys.modules[name]).values()):
        if hasattr(value, "cache_info") and value.__module__ == name:
            parameters = signature(value).parameters.values()
            if all(parameter.default is not parameter.empty for parameter in parameters):
                yield value
