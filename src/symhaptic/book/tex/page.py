"""One chapter as LaTeX: prose, steps with their proofs in the margin, printed forms beside."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Expr

from symhaptic.book.chapters import Chapter
from symhaptic.book.evidence import evidence
from symhaptic.book.foreign import NOT, checked
from symhaptic.book.record import Block, Record, Settled
from symhaptic.book.rests import Said, Shown, rests, shown_in
from symhaptic.book.rules import called
from symhaptic.book.tex.breaking import broken, pieces, width
from symhaptic.book.tex.forms import BESIDE, LONG_CLAIM, answers, letters, printed_forms, sentence
from symhaptic.book.tex.words import anchor, as_sentence, literally, paragraphs, prose
from symhaptic.notation.latex import euler, latex
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.verdict import Kind

LINE = 29.0
"""Width of an equation in em, the number on its right taken off."""


def chapter_tex(chapter: Chapter, number: int) -> str:
    """The chapter's LaTeX, to be included by the book or by any document with `symhaptic.sty`."""
    title = prose(chapter.title)
    out = [
        f"\\begin{{symhapticchapter}}{{{number}}}{{{literally(chapter.source)}}}{{{title}}}",
        "",
        "\n\n".join(paragraphs(chapter.introduction)),
        "",
    ]
    shown = shown_in([(number, chapter)])
    out += _answer(chapter.page, number, shown)
    steps = 0
    for block in chapter.page.blocks:
        if block.kind == "prose":
            out += ["\n\n".join(paragraphs(block.text)), ""]
        elif block.kind == "equation":
            steps += 1
            out += _equation(block, number, steps)
        elif block.kind == "theorem":
            steps += 1
            out += _theorem(block, number, steps, shown)
        elif block.kind == "table":
            out += _table(block)
        elif block.kind == "figure":
            out += _figure(block)
    if chapter.page.settled:
        settled = list(chapter.page.settled.values())
        out += printed_forms(settled, [_grounds(item, shown) for item in settled])
    return "\n".join([*out, "\\end{symhapticchapter}"]) + "\n"


# -- equations ------------------------------------------------------------------------


def _equation(block: Block, chapter: int, step: int) -> list[str]:
    heading = f"Step {step}"
    reason = as_sentence(prose(block.text)) if block.text else ""
    rows = rows_of(block.lines)
    beside = f"\\quad paper ({literally(block.paper)})" if block.paper else ""
    tag = (
        f"\\tag*{{({chapter}.{block.number})"
        f"\\verdict{{{block.verdict}}}{{{block.verdict}{beside}}}{{{_breakable(block.method)}}}}}"
    )
    if block.boxed:
        inner = (
            rows[0].replace("&", "")
            if len(rows) == 1
            else ("\\begin{aligned}" + " \\\\ ".join(rows) + "\\end{aligned}")
        )
        body = [f"\\boxed{{\\;{inner}\\;}}{tag}"]
    else:
        body = [f"{row}\\notag\\\\" for row in rows[:-1]] + [f"{rows[-1]}{tag}"]
    return [
        f"\\step{{{heading}. {prose(block.title)}.}}{{{reason}}}",
        "\\begin{align*}",
        *body,
        "\\end{align*}",
        "",
    ]


def _answer(page: Record, chapter: int, shown: Mapping[Said, Shown]) -> list[str]:
    """What the chapter finds, before the steps that lead to it.

    That is the theorem that its author has boxed, or else the statements that it settles, in words.
    """
    boxed = [block for block in page.blocks if block.kind == "theorem" and block.boxed]
    if not boxed:
        found = [s for s in page.settled.values() if s.verdict.kind is not Kind.DEFINITION]
        return [answers(found), ""] if found else []
    return [
        line
        for block in boxed
        for line in (
            f"\\step{{Theorem.}}{{{as_sentence(prose(block.title))}}}",
            _claimed("boxedclaim", block, chapter, shown),
            "",
        )
    ]


def _theorem(block: Block, chapter: int, step: int, shown: Mapping[Said, Shown]) -> list[str]:
    """Hypotheses and conclusion as a sentence, whose formulas break where TeX finds it best.

    Of the chapter's theorem, which stands at its head, only the reason is left to say.
    """
    reason = as_sentence(prose(block.text)) if block.text else ""
    heading = f"Step {step}. {prose(block.title)}."
    if block.boxed:
        number = f"\\theoremlink{{{chapter}.{block.number}}}"
        return [f"\\step{{{heading}}}{{{reason} This is the theorem {number}.}}", ""]
    return [f"\\step{{{heading}}}{{{reason}}}", _claimed("claim", block, chapter, shown), ""]


def _claimed(kind: str, block: Block, chapter: int, shown: Mapping[Said, Shown]) -> str:
    """A theorem, what it is, and beside it what it rests on."""
    given, then = block.said
    place = f"{chapter}.{block.number}"
    number = f"\\theoremplace{{{place}}}\\theoremrow{{{place}}}"
    method = prose(block.method)
    if block.theorem is not None:
        method = _by(method, [block.theorem], shown)
    kind = "longclaim" if sum(map(width, (*given, then))) > LONG_CLAIM else kind
    long = letters(method) > BESIDE
    beside = "" if long else method
    claim = f"\\{kind}{{{sentence(given, then)}}}{{{number}}}{{{block.verdict}}}{{{beside}}}"
    numbers = evidence(block.theorem, shown) if block.theorem is not None else ""
    below = [as_sentence(method)] if long else []
    below += [as_sentence(prose(numbers))] if numbers else []
    return "\n".join([claim, *(f"\\numbers{{{text}}}" for text in below)])


