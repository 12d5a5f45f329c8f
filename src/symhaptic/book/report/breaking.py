r"""Breaks long formulas, for print and for narrow screens: before a sign, outermost first.

Widths are estimates in em, good to a few per cent; whether a line really fits is for TeX to
say, and the build fails where it does not.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy import Expr

from symhaptic.notation.latex import euler, latex
from symhaptic.notation.term_order import factors, ordered_terms

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[{}^_]|\d|[A-Za-z]|[^\s]")
_COMMANDS = {
    r"\quad": 1.0,
    r"\qquad": 2.0,
    r"\,": 0.17,
    r"\;": 0.28,
    r"\!": -0.17,
    r"\sin": 1.4,
    r"\cos": 1.4,
    r"\tan": 1.5,
    r"\cot": 1.4,
    r"\sinh": 2.0,
    r"\cosh": 2.0,
    r"\lim": 1.6,
    r"\left": 0.1,
    r"\right": 0.1,
    r"\displaystyle": 0.0,
    r"\changed": 0.0,
    r"\br": 0.0,
    r"\mathrel": 0.0,
    r"\bigl": 0.08,
    r"\bigr": 0.08,
    r"\Bigl": 0.2,
    r"\Bigr": 0.2,
    r"\mathrm": 0.0,
    r"\text": 0.0,
    r"\hat": 0.0,
    r"\partial": 0.55,
    r"\cdot": 0.7,
    r"\in": 1.2,
    r"\to": 1.5,
    r"\infty": 1.0,
    r"\max": 1.6,
    r"\mathbb": 0.1,
}
_RELATIONS = {"=", "<", ">", r"\le", r"\ge", r"\leq", r"\geq", r"\ne"}


def width(text: str) -> float:
    r"""Estimated width in em of a line of LaTeX in display style.

    >>> 1.5 < width(r"\frac{KT}{2}") < 2.5
    True
    """
    tokens = _TOKEN.findall(re.sub(r"\\hat\{=\}", "=", text))
    total, _ = _measure(tokens, 0)
    return total


def _group(tokens: list[str], at: int) -> tuple[float, int]:
    if at < len(tokens) and tokens[at] == "{":
        return _measure(tokens, at + 1)
    return (_measure(tokens[at : at + 1], 0)[0], at + 1)


def _measure(tokens: list[str], at: int) -> tuple[float, int]:
    total = widest = 0.0
    while at < len(tokens):
        token = tokens[at]
        at += 1
        if token == "}":
            return max(total, widest), at
        if token == "{":
            inner, at = _measure(tokens, at)
            total += inner
        elif token in (r"\frac", r"\tfrac", r"\dfrac"):
            top, at = _group(tokens, at)
            bottom, at = _group(tokens, at)
            total += max(top, bottom) * (0.72 if token == r"\tfrac" else 1.0) + 0.24
        elif token == r"\sqrt":
            inner, at = _group(tokens, at)
            total += inner + 0.9
        elif token in "^_":
            inner, at = _group(tokens, at)
            total += 0.72 * inner + 0.05
        elif token in (r"\begin", r"\end"):
            _, at = _group(tokens, at)
            total += 0.5
        elif token == r"\\":
            widest, total = max(widest, total), 0.0
        elif token in _RELATIONS:
            total += 1.35
        elif token in "+-":
            total += 1.22
        elif token in _COMMANDS:
            total += _COMMANDS[token]
        elif token.startswith("\\"):
            total += 0.6
        elif token in "()[],.|":
            total += 0.4
        elif token in "mMNwTKB":
            total += 0.78
        else:
            total += 0.52
    return max(total, widest), at


def pieces(expr: Expr, limit: float) -> list[str]:
    """An expression as LaTeX in as many pieces as it takes to stay within ``limit`` em."""
    whole = latex(expr)
    if width(whole) <= limit:
        return [whole]
    if expr.is_Add:
        return _packed([pieces(term, limit - 1) for term in ordered_terms(expr)], limit)
    if expr.is_Mul:
        return _product(expr, limit) or [whole]
    return [whole]


def _packed(terms: list[list[str]], limit: float) -> list[str]:
    lines = [""]
    for parts in terms:
        for i, part in enumerate(parts):
            signed = part if part.startswith("-") or i or lines == [""] else f"+{part}"
            if (lines[-1] and width(lines[-1] + signed) > limit) or i:
                lines.append(signed)
            else:
                lines[-1] += signed
    return lines


def _product(expr: Expr, limit: float) -> list[str] | None:
    """Breaks inside the widest sum among the factors, with the others written before it."""
    negative, top, bottom = factors(expr)
    sums = [f for f in top if f.is_Add]
    if not sums:
        return None
    if bottom and width(latex(sp.Mul(*bottom))) > limit / 3:
        above = pieces(sp.Mul(*top), limit - 1)
        stack = r" \\ ".join(above)
        sign = "-" if negative else ""
        return [
            rf"{sign}\frac{{\begin{{gathered}}{stack}\end{{gathered}}}}{{{latex(sp.Mul(*bottom))}}}"
        ]
    longest = max(sums, key=lambda f: width(latex(f)))
    rest = [f for f in top if f is not longest]
    front = ""
    if rest or bottom:
        before = sp.Mul(*rest, *(1 / f for f in bottom), evaluate=False)
        front = latex(before)
        if before.is_Add:  # a sum keeps its brackets
            front = rf"\left({front}\right)" if r"\frac" in front else f"({front})"
    if bottom and not rest:
        front = latex(1 / sp.Mul(*bottom))
    room = limit - width(front) - 1.5
    if room < 6:
        return None
    inner = pieces(longest, room)
    inner[0] = rf"{'-' if negative else ''}{front}\Bigl({inner[0]}"
    inner[-1] = rf"{inner[-1]}\Bigr)"
    return inner


def parted(tex: str, at: str, brackets: str = "{}") -> list[str]:
    r"""LaTeX split where the pattern ``at`` matches outside of brackets.

    >>> parted(r"a\ \text{b\ c}\ d", r"\\ ")
    ['a', '\\text{b\\ c}', 'd']
    """
    parts, depth, done = [], 0, 0
    for token in re.finditer(rf"(?P<at>{at})|\\.|[{re.escape(brackets)}]", tex, re.DOTALL):
        if token["at"] is None and len(token[0]) == 1:
            depth += 1 if brackets.index(token[0]) % 2 == 0 else -1
        elif token["at"] is not None and depth == 0:
            parts.append(tex[done : token.start()])
            done = token.end()
    return [*parts, tex[done:]]


# -- in print -------------------------------------------------------------------------

LINE = 29.0
"""Width of an equation in em, the number on its right taken off."""

FORM = 29.5
"""Width of the column of published forms, in em of its own size."""


def rows_of(lines: Iterable[tuple[Any, str, Any]]) -> list[str]:
    """Lines of an equation, aligned at their sign, broken where they are too long for one."""
    rows: list[str] = []
    for left, sign, right in lines:
        shown = euler(left) if isinstance(left, str) else latex(left)
        start, own_line = shown, width(shown) > LINE / 2.5
        right_shown = euler(right) if isinstance(right, str) else latex(right)
        if isinstance(left, Expr) and width(shown) > LINE:
            parts = pieces(left, LINE)
            rows += [f"&{parts[0]}", *(f"&\\quad {p}" for p in parts[1:])]
            start = ""
        elif own_line and width(shown) + width(right_shown) > LINE:
            rows.append(f"&{shown}")
            start = ""
        room = LINE - width(start) - 1.5
        parts = broken(right_shown) if isinstance(right, str) else pieces(right, room)
        lead = f"{start} &{sign} " if start else f"&\\quad{sign} " if own_line else f"&{sign} "
        rows.append(f"{lead}{parts[0]}")
        rows += [f"&\\qquad {p}" for p in parts[1:]]
    return rows


def broken(printed: str) -> list[str]:
    r"""A published formula split at its ``\br`` markers; those inside a fraction stack there."""
    if r"\br " in printed:  # a bracket may open on one line and close on the next
        printed = printed.replace(r"\left", r"\bigl").replace(r"\right", r"\bigr")
    return [_stacked(part) for part in parted(printed, r"\\br ")]


def _stacked(text: str) -> str:
    """Line breaks inside a group become a stack of centred lines."""
    while r"\br " in text:
        at = text.index(r"\br ")
        begin, end = _brace(text, at, -1), _brace(text, at, 1)
        inner = text[begin + 1 : end].replace(r"\br ", r"\\ ")
        text = f"{text[: begin + 1]}\\begin{{gathered}}{inner}\\end{{gathered}}{text[end:]}"
    return text


def _brace(text: str, at: int, way: int) -> int:
    """The place of the brace that opens or closes the group around a place."""
    depth = 0
    while depth <= 0:
        at += way
        depth += way * ((text[at] == "}") - (text[at] == "{"))
    return at


def stack(formulas: Iterable[str]) -> str:
    """Formulas line by line, aligned at the left, in the largest size that fits the column."""
    lines = [_upright(line) for formula in formulas for line in broken(formula)]
    widest = max(map(width, lines))
    size = "" if widest <= FORM else "\\footnotesize" if widest <= 1.12 * FORM else "\\scriptsize"
    rows = " \\\\[3pt] ".join(
        f"&\\quad {line}" if at and line.lstrip().startswith(("+", "-", r"\left(")) else f"&{line}"
        for at, line in enumerate(lines)
    )
    return f"{{{size}$\\displaystyle\\begin{{aligned}}[t]{rows}\\end{{aligned}}$}}"


def _upright(line: str) -> str:
    """Fractions in a column vector at full size, those inside them small; a proper relation."""
    line = line.replace(r"\hat{=}", r"\mathrel{\hat{=}}")
    if "pmatrix" not in line:
        return line
    out, depth = "", 0
    for token in re.findall(r"\\[A-Za-z]+|\\.|.", line):
        depth += (token == "{") - (token == "}")
        out += {r"\frac": r"\dfrac" if depth == 0 else r"\tfrac", r"\\": r"\\[10pt]"}.get(
            token, token
        )
    return out


_WORD = 10.0
"""Em, as wide as a long word: below this a formula is not broken within a line."""


def running(tex: str) -> str:
    """A long formula as running text: it may break after a comma and before an arrow."""
    if width(tex) < _WORD:
        return tex
    tex = re.sub(r",(?=\w|\\[a-z])", r",\\allowbreak ", tex)
    tex = tex.replace(r",\ ", r",\allowbreak\ ").replace(r":\ ", r":\allowbreak\ ")
    return tex.replace(r"\ \Rightarrow\ ", r"\allowbreak\ \Rightarrow\ ")


def in_margin(tex: str) -> str:
    """A formula in the margin: of a list of a field's generators the widest are left out."""
    field = re.fullmatch(r"\\mathbb\{Q\}\((.*)\)", tex)
    if field is None:
        return running(tex)
    shown = [g if width(g) < 9 else r"\ldots" for g in parted(field[1], ",", "{}()")]
    kept = [g for at, g in enumerate(shown) if g != r"\ldots" or r"\ldots" not in shown[:at]]
    return r"\mathbb{Q}(" + r",\allowbreak ".join(kept) + ")"


