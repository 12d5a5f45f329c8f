"""Pages as LaTeX: what is typed is printed as it stands, and no command in it is run."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import singledispatch

from docutils import nodes
from docutils.nodes import Element, Node

from symhaptic.book.parts import titles
from symhaptic.book.report.breaking import in_margin, running, stack
from symhaptic.book.report.chapter import reference
from symhaptic.book.report.tree import Link, as_sentence, place_of, words
from symhaptic.proof.theorems.axioms import AXIOMS

BESIDE = 110
"""Letters of what something rests on up to which the margin lists it all."""

_SIGNS = {
    **{sign: f"\\{sign}" for sign in "_%#&{}$"},
    **{"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\textasciitilde{}"},
    **{"\u202f": r"\,", "\xa0": "~", "“": "``", "”": "''", "—": "---"},
}


def literally(text: str) -> str:
    """Any letters as they are, such as those of a name, without TeX's ligatures of signs."""
    shown = "".join(_SIGNS.get(c, c) for c in re.sub(r"([-<>,'`])(?=\1)", "\\1\0", text))
    return shown.replace("\0", "{}")


def prose(text: str) -> str:
    r"""Prose with formulas between dollar signs.

    >>> print(prose("50 % of $a_b$, not {c"), prose(r"\emph{50 %}"), prose(r"$\input{c}$"))
    50 \% of $a_b$, not \{c \emph{50 \%} \$\textbackslash{}input\{c\}\$
    """
    return "".join(map(inline, words(text)))


# -- within a line --------------------------------------------------------------------


@singledispatch
def inline(node: Node) -> str:
    """LaTeX of what stands within a line."""
    return "".join(map(inline, node.children))


@inline.register
def _(node: nodes.Text) -> str:
    return literally(str(node))


@inline.register
def _(node: nodes.math) -> str:
    tex = node.astext().replace(r"\br ", "")
    return f"${running(tex)}$"


@inline.register
def _(node: nodes.literal) -> str:
    """A line may break after each hyphen of a name, and in a table after each sign of a formula."""
    at = r"[-+*/ ,=()_]" if "table" in node["classes"] else "-"
    shown = re.sub(at, r"\g<0>\\allowbreak{}", literally(node.astext()))
    return rf"\texttt{{{shown}}}"


@inline.register
def _(node: nodes.strong) -> str:
    return rf"\textbf{{{_inner(node)}}}"


@inline.register
def _(node: nodes.emphasis) -> str:
    return rf"\emph{{{_inner(node)}}}"


@inline.register
def _(node: nodes.inline) -> str:
    kinds = [name.removeprefix("kind-") for name in node["classes"] if name.startswith("kind-")]
    return rf"\kind{{{kinds[0]}}}{{{_inner(node)}}}" if kinds else _inner(node)


@inline.register
def _(node: Link) -> str:
    to, at = node["to"], node["at"]
    match to:
        case "theorem":
            number = f"\\theoremlink{{{at}}}"
            return _inner(node).replace(f"({at})", number)
        case "rule":
            return f"\\byrule{{{place_of(to, at)}}}{{{_inner(node)}}}"
        case "statement":
            return f"\\statementlink{{{place_of(to, at)}}}{{{referenced(reference(at))}}}"
        case "erratum" if node.astext() == at:
            return referenced(reference(at))
        case "row":
            return f"\\rowplace{{{at}}}"
        case "chapter":
            number, named = re.sub("[^0-9]", "", node.astext()), titles().get(at)
            return f"\\chapterlink{{{number}}}" + f"{{{prose(named) if named else literally(at)}}}"
    return _inner(node)


def _inner(node: Element) -> str:
    return "".join(map(inline, node.children))


def referenced(shown: str) -> str:
    """The number of an equation or table, or the id of another statement, to be broken.

    A column may hold thirteen letters; a longer word, "interconnection", breaks where it has to.
    """
    if shown.startswith(("(", "Table")):
        return literally(shown)
    split = (re.split(r"(?<=\b\w{5})(?=\w{9})", word) for word in re.split(r"(?<=[-:])", shown))
    breaking = "\\allowbreak ".join("\\penalty1000 ".join(map(literally, w)) for w in split)
    return f"\\texttt{{\\scriptsize {breaking}}}"


# -- blocks ---------------------------------------------------------------------------


def page(section: nodes.section, head: str, end: str = "") -> str:
    """The LaTeX of a page between its head and its end."""
    return "\n".join([head, "", *_blocks(section.children[1:]), end]).rstrip() + "\n"


