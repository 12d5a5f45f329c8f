"""Where the site goes, and what has to be installed to make it."""

from __future__ import annotations

from pathlib import Path

from symhaptic.book.tex.tex import ReportError
from symhaptic.notation.extras import missing

NEEDS = (
    "the site needs sphinx, furo, nbformat, matplotlib and pypandoc_binary: "
    "pip install 'symhaptic[report]'"
)
MARK = ".symhaptic-site"
"""Stands in a folder that may be written anew, since it was made here."""


def can() -> bool:
    """Whether what makes the site is installed."""
    return not missing("sphinx", "furo", "jinja2", "nbformat", "matplotlib", "pypandoc")


def allowed(target: Path) -> None:
    """Raise :class:`ReportError` where something else stands in the site's place."""
    if not can():
        raise ReportError(NEEDS)
    if target.is_symlink() or (target.exists() and not (target / MARK).is_file()):
        raise ReportError(
            f"-o {target.parent}: {target.name} there is not made by `symhaptic report`; a folder "
            "without it is allowed"
        )
