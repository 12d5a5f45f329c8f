"""The plots of stable regions: what is drawn, and what their chapters say of it, by eigenvalues."""

import itertools
import warnings

import matplotlib as mpl
import numpy as np
import pytest
from chapters import chapter
from oracle import moduli, radius

from symhaptic.book.figures import stability as drawn
from symhaptic.book.figures.style import STYLE

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


def test_roots_leave_where_the_wall_stops_to_lead():
    """Eigenvalues: just behind the delay margin one pair is outside, just before it none."""
    from symhaptic import delay_margin

    for alpha, beta in ((0.01, 0.05), (0.05, 0.3), (0.3, 0.8)):
        margin = float(delay_margin(alpha, beta, 0.001, 0.02))
        assert moduli(alpha, beta, 0.001, 0.02, margin - 1e-4).max() < 1
        behind = moduli(alpha, beta, 0.001, 0.02, margin + 1e-4)
        assert np.sum(behind > 1) == 2