def title(section: nodes.section) -> str:
    """The title of a page, without its number."""
    parts = section[0].children[1:] if "number" in section else section[0].children
    return "".join(map(inline, parts))


def _blocks(found: Iterable[Node]) -> list[str]:
    return [
        line
        for node in found
        if isinstance(node, Element) and node.get("only") != "site"
        for line in block(node)
    ]


@singledispatch
def block(node: Element) -> list[str]:
    """Lines of LaTeX of a block."""
    return _blocks(node.children)


@block.register
def _(node: nodes.paragraph) -> list[str]:
    return [*_placed(node), _inner(node), ""]


def _placed(node: Element) -> list[str]:
    """The place that a link leads to."""
    to, at = node.get("to"), node.get("at", "")
    return [rf"\{to}place{{{place_of(to, at)}}}"] if to in ("rule",) else []


@block.register
def _(node: nodes.rubric) -> list[str]:
    return [*_placed(node), f"\\step{{{as_sentence(_inner(node))}}}"]


@block.register
def _(node: nodes.math_block) -> list[str]:
    return [f"\\[{stack(node['rows'])}\\]", ""]


@block.register
def _(node: nodes.section) -> list[str]:
    forms = [one for one in node.children[1:] if _is(one, "statement")]
    if not forms:
        return [f"\\heading{{{title(node)}}}", *_blocks(node.children[1:])]
    rows = [row for form in forms for row in block(form)]
    if len(rows) > 3:  # neither the first row nor the last stands alone
        rows[0] += "\\together"
        rows[-2] = rows[-2].removesuffix("\\together") + "\\together"
    return [f"\\printedforms{{{title(node)}}}", *rows, "\\formsend", ""]


def _is(node: Node, kind: str) -> bool:
    return isinstance(node, nodes.container) and kind in node["classes"]


@block.register
def _(node: nodes.container) -> list[str]:
    return _CONTAINERS[node["classes"][0]](node)


def _step(node: nodes.container) -> list[str]:
    """A reason, then formulas, the last with its number and its verdict beside it.

    A theorem has below it what it rests on; one without a formula has its number in the text.
    """
    *before, verdict = node.children
    assert isinstance(verdict, Element)
    claimed = any(_is(child, "claim") for child in before)
    formulas = [child for child in before if _is(child, "formula")]
    tag = _tag(verdict, claimed)
    out: list[str] = []
    for child in before:
        if child in formulas:
            out += _formula(child, tag if child is formulas[-1] else r"\notag")
        elif isinstance(child, nodes.paragraph):
            out += [inline(child)]
    if claimed:
        out += [] if formulas else [f"\\formal{{{tag}}}"]
        found = [inline(child) for child in before if _is(child, "numbers")]
        out += [f"\\numbers{{{' '.join([as_sentence(_method(verdict)), *found])}}}"]
    return [*out, ""]


def _method(verdict: Element) -> str:
    """How a step is proved."""
    return "".join(map(_beside, verdict.children[1:]))


def _beside(node: Element) -> str:
    """What shows something, for the margin; in a long list elementary facts are only counted."""
    shown = "".join(
        f"${in_margin(one.astext())}$" if isinstance(one, nodes.math) else inline(one)
        for one in node.children
    )
    links = list(node.findall(Link))
    facts = [one for one in links if one["at"] in AXIOMS]
    if letters(shown) <= BESIDE or len(facts) < 2:
        return shown
    named = [inline(one) for one in links if one not in facts]
    return f"{shown[: shown.index('by ')]}by {', '.join([*named, f'{len(facts)} axioms'])}"


def _tag(verdict: Element, claimed: bool) -> str:
    """The number of a step and its verdict; of a theorem, what it rests on stands elsewhere."""
    beside = f"\\quad paper ({literally(verdict['paper'])})" if verdict["paper"] else ""
    kind, number = verdict["verdict"], verdict["number"]
    how = "" if claimed else _method(verdict)
    place = f"\\theoremplace{{{number}}}\\theoremrow{{{number}}}" if claimed else f"({number})"
    return f"{place}\\verdict{{{kind}}}{{{kind}{beside}}}{{{how}}}"


