"""The site as a folder: sources for Sphinx, figures as SVG, and Sphinx's run."""

from __future__ import annotations

import json
import os
import re
import shutil
import sys
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from pathlib import Path

from symhaptic.book.chapters import Chapter
from symhaptic.book.figures import drawings
from symhaptic.book.ledger import Entry, by_source, counted, of_chapter
from symhaptic.book.ledger import ledger as listed
from symhaptic.book.parts import OWN, PARTS, part_of
from symhaptic.book.processes import folder, run
from symhaptic.book.record import Block
from symhaptic.book.rests import between, shown_in
from symhaptic.book.site import explorer, gallery, mathml, mentions, reference, tables
from symhaptic.book.site.chapter import Place, chapter_page, kind
from symhaptic.book.site.guides import guides, more, pictures
from symhaptic.book.site.notebooks import FOLDER, GUIDES, notebooks
from symhaptic.book.site.place import MARK, allowed
from symhaptic.book.site.words import container, heading, plain, table, words
from symhaptic.book.tex.build import MEANINGS
from symhaptic.book.tex.tex import ReportError
from symhaptic.proof.verdict import Kind

STATIC = Path(__file__).parent / "static"
TITLE = "Haptic walls, verified"
EXTENSIONS = ("mathml", "mentions", "navigation", "reference")
"""Modules beside this one that Sphinx loads."""

EXTRA = "extra"
"""Where the sources have what Sphinx takes over as it is."""

Numbered = tuple[int, Chapter]
"""A chapter and its number in the book."""

Take = Callable[[Block, Path], None]
"""Puts a figure into its file."""

OPENING = """\
Every formula of *Passivity and Stability Boundaries for Haptic Systems with Time Delay*
(T. Hulin, A. Albu-Schäffer, G. Hirzinger, 2014), derived from first principles and judged as
printed: by exact algebra, exact series, sign certificates or balls that contain the value, joined
by named theorems. Nothing rests on sampling.
"""


def sources(numbered: Sequence[Numbered], whole: bool) -> dict[str, str]:
    """Name and text of every page; of some chapters alone, where they are not the ``whole``."""
    shown, edges = shown_in(numbered), between(numbered)
    places = {number: chapter.name for number, chapter in numbered}
    settled = frozenset(id for _, chapter in numbered for id in chapter.page.settled)
    mentioned = _mentioned(numbered, mentions.places(places, settled))
    pages = {
        c.name: chapter_page(c, Place(number, shown, whole, places, edges, settled, mentioned))
        for number, c in numbered
    }
    entries = listed(entry for _, chapter in numbered for entry in of_chapter(chapter))
    if whole:
        names = {chapter.source: (number, chapter.name) for number, chapter in numbered}
        pages |= {
            "results": tables.results(entries),
            "errata": tables.errata(entries),
            "ledger": tables.ledger(entries, names),
            **{name: _with_notebook(name, text) for name, text in guides().items()},
            **more(),
            **({gallery.NAME: gallery.page()} if gallery.programs() else {}),
            **reference.pages(),
        }
    pages["believed"] = tables.believed(entries)
    pages[explorer.NAME] = explorer.page({chapter.name for _, chapter in numbered})
    pages["index"] = _index([chapter for _, chapter in numbered], entries, whole)
    return {f"{name}.rst": text for name, text in pages.items()}


def _with_notebook(name: str, text: str) -> str:
    """A guide that leads to itself as a notebook, below its title."""
    if name not in GUIDES:
        return text
    title, _, rest = text.partition("\n\n")
    link = f"The same `as a notebook <{FOLDER}/{name}.ipynb>`__, to be run and changed."
    return "\n".join([title, "", *container("source", [link]), rest])


def _mentioned(numbered: Sequence[Numbered], known: Mapping[str, str]) -> dict[str, frozenset[int]]:
    """For each label that words of a chapter mention the numbers of these chapters."""
    found: dict[str, set[int]] = defaultdict(set)
    for number, chapter in numbered:
        for label in mentions.mentioned(chapter, known):
            found[label].add(number)
    return {label: frozenset(numbers) for label, numbers in found.items()}


TASKS = (
    ("How stiff may my wall be?", ":doc:`limits`, or :ref:`turn a loop by hand <explorer>`"),
    ("From a device to C in ten minutes", ":doc:`tutorial`"),
    ("Which formula, and under which condition?", ":ref:`The formulas to use <results>`"),
    ("What is wrong in the paper?", ":ref:`errata`, and :ref:`every statement <ledger>`"),
    ("Is my own formula right? Is my code?", ":doc:`verify` and :doc:`check`"),
    ("A figure, a sweep, a microcontroller, a thesis", ":doc:`howto` and :doc:`gallery`"),
    ("What does a verdict mean, what is believed?", ":doc:`verdicts`"),
    ("Every name", ":doc:`reference`"),
)
"""What somebody comes for, and where it is."""


def _index(chapters: Sequence[Chapter], entries: Sequence[Entry], whole: bool) -> str:
    out = [*heading(TITLE), OPENING]
    if whole:
        out += table("tasks", [["you want", "go to"], *map(list, TASKS)])
        told = f"**{len(entries)} statements,** {plain(by_source(entries))}: {counted(entries)}."
        out += [told, ""]
        out += table("kinds", [["verdict", "what it means"], *([kind(k), m] for k, m in MEANINGS)])
    before = ["results", "errata", "ledger"] if whole else []
    out += _tree("Results", [*before, "believed"])
    shown = [
        *(guides() if whole else ()),
        *([gallery.NAME] if whole and gallery.programs() else []),
    ]
    out += _tree("Use it", [explorer.NAME, *shown])
    out += _tree("Reference", [*reference.pages(), *more()]) if whole else []
    for part in (*PARTS, OWN):
        inside = [chapter.name for chapter in chapters if part_of(chapter.name) is part]
        if inside:
            out += _tree(part.title, inside)
    return "\n".join(out) + "\n"


