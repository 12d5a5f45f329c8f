"""Writes the printed report: whole or not at all, the same from run to run, no line overfull."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias

from symhaptic.book.chapters import Chapter, expected_bench, expected_mutants, source_beside
from symhaptic.book.committed import GENERATED, committed
from symhaptic.book.ledger import by_source, counted, ledger, of_chapter
from symhaptic.book.measured.chapter import measurement
from symhaptic.book.measured.record import BadRecord
from symhaptic.book.parts import OWN, PARTS, in_parts, numbers, part_of
from symhaptic.book.processes import run
from symhaptic.book.record import Block
from symhaptic.book.report import latex, pages
from symhaptic.book.report.chapter import Place
from symhaptic.book.report.chapter import page as chapter_page
from symhaptic.book.report.place import ReportError, drafted, left_over, refuse_foreign
from symhaptic.book.rests import between, shown_in
from symhaptic.book.sources import PAPER
from symhaptic.proof.verdict import Kind
from symhaptic.version import __version__

Numbered: TypeAlias = tuple[int, Chapter]
"""A chapter and its number in the book."""

Say: TypeAlias = Callable[[str], None]
"""Told what is being made."""

Take: TypeAlias = Callable[[Block, Path], None]
"""Puts a figure into its file."""

TITLE = "Passivity and stability of haptic walls, derived and verified"

MEANINGS = (
    (Kind.DEFINITION, "introduces notation, with consistent units"),
    (Kind.PROVED, "holds for all values of its domain"),
    (Kind.ENCLOSED, "a number or inequality holds, by ball arithmetic"),
    (Kind.QUALIFIED, "holds under a condition that the paper does not state"),
    (Kind.MISPRINT, "false as published, true as corrected"),
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

ALWAYS = ("ledger.json", "results.tex", "errata.tex")
"""What a check wants of a whole report; of the rest it compares what is there."""

PACKAGE = "symhaptic.sty"
"""What a chapter's LaTeX needs."""

CITED = "symhaptic.bib"
"""BibTeX entries of the package and of the source, beside chapters for a document of your own."""

BAD = r"^(?:Overfull \\[hv]box.*|LaTeX Warning: Reference.*|.*has been referenced but does not.*)$"
"""Lines of TeX's log about what a reader would find: a line or page too long, a link to nowhere."""

_SAFE = ("-interaction=nonstopmode", "-halt-on-error", "-latexoption=-no-shell-escape")
"""TeX asks nothing, stops at an error, and starts no other program."""

_TOLD = 20
"""Bad lines that a message lists."""


