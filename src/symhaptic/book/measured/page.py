"""The measured part of docs/speed.md: which call to take, and a picture, from the record.

`python -m symhaptic.book.measured.page` writes both; a test fails if the page is another.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from symhaptic.book.chapters import beside, expected_bench
from symhaptic.book.measured.record import read
from symhaptic.book.measured.tables import about, calls, in_markdown, judges

BEGIN, END = "<!-- measured, by `python -m symhaptic.book.measured.page` -->", "<!-- end -->"


def renewed(page: str, record: dict[str, Any]) -> str:
    """A page with what is between the two marks replaced."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    tables = calls(record["functions"]), judges(record["stability"])
    shown = "\n".join(in_markdown(table, "###") for table in tables)
    return f"{before}{BEGIN}\n{shown}\n\n{about(record)} {record['method']}\n\n{END}{after}"


def write(folder: Path) -> None:
    """Renew speed.md, and draw speed.png."""
    from symhaptic.book.figures.bench import drawings
    from symhaptic.book.figures.style import save

    record, page = read(expected_bench()), folder / "speed.md"
    page.write_text(renewed(page.read_text(encoding="utf-8"), record), encoding="utf-8")
    draw, panels, height = drawings(record)["bench_functions"]
    save(draw, folder / "speed.png", panels, height)


if __name__ == "__main__":
    write(beside("docs"))
