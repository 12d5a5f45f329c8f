"""A page as a tree of docutils nodes, which two writers turn into HTML and LaTeX.

What chapters, sources and notes say is text in this tree and never markup: each writer escapes it
in one place.  Only the few marks of :func:`scanned` mean something.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeAlias

from docutils import nodes
from docutils.nodes import Element, Node

from symhaptic.book.parts import numbers
from symhaptic.notation.latex import euler, refused

Part: TypeAlias = "str | Node | Sequence[str | Node]"
"""Plain text, a node, or several of both."""


class Link(nodes.inline):  # type: ignore[misc]  # docutils has no types
    """Words that lead to a place: ``to`` is what stands there, ``at`` its name."""


def led(to: str, at: str, *shown: Part) -> Link:
    """Return a link."""
    return Link("", "", *flat(shown), to=to, at=at)


def flat(parts: Iterable[Part]) -> list[Node]:
    """Parts as nodes; text stands for itself."""
    found: list[Node] = []
    for part in parts:
        if isinstance(part, str) and not isinstance(part, nodes.Text):
            found += [nodes.Text(_printable(part))] if part else []
        elif isinstance(part, Node):
            found.append(part)
        else:
            found += flat(part)
    return found


def _printable(text: str) -> str:
    """Text in one line, without control characters."""
    return re.sub(r"[\x00-\x1f\x7f\x85\u2028\u2029]+", _blank, text)


def _blank(found: re.Match[str]) -> str:
    return " " if found[0].isspace() else "\ufffd"


# -- words ----------------------------------------------------------------------------

_MARK = re.compile(
    r"\$(?P<formula>[^$]*)\$"
    r"|\\chapter\{(?P<chapter>\w+)\}"
    r"|\\texttt\{(?P<code>[^{}$]*)\}"
    r"|(?P<emphasis>\\(?:emph|textbf)\{)"
    r"|(?P<space>\\,|~)"
    r"|\\(?P<sign>[%&_#]|\^\{\})"
    r"|(?P<brace>[{}])"
)
"""The marks that a text may have; everything else in it stands for itself."""

SPACES = {r"\,": "\u202f", "~": "\xa0"}
"""What prose writes for a space, and what it means."""


def scanned(text: str) -> Iterator[tuple[str, str]]:
    r"""Parts of a text, each with its kind: a mark, ``end`` of an emphasis, or plain ``text``.

    A formula that :func:`refused` objects to, and a brace that belongs to no mark, are text.

    >>> list(scanned(r"\emph{5\% of {$a_b$}} $\input{x}$"))[:4]
    [('emphasis', '\\emph{'), ('text', '5'), ('text', '%'), ('text', ' of ')]
    """
    opened: list[str] = []
    done = 0
    for mark in _MARK.finditer(text):
        if mark.start() > done:
            yield "text", text[done : mark.start()]
        done = mark.end()
        kind = str(mark.lastgroup)
        part = mark[kind]
        if part == "}" and opened and opened.pop() == "emphasis":
            yield "end", ""
        elif kind == "sign":
            yield "text", part[0]
        elif kind == "code":
            yield kind, re.sub(r"\\([_%&#])", r"\1", part)
        elif (
            kind == "brace"
            or (kind == "formula" and refused(part))
            or (kind == "chapter" and part not in numbers())
        ):
            yield "text", mark[0]
        else:
            yield kind, part
        if kind == "emphasis" or part == "{":
            opened.append(kind)
    yield "text", text[done:]


def words(text: str) -> list[Node]:
    r"""Prose with formulas between dollar signs as nodes.

    >>> [node.astext() for node in words(r"- the angle $\theta$, of \emph{50\,\%} $5")]
    ['- the angle ', '\\theta', ', of ', '50\u202f%', ' $5']
    """
    found: list[list[str | Node]] = [[]]
    for kind, part in scanned(" ".join(text.split())):
        match kind:
            case "emphasis":
                found.append([])
            case "end":
                inner = found.pop()
                found[-1].append(nodes.emphasis("", "", *flat([_joined(inner)])))
            case "formula":
                found[-1].append(math(euler(part)))
            case "code":
                found[-1].append(nodes.literal("", _printable(part)))
            case "chapter":
                number = numbers()[part]
                found[-1].append(led("chapter", part, f"chapter {number}"))
            case _:
                found[-1].append(SPACES.get(part, part) if kind == "space" else part)
    while len(found) > 1:  # an emphasis that never ends
        inner = found.pop()
        found[-1].append(nodes.emphasis("", "", *flat([_joined(inner)])))
    return flat([_joined(found[0])])


def _joined(parts: Iterable[str | Node]) -> list[str | Node]:
    """Neighbouring texts as one."""
    found: list[str | Node] = []
    for part in parts:
        last = found[-1] if found else None
        if type(part) is str and type(last) is str:
            found[-1] = last + part
        else:
            found.append(part)
    return found


def as_sentence(text: str) -> str:
    """Words that begin with a capital letter and end with a stop."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?", ":")) else f"{text}."


