"""Writes the report: whole or not at all, the same from run to run, no line overfull."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from symhaptic.book import foreign
from symhaptic.book.chapters import Chapter, expected_bench, expected_mutants
from symhaptic.book.committed import GENERATED, committed
from symhaptic.book.foreign import LEAVES, WHOLE, asked
from symhaptic.book.ledger import (
    Entry,
    by_source,
    counted,
    ledger,
    of_chapter,
)
from symhaptic.book.measured.chapter import measurement
from symhaptic.book.measured.record import BadRecord
from symhaptic.book.parts import in_parts
from symhaptic.book.record import Block
from symhaptic.book.rests import between
from symhaptic.book.sources import PAPER
from symhaptic.book.tex.believed import believed, symbols
from symhaptic.book.tex.errata import AT_HAND, errata
from symhaptic.book.tex.mutants import mutants_listed
from symhaptic.book.tex.page import chapter_tex
from symhaptic.book.tex.parts import parts
from symhaptic.book.tex.place import drafted, left_over, refuse_foreign
from symhaptic.book.tex.results import results
from symhaptic.book.tex.tex import ReportError, filled, typeset
from symhaptic.book.tex.words import literally, prose
from symhaptic.proof.verdict import Kind

MEANINGS = (
    (Kind.DEFINITION, "introduces notation, with consistent units"),
    (Kind.PROVED, "holds for all values of its domain"),
    (Kind.ENCLOSED, "a number or inequality holds, by ball arithmetic"),
    (Kind.QUALIFIED, "holds under a condition that the paper does not state"),
    (Kind.MISPRINT, "false as printed, true as corrected"),
    (Kind.REFUTED, "false"),
    (Kind.EXTERNAL, "rests on data outside the paper"),
    (Kind.SLIP, "a wrong name, number or reference in the text; not a theorem"),
    (Kind.UNDECIDED, "none of these yet"),
)
RESERVED = (
    *("believed", "bench", "book", "chapters", "errata", "ledger", "mutants", "results"),
    *("index", "search"),
)
"""Names of the report's own files, which no chapter may have."""

PACKAGE = "symhaptic.sty"
"""What a chapter's LaTeX needs."""


def check(paths: list[Path]) -> None:
    r"""Say before the work is done that a chapter's name is taken, or none for ``\input``."""
    names = [path.stem for path in paths]
    for path in reversed(paths):
        if not re.fullmatch(r"[\w.-]+", path.stem, re.ASCII):
            raise ReportError(
                f"--derivation {path}: {path.stem!r} is no name for LaTeX; letters, digits, '-', "
                "'_' and '.' are allowed; rename the file"
            )
        if names.count(path.stem) > 1 or path.stem in RESERVED:
            raise ReportError(
                f"--derivation {path}: the name {path.stem!r} is taken; rename the file"
            )


def names_of(paths: list[Path], pdf: bool) -> list[str]:
    """Text files and PDF of the report of these derivations, known before they are run."""
    own = [name for name in RESERVED if name != "chapters"]
    names = [f"{name}.tex" for name in (*(path.stem for path in paths), *own)]
    return [*names, PACKAGE, "ledger.json", *(["book.pdf"] if pdf else [])]


def names_of_excerpt(paths: list[Path], standalone: bool, pdf: bool) -> list[str]:
    """The same of some chapters alone."""
    alone = ["chapters.tex"] * standalone + ["chapters.pdf"] * pdf
    return [PACKAGE, *(f"{path.stem}.tex" for path in paths), *alone]


