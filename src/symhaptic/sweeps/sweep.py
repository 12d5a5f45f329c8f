"""Any quantity over named axes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import shown
from symhaptic.numeric.renamed import with_new_names
from symhaptic.sweeps.axes import plan_of
from symhaptic.sweeps.plan import Piece, Plan
from symhaptic.sweeps.stores import store
from symhaptic.sweeps.work import done, executor

if TYPE_CHECKING:
    import xarray
    from distributed import Client
    from numpy.typing import NDArray

    from symhaptic.scene.scene import Scene


def sweep(
    quantity: str | Callable[..., Any],
    scene: Scene | None = None,
    *,
    over: str | Sequence[str] = (),
    reduce: str | Sequence[str] = (),
    to: str | Path | None = None,
    on: str | Executor | Client = "threads",
    workers: int | None = None,
    chunks: int | Mapping[str, int] | None = None,
    lazy: bool | None = None,
    **axes: Any,
) -> xarray.Dataset:
    """Compute a quantity at all points of named axes.

    Parameters
    ----------
    quantity : str or callable
        A public function of arrays or its name, such as ``"is_stable"``, or a function of your own,
        which takes arrays by name and computes each point by itself: it is given a part of the
        points at a time.  Processes must be able to import it.
    scene : Scene, optional
        With a scene, axes and results are in SI units, and the scene provides the values that no
        axis gives.  For stability, the scene's arm is added to the device, (2); for passivity, it
        is ignored, (3).
    over : str or sequence of str, optional
        Dimensions that are reduced.
    reduce : str or sequence of str, optional
        Reductions: ``"min"``, ``"max"`` or ``"mean"`` of numbers, ``"all"``, ``"any"``, ``"mean"``
        or ``"count"`` of truth values.  NaN is included.
    to : str or Path, optional
        Store the result block by block: a name or the address of a store that ends in ``.zarr``, or
        a name that ends in ``.parquet``.  To resume an interrupted sweep, make the same call again.
    on : str, executor or client, optional
        What computes the blocks: ``"threads"`` (the kernels release the lock), ``"processes"``, an
        executor of ``concurrent.futures``, or a client of dask.distributed.
    workers : int, optional
        Number of threads or processes.
    chunks : int or dict, optional
        Points of a block, four million by default, or its lengths by dimension.
    lazy : bool, optional
        Return Dask arrays and compute nothing yet.  The default for a result that is larger than
        half of the memory and is not stored.
    **axes
        Arguments of the quantity: numbers, one-dimensional arrays, or xarray's arrays.  A
        one-dimensional array becomes a dimension with the name of its argument.  Give one shared
        dimension to gamma and delta of the same arms.  With a scene: ``stiffness``, ``damping``,
        ``mass``, ``sampling_period``, ``delay`` or ``delay_samples`` of the device, ``K`` and ``B``
        of a wall, or ``frequency_hz``.

    Returns
    -------
    xarray.Dataset
        The results over the axes, with units and meanings, the same bit for bit wherever a block is
        computed.  With a scene in N/m, Ns/m, s and Hz.

    Raises
    ------
    ValueError
        Before the sweep begins, if it is impossible, or if a store at ``to`` was made by another
        call, by changed code, or is being written by a second process.
    ModuleNotFoundError
        Without the extra ``symhaptic[sweep]``.

    Examples
    --------
    >>> import numpy as np
    >>> found = sweep("max_stable_stiffness", gamma=0.0, delta=[0.0, 0.02], delay=np.arange(3))
    >>> found.alpha.dims, found.alpha.attrs["units"]
    (('delta', 'delay'), '1')
    >>> found.alpha.sel(delta=0.02).round(4).values
    array([0.7132, 0.1548, 0.0691])
    """
    needed("symhaptic.sweep", "dask", "xarray", extra="sweep")
    if getattr(quantity, "__name__", quantity) == "passivity_boundary":
        axes = with_new_names(axes, {"omega": "theta"})
    plan = plan_of(quantity, scene, over, reduce, chunks, axes, to is not None or on != "threads")
    total = int(np.prod(plan.grid))
    if to is not None:
        if lazy:
            raise ValueError(
                f"lazy: {lazy!r} and to={shown(to)} exclude each other; give one of them"
            )
        place = store(to, plan)
        place.begin(plan)
        if next(place.missing(plan), None) is not None:
            with place.alone(), executor(on, workers) as pool:
                missing = list(place.missing(plan))
                for _ in done(pool, place.finish, map(plan.piece, missing), len(missing), total):
                    pass
        return plan.lazily(place.read)
    if lazy or (lazy is None and _large(plan)):
        return plan.lazily(Piece.compute)
    found = [np.empty(plan.shape, v.dtype) for v in plan.variables]
    with executor(on, workers) as pool:
        for region, values in done(pool, _placed, map(plan.piece, plan.indices()), total, total):
            for into, value in zip(found, values, strict=True):
                into[region] = value
    return plan.filled(found)


def _placed(piece: Piece) -> tuple[tuple[slice, ...], list[NDArray[Any]]]:
    """A block and where it belongs."""
    return piece.region, piece.compute()


_SMALL = 10**8
"""Bytes that fit any memory."""


def _large(plan: Plan) -> bool:
    """Whether the result is larger than half of the memory."""
    if plan.nbytes < _SMALL:
        return False
    needed("symhaptic.sweep of a result so large", "distributed", extra="sweep")
    from distributed.system import MEMORY_LIMIT

    return 2 * plan.nbytes > MEMORY_LIMIT
