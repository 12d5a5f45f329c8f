"""The lemmas that a chapter takes from the package, derived before the chapter runs.

A theorem is its derivation.  One that is derived in the process from which the chapter's is forked
is the same there as if the chapter had derived it, and is not derived anew where it arrives.
"""

from __future__ import annotations

import ast
import importlib
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from inspect import isclass, isfunction, ismodule, signature, unwrap
from pathlib import Path
from types import CodeType
from typing import Any, TypeAlias

from symhaptic.book import lemmas

Lemma: TypeAlias = Callable[[], Any]
"""A function of the package that keeps what it derived, and need not be told of what.

So is ``derive`` of an object in a module of lemmas."""


class Beforehand:
    """What chapters take from the package: their modules are imported at once."""

    def __init__(self, paths: Sequence[Path]) -> None:
        self.lemmas: list[tuple[Lemma, ...]] = [tuple(_lemmas(path)) for path in paths]
        self._derived: set[Lemma] = set()

    def derive(self, number: int) -> bool:
        """Derive the lemmas of a chapter that are not derived here; whether there were any."""
        new = [lemma for lemma in self.lemmas[number] if lemma not in self._derived]
        for lemma in new:
            with suppress(ValueError):  # told by the chapter that needs it
                lemma()
        self._derived.update(new)
        return bool(new)

    def next(
        self, waiting: Collection[int], here: Collection[Lemma], elsewhere: Collection[Lemma]
    ) -> int:
        """The first of the chapters that wait for the fewest lemmas which others have derived."""
        return min(
            waiting,
            key=lambda n: (sum(x in elsewhere and x not in here for x in self.lemmas[n]), n),
        )


def _lemmas(path: Path) -> Iterator[Lemma]:
    """The lemmas that a chapter reaches by the names in it."""
    try:
        tree = ast.parse(path.read_bytes())
    except (OSError, SyntaxError, ValueError):
        return  # told when it is run
    names: set[str] = set()
    taken: dict[str, Any] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            names.add(node.attr)
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("symhaptic."):
            with suppress(ImportError):  # the same
                module = importlib.import_module(str(node.module))
                taken |= {a.name: vars(module).get(a.name) for a in node.names}
    yield from _reached(names | set(taken), taken, set())


def _reached(names: Collection[str], among: Mapping[str, Any], seen: set[int]) -> Iterator[Lemma]:
    """The lemmas that stand under names, and those that these name in turn."""
    for value in [among[name] for name in sorted(names) if name in among]:
        function = value if ismodule(value) or isclass(value) else _function(value)
        home = function.__name__ if ismodule(function) else getattr(function, "__module__", None)
        if id(value) in seen or not str(home).startswith(f"{lemmas.__name__}."):
            continue
        if isclass(function):
            seen.add(id(value))
            yield from _reached(vars(function), vars(function), seen)
        elif ismodule(function):
            yield from _reached(names, vars(function), seen)
        elif isfunction(function):
            seen.add(id(value))
            if hasattr(value, "cache_info") and _needs_nothing(value):
                yield value
            yield from _reached(_named(function.__code__), function.__globals__, seen)
        elif callable(derive := getattr(value, "derive", None)):
            seen.add(id(value))
            yield derive


def _function(value: Any) -> Any:
    """The function below a method, a property or what keeps its values."""
    below = getattr(value, "fget", None) or getattr(value, "func", None) or value
    return unwrap(below) if callable(below) else below


def _named(code: CodeType) -> set[str]:
    """The names in a function, and in those inside of it."""
    inner = [_named(part) for part in code.co_consts if isinstance(part, CodeType)]
    return set(code.co_names).union(*inner)


def _needs_nothing(function: Any) -> bool:
    parameters = signature(function).parameters.values()
    return all(parameter.default is not parameter.empty for parameter in parameters)
