"""Words for LaTeX: what TeX takes for itself is written out."""

from __future__ import annotations

import re

from symhaptic.book.parts import referred
from symhaptic.notation.latex import euler, matching


def escaped(text: str) -> str:
    """Plain words for LaTeX."""
    return re.sub(r"([_%#&{}])", r"\\\1", text)


_SIGNS = {
    **{sign: f"\\{sign}" for sign in "_%#&{}$"},
    **{"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\textasciitilde{}"},
}


def literally(text: str) -> str:
    """Any letters as they are, such as those of a name."""
    return "".join(_SIGNS.get(c, c) for c in text)


def as_sentence(text: str) -> str:
    """Words that begin with a capital letter and end with a stop."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?", ":")) else f"{text}."


def prose(text: str) -> str:
    """Prose with formulas between dollar signs: what TeX takes for itself is written out."""
    return beside_formulas(referred(text, lambda number: f"\\chapterlink{{{number}}}"))


def beside_formulas(text: str) -> str:
    r"""The signs of TeX in words beside formulas are written out, braces where they do not match.

    A line may break after each hyphen of an id.

    >>> print(beside_formulas("50 % of $a_b$, not {c"), beside_formulas(r"\emph{50 %}"))
    50 \% of $a_b$, not \{c \emph{50 \%}
    """
    text = re.sub(r"\\texttt\{[^{}]*\}", lambda id: id[0].replace("-", r"-\allowbreak{}"), text)
    parts = re.split(r"(\$[^$]*\$)", text)
    parts[1::2] = [euler(part) if matching(part) else literally(part) for part in parts[1::2]]
    signs = "%#&_^$" if matching("".join(parts[::2])) else "%#&_^${}"
    return "".join(
        part if i % 2 else re.sub(rf"(?<!\\)[{signs}]", lambda sign: _SIGNS[sign[0]], part)
        for i, part in enumerate(parts)
    )


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
