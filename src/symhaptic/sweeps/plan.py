r"""A sweep as independent blocks.

All points are the product of named dimensions.  Blocks are cut from the dimensions that stay; one
block goes through all of those that are reduced, tile by tile and always in the same order, so that
its bits depend neither on how many work at the sweep nor on what was interrupted.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from threading import Lock
from typing import TYPE_CHECKING, Any, NamedTuple
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray

from symhaptic.numeric.arguments import real
from symhaptic.numeric.compiled import kernels_used
from symhaptic.sweeps.marks import package
from symhaptic.sweeps.quantities import Work

if TYPE_CHECKING:
    import xarray

POINTS = 2**22
"""Points of a block, those that are reduced counted: seconds of work, some 30 MB of results."""

_TILE = 2**17
"""Points that a function is given at once; what it makes of them on its way fits the memory."""


class Reduction(NamedTuple):
    """A reduction of values along dimensions."""

    combine: np.ufunc
    kind: type | None
    """The kind of values that it reduces; None for numbers and counts."""
    method: str
    """Its name in ``cell_methods`` of the CF conventions."""


REDUCTIONS = {
    "min": Reduction(np.minimum, None, "minimum"),
    "max": Reduction(np.maximum, None, "maximum"),
    "mean": Reduction(np.add, None, "mean"),
    "all": Reduction(np.logical_and, bool, "minimum"),
    "any": Reduction(np.logical_or, bool, "maximum"),
    "count": Reduction(np.add, bool, "sum"),
}


class Variable(NamedTuple):
    """One variable of the result."""

    name: str
    source: int
    """Which of the function's results it is."""
    word: str
    """Its reduction, or an empty string."""
    dtype: np.dtype[Any]
    attributes: dict[str, str]


@dataclass(frozen=True)
class Piece:
    """A block with all that is needed to compute it."""

    index: tuple[int, ...]
    region: tuple[slice, ...]
    """Its place in the result."""
    work: Work
    inputs: Mapping[str, NDArray[np.float64]]
    """Arrays of all dimensions, of length 1 where an argument does not have one."""
    shape: tuple[int, ...]
    """Points along all dimensions, those that stay first."""
    variables: tuple[Variable, ...]
    made: Mapping[str, str]
    """Versions that began the sweep, as :func:`maker` returns them."""
    functions: tuple[str, ...]
    """Marks of the function in the process that began the sweep.  Its mark here is one of them."""
    process: str
    """That process."""

    def compute(self) -> list[NDArray[Any]]:
        """The block of every variable."""
        if self.made != maker():
            own, first = (
                ", ".join(f"{name} {one[name]}" for name in one if self.made[name] != maker()[name])
                for one in (maker(), self.made)
            )
            raise ValueError(
                f"workers: this one has {own}, and the sweep began with {first}; give all workers "
                "the same, or the bits of their blocks may differ"
            )
        if self.functions and self.process != _PROCESS:
            _refuse_another(self.work, self.functions)
        kept = len(self.region)
        over = tuple(range(kept, len(self.shape)))
        found = [np.zeros(self.shape[:kept], _sum(v)) for v in self.variables]
        for tile in _tiles(self.shape):
            here = {
                n: a[tuple(s if k > 1 else slice(None) for k, s in zip(a.shape, tile, strict=True))]
                for n, a in self.inputs.items()
            }
            values = self.work(**here)
            count = 1 + max(v.source for v in self.variables)
            if len(values) != count and not self.work.results:
                raise ValueError(
                    f"quantity: {self.work.says} gives {len(values)} results at some points, and "
                    f"{count} at the first; give as many everywhere"
                )
            size = tuple(s.stop - s.start for s in tile)
            begins = all(s.start == 0 for s in tile[kept:])
            for into, variable in zip(found, self.variables, strict=True):
                value = np.broadcast_to(_kept(variable, values[variable.source]), size)
                into[tile[:kept]] = _reduced(variable, value, over, into[tile[:kept]], begins)
        total = math.prod(self.shape[kept:])
        return [
            into / total if v.word == "mean" else into.astype(v.dtype, copy=False)
            for into, v in zip(found, self.variables, strict=True)
        ]


