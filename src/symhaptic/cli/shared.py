"""What the commands share: how a bad input is told, progress, and where results go."""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryFile
from typing import NoReturn

import typer

app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF}
"""Errors of a place that is full, or that is open for reading only."""


class Unusable(ValueError):
    """A bad input, with the line that names the argument, its value and what is allowed."""


def refuse(message: str) -> NoReturn:
    """End with one line that says what is wrong."""
    raise Unusable(message)


@contextmanager
def progress(total: int) -> Iterator[Callable[[int, Path], None]]:
    """A progress bar that shows the statement under way, where somebody watches."""
    if not sys.stderr.isatty():
        yield lambda done, path: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from symhaptic.book.listing import under_way

    columns = (TextColumn("{task.description:32}"), BarColumn(), MofNCompleteColumn())
    console = Console(stderr=True)
    with Progress(*columns, TimeElapsedColumn(), console=console, transient=True) as bar:
        task = bar.add_task("", total=total)
        yield lambda done, path: bar.update(task, completed=done, description=under_way(path))


def can_draw(option: str) -> None:
    """Say before the work is done that nothing is there that draws."""
    if find_spec("matplotlib") is None:
        refuse(f"{option}: needs matplotlib; pip install 'symhaptic[report]'")


def writable(output: Path | None) -> None:
    """Say before the work is done that its result has no place; only writing shows it."""
    if output is None:
        return
    if output.is_dir() or not output.parent.is_dir():
        reason = "Is a directory" if output.is_dir() else "No such file or directory"
        unwritable(output, reason)
    if output.exists() and not output.is_file():  # a device or a pipe has no draft beside it
        return
    try:
        with TemporaryFile(dir=output.resolve().parent):
            pass
    except OSError as wrong:
        unwritable(output, wrong.strerror)


def only_listed(**given: object) -> None:
    """Refuse what has no effect beside --list, by its option's name; what is empty is not given."""
    for name, value in given.items():
        if value:
            option = "-o" if name == "output" else f"--{name}"
            said = option if value is True else f"{option} {value}"
            refuse(f"{said}: has no effect on what --list prints; leave one of them out")


def unwritable(output: Path, reason: str | None) -> NoReturn:
    """End with one line that says why nothing can be written there."""
    refuse(f"-o {output}: cannot write there ({reason}); give a file in a folder that exists")


def folder_allowed(output: Path, option: str = "-o") -> None:
    """Say before the work is done that no folder of results can be there.

    Only writing shows it, so folders are made for a moment.
    """
    from symhaptic.book import processes

    try:
        with processes.folder(parent=output):
            pass
    except OSError as wrong:
        if wrong.filename is None:  # no file can be opened at all
            raise
        no_folder(output, wrong.strerror, option)


def no_folder(output: Path, reason: str | None, option: str = "-o") -> NoReturn:
    """End with one line that says why no folder of results can be there."""
    where = f"{option} {output}"
    refuse(f"{where}: cannot write there ({reason}); give a folder that can be written")


@contextmanager
def filling(output: Path) -> Iterator[None]:
    """Name the folder of results where a file in it cannot be written whole."""
    try:
        yield
    except OSError as wrong:
        if wrong.errno not in FULL:
            raise
        no_folder(output, wrong.strerror)


def write(replace: Callable[[Path, str | bytes], None], output: Path, content: str | bytes) -> None:
    """A result into its file, whole or not at all."""
    try:
        replace(output, content)
    except OSError as wrong:
        unwritable(output, wrong.strerror)
