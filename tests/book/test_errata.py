"""The pages of results, errata and verdicts list what the ledger holds, and nothing else."""

import re
from dataclasses import replace

import pytest
from chapters import chapter
from docutils import nodes

from symhaptic.book.chapters import shipped
from symhaptic.book.consequences import CONSEQUENCES, IMPORTANCE
from symhaptic.book.ledger import ledger, of_chapter
from symhaptic.book.report import pages
from symhaptic.book.report.chapter import Place, page
from symhaptic.book.report.pages import OTHERS, by_importance, errata
from symhaptic.book.sources import PAPER
from symhaptic.paper import STATEMENTS
from symhaptic.proof.verdict import Kind

FEW = {"s3a_undelayed", "s4d_parts_of_the_arm", "s8c_four_masses"}
"""Right under a condition, refuted, and refuted in another source."""
whole = pytest.mark.parametrize(
    "entries", [pytest.param(None, marks=pytest.mark.ci)], indirect=True, scope="module"
)

WRONG = {Kind.QUALIFIED, Kind.MISPRINT, Kind.REFUTED, Kind.SLIP}


@pytest.fixture(
    scope="module", params=[FEW, pytest.param(None, marks=pytest.mark.ci)], ids=["few", "all"]
)
def entries(request):
    asked = (path.stem for path in shipped() if path.stem in (request.param or {path.stem}))
    return ledger(entry for name in asked for entry in of_chapter(chapter(name)))


@pytest.fixture(scope="module")
def chapters(entries):
    return {e.derivation: (i, "x") for i, e in enumerate(entries, 1) if e.derivation}


def listed(entries, chapters):
    found = errata(entries, chapters).findall(nodes.container)
    return [one for one in found if one.get("to") == "erratum"]


def test_each_error_is_listed_once(entries, chapters):
    wrong = [e for e in entries if e.verdict.kind in WRONG and e.source is PAPER]
    assert len(listed(entries, chapters)) == len(wrong)


def test_each_has_what_a_reader_needs(entries, chapters):
    """In this order: the paper's words or formula, the claim, what is right and what shows it."""
    statements = {e.statement.id: e for e in entries}
    for item in listed(entries, chapters):
        _, location, first, *_, last, verdict = item.children
        statement = statements[item["at"]].statement
        assert location.astext() == statements[item["at"]].statement.location
        assert first.astext().startswith("“") or isinstance(first, nodes.math_block)
        assert last.astext().startswith("For a device: ")
        assert verdict.astext().split()[0] in WRONG
        said = item.astext()
        words = ("Claims ", "Right", "What holds:", "Shown by ")
        order = re.findall("|".join(words), said)
        assert order == sorted(order, key=words.index), said
        assert "Shown by " in said
        assert {"Right", "What holds:"} & set(order), said
        shown = [one["rows"] for one in item.findall(nodes.math_block)]
        assert not statement.latex or list(statement.latex) in shown


def test_the_table_of_verdicts_leads_to_what_is_settled(entries, chapters):
    rows = list(pages.ledger(entries, chapters).findall(nodes.row))[1:]
    assert len(rows) == len(entries)
    for entry, row in zip(entries, rows, strict=True):
        number = chapters[entry.derivation][0] if entry.derivation else ""
        assert [cell.astext() for cell in row.children][-1] == str(number)
        links = {
            one["to"] for one in row.findall() if isinstance(one, nodes.Element) and "to" in one
        }
        assert links == ({"statement", "chapter"} if entry.derivation else set())


def test_the_formulas_to_use_are_there(entries, chapters):
    """(6) of the paper, b > KT/2 + |B|, which holds for 0 < omega < pi/T."""
    found = pages.results(entries, chapters).findall(nodes.container)
    (item,) = (one for one in found if one.get("to") == "use" and one["at"] == "eq6")
    (formula,) = item.findall(nodes.math_block)
    assert formula["rows"] == list(STATEMENTS["eq6"].latex)


