"""A slip of the text is a verdict of its own: no theorem, no pass, and never of a formula."""

import pytest

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
