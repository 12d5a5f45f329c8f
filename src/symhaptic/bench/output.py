"""Writes a measurement: the record, its tables and its plots."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from symhaptic.bench import record as records
from symhaptic.bench.tables import markdown
from symhaptic.listing import replace

FORMATS = ("png", "pdf", "svg")


def write(record: dict[str, Any], folder: Path) -> None:
    """bench.json and bench.md, and the plots where matplotlib is installed."""
    folder.mkdir(parents=True, exist_ok=True)
    replace(folder / "bench.json", records.text(record))
    replace(folder / "bench.md", markdown(record))
    if find_spec("matplotlib") is None:
        return
    from symhaptic.report.bench_figures import drawings
    from symhaptic.report.figures import save

    for name, (draw, panels, height) in drawings(record).items():
        for format in FORMATS:
            save(draw, folder / f"{name}.{format}", panels, height)
