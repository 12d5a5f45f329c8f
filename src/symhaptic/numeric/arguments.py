"""Arguments as arrays: NaN stays NaN, and what is impossible is refused by name."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any, NoReturn

import numpy as np
from array_api_compat import array_namespace
from numpy.typing import ArrayLike, NDArray

from symhaptic.notation.quantities import shown
from symhaptic.notation.sizes import LARGEST, LONGEST, STIFFEST

Array = NDArray[np.float64]

IN_ORDER = {
    "eq5": "K B T omega d",
    "eq6": "K B T",
    "eq7": "b T omega d",
    "eq9": "b B T d",
    "eq11": "b T d",
    "eq12": "b k m T",
    "eq24": "b B t_d T",
    "eq28": "k b m",
}
"""Order of the arguments of an equation in SI units, wherever it is a function."""

_BLOCK = 16384
"""Elements worked on at a time: NumPy's calls cost little beside them, and arrays fit the cache."""

_BELOW_PI = {True: math.pi, False: float(np.nextafter(np.float32(np.pi), np.float32(0)))}
"""The last float before pi, in double precision and in single: ``math.pi`` is less than pi."""


def real(name: str, values: ArrayLike | Fraction) -> Array:
    """The argument as a float64 array; text, dates and complex numbers are no numbers here.

    What is masked is NaN.
    """
    try:
        if isinstance(values, np.ma.MaskedArray):
            plain = values.filled(np.nan) if values.dtype == object else values.data
            return np.where(np.ma.getmaskarray(values), np.nan, real(name, plain))
        array = np.asarray(values)
        if array.dtype.kind in "biuf" or (array.dtype == object and all(map(_is_real, array.flat))):
            with np.errstate(over="ignore"):  # what no float64 holds is infinite
                return np.asarray(array, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        pass
    refuse_all(name, values)


def _is_real(value: object) -> bool:
    return hasattr(value, "__float__") and not isinstance(value, np.complexfloating)


def one(name: str, value: Any) -> float:
    """The argument, which is one number."""
    return single(name, real(name, value))


def single(name: str, values: Array) -> float:
    """The argument as one number."""
    if values.size != 1:
        raise ValueError(f"{name}: {shown(values)} is not allowed; give one number")
    return float(values.reshape(())) + 0.0  # no negative zero


def finite(name: str, values: ArrayLike) -> Array:
    """The argument as an array of finite numbers or NaN."""
    array = real(name, values)
    _finite(name, array, np)
    return array


def checked(name: str, values: ArrayLike | Fraction) -> Array:
    """The argument as an array of NaN and of what the argument of this name may be."""
    array = real(name, values)
    check(name, array, np)
    return array


def of_loop(name: str, values: ArrayLike) -> float:
    """One number >= 0: gamma, delta or the delay of a loop."""
    array = checked(name, values)
    refuse(name, array, np.isnan(array), f"finite numbers {name} >= 0")
    return single(name, array)


def check(name: str, array: Any, xp: Any) -> None:
    """Refuse what the argument of this name may not be, in an array of any library."""
    _CHECKS[name](name, array, xp)


def _finite(name: str, array: Any, xp: Any) -> None:
    refuse(name, array, xp.isinf(array), "finite numbers")
    if float(xp.finfo(array.dtype).max) > LARGEST:
        refuse(name, array, xp.abs(array) > LARGEST, f"numbers up to {LARGEST:g} in size")


def _nonnegative(name: str, array: Any, xp: Any) -> None:
    refuse(name, array, (array < 0) | xp.isinf(array), f"finite numbers {name} >= 0")
    if float(xp.finfo(array.dtype).max) > LARGEST:
        most = STIFFEST if name == "gamma" else LARGEST
        refuse(name, array, array > most, f"numbers 0 <= {name} <= {most:g}")


def _periods(name: str, array: Any, xp: Any) -> None:
    _nonnegative(name, array, xp)
    refuse(name, array, array > LONGEST, f"numbers 0 <= {name} <= {LONGEST:g}")


def _angle(name: str, array: Any, xp: Any) -> None:
    last = _BELOW_PI[float(xp.finfo(array.dtype).max) > LARGEST]
    refuse(name, array, (array <= 0) | (array > last), f"numbers 0 < {name} < pi")


def _fraction(name: str, array: Any, xp: Any) -> None:
    refuse(name, array, (array < 0) | (array >= 1), f"numbers 0 <= {name} < 1")


_CHECKS: dict[str, Callable[[str, Any, Any], None]] = {
    "alpha": _finite,
    "beta": _finite,
    "K": _finite,
    "B": _finite,
    "frequency_hz": lambda name, array, xp: None,  # its range depends on the sampling period
    "gamma": _nonnegative,
    "delta": _nonnegative,
    "delay": _periods,
    "epsilon": _fraction,
    "theta": _angle,
}


def refuse_all(name: str, value: object) -> NoReturn:
    """Raise :class:`ValueError` for what is no real number."""
    raise ValueError(f"{name}: {shown(value)} is not allowed; give real numbers")


def refuse(name: str, values: Any, bad: Any, allowed: str) -> None:
    """Raise :class:`ValueError` with the first bad value."""
    xp = array_namespace(bad)
    if bool(xp.any(bad)):
        value = float(xp.reshape(values, (-1,))[xp.reshape(bad, (-1,))][0])
        raise ValueError(f"{name}: {value!r} is not allowed; give {allowed}")


def unitless(name: str, values: Array, found: Array) -> Array:
    """What an argument is without its unit; too large, it is refused by the argument's name."""
    allowed = f"at most {LARGEST:g} in size without its unit"
    refuse(name, values, np.abs(found) > LARGEST, allowed)
    return found


def check_sheet(sheet: str) -> None:
    """Refuse what names no meaning of a fractional delay."""
    if not isinstance(sheet, str) or sheet not in ("exact", "principal"):
        raise ValueError(f"sheet: {shown(sheet)} is not allowed; give 'exact' or 'principal'")


def together(*arrays: Any) -> tuple[int, ...]:
    """The shape that the arguments broadcast to."""
    try:
        return np.broadcast_shapes(*(tuple(a.shape) for a in arrays))
    except ValueError:
        shapes = ", ".join(str(tuple(a.shape)) for a in arrays)
        raise ValueError(
            f"shapes of the arguments: {shapes} are not allowed; give shapes that broadcast"
        ) from None


def in_blocks(
    work: Callable[..., Sequence[Array] | Array],
    *arrays: Array,
    block: int = _BLOCK,
    told: str | None = None,
) -> Array:
    """The rows that ``work`` makes of the broadcast arrays, on pieces that fit the cache.

    ``work`` gets flat pieces, of one element where an argument has but one.  With ``told``, what
    is done and how much of it are shown where somebody watches and there are several pieces.
    """
    shape = together(*arrays)
    size = math.prod(shape)
    flat = [a.reshape(1) if a.size == 1 else np.broadcast_to(a, shape).reshape(-1) for a in arrays]
    found = np.empty((0, size))
    for begin in _shown_on_terminal(range(0, max(size, 1), block), told):
        part = slice(begin, begin + block)
        rows = work(*(a if a.size == 1 else a[part] for a in flat))
        if not begin:
            found = np.empty((len(rows), size))
        for row, values in zip(found, rows, strict=True):
            row[part] = values
    return found.reshape(len(found), *shape)


def _shown_on_terminal(begins: range, told: str | None) -> Iterable[int]:
    """The same numbers, with a progress bar on a terminal."""
    if told is None or len(begins) < 4 or not sys.stderr.isatty():
        return begins
    from rich.console import Console
    from rich.progress import track

    return track(begins, told, console=Console(stderr=True), transient=True)
