"""The guides of the repository, docs/*.md, as pages of the site."""

from __future__ import annotations

import re
import subprocess

from symhaptic.book.chapters import beside
from symhaptic.book.site.mathml import pandoc

ORDER = ("limits", "verify", "check", "export", "reports", "speed", "design", "found")
"""Of the guides, as they are read."""

_LINK = re.compile(r"`([^`<]+) <(\w+)\.md>`__")


def guides() -> dict[str, str]:
    """Name and text of each guide as reStructuredText; none where there is no repository."""
    folder = beside("docs")
    return {
        name: _LINK.sub(r":doc:`\1 <\2>`", turned((folder / f"{name}.md").read_text("utf-8")))
        for name in ORDER
        if (folder / f"{name}.md").is_file()
    }


def turned(markdown: str) -> str:
    """Markdown as reStructuredText, by pandoc."""
    command = [pandoc(), "--from", "gfm-smart", "--to", "rst", "--wrap", "preserve"]
    return subprocess.run(
        command, input=markdown, capture_output=True, text=True, check=True, encoding="utf-8"
    ).stdout
