"""Where finished blocks are kept, so that a sweep goes on where it was killed.

A block counts as done when a mark says so that is written after it.  What a killed process had
begun is computed again, and the end has the same bytes as without the kill.  Checksums are compared
when a block is read.
"""

from __future__ import annotations

import json
import math
import os
import sys
import zlib
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Protocol
from uuid import uuid4

import numpy as np

from symhaptic.book.processes import folder
from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import shown
from symhaptic.sweeps.dataset import lazily
from symhaptic.sweeps.plan import Piece, Plan

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

PLAN = "symhaptic_sweep"
"""The attribute that says which sweep it is."""

_DRAFT = "_draft-"
"""Beginning of the name of a file of Parquet that is being written; its readers pass over it."""

_TAKEN = ("blocks", "zarr.json")
"""Names of its own in a group."""


class Store(Protocol):
    """A place for blocks."""

    def begin(self, plan: Plan, empty: xarray.Dataset) -> None:
        """Make it ready, or see that it is the same sweep that it was begun for."""

    def alone(self) -> AbstractContextManager[None]:
        """Refuse a second writer on this machine, and remove drafts of one that was killed."""

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """The blocks that are not done."""

    def finish(self, piece: Piece) -> None:
        """Compute a block and keep it, unless it is done; for workers."""

    def open(self, plan: Plan, empty: xarray.Dataset) -> xarray.Dataset:
        """What is kept, read when it is asked for."""


def store(to: str | Path) -> Store:
    """Zarr or Parquet, by the end of the name."""
    place = str(to).rstrip("/")
    if place.endswith(".zarr"):
        needed("symhaptic.sweep to a Zarr store", "zarr", extra="sweep")
        return Zarr(place)
    if place.endswith(".parquet") and "://" not in place:
        needed("symhaptic.sweep to Parquet files", "pyarrow", extra="sweep")
        return Parquet(place)
    raise ValueError(
        f"to: {place!r} is not allowed; give a name that ends in .zarr, or a folder's that "
        "ends in .parquet"
    )


def _begun(place: str, said: str | bytes | None, plan: Plan, where: str) -> None:
    """Refuse what is there and is not this sweep; ``where`` is the file that says which it is."""
    if said is None:
        raise ValueError(f"to: {place!r} is not allowed; it is there and holds no sweep")
    try:
        was = json.loads(said)
    except ValueError:
        was = None
    if not isinstance(was, dict):
        raise _damaged(place, where)
    now = json.loads(plan.description())
    if was != now:
        other = ", ".join(key for key in now if was.get(key) != now[key])
        raise ValueError(
            f"to: {place!r} is not allowed; it holds another sweep, which differs in {other}"
        )


def _damaged(place: str, where: str) -> ValueError:
    return ValueError(
        f"to: {place!r} is not allowed; its file {where}, which says what it holds, is damaged; "
        "give another place, or remove this one"
    )


_WRONG = (KeyError, TypeError, ValueError, RuntimeError)
"""What Zarr, and what it decompresses with, raise for files that are damaged."""


@contextmanager
def _readable(place: str) -> Iterator[None]:
    """Report damage of what describes a group."""
    try:
        yield
    except _WRONG as wrong:
        raise ValueError(
            f"to: a zarr.json, a label or a mark in {place!r} is damaged ({wrong}); give another "
            "place, or remove this one"
        ) from None


def _bad_block(files: str, mark: str) -> ValueError:
    return ValueError(
        f"to: {files} is damaged or missing; delete {mark}, and the same call computes this block "
        "again"
    )


@contextmanager
def _alone(place: str, file: str, drafts: str) -> Iterator[None]:
    """Lock a file as long as this process writes; the system unlocks it if that is killed."""
    with open(Path(place) / file, "r+b") as held:
        if sys.platform != "win32":
            import fcntl

            try:
                fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise ValueError(
                    f"to: another process is writing to {place!r}; wait until it has ended, or "
                    "give another place"
                ) from None
        for draft in Path(place).rglob(drafts):
            draft.unlink(missing_ok=True)
        yield


@contextmanager
def _beside(place: Path) -> Iterator[Path]:
    """Where it is made before it has its name, in a folder of its own that does not stay."""
    stack = ExitStack()
    try:
        draft = stack.enter_context(folder(f".{place.name}-", place.parent))
    except (OSError, ValueError) as wrong:
        reason = wrong.strerror if isinstance(wrong, OSError) else wrong
        raise ValueError(
            f"to: {str(place)!r} is not allowed; it cannot be made there ({reason}); "
            "give a name in a folder that can be written"
        ) from None
    with stack:
        yield draft / "new"


