"""One chapter as a page: prose, steps with their proofs beside, published forms."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from docutils import nodes
from docutils.nodes import Node
from sympy import Symbol

from symhaptic.book.chapters import Chapter
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.evidence import evidence
from symhaptic.book.foreign import LEAVES, NOT, WHOLE, Checked, checked
from symhaptic.book.record import Block, Settled
from symhaptic.book.report import tree
from symhaptic.book.report.breaking import parted, rows_of
from symhaptic.book.report.stated import stated
from symhaptic.book.report.tree import (
    Part,
    as_sentence,
    container,
    display,
    emphasis,
    kind,
    led,
    listed,
    math,
    only,
    paragraph,
    paragraphs,
    rubric,
    section,
    strong,
    words,
)
from symhaptic.book.rests import Said, Shown, rests
from symhaptic.book.rules import called
from symhaptic.book.sources import PAPER, source_of
from symhaptic.forms.stable import STATEMENTS
from symhaptic.notation.latex import latex
from symhaptic.paper.statement import Statement
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.proof.verdict import Kind, Verdict

WRONG = frozenset({Kind.REFUTED, Kind.MISPRINT, Kind.QUALIFIED, Kind.SLIP})
"""Verdicts of what the errata list."""


@dataclass(frozen=True)
class Place:
    """What a page has to know of the others; all but the first two are for the site."""

    number: int
    shown: Mapping[Said, Shown]
    whole: bool = False
    """Whether there are errata and the reference, with all chapters."""
    names: Mapping[int, str] = field(default_factory=dict)
    """Name of the page of each chapter."""
    edges: Mapping[int, frozenset[int]] = field(default_factory=dict)
    """For each chapter those whose theorems it applies."""
    settled: frozenset[str] = frozenset()
    """Ids of the statements that have a place on the site."""
    mentioned: Mapping[str, frozenset[int]] = field(default_factory=dict)
    """For the label of a chapter or a statement those chapters whose words mention it."""
    public: frozenset[str] = frozenset()
    """Names that the reference has."""

    def of(self, number: int) -> Place:
        """What the page of this number has to know."""
        return replace(self, number=number)


def page(chapter: Chapter, place: Place) -> nodes.section:
    """Return a chapter as a tree."""
    blocks: list[Node] = [
        *only("site", _source(chapter, place)),
        *paragraphs(chapter.introduction),
        *_answer(chapter, place),
    ]
    steps = 0
    for block in chapter.page.blocks:
        if block.kind in ("equation", "theorem"):
            steps += 1
        blocks += _BLOCKS[block.kind](block, f"Step {steps}. ", place)
    if chapter.page.settled:
        forms = (_printed(item, place) for item in chapter.page.settled.values())
        blocks.append(section("The published statements", *forms))
    return section(
        [f"{place.number}. ", words(chapter.title)],
        *blocks,
        to="chapter",
        at=chapter.name,
        number=place.number,
        code=chapter.source,
    )


def _source(chapter: Chapter, place: Place) -> nodes.container:
    """The code, the chapters whose theorems are applied, and those that apply theorems of this."""
    below = place.edges.get(place.number, frozenset())
    above = {number for number, under in place.edges.items() if place.number in under}
    told = place.mentioned.get(tree.label("chapter", chapter.name), frozenset())
    code = led("code", chapter.path.name, chapter.source)
    parts: list[Part] = ["Code: ", code]
    for said, numbers in (
        (". Applies theorems of ", below),
        (". Its theorems are applied in ", above),
        (". Also mentioned in ", told - above),
    ):
        parts += [said, _chapters(numbers, place)] if numbers else []
    return container("source", paragraph(*parts, "."))


def _chapters(numbers: Collection[int], place: Place) -> list[Node]:
    links = listed(led("chapter", place.names[n], str(n)) for n in sorted(numbers))
    return tree.flat([f"chapter{'s' * (len(numbers) > 1)} ", *links])


# -- blocks ---------------------------------------------------------------------------


def _prose(block: Block, lead: str, place: Place) -> list[Node]:
    return paragraphs(block.text)


def _equation(block: Block, lead: str, place: Place) -> list[Node]:
    id = f"eq{block.paper}"
    paper: Part = f"({block.paper})"
    if id in place.settled:
        paper = led("statement", id, paper)
    kinds = "formula boxed" if block.boxed else "formula"
    return [
        rubric(lead, words(block.title), to="equation", at=f"{place.number}-{block.number}"),
        container(
            "step",
            *_reason(block),
            container(kinds, display(rows_of(block.lines), aligned=True)),
            _verdict(block, place, words(block.method), paper if block.paper else ""),
        ),
    ]


def _reason(block: Block) -> list[Node]:
    return [paragraph(words(as_sentence(block.text)))] if block.text else []


def _verdict(block: Block, place: Place, method: Part, paper: Part = "") -> nodes.container:
    """The verdict on a step beside it, with its number and how it is proved."""
    number = f"{place.number}.{block.number}"
    head = paragraph(kind(block.verdict), f" ({number})", [" — paper ", paper] if paper else "")
    given = {"verdict": block.verdict, "number": number, "paper": block.paper}
    return container("verdict", head, *([paragraph(method)] if method else []), **given)


def _theorem(block: Block, lead: str, place: Place) -> list[Node]:
    """A theorem; of the chapter's, which stands at its head, only the reason is left to say."""
    number = f"{place.number}.{block.number}"
    title: list[Part] = [lead, words(block.title)]
    if block.boxed:
        reason = [words(as_sentence(block.text)), " "] if block.text else []
        link = led("theorem", number, f"the theorem ({number})")
        return [rubric(title), paragraph(reason, "This is ", link, ".")]
    return [
        rubric(title, to="theorem", at=number),
        container("step", *_reason(block), *_claimed(block, place)),
    ]


