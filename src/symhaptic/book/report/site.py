"""The site as a folder: sources for Sphinx, figures as SVG, and Sphinx's run."""

from __future__ import annotations

import base64
import os
import pickle
import re
import shutil
import sys
from collections import defaultdict
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from pathlib import Path
from string import Template

from docutils import nodes

from symhaptic.book.committed import GENERATED
from symhaptic.book.figures import drawings
from symhaptic.book.ledger import by_source, counted, of_chapter
from symhaptic.book.ledger import ledger as listed
from symhaptic.book.listing import replace
from symhaptic.book.parts import OWN, PARTS, part_of
from symhaptic.book.processes import folder, run
from symhaptic.book.report import explorer, gallery, guides, mentions, pages, reference
from symhaptic.book.report.chapter import Place, page
from symhaptic.book.report.extension import TREES
from symhaptic.book.report.notebooks import FOLDER, GUIDES, notebooks
from symhaptic.book.report.place import SITE_MARK, ReportError, allowed
from symhaptic.book.report.printed import MEANINGS, Numbered, Say, Take
from symhaptic.book.report.tree import Part, kind, led, paragraph, section, strong, table, words
from symhaptic.book.rests import between, shown_in

STATIC = Path(__file__).parent / "static"
TITLE = "Haptic walls, verified"

OWN_PAGES = {
    *("believed", "errata", "explorer", "gallery", "ledger", "reference", "results"),
    *guides.ORDER,
    *guides.BESIDE,
}
"""Pages that are no chapters."""

_WITHOUT_LIST = ("errata", "explorer", "results")
"""Pages without a list of their sections, which leaves more room for formulas."""

EXTRA = "extra"
"""Where the sources have what Sphinx takes over as it is."""

OPENING = (
    "How stiff and how damped may a virtual wall be before it becomes active or unstable, for your "
    "device, sampling rate and delay? The Python package symhaptic computes and proves the limits. "
    r"It also checks every formula of \emph{Passivity and Stability Boundaries for Haptic Systems "
    r"with Time Delay} (T. Hulin, A. Albu-Schäffer, G. Hirzinger, 2014). Each formula is derived "
    "from first principles and proved or refuted as published. No verdict rests on sampling."
)

TASKS: tuple[tuple[str, Part], ...] = (
    ("What is modelled, and which formula is for what?", led("page", "model")),
    (
        "How stiff may my wall be?",
        [led("page", "limits"), ", or ", led("page", "explorer", "change a loop in the explorer")],
    ),
    ("How is it installed, and what are the first steps?", led("page", "tutorial")),
    (
        "Which formula, and under which condition?",
        led("page", "results", "The formulas to use"),
    ),
    (
        "What is wrong in the paper?",
        [
            *(led("page", "found", "The findings by importance"), ", "),
            *(led("page", "errata", "all errata"), ", and "),
            led("page", "ledger", "every statement"),
        ],
    ),
    (
        "Is my own formula right? Is my code?",
        [led("page", "verify"), " and ", led("page", "check")],
    ),
    (
        "A figure, a sweep, a microcontroller, a thesis",
        [led("page", "howto"), " and ", led("page", "gallery")],
    ),
    ("What does a verdict mean, and what is the trusted base?", led("page", "verdicts")),
    ("All functions", led("page", "reference")),
)
"""What somebody comes for, and where it is."""


