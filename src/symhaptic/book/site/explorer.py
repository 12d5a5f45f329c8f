"""The explorer: a page on which one loop can be turned by hand, by the exported functions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from symhaptic.book.site.devices import ARMS, DEVICES
from symhaptic.book.site.words import heading
from symhaptic.export import request
from symhaptic.rules import STATEMENTS as RULES

FILES = Path(__file__).parent / "static" / "explorer"
SCRIPTS = ("loop.js", "plot.js", "page.js")
STYLES = ("explorer.css", "figure.css")

FUNCTIONS = (
    *("is_stable", "stability_boundary", "max_stable_stiffness", "discretize_late"),
    *("passivity_boundary", "passivity_margin", "max_passive_stiffness"),
)
"""What the page computes with."""

OUT = (
    ("stable", "the wall, with this arm"),
    ("passive", "the wall, with the device alone"),
    ("margin", "passivity margin, in damping of the device"),
    ("stiffest", "stiffest stable wall"),
    ("here", "stable up to, with this B"),
    ("stiffest-passive", "stiffest passive wall"),
    ("passive-here", "passive up to, with this B"),
    ("later", "more delay until it is not stable"),
    ("numbers", "in units of mass and period"),
)
"""Names of the results, with what is said of them."""

LINKED = {
    "stiffest": "s5b_stiffest_wall",
    "stiffest-passive": "s3c_stiffness_maximum",
    "passive": "s3a_passivity_condition",
    "stable": "s4d_explicit_boundary",
}
"""Chapters that derive a result."""


def assets() -> dict[str, str]:
    """The exported functions as a script, and the presets, by their names as files."""
    target = request.target("javascript")
    _, files = request.built(target, request.chosen(list(FUNCTIONS), request.scene("")), "haptic")
    presets = {
        "devices": [_preset(name, values, source) for name, values, source in DEVICES],
        "arms": [_preset(name, values, source) for name, values, source in ARMS],
    }
    data = f"globalThis.explorerData = {json.dumps(presets)};\n"
    return {"haptic.script.js": files["haptic.script.js"], "explorer-data.js": data}


def _preset(name: str, values: dict[str, float], source: str) -> dict[str, Any]:
    return {"name": name, "values": values, "source": source}


def page(chapters: Sequence[str]) -> str:
    """The page as reStructuredText; results lead to those of the chapters that are there."""
    styles = "".join((FILES / name).read_text(encoding="utf-8") for name in STYLES)
    out = [*heading("Explore a wall"), ".. raw:: html", ""]
    out += [f"   {line}" for line in _html(styles, chapters).splitlines()]
    return "\n".join(out) + "\n"


def _html(styles: str, chapters: Sequence[str]) -> str:
    scripts = "\n".join(
        f'<script src="_static/{name}"></script>'
        for name in ("haptic.script.js", "explorer-data.js", *(f"explorer/{s}" for s in SCRIPTS))
    )
    rows = [_row(name, text, LINKED.get(name), chapters) for name, text in OUT]
    rules = [
        _row(
            id.partition(":")[2],
            f"rule in circulation: {_plain(RULES[id].latex[0])}",
            chapter,
            chapters,
        )
        for id, chapter in (
            ("rules:twice-damping", "s8a_twice_the_damping"),
            ("rules:damping-over-delay", "s8b_damping_over_delay"),
            ("rules:four-masses", "s8c_four_masses"),
        )
    ]
    return f"""\
<style id="explorer-style">
{styles}</style>
<p>Turn a loop by hand: a device, the arm that holds it, a sampled wall. What is green is stable,
what is brown is passive. Each point and each number is computed by the functions that
<code>symhaptic export</code> writes, here in your browser.</p>
<noscript><p>This page computes in the browser, and needs JavaScript.</p></noscript>
<div class="explorer">
<form>
<fieldset><legend>Device</legend>
<label for="devices">preset</label>
<select id="devices"><option value="">choose</option></select>
<p class="source" id="devices-source"></p>
<div data-group="mD bD"></div></fieldset>
<fieldset><legend>Arm that holds it</legend>
<label for="arms">preset</label>
<select id="arms"><option value="">choose</option></select>
<p class="source" id="arms-source"></p>
<div data-group="mH bH kH"></div></fieldset>
<fieldset><legend>Loop</legend><div data-group="T td"></div></fieldset>
<fieldset><legend>Wall</legend><div data-group="K B"></div>
<p class="hint">or drag it in the picture</p></fieldset>
<p class="told" role="alert"></p>
</form>
<div class="figures">
<svg class="regions" viewBox="0 0 640 440" role="img" aria-label="Stable and passive walls"></svg>
<p class="hint"><label><input type="checkbox" id="near"> close-up of the passive walls</label></p>
<p class="short" aria-live="polite"></p>
<svg class="motion" viewBox="0 0 640 200" role="img" aria-label="Motion after a push"></svg>
<table><caption class="source">Limits of this loop</caption><tbody>
{"".join(rows)}{"".join(rules)}</tbody></table>
<p class="hint">More delay is looked for in steps of a sixteenth of a period; all other numbers are
those of the exported functions.</p>
<div class="row">
<button type="button" data-copy="Python">Copy as Python</button>
<button type="button" data-copy="TOML">TOML</button>
<button type="button" data-copy="C">C</button>
<button type="button" data-copy="link">Link</button>
<button type="button" data-save="svg">Save SVG</button>
<button type="button" data-save="png">PNG</button>
</div>
<pre class="copied" tabindex="0" aria-label="What was copied"></pre>
</div>
</div>
{scripts}
"""


def _plain(latex: str) -> str:
    """The few forms of the rules without LaTeX."""
    for old, new in (
        (r"K \leq \frac{2b}{T}", "K ≤ 2b/T"),
        (r"K < \frac{b+B}{t_d+T/2}", "K < (b + B)/(t_d + T/2)"),
        (r"K < \frac{4m}{T^2}", "K < 4m/T²"),
    ):
        if latex == old:
            return new
    return latex


def _row(name: str, text: str, chapter: str | None, chapters: Sequence[str]) -> str:
    said = escape(text)
    if chapter in chapters:
        said = f'<a href="{chapter}.html">{said}</a>'
    return f'<tr><th scope="row">{said}</th><td data-out="{name}"></td></tr>\n'
