"""Each derivation runs and gives the expected verdicts."""

import re

import pytest
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.paper import STATEMENTS

LONGEST = 250
"""Lines of a chapter, with the lemmas that it alone uses."""
LONGER = dict.fromkeys(("s4d_left_bound_delayed", "s5a_one_delta", "s6g_next_whole_delay"), 340)
"""Chapters with one long proof each, whose lemmas serve nowhere else."""

DEFINITIONS = [
    "eq1",
    "eq2",
    "eq3",
    "eq13",
    "tab1",
    "eq23",
    "eq26",
]
PROVED = [
    "eq15",
    "s2c-delays-lump",
    "s3a-mass-free",
    "s3c-kmax-frequency",
    "s4b-five-parameters",
    "eq28",
    "eq29",
    "eq30",
    "s5a-proportional",
    "s5c-undamped-limit",
    "s4d-gamma-invisible",
    "fig7",
    "fig8",
    "fig9",
    "fig12",
    "s5c-robust-vanishes",
    "counting-ignores-delay",
    "free-wall-stronger",
    "fractional-plant",
    "fractional-polynomial",
    "fractional-boundary",
    "fractional-half-mass",
    "fractional-half-mass-apart",
    "fractional-passivity",
    "fractional-passive-is-stable",
    "fractional-low-frequencies",
    "fractional-limit-points",
    "fractional-largest-stiffness",
    "fractional-longer-delay",
    "fractional-next-whole",
    "fractional-stiffness-bound",
    "fractional-literal",
    "fractional-figures",
    "fractional-principal",
    "eq19",
    "eq21",
    "fig6",
    "arm-mean-ratio",
    "s2d-arm-in-force",
    "s4b-seven-to-five",
    "s4c-independent-limits",
    "s4c-outlier",
    "s4c-series",
    "s4d-too-much-damping",
    "fig10",
    "s4e-unstable-side",
    "s4e-same-as-passive",
    "s4e-linearised",
    "arm-numbers",
    "linear-lag",
    "linear-tangent",
    "linear-short-periods",
    "linear-error-start",
    "linear-error-rises",
    "linear-error-corner",
    "linear-free-mass",
    "linear-safe",
    "linear-two-percent",
    "stiffest-wall",
    "weaker-damping",
    "faster-sampling",
    "s5c-marginal-b",
    "s5c-pole-inside",
    "s5c-shape",
    "s6-performance",
    "undelayed-turned-down",
    "delay-margin",
    "computed-discretize",
    "computed-characteristic-polynomial",
    "computed-stability-conditions",
    "computed-discretize-fractional",
    "computed-unstable-roots",
    "computed-is-stable",
    "computed-stability-boundary",
    "computed-max-stable-stiffness",
    "computed-passivity-margin-at",
    "computed-passivity-margin",
    "computed-passivity-boundary",
    "computed-max-passive-stiffness",
    "computed-linear-limit",
    "s2c-positive-delay",
    "s2c-rational-delay",
    "explicit-boundary",
    "jury-inequalities",
    "s4d-left-bound",
    "left-bound-damped",
    "s4d-delta-grows",
    "damping-destabilises",
    "s4e-two-percent",
    "fig11",
    "one-delta-figures",
    "one-delta-kept",
    "s5a-subset",
    "stiffest-wall-undelayed",
    "boundary-tangents",
    "s5c-nyquist-spring",
    "fig13",
    "s5c-robust-shrinks",
    "s5c-robust-grows",
    "s3c-upper-part",
    "s4d-delay-shrinks-area",
    "s4d-all-stabilising-area",
    "s6-light-device",
    "rules:average-damping",
    "rules:virtual-wall",
    "rules:semi-implicit-euler",
    "rules:euler-explicit",
    "rules:known-velocity",
    "rules:counts-and-friction",
    "rules:low-pass-mass",
    "rules:lag-as-delay",
    "coupling:period",
    "coupling:noise",
    "coupling:rest",
    "coupling:beside-spring",
]
ENCLOSED = [
    "s3c-kmax-41",
    "s3c-kmax-27",
    "s5b-eta-d0",
    "s5b-eta-d1",
    "s5c-human-10000",
    "eq31",
    "s6-stable-22",
    "one-delta-ratio",
    "s0-far-higher",
    "s5b-clearly-larger",
    "s5a-much-smaller",
    "s6-why-conservative",
    "one-period-share",
    "s6-damping-marginal",
    "s6-stiffness-marginal",
    "s6-linear-small-error",
    "s5c-delta-hardly-visible",
]
MISPRINTS = [
    "eq12",
    "s4a-delay-equivalent",
    "s3b-linear-in-T",
    "s5c-interval",
]
SLIPS = [
    "coupling:ratio",
    "s1-conclusion",
    "s5b-ratio-panels",
    "s5b-captions-alike",
    "s4d-bound-of-b",
    "s4c-et-al",
    "s1-et-al",
]
QUALIFIED = [
    "eq5",
    "eq8",
    "eq11",
    "eq4",
    "eq6",
    "eq7",
    "eq9",
    "eq10",
    "eq14",
    "eq16",
    "eq17",
    "eq18",
    "eq27",
    "s3a-undelayed",
    "s3c-limit-points",
    "s3c-bmax-frequency",
    "s3c-lower-part",
    "s4d-degree",
    "s4d-quadratic-in-period",
    "s4d-damping-bound",
    "s5c-robust-subset",
    "s6-sampling",
    "s6-mass",
    "eq20",
    "fig4",
    "fig5",
    "s3-interconnection",
    "s4a-exact-instants",
    "s5b-soft-contacts",
    "eq24",
    "eq25",
    "s4e-stiffness-free",
    "s4e-passive-range",
    "s6-linear-dissipation",
    "s5a-smaller-delta",
    "s6-human-10000",
    "s6-faster-sampling",
    "rules:twice-damping",
    "rules:damping-over-delay",
    "rules:plain-damping",
    "rules:virtual-mass",
    "rules:virtual-mass-stable",
    "rules:one-mass",
    "rules:filter-as-delay",
    "rules:energy-leak",
    "rules:delay-damping",
    "coupling:stable-mass",
    "s6-subset",
    "s6-damping-any-delay",
    "s6-stiffness-any-delay",
]
REFUTED = [
    "rules:four-masses",
    "rules:two-masses",
    "rules:damped-contact",
    "rules:euler-for-devices",
    "rules:two-dampings",
    "rules:both-below-two",
    "coupling:implicit",
    "coupling:damper",
    "s4d-all-stabilising",
    "s4d-delay-shrinks",
    "s4c-extension-30",
    "s5b-eta-grows",
    "one-delta",
]
EXTERNAL = [
    "coupling:passive-mass",
    "s3-unilateral",
    "tab2",
    "eq22",
    "s4c-device-damping",
    "s4c-wider-delta",
    "s4e-alpha-003",
    "s4d-explicit-only-undelayed",
]
UNDECIDED = [
    "s5c-robust-shrinks-sets",
    "s5c-robust-grows-sets",
    "s5c-every-spring",
]
EXPECTED = {
    id: kind
    for kind, ids in {
        "definition": DEFINITIONS,
        "proved": PROVED,
        "enclosed": ENCLOSED,
        "misprint": MISPRINTS,
        "slip": SLIPS,
        "qualified": QUALIFIED,
        "refuted": REFUTED,
        "external": EXTERNAL,
        "undecided": UNDECIDED,
    }.items()
    for id in ids
}
CHAPTERS = [path.stem for path in shipped()]


