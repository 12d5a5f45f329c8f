"""Printed forms as a report shows them: reference, formula, verdict and correction."""

from __future__ import annotations

import re
from collections.abc import Sequence

from symhaptic.book.record import Settled
from symhaptic.book.tex.breaking import broken, width
from symhaptic.book.tex.words import literally, place_of, prose
from symhaptic.notation.latex import latex
from symhaptic.paper import Statement
from symhaptic.proof.verdict import Kind, Verdict

FORM = 29.5
"""Width of the column of printed forms, in em of its own size."""


NARROW = 75.0
"""Width of a proposition in em up to which it stands beside the words, and not below them."""


LONG_CLAIM = 400.0
"""Width of a proposition in em from which on a page may break it: others stay in one piece."""


BESIDE = 110
"""Letters of what a statement rests on up to which it stands in the margin, and not below."""


def letters(ground: str) -> int:
    r"""How many letters are set, of links only what is shown.

    >>> letters(r"a theorem by \byrule{held-answer}{motion}, \byrule{units}{units}")
    26
    """
    return len(re.sub(r"\\byrule\{[^{}]*\}|\\[a-z]+|[{}]", "", ground))


def printed_forms(settled: list[Settled], grounds: list[str]) -> list[str]:
    """The table of what is printed, beside the verdict and, where needed, the correction.

    ``grounds`` say of each what it rests on.  Neither the first row nor the last stands alone.
    """
    rows = []
    for item, ground in zip(settled, grounds, strict=True):
        statement, verdict = item.statement, item.verdict
        shown = _beside(printed(statement), verdict, facing=not statement.latex)
        beside = _verdict(verdict)
        long = letters(ground) > BESIDE
        if ground and not long:
            beside += f"\\\\\\textcolor{{black!60}}{{{ground}}}"
        place = f"\\statementplace{{{place_of(statement.id)}}}{reference(statement.id)}"
        rows.append(f"\\form{{{place}}}{{{shown}}}{{{beside}}}")
        if width(verdict.proposition or "") > LONG_CLAIM:
            rows[-1] += f"\n\\claimed{{${running(verdict.proposition or '')}$}}"
        if long:
            rows[-1] += f"\n\\grounds{{{ground}}}"
        right = correction(verdict)
        if right:
            rows.append(f"\\form{{}}{{{right}}}{{\\kind{{proved}}{{proved}} as corrected}}")
    if len(rows) > 1:
        rows[0] += "\\together"
        rows[-2] = rows[-2].removesuffix("\\together") + "\\together"
    return ["\\printedforms", *rows, "\\formsend", ""]


def answers(settled: Sequence[Settled]) -> str:
    """What a chapter finds, in words: each statement with its verdict and its condition."""
    return "\n".join(["\\answers", *map(_answered, settled), "\\answersend"])


def _answered(item: Settled) -> str:
    statement, verdict = item.statement, item.verdict
    says = prose(statement.says)
    if verdict.kind is Kind.QUALIFIED:
        says += f", for {condition(verdict)}"
    place = f"\\statementlink{{{place_of(statement.id)}}}{{{reference(statement.id)}}}"
    return f"\\answer{{{place}}}{{{says}}}{{\\kind{{{verdict.kind}}}{{{verdict.kind}}}}}"


def _beside(shown: str, verdict: Verdict, facing: bool) -> str:
    """What is printed, what it claims, and the condition under which it is right."""
    right = ""
    if verdict.condition:
        for_ = f"\\kind{{{verdict.kind}}}{{for}} {condition(verdict)}"
        right = f"\\\\[4pt]{{\\footnotesize {for_}}}"
    if not verdict.proposition or width(verdict.proposition) > LONG_CLAIM:
        return shown + right
    claim = running(verdict.proposition)
    if facing and width(claim) < NARROW:
        return f"\\facing{{{shown}}}{{\\footnotesize ${claim}${right}}}"
    return f"{shown}\\\\[4pt]{{\\footnotesize claims ${claim}$}}{right}"


def quoted(statement: Statement) -> str:
    """The source's own words in quotation marks; empty where a chapter states it itself."""
    return f"``{prose(statement.quote)}''" if statement.quote else ""


def formula(statement: Statement) -> str:
    """The formula of a statement, line by line, with its domain; empty where it has none."""
    lines = [line for text in statement.latex for line in broken(text)]
    shown = stack(lines) if lines else ""
    if lines and statement.domain:
        shown += f"\\\\[2pt]{{\\footnotesize ${statement.domain}$}}"
    return shown


def printed(statement: Statement) -> str:
    """The source's words, its formula, and our reading of them, in this order."""
    reading = prose(statement.says)
    if statement.quote:
        label = "" if statement.latex else "\\emph{Read as:} "
        reading = f"{{\\footnotesize {label}{reading}}}"
    parts = (quoted(statement), formula(statement), reading)
    return "\\\\[2pt]".join(part for part in parts if part)


