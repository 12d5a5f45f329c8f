"""The pages beside the chapters: results, errata, ledger, what is believed, what mutants meet.

The choice is made here; formulas, conditions and corrections come from statements and verdicts.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

from docutils import nodes
from docutils.nodes import Node

from symhaptic.book import foreign
from symhaptic.book.chapters import Chapter
from symhaptic.book.consequences import IMPORTANCE
from symhaptic.book.ledger import Entry, counted
from symhaptic.book.plain import in_formulas
from symhaptic.book.report.breaking import width
from symhaptic.book.report.chapter import (
    WRONG,
    by,
    claimed,
    condition,
    corrected,
    formula_in_words,
    in_words,
    referred,
    shown_by,
)
from symhaptic.book.report.tree import (
    Part,
    container,
    display,
    emphasis,
    kind,
    led,
    listed,
    math,
    only,
    paragraph,
    rubric,
    section,
    strong,
    table,
    words,
)
from symhaptic.book.rests import Said, said, shown_in, used
from symhaptic.book.rules import called, classical, others, says
from symhaptic.book.sources import PAPER
from symhaptic.notation import SYMBOLS
from symhaptic.notation.predicates import MEANINGS
from symhaptic.notation.written import defined, written
from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.proof.verdict import UNSETTLED, Kind

Places: TypeAlias = Mapping[str, tuple[int, str]]
"""Number and name of each chapter, by the file that it is derived in."""

USE = (
    ("The largest passive stiffness, and the damping that it takes", ("eq11",)),
    ("Passive or not, at each frequency below $\\pi/T$", ("eq5",)),
    ("The boundary of the passive walls: an arc and a line", ("eq7", "eq8")),
    ("Passive or not in short: without delay, and for light damping", ("eq6", "eq9")),
    ("The boundary of the stable walls, for every device and delay", ("explicit-boundary",)),
    ("Stable or not, by Jury's inequalities", ("jury-inequalities",)),
    ("The linear limit of stability", ("eq24", "eq25")),
    ("Passive walls are stable", ("s5a-subset",)),
    ("With a delay of $(\\ell+\\varepsilon)T$: passive or not", ("fractional-passivity",)),
)
"""What a reader asks, and the statements that answer."""


def _page(name: str, title: Part, *blocks: Node, code: str = "ledger.json") -> nodes.section:
    return section(title, *blocks, to="page", at=name, code=code)


def _columns(*widths: int) -> str:
    """Columns of a table in print by their widths in mm."""
    return "".join(rf">{{\raggedright\arraybackslash}}p{{{width}mm}}" for width in widths)


# -- results and errata ---------------------------------------------------------------


def results(entries: Sequence[Entry], places: Places) -> nodes.section:
    """The formulas to use, each with its condition, and what is wrong in short."""
    found = {entry.statement.id: entry for entry in entries if entry.derivation is not None}
    blocks: list[Node] = [
        paragraph("As published or as corrected, each with the condition under which it is right.")
    ]
    for question, ids in USE:
        answers = [_use(found[id], places) for id in ids if id in found]
        blocks += [rubric(words(question)), *answers] if answers else []
    return _page("results", "The formulas to use", *blocks)


def _use(entry: Entry, places: Places) -> nodes.container:
    """The right form, its condition, and where it is shown."""
    statement, verdict = entry.statement, entry.verdict
    lines: Sequence[str] = statement.latex
    if verdict.corrected is not None:
        lines = verdict.corrected.split(r",\quad ")
    out: list[Node] = [display(lines) if lines else paragraph(words(statement.says))]
    where: list[Part] = []
    if statement.domain and verdict.corrected is None:
        where.append(math(statement.domain))
    if verdict.condition:
        where.append(["for ", condition(verdict)])
    out += [paragraph(listed(where), classes=["domain"])] if where else []
    return _entry(entry, places, "use", *out)


def _entry(entry: Entry, places: Places, to: str, *blocks: Node) -> nodes.container:
    """A statement with its verdict and its chapter beside it."""
    id = entry.statement.id
    beside = [paragraph(kind(entry.verdict.kind)), paragraph(_chapter(entry, places))]
    location = entry.statement.location
    heads = only("site", paragraph(referred(id), " — ", words(location)))
    if to == "erratum":
        heads += only("print", paragraph(words(location), classes=["domain"]))
    beside_ = container("verdict", *beside)
    return container("statement", *heads, *blocks, beside_, to=to, at=id, id=id)


def _chapter(entry: Entry, places: Places) -> Part:
    number, name = places.get(entry.derivation or "", (0, ""))
    return led("chapter", name, f"chapter {number}") if name else ""


AT_HAND = (
    "The source was a text conversion of the accepted manuscript, without its figures. What a "
    "figure shows is known from its caption and from the text alone, and the figures of this book "
    "are drawn anew from the captions. An entry that is marked as possibly of the conversion may "
    "not be in the published paper."
)
"""What the paper was read from."""

OTHERS = "Other entries"
"""What stands in no part of the list of consequences."""


def by_importance(entries: Iterable[Entry]) -> list[tuple[str, list[Entry]]]:
    """The errata of the paper in parts, the gravest first, each with its title."""
    wrong = {e.statement.id: e for e in entries if e.source is PAPER and e.verdict.kind in WRONG}
    parts = [
        (title, [wrong.pop(id) for id in listed_ if id in wrong]) for title, listed_ in IMPORTANCE
    ]
    return [(title, found) for title, found in (*parts, (OTHERS, [*wrong.values()])) if found]


def errata(entries: Sequence[Entry], places: Places) -> nodes.section:
    """What is wrong in the paper, or right only under a condition."""
    parts = by_importance(entries)
    head = ["statement", "read as", "verdict", "what is right", "where"]
    rows: list[list[Part]] = [
        [
            led("erratum", e.statement.id, e.statement.id),
            words(e.statement.says),
            kind(e.verdict.kind),
            _in_short(e),
            words(e.statement.location),
        ]
        for _, found in parts
        for e in found
    ]
    return _page(
        "errata",
        "Errata",
        paragraph(
            "This page lists what is wrong in the paper, or right only under a condition. Each "
            "entry gives the paper's own words or formula, our reading of it, what is right, what "
            "shows it, and what it means for a device. The most serious entries come first. "
            f"{_errors(entries)}."
        ),
        paragraph(AT_HAND),
        table("ledger", [head, *rows], columns=_columns(25, 46, 18, 46, 17)),
        *(section(title, *(_erratum(entry, places) for entry in found)) for title, found in parts),
    )


def _errors(entries: Iterable[Entry]) -> str:
    """How many entries the errata have."""
    kinds = [entry.verdict.kind for entry in entries if entry.source is PAPER]
    wrong = kinds.count(Kind.REFUTED) + kinds.count(Kind.MISPRINT)
    return (
        f"Of {len(kinds)} statements of the paper {wrong} are wrong as they stand, "
        f"{kinds.count(Kind.QUALIFIED)} need a condition that the paper does not give, and "
        f"{kinds.count(Kind.SLIP)} are slips of the text"
    )


WIDE = 14.0
"""Width of a formula in em from which on a table has words or a link instead."""


def _in_short(entry: Entry) -> Part:
    """What is right, in one line."""
    verdict = entry.verdict
    if verdict.kind is Kind.QUALIFIED:
        return ["for ", condition(verdict)]
    right = words(formula_in_words(verdict.corrected or ""))
    if right and all(width(one.astext()) < WIDE for one in right if isinstance(one, nodes.math)):
        return right
    return (
        words(verdict.shows) if verdict.shows else led("erratum", entry.statement.id, "see below")
    )


def _erratum(entry: Entry, places: Places) -> nodes.container:
    """The source's words, its formula and our reading, then what is right and what shows it."""
    statement, verdict = entry.statement, entry.verdict
    out = [*in_words(statement), *claimed(verdict)]
    if verdict.condition:
        out.append(paragraph(emphasis("Right for"), " ", condition(verdict), "."))
    wrong = verdict.kind in (Kind.MISPRINT, Kind.SLIP)
    out += corrected(verdict, "Right:" if wrong else "What holds:")
    if found := shown_by(verdict):
        out.append(paragraph(emphasis("Shown by"), " ", listed(found, "; "), "."))
    if entry.consequence:
        out.append(paragraph(emphasis("For a device:"), " ", words(entry.consequence)))
    return _entry(entry, places, "erratum", *out)


