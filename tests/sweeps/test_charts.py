"""Charts of sweeps: what is drawn has units, nothing is cut off, and no legend covers a curve."""

import dataclasses

import numpy as np
import pytest

from symhaptic import Scene

pytest.importorskip("xarray", reason="no xarray here: no sweeps")
pytest.importorskip("matplotlib", reason="no Matplotlib here: no charts")

from matplotlib.figure import Figure
from xarray import DataArray

from symhaptic.sweeps import charts, drawing

SCENE = Scene(mass=0.6, damping=6.0, stiffness=800.0, sampling_period=1e-3, delay=1e-3)
FEW = {
    charts.robust_limits: {"points": 30}, charts.stiffest: {"points": 30},
    charts.delay_margin: {"points": 10}, charts.model_costs: {},
}  # fmt: skip


@pytest.mark.parametrize("chart", FEW, ids=lambda f: f.__name__)
def test_what_is_no_scene_is_named(chart):
    with pytest.raises(ValueError, match="scene: 'free mass' is not allowed; give a Scene"):
        chart("free mass")


@pytest.mark.parametrize("scene", [None, SCENE], ids=["23", "scene"])
@pytest.mark.parametrize("chart", FEW, ids=lambda f: f.__name__)
def test_charts_have_units_and_room(chart, scene, tmp_path):
    words = dict(FEW[chart])
    if chart is charts.model_costs:
        late = np.linspace(0, 4, 5)
        words["delays"] = late if scene is None else 1e-3 * late
    figure = chart(scene, **words)
    figure.savefig(tmp_path / "chart.png")
    assert (tmp_path / "chart.png").read_bytes()[:4] == b"\x89PNG"
    renderer = figure.canvas.get_renderer()
    whole = figure.get_tightbbox(renderer)
    assert whole.x0 >= 0
    assert whole.y0 >= 0
    assert whole.x1 <= figure.get_figwidth()
    assert whole.y1 <= figure.get_figheight()
    axes = figure.axes[0]
    assert axes.get_xlabel()
    assert axes.get_ylabel()
    if scene is not None:
        every = " ".join(
            [*(a.get_ylabel() for a in figure.axes), axes.get_xlabel(), axes.get_title(loc="left")]
        )
        assert " in ms" in every or " in Ns/m" in every
        assert "N/m" in every
    legend = axes.get_legend()
    if legend is not None:
        assert not legend.get_window_extent(renderer).overlaps(axes.get_window_extent(renderer))


@pytest.mark.parametrize(("low", "springs", "arms"), [(0, "0 to 2000", 49), (2000, "2000", 7)])
def test_a_range_of_ones_own(low, springs, arms):
    """Seven arms along each side, one where both ends are the same."""
    figure = charts.robust_limits(SCENE, stiffness=(low, 2000.0), damping=(1.0, 3.0), points=20)
    (axes,) = figure.axes
    assert axes.get_title(loc="left") == f"$k$ = {springs} N/m, $b$ = 1 to 3 Ns/m"
    assert f"stable for all of {arms} arms" in [t.get_text() for t in axes.get_legend().get_texts()]


def test_a_device_without_damping_is_drawn_behind_one_period():
    """Roots of 2 z^2 (z - 1)^2 + (z + 1)(alpha z + beta (z - 1)) by NumPy: alpha < 0.144469."""
    (axes,) = charts.robust_limits(stiffness=(0, 0), damping=(0, 0), points=20).axes
    left, right = axes.get_xlim()
    assert left < 0 < 0.144469 < right < 1.2 * 0.144469
    low, high = axes.get_ylim()
    assert low < 0 < -5 * low < high


def test_the_axes_without_stiffness_and_without_damping_are_drawn():
    lines = charts.robust_limits(SCENE, points=20).axes[0].lines
    drawn = [(list(line.get_xdata()), list(line.get_ydata())) for line in lines]
    assert drawn == [([0, 1], [0, 0]), ([0, 0], [0, 1])]  # across and up, in parts of the axes
    assert {(line.get_color(), line.get_linewidth()) for line in lines} == {("black", 0.5)}