@pytest.mark.parametrize("name", CHAPTERS)
def test_chapter_runs_and_is_short(name):
    found = chapter(name)
    assert len(found.path.read_text(encoding="utf-8").splitlines()) < LONGER.get(name, LONGEST)
    assert re.search(r"[\w$]\??$", found.title)  # a question or a statement
    assert found.introduction


@pytest.fixture(scope="module")
def settled():
    return {id: s for name in CHAPTERS for id, s in chapter(name).page.settled.items()}


def test_no_statement_is_settled_twice():
    ids = [id for name in CHAPTERS for id in chapter(name).page.settled]
    assert len(ids) == len(set(ids))


def test_verdicts_are_the_expected_ones_and_no_statement_is_left_out(settled):
    assert {id: found.verdict.kind for id, found in settled.items()} == EXPECTED
    assert set(STATEMENTS) <= set(settled)


def test_conditions_come_with_counterexamples(settled):
    for id in QUALIFIED:
        verdict = settled[id].verdict
        assert verdict.condition, id
        assert verdict.counterexample, id
        assert verdict.shows, id


def test_misprints_come_with_corrections(settled):
    for id in MISPRINTS:
        verdict = settled[id].verdict
        assert verdict.corrected, id
        assert verdict.counterexample is not None, id  # empty where nothing is to be chosen
