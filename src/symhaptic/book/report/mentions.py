"""What a text mentions is a link: chapters, equations, figures and tables of the paper, statements.

Looked for in what Sphinx has read, so that formulas, code and titles are left alone, and prose,
guides and docstrings need no marks.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from docutils import nodes

from symhaptic.book.chapters import Chapter
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.report.tree import label, words

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
        said: label("chapter", name)
        for number, name in names.items()
        for said in (f"chapter {number}", name)
    }
    ids = (id for id in settled if re.search(r"[\d:]", id))  # others are words like any
    return found | {id: label("statement", id) for id in ids}


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
    return "".join(n.astext() if not isinstance(n, nodes.math) else " " for n in words(text))
