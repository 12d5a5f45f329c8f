r"""Plain words and signs, as a docstring has them, as prose with formulas.

Letters, numbers and signs that stand beside each other are one formula; a word, a comma or a full
stop ends it.  What brackets hold belongs to a formula where no word is in it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

_RELATIONS = {
    "<=>": r"\Leftrightarrow",
    "=>": r"\Rightarrow",
    "<=": r"\le",
    ">=": r"\ge",
    "!=": r"\ne",
    "|-": r"\vdash",
    "/\\": r"\wedge",
    "\\/": r"\vee",
    "<": "<",
    ">": ">",
    "=": "=",
}
_AROUND = {"conj": r"\overline", "sqrt": r"\sqrt"}
"""Functions that LaTeX draws around what they are of."""

_FUNCTIONS = {
    **{name: f"\\{name}" for name in ("exp", "sin", "cos", "tan", "det", "log")},
    **{name: rf"\mathrm{{{name}}}" for name in ("Re", "Im", "adj", "tr")},
    **_AROUND,
    "int": r"\int",
    "df": "df",
    "du": r"\,du",
    "ddelta": r"d\delta",
}
_GREEK = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "theta", "omega", "pi", "sigma"),
    *("Phi", "Gamma", "Delta"),
)
_NO_ARTICLE_BEFORE = ("and", "or", "is", "be", "adds")
"""Words before which a letter is no article."""

_TOKENS = re.compile(
    r"(?P<space>\s*)(?:"
    rf"(?P<greek>(?:{'|'.join(_GREEK)})(?![A-Za-z]))"
    rf"|(?P<function>(?:{'|'.join(_FUNCTIONS)})\b(?!'))"
    r"|(?P<word>\d+(?:\.\d+)?\((?:[a-z]|\d+)\)|\d+[a-z]+\b|[A-Z]\.(?=\s+[A-Z])"
    r"|[A-Za-z]+(?:[-'][A-Za-z]+)+'?|[A-Za-z]{2,}(?![\^_])'?)"
    r"|(?P<numbered>[nm][01])\b"
    r"|(?P<letter>[A-Za-z])"
    r"|(?P<number>\d+(?:\.\d+)?)"
    rf"|(?P<relation>{'|'.join(map(re.escape, _RELATIONS))})"
    r"|(?P<script>'+|[_^](?:-?\w+|\((?P<held>[^()]*)\)))"
    r"|(?P<dots>\.\.\.)"
    r"|(?P<sign>[-+*/|])"
    r"|(?P<open>[(\[])|(?P<close>[)\]])"
    r"|(?P<other>\S))"
)
"""What a text is made of; a dash, an index or a power is a script."""


@dataclass(frozen=True)
class _Part:
    """A token, or what stands in brackets, as it stands and as it is in a formula."""

    kind: str
    space: str
    text: str
    latex: str

    @property
    def is_formula(self) -> bool:
        return self.kind not in ("word", "other", "close", "open")


def in_formulas(text: str) -> str:
    r"""What is a formula in a text, between dollar signs.

    >>> in_formulas("p(z) != 0 for a v, and z^(d+1) A of Jury's p' at exp(j theta) in (18)")
    "$p(z)\\ne0$ for a $v$, and $z^{d+1}A$ of Jury's $p'$ at $\\exp(j\\theta)$ in (18)"
    >>> in_formulas("A zero a is of n1, a and e; conj(p) ends at 1, and see 5.10(b)")
    'A zero $a$ is of $n_1$, $a$ and $e$; $\\overline{p}$ ends at 1, and see 5.10(b)'
    >>> in_formulas("tr A = 2 Re z"), in_formulas("stiffness, sqrt(K T^2/m)")
    ('$\\mathrm{tr}\\,A=2\\,\\mathrm{Re}\\,z$', 'stiffness, $\\sqrt{KT^2/m}$')
    """
    return _prose(_bracketed(list(_tokens(text))))


def _tokens(text: str) -> Iterator[_Part]:
    for found in _TOKENS.finditer(text):
        kind, space = str(found.lastgroup if found["held"] is None else "script"), found["space"]
        text = found[0][len(space) :]
        yield _Part(kind, space, text, _latex(kind, text, found["held"]))


def _latex(kind: str, text: str, held: str | None) -> str:
    if kind == "relation":
        return _RELATIONS[text]
    if kind == "function":
        return _FUNCTIONS[text]
    if kind == "greek":
        return r"\varepsilon" if text == "epsilon" else f"\\{text}"
    if kind == "numbered":
        return f"{text[0]}_{text[1]}"
    if kind == "script" and text[0] in "_^":
        inner = _formula(list(_tokens(held if held is not None else text[1:])))
        return text[0] + (inner if len(inner) == 1 else f"{{{inner}}}")
    return {"...": r"\dots"}.get(text, text)


def _bracketed(parts: Sequence[_Part]) -> list[_Part]:
    """The same, with brackets that hold a formula as one part of it."""
    out: list[_Part] = []
    opened: list[int] = []
    for part in parts:
        if part.kind == "open":
            opened.append(len(out))
        out.append(part)
        if part.kind == "close" and opened:
            first = opened.pop()
            inside = out[first:]
            held = [p for p in inside[1:-1] if p.text != ","]
            before = out[first - 1] if first and not inside[0].space else None
            called = before is not None and before.is_formula
            equation = len(held) == 1 and held[0].kind == "number" and not called
            if held and all(p.is_formula for p in held) and not equation:
                text = "".join(p.space * (i > 0) + p.text for i, p in enumerate(inside))
                latex = inside[0].text + _formula(inside[1:-1]) + part.text
                if before is not None and before.text in _AROUND:
                    latex = f"{{{_formula(inside[1:-1])}}}"
                out[first:] = [_Part("bracket", inside[0].space, text, latex)]
    return out


def _formula(parts: Sequence[_Part]) -> str:
    """Parts beside each other as LaTeX; a command keeps clear of a letter behind it."""
    out = ""
    for before, part in zip((None, *parts), parts, strict=False):
        latex = r",\ " if part.text == "," else part.latex
        if before is not None and _apart(before, part):
            out += r"\,"
        elif re.search(r"\\[A-Za-z]+$", out) and latex[:1].isalpha():
            out += " "
        out += latex
    return out


def _apart(before: _Part, part: _Part) -> bool:
    """Whether the name of a function stands beside what it is not taken of, or without brackets."""
    if before.latex.startswith(r"\mathrm"):
        return part.kind != "bracket"
    return part.latex.startswith(r"\mathrm") and before.kind not in ("sign", "relation")


def _prose(parts: Sequence[_Part]) -> str:
    out, run = "", list[_Part]()
    for i, part in enumerate(parts):
        if part.is_formula and not _is_article(parts, i):
            run.append(part)
            continue
        out += _run(run) + part.space + part.text
        run = []
    return out + _run(run)


def _is_article(parts: Sequence[_Part], place: int) -> bool:
    """Whether a letter behind a word is an article, of what follows it."""
    if parts[place].text not in ("a", "A") or place + 1 == len(parts):
        return False
    behind = place > 0 and parts[place - 1].is_formula
    after = parts[place + 1]
    of = after.kind in ("word", "letter", "greek", "function") and after.space
    return not behind and bool(of) and after.text not in _NO_ARTICLE_BEFORE


def _run(run: Sequence[_Part]) -> str:
    """A formula; a sign between words stands alone, and a number alone is a word."""
    if not run:
        return ""
    for end in (0, -1):
        if len(run) > 1 and run[end].kind == "relation" and run[end].text in ("=>", "<=>"):
            rest = run[1:] if end == 0 else run[:-1]
            sides = [run[:1], rest] if end == 0 else [rest, run[-1:]]
            return "".join(map(_run, sides))
    first = run[0]
    if len(run) == 1 and (first.kind in ("number", "dots", "sign") or first.text == "="):
        return first.space + first.text
    return f"{first.space}${_formula(run)}$"