# -- ledger ---------------------------------------------------------------------------


def ledger(entries: Sequence[Entry], places: Places) -> nodes.section:
    """Every statement with its verdict, to be filtered and sorted."""
    head = ["statement", "read as", "verdict", "Rocq", "where", "chapter"]
    rows: list[list[Part]] = []
    for entry in entries:
        number, name = places.get(entry.derivation or "", (0, ""))
        id = entry.statement.id
        rows.append(
            [
                led("statement", id, id) if entry.verdict != UNSETTLED else id,
                words(entry.statement.says),
                kind(entry.verdict.kind),
                entry.rocq.extent if foreign.asked() else "",
                "own finding" if entry.own else words(entry.statement.location),
                led("chapter", name, str(number)) if name else "",
            ]
        )
    told = f"{counted(entries)}. An undecided statement is one that no chapter has settled yet."
    out: list[Node] = [paragraph(told), *_checked(entries)]
    columns = _columns(29, 51, 19, 12, 19, 17)
    out.append(table("ledger", [head, *rows], columns=columns))
    return _page("ledger", "Every statement and its verdict", *out, *_unchecked(entries))


def _checked(entries: Sequence[Entry]) -> list[Node]:
    """What Rocq has checked in all."""
    if not foreign.asked():
        return []
    told = (
        f"{foreign.asked()}, an independent proof assistant, has checked these statements: "
        f"{foreign.counted(entry.rocq for entry in entries)}. A statement that is checked whole "
        "rests on classical rules alone, which its chapter names."
    )
    if foreign.leaves():
        told += f" Of the basic steps in all chapters it has checked {foreign.leaves()}."
    return [paragraph(told)]


