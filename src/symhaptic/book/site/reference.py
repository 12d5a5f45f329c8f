"""Every public name, from its docstring by autodoc, with what its arguments are and its formula."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any

from sphinx.application import Sphinx

import symhaptic
from symhaptic.book.site import gallery
from symhaptic.book.site.words import display, heading, math, table
from symhaptic.book.tex.words import place_of
from symhaptic.forms.stable import STATEMENTS
from symhaptic.notation import SYMBOLS
from symhaptic.paper import STATEMENTS as PRINTED

PUBLIC = tuple(symhaptic.__all__)

GROUPS = {
    "A device in SI units": ("Scene",),
    "Stable walls": (
        *("is_stable", "max_stable_stiffness", "limit_at", "delay_margin", "max_delay"),
        *(
            "stability_boundary",
            "stable_region",
            "robust_region",
            "unstable_roots",
            "characteristic_polynomial",
        ),
        *("grid_boundary", "linear_limit", "jury"),
    ),
    "Passive walls": (
        *("is_passive", "max_passive_stiffness", "passivity_margin", "passivity_margin_at"),
        *("passivity_boundary",),
    ),
    "The sampled device": ("discretize", "discretize_fractional"),
    "Formulas and proofs": (
        *("formula", "lambdify", "prove", "enclose", "enclose_maximum", "recheck"),
        *("Formula", "Verdict"),
    ),
    "What is given back": ("Extremum", "Region"),
}

_OTHERS = "More"

_SPELT = {"delay": "d", "omega": "omega_hat"}
"""Arguments that are not spelt as their symbol."""

SETTINGS = {
    "autodoc_typehints": "none",
    "autodoc_member_order": "bysource",
    "autodoc_inherit_docstrings": False,
    "nitpick_ignore_regex": [("py:.*", r"(?!symhaptic\.)\w+")],  # of Python itself
}
"""Sphinx's."""


def pages() -> dict[str, str]:
    """The page of all names; those that no group has come last."""
    known = {name for names in GROUPS.values() for name in names}
    groups = {**GROUPS, _OTHERS: tuple(name for name in PUBLIC if name not in known)}
    out = [".. _reference:", "", *heading("Every name")]
    out += [
        "All are imported from ``symhaptic``. Numbers are dimensionless, in the parameters of "
        "Table I, where they are Greek: :math:`\\alpha=KT^2/m`, :math:`\\beta=BT/m`, "
        ":math:`\\gamma=kT^2/m`, :math:`\\delta=bT/m`; a delay is in periods.",
        "",
        ".. currentmodule:: symhaptic",
        "",
    ]
    for title, names in groups.items():
        if names:
            out += heading(title, "-")
            out += [line for name in names if name in PUBLIC for line in _entry(name)]
    return {"reference": "\n".join(out) + "\n"}


def _entry(name: str) -> list[str]:
    thing = getattr(symhaptic, name)
    if inspect.isclass(thing):
        ours = thing.__base__.__module__.startswith("symhaptic")
        inherited = ["   :inherited-members: object"] if ours else []
        return [f".. autoclass:: {name}", "   :members:", *inherited, "", *_picture(name)]
    return [
        *heading(f"``{name}``", "~"),
        f".. autofunction:: {name}",
        "",
        *_arguments(thing),
        *_formula(name),
        *_picture(name),
    ]


def _picture(name: str) -> list[str]:
    """The first picture of the gallery that a name makes, which leads to the lines that do so."""
    for path in gallery.shows(name)[:1]:
        place = f":ref:`In the gallery <{gallery.NAME}-{path.stem}>`"
        return [*gallery.picture(path), f"   {place}", ""]
    return []


def _arguments(function: Any) -> list[str]:
    """Symbol, unit and domain of each argument that is a symbol of the notation."""
    rows = []
    for name in inspect.signature(function).parameters:
        known = SYMBOLS.get(_SPELT.get(name, name))
        if known is not None and function.__module__.startswith("symhaptic.numeric"):
            rows.append(
                [
                    *(f"``{name}``", math(known.latex), known.unit, known.domain),
                    mathematics(known.meaning),
                ]
            )
    head = ["argument", "symbol", "unit", "domain", "meaning"]
    return table("arguments", [head, *rows]) if rows else []


def _formula(name: str) -> list[str]:
    """What the paper prints of it, and where that is settled."""
    out: list[str] = []
    for id in STATEMENTS.get(name, ()):
        place = f":ref:`({id.removeprefix('eq')}) <statement-{place_of(id)}>`"
        out += [f"In the paper it is {place}, as printed:", ""]
        out += display(f"&{line}" for line in PRINTED[id].latex)
    return out


def docstrings() -> Iterator[str]:
    """Whatever autodoc takes over, for its formulas; of attributes what their source says."""
    for name in PUBLIC:
        thing = getattr(symhaptic, name)
        yield mathematics(inspect.getdoc(thing) or "")
        if inspect.isclass(thing):
            yield " ".join(re.findall(r":math:`[^`]*`", mathematics(inspect.getsource(thing))))
        for member, of in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_"):
                yield mathematics(inspect.getdoc(of) or "")


_LETTER = r"(?:alpha|beta|gamma|delta|[A-Za-z])(?:_[A-Za-z])?"
_TERM = rf"{_LETTER}(?: [A-Za-z](?:\^2)?)?/[A-Za-z](?:_[A-Za-z]|\^2)?"
_SYMBOL = re.compile(
    rf"(?<![\w.])(?:{_LETTER} = {_TERM}|[A-Za-z]_[A-Za-z](?:/[A-Za-z](?:_[A-Za-z])?)?)(?![\w/^(*])"
    r"(?P<room>  +)?"
)
"""A letter with another at its foot, and what is equal to a quotient of letters."""


def mathematics(text: str) -> str:
    r"""Symbols that a docstring has as plain text, as formulas; literals and examples stay.

    Columns of a table stay below each other.

    >>> mathematics("d = t_d/T, ``t_d`` of t_d in s")
    ':math:`d = t_d/T`, ``t_d`` of :math:`t_d` in s'
    >>> mathematics("t_d            s")
    ':math:`t_d`    s'
    """
    parts = re.split(
        r"(:\w+:`[^`]*`|``[^`]*``|`[^`]*`|>>> .*?(?:\n\s*\n|$))", text, flags=re.DOTALL
    )
    return "".join(p if at % 2 else _SYMBOL.sub(_as_formula, p) for at, p in enumerate(parts))


def _as_formula(found: re.Match[str]) -> str:
    plain = found[0].rstrip()
    tex = re.sub(r"alpha|beta|gamma|delta", lambda name: rf"\{name[0]}", plain)
    role = f":math:`{tex}`"
    return role.ljust(len(found[0])) if found["room"] else role


def _processed(app: Sphinx, what: str, name: str, of: Any, options: Any, lines: list[str]) -> None:
    lines[:] = mathematics("\n".join(lines)).split("\n")


def setup(app: Sphinx) -> dict[str, Any]:
    """Sphinx's entry."""
    app.setup_extension("sphinx.ext.autodoc")
    app.connect("autodoc-process-docstring", _processed)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
