"""The plots of stable regions: what is drawn, and what their chapters say of it, by eigenvalues."""

import itertools
import warnings

import matplotlib as mpl
import mpmath
import numpy as np
import pytest
import sympy as sp
from chapters import chapter, equalities, run_altered
from oracle import moduli, radius
from scipy.signal import cont2discrete

from symhaptic.book.chapters import BadChapter
from symhaptic.book.figures import stability as drawn
from symhaptic.book.figures.passivity import STYLE
from symhaptic.proof.decide import compare
from symhaptic.proof.mutants import wrong

CHAPTERS = [
    "s4d_figure7_undelayed",
    "s4d_figure8_origin",
    "s4d_figure9_delayed",
    "s4d_roots_delay_margin",
    "s5a_figure",
    "s5b_figure",
    "s5c_robust",
    "s5c_robust_figure",
]
RNG = np.random.default_rng(13)


@pytest.fixture
def few_springs(monkeypatch):
    """Fig. 13 with fewer springs and rows, drawn in a second."""
    monkeypatch.setattr(drawn, "SPRINGS", np.linspace(0, 1, 5))


def figure(name):
    """The figure of that name among the chapters, drawn; its axes as a flat list."""
    mpl.use("Agg")
    import matplotlib.pyplot as plt

    (block,) = (
        b
        for c in CHAPTERS
        for b in chapter(c).page.blocks
        if b.kind == "figure" and b.title == name
    )
    with mpl.rc_context(STYLE), warnings.catch_warnings():
        warnings.simplefilter("error")
        made, axes = plt.subplots(
            *block.panels, figsize=(5.2, 5.2 * block.height), layout="constrained"
        )
        block.draw(axes)
        made.canvas.draw()  # runs the layout
    plt.close(made)
    return list(np.atleast_1d(axes).flat)


def lines(axes, style=None):
    """x and y of the drawn curves with many points, of one line style if given."""
    kept = [line for line in axes.lines if len(line.get_xdata()) > 4]
    if style is not None:
        kept = [line for line in kept if line.get_linestyle() == style]
    return [np.asarray(line.get_xydata(), dtype=float) for line in kept]


def contains_data(axes):
    left, right = axes.get_xlim()
    low, high = axes.get_ylim()
    every = np.vstack(lines(axes))
    return (
        left <= every[:, 0].min()
        and every[:, 0].max() <= right
        and low <= every[:, 1].min()
        and every[:, 1].max() <= high
    )


