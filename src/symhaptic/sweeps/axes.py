"""From what somebody asks to a plan: arguments, dimensions, and what is impossible."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from symhaptic.notation.quantities import in_unit, shown
from symhaptic.notation.suggest import suggested
from symhaptic.notation.units import spelled
from symhaptic.numeric import arguments
from symhaptic.scene.arms import UNITS
from symhaptic.scene.scene import Scene
from symhaptic.sweeps.plan import REDUCTIONS, Plan, Variable, lengths_of
from symhaptic.sweeps.quantities import INPUTS, Meaning, Result, Work, work_of


def scene_or_none(scene: Scene | None) -> None:
    """Raise :class:`ValueError` for what is no scene."""
    if scene is not None and not isinstance(scene, Scene):
        raise ValueError(f"scene: {shown(scene)} is not allowed; give a Scene")


def plan_of(
    quantity: str | Callable[..., Any],
    scene: Scene | None,
    over: str | Sequence[str],
    reduce: str | Sequence[str],
    chunks: int | Mapping[str, int] | None,
    axes: Mapping[str, Any],
    marked: bool = False,
) -> Plan:
    """What is computed, where, and in which blocks.

    ``marked`` is whether a function of the user's own is compared with that of another process.
    Raises :class:`ValueError` for what is impossible.
    """
    import xarray

    scene_or_none(scene)
    work = work_of(quantity, axes, scene)
    given = {n: v for n, v in axes.items() if n not in work.words}
    if scene is not None:
        given = _of_scene(scene, work, given)
    meanings = work.meanings if scene is not None else INPUTS
    _named(work, given)
    coords: dict[str, Any] = {}
    sizes: dict[str, int] = {}
    for name, value in given.items():
        made = _coordinates(name, value, meanings.get(name), bool(work.results))
        for label, coord in made.items():
            _agree(name, label, coords.setdefault(label, coord), coord)
        for dim, size in zip(made[name].dims, made[name].shape, strict=True):
            if sizes.setdefault(dim, size) != size:
                raise ValueError(f"{name}: {size} values along {dim!r} are not allowed; "
                                 f"give {sizes[dim]}")  # fmt: skip
    along, reduced = _words("over", over), _words("reduce", reduce)
    for dim in along:
        if dim not in sizes:
            raise ValueError(f"over: {dim!r} is not allowed; {suggested(dim, sizes)}")
        if along.count(dim) > 1:
            raise ValueError(f"over: {shown(over)} is not allowed; give each dimension once")
    if bool(along) != bool(reduced):
        raise ValueError(f"over: {along!r} with reduce={reduced!r} is incomplete; "
                         "give both or neither")  # fmt: skip
    stay = {d: n for d, n in sizes.items() if d not in along}
    before = _marks(work) if marked else ()
    first = {n: coords[n].values.reshape(-1)[0] for n in given}
    variables = tuple(
        _variable(i, result, work.statement, word, reduced, along)
        for i, result in enumerate(work.results or _results(work, first))
        for word in (reduced or ("",))
    )
    functions = (*before, *_marks(work)) if before else ()
    kept = {n for n, c in coords.items() if not set(c.dims) & set(along)}
    for taken in {v.name for v in variables} & {*stay, *kept}:
        raise ValueError(f"{taken}: a result has the name of this dimension or coordinate; "
                         "rename the dimension or coordinate")  # fmt: skip
    lengths = lengths_of(stay, {d: sizes[d] for d in along}, _chunks(chunks, stay))
    dataset = xarray.Dataset(coords=coords)
    return Plan(work, tuple(given), dataset, tuple(stay), along, variables, lengths, functions)


def _marks(work: Work) -> tuple[str, ...]:
    """The mark of a function of the user's own as it is now, if it has one."""
    try:
        return () if work.results else (work.body,)
    except ValueError:
        return ()


def _agree(name: str, label: str, known: Any, coord: Any) -> None:
    """Refuse labels that differ from those of an argument before: values stand by place."""
    if not known.equals(coord):
        raise ValueError(f"{name}: its labels {label!r} are not allowed; another argument "
                         "has others")  # fmt: skip


def _words(name: str, value: str | Sequence[str]) -> tuple[str, ...]:
    words: tuple[Any, ...] = (value,)
    if isinstance(value, Iterable) and not isinstance(value, str):
        words = tuple(value)
    if not all(isinstance(word, str) for word in words):
        raise ValueError(f"{name}: {shown(value)} is not allowed; give a word or several")
    return words


def _of_scene(scene: Scene, work: Work, given: Mapping[str, Any]) -> dict[str, Any]:
    """The given arguments, and the scene's own for the others; masses are those of the device."""
    if "delay" in given and "delay_samples" in given:
        raise ValueError("delay_samples: delay= says the same; give one of them")
    found: dict[str, Any] = dict(given)
    for name in work.arguments:
        if name == "delay":
            if not {"delay", "delay_samples"} & set(given):
                own = "delay_samples" if scene.delay_samples is not None else "delay"
                found[own] = getattr(scene, own) or 0.0
        elif name in (*UNITS, "sampling_period") and name not in given:
            found[name] = getattr(scene, name) or 0.0
    return found