def _formula(node: Element, tag: str) -> list[str]:
    rows = node[0]["rows"]
    tag = tag if tag == r"\notag" else f"\\tag*{{{tag}}}"
    body = [f"{row}\\notag\\\\" for row in rows[:-1]] + [f"{rows[-1]}{tag}"]
    if "boxed" in node["classes"]:
        inner = " \\\\ ".join(rows)
        inner = rf"\begin{{aligned}}{inner}\end{{aligned}}" if rows[1:] else inner.replace("&", "")
        body = [f"\\boxed{{\\;{inner}\\;}}{tag}"]
    return ["\\begin{align*}", *body, "\\end{align*}"]


def letters(ground: str) -> int:
    r"""How many letters are set, of links only what is shown.

    >>> letters(r"a theorem by \byrule{held-answer}{motion}, \byrule{units}{units}")
    26
    """
    return len(re.sub(r"\\byrule\{[^{}]*\}|\\[a-z]+|[{}]", "", ground))


def _answer(node: nodes.container) -> list[str]:
    rows = []
    for item in node.findall(nodes.list_item):
        first, *rest = item[0].children
        said = "".join(map(inline, rest)).lstrip()
        rows.append(f"\\answer{{{inline(first)}}}{{{said}}}")
    return ["\\answers", *rows, "\\answersend", ""]


def _statement(node: nodes.container) -> list[str]:
    """A statement: reference, words and formulas, and its verdict with its grounds beside."""
    *body, verdict = (one for one in node.children if isinstance(one, Element))
    id = node["id"]
    to = "place" if node["to"] == "statement" else "link"
    place = referenced(reference(id))
    place = f"\\statement{to}{{{place_of('statement', id)}}}" + (
        place if to == "place" else f"{{{place}}}"
    )
    lines = [_within(one) for one in body if one.get("only") != "site"]
    beside = [one for one in verdict.children if one.get("only") != "site"]
    grounds = [as_sentence(_beside(one)) for one in beside if "ground" in one["classes"]]
    said, *shows = (inline(one) for one in beside if "ground" not in one["classes"])
    if sum(map(letters, shows)) <= BESIDE:
        said = ": ".join([said, *shows])
    else:
        lines.append("".join(map(as_sentence, shows)))
    below = f"\\below{{{' '.join(grounds)}}}" if grounds else ""
    return [f"\\form{{{place}}}{{" + "\\\\[2pt]".join(lines) + f"}}{{{said}}}{below}"]


def _within(node: Element) -> str:
    """A block of a statement within its column."""
    if isinstance(node, nodes.math_block):
        return stack(node["rows"])
    small = {"domain", "reading"} & set(node["classes"])
    return f"{{\\footnotesize {inline(node)}}}" if small else inline(node)


@block.register
def _(node: nodes.table) -> list[str]:
    """A table as wide as text and margin; no page parts its last three rows."""
    head, *rows = _rows(node)
    rows = [f"{row} \\\\{'*' * (2 <= len(rows) - at <= 3)}" for at, row in enumerate(rows)]
    begin = f"\\begin{{longtable}}{{@{{}}{node['columns']}@{{}}}}\\toprule {head} \\\\ \\midrule"
    return [f"\\wide{{{begin}\\endhead\\bottomrule\\endfoot", *rows, "\\end{longtable}}", ""]


def _rows(table: nodes.Element) -> list[str]:
    """The cells of each row; TeX would read a star or a bracket at its start as an argument."""
    found = []
    for row in table.findall(nodes.row):
        cells = ["".join(map(inline, entry.children)) for entry in row.children]
        found.append(" & ".join("{}" * c.startswith(("*", "[")) + c for c in cells))
    return found


def _tabled(node: nodes.container) -> list[str]:
    """A table of numbers with its caption, in the middle of the page."""
    table, caption = node.children
    head, *rows = (f"{row} \\\\" for row in _rows(table))
    columns = head.count(" & ") + 1
    return [
        "\\begin{center}",
        f"\\begin{{tabular}}{{@{{}}*{{{columns}}}{{r}}@{{}}}}\\toprule",
        *(head, "\\midrule", *rows),
        r"\bottomrule\end{tabular}\\*[4pt]"
        rf"{{\footnotesize\interlinepenalty=10000 {inline(caption)}\par}}",
        "\\end{center}",
        "",
    ]


@block.register
def _(node: nodes.figure) -> list[str]:
    return [
        "\\begin{figure}[htbp]\\centering",
        f"\\includegraphics{{figures/{node['name']}.pdf}}",
        f"\\caption*{{\\footnotesize {inline(node[1])}}}",
        "\\end{figure}",
        "",
    ]


_CONTAINERS = {"step": _step, "statement": _statement, "answer": _answer, "tabled": _tabled}
