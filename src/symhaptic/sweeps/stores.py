"""Stores of finished blocks, from which an interrupted sweep is resumed.

A mark that is written after a block says that the block is done.  Blocks that a killed process had
begun are computed again, and the result has the same bytes as without the kill.  Checksums are
compared when a block is read, and those of the files that describe a store when a sweep begins.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import sys
import zlib
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal
from uuid import uuid4

import numpy as np

from symhaptic.book.processes import folder
from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import shown
from symhaptic.sweeps.plan import Piece, Plan

if TYPE_CHECKING:
    from numpy.typing import NDArray

PLAN = "symhaptic_sweep"
"""The attribute that describes the sweep."""

_DRAFT = "_draft-"
"""Prefix of Parquet files that are being written; readers of Parquet ignore such files."""

_DONE = "blocks/done"
"""The array of Zarr with a mark for each block that is done."""

_TAKEN = ("blocks", "zarr.json")
"""Names that labels and results cannot have."""


def store(to: str | Path, plan: Plan) -> Store:
    """The store of a name, for a sweep: Zarr or Parquet, by its ending."""
    place = str(to).rstrip("/")
    if place.endswith(".zarr"):
        needed("symhaptic.sweep to a Zarr store", "zarr", extra="sweep")
        return Zarr(place, plan.mark)
    if place.endswith(".parquet") and "://" not in place:
        needed("symhaptic.sweep to Parquet files", "pyarrow", extra="sweep")
        return Parquet(place, plan.mark)
    raise ValueError(
        f"to: {place!r} is not allowed; give a name that ends in .zarr, or the name of a folder "
        "that ends in .parquet"
    )


def _damaged(file: str) -> ValueError:
    return ValueError(
        f"to: {file}, which describes what is stored, is damaged or missing; give another place, "
        "or remove this one"
    )


_WRONG = (LookupError, TypeError, ValueError, RuntimeError, ArithmeticError)
"""Exceptions of Zarr and its codecs for damaged files."""


def _sealed(said: Mapping[str, Any]) -> str:
    """A description with its own checksum."""
    text = json.dumps(said, sort_keys=True)
    return json.dumps({**said, _SEAL: zlib.crc32(text.encode())}, sort_keys=True)


def _opened(text: str | bytes) -> dict[str, Any] | None:
    """A description, or None if it is damaged."""
    try:
        said = json.loads(text)
        return said if _sealed({k: said[k] for k in said if k != _SEAL}) == text else None
    except (ValueError, TypeError, LookupError):
        return None


_SEAL = "crc32"


def _bad_block(files: str, mark: str) -> ValueError:
    return ValueError(
        f"to: {files} is damaged or missing; delete {mark}, and the same call computes this block "
        "again"
    )


@contextmanager
def _beside(place: Path) -> Iterator[Path]:
    """A temporary folder in which a store is made before it gets its name."""
    stack = ExitStack()
    try:
        draft = stack.enter_context(folder(f".{place.name}-", place.parent))
    except (OSError, ValueError) as wrong:
        reason = wrong.strerror if isinstance(wrong, OSError) else wrong
        raise ValueError(
            f"to: {str(place)!r} cannot be made there ({reason}); "
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
class Store:
    """A place for blocks."""

    place: str
    mark: str
    """Digest of the sweep, which its blocks are marked with."""

    ABOUT: ClassVar[str]
    """The file that describes the sweep."""
    DRAFTS: ClassVar[str]
    """Pattern of the files that a killed process leaves incomplete."""

    def begin(self, plan: Plan) -> None:
        """Make the store, or check that it belongs to the same sweep.

        A local store is made under another name first, so that it is complete when it appears.
        """
        local = "://" not in self.place
        if not local or os.path.lexists(self.place):
            text = self._said()
            if text is not None:
                return self._same(plan, text)
            if local:
                raise ValueError(f"to: {self.place!r} exists and holds no sweep; give another name")
        self._refuse_names(plan)
        if not local:
            return self._make(self.place, plan)
        with _beside(Path(self.place)) as draft:
            self._make(str(draft), plan)
            _named(draft, self.place)
        return self.begin(plan)

    def _same(self, plan: Plan, text: str) -> None:
        """Refuse another sweep, and damage of what describes this one."""
        was, now = _opened(text), self._describe(plan)
        if was is None:
            raise _damaged(f"{self.place}/{self.ABOUT}")
        files, labels, known = was.pop("files"), was.pop("labels"), now.pop("labels")
        other = [key for key in now if was.get(key) != now[key]]
        other += [f"the labels {name!r}" for name in sorted({*labels, *known})
                  if labels.get(name) != known.get(name)]  # fmt: skip
        if other:
            raise ValueError(
                f"to: {self.place!r} holds another sweep, which differs in {', '.join(other)}; "
                "give another name"
            )
        self._refuse_damage(files)

    def _describe(self, plan: Plan) -> dict[str, Any]:
        """The sweep, with the labels that are stored."""
        return {**json.loads(json.dumps(plan.description())), "labels": {}}

    def _refuse_damage(self, files: Mapping[str, int]) -> None:
        """Compare files that never change with their checksums."""
        for name, known in files.items():
            if zlib.crc32(_bytes(f"{self.place}/{name}")) != known:
                raise _damaged(f"{self.place}/{name}")

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Refuse a second writer on this machine, and remove drafts of one that was killed.

        A file is locked as long as this process writes; the system unlocks it if that is killed.
        """
        if "://" in self.place:
            yield
            return
        with open(Path(self.place) / self.ABOUT, "r+b") as held:
            if sys.platform != "win32":
                import fcntl

                try:
                    fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:
                    raise ValueError(
                        f"to: another process is writing to {self.place!r}; wait until it has "
                        "ended, or give another place"
                    ) from None
            for draft in filter(Path.is_file, Path(self.place).rglob(self.DRAFTS)):
                draft.unlink(missing_ok=True)
            yield

    def _checksum(self, index: tuple[int, ...], *values: NDArray[Any]) -> int:
        """CRC-32 of the results of a block of this sweep, with a bit above it so that it is not 0.

        All NaN count as the same number.
        """
        found = zlib.crc32(f"{self.mark} {index} {[v.dtype.str for v in values]}".encode())
        for one in values:
            same = np.where(np.isnan(one), np.nan, one) if one.dtype.kind == "f" else one
            found = zlib.crc32(np.ascontiguousarray(same).tobytes(), found)
        return 2**32 + found

    def _said(self) -> str | None:
        """The description of the sweep that is there."""
        raise NotImplementedError

    def _refuse_names(self, plan: Plan) -> None:
        """Refuse labels that would be lost or changed, and results without a name there."""

    def _make(self, place: str, plan: Plan) -> None:
        """Make the store without any block."""
        raise NotImplementedError

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """The blocks that are not done."""
        raise NotImplementedError

    def finish(self, piece: Piece) -> None:
        """Compute a block and keep it, unless it is done; for workers."""
        raise NotImplementedError

    def read(self, piece: Piece) -> list[NDArray[Any]]:
        """Read a block and compare its checksum."""
        raise NotImplementedError


