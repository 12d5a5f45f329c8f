"""A statement that no theorem decides is undecided: listed with its claim, and never a pass."""

import pytest

from symhaptic.book.committed import unproved
from symhaptic.book.ledger import Entry
from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.notation import K
from symhaptic.notation.proposition import ForAll, proposition
from symhaptic.paper import STATEMENTS
from symhaptic.proof.settle import OPEN, Settlement
from symhaptic.proof.verdict import Kind

CLAIM = ForAll((K,), proposition(K > 0))


def test_what_is_left_open_is_no_pass():
    found = Settlement(left_open=True, claim=lambda _: CLAIM, note="known for $K=1$").decide(())
    assert found.kind is Kind.UNDECIDED
    assert not found
    assert (found.method, found.claim, found.note) == (OPEN, CLAIM, "known for $K=1$")


def test_only_a_statement_is_left_open_and_once():
    page = Page("test")
    with pytest.raises(FalseStep, match="no statement 'some'"):
        page.leave_open("some", "nothing")
    page.state("some", "some stiffness is positive", claim=CLAIM)
    page.leave_open("some", "nothing is known")
    with pytest.raises(FalseStep, match="some"):
        page.leave_open("some", "nothing is known")


def test_of_the_papers_those_that_the_ledger_lists_are_no_surprise():
    verdict = Settlement(left_open=True, note="none").decide(())
    entry = Entry(STATEMENTS["s5c-every-spring"], verdict, "s5c_robust_walls.py", 0.0)
    assert unproved([entry], {"s5c-every-spring": "undecided"}) == []
    (line,) = unproved([entry], None)
    assert line == "s5c-every-spring: undecided, and no ledger says so"
