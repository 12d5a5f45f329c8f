"""The human arm, Figs. 4 to 6, and claims and slips of the text, by other means than the package.

Numbers of the paper are typed here once more, from its Table II and Sec. IV-C.
"""

import itertools
import warnings
from fractions import Fraction

import matplotlib as mpl
import mpmath
import numpy as np
import pytest
from chapters import chapter
from scipy.optimize import linprog

import symhaptic.paper.tables as tables
from symhaptic.book.figures.style import STYLE, WIDTH

# Table II: reference, m_H/kg, k_H/(N/m), b_H/(Ns/m)
ARMS = """
21 1     39.5  12.6
17 0.8   568   5.5
22 4.54  12.5  6.83
23 1.95  55    2.46
24 0.15  1000  7.5
25 2.79  345   33.8
26 17.51 175.1 175.1
27 0.5   40    6
28 0.15  7     0.5
29 1.8   199.1 26.2
30 2.0   10.0  2.0
"""
ROWS = [line.split() for line in ARMS.split("\n") if line]


# -- Table II -------------------------------------------------------------------------------


def test_table_ii_is_the_printed_one():
    typed = [[str(a.reference), a.mass, a.stiffness, a.damping] for a in tables.TABLE_II]
    assert typed == ROWS
    assert [a.reference for a in tables.TABLE_II if a.with_device] == [21]


# -- the figures ----------------------------------------------------------------------------


def drawn(name, title):
    """The axes of one figure, drawn without a warning."""
    mpl.use("Agg")
    import matplotlib.pyplot as plt

    (block,) = (b for b in chapter(name).page.blocks if b.kind == "figure" and b.title == title)
    with mpl.rc_context(STYLE), warnings.catch_warnings():
        warnings.simplefilter("error")
        made, axes = plt.subplots(figsize=(WIDTH, block.height * WIDTH), layout="constrained")
        block.draw(axes)
        made.canvas.draw()
    return made, axes


def test_figure_6_shows_every_row_at_its_place_and_no_label_covers_another():
    made, axes = drawn("s4c_arm_ranges", "fig6")
    points = {(line.get_xdata()[0], line.get_ydata()[0]) for line in axes.lines[2:]}
    assert points == {(float(r[2]) / float(r[1]), float(r[3]) / float(r[1])) for r in ROWS}
    boxes = [t.get_window_extent() for t in axes.texts]
    boxes.append(axes.get_legend().get_window_extent())
    assert len(axes.texts) == len(ROWS)
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
    page = made.bbox
    assert all(page.x0 <= b.x0 and b.x1 <= page.x1 for b in boxes)
    # no label lies on the point of another row
    places = axes.transData.transform(sorted(points))
    assert not any(b.contains(*place) for b in boxes for place in places)
    corners = [(line.get_xdata()[0], line.get_ydata()[-1]) for line in axes.lines[:2]]
    assert corners == [(1000, 20), (710, 14.6)]  # (23) over T^2 and T at 1 ms, and (21)


def condition(angles, delay):
    """Rows of K and B in (5) as it is printed, b = T = 1."""
    cos, scale = np.cos, 2 - 2 * np.cos(angles)
    k = (cos(delay * angles) - cos((delay + 1) * angles)) / scale
    b = cos(delay * angles) - 2 * cos((delay + 1) * angles) + cos((delay + 2) * angles)
    return np.stack([k, b / scale], axis=1)


@pytest.mark.parametrize("delay", [0, 0.25, 0.5, 1, 2, 4, 8])
def test_tips_and_corners_of_figure_4(delay):
    """Tips by linear programming over (5) on 3000 angles, corners by mpmath on (7)."""
    (table,) = (b for b in chapter("s3d_figures").page.blocks if b.kind == "table")
    row = next(r for r in table.rows if r[0] == f"${delay:g}$")
    corner_k, corner_b, tip_k, tip_b = (float(Fraction(str(c).strip("$"))) for c in row[1:])
    angles = np.linspace(0, np.pi, 3002)[1:-1]
    found = linprog([-1, 0], condition(angles, delay), np.ones(3000), bounds=(-3, 3))
    assert tip_k <= found.x[0] + 1e-6  # decimals are cut off
    assert found.x[0] - tip_k < 2e-4  # of four decimals, and a chord of the grid
    if delay:  # without delay the point is a corner, in (5) an open one
        assert found.x[1] == pytest.approx(tip_b, abs=2e-3)  # flat there: root of the grid's error
        with mpmath.workdps(60):
            w, d = mpmath.mpf(10) ** -12, mpmath.mpf(delay)
            sin = mpmath.sin
            below = sin(2 * (d + 1) * w) - 2 * (1 + d) * sin(w)
            k = 2 * (d + 1) * (sin((d + 2) * w) - 2 * sin((d + 1) * w) + sin(d * w)) / below
            b = 2 * (d * sin((d + 1) * w) - (1 + d) * sin(d * w)) / below
        assert corner_k == pytest.approx(float(k), abs=1e-12)
        assert corner_b == pytest.approx(float(b), abs=1e-12)