def trees(numbered: Sequence[Numbered], whole: bool) -> dict[str, nodes.section]:
    """Every page that is a tree; of some chapters alone, where they are not the ``whole``."""
    names = {number: chapter.name for number, chapter in numbered}
    known = _places(numbered)
    mentioned: dict[str, set[int]] = defaultdict(set)
    for number, chapter in numbered:
        for place in mentions.mentioned(chapter, known):
            mentioned[place].add(number)
    shared = Place(
        0,
        shown_in(numbered),
        whole,
        names,
        between(numbered),
        frozenset(id for _, chapter in numbered for id in chapter.page.settled),
        {place: frozenset(numbers) for place, numbers in mentioned.items()},
        frozenset(reference.PUBLIC if whole else ()),
    )
    for name in names.values():
        if name in OWN_PAGES:
            raise ReportError(f"{name}: the site has a page of this name; rename the chapter")
    found = {one.name: page(one, shared.of(number)) for number, one in numbered}
    entries = listed(entry for _, chapter in numbered for entry in of_chapter(chapter))
    if whole:
        places = {chapter.source: (number, chapter.name) for number, chapter in numbered}
        found["results"] = pages.results(entries, places)
        found["errata"] = pages.errata(entries, places)
        found["ledger"] = pages.ledger(entries, places)
        found |= reference.trees()
        if gallery.programs():
            found["gallery"] = gallery.page()
    found["believed"] = pages.believed(entries)
    found["explorer"] = explorer.page()
    opening = [paragraph(words(OPENING))]
    if whole:
        count = strong(f"{len(entries)} statements,")
        opening += [
            table("tasks", [["you want", "go to"], *TASKS]),
            paragraph(count, f" {by_source(entries)}: {counted(entries)}."),
            table("kinds", [["verdict", "what it means"], *([kind(k), m] for k, m in MEANINGS)]),
        ]
    found["index"] = section(TITLE, *opening)
    return found


def _places(numbered: Sequence[Numbered]) -> dict[str, str]:
    names = {number: chapter.name for number, chapter in numbered}
    return mentions.places(names, (id for _, chapter in numbered for id in chapter.page.settled))


def _texts(numbered: Sequence[Numbered], known: Mapping[str, nodes.section]) -> dict[str, str]:
    """Name and text of each page for Sphinx: guides, and where trees stand."""
    whole = "ledger" in known
    found = {
        name: f"{':hide-toc:' * ('number' in tree or name in _WITHOUT_LIST)}\n\n.. tree:: {name}\n"
        for name, tree in known.items()
        if not name.startswith(reference.PREFIX)
    }
    if whole:
        found |= {name: _with_notebook(name, text) for name, text in guides.guides().items()}
        found |= guides.more() | {"reference": reference.page(known)}
    before = ["results", "errata", "ledger"] if whole else []
    found["index"] += _toctree("Results", [*before, "believed"])
    shown = [*guides.guides(), *(["gallery"] if "gallery" in known else [])] if whole else []
    found["index"] += _toctree("Use it", ["explorer", *shown])
    found["index"] += _toctree("Reference", ["reference", *guides.more()]) if whole else ""
    for part in (*PARTS, OWN):
        inside = [chapter.name for _, chapter in numbered if part_of(chapter.name) is part]
        found["index"] += _toctree(part.title, inside) if inside else ""
    return found


def _with_notebook(name: str, text: str) -> str:
    """A guide that leads to itself as a notebook, below its title."""
    if name not in GUIDES:
        return text
    title, _, rest = text.partition("\n\n")
    link = f"The same `as a notebook <{FOLDER}/{name}.ipynb>`__, to be run and changed."
    return f"{title}\n\n.. container:: source\n\n   {link}\n\n{rest}"


def _toctree(title: str, names: Sequence[str]) -> str:
    lines = ["", ".. toctree::", "   :hidden:", "   :maxdepth: 1", f"   :caption: {title}", ""]
    return "\n".join([*lines, *(f"   {name}" for name in names), ""])


# -- files ----------------------------------------------------------------------------


