"""Words and formulas for reStructuredText."""

from __future__ import annotations

import re
from collections.abc import Iterable

from symhaptic.book.parts import numbers
from symhaptic.book.tex.breaking import width
from symhaptic.book.tex.words import scanned
from symhaptic.notation.latex import euler

_SPACES = {r"\,": "\u202f", "~": "\xa0"}
"""What prose writes for TeX, and what it means."""

_LEFT_OUT = (r"\allowbreak ", r"\allowbreak", r"\br ")


def formula(tex: str) -> str:
    r"""LaTeX as MathML's maker reads it: places to break a line left out, changes underlined.

    >>> formula(r"a,\allowbreak b\changed{c}")
    'a,b\\underline{c}'
    """
    for mark in _LEFT_OUT:
        tex = tex.replace(mark, "")
    tex = " ".join(tex.replace(r"\changed{", r"\underline{").split())
    return re.sub(r"(?<!\\)((?:\\\\)*)\\$", r"\1", tex).rstrip()  # of a space at the end


def math(tex: str) -> str:
    """A formula in a line of text; one that is long may be broken."""
    parts = map(formula, _narrow(formula(tex)))
    return _BREAK.join(f":math:`{part}`" for part in parts if part)


def breakable(tex: str) -> str:
    r"""A long formula in a line of text, as several between which the line may break.

    >>> breakable(r"\forall\,x\ \text{with a\ b}\ x<1")
    ':math:`\\forall\\,x` :math:`\\text{with a\\ b}` :math:`x<1`'
    """
    parts, depth = [""], 0
    for token in re.findall(r"\\.|[^\\]", tex, re.DOTALL):
        depth += (token == "{") - (token == "}")
        if token == "\\ " and depth == 0:
            parts.append("")
        else:
            parts[-1] += token
    return " ".join(math(part) for part in parts if part.strip())


_NARROW = 16.0
"""Em, which a line of a narrow screen has."""

_BREAK = "\\ \u200b\\ "
"""Nothing, behind which a line may end."""

_OPEN = {"(", "=", "<", ">", "+", "-", "/", ",", r"\le", r"\ge", r"\ne", r"\cdot", r"\in", r"\,"}
"""Behind these a sign belongs to what follows."""


def _narrow(tex: str) -> list[str]:
    r"""A formula in pieces that fit, parted before a sign or a relation and behind a comma.

    What stands between braces, or at the foot or the head of something, is not parted.

    >>> _narrow("a+b")
    ['a+b']
    >>> _narrow("=".join("abc"[i] * 20 for i in range(3)))
    ['aaaaaaaaaaaaaaaaaaaa', '{}=bbbbbbbbbbbbbbbbbbbb', '{}=cccccccccccccccccccc']
    """
    if width(tex) <= _NARROW:
        return [tex]
    atoms, depth, before = [""], 0, "("
    for token in re.findall(r"\\[A-Za-z]+|\\.|\s+|[^\\]", tex, re.DOTALL):
        sign = token in ("+", "-") and before not in _OPEN
        if depth == 0 and (sign or (token in _RELATIONS and before not in ("^", "_"))):
            atoms.append("{}" if atoms[-1] else "")
        atoms[-1] += token
        depth += (token in _BEGIN) - (token in _END)
        if depth == 0 and token == ",":
            atoms.append("")
        before = token if token.strip() else before
    return _packed(atoms)


_RELATIONS = {"=", "<", ">", r"\le", r"\ge", r"\ne"}
_BEGIN, _END = {"{", r"\left"}, {"}", r"\right"}


def _packed(atoms: Iterable[str]) -> list[str]:
    """As many atoms to a piece as there is room for."""
    pieces: list[str] = []
    for atom in filter(None, atoms):
        joined = pieces[-1] + atom.removeprefix("{}") if pieces else ""
        if pieces and width(joined) <= _NARROW:
            pieces[-1] = joined
        else:
            pieces.append(atom)
    return pieces


def plain(text: str) -> str:
    r"""Text that stands for itself: no sign in it is markup, wherever it begins.

    >>> plain("a 5% |loss| of `x`_"), plain("- 5 N/m"), plain(".. raw:: html")
    ('a 5% \\|loss\\| of \\`x\\`\\_', '\\ - 5 N/m', '\\ .. raw\\:\\: html')
    """
    return _begun(_escaped(text).strip())


def _escaped(text: str) -> str:
    """A text whose signs mean nothing within a line."""
    return re.sub(r"([\\*`|_:@])", r"\\\1", re.sub(r"\s+", " ", text))


