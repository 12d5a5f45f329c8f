"""Each derivation runs, and stops where something in it is changed."""

import dataclasses
import re

import oracle
import pytest
from chapters import chapter, run_altered
from sympy import Rational, S

from symhaptic.book.chapters import BadChapter, Chapter, shipped
from symhaptic.book.lemmas.linear_far import beyond
from symhaptic.book.lemmas.linear_two_percent import SPRINGS, within
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.book.page import Page
from symhaptic.book.report.printed import chapter_tex
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.paper import STATEMENTS
from symhaptic.paper.propositions.linear_error import BETWEEN
from symhaptic.paper.propositions.plots import CURVE
from symhaptic.paper.propositions.stability import NUMBERS
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.proof import box
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.verdict import Unfounded

LONGEST = 250
"""Lines of a chapter, with the lemmas that it alone uses."""
LONGER = dict.fromkeys(("s4d_left_bound_delayed", "s5a_one_delta", "s6g_next_whole_delay"), 340)
"""Chapters with one long proof each, whose lemmas serve nowhere else."""

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


def test_no_statement_of_the_paper_is_left_out(settled):
    assert set(STATEMENTS) <= set(settled)


def test_verdicts_come_with_what_shows_them(settled):
    for id, found in settled.items():
        verdict = found.verdict
        if verdict.kind == "qualified":
            assert verdict.condition, id
            assert verdict.counterexample, id
            assert verdict.shows, id
        if verdict.kind == "misprint":
            assert verdict.corrected, id
            assert verdict.counterexample is not None, id  # empty where nothing is to be chosen


ALTERED = [
    # chapter, what is written, what a slip of the pen would make of it
    ("s4d_jury", "(a_3 + a_0) * (x - 1)", "(a_3 + a_0) * (x + 1)"),
    ("s4d_jury_implicit", "boundary.wall(device)", "boundary.wall(device, delay=d + 1)"),
    ("s4d_explicit_boundary_signs", "arms, add_assum(", "arms[1:], add_assum("),
    ("s4d_figure9_delayed", "-STIFF + THIN / 2", "-STIFF - THIN / 2"),
    ("s4e_lag", "unless={Eq(b, 0)", "unless={Eq(k, 0)"),
    ("s4e_lag_dropped", "K: 3 * HALF}", "K: HALF}"),
    ("s4e_line_error_rises", "        risen(),", "        add_assum(risen(), K >= 0),"),
    ("s4e_line", "claim=tangent(),", "claim=tangent().body,"),
    ("s4e_line_two_percent", "example={delta: DAMPED}", "example={delta: 2 * DAMPED}"),
    ("s5b_stiffest_wall_peak", "point = {gamma: STIFF}", "point = {gamma: 2 * STIFF}"),
    ("s5c_nyquist_numbers", "Rational(102, 10**7)", "Rational(101, 10**7)"),
    ("s5c_robust", "- across * cos(late", "+ across * cos(late"),
    ("s6_gains", "b: 2 * b", "b: b"),
]


@pytest.mark.parametrize(("name", "written", "slip"), ALTERED)
def test_a_chapter_with_a_slip_of_the_pen_stops(tmp_path, name, written, slip):
    """A step, a limit, a box, an example, a counterexample, a condition, a digit."""
    with pytest.raises(BadChapter):
        run_altered(name, written, slip, tmp_path)


def test_a_root_on_the_wrong_side_is_not_shown():
    """Mutants of the counterexample: the dampings exchanged."""
    point = {alpha: S(-4), beta: Rational(59, 10), gamma: S(5), d: S.Zero}
    light, heavy = ({**point, delta: Rational(n, 10)} for n in (12, 15))
    assert stable_at(light)
    assert unstable_at(heavy)
    with pytest.raises(NotShown):
        stable_at(heavy)
    with pytest.raises(NotShown):
        unstable_at(light)


@pytest.mark.parametrize(
    ("name", "id"), [("s4d_scaling_kept", "s4d-damping-bound"), ("s6_scaling", "s6-mass")]
)
def test_each_condition_needs_a_point(name, id):
    settled = chapter(name).page.settled[id]
    judged, claim = settled.settlement.judged, settled.settlement.claim(())
    for left_out in range(2):
        cases = tuple(case for i, case in enumerate(judged.unless) if i != left_out)
        with pytest.raises(Unfounded, match="no counterexample violates just"):
            dataclasses.replace(judged, unless=cases).decide(claim)


@pytest.mark.parametrize("damping", [BETWEEN[0][1], BETWEEN[1][1]])
def test_no_threshold_is_shown_beyond_the_damping_where_it_is_false(damping):
    """linear-two-percent: a box that has the damping of 2 per cent in it is not shown."""
    delay = [high for _, high in BETWEEN.values()].index(damping)
    with pytest.raises(box.NotShown):
        within(delay, damping)
    arms = {gamma: (STIFF, STIFF), delta: (BETWEEN[delay][0], DAMPED)}
    with pytest.raises(box.NotShown):
        beyond(delay, SPRINGS[delay], S.Zero, arms)


def test_a_table_has_a_cell_under_each_head(tmp_path):
    page = Page("x")
    page.table("50% of $a_1$", ["$n$", "what"], [(1, "one & two"), (2, alpha**2)])
    tex = chapter_tex(Chapter(tmp_path / "x.py", "X?", "", page, 0.0), 1)
    assert r"$n$ & what \\" in tex
    assert r"$1$ & one \& two \\" in tex
    assert r"$2$ & $\alpha^2$ \\" in tex
    assert r"50\% of $a_1$" in tex
    with pytest.raises(ValueError, match="table: 1 cells under 2 heads"):
        page.table("", ["a", "b"], [(1,)])


def test_the_curve_of_fig_7_is_the_boundary():
    for spring, damper in ((0.0, 0.02), (1e-3, 0.0), (1e-3, 0.02), (4e-4, 0.01)):
        numbers = oracle.named(spring, damper)
        for damping in (0.1, 0.8, 1.7):
            at = {**{s: numbers[str(s)] for s in NUMBERS}, beta: damping}
            stiffness = float(CURVE.subs(at))
            assert oracle.stable(stiffness - 1e-9, damping, spring, damper, 0)
            assert not oracle.stable(stiffness + 1e-9, damping, spring, damper, 0)
