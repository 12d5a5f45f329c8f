"""Labels, units, masks and laziness: what comes with them goes with them, or is refused.

One wrapper around every public numeric function.  None of these libraries is loaded unless an
argument is made of it.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping
from functools import partial, wraps
from typing import Any, NoReturn, ParamSpec, TypeVar, cast

import numpy as np

from symhaptic.notation.quantities import dimensionless, shown
from symhaptic.numeric.arguments import real
from symhaptic.numeric.compiled import WORDS

P = ParamSpec("P")
R = TypeVar("R")

_LIBRARIES = ("pint", "xarray", "dask", "pandas", "torch")


def kept(
    into: Callable[..., Any] | None = None, traced: bool = False, /, **kinds: type
) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let a function take and give arrays of xarray, Dask, pandas, Pint and with masks.

    ``kinds`` are the names of the results and their types; ``into`` is the tuple that they make.
    Unless it may be ``traced``, Torch's compiler breaks its graph at the function.
    """

    def around(function: Callable[P, R]) -> Callable[P, R]:
        names = [n for n in inspect.signature(function).parameters if n not in WORDS]

        @wraps(function)
        def wrapped(*args: P.args, **kwargs: P.kwargs) -> R:
            present = {_library(v) for v in (*args, *kwargs.values())}
            if present <= {""}:
                return function(*args, **kwargs)
            if "torch" in present and not traced and _compiled():
                return cast(R, sys.modules["torch"].compiler.disable(function)(*args, **kwargs))
            if present <= {"", "torch"}:
                return function(*args, **kwargs)
            bound = inspect.signature(function).bind(*args, **kwargs).arguments
            numbers = {n: bound.pop(n) for n in names if n in bound}
            found = _carried(partial(_by_name, wrapped, list(numbers), bound), numbers, kinds)
            return cast(R, into(*found) if into else found)

        return wrapped

    return around


def numbers_only(function: Callable[P, R]) -> Callable[P, R]:
    """Let a function of plain numbers take Pint's, and refuse labelled and lazy arrays."""

    @wraps(function)
    def wrapped(*args: P.args, **kwargs: P.kwargs) -> R:
        if {_library(v) for v in (*args, *kwargs.values())} <= {"", "torch"}:
            return function(*args, **kwargs)
        bound = inspect.signature(function).bind(*args, **kwargs).arguments
        for name, value in bound.items():
            if _library(value) == "pint":
                bound[name] = dimensionless(name, value)
            if _library(bound[name]) not in ("", "torch"):
                _refuse(name, value, "plain numbers")
        return cast(Callable[..., R], function)(**bound)

    return wrapped


def _library(value: object) -> str:
    """The library that a value's labels, units or laziness come from."""
    kind = type(value)
    if kind in (float, int, np.ndarray, str):
        return ""
    if isinstance(value, np.ma.MaskedArray):
        return "masked"
    for base in kind.__mro__[:-1]:
        root = base.__module__.partition(".")[0]
        if root in _LIBRARIES:
            return root
    return ""


def _compiled() -> bool:
    return bool(sys.modules["torch"].compiler.is_compiling())


def _by_name(function: Callable[..., Any], names: list[str], words: Any, *values: Any) -> Any:
    return function(**dict(zip(names, values, strict=True)), **words)


def _refuse(name: str, value: object, allowed: str) -> NoReturn:
    raise ValueError(f"{name}: {shown(value)} is not allowed; give {allowed}")


def _carried(
    work: Callable[..., Any], numbers: Mapping[str, Any], kinds: Mapping[str, type]
) -> Any:
    present = {_library(v) for v in numbers.values()}
    if "pint" in present:
        return _with_units(work, numbers, kinds)
    if "xarray" in present:
        return _by_dimension(work, numbers, kinds)
    if "dask" in present:
        return _lazily(work, numbers, kinds)
    if "pandas" in present:
        return _by_index(work, numbers, kinds)
    return _masked(work, numbers)


def _each(make: Callable[[str, Any], Any], found: Any, kinds: Mapping[str, type]) -> Any:
    if isinstance(found, tuple):
        return tuple(make(name, one) for name, one in zip(kinds, found, strict=True))
    return make(next(iter(kinds)), found)


