"""The arguments of a public function as arrays of one library: checked, and their results alike."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np
from array_api_compat import (
    array_namespace,
    device,
    is_array_api_obj,
    is_jax_array,
    is_lazy_array,
    is_numpy_array,
    is_torch_array,
)

from symhaptic.kernels import haptic
from symhaptic.numeric import arguments, compiled
from symhaptic.numeric.arguments import Array


class Given:
    """Numbers and arrays of any library, in the order of their names.

    Numbers and lists become NumPy's, or follow the arrays beside them.  Values are checked by the
    names of the arguments, unless they are traced and cannot be: then out of range gives NaN or
    what the formula gives there.
    """

    def __init__(self, **values: Any) -> None:
        plain = [_plain(name, value) for name, value in values.items()]
        self.xp, *arrays = haptic.arrays(*plain)
        self.values: tuple[Any, ...] = tuple(arrays)
        self.traced = any(map(_is_traced, arrays))
        if not self.traced:
            for name, array in zip(values, arrays, strict=True):
                arguments.check(name, array, self.xp)
        arguments.together(*arrays)

    def __call__(self, kernel: Callable[..., Any]) -> Any:
        """What a kernel makes of them; where it divides by 0 there is no result, which is NaN."""
        kernel = self.kernel(kernel)
        if not is_numpy_array(self.values[0]):
            return kernel(*self.values)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            found = kernel(*self.values)
        return tuple(map(single, found)) if isinstance(found, tuple) else single(found)

    def in_double(self) -> Given:
        """The same in double precision, where the library has it on this device.

        For verdicts: in single precision more walls are too close to the boundary to be told.
        """
        first = self.values[0]
        where = {} if is_numpy_array(first) or self.traced else {"device": device(first)}
        kinds = self.xp.__array_namespace_info__().dtypes(**where, kind="real floating")
        if "float64" in kinds:
            self.values = tuple(self.xp.astype(v, kinds["float64"]) for v in self.values)
        return self

    def kernel(self, kernel: Callable[..., Any]) -> Callable[..., Any]:
        """For NumPy's arrays the compiled one, where there is one."""
        return compiled.of(kernel) if is_numpy_array(self.values[0]) else kernel

    def each(self, work: Callable[..., Any]) -> Any:
        """What ``work``, given the namespace and flat pieces, makes of them element by element."""
        return self(partial(haptic.elementwise, self.xp, partial(work, self.xp)))

    def whole(self, delay: Any) -> bool:
        """Whether no delay has a fraction, as far as that can be known."""
        if _is_traced(delay):
            return True
        return not bool(self.xp.any(delay > self.xp.floor(delay)))

    def by_numpy(self, work: Callable[..., Iterable[Array]], results: int = 1) -> Any:
        """What a function of float64 NumPy arrays makes of them, in their own library.

        Its rows have the shape that the arguments broadcast to.
        """
        first = self.values[0]
        if not self.traced:
            rows = work(*(to_numpy(v) for v in self.values))
            return tuple(self.own(row) for row in rows)
        if not is_jax_array(first):
            raise ValueError("traced arrays are not allowed here, except those of JAX")
        jax = sys.modules["jax"]
        like = jax.ShapeDtypeStruct(arguments.together(*self.values), first.dtype)

        def rows_of(*values: Any) -> tuple[Array, ...]:
            found = work(*(np.asarray(v, dtype=np.float64) for v in values))
            return tuple(np.asarray(row, dtype=first.dtype) for row in found)

        # of one shape: `jax.vmap` puts its axes in front of those that each argument has
        spread = (self.xp.broadcast_to(v, like.shape) for v in self.values)
        return jax.pure_callback(rows_of, (like,) * results, *spread, vmap_method="broadcast_all")

    def own(self, row: Array) -> Any:
        """A NumPy array in the library, on the device and, of floats, in the precision of these."""
        first = self.values[0]
        kind = first.dtype if row.dtype.kind == "f" else None
        if is_numpy_array(first):
            return single(np.asarray(row, dtype=kind))
        where = {} if is_lazy_array(first) else {"device": device(first)}
        return self.xp.asarray(row, dtype=kind, **where)


def single(values: Any) -> Any:
    """A number of NumPy's where there are no axes, as its own functions give it."""
    return np.asarray(values)[()]


def to_numpy(values: Any) -> Array:
    """Values as float64 NumPy array, wherever they are."""
    if is_torch_array(values):
        values = values.detach().cpu()
    elif hasattr(values, "get") and not is_numpy_array(values):
        values = values.get()  # CuPy
    return np.asarray(values, dtype=np.float64)


def _plain(name: str, value: Any) -> Any:
    """An array of real numbers as it is, numbers and lists as Python's floats."""
    if is_array_api_obj(value) and not is_numpy_array(value):
        allowed = ("bool", "integral", "real floating")
        if not array_namespace(value).isdtype(value.dtype, allowed):
            arguments.refuse_all(name, value)
        return value
    array = arguments.real(name, value)
    if isinstance(value, np.ndarray):
        return value if value.dtype == np.float32 else array
    return array.tolist()


def _is_traced(x: Any) -> bool:
    """Whether an array has no values yet."""
    if is_jax_array(x):
        return isinstance(x, sys.modules["jax"].core.Tracer)
    if is_torch_array(x):
        return bool(sys.modules["torch"].compiler.is_compiling())
    return bool(is_lazy_array(x))