def _claimed(block: Block, place: Place) -> list[Node]:
    """A theorem with what it rests on: in formulas where a reader follows them, and formally."""
    out: list[Node] = []
    method: Part = words(block.method)
    numbers: list[Node] = []
    if block.theorem is not None:
        out = _in_formulas(block.theorem, block.boxed)
        method = by([block.theorem], place.shown, "by ") or method
        told = evidence(block.theorem, place.shown)
        numbers = [container("numbers", paragraph(words(as_sentence(told))))] if told else []
    given, then = block.said
    said: list[Part] = [math(then), "."]
    if given:
        said = ["Let ", *listed(map(math, given)), ". Then ", *said]
    formal = only("site", container("claim", paragraph(said)))
    return [*out, *formal, *numbers, _verdict(block, place, method)]


def _in_formulas(theorem: Theorem, boxed: bool) -> list[Node]:
    """Conditions and conclusion of a theorem; nothing where only a program would read them."""
    found = stated(theorem)
    if found is None:
        return []
    given = listed(map(math, found.given))
    out: list[Node] = []
    if found.let:
        lead: Part = ["Let ", given, " and"] if given else "Let"
        out = [paragraph(lead), container("formula", display(found.let, aligned=True))]
    if lead := "Then" if found.let else ["For ", given, ":"] if given else "":
        out.append(paragraph(lead))
    shown = display(found.then, aligned=True)
    return [*out, container("formula boxed" if boxed else "formula", shown)]


def by(
    theorems: Sequence[Theorem], shown: Mapping[Said, Shown], before: str = " by "
) -> list[Part]:
    """What theorems rest on: others on the pages by number, and classical rules by name."""
    found = rests(theorems, shown)
    places = [led("theorem", one.place, f"({one.place})") for one in found.shown]
    links = listed([*places, *rules(found.rules)])
    return [before, *links] if links else []


def rules(names: Iterable[str]) -> list[Node]:
    """Links to classical rules, each name once."""
    return [led("rule", rule, name) for name, rule in {called(r): r for r in names}.items()]


