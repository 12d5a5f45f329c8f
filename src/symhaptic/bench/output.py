"""Writes a measurement: the record, its tables and its plots."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from symhaptic.book.listing import replace
from symhaptic.book.measured import record as records
from symhaptic.book.measured.tables import markdown

FORMATS = ("png", "pdf", "svg")


def write(record: dict[str, Any], folder: Path) -> bool:
    """Write bench.json and bench.md; return whether Matplotlib is installed and drew the plots."""
    folder.mkdir(parents=True, exist_ok=True)
    replace(folder / "bench.json", records.text(record))
    replace(folder / "bench.md", markdown(record))
    if find_spec("matplotlib") is None:
        return False
    from symhaptic.book.figures.bench import drawings
    from symhaptic.book.figures.passivity import save

    for name, (draw, panels, height) in drawings(record).items():
        for format in FORMATS:
            save(draw, folder / f"{name}.{format}", panels, height)
    return True