# -- on a screen ----------------------------------------------------------------------

_NARROW = 16.0
"""Em, which a line of a narrow screen has."""

_WIDE = 30.0
"""Em, beyond which a line is folded where the print may be."""

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


def narrow(tex: str) -> list[list[str]]:
    r"""A formula as words of pieces: a line may break between any two, words have a space between.

    A long one is parted at its spaces, before a sign or a relation and behind a comma.  What stands
    between braces, or at the foot or the head of something, is not parted.

    >>> narrow("a+b")
    [['a+b']]
    >>> narrow(r"\forall x\ \text{with a\ b}\ " + "=".join("abc"[i] * 20 for i in range(2)))
    [['\\forall x'], ['\\text{with a\\ b}'], ['aaaaaaaaaaaaaaaaaaaa', '{}=bbbbbbbbbbbbbbbbbbbb']]
    """
    tex = formula(tex)
    if width(tex) <= _NARROW:
        return [[tex]] if tex else []
    found = (_pieces(formula(part)) for part in parted(tex, r"\\ ") if part.strip())
    return [[piece for piece in map(formula, one) if piece] for one in found]


_OPEN = {"(", "=", "<", ">", "+", "-", "/", ",", r"\le", r"\ge", r"\ne", r"\cdot", r"\in", r"\,"}
"""Behind these a sign belongs to what follows."""

