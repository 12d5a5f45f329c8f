"""Writes the report: whole or not at all, the same from run to run, no line overfull."""

from __future__ import annotations

import difflib
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from symhaptic.bench.record import BadRecord
from symhaptic.ledger import GENERATED, Entry, committed, counted, ledger, of_chapter
from symhaptic.library import Chapter, expected_bench, expected_mutants
from symhaptic.proof.verdict import Kind
from symhaptic.report.bench import measurement
from symhaptic.report.errata import errata
from symhaptic.report.mutants import mutants_listed
from symhaptic.report.page import chapter_tex
from symhaptic.report.words import escaped, prose

MEANINGS = (
    (Kind.DEFINITION, "introduces notation, with consistent units"),
    (Kind.PROVED, "holds for all values of its domain"),
    (Kind.ENCLOSED, "a number or inequality holds, by ball arithmetic"),
    (Kind.QUALIFIED, "holds under a condition that the paper does not state"),
    (Kind.MISPRINT, "false as printed, true as corrected"),
    (Kind.REFUTED, "false"),
    (Kind.EXTERNAL, "rests on data outside the paper"),
    (Kind.UNDECIDED, "none of these yet"),
)
DRAFT = ".draft-"
"""Beginning of the name of the folder that a report is made in."""

STALE = 3600
"""Seconds after which a draft is taken to be left over."""

RESERVED = ("bench", "book", "errata", "ledger", "mutants", "preamble")
"""Names of the report's own files, which no chapter may have."""

NO_TEX = (
    "no latexmk and pdflatex found; on Debian: "
    "apt-get install latexmk texlive-latex-recommended lmodern"
)
TITLE = "Passivity and stability of haptic walls, derived and verified"


class ReportError(RuntimeError):
    """The report cannot be written; the message is one line."""


def check(paths: list[Path]) -> None:
    """Say before the work is done that a chapter's name is taken."""
    names = [path.stem for path in paths]
    for path in reversed(paths):
        if names.count(path.stem) > 1 or path.stem in RESERVED:
            raise ReportError(
                f"--derivation {path}: the name {path.stem!r} is taken; rename the file"
            )


def text_files(chapters: list[Chapter]) -> dict[str, str]:
    """Name and content of every text file of the report."""
    try:
        from jinja2 import Environment, PackageLoader, StrictUndefined
    except ImportError:
        raise ReportError(
            "reports need jinja2 and matplotlib: pip install 'symhaptic[report]'"
        ) from None
    environment = Environment(
        loader=PackageLoader("symhaptic.report"),
        undefined=StrictUndefined,
        autoescape=False,
        keep_trailing_newline=True,
        variable_start_string="<<",
        variable_end_string=">>",
        block_start_string="<%",
        block_end_string="%>",
        comment_start_string="<#",
        comment_end_string="#>",
    )
    entries = ledger(entry for chapter in chapters for entry in of_chapter(chapter))
    shared = {"generated": GENERATED, "title": TITLE, "counts": counted(entries)}
    files = {
        f"{chapter.name}.tex": f"% {GENERATED}\n" + chapter_tex(chapter, number)
        for number, chapter in enumerate(chapters, 1)
    }
    numbers = {chapter.source: number for number, chapter in enumerate(chapters, 1)}
    rows = [_row(entry, numbers) for entry in entries]
    trials = mutants_listed(expected_mutants())
    try:
        speed = measurement(expected_bench())
    except BadRecord as wrong:
        raise ReportError(str(wrong)) from None
    parts: list[tuple[str, dict[str, Any]]] = [
        ("preamble", {}),
        (
            "book",
            {
                "chapters": [c.name for c in chapters],
                "kinds": [(str(k), m) for k, m in MEANINGS],
                "count": f"{len(entries)} statements",
                "appendices": [
                    "errata",
                    "ledger",
                    *(["mutants"] if trials else []),
                    *(["bench"] if speed else []),
                ],
            },
        ),
        ("errata", {"classes": errata(entries, numbers), "errors": _errors(entries)}),
        ("ledger", {"rows": rows}),
        *([("mutants", trials)] if trials else []),
        *([("bench", speed)] if speed else []),
    ]
    for name, extra in parts:
        files[f"{name}.tex"] = environment.get_template(f"{name}.tex").render(**shared, **extra)
    files["ledger.json"] = committed(entries)
    return files


def _errors(entries: list[Entry]) -> str:
    """How many entries the errata have."""
    kinds = [entry.verdict.kind for entry in entries if not entry.own]
    wrong = kinds.count(Kind.REFUTED) + kinds.count(Kind.MISPRINT)
    return (
        f"Of {len(kinds)} statements {wrong} are wrong as printed and "
        f"{kinds.count(Kind.QUALIFIED)} need a condition that the paper does not give"
    )


