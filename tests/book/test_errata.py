"""The errata list whatever the ledger calls wrong or conditional, and nothing else."""

from dataclasses import replace

import pytest
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.book.consequences import CONSEQUENCES, IMPORTANCE
from symhaptic.book.ledger import ledger, of_chapter
from symhaptic.book.sources import PAPER
from symhaptic.book.tex.errata import OTHERS, by_importance, errata
from symhaptic.proof.verdict import Kind

pytestmark = pytest.mark.ci

WRONG = {Kind.QUALIFIED, Kind.MISPRINT, Kind.REFUTED, Kind.SLIP}


@pytest.fixture(scope="module")
def entries():
    return ledger(e for path in shipped() for e in of_chapter(chapter(path.stem)))


@pytest.fixture(scope="module")
def chapters(entries):
    return {e.derivation: i for i, e in enumerate(entries, 1) if e.derivation}


def listed(entries, chapters):
    return [item for _, items in errata(entries, chapters) for item in items]


def test_each_error_is_listed_once(entries, chapters):
    wrong = [e for e in entries if e.verdict.kind in WRONG and e.source is PAPER]
    assert len(listed(entries, chapters)) == len(wrong)


def test_each_has_what_a_reader_needs(entries, chapters):
    for item in listed(entries, chapters):
        rows = [row.split("}")[0] for row in item.split("\\erratumrow{")[1:]]
        assert rows[0] == "the paper" or (rows[0], "(17)" in item) == ("printed", True)
        assert rows[-1] == "for a device"
        assert "shown by" in rows
        order = [row for row in rows if row in ("the paper", "read as", "proposition", "verdict")]
        assert [row for row in ORDER if row in order] == order
        assert {"read as", "verdict"} < set(order)
        assert {"right", "right for", "what holds"} & set(rows), item


ORDER = ("the paper", "read as", "proposition", "verdict")


def test_a_paraphrase_is_called_printed_nowhere(entries, chapters):
    """What is labelled so is a formula of the transcription."""
    for item in listed(entries, chapters):
        if "\\erratumrow{printed}" in item:
            row = item.split("\\erratumrow{printed}{")[1].split("\\erratumrow{")[0]
            assert "\\displaystyle" in row, item


def test_the_gravest_stand_first_and_nothing_is_left_over(entries):
    titles = [title for title, _ in by_importance(entries)]
    assert titles == [title for title, _ in IMPORTANCE]
    slips = by_importance(entries)[-1][1]
    assert {e.verdict.kind for e in slips} == {Kind.SLIP}
    others = [e for _, part in by_importance(entries)[:-1] for e in part]
    assert Kind.SLIP not in {e.verdict.kind for e in others}


def test_an_error_of_which_no_consequence_is_known_is_listed_still(entries):
    first = next(i for i, e in enumerate(entries) if e.verdict.kind is Kind.PROVED)
    more = list(entries)
    more[first] = said(more[first], Kind.REFUTED)
    assert by_importance(more)[-1] == (OTHERS, [more[first]])


def said(entry, kind):
    return replace(entry, verdict=replace(entry.verdict, kind=kind))


def test_what_turns_out_wrong_appears_and_what_is_right_disappears(entries, chapters):
    first = next(i for i, e in enumerate(entries) if e.verdict.kind is Kind.PROVED)
    more = list(entries)
    more[first] = said(more[first], Kind.REFUTED)
    assert len(listed(more, chapters)) == len(listed(entries, chapters)) + 1
    right = [said(e, Kind.PROVED) for e in entries]
    assert errata(right, chapters) == []


def test_a_consequence_for_each_error_of_the_paper_and_for_no_other(entries):
    wrong = {e.statement.id for e in entries if e.verdict.kind in WRONG and not e.own}
    assert wrong == set(CONSEQUENCES)