def _unchecked(entries: Sequence[Entry]) -> list[Node]:
    """Why it has not checked the others whole."""
    found: dict[str, list[str]] = {}
    for entry in entries:
        if entry.rocq.reason:
            found.setdefault(entry.rocq.reason, []).append(entry.statement.id)
    if not foreign.asked() or not found:
        return []
    reasons = sorted(found.items(), key=lambda item: (-len(item[1]), item[0]))
    told = (
        paragraph(f"{why}: ", listed(nodes.literal("", id) for id in ids)) for why, ids in reasons
    )
    return [section("Why Rocq has not checked the others whole", *told)]


# -- what is believed -----------------------------------------------------------------

TITLES = {"kernel": "Logic: the rules of the kernel", "leaves": "What the deciders know"}
"""Headings of the modules of rules; all others say what predicates mean."""


def believed(entries: Iterable[Entry]) -> nodes.section:
    """The classical rules with their sources, the other rules, and what the predicates mean."""
    counts = used(entry.verdict.rests for entry in entries)
    blocks: list[Node] = [
        paragraph(
            "Only rules make theorems. A verdict is right if these rules are right and if the "
            "statements are transcribed as published. No verdict depends on prose or captions. "
            "Classical theorems are applied and not proved: each is given with its source and "
            "with the number of statements that rest on it."
        )
    ]
    for rule, source in classical().items():
        axiom = AXIOMS.get(rule)
        told = [math(written(axiom.says))] if axiom else plain(says(rule))
        blocks.append(rubric(called(rule), to="rule", at=rule))
        rest = [". ", emphasis("Source:"), " ", plain(source), f". Statements: {counts[rule]}."]
        blocks.append(paragraph(told, rest if axiom else [" ", *rest[1:]]))
    lists: dict[str, list[Node]] = {}
    for module, found in others().items():
        title = TITLES.get(module, "What the predicates mean of walls and devices")
        for name, text in found.items():
            shown = strong(name.replace("_", " "))
            one = paragraph(shown, f" ({counts[name]}) ", plain(text))
            lists.setdefault(title, []).append(one)
    blocks += [section(title, *found) for title, found in lists.items()]
    meant = (paragraph(math(one), " — ", words(says), ".") for one, says in map(defined, MEANINGS))
    blocks.append(section("Predicates, and what they mean", *meant, to="page", at="predicates"))
    return _page("believed", "The trusted base", *blocks, code="proof/theorems")


def symbols() -> list[tuple[nodes.math, str, list[Node]]]:
    """Every symbol of the notation with its unit and what it means."""
    return [
        (math(one.latex), "" if one.unit == "1" else one.unit, plain(one.meaning))
        for one in SYMBOLS.values()
    ]


