"""What is measured, how often, and on which machine."""

from __future__ import annotations

import math
import os
import platform
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from symhaptic.bench import functions, models, peers, tracing, verdicts
from symhaptic.bench.functions import FUNCTIONS
from symhaptic.bench.timing import METHOD
from symhaptic.book.listing import replace
from symhaptic.book.measured.record import SCHEMA, text
from symhaptic.book.measured.tables import markdown
from symhaptic.version import __version__


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
    functions.Effort(500, 15, 10_000),
    tuple(range(9)),
    (1e-3, 1e-6, 1e-9, 1e-12),
    41,
    20,
    (0, 1, 2, 4, 8, 16, 32, 64, 128, 256),
    50,
    32,
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
    """A complete record; ``told`` is called with each section that begins."""
    begin = time.perf_counter()
    record: dict[str, Any] = {
        "schema": SCHEMA,
        "package": "symhaptic",
        "version": __version__,
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "commit": commit(),
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
    """Numbers with three digits; None for infinite numbers and NaN."""
    if isinstance(value, dict):
        return {k: v if k in ("at", "threshold", "last") else _short(v) for k, v in value.items()}
    if isinstance(value, float):
        return float(f"{value:.3g}") if math.isfinite(value) else None
    return value


FORMATS = ("png", "pdf", "svg")


def write(record: dict[str, Any], folder: Path) -> bool:
    """Write bench.json and bench.md; return whether Matplotlib is installed and drew the plots."""
    folder.mkdir(parents=True, exist_ok=True)
    replace(folder / "bench.json", text(record))
    replace(folder / "bench.md", markdown(record))
    if find_spec("matplotlib") is None:
        return False
    from symhaptic.book.figures.bench import drawings
    from symhaptic.book.figures.style import save

    for name, (draw, panels, height) in drawings(record).items():
        for format in FORMATS:
            save(draw, folder / f"{name}.{format}", panels, height)
    return True


def commit(folder: Path = Path(__file__).parent) -> str | None:
    """The commit that is measured, with -dirty if files have changed; None outside a checkout."""
    if not shutil.which("git"):
        return None
    said = subprocess.run(
        ["git", "-C", str(folder), "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"],
        capture_output=True,
        text=True,
        check=False,
    )
    return said.stdout.strip() or None


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
    """Versions of everything that is measured; None if it is not installed."""
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
