"""What is said of delays that are no whole number of periods rests on theorems."""

import pytest
from chapters import chapter

SETTLED = {
    "fractional-half-mass": ("s6c_half_a_period", "proved"),
    "fractional-half-mass-apart": ("s6c_half_a_period", "proved"),
    "fractional-passivity": ("s6d_fractional_passivity", "proved"),
    "fractional-low-frequencies": ("s6e_fractional_region", "proved"),
    "fractional-principal": ("s6h_fractional_readings", "proved"),
    "fractional-next-whole": ("s6g_next_whole_delay", "proved"),
    "fractional-passive-is-stable": ("s6e_fractional_passive_is_stable", "proved"),
    "fractional-boundary": ("s6b_fractional_stability", "proved"),
    "fractional-polynomial": ("s6b_fractional_stability", "proved"),
    "fractional-plant": ("s6a_fractional_plant", "proved"),
    "fractional-limit-points": ("s6e_fractional_region", "proved"),
    "fractional-largest-stiffness": ("s6f_half_a_period_passive", "proved"),
    "fractional-stiffness-bound": ("s6f_stiffest_passive_wall", "proved"),
    "fractional-longer-delay": ("s6f_half_a_period_passive", "proved"),
    "fractional-literal": ("s6h_fractional_letter", "proved"),
    "fractional-figures": ("s6h_fractional_letter", "proved"),
}


@pytest.mark.parametrize("id", SETTLED)
def test_verdict_rests_on_a_theorem(id):
    name, kind = SETTLED[id]
    verdict = chapter(name).page.settled[id].verdict
    assert (verdict.kind, bool(verdict.rests)) == (kind, True)
