"""Which kernels work: the compiled ufuncs where they are there and NumPy's arrays are given.

SYMHAPTIC_KERNELS=array leaves the compiled ones aside, SYMHAPTIC_KERNELS=compiled insists on them.
"""

from __future__ import annotations

import math
import os
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import partial, wraps
from inspect import signature
from types import ModuleType
from typing import Any, ParamSpec, TypeVar, cast

import numpy as np

from symhaptic.kernels import OF_NUMBERS, STAMP

P = ParamSpec("P")
R = TypeVar("R")

CHOICE = "SYMHAPTIC_KERNELS"

_DOUBLE = np.dtype(np.float64)

_WHOLE = 2**53
"""Whole numbers up to here are floats."""

_LARGEST = sys.float_info.max

_STALE = "the compiled kernels are of other sources: `pip install -e .` compiles them anew"


def _module() -> ModuleType | None:
    choice = os.environ.get(CHOICE, "")
    if choice not in ("", "array", "compiled"):
        raise ValueError(f"{CHOICE}: {choice!r} is not allowed; give 'array' or 'compiled'")
    if choice == "array":
        return None
    try:
        from symhaptic.kernels import _compiled
    except ImportError:
        if choice == "compiled":
            raise ValueError(
                f"{CHOICE}: 'compiled' is not available, because the install found no compiler; "
                "give 'array'"
            ) from None
        return None
    if getattr(_compiled, "STAMP", "") == STAMP:
        return _compiled
    if choice == "compiled":
        raise ValueError(f"{CHOICE}: 'compiled' is not available: {_STALE}; or give 'array'")
    warnings.warn(f"{_STALE}; until then the array kernels work", RuntimeWarning, stacklevel=2)
    return None


MODULE = _module()


def kernels_used() -> str:
    """``compiled`` or ``array``: what works on NumPy's arrays here."""
    return "array" if MODULE is None else "compiled"


def show_config() -> None:
    """Print which kernels compute NumPy's arrays, and NumPy's version.

    The kernels are ``compiled`` if the install found a compiler or used a wheel.  Otherwise they
    are the slower ``array`` kernels, which give the same results within rounding.

    >>> show_config()  # doctest: +ELLIPSIS
    kernels: ...
    numpy: ...
    """
    print(f"kernels: {kernels_used()}\nnumpy: {np.__version__}")