def _table(block: Block, lead: str, place: Place) -> list[Node]:
    rows = [[_cell(cell) for cell in row] for row in block.rows]
    return [container("tabled", tree.table("numbers", rows), paragraph(words(block.text)))]


def _cell(cell: Any) -> Part:
    return words(cell) if isinstance(cell, str) else math(latex(cell))


def _figure(block: Block, lead: str, place: Place) -> list[Node]:
    alt = " ".join(re.sub(r"[$\\{}]", "", block.text).split())
    return [tree.figure(block.title, alt, words(block.text))]


_BLOCKS = {
    "prose": _prose,
    "equation": _equation,
    "theorem": _theorem,
    "table": _table,
    "figure": _figure,
}


def _answer(chapter: Chapter, place: Place) -> list[Node]:
    """What the chapter finds: its boxed theorem, or its statements in words."""
    out: list[Node] = []
    for block in chapter.page.blocks:
        if block.kind == "theorem" and block.boxed:
            at = f"{place.number}.{block.number}"
            out.append(rubric("Theorem. ", words(block.title), to="theorem", at=at))
            out.append(container("step", *_claimed(block, place)))
    if out:
        return out
    settled = chapter.page.settled.values()
    found = [_in_short(s) for s in settled if s.verdict.kind is not Kind.DEFINITION]
    items = (nodes.list_item("", one) for one in found)
    answers = nodes.bullet_list("", *items)
    return [container("answer", paragraph(strong("In short.")), answers)] if found else []


def _in_short(item: Settled) -> nodes.paragraph:
    verdict = item.verdict
    right = [", for ", condition(verdict)] if verdict.kind is Kind.QUALIFIED else []
    place = referred(item.statement.id)
    return paragraph(place, " ", words(item.statement.says), right, ": ", kind(verdict.kind))


# -- statements -----------------------------------------------------------------------

_NUMBERED = re.compile(r"(eq|tab)(\d+)")
"""The ids of the paper's equations and tables."""


def reference(id: str) -> str:
    """The number of an equation or table, or the id of another statement."""
    if number := _NUMBERED.fullmatch(id):
        return f"({number[2]})" if number[1] == "eq" else f"Table {'I' * int(number[2])}"
    return id


def referred(id: str) -> tree.Link:
    """A link to where a statement is settled."""
    return led("statement", id, reference(id))


def _printed(item: Settled, place: Place) -> nodes.container:
    """A statement of the paper as published, what it claims, its verdict and what is right."""
    statement, verdict = item.statement, item.verdict
    id = statement.id
    head = paragraph(strong(id), " — ", words(statement.location))
    out = [*only("site", head), *in_words(statement), *claimed(verdict)]
    if verdict.condition:
        out.append(paragraph("Right for ", condition(verdict), "."))
    out += corrected(verdict, "Right is:")
    notes: list[nodes.paragraph] = []
    if id in CONSEQUENCES:
        notes.append(paragraph(emphasis("For a device:"), " ", words(CONSEQUENCES[id])))
    if place.whole and source_of(id) is PAPER and verdict.kind in WRONG:
        notes.append(paragraph(led("erratum", id, "In the errata")))
    names = [name for name, ids in STATEMENTS.items() if id in ids and name in place.public]
    if names:
        functions = listed(led("function", name, nodes.literal("", name)) for name in names)
        notes.append(paragraph("Computed by ", functions, "."))
    mentioned = place.mentioned.get(tree.label("statement", id))
    if mentioned:
        notes.append(paragraph("Mentioned in ", _chapters(mentioned, place), "."))
    said = [kind(verdict.kind)]
    beside = container("verdict", paragraph(said), *_shown_by(verdict), *_grounds(item, place))
    return container("statement", *out, *only("site", *notes), beside, to="statement", at=id, id=id)


def claimed(verdict: Verdict) -> list[Node]:
    """What a statement claims, formally: for the site."""
    if not verdict.proposition:
        return []
    return only("site", container("claim", paragraph("Claims ", math(verdict.proposition), ".")))


