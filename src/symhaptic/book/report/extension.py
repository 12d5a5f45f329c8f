"""What Sphinx loads for the site: pages that are trees, MathML, links to what is mentioned.

All formulas are turned by one run of pandoc, when all pages are read and none is written.  Pandoc
and not a script of the browser: what it writes needs no network and no script, it is read by
screen readers, and it keeps the LaTeX beside each formula, to be copied.
"""

from __future__ import annotations

import json
import pickle
import re
import subprocess
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias
from xml.etree import ElementTree

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.environment.adapters.toctree import global_toctree_for_doc
from sphinx.transforms import SphinxTransform
from sphinx.util.docutils import SphinxDirective

from symhaptic.book.report import reference
from symhaptic.book.report.breaking import displayed, formula, narrow
from symhaptic.book.report.guides import pandoc
from symhaptic.book.report.mentions import mentions
from symhaptic.book.report.place import ReportError
from symhaptic.book.report.tree import Link, label

TREES = "trees.pickle"
"""Where the sources keep the pages that are trees, by their names, and the places of mentions."""


@dataclass(frozen=True)
class Kept:
    """The trees by their names, the labels of what may be mentioned, and all labels."""

    trees: dict[str, nodes.section]
    places: dict[str, str]
    labels: frozenset[str]


@cache
def kept(folder: str) -> Kept:
    """What the sources keep for all pages."""
    trees, places = pickle.loads((Path(folder) / TREES).read_bytes())
    elements = (node for tree in trees.values() for node in tree.findall(nodes.Element))
    found = (n for n in elements if "to" in n and not isinstance(n, Link))
    return Kept(trees, places, frozenset(label(node["to"], node["at"]) for node in found))


FOLDED = "<details><summary>Formal proposition</summary>", "</details>"
"""What a formal proposition stands between: a reader opens it."""

_AS_TYPED = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.raw)


class Tree(SphinxDirective):
    """Puts a tree into a page: what it says is never read as markup."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The tree, with its places known to Sphinx and its links to be resolved by it."""
        known = kept(str(self.env.srcdir))
        found = nodes.container("", known.trees[self.arguments[0]])
        for node in list(found.findall(nodes.Element)):
            if node.get("only") == "print":
                node.parent.remove(node)
            elif "claim" in node["classes"]:
                ends = (nodes.raw("", end, format="html") for end in FOLDED)
                node[:] = [next(ends), *node, next(ends)]
            elif isinstance(node, Link):
                node.replace_self(self._led(node, known.labels))
            elif "to" in node:
                node["names"].append(label(node["to"], node["at"]))
                self.state.document.note_explicit_target(node, node)
            elif isinstance(node, nodes.section):
                node["names"].append(nodes.fully_normalize_name(node[0].astext()))
                self.state.document.note_implicit_target(node, node)
        for text in list(found.findall(nodes.Text)):
            if not isinstance(text.parent, _AS_TYPED):  # or quotes that are made curly cost them
                text.parent.replace(text, nodes.Text(text.replace("\\", "\0\\")))
        return list(found.children)

    def _led(self, node: Link, known: frozenset[str]) -> list[nodes.Node]:
        """A link for Sphinx, or the words alone where this site has no such place."""
        to, at, doc = node["to"], node["at"], self.env.docname
        if to == "code":
            code = nodes.literal("", "", *node.children, classes=["xref", "download"])
            return [addnodes.download_reference("", "", code, reftarget=f"code/{at}", refdoc=doc)]
        given: dict[str, Any] = {"refdomain": "std", "reftype": "ref", "reftarget": label(to, at)}
        if to == "function":
            given = {"refdomain": "py", "reftype": "func", "reftarget": f"symhaptic.{at}"}
        elif to == "page":
            given = {"refdomain": "std", "reftype": "doc", "reftarget": f"/{at}"}
        elif label(to, at) not in known:
            return list(node.children)
        inner = nodes.inline("", "", *node.children, classes=["std", "std-ref"])
        given |= {"refdoc": doc, "refexplicit": bool(node.children), "refwarn": True}
        return [addnodes.pending_xref("", inner, **given)]


# -- what is mentioned ----------------------------------------------------------------

_LEFT_ALONE = (
    *(nodes.title, nodes.strong, nodes.reference, nodes.literal, nodes.literal_block),
    *(nodes.math, nodes.raw),
    *(nodes.math_block, nodes.comment, nodes.image, addnodes.pending_xref),
    *(addnodes.download_reference, addnodes.desc_signature),
)


class Mentions(SphinxTransform):
    """Parts the text of a page where it mentions what has a place."""

    default_priority = 600

    def apply(self, **_: Any) -> None:
        """Of the page that has been read."""
        known = kept(str(self.env.srcdir)).places
        for text in list(self.document.findall(nodes.Text)):
            if not any(isinstance(above, _LEFT_ALONE) for above in _above(text)):
                spans = list(mentions(str(text), known))
                done, parts = 0, list[nodes.Node]()
                for start, end, place in spans:
                    parts += [nodes.Text(text[done:start]), self._link(text[start:end], place)]
                    done = end
                if spans:
                    text.parent.replace(text, [*parts, nodes.Text(text[done:])])

    def _link(self, shown: str, place: str) -> nodes.Node:
        how = {"refdomain": "std", "reftype": "ref", "reftarget": place, "refexplicit": True}
        inner = nodes.inline(shown, shown)
        return addnodes.pending_xref("", inner, refdoc=self.env.docname, refwarn=True, **how)