class Zarr(Store):
    """A Zarr group with one chunk per block; ``blocks/done`` has checksums of finished blocks."""

    ABOUT = "zarr.json"
    DRAFTS = "*.partial"

    def _said(self) -> str | None:
        try:
            said = self._group("r").attrs.get(PLAN)
        except FileNotFoundError:  # Zarr finds no group
            said = None
        except _WRONG:
            raise _damaged(f"{self.place}/{self.ABOUT}") from None
        if said is None and _bytes(f"{self.place}/{_DONE}/zarr.json"):
            raise _damaged(f"{self.place}/{self.ABOUT}")
        return said if isinstance(said, str) else None if said is None else ""

    def _describe(self, plan: Plan) -> dict[str, Any]:
        labels = {
            str(name): hashlib.sha256(repr((c.dims, c.dtype, c.values.tolist())).encode())
            for name, c in plan.labels.coords.items()
            if name not in plan.names
        }
        return super()._describe(plan) | {"labels": {n: d.hexdigest() for n, d in labels.items()}}

    def _make(self, place: str, plan: Plan) -> None:
        import zarr
        from zarr.codecs import Crc32cCodec, ZstdCodec

        empty = plan.empty()
        kept: dict[str, dict[str, Any]] = {
            str(name): {"compressors": (ZstdCodec(level=0), Crc32cCodec())}
            for name in empty.variables
        }
        for name, values in empty.variables.items():
            chunks = plan.lengths if name in empty.data_vars else values.shape
            kept[str(name)] |= {"chunks": chunks} if chunks else {}
        empty.to_zarr(place, compute=False, encoding=kept, consolidated=False, zarr_format=3)
        group = zarr.open_group(place, mode="r+")
        count = len(plan.variables)
        group.create_array(
            _DONE, shape=(*plan.grid, count), chunks=(*(1 for _ in plan.grid), count),
            dtype="uint64", fill_value=0, compressors=None,
        )  # fmt: skip
        names = [f"{name}/zarr.json" for name in (*empty.variables, "blocks", _DONE)]
        names += ["/".join((str(name), "c", *("0" for _ in label.dims)))
                  for name, label in empty.coords.items()]  # fmt: skip
        files = {name: zlib.crc32(_bytes(f"{place}/{name}")) for name in names}
        group.attrs[PLAN] = _sealed(self._describe(plan) | {"files": files})

    def _refuse_names(self, plan: Plan) -> None:
        import xarray
        from zarr.storage import MemoryStore

        for result in plan.variables:
            if result.name in _TAKEN or not result.name.strip(".") or "/" in result.name:
                raise ValueError(
                    f"quantity: a result has the name {result.name!r}, which is not allowed in "
                    f"{self.place!r}; give it another name, or a place that ends in .parquet"
                )
        for name, coord in plan.labels.coords.items():
            tried = MemoryStore()
            try:
                one = xarray.Dataset(coords={name: coord.variable})
                one.to_zarr(tried, consolidated=False, zarr_format=3)
                found = xarray.open_zarr(tried, consolidated=False, chunks=None)
            except (TypeError, ValueError):
                found = xarray.Dataset()
            if (
                name in _TAKEN
                or name not in found
                or not found[name].variable.equals(coord.variable)
            ):
                raise ValueError(
                    f"{name}: {shown(coord.values)} as labels are not allowed in {self.place!r}; "
                    "give numbers, text or dates, with a plain name and plain attributes"
                )

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """The blocks without a mark."""
        try:
            done = np.asarray(self._group("r")[_DONE][...])
        except _WRONG:
            what = f"{self.place}/{self.ABOUT} or a file in {self.place}/{_DONE}/c"
            raise _damaged(what) from None
        return (index for index in plan.indices() if not done[index].any())

    def finish(self, piece: Piece) -> None:
        """Write the block first, then its mark."""
        group = self._group()
        done = group[_DONE]
        if np.any(done[piece.index]):
            return
        found = piece.compute()
        for variable, values in zip(piece.variables, found, strict=True):
            group[variable.name][piece.region] = values
        done[piece.index] = [self._checksum(piece.index, values) for values in found]

    def read(self, piece: Piece) -> list[NDArray[Any]]:
        """Read the chunks of a block and compare their checksums with the mark."""
        found, place = [], "/".join(("c", *map(str, piece.index)))
        for i, variable in enumerate(piece.variables):
            try:
                group = self._group("r")
                values = np.asarray(group[variable.name][piece.region])
                same = group[_DONE][piece.index][i] == self._checksum(piece.index, values)
            except _WRONG:
                same = False
            if not same:
                said = _opened(self._said() or "")
                if said is None:
                    raise _damaged(f"{self.place}/{self.ABOUT}")
                self._refuse_damage(said["files"])
                mark = f"{self.place}/{_DONE}/{place}/0"
                raise _bad_block(f"{self.place}/{variable.name}/{place}", mark)
            found.append(values)
        return found

    def _group(self, mode: Literal["r", "r+"] = "r+") -> Any:
        import zarr

        return zarr.open_group(self.place, mode=mode)


