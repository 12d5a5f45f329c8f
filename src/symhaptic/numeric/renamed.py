"""Old names of arguments, which stay for one more minor version with a warning."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar, cast

P = ParamSpec("P")
R = TypeVar("R")


def renamed(**names: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let a function take old keywords, each given with the new one."""

    def around(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def called(*args: P.args, **named: P.kwargs) -> R:
            return function(*args, **(with_new_names(named, names) if named else named))

        return cast(Callable[P, R], called)

    return around


def with_new_names(named: dict[str, Any], names: dict[str, str], depth: int = 3) -> dict[str, Any]:
    """The arguments by their new names, in the same order.

    Warns with :class:`DeprecationWarning` at the caller, ``depth`` calls further out.
    """
    for old, new in names.items():
        if old in named and new not in named:
            warnings.warn(f"{old}: is now {new}; give {new}", DeprecationWarning, depth)
            named = {new if name == old else name: value for name, value in named.items()}
    return named