def _foreign(item: Settled) -> str:
    """How far Rocq has checked a statement, and what it says that this rests on."""
    found = checked(item.statement.id, item.settlement.judged)
    if found.extent == NOT:
        return ""
    rules = [f"\\byrule{{{anchor(rule)}}}{{{prose(called(rule))}}}" for rule in found.rules]
    by = ", ".join([*rules, *map(prose, found.others)])
    return f"Rocq: {found.in_short}{', by ' if by else ''}{by}"


def _by(lead: str, theorems: Sequence[Theorem], shown: Mapping[Said, Shown]) -> str:
    """What theorems rest on: others of the page by number, classical rules by name."""
    found = rests(theorems, shown)
    places = [f"\\theoremlink{{{one.place}}}" for one in found.shown]
    names = {called(rule): rule for rule in found.rules}
    rules = [f"\\byrule{{{anchor(rule)}}}{{{prose(name)}}}" for name, rule in names.items()]
    return f"{lead} by {', '.join([*places, *rules])}" if places or rules else lead


def _grounds(item: Settled, shown: Mapping[Said, Shown]) -> str:
    """What the verdict on a statement rests on."""
    judged = item.settlement.judged
    if judged is None:
        return ""
    told = [_by("a theorem", [judged.theorem], shown), _foreign(item)]
    return "\\\\".join(filter(None, told))


def _breakable(method: str) -> str:
    """Lets the list of a field's generators run over lines of the margin, the widest left out."""

    def shortened(found: re.Match[str]) -> str:
        shown = [g if width(g) < 9 else r"\ldots" for g in _split(found.group(1))]
        kept = [g for i, g in enumerate(shown) if g != r"\ldots" or r"\ldots" not in shown[:i]]
        return r"$\mathbb{Q}(" + r",\allowbreak ".join(kept) + ")$"

    return re.sub(r"\$\\mathbb\{Q\}\((.*?)\)\$", shortened, method)


def _split(text: str) -> list[str]:
    """Splits at commas outside braces and brackets."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "{(") - (c in ")}")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return parts


def rows_of(lines: tuple[tuple[str, str, Any], ...]) -> list[str]:
    """Lines of an equation, aligned at their sign, broken where they are too long for one."""
    rows: list[str] = []
    for left, sign, right in _upright(lines):
        shown = left if isinstance(left, str) else latex(left)
        start, own_line = shown, width(shown) > LINE / 2.5
        if isinstance(left, Expr) and width(shown) > LINE:
            parts = pieces(left, LINE)
            rows += [f"&{parts[0]}", *(f"&\\quad {p}" for p in parts[1:])]
            start = ""
        elif own_line and width(shown) + width(_text(right)) > LINE:
            rows.append(f"&{shown}")
            start = ""
        room = LINE - width(start) - 1.5
        parts = broken(right) if isinstance(right, str) else pieces(right, room)
        lead = f"{start} &{sign} " if start else f"&\\quad{sign} " if own_line else f"&{sign} "
        rows.append(f"{lead}{parts[0]}")
        rows += [f"&\\qquad {p}" for p in parts[1:]]
    return rows


def _upright(lines: tuple[tuple[str, str, Any], ...]) -> list[tuple[Any, str, Any]]:
    """The lines with Euler's number upright in what was typed."""
    typed = [[euler(s) if isinstance(s, str) else s for s in (a, b)] for a, _, b in lines]
    return [(left, line[1], right) for line, (left, right) in zip(lines, typed, strict=True)]


def _text(side: Any) -> str:
    return side if isinstance(side, str) else latex(side)


def _table(block: Block) -> list[str]:
    head, *rows = (" & ".join(_cell(cell) for cell in row) + r" \\" for row in block.rows)
    return [
        "\\begin{center}",
        f"\\begin{{tabular}}{{@{{}}*{{{len(block.rows[0])}}}{{r}}@{{}}}}\\toprule",
        head,
        "\\midrule",
        *rows,
        r"\bottomrule\end{tabular}\\*[4pt]"
        rf"{{\footnotesize\interlinepenalty=10000 {prose(block.text)}\par}}",
        "\\end{center}",
        "",
    ]


def _cell(cell: object) -> str:
    """A cell of a table; TeX would read a star or a bracket at its start as an argument."""
    text = prose(cell) if isinstance(cell, str) else f"${latex(cell)}$"
    return "{}" * text.startswith(("*", "[")) + text


def _figure(block: Block) -> list[str]:
    return [
        "\\begin{figure}[htbp]\\centering",
        f"\\includegraphics{{figures/{block.title}.pdf}}",
        f"\\caption*{{\\footnotesize {prose(block.text)}}}",
        "\\end{figure}",
        "",
    ]
