"""The plots and what is read from them rest on theorems, with the conditions that they need."""

import pytest
from chapters import chapter

SETTLED = {
    "eq27": ("s5a_normalised_boundary", "qualified"),
}


@pytest.mark.parametrize("id", SETTLED)
def test_verdict_rests_on_a_theorem(id):
    name, kind = SETTLED[id]
    verdict = chapter(name).page.settled[id].verdict
    assert (verdict.kind, bool(verdict.rests)) == (kind, True)


def test_normalised_curve_bounds_up_to_its_end_for_whole_delays():
    condition = chapter("s5a_normalised_boundary").page.settled["eq27"].verdict.condition
    assert condition == r"d\in\mathbb{N}_0,\ \hat{\omega}\le\pi/(d+1)"
