"""Arguments as arrays: NaN stays NaN, and what is impossible is refused by name."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

_BLOCK = 8192
"""Elements worked on at a time: a dozen arrays of them fit the cache."""


def real(name: str, values: ArrayLike) -> Array:
    """The argument as a float64 array."""
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {values!r} is not allowed; real numbers are") from None


def finite(name: str, values: ArrayLike) -> Array:
    """The argument as an array of finite numbers or NaN."""
    array = real(name, values)
    refuse(name, array, np.isinf(array), "finite numbers are")
    return array


def nonnegative(name: str, values: ArrayLike) -> Array:
    """The argument as an array of finite numbers >= 0 or NaN."""
    array = real(name, values)
    refuse(name, array, (array < 0) | np.isinf(array), f"finite numbers {name} >= 0 are")
    return array


def refuse(name: str, values: Array, bad: NDArray[np.bool_], allowed: str) -> None:
    """Raise :class:`ValueError` with the first bad value."""
    if np.any(bad):
        value = float(values[bad].flat[0])
        raise ValueError(f"{name}: {value!r} is not allowed; {allowed}")


def one_of(name: str, value: str, allowed: tuple[str, ...]) -> str:
    """The argument, which must be one of a few words."""
    if value not in allowed:
        raise ValueError(f"{name}: {value!r} is not allowed; {' or '.join(map(repr, allowed))} is")
    return value


def in_blocks(work: Callable[..., Array], *arrays: Array) -> Array:
    """``work`` on flat pieces of the broadcast arrays, small enough for the cache."""
    shape = np.broadcast_shapes(*(a.shape for a in arrays))
    size = int(np.prod(shape))
    if size <= _BLOCK:
        return np.asarray(work(*(np.broadcast_to(a, shape) for a in arrays)))
    flat = [a.reshape(1) if a.size == 1 else np.broadcast_to(a, shape).reshape(-1) for a in arrays]
    pieces = [
        work(*(a if a.size == 1 else a[begin : begin + _BLOCK] for a in flat))
        for begin in range(0, size, _BLOCK)
    ]
    return np.concatenate(pieces, axis=-1).reshape(*pieces[0].shape[:-1], *shape)