def _named(draft: Path, place: str) -> None:
    """Give a store its name, unless another process has made it there first."""
    try:
        os.rename(draft, place)
    except OSError:
        if not os.path.lexists(place):
            raise


@dataclass(frozen=True)
class Zarr:
    """A Zarr group: one chunk a block, and in ``blocks/done`` checksums of each that is done."""

    place: str

    _ABOUT: ClassVar = "zarr.json"

    def begin(self, plan: Plan, empty: xarray.Dataset) -> None:
        """Make the group whole at once, under another name first where names can be changed."""
        import zarr

        local = "://" not in self.place
        if not local or os.path.lexists(self.place):
            try:
                found = zarr.open_group(self.place, mode="r")
            except FileNotFoundError:
                if local:
                    _begun(self.place, None, plan, self._ABOUT)
            except _WRONG:
                raise _damaged(self.place, self._ABOUT) from None
            else:
                said = found.attrs.get(PLAN)
                _begun(self.place, said if isinstance(said, str) else None, plan, self._ABOUT)
                return self._labelled(empty)
        for name, coord in empty.coords.items():
            self._to_be_kept(str(name), coord)
        if not local:
            return self._made(self.place, plan, empty)
        with _beside(Path(self.place)) as place:
            self._made(str(place), plan, empty)
            _named(place, self.place)
        return self.begin(plan, empty)

    @staticmethod
    def _made(place: str, plan: Plan, empty: xarray.Dataset) -> None:
        """A group without values, in which no block is done."""
        import zarr
        from zarr.codecs import Crc32cCodec, ZstdCodec

        kept: dict[str, dict[str, Any]] = {
            str(name): {"compressors": (ZstdCodec(level=0), Crc32cCodec())}
            for name in empty.variables
        }
        for name in map(str, empty.data_vars):
            kept[name] |= {"chunks": plan.lengths} if plan.lengths else {}
        empty.to_zarr(place, compute=False, encoding=kept, consolidated=False, zarr_format=3)
        group = zarr.open_group(place, mode="r+")
        count = len(plan.variables)
        group.create_array(
            "blocks/done", shape=(*plan.grid, count), chunks=(*(1 for _ in plan.grid), count),
            dtype="uint64", fill_value=0, compressors=None,
        )  # fmt: skip
        group.attrs[PLAN] = plan.description()

    def _to_be_kept(self, name: str, coord: xarray.DataArray) -> None:
        """Refuse labels that Zarr would lose or change."""
        import xarray
        from zarr.storage import MemoryStore

        tried = MemoryStore()
        try:
            xarray.Dataset(coords={name: coord}).to_zarr(tried, consolidated=False, zarr_format=3)
            found = xarray.open_zarr(tried, consolidated=False, chunks=None)
        except (TypeError, ValueError):
            found = xarray.Dataset()
        if name in _TAKEN or name not in found or not found[name].equals(coord):
            raise ValueError(
                f"{name}: {shown(coord.values)} as labels are not allowed in {self.place!r}; "
                "give numbers, text or dates, with a plain name and plain attributes"
            )

    def _labelled(self, empty: xarray.Dataset) -> None:
        """Refuse a sweep of other labels."""
        import xarray

        with _readable(self.place):
            found = xarray.open_zarr(self.place, consolidated=False, chunks=None).coords
            for coord in found.values():
                coord.load()
        for name in sorted({*map(str, found), *map(str, empty.coords)}):
            if name not in found or name not in empty.coords or not (
                found[name].equals(empty.coords[name])
            ):  # fmt: skip
                raise ValueError(
                    f"to: {self.place!r} is not allowed; it holds another sweep, which differs in "
                    f"the labels {name!r}"
                )

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """Where there is no mark."""
        with _readable(self.place):
            done = np.asarray(self._group()["blocks/done"][...])
        return (index for index in plan.indices() if not done[index].any())

    def finish(self, piece: Piece) -> None:
        """The block first, then its mark."""
        group = self._group()
        done = group["blocks/done"]
        if np.any(done[piece.index]):
            return
        found = piece.compute()
        for variable, values in zip(piece.variables, found, strict=True):
            group[variable.name][piece.region] = values
        done[piece.index] = [*map(_checksum, found)]

    def open(self, plan: Plan, empty: xarray.Dataset) -> xarray.Dataset:
        """The group as arrays of Dask."""
        return lazily(plan, empty, self._read)

    def _read(self, piece: Piece) -> list[NDArray[Any]]:
        with _readable(self.place):
            group = self._group("r")
        found, place = [], "/".join(("c", *map(str, piece.index)))
        mark = f"{self.place}/blocks/done/{place}/0"
        for i, variable in enumerate(piece.variables):
            try:
                values = np.asarray(group[variable.name][piece.region])
                same = group["blocks/done"][piece.index][i] == _checksum(values)
            except _WRONG:
                same = False
            if not same:
                raise _bad_block(f"{self.place}/{variable.name}/{place}", mark)
            found.append(values)
        return found

    def alone(self) -> AbstractContextManager[None]:
        """Lock the file of the group, where it is one of this machine."""
        if "://" in self.place:
            return nullcontext()
        return _alone(self.place, self._ABOUT, "*.partial")

    def _group(self, mode: Literal["r", "r+"] = "r+") -> Any:
        import zarr

        return zarr.open_group(self.place, mode=mode)


