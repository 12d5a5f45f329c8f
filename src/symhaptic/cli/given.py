"""Chapters and sources that a user gives: their options, and messages if they cannot be run."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.cli.shared import refuse

if TYPE_CHECKING:
    from symhaptic.book.chapters import BadChapter

Derivations = Annotated[
    list[Path] | None,
    typer.Option("--derivation", metavar="FILE", help="A chapter of your own; repeatable."),
]

SourceFolder = Annotated[
    Path | None,
    typer.Option(
        "--source", metavar="DIR", help="Your own source: a folder with source.py and chapters."
    ),
]


def chapters_in(folder: Path) -> list[Path]:
    """The chapters of a user's source, which is read before any of them is run."""
    from symhaptic.book.chapters import SOURCE_FILE, BadChapter, readable, source_beside

    if not (folder / SOURCE_FILE).is_file():
        refuse(f"--source {folder}: has no {SOURCE_FILE}; give a folder with one")
    paths = [path for path in sorted(folder.glob("*.py")) if path.name != SOURCE_FILE]
    if not paths:
        refuse(f"--source {folder}: has no chapter beside {SOURCE_FILE}")
    try:
        source_beside(paths[0])
        return [readable(path) for path in paths]
    except BadChapter as wrong:
        refuse(f"--source {wrong}")


def told_bad(wrong: BadChapter, own: list[Path]) -> None:
    """One line on what is wrong with a chapter."""
    given = "--derivation " if wrong.path in own else ""
    from symhaptic.book.listing import shown

    typer.echo(shown(f"symhaptic: error: {given}{wrong}"), err=True)


def own_chapters(paths: list[Path] | None) -> list[Path]:
    """A user's chapters, which are looked at before anything is run."""
    from symhaptic.book.chapters import BadChapter, readable

    try:
        return list({path.resolve(): readable(path) for path in paths or []}.values())
    except BadChapter as wrong:
        refuse(f"--derivation {wrong}")


def read(own: list[Path], source: Path | None) -> list[Path]:
    """What somebody has written and hands in."""
    from symhaptic.book.chapters import SOURCE_FILE

    return own if source is None else [*own, source / SOURCE_FILE]