def of(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The compiled ufunc of the same name as a public kernel, or the kernel."""
    name = getattr(kernel, "__name__", "")
    return cast(Callable[..., Any], getattr(MODULE, name, kernel))


WORDS = ("sheet", "tolerance", "threshold", "certified", "digits")
"""Arguments of public functions that are no arrays."""


def at_once(
    name: str,
    into: Callable[..., Any] | None = None,
    sure: Callable[[Any], bool] | None = None,
    work: Callable[..., Any] | None = None,
) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let floats and float64 arrays go to a ufunc without a detour.

    Or to ``work``, which is given the ufunc before them; ``into`` is made of the results.
    The ufunc's loop asks of each argument whether it is in range, which costs next to nothing
    there, and tells whether all were.  If not, where the first result is not ``sure``, and for all
    other arguments, the function itself is called, which says what is wrong.
    """

    def around(function: Callable[P, R]) -> Callable[P, R]:
        ufunc = getattr(MODULE, name, None)
        if MODULE is None:
            return _of_numbers(function, name, into)
        if ufunc is None:
            return function
        outside: Callable[[], bool] = MODULE.outside
        one: Callable[..., Any] = getattr(MODULE, f"one_{name}") if work is None else _nothing
        rest = [v for n, v in signature(function).parameters.items() if n not in WORDS]
        names = [v.name for v in rest]
        usual = tuple(v.default for v in rest if v.default is not v.empty)
        rows = partial(_in_one_piece, ufunc) if ufunc.nout > 1 else ufunc
        kernel = rows if work is None else partial(work, ufunc)

        def many(*args: P.args, **named: P.kwargs) -> R:
            left = len(names) - len(args)
            more = usual[-left:] if 0 < left <= len(usual) and not named else ()
            given = _numbers(names, (*args, *more), named)
            if given is None:
                return function(*args, **named)
            try:
                found = kernel(*given)
            except ValueError:  # shapes that do not broadcast
                return function(*args, **named)
            if outside() or not known(found):
                return function(*args, **named)
            return made(found)

        def plain(*args: P.args, **named: P.kwargs) -> R:
            found: R | None = None if named else one(*args)
            return many(*args, **named) if found is None else found

        def called(*args: P.args, **named: P.kwargs) -> R:
            found = None if named else one(*args)
            if found is None or not known(found):
                return many(*args, **named)
            return made(found)

        def known(found: Any) -> bool:
            return sure is None or sure(found[0] if type(found) is tuple else found)

        def made(found: Any) -> R:
            if into is not None:
                found = into(*found) if type(found) is tuple else into(found)
            result: R = found
            return result

        return wraps(function)(plain if into is None and sure is None else called)

    return around


def _of_numbers(
    function: Callable[P, R], name: str, into: Callable[..., Any] | None
) -> Callable[P, R]:
    """A function whose calls with floats go to the kernel of plain Python, if there is one."""
    if name not in OF_NUMBERS:
        return function

    @wraps(function)
    def called(*args: P.args, **named: P.kwargs) -> R:
        if named or not all(type(x) is float or type(x) is int for x in args):
            return function(*args, **named)
        from symhaptic.kernels import scalar

        try:
            found = getattr(scalar, name)(*map(float, cast(tuple[float, ...], args)))
        except (ArithmeticError, TypeError):  # a zero divisor, or another number of arguments
            return function(*args, **named)
        values = found if type(found) is tuple else (found,)
        if not all(v is not None and -_LARGEST <= v <= _LARGEST for v in values):
            return function(*args, **named)
        numbers = [np.bool_(v) if type(v) is bool else np.float64(v) for v in values]
        made: Any = tuple(numbers) if len(numbers) > 1 else numbers[0]
        result: R = into(*numbers) if into else made
        return result

    return called


_REUSED = 2**25
"""Bytes up to which an allocator may keep what was freed; it takes more from the system anew."""


def _in_one_piece(ufunc: np.ufunc, *given: Any) -> Any:
    """All results of a ufunc as rows of one array: what is freed at once is reused at once.

    Freed one by one, large ones go back to the system, whose fresh pages cost a sixth of the time.
    """
    shape = np.broadcast_shapes(*map(np.shape, given))
    if not shape or 8 * math.prod(shape) * ufunc.nout > _REUSED:
        return ufunc(*given)
    return ufunc(*given, out=tuple(np.empty((ufunc.nout, *shape))))


def _nothing(*numbers: Any) -> None:
    """No short way."""


def _numbers(names: list[str], args: Sequence[Any], named: Mapping[str, Any]) -> Any:
    """All arguments in their order, floats and float64 arrays that are not empty; or None."""
    if len(args) + len(named) != len(names):
        return None
    if named:
        if not named.keys() <= set(names[len(args) :]):
            return None
        args = (*args, *[named[n] for n in names[len(args) :]])
    found = args
    for value in args:
        kind = type(value)
        if kind is float:
            continue
        if kind is np.float64 or (kind is int and -_WHOLE <= value <= _WHOLE):
            found = [float(v) if type(v) is kind else v for v in found]
        elif kind is not np.ndarray or value.dtype is not _DOUBLE or not value.size:
            return None
    return found


def finite(value: Any) -> bool:
    """Whether all numbers are; NaN is not."""
    if type(value) is np.ndarray:
        return bool(value.min() >= -_LARGEST and value.max() <= _LARGEST)
    return bool(-_LARGEST <= value <= _LARGEST)


def told(value: Any) -> bool:
    """Whether none is NaN."""
    lowest = value.min() if type(value) is np.ndarray else value
    return bool(lowest == lowest)