def _with_units(
    work: Callable[..., Any], numbers: Mapping[str, Any], kinds: Mapping[str, type]
) -> Any:
    """Pint's numbers must have no dimension; 100 mm/m is 0.1.  So have real results."""
    import pint

    for name, value in numbers.items():
        if _library(value) == "pint" and not isinstance(value, pint.Quantity):
            _refuse(name, value, "quantities of Pint")
    first = next(v for v in numbers.values() if _library(v) == "pint")
    plain = (
        dimensionless(name, value) if _library(value) == "pint" else value
        for name, value in numbers.items()
    )

    def quantity(name: str, found: Any) -> Any:
        labelled = _library(found) in ("xarray", "pandas")  # which no quantity can hold
        wrapped = kinds[name] is float and not labelled
        return first._REGISTRY.Quantity(found, "") if wrapped else found

    return _each(quantity, work(*plain), kinds)


def _alone(numbers: Mapping[str, Any], library: str) -> None:
    """Refuse arrays without labels beside labelled ones: which axis is meant is not known."""
    for name, value in numbers.items():
        if _library(value) != library and (_library(value) != "" or np.ndim(value)):
            _refuse(name, value, f"arrays of {library} alone, or beside numbers")


def _by_dimension(
    work: Callable[..., Any], numbers: Mapping[str, Any], kinds: Mapping[str, type]
) -> Any:
    """xarray's arrays broadcast by the names of their dimensions; their coordinates must agree."""
    import xarray

    _alone(numbers, "xarray")
    for name, value in numbers.items():
        if isinstance(value, xarray.DataTree):
            _refuse(name, type(value), "a DataArray, a Dataset or a Variable of xarray")
    try:
        found = xarray.apply_ufunc(
            work,
            *numbers.values(),
            output_core_dims=[()] * len(kinds),
            dask="parallelized",
            output_dtypes=list(kinds.values()),
            join="exact",
            keep_attrs=False,
        )
    except xarray.AlignmentError as wrong:
        text = " ".join(str(wrong).split())
        raise ValueError(f"coordinates of the arguments: {text}") from None
    return _each(lambda name, one: one.rename(name) if hasattr(one, "name") else one, found, kinds)


def _lazily(work: Callable[..., Any], numbers: Mapping[str, Any], kinds: Mapping[str, type]) -> Any:
    """Compute Dask's arrays block by block on demand; other chunks or none are unified."""
    import dask.array

    for name, value in numbers.items():
        if _library(value) == "dask" and not isinstance(value, dask.array.Array):
            _refuse(name, type(value), "arrays of Dask")
        if _library(value) not in ("dask", ""):
            _refuse(name, value, "arrays of Dask alone, or beside plain ones")
    signature = ",".join(["()"] * len(numbers)) + "->" + ",".join(["()"] * len(kinds))
    return dask.array.apply_gufunc(
        work,
        signature,
        *numbers.values(),
        output_dtypes=list(kinds.values()),
        allow_rechunk=True,  # an elementwise function accepts any chunks
    )


def _by_index(
    work: Callable[..., Any], numbers: Mapping[str, Any], kinds: Mapping[str, type]
) -> Any:
    """Series or frames of pandas with equal indices."""
    import pandas

    _alone(numbers, "pandas")
    labelled = {n: v for n, v in numbers.items() if _library(v) == "pandas"}
    first = next(iter(labelled.values()))
    for name, value in labelled.items():
        if not isinstance(value, pandas.Series | pandas.DataFrame):
            _refuse(name, value, "a Series or a DataFrame of pandas")
        same = type(value) is type(first) and all(
            one.equals(other) for one, other in zip(value.axes, first.axes, strict=True)
        )
        if not same:
            _refuse(name, type(value), "the labels of the first")
    plain = (_numbers(n, v) if n in labelled else v for n, v in numbers.items())

    def labels(name: str, found: Any) -> Any:
        if isinstance(first, pandas.DataFrame):
            return pandas.DataFrame(found, index=first.index, columns=first.columns)
        return pandas.Series(found, index=first.index, name=name)

    return _each(labels, work(*plain), kinds)


def _numbers(name: str, labelled: Any) -> Any:
    """The numbers of a Series or frame; what is missing is NaN, and dates are no numbers."""
    try:
        values = labelled.to_numpy(na_value=np.nan)
    except (TypeError, ValueError):
        return _refuse(name, labelled, "real numbers")
    return real(name, values)


def _masked(work: Callable[..., Any], numbers: Mapping[str, Any]) -> Any:
    """What is masked in one argument is masked in the result."""
    plain = (real(n, v) if _library(v) == "masked" else v for n, v in numbers.items())
    found = work(*plain)
    masks = [np.ma.getmaskarray(v) for v in numbers.values() if _library(v) == "masked"]

    def masked(one: Any) -> Any:
        mask = np.any([np.broadcast_to(m, np.shape(one)) for m in masks], axis=0)
        return np.ma.MaskedArray(one, mask=mask)

    return tuple(map(masked, found)) if isinstance(found, tuple) else masked(found)