def _checksum(values: NDArray[Any]) -> int:
    """CRC-32 with a bit above it, so that it is never 0; of NaN the sign and payload are none."""
    if values.dtype.kind == "f":
        values = np.where(np.isnan(values), np.nan, values)
    return 2**32 + zlib.crc32(np.ascontiguousarray(values).tobytes())


@dataclass(frozen=True)
class Parquet:
    """A folder of Parquet files, one a block with a row a point, each there at once when done."""

    place: str

    def begin(self, plan: Plan, empty: xarray.Dataset) -> None:
        """Make the folder, with the plan in a file that readers of Parquet pass over."""
        if os.path.lexists(self.place):
            file = self._plan(self.place)
            said = file.read_bytes() if file.is_file() else None
            return _begun(self.place, said, plan, file.name)
        with _beside(Path(self.place)) as place:
            place.mkdir()
            self._plan(place).write_text(plan.description(), "utf-8")
            _named(place, self.place)
        return self.begin(plan, empty)

    @staticmethod
    def _plan(place: str | Path) -> Path:
        return Path(place) / f"_{PLAN}.json"

    def alone(self) -> AbstractContextManager[None]:
        """Lock the file of the plan."""
        return _alone(self.place, self._plan(self.place).name, f"{_DRAFT}*")

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """Where there is no file."""
        there = {path.name for path in Path(self.place).iterdir()}
        return (index for index in plan.indices() if _file(index) not in there)

    def finish(self, piece: Piece) -> None:
        """Write beside, and give it its name when it is whole."""
        import pyarrow
        from pyarrow import parquet

        whole = Path(self.place) / _file(piece.index)
        if whole.exists():
            return
        values = piece.compute()
        kept = len(piece.begin)
        shape = piece.shape[:kept]
        meanings = piece.work.meanings
        columns: dict[str, NDArray[Any]] = {}
        said: dict[str, dict[str, str]] = {}
        for name, array in piece.inputs.items():
            if math.prod(array.shape[kept:]) == 1:
                columns[name] = np.broadcast_to(array.reshape(array.shape[:kept]), shape)
                said[name] = meanings[name].attributes if name in meanings else {}
        for variable, value in zip(piece.variables, values, strict=True):
            columns[variable.name], said[variable.name] = value, variable.attributes
        fields = [
            pyarrow.field(name, pyarrow.from_numpy_dtype(value.dtype), metadata=said[name])
            for name, value in columns.items()
        ]
        rows = [np.ravel(value) for value in columns.values()]
        table = pyarrow.table(rows, schema=pyarrow.schema(fields))
        beside = whole.with_name(f"{_DRAFT}{uuid4()}")
        parquet.write_table(table, beside, write_page_checksum=True)
        os.replace(beside, whole)

    def open(self, plan: Plan, empty: xarray.Dataset) -> xarray.Dataset:
        """The files as arrays of Dask."""
        return lazily(plan, empty, self._read)

    def _read(self, piece: Piece) -> list[NDArray[Any]]:
        from pyarrow import ArrowException, parquet

        names = [v.name for v in piece.variables]
        file = Path(self.place) / _file(piece.index)
        shape = piece.shape[: len(piece.begin)]
        try:
            table = parquet.read_table(file, columns=names, page_checksum_verification=True)
            return [table[name].to_numpy().reshape(shape) for name in names]
        except (OSError, ArrowException, KeyError, ValueError):
            raise _bad_block(str(file), "it") from None


def _file(index: tuple[int, ...]) -> str:
    return f"block-{'-'.join(f'{i:05}' for i in index) or '0'}.parquet"
