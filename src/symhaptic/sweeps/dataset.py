"""What a sweep gives: xarray's Dataset, whose attributes say what everything is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.sweeps.plan import Piece, Plan

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray


def empty(plan: Plan, coords: Mapping[str, Any]) -> xarray.Dataset:
    """The result without its values: arrays of Dask that are all zero and take no memory."""
    import dask.array
    import xarray

    held = {
        v.name: (
            plan.kept,
            dask.array.zeros(plan.shape, dtype=v.dtype, chunks=plan.lengths or -1),
            v.attributes,
        )
        for v in plan.variables
    }
    return xarray.Dataset(held, coords, plan.attributes)


def lazily(
    plan: Plan, like: xarray.Dataset, work: Callable[[Piece], list[NDArray[Any]]]
) -> xarray.Dataset:
    """The blocks as arrays of Dask: each is computed or read when it is asked for."""
    import dask.array

    kind = np.result_type(*(v.dtype for v in plan.variables))

    def block(block_id: tuple[int, ...]) -> NDArray[Any]:
        found = work(plan.piece(block_id[1:]))
        return np.stack([value.astype(kind, copy=False) for value in found])

    ends = zip(plan.shape, plan.lengths, strict=True)
    chunks = tuple(tuple(min(step, n - begin) for begin in range(0, n, step)) for n, step in ends)
    count = len(plan.variables)
    every = dask.array.map_blocks(
        block, chunks=((count,), *chunks), dtype=kind, meta=np.zeros((0,) * (1 + len(chunks)), kind)
    )
    return like.assign(
        {
            v.name: (plan.kept, every[i].astype(v.dtype), v.attributes)
            for i, v in enumerate(plan.variables)
        }
    )
