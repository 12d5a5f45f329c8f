"""Plain words and signs, as a docstring has them, as prose with formulas."""

from __future__ import annotations

import re

_SIGNS = {
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
    "|": "|",
}

_GREEK = ("alpha", "beta", "gamma", "delta", "epsilon", "theta", "omega", "pi", "Phi", "Gamma")

_SCRIPTED = (
    r"(?P<base>(?<![A-Za-z'])[A-Za-z]|[)|]|\b(?:Phi|Gamma)(?=_))(?P<primes>'*)"
    r"(?P<sub>_\([^()]*\)|_\w+|(?<=[nm])[0-9]\b)?(?P<sup>\^-?\w+|\^\([^()]*\))?(?![A-Za-z])"
)
"""A letter or a bracket with what is dashed, lowered or raised behind it."""

_PARTS = re.compile(
    rf"(?P<sign>(?:{'|'.join(map(re.escape, _SIGNS))})(?!\^))|{_SCRIPTED}"
    rf"|\b(?P<greek>{'|'.join(_GREEK)})\b(?P<dash>'*(?:\^\w)?)"
)


def in_formulas(text: str) -> str:
    r"""Signs, Greek letters and letters with indices or powers as formulas between dollar signs.

    >>> in_formulas("p |- p <= 1, and z^(d+1) A of Jury's p' at theta")
    "p $\\vdash$ p $\\le$ 1, and $z^{d+1}$ A of Jury's $p'$ at $\\theta$"
    """
    return _PARTS.sub(_formula, text)


def _formula(found: re.Match[str]) -> str:
    if found["sign"]:
        return f"${_SIGNS[found['sign']]}$"
    if found["greek"]:
        return f"${_letter(found['greek'])}{found['dash']}$"
    scripts = "".join(
        f"{mark}{{{_letter(of.lstrip('_^').strip('()'))}}}"
        for mark, of in (("_", found["sub"]), ("^", found["sup"]))
        if of
    )
    if not (scripts or found["primes"]):
        return found[0]
    scripts = found["primes"] + re.sub(r"\{(\w)\}", r"\1", scripts)
    return f"${_letter(found['base'])}{scripts}$"


def _letter(name: str) -> str:
    r"""A Greek letter's command, epsilon as the book writes it; others as they are."""
    if name not in _GREEK:
        return name
    return r"\varepsilon" if name == "epsilon" else f"\\{name}"
