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


def prepare(paths: Sequence[Path]) -> None:
    """Import what the chapters take from the package, and derive the lemmas of several of them."""
    wanted: Counter[str] = Counter()
    for path in paths:
        wanted.update({below for name in _imported(path) for below in _lemmas_of(name)})
    for name, chapters in wanted.items():
        for lemma in _without_arguments(name) if chapters > 1 else ():
            with suppress(ValueError):  # told by the chapters that need it
                lemma()


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
