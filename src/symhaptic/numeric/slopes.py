"""Derivatives in JAX of functions that search for an angle or a wall.

JAX cannot differentiate a search.  The derivatives here are those of the stable forms at the angle
that was found, which the envelope theorem holds still; NumPy computes them.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from functools import cache, partial, wraps
from importlib import import_module
from inspect import signature
from typing import TYPE_CHECKING, Any, NoReturn, ParamSpec, TypeVar

import numpy as np

from symhaptic.numeric.arguments import Array
from symhaptic.numeric.extremum import Extremum

if TYPE_CHECKING:
    from symhaptic.forms.stable import Form

P = ParamSpec("P")
R = TypeVar("R")

Slopes = Callable[..., Mapping[tuple[str, str], Array]]
"""Maps the name of a result and that of an argument to the derivative, of float64 arrays."""


def in_jax(
    results: tuple[str, ...], by: tuple[str, ...] = (), slopes: Slopes | None = None
) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let JAX differentiate a function of arrays once, with respect to the arguments ``by``.

    A result without a derivative has NaN.  Another argument, and a second derivative, raise
    :class:`ValueError` in one line.
    """

    def around(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def called(*args: P.args, **named: P.kwargs) -> R:
            if not _traced(*args, *named.values()):
                return function(*args, **named)
            given = signature(function).bind(*args, **named).arguments
            words = {n: given.pop(n) for n in list(given) if isinstance(given[n], str)}
            asked = partial(_differentiated, function, tuple(given), words, results, by, slopes)
            found: R = asked(*given.values())
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
    *values: Any,
) -> Any:
    jax = sys.modules["jax"]
    jnp = jax.numpy
    kind = jnp.result_type(*values, 1.0)
    title = getattr(function, "__name__", "function")

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
                _refuse(title, name)
        if moved and slopes is not None:
            rows = _rows(slopes, title, results, tuple(moved), found[0], primals)
            for i, row in enumerate(rows):
                slope[i // len(moved)] += row * [*moved.values()][i % len(moved)]
        return found, tuple(slope)

    plain.defjvp(rule, symbolic_zeros=True)
    found = plain(*(jnp.asarray(v, dtype=kind) for v in values))
    if results == Extremum._fields:
        return Extremum(*found)
    return found if len(results) > 1 else found[0]


def _still(tangent: Any) -> bool:
    """Whether an argument is not differentiated by."""
    return isinstance(tangent, import_module("jax.custom_derivatives").SymbolicZero)


def _refuse(title: str, name: str) -> NoReturn:
    raise ValueError(
        f"{name}: {title} has no derivative with respect to it in JAX; "
        "take differences of its values"
    )


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
            f"{title}: has no second derivatives in JAX; take differences of the first"
        )

    once = jax.custom_jvp(called)
    once.defjvp(again)
    return tuple(once(*primals))


@cache
def compiled(form: Form) -> tuple[Callable[..., Any], tuple[str, ...]]:
    """A stable form with all its derivatives as a function of NumPy arrays, and its results."""
    from symhaptic.export import request
    from symhaptic.export.targets import TARGETS
    from symhaptic.forms.derivatives import differentiable, with_derivatives

    wanted = with_derivatives(form, differentiable(form))
    _, files = request.built(TARGETS["numpy"], [wanted], "slopes", vectors=False)
    space: dict[str, Any] = {}
    exec(compile(files["slopes.py"], f"<{wanted.name}>", "exec"), space)
    return space[wanted.name], tuple(name for name, _ in wanted.results)


def of(form: Form, *values: Array) -> dict[tuple[str, str], Array]:
    """The derivatives of a stable form by its arguments, of float64 arrays."""
    function, names = compiled(form)
    shape = np.broadcast_shapes(*(v.shape for v in values))
    rows = function(*(np.broadcast_to(v, shape) for v in values))
    found = {}
    for name, row in zip(names, rows, strict=True):
        result, by, argument = name.partition("_by_")
        if by:
            found[result, argument] = np.asarray(row)
    return found


def of_public(name: str, *values: Array) -> dict[tuple[str, str], Array]:
    """The derivatives of a public function, by the names that its arguments have."""
    from symhaptic.forms import stable

    found = of(stable.form(name), *values)
    return {(result, "delay" if by == "d" else by): row for (result, by), row in found.items()}


def of_passive_stiffness(delta: Array, delay: Array) -> dict[tuple[str, str], Array]:
    """The derivatives of the largest passive stiffness.

    At the wall of largest stiffness the margin m(alpha, beta, d) is 0 and does not change with
    beta, so that alpha changes with the delay by -m_d/m_alpha.  NaN without delay, where every
    angle is a worst one.
    """
    from symhaptic.forms import stable

    found = of_public("max_passive_stiffness", delta, delay)
    function, _ = compiled(stable.form("max_passive_stiffness"))
    alpha, beta = function(delta, delay)[:2]
    margin = of_public("passivity_margin", alpha, beta, delta, delay)
    slope = -margin["margin", "delay"] / margin["margin", "alpha"]
    found["alpha", "delay"] = np.where(delay == 0, np.nan, slope)
    return found
