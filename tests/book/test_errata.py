"""The errata list whatever the ledger calls wrong or conditional, and nothing else."""

from dataclasses import replace

import pytest
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.book.consequences import CONSEQUENCES
from symhaptic.book.ledger import ledger, of_chapter
from symhaptic.book.sources import PAPER
from symhaptic.book.tex.errata import errata
from symhaptic.proof.verdict import Kind

WRONG = {Kind.QUALIFIED, Kind.MISPRINT, Kind.REFUTED}


@pytest.fixture(scope="module")
def entries():
    return ledger(e for path in shipped() for e in of_chapter(chapter(path.stem)))


@pytest.fixture(scope="module")
def chapters(entries):
    return {e.derivation: i for i, e in enumerate(entries, 1) if e.derivation}


def listed(entries, chapters):
    return [item for _, items in errata(entries, chapters) for item in items]


def test_each_error_is_listed_once(entries, chapters):
    wrong = [e for e in entries if e.verdict.claimed in WRONG and e.source is PAPER]
    assert len(listed(entries, chapters)) == len(wrong)


def test_each_has_what_a_reader_needs(entries, chapters):
    for item in listed(entries, chapters):
        rows = [row.split("}")[0] for row in item.split("\\erratumrow{")[1:]]
        assert rows[0] == "printed"
        assert rows[-1] == "for a device"
        assert "shown by" in rows
        assert {"right", "right for", "what holds"} & set(rows), item


def said(entry, kind):
    return replace(entry, verdict=replace(entry.verdict, kind=kind, argued_for=None))


def test_what_turns_out_wrong_appears_and_what_is_right_disappears(entries, chapters):
    first = next(i for i, e in enumerate(entries) if e.verdict.claimed is Kind.PROVED)
    more = list(entries)
    more[first] = said(more[first], Kind.REFUTED)
    assert len(listed(more, chapters)) == len(listed(entries, chapters)) + 1
    right = [said(e, Kind.PROVED) for e in entries]
    assert errata(right, chapters) == []


def test_a_consequence_for_each_error_of_the_paper_and_for_no_other(entries):
    wrong = {e.statement.id for e in entries if e.verdict.claimed in WRONG and not e.own}
    assert wrong == set(CONSEQUENCES)
