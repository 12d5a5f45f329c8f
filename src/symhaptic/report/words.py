"""Words for LaTeX: what TeX takes for itself is written out."""

from __future__ import annotations

import re


def escaped(text: str) -> str:
    """Plain words for LaTeX."""
    return re.sub(r"([_%#&{}])", r"\\\1", text)


def prose(text: str) -> str:
    """Prose with formulas between dollar signs: what TeX takes for itself is written out."""
    parts = re.split(r"(\$[^$]*\$)", text)
    return "".join(p if p[:1] == "$" else re.sub(r"(?<!\\)([%#&_])", r"\\\1", p) for p in parts)
