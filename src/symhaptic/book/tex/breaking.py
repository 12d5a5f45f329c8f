r"""Breaks a long formula at sensible places: before a sign, outermost first.

Widths are estimates in em, good to a few per cent; whether a line really fits is for TeX to
say, and the build fails where it does not.
"""

from __future__ import annotations

import re

import sympy as sp
from sympy import Expr

from symhaptic.notation.latex import latex
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


def broken(printed: str) -> list[str]:
    r"""A printed formula split at its ``\br`` markers; those inside a fraction stack there."""
    if r"\br " in printed:  # a bracket may open on one line and close on the next
        printed = printed.replace(r"\left", r"\bigl").replace(r"\right", r"\bigr")
    outer: list[str] = []
    depth, start = 0, 0
    for found in re.finditer(r"\\br |[{}]", printed):
        token = found.group()
        if token == "{":
            depth += 1
        elif token == "}":
            depth -= 1
        elif depth == 0:
            outer.append(printed[start : found.start()])
            start = found.end()
    outer.append(printed[start:])
    return [_stacked(part) for part in outer]


def _stacked(text: str) -> str:
    """Line breaks inside a group become a stack of centred lines."""
    while r"\br " in text:
        at = text.index(r"\br ")
        begin, depth = at, 0
        while True:
            begin -= 1
            depth += (text[begin] == "}") - (text[begin] == "{")
            if depth < 0:
                break
        end, depth = at, 0
        while True:
            depth += (text[end] == "{") - (text[end] == "}")
            if depth < 0:
                break
            end += 1
        inner = text[begin + 1 : end].replace(r"\br ", r"\\ ")
        text = f"{text[: begin + 1]}\\begin{{gathered}}{inner}\\end{{gathered}}{text[end:]}"
    return text