def _bytes(file: str) -> bytes:
    """The content of a file, local or remote; empty if there is none."""
    try:
        if "://" not in file:
            return Path(file).read_bytes()
        from fsspec import open as opened

        with opened(file, "rb") as held:
            found: bytes = held.read()
            return found
    except OSError:
        return b""


class Parquet(Store):
    """A folder of Parquet files, one per block, with one row per point."""

    ABOUT = f"_{PLAN}.json"  # which readers of Parquet pass over
    DRAFTS = f"{_DRAFT}*"

    def _said(self) -> str | None:
        file = Path(self.place) / self.ABOUT
        return file.read_text("utf-8", "replace") if file.is_file() else None

    def _make(self, place: str, plan: Plan) -> None:
        Path(place).mkdir()
        text = _sealed(self._describe(plan) | {"files": {}})
        (Path(place) / self.ABOUT).write_text(text, "utf-8")

    def missing(self, plan: Plan) -> Iterator[tuple[int, ...]]:
        """The blocks without a file."""
        there = {path.name for path in Path(self.place).iterdir()}
        return (index for index in plan.indices() if _file(index) not in there)

    def finish(self, piece: Piece) -> None:
        """Write a draft, and rename it when it is complete."""
        import pyarrow
        from pyarrow import parquet

        whole = Path(self.place) / _file(piece.index)
        if whole.exists():
            return
        values = piece.compute()
        kept = len(piece.region)
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
        checksum = {_SEAL: str(self._checksum(piece.index, *values))}
        table = pyarrow.table(rows, schema=pyarrow.schema(fields, checksum))
        beside = whole.with_name(f"{_DRAFT}{uuid4()}")
        parquet.write_table(table, beside, write_page_checksum=True)
        os.replace(beside, whole)

    def read(self, piece: Piece) -> list[NDArray[Any]]:
        """Read the columns of a block and compare its checksum."""
        from pyarrow import ArrowException, parquet

        names = [v.name for v in piece.variables]
        file = Path(self.place) / _file(piece.index)
        shape = piece.shape[: len(piece.region)]
        try:
            with parquet.ParquetFile(file, page_checksum_verification=True) as opened:
                table = opened.read(names)
            found = [table[name].to_numpy().reshape(shape) for name in names]
            known = (table.schema.metadata or {}).get(_SEAL.encode())
            if known != str(self._checksum(piece.index, *found)).encode():
                raise ValueError("another block")
        except (OSError, ArrowException, KeyError, ValueError):
            raise _bad_block(str(file), "it") from None
        return found


def _file(index: tuple[int, ...]) -> str:
    return f"block-{'-'.join(f'{i:05}' for i in index) or '0'}.parquet"
