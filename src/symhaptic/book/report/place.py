"""Where a report goes: made beside its place, moved there whole, and nobody else's file lost."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from symhaptic.book.committed import GENERATED
from symhaptic.book.processes import folder
from symhaptic.notation.extras import missing

NEEDS = "a report needs docutils, jinja2 and matplotlib: pip install 'symhaptic[report]'"
SITE_NEEDS = (
    "the site needs sphinx, furo, nbformat, matplotlib and pypandoc_binary: "
    "pip install 'symhaptic[report]'"
)
NO_TEX = (
    "no latexmk and pdflatex found; on Debian: "
    "apt-get install latexmk texlive-latex-recommended lmodern"
)

SITE_MARK = ".symhaptic-site"
"""Stands in a folder that may be written anew, since it was made here."""

DRAFT = ".draft-"
"""Beginning of the name of the folder that a report is made in."""

STALE = 3600
"""Seconds after which a draft is removed: the machine went down while it was made."""

KEPT = (".tex", ".sty", ".bib", ".json", ".pdf")
"""Endings of what a report consists of; the rest is TeX's."""

MARKS = b"/Creator (symhaptic)", b"/GeneratedBy (symhaptic)"
"""What PDFs of a report say about themselves: figures, and what TeX made."""


class ReportError(RuntimeError):
    """The report cannot be written; the message is one line."""


def can() -> bool:
    """Whether what writes a report is installed."""
    return not missing("docutils", "jinja2", "matplotlib")


def has_tex() -> bool:
    """Whether latexmk and pdflatex are installed."""
    return shutil.which("latexmk") is not None and shutil.which("pdflatex") is not None


def can_site() -> bool:
    """Whether what makes the site is installed."""
    return not missing("sphinx", "furo", "jinja2", "nbformat", "matplotlib", "pypandoc")


def allowed(target: Path) -> None:
    """Raise :class:`ReportError` where something else stands in the site's place."""
    if not can_site():
        raise ReportError(SITE_NEEDS)
    if target.is_symlink() or (target.exists() and not (target / SITE_MARK).is_file()):
        raise ReportError(
            f"-o {target.parent}: {target.name} there was not written by `symhaptic report`; give "
            "another folder"
        )


def refuse_foreign(target: Path, names: Iterable[str]) -> None:
    """Say that a file stands in the place of a report's, and is none of a report's own."""
    for name in names:
        path = target / name
        if path.is_symlink() or (path.exists() and not _own(path)):
            raise ReportError(
                f"-o {target}: {name} there was not written by `symhaptic report`; "
                "give another folder"
            )


def _own(path: Path) -> bool:
    """Whether a report has written this file, which then says so."""
    if not path.is_file():
        return False
    content = path.read_bytes()
    if path.suffix == ".pdf":
        return any(mark in content for mark in MARKS)
    return GENERATED.encode() in content[:200]


def left_over(target: Path, names: Iterable[str]) -> list[Path]:
    """LaTeX of an earlier report that this one has not, such as that of a chapter now gone."""
    return [p for p in sorted(target.glob("*.tex")) if p.name not in names and _own(p)]


@contextmanager
def drafted(target: Path) -> Iterator[Path]:
    """A folder beside the place of a report; what is in it moves there when all of it is made.

    A run that is killed leaves the old report whole.
    """
    stack = ExitStack()
    try:
        for old in target.glob(f"{DRAFT}*"):  # another run may be making a younger one
            if time.time() - old.stat().st_mtime > STALE:
                shutil.rmtree(old, ignore_errors=True)
        draft = stack.enter_context(folder(DRAFT, target))
    except OSError as wrong:
        raise ReportError(
            f"-o {target}: cannot write there ({wrong.strerror}); a folder that can be written is "
            "allowed"
        ) from None
    with stack:
        yield draft
        made = [p for p in sorted(draft.rglob("*")) if p.is_file() and p.suffix in KEPT]
        refuse_foreign(target, [path.relative_to(draft).as_posix() for path in made])
        for path in made:
            place = target / path.relative_to(draft)
            place.parent.mkdir(exist_ok=True)
            os.replace(path, place)
