"""The gallery: short programs of docs/gallery, each with the picture that it draws when it is run.

A program draws into the current figure; what the picture looks like on the site is said here.
"""

from __future__ import annotations

import ast
import re
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from subprocess import PIPE

from docutils import nodes

from symhaptic.book.chapters import beside
from symhaptic.book.processes import program
from symhaptic.book.report.place import ReportError
from symhaptic.book.report.tree import Part, flat, led, paragraph, section, words

NAME = "gallery"
ORDER = (
    *("walls", "limit_over_delay", "step_response", "rules_in_circulation", "hands"),
    *("safe_walls", "delay_margin", "sweep_map", "passive_walls", "fractional_delay"),
)
"""As they are shown."""


def programs() -> list[Path]:
    """The programs; none where there is no repository."""
    paths = [beside(f"docs/{NAME}/{name}.py") for name in ORDER]
    return [path for path in paths if path.is_file()]


def page() -> nodes.section:
    """Each picture with its program."""
    shown = []
    for path in programs():
        title, more, code = _parts(path)
        link = led("code", f"../{NAME}/{path.name}", path.name)
        lines = nodes.literal_block(code, code, language="python")
        blocks = (paragraph(words(more)), picture(path), lines, paragraph("Download ", link, "."))
        shown.append(section(words(title), *blocks, to=NAME, at=path.stem))
    opening = paragraph(
        "Each picture is drawn by the lines below it, when this page is made. ",
        nodes.literal("", "plt.show()"),
        " at their end opens a window, ",
        nodes.literal("", 'plt.savefig("name.pdf")'),
        " writes a file.",
    )
    return section("Gallery", opening, *shown, to="page", at=NAME)


def _parts(path: Path) -> tuple[str, str, str]:
    """Title, words and code of a program."""
    text = path.read_text(encoding="utf-8")
    title, _, more = (ast.get_docstring(ast.parse(text)) or "").partition("\n\n")
    return title.rstrip("."), more, text.split('"""', 2)[2].strip()


def picture(path: Path, *caption: Part) -> nodes.figure:
    """What a program draws."""
    image = nodes.image(uri=f"{NAME}/{path.stem}.svg", alt=_parts(path)[0])
    below = [nodes.caption("", "", *flat(caption))] if caption else []
    return nodes.figure("", image, *below)


@contextmanager
def drawn(source: Path) -> Iterator[None]:
    """Draw the pictures of the programs beside the sources of the site, while others are made.

    Raises :class:`ReportError` at the end, with the program that fails and its last line.
    """
    found = programs()
    if not found:
        yield
        return
    folder = source / NAME
    folder.mkdir()
    for path in found:
        shutil.copy(path, folder)
    command = [sys.executable, "-m", "symhaptic.book.figures.programs", str(folder)]
    with program([*command, *map(str, found)], stderr=PIPE) as drawing:
        yield
        _, told = drawing.communicate()
    if drawing.returncode:
        names = re.findall(rf"{NAME}.(\w+\.py)", told) or [NAME]
        raise ReportError(f"docs/{NAME}/{names[-1]}: {told.strip().splitlines()[-1]}")


def shows(name: str) -> list[Path]:
    """The programs that use a public name."""
    use = re.compile(rf"\b{name}\b")
    return [path for path in programs() if use.search(path.read_text(encoding="utf-8"))]
