"""Derivatives in JAX of functions that search for an angle or a wall.

JAX cannot differentiate a search.  Its derivatives are given by a function of NumPy arrays, or
refused in one line.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from functools import wraps
from importlib import import_module
from inspect import signature
from typing import Any, NoReturn, ParamSpec, TypeVar

import numpy as np

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import WORDS
from symhaptic.numeric.extremum import Extremum

P = ParamSpec("P")
R = TypeVar("R")

Slopes = Callable[..., Mapping[tuple[str, str], Array]]
"""Maps the name of a result and that of an argument to the derivative, of float64 arrays."""


DIFFERENCES = "take differences of its values"


def in_jax(
    results: tuple[str, ...],
    by: tuple[str, ...] = (),
    slopes: Slopes | None = None,
    instead: str = DIFFERENCES,
) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let JAX differentiate a function of arrays once, with respect to the arguments ``by``.

    The derivatives are given by ``slopes``, or else those of a wall that is proportional to delta.
    A result without a derivative has NaN.  For another argument and for a second derivative a
    :class:`ValueError` says in one line what to do ``instead``.
    """

    def around(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def called(*args: P.args, **named: P.kwargs) -> R:
            if not _traced(*args, *named.values()):
                return function(*args, **named)
            given = signature(function).bind(*args, **named).arguments
            words = {n: given.pop(n) for n in list(given) if n in WORDS}
            found: R = _differentiated(function, tuple(given), words, results, by, slopes, instead)(
                *given.values()
            )
            return found

        return called

    return around


def _traced(*values: Any) -> bool:
    jax = sys.modules.get("jax")
    return jax is not None and any(isinstance(v, jax.core.Tracer) for v in values)


def _differentiated(
    function: Callable[..., Any],
    names: tuple[str, ...],
    words: Mapping[str, Any],
    results: tuple[str, ...],
    by: tuple[str, ...],
    slopes: Slopes | None,
    instead: str,
) -> Callable[..., Any]:
    jax = sys.modules["jax"]
    jnp = jax.numpy
    title = getattr(function, "__name__", "function")
    if slopes is None and by:
        slopes = per_damping(function, names)

    def values_of(*arrays: Any) -> tuple[Any, ...]:
        found = function(**dict(zip(names, arrays, strict=True)), **words)
        return tuple(found) if isinstance(found, tuple) else (found,)

    plain = jax.custom_jvp(values_of)

    def rule(primals: Any, tangents: Any) -> Any:
        found = plain(*primals)
        moved = {n: t for n, t in zip(names, tangents, strict=True) if not _still(t)}
        slope = [jnp.zeros_like(one) for one in found]
        for name in moved:
            if name not in by or words.get("sheet", "exact") != "exact":
                raise ValueError(
                    f"{name}: JAX cannot differentiate {title} with respect to it; {instead}"
                )
        if moved and slopes is not None:
            rows = _rows(slopes, title, results, tuple(moved), found[0], primals)
            for i, row in enumerate(rows):
                slope[i // len(moved)] += row * [*moved.values()][i % len(moved)]
        return found, tuple(slope)

    plain.defjvp(rule, symbolic_zeros=True)

    def called(*values: Any) -> Any:
        kind = jnp.result_type(*values, 1.0)
        found = plain(*(jnp.asarray(v, dtype=kind) for v in values))
        if results == Extremum._fields:
            return Extremum(*found)
        return found if len(results) > 1 else found[0]

    return called


def _still(tangent: Any) -> bool:
    """Whether an argument is not differentiated by."""
    return isinstance(tangent, import_module("jax.custom_derivatives").SymbolicZero)


def _rows(
    slopes: Slopes,
    title: str,
    results: tuple[str, ...],
    moved: tuple[str, ...],
    like: Any,
    primals: tuple[Any, ...],
) -> tuple[Any, ...]:
    """The derivatives of the first result by the arguments that move, then of the next."""
    jax = sys.modules["jax"]

    def computed(*values: Any) -> tuple[Array, ...]:
        arrays = [np.asarray(v, dtype=np.float64) for v in values]
        found = slopes(*arrays)
        none = np.full(np.broadcast_shapes(*(a.shape for a in arrays)), np.nan)
        return tuple(
            np.asarray(found.get((result, name), none), dtype=like.dtype)
            for result in results
            for name in moved
        )

    shape = jax.ShapeDtypeStruct(like.shape, like.dtype)

    def called(*arrays: Any) -> tuple[Any, ...]:
        spread = (jax.numpy.broadcast_to(a, like.shape) for a in arrays)
        shapes = (shape,) * (len(results) * len(moved))
        return tuple(jax.pure_callback(computed, shapes, *spread, vmap_method="broadcast_all"))

    def again(primals: Any, tangents: Any) -> NoReturn:
        raise ValueError(
            f"{title}: JAX cannot differentiate it twice; take differences of the first derivative"
        )

    once = jax.custom_jvp(called)
    once.defjvp(again)
    return tuple(once(*primals))


def per_damping(function: Callable[..., Any], names: tuple[str, ...]) -> Slopes:
    """The derivatives by ``delta`` of a wall that is proportional to it: the wall for delta = 1."""

    def found(*values: Array) -> dict[tuple[str, str], Array]:
        given = dict(zip(names, values, strict=True))
        alpha, beta, *_ = function(**{**given, "delta": np.ones_like(given["delta"])})
        return {
            ("alpha", "delta"): alpha,
            ("beta", "delta"): beta,
            ("theta", "delta"): np.zeros_like(alpha),
        }

    return found
