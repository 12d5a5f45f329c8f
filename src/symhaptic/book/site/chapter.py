"""One chapter as a page of the site: prose, steps with their proofs beside, printed forms."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from sympy import Basic

from symhaptic.book.chapters import Chapter
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.evidence import evidence
from symhaptic.book.foreign import LEAVES, NOT, WHOLE, Checked, checked
from symhaptic.book.record import Block, Settled
from symhaptic.book.rests import Said, Shown, rests
from symhaptic.book.rules import called
from symhaptic.book.site.reference import PUBLIC
from symhaptic.book.site.words import (
    breakable,
    container,
    display,
    heading,
    math,
    plain,
    table,
    words,
)
from symhaptic.book.sources import PAPER, source_of
from symhaptic.book.tex.errata import WRONG
from symhaptic.book.tex.forms import shown_by
from symhaptic.book.tex.page import rows_of
from symhaptic.book.tex.words import anchor, as_sentence, place_of
from symhaptic.forms.stable import STATEMENTS
from symhaptic.notation.latex import latex
from symhaptic.paper.statement import Statement
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.verdict import Kind, Verdict


@dataclass(frozen=True)
class Place:
    """What a page has to know of the others."""

    number: int
    shown: Mapping[Said, Shown]
    whole: bool = True
    """Whether there are errata and the reference, with all chapters."""
    names: Mapping[int, str] = field(default_factory=dict)
    """Name of the page of each chapter."""
    edges: Mapping[int, frozenset[int]] = field(default_factory=dict)
    """For each chapter those whose theorems it applies."""
    settled: frozenset[str] = frozenset()
    """Ids of the statements that have a place on the site."""
    mentioned: Mapping[str, frozenset[int]] = field(default_factory=dict)
    """For the label of a chapter or a statement those chapters whose words mention it."""


def chapter_page(chapter: Chapter, place: Place) -> str:
    """reStructuredText of a chapter."""
    page = chapter.page
    out = [":hide-toc:", "", f".. _chapter-{chapter.name}:", ""]
    out += heading(f"{place.number}. {words(chapter.title)}")
    code = f":download:`{chapter.source} <code/{chapter.path.name}>`"
    out += container("source", [". ".join([f"Code: {code}", *_neighbours(place)]) + "."])
    out += _paragraphs(chapter.introduction)
    out += _answer(chapter, place)
    steps = 0
    for block in page.blocks:
        if block.kind == "prose":
            out += _paragraphs(block.text)
        elif block.kind == "equation":
            steps += 1
            out += _equation(block, f"Step {steps}", place)
        elif block.kind == "theorem":
            steps += 1
            out += _theorem(block, f"Step {steps}", place)
        elif block.kind == "table":
            out += _table(block)
        elif block.kind == "figure":
            out += _figure(block)
    if page.settled:
        out += heading("The printed forms beside it", "-")
        for item in page.settled.values():
            out += _printed(item, place)
    return "\n".join(out) + "\n"


def _neighbours(place: Place) -> list[str]:
    """The chapters whose theorems are applied, and those that apply theorems of this one."""
    below = place.edges.get(place.number, frozenset())
    above = {number for number, under in place.edges.items() if place.number in under}
    told = place.mentioned.get(f"chapter-{place.names[place.number]}", frozenset())
    found = [
        ("Applies theorems of", below),
        ("Its theorems are applied in", above),
        ("Also mentioned in", told - above),
    ]
    return [f"{words} {_chapters(numbers, place)}" for words, numbers in found if numbers]


def _chapters(numbers: Collection[int], place: Place) -> str:
    links = (f":doc:`{number} <{place.names[number]}>`" for number in sorted(numbers))
    return f"chapter{'s' * (len(numbers) > 1)} {', '.join(links)}"


def _paragraphs(text: str) -> list[str]:
    return [line for part in re.split(r"\n\s*\n", text) for line in (words(part), "")]


def _title(lead: str, title: str, label: str) -> list[str]:
    return [f".. _{label}:", "", f".. rubric:: {lead}. {words(title)}", ""]


def _equation(block: Block, lead: str, place: Place) -> list[str]:
    label = f"equation-{place.number}-{block.number}"
    paper = f" — paper {_paper(block.paper, place)}" if block.paper else ""
    said = _said(block.verdict, f"({place.number}.{block.number})", words(block.method), paper)
    reason = [words(as_sentence(block.text)), ""] if block.text else []
    formula = container(
        "formula boxed" if block.boxed else "formula", display(rows_of(block.lines))
    )
    return [
        *_title(lead, block.title, label),
        *container("step", [*reason, *formula, *said]),
    ]


def _paper(number: str, place: Place) -> str:
    """The number of an equation of the paper, which leads to where it is settled."""
    id = f"eq{number}"
    return f":ref:`({number}) <statement-{id}>`" if id in place.settled else plain(f"({number})")


def _theorem(block: Block, lead: str, place: Place) -> list[str]:
    reason = [words(as_sentence(block.text)), ""] if block.text else []
    number = f"{place.number}.{block.number}"
    if block.boxed:
        back = [*reason, f"This is :ref:`the theorem ({number}) <theorem-{number}>`.", ""]
        return [f".. rubric:: {lead}. {words(block.title)}", "", *back]
    return [
        *_title(lead, block.title, f"theorem-{number}"),
        *container("step", [*reason, *_claimed(block, place)]),
    ]


def _claimed(block: Block, place: Place) -> list[str]:
    """A theorem with what it rests on."""
    given, then = block.said
    let = "\\ , ".join(map(breakable, given))
    says = f"Let {let}\\ . Then {breakable(then)}\\ ." if given else f"{breakable(then)}\\ ."
    method = words(block.method)
    if block.theorem is not None:
        method += by([block.theorem], place.shown)
    kind = "claim boxed" if block.boxed else "claim"
    number = f"({place.number}.{block.number})"
    numbers = evidence(block.theorem, place.shown) if block.theorem is not None else ""
    beside = container("numbers", [words(as_sentence(numbers))]) if numbers else []
    return [*container(kind, [says]), *beside, *_said(block.verdict, number, method)]


def _answer(chapter: Chapter, place: Place) -> list[str]:
    """What the chapter finds: its boxed theorem, or its statements in words."""
    boxed = [b for b in chapter.page.blocks if b.kind == "theorem" and b.boxed]
    out: list[str] = []
    for block in boxed:
        label = f"theorem-{place.number}.{block.number}"
        out += _title("Theorem", block.title, label) + container("step", _claimed(block, place))
    if boxed:
        return out
    found = [s for s in chapter.page.settled.values() if s.verdict.kind is not Kind.DEFINITION]
    rows = [f"* {statement_link(s.statement.id)} {_in_short(s)}" for s in found]
    return container("answer", ["**In short.**", "", *rows]) if rows else []


def _in_short(item: Settled) -> str:
    verdict = item.verdict
    says = words(item.statement.says)
    if verdict.kind is Kind.QUALIFIED:
        says += f", for {math(verdict.condition or '')}\\ "
    return f"{says}: {kind(verdict.kind)}"


def _said(verdict: str, number: str, method: str, more: str = "") -> list[str]:
    return container("verdict", [f"{kind(verdict)} {number}{more}", "", method or ""])


def kind(verdict: str) -> str:
    """A verdict in its colour."""
    return f":kind-{verdict}:`{verdict}`"


def statement_link(id: str) -> str:
    """The id of a statement, which leads to where it is settled."""
    return f":ref:`{_link_text(id)} <statement-{place_of(id)}>`"


def by(theorems: Sequence[Theorem], shown: Mapping[Said, Shown]) -> str:
    """What theorems rest on: others of the site, and classical rules by name."""
    found = rests(theorems, shown)
    places = [f":ref:`({one.place}) <theorem-{one.place}>`" for one in found.shown]
    names = {called(rule): rule for rule in found.rules}
    rules = [f":ref:`{_link_text(name)} <rule-{anchor(rule)}>`" for name, rule in names.items()]
    return f" by {', '.join([*places, *rules])}" if places or rules else ""


def _foreign(found: Checked) -> list[str]:
    """How far Rocq has checked a statement, why no further, and on what this rests."""
    if found == Checked():
        return []
    rules = [f":ref:`{_link_text(called(r))} <rule-{anchor(r)}>`" for r in found.rules]
    why = f" ({plain(found.why)})" if found.why else ""
    by = f", by {', '.join([*rules, *map(plain, found.others)])}" if found.rests else ""
    extent = {WHOLE: "whole", LEAVES: "in part", NOT: "not"}[found.extent]
    return [f"*Rocq:* {extent}{why}{by}", ""]


def _link_text(name: str) -> str:
    return name.replace("<", "less than").replace("`", "'")


def _printed(item: Settled, place: Place) -> list[str]:
    """A statement of the paper as printed, what it claims, its verdict and what is right."""
    statement, verdict = item.statement, item.verdict
    out = [
        f"**{plain(statement.id)}** — {words(statement.location)}",
        "",
        *statement_in_words(statement),
    ]
    if verdict.proposition:
        out += container("claim", [f"Claims {breakable(verdict.proposition)}\\ ."])
    if verdict.condition:
        out += [f"Right for {math(verdict.condition)}\\ .", ""]
    right = _right(verdict)
    if right:
        out += ["Right is:", "", *right]
    consequence = CONSEQUENCES.get(statement.id)
    if consequence:
        out += [f"*For a device:* {words(consequence)}", ""]
    if place.whole and source_of(statement.id) is PAPER and verdict.kind in WRONG:
        out += [f":ref:`In the errata <erratum-{statement.id}>`", ""]
    names = [name for name, ids in STATEMENTS.items() if statement.id in ids]
    if place.whole and names:
        functions = ", ".join(f":func:`~symhaptic.{name}`" for name in names if name in PUBLIC)
        out += [f"Computed by {functions}.", ""] if functions else []
    label = f"statement-{place_of(statement.id)}"
    if label in place.mentioned:
        out += [f"Mentioned in {_chapters(place.mentioned[label], place)}.", ""]
    judged = item.settlement.judged
    ground = "a theorem" + by([judged.theorem], place.shown) if judged else words(verdict.method)
    shows = [words(text) for text in shown_by(verdict)]
    said = "; ".join([ground, *shows])
    foreign = checked(statement.id, judged) if judged else Checked()
    out += container("verdict", [kind(verdict.kind), "", said, "", *_foreign(foreign)])
    return [f".. _{label}:", "", *container("statement", out)]


def statement_in_words(statement: Statement) -> list[str]:
    """The source's own words, its formula, and our reading of them, in this order."""
    out = [f"“{words(statement.quote)}”", ""] if statement.quote else []
    if statement.latex:
        out += display([f"&{line}" for line in statement.latex])
    if statement.domain:
        out += [math(statement.domain), ""]
    label = "*Read as:* " if statement.quote and not statement.latex else ""
    return [*out, f"{label}{words(statement.says)}", ""]


def _right(verdict: Verdict) -> list[str]:
    """The right form where the printed one is wrong."""
    if verdict.corrected is not None:
        return display([f"&{part}" for part in verdict.corrected.split(r",\quad ")])
    return []


def in_words(verdict: Verdict) -> str:
    """What is right, in one line."""
    if verdict.kind is Kind.QUALIFIED:
        return f"for {math(verdict.condition or '')}"
    if verdict.corrected is not None:
        return math(verdict.corrected)
    return words(verdict.shows or "")


def _table(block: Block) -> list[str]:
    rows = [[_cell(cell) for cell in row] for row in block.rows]
    return [*table("numbers", rows), words(block.text), ""]


def _cell(cell: object) -> str:
    return (
        words(cell)
        if isinstance(cell, str)
        else math(latex(cell))
        if isinstance(cell, Basic)
        else plain(str(cell))
    )


def _figure(block: Block) -> list[str]:
    alt = " ".join(re.sub(r"[$\\{}]", "", block.text).split())
    return [
        f".. figure:: figures/{block.title}.svg",
        f"   :alt: {alt}",
        "",
        f"   {words(block.text)}",
        "",
    ]
