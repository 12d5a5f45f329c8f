"""MathML for the site: all formulas are turned by one run of pandoc, before Sphinx asks for them.

Pandoc and not a script of the browser: what it writes needs no network and no script, it is read
by screen readers, and it keeps the LaTeX beside each formula, to be copied.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from docutils import nodes
from sphinx.application import Sphinx

from symhaptic.book.tex.tex import ReportError

FORMULAS = "formulas.json"
"""Where the sources keep what pandoc wrote."""

_INLINE = re.compile(r":math:`([^`]*)`")
_DISPLAY = re.compile(r"^( *)\.\. math::\n\n\1   (.*)$", re.MULTILINE)


def formulas(sources: Iterable[str]) -> set[tuple[str, bool]]:
    """Every formula of these sources, and whether it stands by itself."""
    found: set[tuple[str, bool]] = set()
    for text in sources:
        found |= {(tex, False) for tex in _INLINE.findall(text)}
        found |= {(tex, True) for _, tex in _DISPLAY.findall(text)}
    return found


def turned(wanted: Iterable[tuple[str, bool]]) -> dict[str, str]:
    """MathML of each formula, by its LaTeX with a mark in front of what stands by itself."""
    listed = sorted(wanted)
    blocks = [
        {"t": "Para", "c": [{"t": "Math", "c": [{"t": _style(alone)}, tex]}]}
        for tex, alone in listed
    ]
    document = {"pandoc-api-version": [1, 23, 1], "meta": {}, "blocks": blocks}
    run = subprocess.run(
        [pandoc(), "-f", "json", "-t", "html5", "--mathml"],
        input=json.dumps(document),
        capture_output=True,
        text=True,
        check=False,
    )
    if run.returncode != 0 or run.stderr:
        first = (run.stderr or "no message").strip().splitlines()[0]
        raise ReportError(f"pandoc could not read a formula: {first}")
    made = re.findall(r"<p>(.*?)</p>", run.stdout, re.DOTALL)
    made = [spaced(html) for html in made]
    return {key(tex, alone): html for (tex, alone), html in zip(listed, made, strict=True)}


_MATHML = "http://www.w3.org/1998/Math/MathML"
ElementTree.register_namespace("", _MATHML)


def _tags(*names: str) -> frozenset[str]:
    return frozenset(f"{{{_MATHML}}}{name}" for name in names)


_ROWS = _tags("math", "mrow", "mstyle", "mtd")
"""What has any number of elements; a power has two, and with a space among them it is none."""

_SCRIPTED = _tags("msup", "msub", "msubsup", "munder")
_ENDS = _tags("mi", "mn", "msup", "msub", "mfrac")
"""Behind these a function is set apart."""


_FORMS = {**dict.fromkeys("([{", "prefix"), **dict.fromkeys(")]}", "postfix")}
"""Brackets that have one form only, which a browser knows."""


def spaced(html: str) -> str:
    """The thin spaces that TeX puts around the name of a function, its exponent included."""
    root = ElementTree.fromstring(html)
    for row in [e for e in root.iter() if e.tag in _ROWS]:
        for part in [e for e in row if _named(e[0] if e.tag in _SCRIPTED else e)]:
            at = list(row).index(part)
            if at + 1 < len(row) and row[at + 1].text != "(":
                row.insert(at + 1, _thin())
            if at and (row[at - 1].tag in _ENDS or row[at - 1].text == ")"):
                row.insert(at, _thin())
    for mark in root.iter(f"{{{_MATHML}}}mo"):
        if mark.get("form") == _FORMS.get(mark.text or ""):
            mark.attrib.pop("form", None)
    # a page of HTML knows what math is, and a tenth of the site were these words
    return ElementTree.tostring(root, encoding="unicode").replace(f' xmlns="{_MATHML}"', "", 1)


def _named(part: ElementTree.Element) -> bool:
    """Whether this is the name of a function and the sign, of no width, that it is applied."""
    return len(part) == 2 and part[1].text == "\u2061"


def _thin() -> ElementTree.Element:
    return ElementTree.Element(f"{{{_MATHML}}}mspace", width="0.167em")


def key(tex: str, alone: bool) -> str:
    """A formula as it is looked up."""
    return f"{'$$' if alone else '$'}{tex}"


def _style(alone: bool) -> str:
    return "DisplayMath" if alone else "InlineMath"


def pandoc() -> str:
    """The program."""
    import pypandoc

    return str(pypandoc.get_pandoc_path())


# -- for Sphinx ---------------------------------------------------------------------------


def _known(writer: Any) -> Mapping[str, str]:
    found: Mapping[str, str] = writer.config.symhaptic_formulas
    return found


def _visit(writer: Any, node: nodes.math) -> None:
    writer.body.append(_known(writer)[key(node.astext(), False)])
    raise nodes.SkipNode


def _visit_block(writer: Any, node: nodes.math_block) -> None:
    writer.body.append(f'<div class="math">{_known(writer)[key(node.astext(), True)]}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Sphinx's entry: formulas are looked up, none is turned while pages are written."""
    known = json.loads((Path(app.srcdir) / FORMULAS).read_text(encoding="utf-8"))
    app.add_config_value("symhaptic_formulas", known, "")
    app.add_html_math_renderer("mathml", (_visit, None), (_visit_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
