"""Which kernels work: the compiled ufuncs where they are there and NumPy's arrays are given.

SYMHAPTIC_KERNELS=array leaves the compiled ones aside, SYMHAPTIC_KERNELS=compiled insists on them.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import wraps
from inspect import signature
from types import ModuleType
from typing import Any, ParamSpec, TypeVar, cast

import numpy as np

P = ParamSpec("P")
R = TypeVar("R")

CHOICE = "SYMHAPTIC_KERNELS"

_DOUBLE = np.dtype(np.float64)

_LARGEST = 1e70
"""As in :mod:`symhaptic.numeric.arguments`, which tells what is wrong with what is beyond."""

_LOW = {"alpha": -_LARGEST, "beta": -_LARGEST}
_HIGH = {"delay": 1e15}


def _module() -> ModuleType | None:
    choice = os.environ.get(CHOICE, "")
    if choice not in ("", "array", "compiled"):
        raise ValueError(f"{CHOICE}: {choice!r} is not allowed; 'array' or 'compiled' is")
    if choice == "array":
        return None
    try:
        from symhaptic.kernels import _compiled
    except ImportError:
        if choice == "compiled":
            raise
        return None
    return _compiled


MODULE = _module()


def kernels_used() -> str:
    """``compiled`` or ``array``: what works on NumPy's arrays here."""
    return "array" if MODULE is None else "compiled"


def show_config() -> None:
    """Print which kernels work on NumPy's arrays, and NumPy's version.

    The kernels are ``compiled`` where the install found a compiler or a wheel brought them; else
    they are the slower ``array`` kernels, which give the same within rounding.

    >>> show_config()  # doctest: +ELLIPSIS
    kernels: ...
    numpy: ...
    """
    print(f"kernels: {kernels_used()}\nnumpy: {np.__version__}")


def of(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The compiled ufunc of the same name as a public kernel, or the kernel."""
    name = getattr(kernel, "__name__", "")
    return cast(Callable[..., Any], getattr(MODULE, name, kernel))


def at_once(name: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let floats and float64 arrays go to a ufunc without a detour.

    One look at the result tells whether all was in range: elsewhere a number is NaN.  A truth
    value does not tell, and there one look at each argument does.  What is not surely in range,
    and all else, goes to the function itself, which says what is wrong.
    """

    def around(function: Callable[P, R]) -> Callable[P, R]:
        ufunc = getattr(MODULE, name, None)
        if ufunc is None:
            return function
        names = list(signature(function).parameters)[: ufunc.nin]
        bounds = [(_LOW.get(n, 0.0), _HIGH.get(n, _LARGEST)) for n in names]
        truth = ufunc.types[0].endswith("?")
        count = len(names)
        slow = cast(Callable[..., R], function)

        @wraps(function)
        def called(*args: Any, **named: Any) -> Any:
            given = args
            if named:
                if len(args) + len(named) != count:
                    return slow(*args, **named)
                try:
                    given = (*args, *[named[n] for n in names[len(args) :]])
                except KeyError:
                    return slow(*args, **named)
            elif len(args) != count:
                return slow(*args)
            plain = True
            for value in given:
                kind = type(value)
                if kind is not float:
                    if kind is not np.ndarray or value.dtype is not _DOUBLE or not value.size:
                        return slow(*args, **named)
                    plain = False
            if truth:
                for value, (low, high) in zip(given, bounds, strict=True):
                    if type(value) is float:
                        if not low <= value <= high:
                            return slow(*args, **named)
                    elif not (value.min() >= low and value.max() <= high):
                        return slow(*args, **named)
            try:
                found = ufunc(*given)
            except ValueError:  # shapes that do not broadcast
                return slow(*args, **named)
            if not truth:
                first = found[0] if type(found) is tuple else found
                if plain:
                    good = -np.inf < first < np.inf
                else:
                    good = first.min() > -np.inf and first.max() < np.inf
                if not good:
                    return slow(*args, **named)
            if type(found) is tuple:
                return tuple([np.asarray(f) for f in found])
            return np.asarray(found)

        return cast(Callable[P, R], called)

    return around