def _above(node: nodes.Node) -> Iterator[nodes.Node]:
    while node.parent is not None:
        node = node.parent
        yield node


# -- formulas -------------------------------------------------------------------------

Formula: TypeAlias = tuple[str, bool]
"""LaTeX, and whether it stands by itself."""

_MADE: dict[Formula, str] = {}
"""MathML of each formula of the site."""


def _turn_all(app: Sphinx, env: Any) -> list[str]:
    """Turn all formulas of all pages."""
    wanted: set[Formula] = set()
    for name in env.found_docs:
        tree = env.get_doctree(name)
        wanted |= {(p, False) for m in tree.findall(nodes.math) for p in _pieces(m)}
        wanted |= {(_display(m), True) for m in tree.findall(nodes.math_block)}
    _MADE.update(turned(wanted))
    return []


def _pieces(node: nodes.math) -> list[str]:
    return [piece for word in narrow(node.astext()) for piece in word]


def _display(node: nodes.math_block) -> str:
    if "rows" in node:
        return displayed(node["rows"], node["aligned"])
    return formula(node.astext())


def turned(wanted: Iterable[Formula]) -> dict[Formula, str]:
    """MathML of each formula, by pandoc."""
    listed = sorted(wanted)
    styles = {False: {"t": "InlineMath"}, True: {"t": "DisplayMath"}}
    blocks = [
        {"t": "Para", "c": [{"t": "Math", "c": [styles[alone], tex]}]} for tex, alone in listed
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
    return dict(zip(listed, map(spaced, made), strict=True))


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
    # HTML knows what math is, and this attribute would make up a tenth of the site
    return ElementTree.tostring(root, encoding="unicode").replace(f' xmlns="{_MATHML}"', "", 1)


def _named(part: ElementTree.Element) -> bool:
    """Whether this is the name of a function and the sign, of no width, that it is applied."""
    return len(part) == 2 and part[1].text == "\u2061"


def _thin() -> ElementTree.Element:
    return ElementTree.Element(f"{{{_MATHML}}}mspace", width="0.167em")


def _visit(writer: Any, node: nodes.math) -> None:
    """A formula in pieces, between which a line may end."""
    shown = ("\u200b".join(_MADE[p, False] for p in word) for word in narrow(node.astext()))
    writer.body.append(" ".join(shown))
    raise nodes.SkipNode


def _visit_block(writer: Any, node: nodes.math_block) -> None:
    writer.body.append(f'<div class="math">{_MADE[_display(node), True]}</div>')
    raise nodes.SkipNode


# -- the list of all pages ------------------------------------------------------------

_ENTRY = '<li class="toctree-l1"><a class="reference internal" href="{}">'
_CURRENT = (
    '<li class="toctree-l1 current current-page"><a class="current reference internal" href="#">'
)
_EARLY, _LATE = 400, 600
"""Before and after the theme, which comes at 500."""


class _Navigation:
    """The list beside each page: made once, since all pages lie in one folder.

    Sphinx would put it together anew for every page, and the theme read it again, which takes
    longer than everything else; only which entry is the page itself differs.
    """

    def __init__(self) -> None:
        self.tree = ""

    def make(self, app: Sphinx, builder: StandaloneHTMLBuilder) -> None:
        """As the index page has it, which does not list itself."""
        tree = global_toctree_for_doc(
            app.env,
            app.config.root_doc,
            builder,
            tags=app.tags,
            titles_only=True,
            maxdepth=-1,
            includehidden=True,
        )
        self.tree = builder.render_partial(tree)["fragment"]

    def give(self, app: Sphinx, page: str, template: str, context: Any, tree: Any) -> None:
        """To the theme."""
        context["toctree"] = lambda **_: self.tree

    def mark(self, app: Sphinx, page: str, template: str, context: Any, tree: Any) -> None:
        """The page itself."""
        entry = _ENTRY.format(app.builder.get_target_uri(page))
        listed = context["furo_navigation_tree"]
        context["furo_navigation_tree"] = listed.replace(entry, _CURRENT)


def setup(app: Sphinx) -> Mapping[str, Any]:
    """Sphinx's entry."""
    navigation = _Navigation()
    app.setup_extension("sphinx.ext.autodoc")
    app.connect("autodoc-process-docstring", reference.processed)
    app.add_directive("tree", Tree)
    app.add_transform(Mentions)
    app.connect("env-updated", _turn_all)
    app.add_html_math_renderer("mathml", (_visit, None), (_visit_block, None))
    app.connect("write-started", navigation.make)
    app.connect("html-page-context", navigation.give, _EARLY)
    app.connect("html-page-context", navigation.mark, _LATE)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
