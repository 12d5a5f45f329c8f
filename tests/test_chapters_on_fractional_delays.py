"""What is said of delays that are no whole number of periods rests on theorems."""

import pytest
from chapters import chapter

SETTLED = {
    "fractional-literal": ("s6h_fractional_letter", "proved"),
    "fractional-figures": ("s6h_fractional_letter", "proved"),
}


@pytest.mark.parametrize("id", SETTLED)
def test_verdict_rests_on_a_theorem(id):
    name, kind = SETTLED[id]
    verdict = chapter(name).page.settled[id].verdict
    assert (verdict.kind, bool(verdict.rests)) == (kind, True)