def text_files(chapters: list[Chapter]) -> dict[str, str]:
    """Name and content of every text file of the report."""
    chapters = in_parts(chapters, lambda chapter: chapter.name)
    entries = ledger(entry for chapter in chapters for entry in of_chapter(chapter))
    shared = {"generated": GENERATED, "counts": counted(entries)}
    numbers = {chapter.source: number for number, chapter in enumerate(chapters, 1)}
    numbered = list(enumerate(chapters, 1))
    files = _chapter_files(numbered)
    rows = [_row(entry, numbers) for entry in entries]
    trials = mutants_listed(expected_mutants())
    try:
        speed = measurement(expected_bench())
    except BadRecord as wrong:
        raise ReportError(str(wrong)) from None
    sections: list[tuple[str, dict[str, Any]]] = [
        (
            "book",
            {
                "parts": parts(numbered),
                "kinds": [(str(k), m) for k, m in MEANINGS],
                "count": f"{len(entries)} statements",
                "symbols": symbols(),
                "sources": prose(by_source(entries)),
                "appendices": [
                    "errata",
                    "ledger",
                    "believed",
                    *(["mutants"] if trials else []),
                    *(["bench"] if speed else []),
                ],
            },
        ),
        ("results", {**results(entries, numbers), "graph": bool(between(numbered))}),
        ("believed", believed(entries)),
        (
            "errata",
            {
                "classes": errata(entries, numbers),
                "errors": _errors(entries),
                "source": literally(AT_HAND),
            },
        ),
        ("ledger", {"rows": rows, **_foreign(entries)}),
        *([("mutants", trials)] if trials else []),
        *([("bench", speed)] if speed else []),
    ]
    for name, extra in sections:
        files[f"{name}.tex"] = filled(f"{name}.tex", **shared, **extra)
    files["ledger.json"] = committed(entries)
    return files


def excerpt_files(chapters: list[tuple[int, Chapter]], standalone: bool) -> dict[str, str]:
    """Some chapters, with their numbers in the book, and what a document needs for them."""
    files = _chapter_files(chapters)
    if standalone:
        names = [chapter.name for _, chapter in chapters]
        files["chapters.tex"] = filled("chapters.tex", generated=GENERATED, chapters=names)
    return files


def _chapter_files(chapters: list[tuple[int, Chapter]]) -> dict[str, str]:
    files = {PACKAGE: filled(PACKAGE, generated=GENERATED)}
    for number, chapter in chapters:
        files[f"{chapter.name}.tex"] = f"% {GENERATED}\n" + chapter_tex(chapter, number)
    return files


def _errors(entries: list[Entry]) -> str:
    """How many entries the errata have."""
    kinds = [entry.verdict.kind for entry in entries if entry.source is PAPER]
    wrong = kinds.count(Kind.REFUTED) + kinds.count(Kind.MISPRINT)
    return (
        f"Of {len(kinds)} statements of the paper {wrong} are wrong as they stand, "
        f"{kinds.count(Kind.QUALIFIED)} need a condition that the paper does not give, and "
        f"{kinds.count(Kind.SLIP)} are slips of the text"
    )


def _row(entry: Entry, numbers: dict[str, int]) -> dict[str, str]:
    id = entry.statement.id
    place = numbers.get(entry.derivation or "")
    location = prose(entry.statement.location)
    return {
        "id": literally(id).replace("-", "-\\allowbreak "),
        "says": f"{prose(entry.statement.says)} \\textcolor{{black!60}}{{({location})}}",
        "kind": str(entry.verdict.kind),
        "chapter": f"chapter {place}" if place else "",
        "rocq": {WHOLE: "whole", LEAVES: "in part"}.get(entry.rocq.extent, "--"),
    }


def _foreign(entries: list[Entry]) -> dict[str, Any]:
    """What Rocq has checked in all, and why it has not checked the others."""
    found: dict[str, list[str]] = {}
    for entry in entries:
        if entry.rocq.reason:
            found.setdefault(_literally(entry.rocq.reason), []).append(entry.statement.id)
    return {
        "rocq": asked(),
        "checked": foreign.counted(entry.rocq for entry in entries),
        "leaves": foreign.leaves(),
        "unchecked": [
            (why, ", ".join(literally(id).replace("-", "-\\allowbreak ") for id in ids))
            for why, ids in sorted(found.items(), key=lambda item: (-len(item[1]), item[0]))
        ],
    }