_LIST = re.compile(r"\(?(?:\w|\d+|[ivxlcdm]+|[IVXLCDM]+)[.)](?:\s|$)")
"""The beginning of an item of a numbered list."""


def _begun(text: str) -> str:
    """A line that begins with nothing, where reStructuredText would take its beginning for more."""
    marked = re.match(r"[^\w\s]", text) and not text.startswith((":math:`", "``"))
    return f"\\ {text}" if marked or _LIST.match(text) else text


def words(text: str) -> str:
    r"""Prose with formulas between dollar signs, in one line; emphasis is left out.

    reStructuredText cannot have emphasis around a formula.

    >>> words("the angle $\\theta$ twice")
    'the angle :math:`\\theta` twice'
    >>> words("(b) is no item of a list"), words(r"by \texttt{is\_stable}: 5\,\%")
    ('\\ (b) is no item of a list', 'by ``is_stable``\\ \\: 5\u202f%')
    >>> words(r"\emph{all $c_n$ and \emph{b}} of $\input{x}$")
    'all :math:`c_n` and b of $\\\\input{x}$'
    """
    out, marked = "", False
    for kind, part in scanned(text):
        shown = _shown(kind, part)
        markup = kind in ("formula", "code") and shown[:1] in (":", "`")
        parted = out[-1:].strip() and shown[:1].strip() and (marked or markup)
        out += "\\ " * bool(parted) + shown
        marked = (markup or marked) if not shown else markup
    return _begun(out.strip())


def _shown(kind: str, part: str) -> str:
    """A part of a text as reStructuredText."""
    match kind:
        case "formula":
            return math(euler(part))
        case "chapter":
            return f"chapter {numbers()[part]}"
        case "code" if re.fullmatch(r"[^\s`](?:[^`\n]*[^\s`])?", part):
            return f"``{part}``"
        case "space":
            return _SPACES[part]
        case "emphasis" | "end":
            return ""
    return _escaped(part)


def display(rows: Iterable[str]) -> list[str]:
    """Lines of a formula that stands by itself, one below the other."""
    lines = [formula(part) for row in rows for part in _folded(row)]
    body = lines[0].replace("&", "") if len(lines) == 1 else _aligned(lines)
    return [".. math::", "", f"   {body}", ""]


_WIDE = 30.0
"""Em, beyond which a line is folded where the print may be."""


def _folded(row: str) -> list[str]:
    r"""A line at the places where print may break it, outside of braces, if it is long.

    Brackets that grow cannot be parted, so they are of one size then.

    >>> _folded(r"&b > \left( K \br + B \right)")
    ['&b > \\left( K \\br + B \\right)']
    """
    if r"\br" not in row or width(row) < _WIDE:
        return [row]
    parts, depth = [""], 0
    for token in re.findall(r"\\br\b|\\.|[^\\]", row, re.DOTALL):
        depth += (token == "{") - (token == "}")
        if token == r"\br" and depth == 0:
            parts.append(r"&\quad ")
        else:
            parts[-1] += token
    even = all(part.count(r"\left") == part.count(r"\right") for part in parts)
    if even:
        return parts
    sized = (re.sub(r"\\left(?=[(\[])", r"\\bigl", part) for part in parts)
    return [re.sub(r"\\right(?=[)\]])", r"\\bigr", part) for part in sized]


def _aligned(lines: list[str]) -> str:
    return r"\begin{aligned}" + r" \\ ".join(lines) + r"\end{aligned}"


def indented(lines: Iterable[str], by: int = 3) -> list[str]:
    """Lines as the content of a directive."""
    return [" " * by + line if line else "" for text in lines for line in text.split("\n")]


def container(kind: str, lines: Iterable[str]) -> list[str]:
    """Lines that belong together, of a kind that the style sheet knows."""
    return [f".. container:: {kind}", "", *indented(lines), ""]


def heading(title: str, mark: str = "=") -> list[str]:
    """A title with the line below it that makes it one."""
    return [title, mark * max(2 * len(title), 4), ""]  # some signs are two columns wide


def table(kind: str, rows: Iterable[Iterable[str]], widths: str = "auto") -> list[str]:
    """Rows of cells, the head first."""
    out = [
        ".. list-table::",
        f"   :class: {kind}",
        f"   :widths: {widths}",
        "   :header-rows: 1",
        "",
    ]
    for row in rows:
        for at, cell in enumerate(row):
            first, *rest = cell.split("\n")
            out.append(f"   {'*' if at == 0 else ' '} - {first}")
            out += [f"       {line}" for line in rest]
    return [*out, ""]
