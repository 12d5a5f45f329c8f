"""Every public name, from its docstring by autodoc, with its formula and a picture."""

from __future__ import annotations

import inspect
import re
from collections.abc import Collection
from typing import Any, cast

from docutils import nodes
from sphinx.config import Config
from sphinx.ext import napoleon
from sphinx.ext.napoleon.docstring import NumpyDocstring

import symhaptic
from symhaptic.book.report import gallery
from symhaptic.book.report.tree import container, display, led, paragraph
from symhaptic.forms.stable import STATEMENTS
from symhaptic.paper import STATEMENTS as PRINTED

PUBLIC = tuple(symhaptic.__all__)
PREFIX = "reference:"

GROUPS = {
    "A device in SI units": ("Scene", "Arm", "ArmRange"),
    "Parts of a loop": (
        *("LowPass", "Average", "Window", "Filter", "Measured", "Oversampled", "Difference"),
        *("Lag", "SecondMass", "LinearDevice", "Encoder"),
    ),
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
    "Results": ("Extremum", "Region"),
    "Sweeps, and what computes": ("sweep", "show_config"),
}

_OTHERS = "More"

SETTINGS = {
    "autodoc_typehints": "none",
    "autodoc_member_order": "bysource",
    "autodoc_inherit_docstrings": False,
    "nitpick_ignore_regex": [("py:.*", r"(?!symhaptic\.)\w+")],  # of Python itself
}
"""Sphinx's."""


def page(known: Collection[str]) -> str:
    """The page of all names; those that no group has come last.

    ``known`` are the names of trees, of which each stands below what autodoc writes.
    """
    grouped = {name for names in GROUPS.values() for name in names}
    groups = {**GROUPS, _OTHERS: tuple(name for name in PUBLIC if name not in grouped)}
    out = [".. _reference:", "", *_heading("Reference", "=")]
    out += [
        "Import all names from ``symhaptic``. :class:`Scene` takes and returns SI units. Functions "
        "with Greek arguments are dimensionless, in the parameters of Table I: "
        ":math:`\\alpha=KT^2/m`, :math:`\\beta=BT/m`, :math:`\\gamma=kT^2/m` and "
        ":math:`\\delta=bT/m`, with a delay in sampling periods. Arguments have the same order in "
        "all functions: the angle, the wall, the device, the delay.",
        "",
        ".. currentmodule:: symhaptic",
        "",
    ]
    for title, names in groups.items():
        rows = [_row(name) for name in names if name in PUBLIC]
        head = [f".. list-table:: {title}", "   :widths: 34 66", "   :class: names", ""]
        out += [*head, *(line for row in rows for line in row), ""] if rows else []
    for title, names in groups.items():
        out += _heading(title, "-") if names else []
        for name in names:
            if name in PUBLIC:
                out += _entry(name)
                out += [f".. tree:: {PREFIX}{name}", ""] if PREFIX + name in known else []
    return "\n".join(out) + "\n"


def _heading(title: str, mark: str) -> list[str]:
    return [title, mark * len(title), ""]


def _row(name: str) -> list[str]:
    """A name in the table, and the summary of its docstring."""
    thing = getattr(symhaptic, name)
    role = "class" if inspect.isclass(thing) else "func"
    summary = mathematics((inspect.getdoc(thing) or "").split("\n\n")[0].replace("\n", " "))
    return [f"   * - :{role}:`{name}`", f"     - {summary}"]


def _entry(name: str) -> list[str]:
    thing = getattr(symhaptic, name)
    if not inspect.isclass(thing):
        return [*_heading(f"``{name}``", "~"), f".. autofunction:: {name}", ""]
    ours = thing.__base__.__module__.startswith("symhaptic")
    inherited = ["   :inherited-members: object"] if ours else []
    return [f".. autoclass:: {name}", "   :members:", *inherited, ""]


def trees() -> dict[str, nodes.container]:
    """What stands below each docstring, by names that no chapter can have."""
    return {PREFIX + name: found for name in PUBLIC if (found := beside(name))}


def beside(name: str) -> nodes.container | None:
    """What stands below a docstring: the published formula and the first picture that it makes."""
    thing = getattr(symhaptic, name)
    blocks: list[nodes.Node] = []
    for id in () if inspect.isclass(thing) else STATEMENTS.get(name, ()):
        number = led("statement", id, f"({id.removeprefix('eq')})")
        blocks.append(paragraph("In the paper it is ", number, ", as published:"))
        blocks.append(display(PRINTED[id].latex))
    for path in gallery.shows(name)[:1]:
        place = led(gallery.NAME, path.stem, "In the gallery")
        blocks.append(gallery.picture(path, place))
    return container("beside", *blocks) if blocks else None


_NUMPYDOC = cast(Config, napoleon.Config(napoleon_use_param=False, napoleon_use_rtype=False))


def sections(text: str) -> str:
    """A docstring with the sections of numpydoc as reStructuredText.

    >>> print(sections("Returns\\n-------\\nfloat\\n    In N.").strip())
    :returns: *float* – In N.
    """
    return str(NumpyDocstring(text, _NUMPYDOC)).replace(" -- ", " – ")


_LETTER = r"(?:alpha|beta|gamma|delta|[A-Za-z])(?:_[A-Za-z])?"
_TERM = rf"{_LETTER}(?: [A-Za-z](?:\^2)?)?/[A-Za-z](?:_[A-Za-z]|\^2)?"
_SYMBOL = re.compile(
    rf"(?<![\w.^/*])(?:{_LETTER} = {_TERM}|[KBkb] T(?:\^2)?/m|omega T"
    r"|(?:alpha|beta|gamma|delta|theta|pi)(?:\^2(?:/\d)?)?"
    r"|[A-Za-z]_(?:\(\w-\w\)|[A-Za-z](?:/[A-Za-z](?:_[A-Za-z])?)?))(?![\w/^(*])(?P<room>  +)?"
)
"""A letter with an index, a Greek letter or its square, and what equals a quotient of letters."""


def mathematics(text: str) -> str:
    r"""Symbols that a docstring has as plain text, as formulas; literals and examples stay.

    Columns of a table stay below each other.

    >>> mathematics("d = t_d/T, ``t_d`` of t_d in s")
    ':math:`d = t_d/T`, ``t_d`` of :math:`t_d` in s'
    >>> mathematics("x_(k-1) and delta^2/4")
    ':math:`x_{k-1}` and :math:`\\delta^2/4`'
    >>> mathematics("t_d            s")
    ':math:`t_d`    s'
    """
    parts = re.split(
        r"(:\w+:`[^`]*`|``[^`]*``|`[^`]*`|\*\*[^*]*\*\*|(?:>>>|\.\. math::) .*?(?:\n\s*\n|$))",
        text,
        flags=re.DOTALL,
    )
    return "".join(p if at % 2 else _SYMBOL.sub(_as_formula, p) for at, p in enumerate(parts))


def _as_formula(found: re.Match[str]) -> str:
    plain = found[0].rstrip()
    tex = re.sub(r"alpha|beta|gamma|delta|theta|omega|pi", lambda name: rf"\{name[0]}", plain)
    tex = re.sub(r"_\((.*)\)", r"_{\1}", tex)
    role = f":math:`{tex}`"
    return role.ljust(len(found[0])) if found["room"] else role


def processed(app: Any, what: str, name: str, of: Any, options: Any, lines: list[str]) -> None:
    """Put sections and formulas into a docstring, for autodoc."""
    lines[:] = mathematics(sections("\n".join(lines))).split("\n")