def _literally(text: str) -> str:
    """Words of another program, which may break within a name."""
    return "".join(literally(c) + r"\allowbreak " * (c in "/.(") for c in text)


# -- writing --------------------------------------------------------------------------


def write(
    chapters: list[Chapter],
    target: Path,
    pdf: bool,
    say: Callable[[str], None],
    take: Callable[[Block, Path], None] | None = None,
) -> None:
    """Write text, figures and, if asked and possible, the PDF into ``target``.

    ``take`` puts a figure into its file; if not given, it is drawn there and then.

    Raises :class:`ReportError` where that cannot be, or would cost a file that is no report's.
    """
    files = text_files(chapters)
    refuse_foreign(target, [*files, *_drawn(chapters)])
    with drafted(target) as draft:
        _texts(files, draft)
        _figures(chapters, draft / "figures", say, take)
        _graph(chapters, draft / "figures", say)
        _measured(draft / "figures", say)
        if pdf:
            typeset(draft, say)
    for path in left_over(target, files):
        path.unlink()


def write_excerpt(
    chapters: list[tuple[int, Chapter]],
    target: Path,
    standalone: bool,
    pdf: bool,
    say: Callable[[str], None],
) -> None:
    """The same for some chapters, with their numbers in the book; others there are left alone."""
    files = excerpt_files(chapters, standalone)
    refuse_foreign(target, [*files, *_drawn([chapter for _, chapter in chapters])])
    with drafted(target) as draft:
        _texts(files, draft)
        _figures([chapter for _, chapter in chapters], draft / "figures", say)
        if pdf:
            typeset(draft, say, "chapters")


def _texts(files: dict[str, str], folder: Path) -> None:
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


def _drawn(chapters: list[Chapter]) -> list[str]:
    """Names of the figures of chapters."""
    blocks = [block for chapter in chapters for block in chapter.page.blocks]
    return [f"figures/{block.title}.pdf" for block in blocks if block.draw is not None]


def _figures(
    chapters: list[Chapter],
    folder: Path,
    say: Callable[[str], None],
    take: Callable[[Block, Path], None] | None = None,
) -> None:
    """The figures of chapters."""
    from symhaptic.book.figures import drawings

    folder.mkdir()
    for block in drawings.figures(chapters):
        say(f"figure {block.title}")
        (take or drawings.take)(block, folder / f"{block.title}.pdf")


def _graph(chapters: list[Chapter], folder: Path, say: Callable[[str], None]) -> None:
    """Which chapter applies theorems of which."""
    numbered = list(enumerate(in_parts(chapters, lambda chapter: chapter.name), 1))
    edges = between(numbered)
    if edges:
        from symhaptic.book.figures.passivity import save
        from symhaptic.book.figures.rests import graph

        say("figure graph")
        titles = {number: chapter.title for number, chapter in numbered}
        draw = partial(graph, edges=edges, titles=titles)
        save(draw, folder / "graph.pdf", height=1.1)


def _measured(folder: Path, say: Callable[[str], None]) -> None:
    """The figures of the committed measurement."""
    if expected_bench().is_file():
        from symhaptic.book.figures.bench import drawings
        from symhaptic.book.figures.passivity import save
        from symhaptic.book.measured.record import read

        for name, (draw, panels, height) in drawings(read(expected_bench())).items():
            say(f"figure {name}")
            save(draw, folder / f"{name}.pdf", panels, height)


def differences(files: dict[str, str], target: Path, whole: bool = True) -> str:
    """A diff from the committed text to what would be written; empty where nothing changed."""
    out: list[str] = []
    gone = {path.name: "" for path in left_over(target, files)} if whole else {}
    for name, text in (files | gone).items():
        path = target / name
        old = path.read_text(encoding="utf-8") if path.is_file() else ""
        out += difflib.unified_diff(
            old.splitlines(keepends=True),
            text.splitlines(keepends=True),
            f"{path} (committed)",
            f"{path} (derived)",
        )
    return "".join(out)