def check(paths: list[Path]) -> None:
    r"""Say before the work is done that a chapter's name is taken, or none for ``\input``."""
    names = [path.stem for path in paths]
    for path in reversed(paths):
        if not re.fullmatch(r"[\w.-]+", path.stem, re.ASCII):
            raise ReportError(
                f"--derivation {path}: {path.stem!r} is no name for LaTeX; rename the file with "
                "letters, digits, '-', '_' and '.'"
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
    return [PACKAGE, CITED, *(f"{path.stem}.tex" for path in paths), *alone]


# -- text -----------------------------------------------------------------------------


def text_files(chapters: list[Chapter]) -> dict[str, str]:
    """Name and content of every text file of the report."""
    numbered = list(enumerate(in_parts(chapters, lambda chapter: chapter.name), 1))
    entries = ledger(entry for _, chapter in numbered for entry in of_chapter(chapter))
    places = {chapter.source: (number, chapter.name) for number, chapter in numbered}
    try:
        speed = measurement(expected_bench())
    except BadRecord as wrong:
        raise ReportError(str(wrong)) from None
    appendices = [
        pages.errata(entries, places),
        pages.ledger(entries, places),
        pages.believed(entries),
        *filter(None, (pages.mutants(expected_mutants()), speed)),
    ]
    files = _chapter_files(numbered)
    for page in (pages.results(entries, places), *appendices):
        places_ = f"{{{latex.literally(page['code'])}}}{{{page['at']}}}"
        head = f"% {GENERATED}\n\\symhapticpage{places_}{{{latex.title(page)}}}"
        wide = page["at"] in ("believed", "ledger", "mutants")
        files[f"{page['at']}.tex"] = latex.page(
            page, head + "\n\\widetext" * wide, "\\widetextend" * wide
        )
    files["book.tex"] = filled(
        "book.tex",
        parts=_parts(numbered),
        kinds=[(str(kind), meaning) for kind, meaning in MEANINGS],
        count=f"{len(entries)} statements",
        counts=counted(entries),
        symbols=[
            (latex.inline(shown), "".join(map(latex.inline, meaning)), unit)
            for shown, unit, meaning in pages.symbols()
        ],
        sources=latex.literally(by_source(entries)),
        graph=bool(between(numbered)),
        appendices=[page["at"] for page in appendices],
    )
    files["ledger.json"] = committed(entries)
    return files


def _parts(numbered: Sequence[Numbered]) -> list[dict[str, Any]]:
    """Title, opening, chapters and table of each part that has a chapter."""
    found = []
    for part in (*PARTS, OWN):
        inside = [(number, one) for number, one in numbered if part_of(one.name) is part]
        if inside:
            found.append(
                {
                    "title": part.title,
                    "opening": latex.prose(part.opening),
                    "names": [one.name for _, one in inside],
                    "rests": "\n\n".join(map(latex.inline, pages.resting(inside, numbered))),
                }
            )
    return found


def excerpt_files(chapters: Sequence[Numbered], standalone: bool) -> dict[str, str]:
    """Some chapters, with their numbers in the book, and what a document needs for them."""
    first = chapters[0][1]
    source = source_beside(first.path) or (PAPER if first.name in numbers() else None)
    files = _chapter_files(chapters) | {CITED: filled(CITED, source=source)}
    if standalone:
        names, said = [one.name for _, one in chapters], latex.literally
        given = {"title": said(source.title if source else first.title)}
        given["author"] = said(source.authors) if source else "symhaptic"
        files["chapters.tex"] = filled("chapters.tex", chapters=names, source=source, **given)
    return files


def _chapter_files(chapters: Sequence[Numbered]) -> dict[str, str]:
    files = {PACKAGE: filled(PACKAGE)}
    for number, chapter in chapters:
        files[f"{chapter.name}.tex"] = f"% {GENERATED}\n" + chapter_tex(chapter, number)
    return files


def chapter_tex(chapter: Chapter, number: int) -> str:
    """A chapter's LaTeX, for the book or any document with `symhaptic.sty`.

    It refers to no other chapter, so that it is the same whichever are beside it.
    """
    page = chapter_page(chapter, Place(number, shown_in([(number, chapter)])))
    source = latex.literally(chapter.source)
    head = f"\\begin{{symhapticchapter}}{{{number}}}{{{source}}}{{{latex.title(page)}}}"
    return latex.page(page, head, "\\end{symhapticchapter}")


def filled(name: str, **given: Any) -> str:
    """A template with its places filled."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("symhaptic.book.report"),
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
    own = {"title": TITLE, "author": "symhaptic", "version": __version__, "said": latex.literally}
    return environment.get_template(name).render(**own | given, generated=GENERATED)


# -- files ----------------------------------------------------------------------------


def write(
    chapters: list[Chapter], target: Path, pdf: bool, say: Say, take: Take | None = None
) -> None:
    """Write text, figures and, if asked and possible, the PDF into ``target``.

    ``take`` puts a figure into its file; if not given, it is drawn there and then.

    Raises :class:`ReportError` where that cannot be, or would cost a file that is no report's.
    """
    files = text_files(chapters)
    refuse_foreign(target, [*files, *_drawn(chapters)])
    with drafted(target) as draft:
        _files(files, chapters, draft, say, take)
        _graph(chapters, draft / "figures", say)
        _measured(draft / "figures", say)
        if pdf:
            typeset(draft, say)
    for path in left_over(target, files):
        path.unlink()


def write_excerpt(
    chapters: Sequence[Numbered], target: Path, standalone: bool, pdf: bool, say: Say
) -> None:
    """The same for some chapters, with their numbers in the book; others there are left alone."""
    files = excerpt_files(chapters, standalone)
    alone = [chapter for _, chapter in chapters]
    refuse_foreign(target, [*files, *_drawn(alone)])
    with drafted(target) as draft:
        _files(files, alone, draft, say, None)
        if pdf:
            typeset(draft, say, "chapters")


def _drawn(chapters: Sequence[Chapter]) -> list[str]:
    """Names of the figures of chapters."""
    blocks = [block for chapter in chapters for block in chapter.page.blocks]
    return [f"figures/{block.title}.pdf" for block in blocks if block.draw is not None]


def _files(
    files: dict[str, str], chapters: Sequence[Chapter], folder: Path, say: Say, take: Take | None
) -> None:
    """The text files, and the figures of chapters."""
    from symhaptic.book.figures import drawings

    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "figures").mkdir()
    for block in drawings.figures(chapters):
        say(f"figure {block.title}")
        (take or drawings.take)(block, folder / "figures" / f"{block.title}.pdf")


def _graph(chapters: list[Chapter], folder: Path, say: Say) -> None:
    """Which chapter applies theorems of which."""
    numbered = list(enumerate(in_parts(chapters, lambda chapter: chapter.name), 1))
    edges = between(numbered)
    if edges:
        from symhaptic.book.figures.rests import graph
        from symhaptic.book.figures.style import save

        say("figure graph")
        titles = {number: chapter.title for number, chapter in numbered}
        draw = partial(graph, edges=edges, titles=titles)
        save(draw, folder / "graph.pdf", height=1.2)


def _measured(folder: Path, say: Say) -> None:
    """The figures of the committed measurement."""
    if expected_bench().is_file():
        from symhaptic.book.figures.bench import drawings
        from symhaptic.book.figures.style import save
        from symhaptic.book.measured.record import read

        for name, (draw, panels, height) in drawings(read(expected_bench())).items():
            say(f"figure {name}")
            save(draw, folder / f"{name}.pdf", panels, height)


def typeset(folder: Path, say: Say, name: str = "book") -> None:
    """Run latexmk on a document; overfull lines and undefined references are errors."""
    say(f"typesetting {name}.pdf")
    done = run(
        ["latexmk", "-pdf", *_SAFE, f"{name}.tex"],
        cwd=folder,
        errors="replace",
        env=os.environ | {"SOURCE_DATE_EPOCH": "0", "max_print_line": "1000"},
    )
    log_file = folder / f"{name}.log"
    log = log_file.read_text(encoding="utf-8", errors="replace") if log_file.is_file() else ""
    if done.returncode != 0:
        first = next((line for line in log.splitlines() if line.startswith("!")), "no message")
        files = re.findall(r"\(\./([\w.-]+)\.tex", log)
        raise ReportError(f"latexmk failed in {files[-1] if files else name}.tex: {first}")
    bad = [(m.group(), log[: m.start()]) for m in re.finditer(BAD, log, re.MULTILINE)]
    if bad:
        opened = [re.findall(r"\(\./([\w.-]+)\.tex", before)[-1:] for _, before in bad]
        lines = [f"{' '.join(o)}.tex: {line}" for o, (line, _) in zip(opened, bad, strict=True)]
        raise ReportError(f"{len(bad)} bad lines in the report: {'; '.join(lines[:_TOLD])}")


def differences(files: dict[str, str], target: Path, whole: bool = True) -> str:
    """A diff from the text in a folder to what would be written; empty where nothing changed."""
    out: list[str] = []
    gone = {path.name: "" for path in left_over(target, files)} if whole else {}
    for name, text in (files | gone).items():
        path = target / name
        old = path.read_text(encoding="utf-8") if path.is_file() else ""
        if old or not whole or name in ALWAYS:
            out += difflib.unified_diff(
                old.splitlines(keepends=True),
                text.splitlines(keepends=True),
                f"{path} (committed)",
                f"{path} (derived)",
            )
    return "".join(out)