_PROCESS = uuid4().hex
"""This process; a forked one has its functions too."""

_SAME = set[tuple[str, ...]]()
"""Marks of functions that are the same here as in the process that began the sweep."""

_ONE = Lock()


def _refuse_another(work: Work, begun: tuple[str, ...]) -> None:
    """Refuse a function that is another one here, before it is called for the first time."""
    with _ONE:
        if begun not in _SAME and work.body not in begun:
            raise ValueError(
                f"on: {work.says} is another function in a worker process, which imports it anew; "
                "set what it uses in its module and not later, or give on='threads'"
            )
        _SAME.add(begun)


def maker() -> dict[str, str]:
    """Versions that the bits of a result depend on."""
    return {"symhaptic": package(), "kernels": kernels_used(), "numpy": np.__version__}


def _kept(variable: Variable, value: Any) -> NDArray[Any]:
    """A result in the dtype of its variable; a user's function may return another dtype."""
    kind = _sum(variable)
    array = real(variable.name, value) if np.ma.isMaskedArray(value) else np.asarray(value)
    if np.can_cast(array.dtype, kind):
        return array
    if kind.kind == "f":
        return real(variable.name, array)
    if array.dtype.kind != "u" or kind != np.int64 or np.any(array > np.iinfo(kind).max):
        raise ValueError(
            f"{variable.name}: {array.dtype} is not allowed; the first point gave {kind}"
        )
    return array


def _sum(variable: Variable) -> np.dtype[Any]:
    """The dtype of partial results: truth values are counted."""
    return np.dtype(np.int64) if variable.word == "count" else variable.dtype


def _reduced(
    variable: Variable,
    value: NDArray[Any],
    over: tuple[int, ...],
    before: NDArray[Any],
    first: bool,
) -> NDArray[Any]:
    if not variable.word:
        return value
    combine = REDUCTIONS[variable.word].combine
    part = combine.reduce(value, axis=over, dtype=before.dtype)
    return np.asarray(part if first else combine(before, part))


def _tiles(shape: tuple[int, ...]) -> Iterator[tuple[slice, ...]]:
    """Tiles of at most ``_TILE`` points; the last dimension varies fastest."""
    lengths = _lengths(shape, _TILE)
    ranges = (range(0, n, step) for n, step in zip(shape, lengths, strict=True))
    for begin in itertools.product(*ranges):
        yield tuple(
            slice(b, min(b + step, n)) for b, step, n in zip(begin, lengths, shape, strict=True)
        )