def test_without_ranges_the_axes_are_those_that_are_documented():
    """Four periods and twice the damping; all walls that are stable, from no stiffness on."""
    axes = charts.stiffest(dataclasses.replace(SCENE, damping=4.0), points=5).axes[0]
    assert axes.get_xlim() == pytest.approx((0.0, 4.0))
    assert axes.get_ylim() == pytest.approx((0.0, 8.0))
    axes = charts.delay_margin(SCENE, points=5).axes[0]
    assert (axes.get_xlim()[0], axes.get_ylim()[0]) == (0.0, 0.0)
    half = dataclasses.replace(SCENE, delay=1.5e-3).max_stable_stiffness()
    assert axes.get_xlim()[1] == pytest.approx(half.K)
    assert axes.get_ylim()[1] > half.B


def test_leaving_out_the_damper_costs_what_is_proved():
    """5 of the paper's (23) at one delay: below 6.68 % without both, 0.338 % without the spring."""
    figure = charts.model_costs(delays=[0.0, 1.0])
    spring, damper, both = (line.get_ydata()[1] for line in figure.axes[0].lines)
    assert spring == pytest.approx(0.337, abs=1e-3)
    assert damper == pytest.approx(6.705, abs=1e-2)
    assert both == pytest.approx(6.671, abs=1e-2)


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: charts.robust_limits(stiffness=0.001), "^stiffness: 0.001 .*; give (low"),
        (lambda: charts.model_costs(damping=(0, 1, 2)), "^damping: (0, 1, 2) .*; give (l"),
        (lambda: charts.stiffest(delay=(2, 1)), "^delay: (2, 1) .*; give (lowest, highest"),
        (lambda: charts.stiffest(damping=(0, "a")), "^delta: (0, 'a') .*; give (lowest"),
        (lambda: charts.stiffest(delay=2), "^delay: 2 is not allowed; give (lowest, highest)$"),
        (lambda: charts.delay_margin(K=1), "^K: 1 is not allowed; give (lowest, highest)$"),
        (lambda: charts.robust_limits(points=1), "^points: 1 .*; give whole numbers >= 2"),
        (lambda: charts.stiffest(points=2.5), "^points: 2.5 .*; give whole numbers >= 2"),
    ],
)
def test_what_is_no_range_is_told_by_its_name(ask, told):
    with pytest.raises(ValueError, match=told.replace("(", r"\(").replace(")", r"\)")):
        ask()


def test_where_no_wall_is_stable_a_picture_says_so():
    figure = charts.delay_margin(SCENE, K=(1e6, 1e7), points=10)
    (axes,) = figure.axes
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["not stable"]


def test_charts_of_a_rotary_device_have_its_units():
    knob = Scene(inertia=1e-4, damping=2e-3, stiffness=0.1, sampling_period=1e-3)
    for chart in (charts.robust_limits, charts.delay_margin):
        axes = chart(knob, points=12).axes[0]
        assert axes.get_xlabel().endswith(" in N m/rad")
        assert axes.get_ylabel().endswith(" in N m s/rad")
    title = charts.robust_limits(knob, points=12).axes[0].get_title(loc="left")
    assert title == "$k$ = 0 to 0.1 N m/rad, $b$ = 0 to 0.002 N m s/rad"
    assert charts.stiffest(knob, points=12).axes[0].get_ylabel().endswith(" in N m s/rad")


def test_colours_reach_from_the_least_to_the_largest_and_stay_beyond():
    """Infinite values have the colour of the largest; nothing is left white."""
    values = DataArray([[1.0, 40.0], [2.0, np.inf]], dims=("y", "x"))
    figure, axes = Figure(), None
    axes = figure.add_subplot()
    x, y = (DataArray([0.0, 1.0], dims=name) for name in "xy")
    drawing.filled(figure, axes, x, y, values, "K")
    low, high = figure.axes[1].get_ylim()
    assert low <= 1
    assert high >= 40
    digits = {f"{tick:e}"[0] for tick in figure.axes[1].get_yticks()}
    assert digits == {"1", "2", "5"}  # the series of coins and weights
    last = axes.collections[0].get_paths()[-1]
    assert last.contains_point((0.999, 0.999))