def test_what_a_chapter_finds_stands_at_its_head():
    """Its theorem in a box, else its statements; a definition is no finding."""
    heads = {}
    for name in ("s2b_wall", "s4d_parts_of_the_arm", "s8c_four_masses"):
        found = page(chapter(name), Place(1, {}))
        titles = [one.astext() for one in found.findall(nodes.rubric)]
        answers = [one.astext() for one in of_class(found, "answer")]
        heads[name] = [title for title in titles if title.startswith("Theorem")], answers
        marked = any("— paper (1)" in one.astext() for one in of_class(found, "verdict"))
        assert marked == (name == "s2b_wall")  # H(z) is (1) of the paper
    assert heads["s2b_wall"] == ([], [])
    _, (answer,) = heads["s4d_parts_of_the_arm"]
    assert answer.startswith("In short.")
    assert answer.count("s4d-all-stabilising") == 1
    ((theorem,), none) = heads["s8c_four_masses"]
    assert "no stiffness is stable" in theorem
    assert not none


@pytest.mark.parametrize("name", ["s2b_wall", "s3a_undelayed", "s4d_parts_of_the_arm"])
def test_equations_and_theorems_are_counted_from_one(name):
    titles = [one.astext() for one in page(chapter(name), Place(1, {})).findall(nodes.rubric)]
    numbers = [int(re.match(r"(?:Step|Theorem) (\d+)", title)[1]) for title in titles]
    counted = [b for b in chapter(name).page.blocks if b.kind in ("equation", "theorem")]
    assert numbers == list(range(1, len(counted) + 1))


def test_one_chapter_is_named_in_the_singular():
    names = {1: "s2a_device", 3: "s3a_undelayed", 4: "s3b_rise"}
    edges = {2: frozenset({1}), 3: frozenset({2}), 4: frozenset({2, 3})}
    place = Place(2, {}, names=names, edges=edges)
    (told,) = of_class(page(chapter("s2b_wall"), place), "source")
    assert (
        "Applies theorems of chapter 1. Its theorems are applied in chapters 3, 4." in told.astext()
    )


def of_class(tree, name):
    return [one for one in tree.findall(nodes.container) if name in one["classes"]]


def test_a_claim_is_for_the_site_and_its_place_for_print(entries, chapters):
    page = errata(entries, chapters)
    claims = [one for one in page.findall(nodes.container) if "claim" in one["classes"]]
    assert claims
    assert {one.get("only") for one in claims} == {"site"}


def test_of_what_needs_a_condition_the_table_says_for_which(entries, chapters):
    table = next(iter(errata(entries, chapters).findall(nodes.table)))
    rows = [[cell.astext() for cell in row] for row in table.findall(nodes.row)][1:]
    statements = {e.statement.id: e.verdict for e in entries}
    assert {kind for _, _, kind, *_ in rows} >= {Kind.QUALIFIED, Kind.REFUTED}
    for id, _, kind, right, _ in rows:
        assert kind == statements[id].kind
        assert right.startswith("for ") == (kind == Kind.QUALIFIED)
        assert len(right) > 4


@whole
def test_the_gravest_stand_first_and_nothing_is_left_over(entries):
    titles = [title for title, _ in by_importance(entries)]
    assert titles == [title for title, _ in IMPORTANCE]
    slips = by_importance(entries)[-1][1]
    assert {e.verdict.kind for e in slips} == {Kind.SLIP}
    others = [e for _, part in by_importance(entries)[:-1] for e in part]
    assert Kind.SLIP not in {e.verdict.kind for e in others}


def said(entry, kind):
    return replace(entry, verdict=replace(entry.verdict, kind=kind))


def test_what_turns_out_wrong_appears_and_what_is_right_disappears(entries, chapters):
    first = next(i for i, e in enumerate(entries) if e.verdict.kind is Kind.PROVED)
    more = list(entries)
    more[first] = said(more[first], Kind.REFUTED)
    assert len(listed(more, chapters)) == len(listed(entries, chapters)) + 1
    assert by_importance(more)[-1] == (OTHERS, [more[first]])  # no consequence is known
    right = [said(e, Kind.PROVED) for e in entries]
    assert listed(right, chapters) == []


@whole
def test_a_consequence_for_each_error_of_the_paper_and_for_no_other(entries):
    wrong = {e.statement.id for e in entries if e.verdict.kind in WRONG and not e.own}
    assert wrong == set(CONSEQUENCES)