def _named(work: Work, given: Mapping[str, Any]) -> None:
    """Refuse arguments that the quantity has not, and lacking ones."""
    allowed = [*work.arguments, *(["delay_samples"] if work.in_si else [])]
    for name in given:
        if name not in allowed or (name == "delay_samples" and "delay" not in work.arguments):
            raise ValueError(
                f"{name}: this quantity has no such argument; {suggested(name, allowed)}"
            )
    lacking = [n for n in work.arguments if n not in given]
    lacking = [n for n in lacking if n != "delay" or "delay_samples" not in given]
    if lacking:
        raise ValueError(f"{lacking[0]}: is missing; {work.says} takes {', '.join(allowed)}")


def _coordinates(name: str, value: Any, meaning: Meaning | None, known: bool) -> dict[str, Any]:
    """An argument, and the labels that it has, as variables with dimensions."""
    import xarray

    kind = type(value).__module__.partition(".")[0]
    found: dict[str, Any] = {}
    if kind == "pandas" and hasattr(value, "to_xarray"):
        value, kind = value.to_xarray(), "xarray"
    if kind == "dask" or isinstance(value, np.ma.MaskedArray):
        raise ValueError(f"{name}: {shown(value)} is not allowed; give arrays in memory without "
                         "masks")  # fmt: skip
    dims: tuple[str, ...] | None = None
    if kind == "xarray":
        if not isinstance(value, xarray.DataArray):
            raise ValueError(f"{name}: {shown(value)} is not allowed; give xarray's DataArrays")
        dims = tuple(map(str, value.dims))
        found = {str(n): xarray.Variable(c.dims, c.values, c.attrs)
                 for n, c in value.coords.items() if c.dims}  # fmt: skip
        value = value.data
    value = in_unit(name, value, spelled(meaning.unit) if meaning else "")
    array = arguments.real(name, value)
    if known:
        _check(name, array)
    if dims is None:
        if array.ndim > 1:
            raise ValueError(f"{name}: {array.ndim} dimensions are not allowed; give one, "
                             "or xarray's, which have names")  # fmt: skip
        dims = (name,) if array.ndim else ()
    if not array.size:
        raise ValueError(f"{name}: no values are not allowed; give one or more")
    said = meaning.attributes if meaning else {}
    return {**found, name: xarray.Variable(dims, array, said)}


def _check(name: str, array: Any) -> None:
    """Refuse what is out of range before anything is computed."""
    if name in ("mass", "inertia", "sampling_period"):
        bad = ~(array > 0) | np.isinf(array)
        arguments.refuse(name, array, bad, f"finite numbers {name} > 0")
    elif name in ("stiffness", "damping", "delay_samples"):
        bad = (array < 0) | np.isinf(array)
        arguments.refuse(name, array, bad, f"finite numbers {name} >= 0")
    else:
        arguments.check(name, array, np)


def _results(work: Work, first: Mapping[str, Any]) -> tuple[Result, ...]:
    """What a function of the user's own gives, by asking for the first point."""
    found = work.function(**first, **work.words)
    several = found if isinstance(found, tuple) else (found,)
    if not several:
        raise ValueError(f"quantity: {work.says} returns nothing; give it a result")
    names = getattr(found, "_fields", None) or [
        work.says if len(several) == 1 else f"{work.says}_{i}" for i in range(len(several))
    ]
    kinds = {"b": bool, "i": int, "u": int}
    arrays = (arguments.real(n, v) if np.asarray(v).dtype.kind not in kinds else np.asarray(v)
              for n, v in zip(names, several, strict=True))  # fmt: skip
    return tuple(
        Result(name, Meaning("", name), kinds.get(array.dtype.kind, float))
        for name, array in zip(names, arrays, strict=True)
    )


def _variable(
    source: int,
    result: Result,
    statement: str,
    word: str,
    words: Sequence[str],
    along: Sequence[str],
) -> Variable:
    dtype: np.dtype[Any] = np.dtype(result.kind)
    formula = {"formula": statement} if statement else {}
    if not word:
        return Variable(result.name, source, "", dtype, result.meaning.attributes | formula)
    if word not in REDUCTIONS:
        raise ValueError(f"reduce: {word!r} is not allowed; {suggested(word, REDUCTIONS)}")
    _, kind, method = REDUCTIONS[word]
    truth = result.kind is bool
    if (kind is bool and not truth) or (truth and word in ("min", "max")):
        allowed = "all, any, mean or count" if truth else "min, max or mean"
        raise ValueError(f"reduce: {word!r} of {result.name} is not allowed; give {allowed}")
    if word == "mean":
        dtype = np.dtype(float)
    elif word == "count":
        dtype = np.dtype(np.int64)
    name = result.name if len(words) == 1 else f"{result.name}_{word}"
    cells = {"cell_methods": f"{' '.join(f'{d}:' for d in along)} {method}"}
    unit = {"units": "1"} if word == "count" else {}
    return Variable(name, source, word, dtype, result.meaning.attributes | unit | cells | formula)


def _chunks(
    chunks: int | Mapping[str, int] | None, stay: Mapping[str, int]
) -> int | Mapping[str, int] | None:
    """Whole numbers, by dimensions that stay."""
    numbers = chunks.values() if isinstance(chunks, Mapping) else [] if chunks is None else [chunks]
    for number in numbers:
        if not isinstance(number, int) or isinstance(number, bool) or number < 1:
            raise ValueError(f"chunks: {shown(number)} is not allowed; give whole numbers > 0")
    for dim in chunks if isinstance(chunks, Mapping) else ():
        if dim not in stay:
            raise ValueError(f"chunks: {dim!r} is not allowed; {suggested(dim, stay)}")
    return chunks