def borders_stability(points, gamma, delta, delay):
    """Eigenvalues: each point of an outline has a root on the circle and no other outside."""
    for alpha, beta in points[:: max(len(points) // 40, 1)]:
        sizes = np.sort(moduli(alpha, beta, gamma, delta, delay))
        # chords stray by 1e-4 of the region, and a double root at 1 magnifies that
        assert abs(sizes[-1] - 1) < 2e-3


# -- what is drawn ------------------------------------------------------------------------


def test_figure_7_draws_the_four_limits():
    (axes,) = figure("fig7")
    found = lines(axes)
    assert len(found) == 4
    assert contains_data(axes)
    for points, (delta, gamma) in zip(found, itertools.product((0, 0.02), (0, 0.001)), strict=True):
        assert points[:, 0].min() == pytest.approx(-gamma, abs=1e-12)
        borders_stability(points, gamma, delta, 0.0)


def test_figure_8_draws_five_springs_and_their_left_bounds():
    (axes,) = figure("fig8")
    lefts = sorted({round(points[:, 0].min(), 9) for points in lines(axes)})
    assert lefts == [-0.001, -0.00075, -0.0005, -0.00025, 0]
    assert len(lines(axes)) == 10
    assert axes.get_xlim()[0] < -0.001
    assert axes.get_ylim()[0] < -0.0205


def test_figure_9_draws_two_delays():
    for axes, delay in zip(figure("fig9"), (1.0, 2.0), strict=True):
        assert len(lines(axes)) == 4
        assert contains_data(axes)
        borders_stability(lines(axes)[3], 0.001, 0.02, delay)


def test_figure_11_draws_seven_delays_and_two_readings():
    whole, close = figure("fig11")
    assert contains_data(whole)
    for axes in (whole, close):
        assert len(lines(axes, "-")) == 7 + (axes is whole)  # the frame of the close-up
        assert len(lines(axes, "--")) + sum(len(x.get_xdata()) == 3 for x in axes.lines) >= 7
    for points, delay in zip(lines(close, "-"), (0, 0.25, 0.5, 1, 2, 4, 8), strict=True):
        borders_stability(points, 0.001, 0.02, float(delay))


def test_the_passive_walls_of_figure_11_are_stable_also_for_the_exact_fractions():
    """Sampling, as the chapter says: 4000 walls on the border of (27) per delay."""
    for delay in (0.25, 0.5):
        alpha, beta = drawn.passive(delay)
        share = RNG.uniform(0, len(alpha) - 1, 4000)
        place = np.arange(len(alpha))
        walls = np.interp(share, place, alpha), np.interp(share, place, beta)
        assert radius(*walls, 0.001, 0.02, delay).max() < 1


def test_the_exact_fractions_leave_the_paper_s_reading_as_said():
    for delay, percent in ((0.25, 1.6), (0.5, 0.3)):
        exact, read = (
            drawn.region(0.001, 0.02, delay, sheet).max_stiffness.alpha
            for sheet in ("exact", "principal")
        )
        assert 100 * (read / exact - 1) == pytest.approx(percent, abs=0.05)


def test_figure_12_shows_the_ratio_near_one_and_falling_again():
    both, ratio, far = figure("fig12")
    assert [len(lines(axes)) for axes in (both, ratio, far)] == [3, 2, 2]
    for points, first in zip(lines(ratio), (0.0561, 0.0561), strict=True):
        assert points[0, 1] == pytest.approx(first, abs=1e-4)  # 1/17.8, Sec. V-B
    without, spring = (points[:, 1] for points in lines(far))
    assert 0.999 < without.max() < 1
    assert 0.99 < spring.max() < 1
    assert without[-1] < 0.91
    assert spring[-1] < 0.06


@pytest.mark.slow
def test_figure_13_has_a_row_for_each_delay_and_reading(few_springs):
    panels = np.array(figure("fig13")).reshape(5, 3)
    for row in panels:
        assert len(lines(row[0])) >= 5
        assert contains_data(row[0])
        assert row[1].get_xlim() == row[2].get_xlim()
        black = [line for line in row[1].lines if line.get_color() == "black"]
        assert len(black) == 1  # one robust region
        assert len(row[1].patches) == 1  # the passive one
        assert np.max(black[0].get_xdata()) > np.max(row[1].patches[0].get_xy()[:, 0])


def test_the_delay_margin_is_drawn_with_five_regions():
    for axes in figure("delay_margin"):
        assert len(lines(axes)) == 5


# -- what the chapters say ----------------------------------------------------------------


def boundary(theta, gamma, delta, d):
    """(alpha, beta) with a root at exp(j theta), from SciPy's zero-order hold."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    z = np.exp(1j * np.asarray(theta))
    q = -(z**d) * np.polyval(bottom, z) / np.polyval(top[0][1:], z)
    beta = q.imag / np.sin(theta)
    return q.real - beta * (1 - np.cos(theta)), beta


def test_the_spring_moves_the_undelayed_curve_by_less_than_said():
    theta = np.arccos(np.linspace(-0.02, 0.9999, 300))
    for gamma, delta in itertools.product((1e-5, 4e-4, 1e-3), (0, 0.003, 0.02)):
        there, before = boundary(theta, gamma, delta, 0), boundary(theta, 0, delta, 0)
        for one, other in zip(there, before, strict=True):
            assert np.abs(one - other).max() < 1.1 * gamma
        assert max(np.abs(a - b).max() for a, b in zip(there, before, strict=True)) > 0.9 * gamma


def test_the_bottom_boundary_is_the_linear_condition_near_the_origin():
    theta = np.arccos(np.linspace(0.997, 1 - 1e-7, 200))
    for gamma, delta in itertools.product((0, 5e-4, 1e-3), (0, 0.01, 0.02)):
        alpha, beta = boundary(theta, gamma, delta, 0)
        assert np.abs(beta - alpha / 2 + delta).max() < 1e-4
        assert alpha[0] > 0.0036  # beyond the window of Fig. 8


def test_the_widths_with_a_delay():
    for d, bound in ((0, 0.72), (1, 0.17), (2, 0.08)):
        theta = np.linspace(1e-3, np.pi / (2 * (d + 1)), 4000)
        for gamma in (0, 1e-3):
            assert 0.85 * bound < boundary(theta, gamma, 0.02, d)[0].max() < bound


def test_the_ratio_at_the_two_peaks():
    """eta from the first maximum of the curve, which eigenvalues confirm to be the border."""
    for d, gamma, eta in ((122, 0.0, 0.99999), (40, 0.001, 0.9998)):
        theta = np.linspace(0.3, 1.2, 20001) * np.pi / (2 * (d + 1))
        alpha, beta = boundary(theta, gamma, 0.02, d)
        at = alpha.argmax()
        passive = 2 * 0.02 * np.tan(np.pi / (4 * (d + 1)))
        assert passive / alpha[at] == pytest.approx(eta, abs=2e-5)
        assert passive < alpha[at]
        assert moduli(alpha[at] * (1 - 1e-4), beta[at], gamma, 0.02, float(d)).max() < 1


def test_the_limit_of_the_ratio():
    largest = mpmath.findroot(lambda p: mpmath.sin(p) + p * mpmath.cos(p), 2)
    assert float(largest) == pytest.approx(2.029, abs=5e-4)
    assert float(largest * mpmath.sin(largest)) == pytest.approx(1.8197, abs=5e-5)
    assert float(mpmath.pi / 2 / (largest * mpmath.sin(largest))) == pytest.approx(0.863, abs=5e-4)


@pytest.mark.parametrize("delay", [0.0, 1.0, 7.0, 40.0, 150.0])
def test_some_walls_on_a_spring_are_stable_with_every_delay(delay):
    assert moduli(0.0005, 0.0, 0.001, 0.02, delay).max() < 1


def test_the_delay_margin_of_the_example():
    """y^2 = (1 - y/4) (alpha^2 + (alpha + beta) beta y) by hand, and the phases there."""
    alpha, beta = 0.01, 0.05
    push = (alpha + beta) * beta
    y = max(np.roots([1 + push / 4, alpha**2 / 4 - push, -(alpha**2)]).real)
    theta = 2 * np.arcsin(np.sqrt(y) / 2)
    assert theta == pytest.approx(0.1077, abs=5e-5)
    z = np.exp(1j * theta)
    wall = -(z + 1) / 2 * ((alpha + beta) * z - beta) / (z - 1) ** 2
    assert np.angle(wall) / theta - 1 == pytest.approx(3.969, abs=5e-4)


def test_roots_leave_where_the_wall_stops_to_lead():
    """Eigenvalues: just behind the delay margin one pair is outside, just before it none."""
    from symhaptic import delay_margin

    for alpha, beta in ((0.01, 0.05), (0.05, 0.3), (0.3, 0.8)):
        margin = float(delay_margin(alpha, beta, 0.001, 0.02))
        assert moduli(alpha, beta, 0.001, 0.02, margin - 1e-4).max() < 1
        behind = moduli(alpha, beta, 0.001, 0.02, margin + 1e-4)
        assert np.sum(behind > 1) == 2


@pytest.mark.parametrize("name", [c for c in CHAPTERS if c != "s4d_figure9_delayed"])
def test_no_wrong_variant_of_a_step_is_proved(name, monkeypatch, record_property):
    count = 0
    for title, left, right in equalities(name, monkeypatch):
        if isinstance(right, sp.Expr):
            for mutant in itertools.islice(wrong((right,)), 2):
                count += 1
                assert not compare(left, mutant.form[0]).equal, f"{title}: {mutant.change}"
    record_property("mutants", count)
    assert count


CHANGES = [
    ("s4d_figure8_origin", "beta + delta - alpha / 2", "beta + delta + alpha / 2"),
    ("s4d_figure7_undelayed", "- 2 * n_0 * x", "+ 2 * n_0 * x"),
    ("s4d_figure9_delayed", "-STIFF + THIN / 2", "-STIFF - THIN / 2"),
    ("s4d_roots_delay_margin", "{**free, d: S(3)}", "{**free, d: S(4)}"),
    ("s4d_roots_delay_margin", "real_part(I * (u", "real_part(-I * (u"),
    ("s5a_figure", "(1 - a - e) * n_0", "(1 - a + e) * n_0"),
    ("s5b_figure", "delta * phi * sin(phi)", "delta * phi * cos(phi)"),
    ("s5c_robust", "(late + 1) * beta - late", "(late + 2) * beta - late"),
    ("s5c_robust", "- across * cos(late", "+ across * cos(late"),
    ("s5c_robust_figure", "exp(I * (1 - epsilon) * Omega)", "exp(I * epsilon * Omega)"),
]


@pytest.mark.parametrize(("name", "right", "false"), CHANGES)
def test_a_chapter_with_something_false_stops(name, right, false, tmp_path):
    with pytest.raises(BadChapter, match=r"not positive|undecided|false|not shown|the limit is"):
        run_altered(name, right, false, tmp_path)
