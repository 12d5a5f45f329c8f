"""The record of a measurement: machine, versions and all figures, as one JSON document."""

from __future__ import annotations

import json
import math
import os
import platform
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from symhaptic import __version__
from symhaptic.bench import functions, models, peers, tracing, verdicts
from symhaptic.bench.functions import FUNCTIONS
from symhaptic.bench.timing import METHOD

SCHEMA = 1

NUMBER = (int, float)
MAYBE = (int, float, type(None))
FIELDS: dict[str, dict[str, Any]] = {
    "functions": {
        "function": str, "set": str, "way": str, "precision": str, "seconds": NUMBER,
        "points": int, "median": MAYBE, "worst": MAYBE, "at": list, "missing": NUMBER,
        "last": NUMBER,
    },
    "boundary": {
        "method": str, "delay": int, "threshold": MAYBE, "points": int, "seconds": NUMBER,
        "median": NUMBER, "worst": NUMBER,
    },
    "stability": {
        "delay": int, "method": str, "walls": int, "seconds": NUMBER, "wrong": dict,
        "refused": NUMBER,
    },
    "models": {
        "delay": int, "model": str, "damping": NUMBER, "seconds": NUMBER, "median": NUMBER,
        "most": NUMBER, "least": NUMBER,
    },
    "peers": {"task": str, "tool": str, "installed": bool},
}  # fmt: skip
"""Sections of a record and the fields of each row."""


class BadRecord(ValueError):
    """A file that is no record; the message is one line."""


@dataclass(frozen=True)
class Size:
    """How much is measured."""

    effort: functions.Effort
    delays: tuple[int, ...]
    thresholds: tuple[float, ...]
    nodes: int
    checked: int
    long: tuple[int, ...]
    plants: int
    most: int
    loops: int
    asked: int
    names: tuple[str, ...] = FUNCTIONS


QUICK = Size(
    functions.Effort(60, 3, 2000), (0, 8), (1e-3, 1e-8), 21, 6, (0, 2, 16, 64), 5, 16, 50, 8
)
FULL = Size(
    functions.Effort(1000, 15, 10_000),
    tuple(range(9)),
    (1e-3, 1e-6, 1e-9, 1e-12),
    41,
    20,
    (0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000),
    50,
    64,
    300,
    40,
)


def sections(size: Size) -> dict[str, Iterator[dict[str, Any]]]:
    """The rows of each section, measured as they are asked for."""
    short = tuple(d for d in (0, 1, 2, 4, 8) if d in size.delays)
    return {
        "functions": functions.measured(size.effort, size.names),
        "boundary": tracing.measured(size.delays, size.thresholds, size.nodes, size.checked),
        "stability": verdicts.measured(size.long, size.plants, size.most),
        "models": models.measured(short, size.loops),
        "peers": peers.measured(size.asked),
    }


def measured(
    size: Size, told: Callable[[int, str], None] = lambda done, name: None
) -> dict[str, Any]:
    """A whole record; ``told`` hears which section is under way."""
    begin = time.perf_counter()
    record: dict[str, Any] = {
        "schema": SCHEMA,
        "package": "symhaptic",
        "version": __version__,
        "quick": size is not FULL,
        "machine": machine(),
        "versions": versions(),
        "method": METHOD,
    }
    for done, (name, rows) in enumerate(sections(size).items()):
        told(done, name)
        record[name] = [_short(row) for row in rows]
    record["seconds"] = round(time.perf_counter() - begin)
    return record


def _short(value: Any) -> Any:
    """Numbers to three digits, and None for what is no number."""
    if isinstance(value, dict):
        return {k: v if k in ("at", "threshold", "last") else _short(v) for k, v in value.items()}
    if isinstance(value, float):
        return float(f"{value:.3g}") if math.isfinite(value) else None
    return value


def machine() -> dict[str, Any]:
    """Processor, cores and system."""
    processor = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        lines = info.read_text(encoding="utf-8").splitlines()
        named = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
        processor = named[0] if named else processor
    return {
        "processor": processor,
        "cores": os.cpu_count() or 1,
        "system": f"{platform.system()} {platform.machine()}",
    }


def versions() -> dict[str, str | None]:
    """Of everything that is measured; None for what is not installed."""
    found: dict[str, str | None] = {"python": platform.python_version()}
    for name in ("numpy", "scipy", "sympy", "mpmath", "python-flint", "control"):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = None
    found["gcc"] = None
    if shutil.which("gcc"):
        said = subprocess.run(
            ["gcc", "-dumpfullversion"], capture_output=True, text=True, check=False
        )
        found["gcc"] = said.stdout.strip() or None
    return found


def text(record: dict[str, Any]) -> str:
    """JSON, one row a line."""
    lines = ["{"]
    for i, (name, value) in enumerate(record.items()):
        comma = "," if i < len(record) - 1 else ""
        if isinstance(value, list):
            rows = [f"  {json.dumps(row, allow_nan=False)}" for row in value]
            lines += [f" {json.dumps(name)}: [", ",\n".join(rows), f" ]{comma}"]
        else:
            lines.append(f" {json.dumps(name)}: {json.dumps(value, allow_nan=False)}{comma}")
    return "\n".join([*lines, "}"]) + "\n"


def read(path: Path) -> dict[str, Any]:
    """A record from a file.

    Raises :class:`BadRecord` for a file that is none.
    """
    try:
        record: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as wrong:
        raise BadRecord(f"{path}: is no record of a measurement ({wrong})") from None
    check(record, str(path))
    return record


def check(record: Any, where: str) -> None:
    """Raise :class:`BadRecord` with the first thing that is missing or of the wrong type."""
    if not isinstance(record, dict) or record.get("schema") != SCHEMA:
        raise BadRecord(f"{where}: is no record of a measurement; schema {SCHEMA} is")
    for name in ("machine", "versions"):
        if not isinstance(record.get(name), dict):
            raise BadRecord(f"{where}: has no {name}")
    for name, fields in FIELDS.items():
        rows = record.get(name)
        if not isinstance(rows, list) or not rows:
            raise BadRecord(f"{where}: has no {name}")
        for i, row in enumerate(rows):
            for field, kind in fields.items():
                if not isinstance(row, dict) or not isinstance(row.get(field, ...), kind):
                    raise BadRecord(f"{where}: {name}, row {i}: {field} is missing or wrong")
