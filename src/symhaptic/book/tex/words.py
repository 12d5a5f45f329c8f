"""Words for LaTeX: a text is data, so every sign in it is printed and no command in it is run."""

from __future__ import annotations

import re
from collections.abc import Iterator

from symhaptic.book.parts import numbers
from symhaptic.notation.latex import euler, refused

_SIGNS = {
    **{sign: f"\\{sign}" for sign in "_%#&{}$"},
    **{"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\textasciitilde{}"},
}


def literally(text: str) -> str:
    """Any letters as they are, such as those of a name, without TeX's ligatures of signs."""
    shown = "".join(_SIGNS.get(c, c) for c in text)
    return re.sub(r"([-<>,])(?=\1)", r"\1{}", shown)


def as_sentence(text: str) -> str:
    """Words that begin with a capital letter and end with a stop."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?", ":")) else f"{text}."


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


def scanned(text: str) -> Iterator[tuple[str, str]]:
    r"""Parts of a text, each with its kind: a mark, ``end`` of an emphasis, or plain ``text``.

    A formula that :func:`refused` objects to, and a brace that belongs to no mark, are text.

    >>> list(scanned(r"\emph{5\% of {$a_b$}} $\input{x}$"))[:4]
    [('emphasis', '\\emph{'), ('text', '5'), ('text', '%'), ('text', ' of ')]
    """
    text = re.sub(r"[\x00-\x08\x0e-\x1f\x7f]", "\ufffd", text)
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
    yield from [("end", "")] * opened.count("emphasis")


def prose(text: str) -> str:
    r"""Prose with formulas between dollar signs: what TeX takes for itself is written out.

    A line may break after each hyphen of a name in ``\texttt``.

    >>> print(prose("50 % of $a_b$, not {c"), prose(r"\emph{50 %}"), prose(r"$\input{c}$"))
    50 \% of $a_b$, not \{c \emph{50 \%} \$\textbackslash{}input\{c\}\$
    """
    text = re.sub(r"\n\s*\n", "\n", text)  # a paragraph may not end within an argument
    return "".join(_printed(kind, part) for kind, part in scanned(text))


def _printed(kind: str, part: str) -> str:
    match kind:
        case "formula":
            return f"${euler(part)}$"
        case "chapter":
            return f"\\chapterlink{{{numbers()[part]}}}"
        case "code":
            return rf"\texttt{{{literally(part)}}}".replace("-", r"-\allowbreak{}")
        case "end":
            return "}"
        case "text":
            return literally(part)
    return part


def paragraphs(text: str) -> list[str]:
    """Prose of each paragraph, parted by blank lines."""
    return [prose(part) for part in re.split(r"\n\s*\n", text)]


def number(value: float) -> str:
    r"""Up to six digits of a number inside a formula, with a power of ten where it needs one.

    >>> number(0.02), number(6.944e-05), number(1e6)
    ('0.02', '6.944\\times10^{-5}', '10^{6}')
    """
    mantissa, _, power = f"{value:g}".partition("e")
    if not power:
        return mantissa
    ten = f"10^{{{int(power)}}}"
    return ten if mantissa == "1" else rf"{mantissa}\times{ten}"


def place_of(id: str) -> str:
    """An id as the place of a link, of which TeX keeps all, and a label of the site, too.

    >>> place_of("rules:four"), place_of("my:K_0")
    ('rules.3a.four', 'my.3a..4b..5f.0')
    """
    return re.sub(r"[^a-z0-9-]", lambda odd: f".{ord(odd[0]):x}.", id)


def anchor(name: str) -> str:
    """A rule's name as the place of a link, in letters that TeX leaves alone."""
    return re.sub(r"[^A-Za-z0-9]+", "-", name)
