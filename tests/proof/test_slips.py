"""Verdicts without a theorem: a slip of the text, and what is left open."""

import pytest

from symhaptic.notation.written import written
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.reading import read
from symhaptic.proof.settle import Settlement
from symhaptic.proof.verdict import Kind, Unfounded


def test_a_slip_is_no_pass():
    found = Settlement(slip=r"\text{Section VI}", shows="IV is Stability").decide(())
    assert found.kind == Kind.SLIP
    assert found.corrected == r"\text{Section VI}"
    assert not found


def test_a_formula_has_no_slips():
    with pytest.raises(Unfounded, match="a formula is compared"):
        Settlement(slip="K = 2b/T", shows="so").decide(read(r"K = \frac{b}{T}"))


def test_what_is_left_open_passes_nowhere_and_shows_what_is_claimed():
    claim = CLAIMED["s5c-every-spring"]
    found = Settlement(left_open=True, claim=claim, note="known in part").decide(())
    assert found.kind == Kind.UNDECIDED
    assert not found
    assert found.proposition == written(claim(()))
