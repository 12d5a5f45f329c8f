"""One chapter as LaTeX: prose, steps with their proofs in the margin, printed forms beside."""

from __future__ import annotations

import re
from typing import Any

from sympy import Expr

from symhaptic.chapter import Block, Settled
from symhaptic.latex import latex
from symhaptic.library import Chapter
from symhaptic.proof.verdict import Kind, Verdict
from symhaptic.report.breaking import broken, pieces, width

LINE = 29.0
"""Width of an equation in em, the number on its right taken off."""

FORM = 29.5
"""Width of the column of printed forms, in em of its own size."""


def chapter_tex(chapter: Chapter, number: int) -> str:
    """The chapter's LaTeX, to be included by the book."""
    title = prose(chapter.title)
    out = [
        f"\\chapterhead{{{number}}}{{{escaped(chapter.source)}}}{{{title}}}",
        "",
        prose(chapter.introduction),
        "",
    ]
    steps = 0
    for block in chapter.page.blocks:
        if block.kind == "prose":
            out += [prose(block.text), ""]
        elif block.kind in ("equation", "result"):
            steps += block.kind == "equation"
            out += _equation(block, number, steps)
        elif block.kind == "table":
            out += _table(block)
        elif block.kind == "figure":
            out += _figure(block)
    if chapter.page.settled:
        out += printed_forms(list(chapter.page.settled.values()))
    return "\n".join(out) + "\n"


def escaped(text: str) -> str:
    """Plain words for LaTeX."""
    return re.sub(r"([_%#&{}])", r"\\\1", text)


def prose(text: str) -> str:
    """Prose with formulas between dollar signs: what TeX takes for itself is written out."""
    parts = re.split(r"(\$[^$]*\$)", text)
    return "".join(p if p[:1] == "$" else re.sub(r"(?<!\\)([%#&_])", r"\\\1", p) for p in parts)


# -- equations ------------------------------------------------------------------------


def _equation(block: Block, chapter: int, step: int) -> list[str]:
    heading = "Result" if block.kind == "result" else f"Step {step}"
    reason = _sentence(prose(block.text)) if block.text else ""
    rows = _rows(block.lines)
    beside = f"\\quad paper ({block.paper})" if block.paper else ""
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


def _sentence(text: str) -> str:
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?", ":")) else f"{text}."


def _rows(lines: tuple[tuple[str, str, Any], ...]) -> list[str]:
    rows: list[str] = []
    for left, sign, right in lines:
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


def _text(side: Any) -> str:
    return side if isinstance(side, str) else latex(side)


def _table(block: Block) -> list[str]:
    head, *rows = (
        " & ".join(prose(c) if isinstance(c, str) else f"${latex(c)}$" for c in row) + r" \\"
        for row in block.rows
    )
    return [
        "\\begin{center}",
        f"\\begin{{tabular}}{{@{{}}*{{{len(block.rows[0])}}}{{r}}@{{}}}}\\toprule",
        head,
        "\\midrule",
        *rows,
        f"\\bottomrule\\end{{tabular}}\\\\[4pt]{{\\footnotesize {prose(block.text)}\\par}}",
        "\\end{center}",
        "",
    ]


def _figure(block: Block) -> list[str]:
    return [
        "\\begin{figure}[htbp]\\centering",
        f"\\includegraphics{{figures/{block.title}.pdf}}",
        f"\\caption*{{\\footnotesize {prose(block.text)}}}",
        "\\end{figure}",
        "",
    ]


# -- printed forms --------------------------------------------------------------------


def printed_forms(settled: list[Settled]) -> list[str]:
    """The table of what is printed, beside the verdict and, where needed, the correction."""
    out = ["\\printedforms"]
    for item in settled:
        statement, verdict = item.statement, item.verdict
        lines = [line for text in statement.latex for line in broken(text)]
        shown = _stack(lines) if lines else prose(statement.says)
        if statement.domain:
            shown += f"\\\\[2pt]{{\\footnotesize ${statement.domain}$}}"
        if verdict.condition:
            running = verdict.condition.replace(r",\ ", "$, $")
            running = running.replace(r"\ \text{and}\ ", "$ and $")
            shown += f"\\\\[4pt]{{\\footnotesize\\kind{{{verdict.kind}}}{{for}} ${running}$}}"
        if lines and not statement.id.startswith(("eq", "tab")):
            shown = f"{prose(statement.says)}\\\\[2pt]{shown}"
        out.append(f"\\form{{{_reference(statement.id)}}}{{{shown}}}{{{_verdict(verdict)}}}")
        correction = _correction(verdict)
        if correction:
            out.append(f"\\form{{}}{{{correction}}}{{\\kind{{proved}}{{proved}} as corrected}}")
    out += ["\\formsend", ""]
    return out


def _reference(id: str) -> str:
    if id.startswith("eq"):
        return f"({id[2:]})"
    if id.startswith("tab"):
        return f"Table {'I' * int(id[3:])}"
    # the column holds thirteen letters; the longest word, "interconnection", breaks after five
    breaking = re.sub(r"-|\b\w{5}(?=\w{9})", r"\g<0>\\allowbreak ", id)
    return f"\\texttt{{\\scriptsize {breaking}}}"


def _stack(lines: list[str]) -> str:
    """Formula lines, aligned at the left, in the largest size that fits the column."""
    lines = [_upright(line) for line in lines]
    widest = max(width(line) for line in lines)
    size = "" if widest <= FORM else "\\footnotesize" if widest <= 1.12 * FORM else "\\scriptsize"
    rows = " \\\\[3pt] ".join(
        f"&{'' if i == 0 or not _continues(line) else chr(92) + 'quad '}{line}"
        for i, line in enumerate(lines)
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


def _continues(line: str) -> bool:
    return line.lstrip().startswith(("+", "-", r"\left("))


def _correction(verdict: Verdict) -> str:
    if verdict.corrected_latex is not None:
        lines = [
            line for text in verdict.corrected_latex.split(r",\quad ") for line in broken(text)
        ]
        return _stack(lines)
    if verdict.corrected is not None:
        return _stack([latex(part) for part in verdict.corrected])
    return ""


def _verdict(verdict: Verdict) -> str:
    parts = [f"\\kind{{{verdict.kind}}}{{{verdict.kind}}}"]
    if verdict.kind == Kind.ENCLOSED and verdict.value:
        parts.append(f"\\\\{{\\scriptsize${verdict.value[:18]}\\ldots$}}\\\\")
    if verdict.kind is Kind.EXTERNAL:
        parts.append(verdict.method)
    if verdict.shows:
        parts.append(verdict.shows)
    elif verdict.counterexample:
        at = ",\\ ".join(f"{_symbol(k)}={v}" for k, v in verdict.counterexample.items())
        parts.append(f"differs at ${at}$")
    if verdict.note:
        parts.append(verdict.note.replace("^2 s^-2", r"$^2$\,s$^{-2}$"))
    return parts[0] + (": " if len(parts) > 1 else "") + "; ".join(parts[1:])


def _symbol(name: str) -> str:
    from sympy import Symbol

    return latex(Symbol(name))
