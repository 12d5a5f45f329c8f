"""The guides of the repository, docs/*.md and what lies beside, as pages of the site."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from symhaptic.book.chapters import beside

ORDER = (
    *("model", "found", "tutorial", "limits", "loops", "simulation", "devices", "sweep", "howto"),
    *("verify", "chapters", "check", "export"),
    *("reports", "security", "verdicts", "statements", "speed", "design", "language"),
)
"""Of the guides, as they are read."""

BESIDE = {"contributing": "CONTRIBUTING.md", "changelog": "CHANGELOG.md"}
"""Pages that lie beside docs/."""

_LINK = re.compile(r"`([^`<]+) <(?:\.\./|docs/)?(\w+)\.md>`__")

_PLACE = re.compile(r"(`[^`<]+ <)(?:\.\./|docs/)?(\w+)\.md(#[\w-]+>`__)")

_LISTED = re.compile(r"(^|\| )(\(\d+\)) (?= +\S| *\|)", re.MULTILINE)
"""A cell with the number of an equation alone, which reStructuredText reads as that of a list."""

_PICTURE = re.compile(r"!\[[^\]]*\]\((\w+\.png)\)")


def guides() -> dict[str, str]:
    """Name and text of each guide as reStructuredText; none where there is no repository."""
    return _pages({name: f"docs/{name}.md" for name in ORDER})


def more() -> dict[str, str]:
    """The same of what lies beside."""
    return _pages(BESIDE)


def _pages(files: dict[str, str]) -> dict[str, str]:
    paths = {name: beside(file) for name, file in files.items()}
    return {
        name: led(turned(path.read_text("utf-8"))) for name, path in paths.items() if path.is_file()
    }


def led(text: str) -> str:
    """A guide with its links to others as links to their pages, and no cell read as a list."""
    text = _LISTED.sub(r"\1\\\2", text)
    text = _PLACE.sub(lambda link: f"{link[1]}{link[2].lower()}.html{link[3]}", text)
    return _LINK.sub(lambda link: f":doc:`{link[1]} <{link[2].lower()}>`", text)


def pictures() -> list[Path]:
    """The pictures that the guides show."""
    folder = beside("docs")
    texts = (folder / f"{name}.md" for name in ORDER if (folder / f"{name}.md").is_file())
    return [folder / name for text in texts for name in _PICTURE.findall(text.read_text("utf-8"))]


def pandoc() -> str:
    """The program."""
    import pypandoc

    return str(pypandoc.get_pandoc_path())


def turned(markdown: str) -> str:
    """Markdown as reStructuredText, by pandoc."""
    command = [pandoc(), "--from", "gfm-smart", "--to", "rst", "--wrap", "preserve"]
    return subprocess.run(
        command, input=markdown, capture_output=True, text=True, check=True, encoding="utf-8"
    ).stdout