def plain(text: str) -> list[Node]:
    r"""A docstring's plain words and signs.

    >>> [node.astext() for node in plain("p |- p <= 1")]
    ['p\\vdash p\\le1']
    """
    return words(in_formulas(text.replace("``", "")))


# -- what rests on what ---------------------------------------------------------------


def resting(
    inside: Sequence[tuple[int, Chapter]], chapters: Sequence[tuple[int, Chapter]]
) -> list[nodes.paragraph]:
    """Theorems of some chapters, and the statements that they settle: what these apply."""
    shown, again = shown_in(chapters), _repeated(chapters)
    rows = []
    for number, chapter in inside:
        for one in shown.values():
            if one.chapter == number:
                places = [led("row", place, "") for place in again[said(one.theorem)]]
                link = led("theorem", one.place, f"({one.place})")
                rows.append(paragraph([*places, link], by([one.theorem], shown, ": ")))
        for id, item in chapter.page.settled.items():
            if judged := item.settlement.judged:
                theorems = [judged.theorem, *(case.theorem for case in judged.unless)]
                rows.append(paragraph(referred(id), by(theorems, shown, ": ")))
    return rows


def _repeated(chapters: Sequence[tuple[int, Chapter]]) -> dict[Said, list[str]]:
    """The places of each theorem; of one that stands on several pages the table has the first."""
    found: dict[Said, list[str]] = {}
    for one in chapters:
        for shown in shown_in([one]).values():
            found.setdefault(said(shown.theorem), []).append(shown.place)
    return found


# -- mutants --------------------------------------------------------------------------

KINDS = {
    "formula": "a sign, factor, exponent, index or function of a formula",
    "digit": "a digit of a number, or a sign in print",
    "negated": "a number's print that says the contrary",
    "claim": "a claim with a part changed, left out or turned round",
    "counterexample": "a counterexample left out",
    "grounds": "the example of the hypotheses left out",
}
"""Kinds of change, in the order of the columns."""

TOGETHER = 12
"""So many changes stand in a row of the table: no row is longer than a page."""


def mutants(path: Path) -> nodes.section | None:
    """The committed outcome of `symhaptic mutants`; None where nothing is committed."""
    if not path.is_file():
        return None
    chapters = json.loads(path.read_text(encoding="utf-8"))["chapters"]
    refused: list[list[Part]] = [["refused", *KINDS]]
    stand: list[list[Part]] = [["of", "changed", "why it may stand"]]
    total, surviving = Counter[str](), 0
    for name, record in chapters.items():
        counted_ = [*record["statements"].items(), (f"tables of {name}", record["tables"])]
        for of, counts in counted_:
            total.update(counts)
            if counts:
                refused.append([_code(of), *(str(counts.get(kind, "")) for kind in KINDS)])
        surviving += len(record["survivors"])
        changed: dict[tuple[str, str], list[str]] = {}
        for of, _, change, why in record["survivors"]:
            changed.setdefault((of, why), []).append(change)
        stand += [
            [_code(of), listed(map(_code, some[at : at + TOGETHER]), "; "), words(why or "DEFECT")]
            for (of, why), some in changed.items()
            for at in range(0, len(some), TOGETHER)
        ]
    kinds: list[list[Part]] = [["kind", "refused", "change"]]
    kinds += [[kind, str(total[kind]), meaning] for kind, meaning in KINDS.items()]
    return _page(
        "mutants",
        "What a wrong formula meets",
        paragraph(
            "A wrong formula must have no proof. As a test, every statement of this book and "
            "every number of its tables was changed in one place and given to the same theorems. "
            f"{total.total()} changes were refused. The others are listed below, with the reasons "
            "why they are no errors."
        ),
        table("kinds", kinds, columns="lrl"),
        table("numbers", refused, columns=_columns(46) + "r" * len(KINDS)),
        section(
            "Changes that survive",
            paragraph(
                f"{surviving} changes were not refused. In none of these cases is the checker "
                "wrong: the changed statement is true, too, or it is weaker, or it says the same "
                "in other words, or no counterexample was found."
            ),
            table("survivors", stand, columns=_columns(44, 70, 42)),
        ),
        code="mutants.json",
    )


def _code(text: str) -> nodes.literal:
    """Plain text in a type of its own."""
    return nodes.literal("", text.replace("^", "**"), classes=["table"])