def _shown_by(verdict: Verdict) -> list[Node]:
    found = shown_by(verdict)
    if verdict.kind is Kind.EXTERNAL:
        found.insert(0, words(verdict.method))
    if verdict.value and verdict.kind in (Kind.ENCLOSED, Kind.QUALIFIED):
        found.insert(0, math(verdict.value[:14] + r"\ldots"))
    return [paragraph(listed(found, "; "), classes=["shows"])] if found else []


def _grounds(item: Settled, place: Place) -> list[Node]:
    """What the verdict on a statement rests on, and how far Rocq has checked that."""
    judged = item.settlement.judged
    if judged is None:
        other = item.verdict.kind is not Kind.EXTERNAL
        return only("site", paragraph(words(item.verdict.method))) if other else []
    shown = by([judged.theorem], place.shown, "by ") or "a theorem of the kernel"
    ground = paragraph(shown, classes=["ground"])
    return [ground, *_foreign(checked(item.statement.id, judged))]


def _foreign(found: Checked) -> list[Node]:
    """How far Rocq has checked a statement, why no further, and on what this rests."""
    if found == Checked():
        return []
    extent = {WHOLE: "whole", LEAVES: "in part", NOT: "not"}[found.extent]
    why = f" ({found.why})" if found.why else ""
    links = listed([*rules(found.rules), *found.others])
    rest = [", by ", *links] if links else []
    ground = paragraph(emphasis("Rocq:"), f" {extent}{why}", rest, classes=["ground"])
    return only("site", ground) if found.extent == NOT else [ground]


def in_words(statement: Statement) -> list[Node]:
    """The source's own words, its formula, and our reading of them, in this order."""
    out: list[Node] = []
    if statement.quote:
        out.append(paragraph("“", words(statement.quote), "”"))
    if statement.latex:
        out.append(display(statement.latex))
    if statement.domain:
        out.append(paragraph(math(statement.domain), classes=["domain"]))
    label = [emphasis("Read as:"), " "] if statement.quote and not statement.latex else []
    kinds = ["reading"] if statement.quote else []
    return [*out, paragraph(label, words(statement.says), classes=kinds)]


def condition(verdict: Verdict) -> list[Node]:
    """A condition as running text, which can be broken between its parts."""
    parts = parted(verdict.condition or "", r"\\ \\text\{and\}\\ ")
    each = [listed(map(math, parted(part, r",\\ ", "{}()"))) for part in parts]
    return tree.flat(listed(each, " and "))


def corrected(verdict: Verdict, lead: str) -> list[Node]:
    """What is right where the print is wrong: a formula, or words."""
    if verdict.corrected is None:
        return []
    if r"\text" in verdict.corrected:
        return [paragraph(emphasis(lead), " ", words(formula_in_words(verdict.corrected)))]
    return [paragraph(emphasis(lead)), display(verdict.corrected.split(r",\quad "))]


def formula_in_words(tex: str) -> str:
    r"""A formula with words in it as prose.

    >>> formula_in_words(r"\text{at}\ x=1,\quad \text{and}\ y")
    'at $x=1$, and $y$'
    """
    tex = tex.replace(r",\quad ", r",\ ")
    found = re.sub(r"(,?)(?:\\ )*\\text\{([^{}]*)\}(?:\\ )*", r"$\1 \2 $", tex)
    return " ".join(f"${found}$".replace("$$", "").split())


def shown_by(verdict: Verdict) -> list[Part]:
    """What happens at the counterexample, or where it is, and what else is to be said."""
    found: list[Part] = []
    if verdict.shows:
        found.append(words(verdict.shows))
    elif verdict.counterexample:
        given = verdict.counterexample.items()
        at = ",\\ ".join(f"{latex(Symbol(name))}={value}" for name, value in given)
        found.append(["differs at ", math(at)])
    if verdict.note:
        found.append(words(verdict.note))
    return found