def math(tex: str) -> nodes.math:
    """A formula in a line of text."""
    return nodes.math("", tex)


def listed(parts: Iterable[Part], mark: str = ", ") -> list[Part]:
    """Parts with a mark between them."""
    return [one for at, part in enumerate(parts) for one in ((mark, part) if at else (part,))]


def kind(verdict: str) -> nodes.inline:
    """A verdict in its colour."""
    return nodes.inline("", str(verdict), classes=[f"kind-{verdict}"])


def strong(*parts: Part) -> nodes.strong:
    """Words in bold."""
    return nodes.strong("", "", *flat(parts))


def emphasis(*parts: Part) -> nodes.emphasis:
    """Words in italics."""
    return nodes.emphasis("", "", *flat(parts))


# -- blocks ---------------------------------------------------------------------------


def paragraph(*parts: Part, **given: object) -> nodes.paragraph:
    """A paragraph of inline parts."""
    return nodes.paragraph("", "", *flat(parts), **given)


def paragraphs(text: str) -> list[Node]:
    """Prose, its paragraphs parted by blank lines."""
    return [paragraph(words(part)) for part in re.split(r"\n\s*\n", text)]


def container(kinds: str, *children: Node, **given: object) -> nodes.container:
    """Blocks that belong together, of a kind that both writers know."""
    return nodes.container("", *children, classes=kinds.split(), **given)


def rubric(*parts: Part, **given: object) -> nodes.rubric:
    """The heading of a step."""
    return nodes.rubric("", "", *flat(parts), **given)


def display(rows: Iterable[str], aligned: bool = False) -> nodes.math_block:
    """A formula that stands by itself, line by line; with ``&`` where its lines are aligned."""
    rows = list(rows)
    return nodes.math_block("", " ".join(rows), rows=rows, aligned=aligned)


def section(title: Part, *children: Node, **given: object) -> nodes.section:
    """A heading with what stands below it."""
    return nodes.section("", nodes.title("", "", *flat([title])), *children, **given)


def table(kinds: str, rows: Iterable[Sequence[Part]], **given: object) -> nodes.table:
    """Rows of cells, the head first."""
    head, *body = (
        nodes.row("", *(nodes.entry("", paragraph(cell)) for cell in row)) for row in rows
    )
    columns = [nodes.colspec(colwidth=1) for _ in head]
    group = nodes.tgroup(
        "", *columns, nodes.thead("", head), nodes.tbody("", *body), cols=len(columns)
    )
    return nodes.table("", group, classes=["colwidths-auto", *kinds.split()], **given)


def figure(name: str, alt: str, *caption: Part) -> nodes.figure:
    """A picture of the folder ``figures``, with its caption."""
    image = nodes.image(uri=f"figures/{name}.svg", alt=alt)
    return nodes.figure("", image, nodes.caption("", "", *flat(caption)), name=name)


def only(writer: str, *blocks: Element) -> list[Node]:
    """Blocks that are for one of the writers, ``site`` or ``print``."""
    for block in blocks:
        block["only"] = writer
    return list(blocks)


# -- places ---------------------------------------------------------------------------


def label(to: str, at: str) -> str:
    """The name of a place, of which TeX and HTML keep all.

    >>> label("statement", "rules:four"), label("statement", "my:K_0"), label("rule", "roots_stay")
    ('statement-rules.3a.four', 'statement-my.3a..4b..5f.0', 'rule-roots-stay')
    """
    return f"{to}-{place_of(to, at)}".lower()


def place_of(to: str, at: str) -> str:
    """The name of a place in letters that TeX and HTML leave alone."""
    if to == "rule":
        return re.sub(r"[^A-Za-z0-9]+", "-", at)
    if to in ("statement", "erratum"):
        return re.sub(r"[^a-z0-9-]", lambda odd: f".{ord(odd[0]):x}.", at)
    return at