_PARTING = {"=", "<", ">", r"\le", r"\ge", r"\ne"}


def _pieces(tex: str) -> list[str]:
    """A formula in pieces that fit a narrow screen."""
    if width(tex) <= _NARROW:
        return [tex]
    atoms, depth, before = [""], 0, "("
    for token in re.findall(r"\\[A-Za-z]+|\\.|\s+|[^\\]", tex, re.DOTALL):
        sign = token in ("+", "-") and before not in _OPEN
        if depth == 0 and (sign or (token in _PARTING and before not in ("^", "_"))):
            atoms.append("{}" if atoms[-1] else "")
        atoms[-1] += token
        depth += (token in ("{", r"\left")) - (token in ("}", r"\right"))
        if depth == 0 and token == ",":
            atoms.append("")
        before = token if token.strip() else before
    found: list[str] = []
    for atom in filter(None, atoms):  # as many to a piece as there is room for
        joined = found[-1] + atom.removeprefix("{}") if found else ""
        if found and width(joined) <= _NARROW:
            found[-1] = joined
        else:
            found.append(atom)
    return found


def displayed(rows: Sequence[str], aligned: bool) -> str:
    """Lines of a formula that stands by itself; with ``&`` where they are already aligned."""
    if not aligned:
        rows = [f"&{row}" for row in rows]
    lines = [formula(part) for row in rows for part in _folded(row)]
    if len(lines) == 1:
        return lines[0].replace("&", "", 1)
    return r"\begin{aligned}" + r" \\ ".join(lines) + r"\end{aligned}"


def _folded(row: str) -> list[str]:
    r"""A line at the places where print may break it, outside of braces, if it is long.

    Brackets that grow cannot be parted, so they are of one size then.

    >>> _folded(r"&b > \left( K \br + B \right)")
    ['&b > \\left( K \\br + B \\right)']
    """
    if r"\br" not in row or width(row) < _WIDE:
        return [row]
    first, *rest = parted(row, r"\\br\b")
    parts = [first, *(rf"&\quad {part}" for part in rest)]
    if all(part.count(r"\left") == part.count(r"\right") for part in parts):
        return parts
    sized = (re.sub(r"\\left(?=[(\[])", r"\\bigl", part) for part in parts)
    return [re.sub(r"\\right(?=[)\]])", r"\\bigr", part) for part in sized]