def _lengths(shape: tuple[int, ...], points: int) -> tuple[int, ...]:
    """Lengths of equal parts of at most ``points`` points, undivided along the last dimensions."""
    lengths: list[int] = []
    for n in reversed(shape):
        parts = -(-n // max(1, min(n, points)))
        lengths.append(-(-n // parts))
        points //= lengths[-1]
    return tuple(reversed(lengths))


@dataclass(frozen=True)
class Plan:
    """All of a sweep except where it is computed and stored."""

    work: Work
    names: tuple[str, ...]
    """The arguments among the coordinates."""
    coords: xarray.Dataset
    """All arguments and labels, with the dimensions that they have."""
    kept: tuple[str, ...]
    over: tuple[str, ...]
    variables: tuple[Variable, ...]
    lengths: tuple[int, ...]
    """Lengths of a block along the dimensions that stay."""
    functions: tuple[str, ...] = ()
    """Marks of a function of the user's own, before and after it is called for the first time."""

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the result."""
        return tuple(self.coords.sizes[d] for d in self.kept)

    @property
    def labels(self) -> xarray.Dataset:
        """The coordinates that the result has."""
        return self.coords.drop_dims(self.over)

    @property
    def attributes(self) -> dict[str, str]:
        """Attributes of the dataset."""
        words = {name: str(value) for name, value in self.work.words.items()}
        if self.work.arm is not None:
            words["arm"] = str(self.work.arm)
        if self.work.scene is not None:
            words |= {n: repr(getattr(self.work.scene, n)) for n in self.work.scene.further}
        made = f"symhaptic {package()}, {kernels_used()} kernels"
        return {"title": self.work.says, "source": made, **words}

    @property
    def nbytes(self) -> int:
        """The memory that the result takes."""
        return math.prod(self.shape) * sum(v.dtype.itemsize for v in self.variables)

    @property
    def grid(self) -> tuple[int, ...]:
        """How many blocks there are along each dimension that stays."""
        return tuple(-(-n // step) for n, step in zip(self.shape, self.lengths, strict=True))

    def indices(self) -> Iterator[tuple[int, ...]]:
        """The blocks by their numbers."""
        return itertools.product(*map(range, self.grid))

    def piece(self, index: tuple[int, ...]) -> Piece:
        """One block."""
        ends = zip(index, self.lengths, self.shape, strict=True)
        region = tuple(slice(i * step, min((i + 1) * step, n)) for i, step, n in ends)
        part = self.coords.isel(dict(zip(self.kept, region, strict=True)))
        dims = (*self.kept, *self.over)
        inputs = {n: part[n].variable.set_dims(dims).transpose(*dims).values for n in self.names}
        shape = tuple(part.sizes[d] for d in dims)
        of = (self.work, inputs, shape, self.variables, maker(), self.functions, _PROCESS)
        return Piece(index, region, *of)

    def description(self) -> dict[str, Any]:
        """Everything that must be equal in two sweeps that share a store."""
        return {
            **maker(),
            "quantity": self.work.says,
            "function": self.functions[0] if self.functions else self.work.body,
            "words": {n: str(v) for n, v in self.work.words.items()},
            "arm": repr(self.work.arm),
            "parts": repr(self.work.scene),
            "variables": [[v.name, v.source, v.word, str(v.dtype)] for v in self.variables],
            "inputs": {
                name: [
                    list(self.coords[name].dims),
                    hashlib.sha256(self.coords[name].values.tobytes()).hexdigest(),
                ]
                for name in self.names
            },
            "dimensions": [[d, self.coords.sizes[d]] for d in self.kept],
            "over": [[d, self.coords.sizes[d]] for d in self.over],
            "blocks": list(self.lengths),
        }

    @property
    def mark(self) -> str:
        """Digest of the description."""
        said = json.dumps(self.description(), sort_keys=True)
        return hashlib.sha256(said.encode()).hexdigest()

    def empty(self) -> xarray.Dataset:
        """The result without its values: arrays of Dask that are all zero and take no memory."""
        import dask.array

        zeros = dask.array.zeros(self.shape, chunks=self.lengths or -1)
        return self.filled([zeros.astype(v.dtype) for v in self.variables])

    def filled(self, values: Sequence[Any]) -> xarray.Dataset:
        """The result with the values of each variable."""
        pairs = zip(self.variables, values, strict=True)
        found = self.labels.assign({v.name: (self.kept, value, v.attributes) for v, value in pairs})
        return found.assign_attrs(self.attributes)

    def lazily(self, work: Callable[[Piece], list[NDArray[Any]]]) -> xarray.Dataset:
        """The blocks as arrays of Dask: each is computed or read when it is asked for."""
        import dask.array

        kind = np.result_type(*(v.dtype for v in self.variables))

        def block(block_id: tuple[int, ...]) -> NDArray[Any]:
            found = work(self.piece(block_id[1:]))
            return np.stack([value.astype(kind, copy=False) for value in found])

        chunks = dask.array.core.normalize_chunks(self.lengths, self.shape)
        every = dask.array.map_blocks(
            block, chunks=((len(self.variables),), *chunks), dtype=kind,
            meta=np.zeros((0,) * (1 + len(self.shape)), kind),
        )  # fmt: skip
        return self.filled([every[i].astype(v.dtype) for i, v in enumerate(self.variables)])


def lengths_of(
    kept: Mapping[str, int], over: Mapping[str, int], chunks: int | Mapping[str, int] | None
) -> tuple[int, ...]:
    """Lengths of blocks, from a number of points or from lengths by dimension."""
    points = POINTS if chunks is None or isinstance(chunks, Mapping) else chunks
    found = _lengths(tuple(kept.values()), max(1, points // math.prod(over.values())))
    if not isinstance(chunks, Mapping):
        return found
    named = dict(zip(kept, found, strict=True)) | dict(chunks)
    return tuple(min(named[d], kept[d]) for d in kept)