def _tree(title: str, names: Sequence[str]) -> list[str]:
    head = [".. toctree::", "   :hidden:", "   :maxdepth: 1", f"   :caption: {words(title)}", ""]
    return [*head, *(f"   {name}" for name in names), ""]


def write(
    numbered: Sequence[Numbered],
    target: Path,
    say: Callable[[str], None],
    whole: bool = True,
    take: Take = drawings.take,
) -> None:
    """Make the site in a folder of its own; what was made there before is replaced as a whole.

    ``numbered`` are chapters with their numbers in the book; where they are not the ``whole``,
    errata, ledger and results are left out.  ``take`` puts a figure into its file.
    """
    allowed(target)
    with folder(".draft-", target.parent) as draft:
        source, made = draft / "source", draft / "site"
        _sources(numbered, source, say, whole, take)
        say("pages of the site")
        _sphinx(source, made, draft / "trees")
        (made / MARK).write_text("written by `symhaptic report`; may be replaced\n")
        if target.exists():
            os.replace(target, draft / "old")
        os.replace(made, target)


def _sources(
    numbered: Sequence[Numbered],
    source: Path,
    say: Callable[[str], None],
    whole: bool,
    take: Take,
) -> None:
    texts = sources(numbered, whole)
    (source / "figures").mkdir(parents=True)
    with gallery.drawn(source) if whole else nullcontext():
        for name, text in texts.items():
            (source / name).write_text(text, encoding="utf-8")
        say("formulas of the site")
        written = [*texts.values(), *(reference.docstrings() if whole else ())]
        found = mathml.turned(mathml.formulas(written))
        (source / "code").mkdir()
        for _, chapter in numbered:
            shutil.copy(chapter.path, source / "code")
        (source / mathml.FORMULAS).write_text(json.dumps(found), encoding="utf-8")
        settled = (id for _, chapter in numbered for id in chapter.page.settled)
        known = mentions.places({number: chapter.name for number, chapter in numbered}, settled)
        (source / mentions.PLACES).write_text(json.dumps(known), encoding="utf-8")
        for block in drawings.figures([chapter for _, chapter in numbered]):
            say(f"figure {block.title} of the site")
            take(block, source / "figures" / f"{block.title}.svg")
        (source / "scripts" / explorer.NAME).mkdir(parents=True)
        for name, text in explorer.files():
            (source / "scripts" / name).write_text(text, encoding="utf-8")
        if whole:
            for picture in pictures():
                shutil.copy(picture, source)
        beside = source / EXTRA / FOLDER
        beside.mkdir(parents=True)
        for name, text in notebooks().items() if whole else ():
            (beside / f"{name}.ipynb").write_text(text, encoding="utf-8")
        say("gallery of the site")
    for picture in source.rglob("*.svg"):
        picture.write_text(lighter(picture.read_text(encoding="utf-8")), encoding="utf-8")


def lighter(svg: str) -> str:
    """A picture whose paths are written to a hundredth of a point, which nobody sees.

    >>> lighter('<path d="M 12.345678 0.5 L -3.14159 2" transform="scale(0.015625)"/>')
    '<path d="M 12.35 0.5 L -3.14 2" transform="scale(0.015625)"/>'
    """
    return re.sub(
        r' d="[^"]*"',
        lambda path: re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", path[0]),
        svg,
    )


def _sphinx(source: Path, made: Path, trees: Path) -> None:
    """Sphinx over the sources, in a process of its own; a warning is an error."""
    roles = "\n".join(f".. role:: {role}" for role in ("kept", *(f"kind-{kind}" for kind in Kind)))
    settings = {
        "project": TITLE,
        "html_title": TITLE,
        "html_theme": "furo",
        "html_math_renderer": "mathml",
        "html_static_path": [str(STATIC), "scripts"],
        "html_extra_path": [EXTRA],
        "html_css_files": ["site.css"],
        "html_js_files": ["site.js"],
        "html_copy_source": False,
        "html_use_index": False,
        "html_show_search_summary": False,
        "html_show_sphinx": False,
        "html_show_copyright": False,
        "smartquotes_action": "qe",  # of two hyphens it would make a dash
        "extensions": [
            *(f"symhaptic.book.site.{name}" for name in EXTENSIONS),
            "sphinx.ext.autodoc",
        ],
        **reference.SETTINGS,
        "rst_prolog": f"{roles}\n\n",
    }
    conf = "".join(f"{name} = {value!r}\n" for name, value in settings.items())
    (source / "conf.py").write_text(conf, encoding="utf-8")
    how = ["-q", "-n", "-W", "--keep-going", "--no-color", "-j", "auto", "-d", str(trees)]
    done = run([sys.executable, "-m", "sphinx", *how, source, made])
    if done.returncode != 0:
        told = (done.stderr or done.stdout).strip().splitlines() or ["no message"]
        raise ReportError(f"the site: {told[0]}")
    for page in made.glob("*.html"):  # a heading without a level is none to a screen reader
        text = page.read_text(encoding="utf-8")
        text = text.replace('role="heading"', 'role="heading" aria-level="2"')
        page.write_text(kept(text), encoding="utf-8")


def kept(html: str) -> str:
    """Formulas with the mark behind them: a browser may end a line between both.

    >>> kept("<math>x</math>, <math>y</math>")
    '<span class="kept"><math>x</math>,</span> <math>y</math>'
    """
    return re.sub(
        r"<math.*?</math>([.,;:!?)]*)",
        lambda found: f'<span class="kept">{found[0]}</span>' if found[1] else found[0],
        html,
        flags=re.DOTALL,
    )