def write(
    numbered: Sequence[Numbered],
    target: Path,
    say: Say,
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
        (made / SITE_MARK).write_text("written by `symhaptic report`; may be replaced\n")
        if target.exists():
            os.replace(target, draft / "old")
        os.replace(made, target)


def _sources(numbered: Sequence[Numbered], source: Path, say: Say, whole: bool, take: Take) -> None:
    known = trees(numbered, whole)
    (source / "figures").mkdir(parents=True)
    with gallery.drawn(source) if whole else nullcontext():
        for name, text in _texts(numbered, known).items():
            (source / f"{name}.rst").write_text(text, encoding="utf-8")
        (source / TREES).write_bytes(pickle.dumps((known, _places(numbered))))
        (source / "code").mkdir()
        for _, chapter in numbered:
            shutil.copy(chapter.path, source / "code")
        for block in drawings.figures([chapter for _, chapter in numbered]):
            say(f"figure {block.title} of the site")
            take(block, source / "figures" / f"{block.title}.svg")
        (source / "scripts" / explorer.NAME).mkdir(parents=True)
        for name, text in explorer.files():
            (source / "scripts" / name).write_text(text, encoding="utf-8")
        for picture in guides.pictures() if whole else ():
            shutil.copy(picture, source)
        (source / EXTRA / FOLDER).mkdir(parents=True)
        for name, text in notebooks().items() if whole else ():
            (source / EXTRA / FOLDER / f"{name}.ipynb").write_text(text, encoding="utf-8")
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


def _sphinx(source: Path, made: Path, doctrees: Path) -> None:
    """Sphinx over the sources, in a process of its own; a warning is an error."""
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
        "html_search_scorer": str(STATIC / "scorer.js"),
        "html_use_index": False,
        "html_show_search_summary": False,
        "html_show_sphinx": False,
        "html_show_copyright": False,
        "smartquotes_action": "qe",  # of two hyphens it would make a dash
        "extensions": ["symhaptic.book.report.extension"],
        **reference.SETTINGS,
    }
    conf = "".join(f"{name} = {value!r}\n" for name, value in settings.items())
    (source / "conf.py").write_text(conf, encoding="utf-8")
    how = ["-q", "-n", "-W", "--keep-going", "--no-color", "-j", "auto", "-d", str(doctrees)]
    done = run([sys.executable, "-m", "sphinx", *how, source, made])
    if done.returncode != 0:
        told = (done.stderr or done.stdout).strip().splitlines() or ["no message"]
        why = next((line.strip() for line in told if "(exception: " in line), told[0])
        raise ReportError(f"the site: {why}")
    for path in made.glob("*.html"):  # a heading without a level is none to a screen reader
        text = path.read_text(encoding="utf-8")
        text = text.replace('role="heading"', 'role="heading" aria-level="2"')
        path.write_text(kept(text), encoding="utf-8")


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


# -- a chapter as one file ------------------------------------------------------------

_PAGE = Template("""\
<!doctype html>
<!-- $generated -->
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="symhaptic report">
<title>$title</title>
<style>
$style
:root { color-scheme: light dark;
  --color-background-border: #8884; --color-foreground-muted: #767676;
  --color-background-primary: Canvas; --color-background-secondary: Canvas;
  --color-code-background: Canvas; --color-foreground-primary: CanvasText;
  --color-brand-primary: LinkText; }
body { font-family: var(--font-stack); line-height: 1.5;
  max-width: 56em; margin: 2em auto; padding: 0 1em; }
img { max-width: 100%; height: auto; }
.headerlink, .math-link { display: none; }
p.rubric { font-weight: 700; }
table.numbers { border-collapse: collapse; }
table.numbers :is(td, th) { padding: .2em .8em; border-bottom: 1px solid #8884; }
</style>
<script>
$script
</script>
</head>
<body>
<main>
$article
</main>
</body>
</html>
""")


def write_single(numbered: Sequence[Numbered], target: Path, say: Say) -> list[Path]:
    """One file for each chapter; a site is made beside, and left behind."""
    with folder() as beside:
        site = beside / "site"
        write(numbered, site, say, whole=False)
        made = {target / f"{c.name}.html": single(site, c.name) for _, c in numbered}
    target.mkdir(parents=True, exist_ok=True)
    for path, text in made.items():
        replace(path, text)
    return list(made)


def single(folder: Path, name: str) -> str:
    """Of a site in a folder; links to its other pages become words."""
    text = (folder / f"{name}.html").read_text(encoding="utf-8")
    found = re.search(r"<article[^>]*>(.*?)</article>", text, re.DOTALL)
    title = re.search(r"<title>(.*?)</title>", text, re.DOTALL)
    article = "" if found is None else found[1]
    article = re.sub(r'<a [^>]*href="[^"#][^"]*"[^>]*>(.*?)</a>', r"\1", article, flags=re.DOTALL)
    article = re.sub(r'src="([^"]*\.svg)"', lambda m: f'src="{_data(folder / m[1])}"', article)
    return _PAGE.substitute(
        generated=GENERATED,
        title=name if title is None else title[1],
        style=(STATIC / "site.css").read_text(encoding="utf-8"),
        script=(STATIC / "site.js").read_text(encoding="utf-8"),
        article=article.strip(),
    )


def _data(image: Path) -> str:
    return "data:image/svg+xml;base64," + base64.b64encode(image.read_bytes()).decode("ascii")