def _row(entry: Entry, numbers: dict[str, int]) -> dict[str, str]:
    id = entry.statement.id
    place = numbers.get(entry.derivation or "")
    location = escaped(entry.statement.location)
    return {
        "id": id.replace("-", "-\\allowbreak "),
        "says": f"{prose(entry.statement.says)} \\textcolor{{black!60}}{{({location})}}",
        "kind": str(entry.verdict.kind),
        "chapter": f"chapter {place}" if place else "",
    }


# -- writing --------------------------------------------------------------------------


def write(chapters: list[Chapter], target: Path, pdf: bool, say: Callable[[str], None]) -> None:
    """Write text, figures and, if asked and possible, the PDF into ``target``.

    Everything is made in a folder beside it first and moved file by file when all is there, so
    that a run that is killed leaves the old report whole.
    """
    files = text_files(chapters)
    made_here = not target.exists()
    try:
        target.mkdir(parents=True, exist_ok=True)
        for old in target.glob(f"{DRAFT}*"):  # of a run that was killed, not of one beside this
            if time.time() - old.stat().st_mtime > STALE:
                shutil.rmtree(old, ignore_errors=True)
        draft = Path(tempfile.mkdtemp(prefix=DRAFT, dir=target))
    except OSError as wrong:
        raise ReportError(
            f"-o {target}: cannot write there ({wrong.strerror}); a folder that can be written is "
            "allowed"
        ) from None
    try:
        for name, text in files.items():
            (draft / name).write_text(text, encoding="utf-8")
        _figures(chapters, draft / "figures", say)
        if pdf:
            typeset(draft, say)
        for made in sorted(draft.rglob("*")):
            if made.is_file() and made.suffix in (".tex", ".json", ".pdf"):
                place = target / made.relative_to(draft)
                place.parent.mkdir(exist_ok=True)
                os.replace(made, place)
        for path in _left_over(target, files):
            path.unlink()
    finally:
        shutil.rmtree(draft, ignore_errors=True)
        if made_here and not any(target.iterdir()):
            target.rmdir()


def _left_over(target: Path, files: dict[str, str]) -> list[Path]:
    """Chapters of an earlier report whose derivation is gone."""
    mark = f"% {GENERATED}"
    return [
        path
        for path in sorted(target.glob("*.tex"))
        if path.name not in files and path.read_text(encoding="utf-8").startswith(mark)
    ]


def _figures(chapters: list[Chapter], folder: Path, say: Callable[[str], None]) -> None:
    folder.mkdir()
    for chapter in chapters:
        for block in chapter.page.blocks:
            if block.draw is not None:
                from symhaptic.report.figures import save

                say(f"figure {block.title}")
                save(block.draw, folder / f"{block.title}.pdf", block.panels, block.height)
    if expected_bench().is_file():
        from symhaptic.bench.record import read
        from symhaptic.report.bench_figures import drawings
        from symhaptic.report.figures import save

        for name, (draw, panels, height) in drawings(read(expected_bench())).items():
            say(f"figure {name}")
            save(draw, folder / f"{name}.pdf", panels, height)


def differences(chapters: list[Chapter], target: Path) -> str:
    """A diff from the committed text to what would be written; empty where nothing changed."""
    out: list[str] = []
    files = text_files(chapters)
    for name, text in (files | {p.name: "" for p in _left_over(target, files)}).items():
        path = target / name
        old = path.read_text(encoding="utf-8") if path.is_file() else ""
        out += difflib.unified_diff(
            old.splitlines(keepends=True),
            text.splitlines(keepends=True),
            f"{path} (committed)",
            f"{path} (derived)",
        )
    return "".join(out)


# -- typesetting ----------------------------------------------------------------------


def has_tex() -> bool:
    """Whether latexmk and pdflatex are installed."""
    return shutil.which("latexmk") is not None and shutil.which("pdflatex") is not None


def typeset(folder: Path, say: Callable[[str], None]) -> None:
    """Run latexmk on the book; overfull lines and undefined references are errors."""
    say("typesetting book.pdf")
    run = subprocess.run(
        ["latexmk", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "book.tex"],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        env=os.environ | {"SOURCE_DATE_EPOCH": "0", "max_print_line": "1000"},
        check=False,
    )
    log_file = folder / "book.log"
    log = log_file.read_text(encoding="utf-8", errors="replace") if log_file.is_file() else ""
    if run.returncode != 0:
        first = next((line for line in log.splitlines() if line.startswith("!")), "no message")
        files = re.findall(r"\(\./(\w+)\.tex", log)
        raise ReportError(f"latexmk failed in {files[-1] if files else 'book'}.tex: {first}")
    bad = re.findall(r"^(?:Overfull \\hbox.*|LaTeX Warning: Reference.*)$", log, re.MULTILINE)
    if bad:
        opened = re.findall(r"\(\./(\w+)\.tex", log[: log.index(bad[0])])
        where = f"{opened[-1] if opened else 'book'}.tex"
        raise ReportError(f"{len(bad)} bad lines in the report, the first in {where}: {bad[0]}")
