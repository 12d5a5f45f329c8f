"""The explorer: a page that draws a loop's regions and shows its limits, by exported kernels.

The kernels come from the exporter, the rules from their statements and the arms from Table II;
the scripts beside it draw, hold the state and lay out.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy as sp
from docutils import nodes

from symhaptic.book.report.devices import ARMS, DEVICES
from symhaptic.book.report.tree import Link, container, display, led, paragraph, section, words
from symhaptic.export.request import built, chosen, target
from symhaptic.notation import B, K, T, b, k, m, t_d
from symhaptic.paper import STATEMENTS as PAPER
from symhaptic.paper.reading import read
from symhaptic.rules import PLAIN as RULES

NAME = "explorer"
KERNELS = (
    *(
        "discretize",
        "discretize_fractional",
        "is_stable",
        "stability_boundary",
        "max_stable_stiffness",
    ),
    *("passivity_margin", "passivity_margin_at", "max_passive_stiffness", "linear_limit"),
)
"""What the page asks of the exporter."""

SCRIPTS = (
    *("kernels", "decimal", "data", "state", "velocity", "boundary", "limits", "response"),
    *("drawing", "copies", "controls", "telling", "page"),
)
"""In the order in which the page loads them."""

HOME = Path(__file__).parent

MEANT: dict[str, Any] = {
    "rules:twice-damping": sp.Eq(B, 0),
    "rules:damping-over-delay": sp.true,
    "rules:four-masses": sp.Eq(B, 0),
    "rules:two-masses": sp.Eq(B, 0),
    **dict.fromkeys(
        ("rules:damped-contact", "rules:euler-for-devices", "rules:two-dampings"),
        (B > 0) & sp.Eq(b, 0) & sp.Eq(k, 0) & sp.Eq(t_d, 0),
    ),
}
"""The loops of which each rule claims something, as the propositions of the room ``rules`` say."""

CHAPTERS = {
    "rules:twice-damping": "s8a_twice_the_damping",
    "rules:damping-over-delay": "s8b_damping_over_delay",
    "rules:four-masses": "s8c_four_masses",
    "rules:two-masses": "s8c_four_masses",
    "rules:damped-contact": "s8e_damped_contact",
    "rules:euler-for-devices": "s10c_simulators",
    "rules:two-dampings": "s10d_measured_velocity",
}


@dataclass(frozen=True)
class Fraction:
    """A limit for a delay of l + epsilon periods in words, its condition, and their chapter."""

    words: str
    formula: tuple[str, ...] = ()
    chapter: str = "s6d_fractional_passivity"


@dataclass(frozen=True)
class Told:
    """One limit: the place of its number, its formula, and the chapter that derives it."""

    id: str
    title: str
    formula: tuple[str, ...]
    chapter: str
    fraction: Fraction | None = None
    """For fractional delays, if ``formula`` holds for integer ones alone."""


_BOUNDARY = r"p\big(e^{j\theta};\, \alpha(\theta), \beta(\theta)\big) = 0,\quad \theta = \omega T"
_WHOLE = (*PAPER["eq5"].latex, r"K \ge 0,\quad d \in \mathbb{N}_0")
_FILTER, _FILTERED = (
    "s10a_filtered_velocity",
    (
        r"b > \frac{T}{2} \frac{1}{1 - \cos(\omega T)} "
        r"\Re\{(1 - e^{-j\omega T}) e^{-j d \omega T} H(e^{j\omega T})\}",
        r"K \ge 0,\quad d \in \mathbb{N}_0",
    ),
)
_PUSHES = (*PAPER["eq4"].latex, r"K \ge 0,\quad d \in \mathbb{N}_0")

FRACTIONAL_PASSIVITY = (
    r"b^2 + bB ((1-\varepsilon) \cos((\ell+1)\theta) + \varepsilon \cos((\ell+2)\theta))",
    r"\quad - \frac{bKT}{2 \sin(\theta/2)} ((1-\varepsilon) \sin((\ell+\tfrac{1}{2})\theta) "
    r"+ \varepsilon \sin((\ell+\tfrac{3}{2})\theta))",
    r"\geq \frac{\varepsilon(1-\varepsilon)}{4} (K^2T^2 + 4B(KT+B) \sin^2(\theta/2))",
)
"""The statement ``fractional-passivity``, in three lines."""

_BETWEEN = (*FRACTIONAL_PASSIVITY, r"0 < \theta < \pi,\quad K \ge 0,\quad d = \ell+\varepsilon")

TOLD = (
    Told(
        "told-limit", "Largest stable stiffness at this damping", (_BOUNDARY,),
        "s4d_explicit_boundary",
    ),
    Told(
        "told-stiffest", "Largest stable stiffness at any damping",
        (r"\frac{\mathrm{d}\alpha}{\mathrm{d}\theta} = 0",), "s5b_stiffest_wall",
    ),
    Told(
        "told-passive-limit", "Largest passive stiffness at this damping", _WHOLE,
        "s3a_passivity_condition",
        Fraction("The largest $K$ that satisfies", _BETWEEN),
    ),
    Told(
        "told-stiffest-passive", "Largest passive stiffness at any damping",
        (r"K = \frac{2b}{T}\tan\frac{\pi}{4(d+1)},\quad d \in \mathbb{N}_0",),
        "s3c_stiffness_maximum",
        Fraction(
            "The largest $K$ that satisfies the condition above with some $B$",
            chapter="s6f_stiffest_passive_wall",
        ),
    ),
    Told("told-linear", "Linear condition", PAPER["eq24"].latex, "s4e_line"),
    Told(
        "told-needed", "Damping that this wall requires to be passive", _PUSHES,
        "s3_energy",
        Fraction("The least $b > 0$ that satisfies the condition above"),
    ),
    Told(
        "told-delay", "Delay margin of this wall: what may be added to the delay",
        (r"T\,\min\{d : |\lambda(d)| = 1\} - t_d",), "s4d_roots_delay_margin",
    ),
)  # fmt: skip


@cache
def kernels() -> str:
    """The exported script: all functions are in ``haptic``."""
    _, files = built(target("javascript"), chosen(KERNELS), "haptic", vectors=False)
    return files["haptic.script.js"]


def data() -> str:
    """Devices, arms and rules as a script."""
    named = {"devices": DEVICES, "arms": ARMS}
    given = {kind: [one._asdict() for one in presets] for kind, presets in named.items()}
    rules = ",\n".join(_rule(id) for id in RULES)
    presets = f"explorer.data = {json.dumps(given, indent=1)};"
    return f'"use strict";\n{presets}\nexplorer.rules = [\n{rules}\n];\n'


def _rule(id: str) -> str:
    """The stiffness that a rule allows, made of its print."""
    (printed,) = (relation for line in RULES[id].latex for relation in read(line))
    if printed.lhs != K:
        raise ValueError(f"{id}: {printed} is no bound of K")
    limit = sp.jscode(printed.rhs)
    meant = "true" if MEANT[id] == sp.true else sp.jscode(MEANT[id])
    names = ", ".join(symbol.name for symbol in (m, b, k, T, t_d, K, B))
    arrow = f"({{ {names} }}) =>"
    return f'{{ id: "{_short(id)}", limit: {arrow} {limit}, meant: {arrow} {meant} }}'


def _short(id: str) -> str:
    return id.partition(":")[2]


def page() -> nodes.section:
    """The page."""
    rules = (
        container(f"limit rule rule-{_short(id)}", *_rule_rows(id, rule.latex))
        for id, rule in RULES.items()
    )
    scripts = "\n".join(f'<script src="_static/{NAME}/{name}.js"></script>' for name in SCRIPTS)
    return section(
        "Explore a wall",
        paragraph(
            "Set a device, an arm and a virtual wall, or drag the wall in the picture. The page "
            "computes which walls are stable and which are passive with the kernels that the "
            "package exports. The address of the page contains all settings."
        ),
        _raw(_markup("explorer.html")),
        section("Limits of this loop", paragraph(words(_COUNTED)), *map(_limit, TOLD)),
        section("Rules in circulation", paragraph(_RULES), *rules),
        section("Take it along", _raw(_markup("share.html"))),
        _raw(f'<link rel="stylesheet" href="_static/{NAME}/{NAME}.css">\n{scripts}'),
        to="page",
        at=NAME,
    )


_COUNTED = (
    "For stability $m$, $b$ and $k$ are those of device and arm together. For passivity $b$ is "
    "that of the device alone. With a velocity filter $F(z)$ the wall has the transfer function "
    "$H(z)=K+B\\,(1-z^{-1})\\,F(z)/T$."
)

_RULES = (
    "What one of these rules allows for this loop, beside the exact limit at this damping. None "
    "of them is safe for every loop; each chapter has a wall that shows it."
)


def _limit(told: Told) -> nodes.container:
    lines = [
        paragraph(_linked(told.title, told.chapter)),
        _raw(f'<p id="{told.id}"></p>'),
        _raw(f'<p class="note" id="{told.id}-note"></p>'),
    ]
    if told.fraction is None:
        return container("limit", *lines, display(told.formula))
    kinds = [container("delay-whole", display(told.formula))]
    for kind, chapter, formula in (
        ("delay-fraction", told.fraction.chapter, told.fraction.formula),
        ("delay-filter", _FILTER, told.fraction.formula and _FILTERED),
    ):
        said = paragraph(words(told.fraction.words), " (", _linked("derivation", chapter), ")")
        kinds.append(container(kind, said, *([display(formula)] if formula else [])))
    return container("limit", *lines, *kinds)


def _rule_rows(id: str, latex: tuple[str, ...]) -> list[nodes.Element]:
    title = _short(id).replace("-", " ").capitalize()
    return [
        paragraph(_linked(title, CHAPTERS[id])),
        _raw('<p class="rule-value"></p>'),
        _raw('<p class="rule-verdict"></p>'),
        display(latex),
    ]


def _linked(title: str, chapter: str) -> Link:
    return led("chapter", chapter, title)


def _raw(html: str) -> nodes.raw:
    return nodes.raw("", html, format="html")


def _markup(name: str) -> str:
    return (HOME / name).read_text(encoding="utf-8")


def files() -> Iterator[tuple[str, str]]:
    """What is made for the page beside its static files, by name."""
    yield f"{NAME}/kernels.js", kernels()
    yield f"{NAME}/data.js", data()