def running(claim: str) -> str:
    """A proposition as running text: it may break after a comma and before an arrow."""
    claim = re.sub(r",(?=\w|\\[a-z])", r",\\allowbreak ", claim)
    claim = claim.replace(r",\ ", r",\allowbreak\ ").replace(r":\ ", r":\allowbreak\ ")
    return claim.replace(r"\ \Rightarrow\ ", r"\allowbreak\ \Rightarrow\ ")


def sentence(given: Sequence[str], then: str) -> str:
    """Hypotheses and conclusion: let this be, then that is."""
    found = ", ".join(f"${running(text)}$" for text in given)
    return f"Let {found}. Then ${running(then)}$." if found else f"${running(then)}$."


def condition(verdict: Verdict) -> str:
    """A condition as running text, which can be broken between its parts."""
    running = (verdict.condition or "").replace(r",\ ", "$, $")
    running = running.replace(r"\ \text{and}\ ", "$ and $")
    return f"${running}$"


_NUMBERED = re.compile(r"(eq|tab)(\d+)")
"""The ids of the paper's equations and tables."""


def reference(id: str) -> str:
    """The number of an equation or table, or the id of another statement."""
    if number := _NUMBERED.fullmatch(id):
        return f"({number[2]})" if number[1] == "eq" else f"Table {'I' * int(number[2])}"
    # a column may hold thirteen letters; a longer word, "interconnection", breaks where it has to
    words = (re.split(r"(?<=\b\w{5})(?=\w{9})", word) for word in re.split(r"(?<=-)", id))
    breaking = "\\allowbreak ".join("\\penalty1000 ".join(map(literally, w)) for w in words)
    return f"\\texttt{{\\scriptsize {breaking}}}"


def stack(lines: list[str]) -> str:
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


def correction(verdict: Verdict) -> str:
    """The right form, line by line; empty where nothing is corrected."""
    if verdict.corrected is not None:
        if verdict.corrected.startswith(r"\forall"):
            return f"{{\\footnotesize ${running(verdict.corrected)}$}}"
        text = verdict.corrected
        if width(text) <= FORM:
            return stack([text])
        lines = [line for part in text.split(r",\quad ") for line in broken(part)]
        return stack(lines)
    return ""


LONG = 70.0
"""Width of a correction in em from which on a reader is told what shows it instead."""

RIGHT = 22.0
"""Width of the column of what is right, in em."""


def right_is(verdict: Verdict) -> str:
    """What is right: for a condition, or a correction; empty where what is printed is right."""
    if verdict.kind is Kind.QUALIFIED:
        return f"for {condition(verdict)}"
    text = verdict.corrected or ""
    if width(text) > LONG and verdict.shows:
        return prose(verdict.shows)
    if r"\text" in text:
        return _in_words(text)
    parts = text.split(r",\quad ")
    one_by_one = len(parts) > 1 and width(text) > RIGHT
    return f"\\fitting{{{stack(parts) if one_by_one else correction(verdict)}}}"


def _in_words(text: str) -> str:
    r"""A correction with words in it as a sentence, which may break between them.

    >>> _in_words(r"\text{at}\ x=1,\ \text{and}\ y")
    'at $x=1$, and $y$'
    """
    parts = re.split(r"\\text\{([^{}]*)\}", text.replace(r",\quad ", r",\ "))
    words = [part if at % 2 else _formulas(part) for at, part in enumerate(parts)]
    return " ".join("".join(words).split()).replace(" ,", ",")


def _formulas(text: str) -> str:
    """Formulas between words, each between dollar signs, with the commas outside."""
    parts = re.split(r"(,?\\ )", text)
    return "".join(
        p.replace(r"\ ", " ") if at % 2 else f"${p}$" if p else "" for at, p in enumerate(parts)
    )


def _verdict(verdict: Verdict) -> str:
    head = f"\\kind{{{verdict.kind}}}{{{verdict.kind}}}"
    words = ([verdict.method] if verdict.kind is Kind.EXTERNAL else []) + shown_by(verdict)
    rest = list(map(prose, words))
    if verdict.value and verdict.kind in (Kind.ENCLOSED, Kind.QUALIFIED):
        head += f":\\\\{{\\scriptsize${verdict.value[:18]}\\ldots$}}\\\\"
        return head + "; ".join(rest)
    return head + (": " if rest else "") + "; ".join(rest)


def shown_by(verdict: Verdict) -> list[str]:
    """What happens at the counterexample, or where it is, and what else is to be said."""
    parts = []
    if verdict.shows:
        parts.append(verdict.shows)
    elif verdict.counterexample:
        at = ",\\ ".join(f"{_symbol(k)}={v}" for k, v in verdict.counterexample.items())
        parts.append(f"differs at ${at}$")
    if verdict.note:
        parts.append(verdict.note.replace("^2 s^-2", r"$^2$\,s$^{-2}$"))
    return parts


def _symbol(name: str) -> str:
    from sympy import Symbol

    return latex(Symbol(name))
