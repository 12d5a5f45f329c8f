"""What a text mentions is a link: chapters, equations, figures and tables of the paper, statements.

Looked for in what Sphinx has read, so that formulas, code and titles are left alone, and prose,
guides and docstrings need no marks.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

from symhaptic.book.chapters import Chapter
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.parts import referred
from symhaptic.book.tex.words import place_of

PLACES = "places.json"
"""Where the sources keep the places of what may be mentioned."""

Span = tuple[int, int, str]
"""Where a mention begins and ends, and the label of what it mentions."""

_MENTION = re.compile(
    r"(?<![\w)])\((?P<eq>\d{1,2})\)"
    r"|\b(?P<fig>Figs?\.\s\d+(?:,?\s(?:and|to)\s\d+)?)"
    r"|\bTable\s(?P<tab>II?)\b"
    r"|\b[Cc]hapter\s(?P<chapter>\d+)\b"
    r"|(?<![\w:.-])(?P<id>(?:rules:)?[a-z]\w*(?:-\w+)*)(?![\w-]|\.\w)"
)


def places(names: Mapping[int, str], settled: Iterable[str]) -> dict[str, str]:
    """Label of each chapter and of each statement that stands on the site.

    >>> places({22: "s3b_rise"}, ["eq11", "arm-numbers"])
    {'chapter 22': 'chapter-s3b_rise', 's3b_rise': 'chapter-s3b_rise', 'eq11': 'statement-eq11'}
    """
    found = {
        said: f"chapter-{name}"
        for number, name in names.items()
        for said in (f"chapter {number}", name)
    }
    ids = (id for id in settled if re.search(r"[\d:]", id))  # others are words like any
    return found | {id: f"statement-{place_of(id)}" for id in ids}


def mentions(text: str, known: Mapping[str, str]) -> Iterator[Span]:
    """What a text mentions of the places that are known.

    >>> known = {"eq11": "a", "fig4": "b", "fig11": "c", "tab2": "d", "chapter 7": "e"}
    >>> text = "By (11), H(11) or eq11, Figs. 4 and 11, Table II and chapter 7, not 8"
    >>> print(*(f"{text[a:b]} {label}" for a, b, label in mentions(text, known)), sep=", ")
    (11) a, eq11 a, Figs. 4 b, 11 c, Table II d, chapter 7 e
    """
    for match in _MENTION.finditer(text):
        start, end = match.span()
        if match["fig"]:
            for at, number in enumerate(re.finditer(r"\d+", match["fig"])):
                if f"fig{number[0]}" in known:
                    begins = start + number.start() if at else start
                    yield begins, start + number.end(), known[f"fig{number[0]}"]
            continue
        named = {
            "eq": f"eq{match['eq']}",
            "tab": f"tab{len(match['tab'] or '')}",
            "chapter": f"chapter {match['chapter']}",
            "id": match["id"],
        }[match.lastgroup or ""]
        if named in known:
            yield start, end, known[named]


def mentioned(chapter: Chapter, known: Mapping[str, str]) -> set[str]:
    """Labels of what a chapter mentions in its words."""
    page = chapter.page
    said = [chapter.introduction]
    for block in page.blocks:
        said += [block.text, *(cell for row in block.rows for cell in row if isinstance(cell, str))]
        said += [block.title] if block.kind != "figure" else []
    for id, item in page.settled.items():
        said += [item.statement.says, CONSEQUENCES.get(id, "")]
    own = {known.get(id) for id in page.settled}
    return {label for text in said for *_, label in mentions(_prose(text), known)} - own


def _prose(text: str) -> str:
    """What is no formula, as it is read."""
    text = referred(text, lambda number: f"chapter {number}")
    return " ".join(text.split("$")[::2]).replace("~", " ").replace(r"\,", " ")


# -- for Sphinx ---------------------------------------------------------------------------

_LEFT_ALONE = (
    *(nodes.title, nodes.strong, nodes.reference, nodes.literal, nodes.literal_block),
    *(nodes.math, nodes.raw),
    *(nodes.math_block, nodes.comment, nodes.image, addnodes.pending_xref),
    *(addnodes.download_reference, addnodes.desc_signature),
)


class Mentions(SphinxTransform):
    """Parts the text of a page where it mentions what has a place."""

    default_priority = 600

    def apply(self, **_: Any) -> None:
        """Of the page that has been read."""
        known = self.config.symhaptic_places
        for text in list(self.document.findall(nodes.Text)):
            if not _within(text, _LEFT_ALONE):
                self._part(text, list(mentions(str(text), known)))

    def _part(self, text: nodes.Text, spans: list[Span]) -> None:
        parts: list[nodes.Node] = []
        done = 0
        for start, end, label in spans:
            parts += [nodes.Text(text[done:start]), self._link(text[start:end], label)]
            done = end
        if spans:
            text.parent.replace(text, [*parts, nodes.Text(text[done:])])

    def _link(self, shown: str, label: str) -> nodes.Node:
        how = {"refdomain": "std", "reftype": "ref", "reftarget": label, "refexplicit": True}
        inner = nodes.inline(shown, shown)
        return addnodes.pending_xref("", inner, refdoc=self.env.docname, refwarn=True, **how)


def _within(node: nodes.Node, kinds: tuple[type, ...]) -> bool:
    while node.parent is not None:
        node = node.parent
        if isinstance(node, kinds):
            return True
    return False


def setup(app: Sphinx) -> dict[str, Any]:
    """Sphinx's entry."""
    known = json.loads((Path(app.srcdir) / PLACES).read_text(encoding="utf-8"))
    app.add_config_value("symhaptic_places", known, "env")
    app.add_transform(Mentions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
