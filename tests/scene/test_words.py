"""What a scene says of itself, draws, and depends on."""

import numpy as np
import pytest

from symhaptic import Arm, Encoder, Lag, LowPass, Measured, Scene
from symhaptic.scene.chart import draw_chart
from symhaptic.scene.picture import STABLE, draw
from symhaptic.scene.walls import passive_region

SCENE = {"mass": 0.1, "damping": 2.0, "stiffness": 50.0, "sampling_period": 1e-3, "delay": 1.5e-3}


@pytest.mark.parametrize("B", [None, 20.0])
def test_units_alone_tell_sums_of_the_sensitivities(B):
    """Masses, dampers, springs and walls c times as large, and times c times as long, are the same.

    With a given B the limit is no quantity that scales along, but for B itself.
    """
    found = Scene(**SCENE).sensitivity(B)
    by_B = 0.0
    if B is not None:
        more, less = (Scene(**SCENE).limit_at(B=B * (1 + h)).K for h in (1e-4, -1e-4))
        by_B = (more - less) / (2e-4 * Scene(**SCENE).limit_at(B=B).K)
    m, b, k, T, late = (found[name] for name in SCENE)
    assert m + b + k + by_B == pytest.approx(1, abs=1e-5)
    assert T + late - b - 2 * k - by_B == pytest.approx(-2, abs=1e-5)


def test_a_sensitivity_tells_what_a_change_does():
    scene = Scene(**SCENE)
    more = Scene(**{**SCENE, "mass": 0.101}).max_stable_stiffness()
    told = 1 + 0.01 * scene.sensitivity()["mass"]
    assert more / scene.max_stable_stiffness() == pytest.approx(told, rel=1e-4)
    assert scene.sensitivity().keys() == SCENE.keys()
    assert "damping" not in Scene(mass=1.0, sampling_period=1e-3, damping=0.0).sensitivity()


def test_limits_at_many_dampings_are_those_at_each():
    scene = Scene(**SCENE)
    B = np.array([[0.0, 5.0], [30.0, 1e6]])
    found = scene.limit_at(B)
    assert found.K.shape == found.frequency_hz.shape == B.shape
    for K, hz, damping in zip(found.K.flat, found.frequency_hz.flat, B.flat, strict=True):
        one = scene.limit_at(B=float(damping))
        assert (K, hz) == pytest.approx((one.K, one.frequency_hz), nan_ok=True)
    assert np.isnan(found.K[1, 1])
    with pytest.raises(ValueError, match="B: "):
        scene.limit_at([1.0, np.inf])


@pytest.mark.parametrize("periods", [0, 0.1, 0.5, 1, 1.5, 4])
def test_the_passive_region_holds_passive_walls_and_hardly_leaves_one_out(periods):
    scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay_samples=periods)
    region = scene.passive_region()
    (outline,) = region.outline
    centre = outline[:-1].mean(axis=0)
    for share, good in ((0.999, True), (1.02, False)):
        some = centre + share * (outline[:-1] - centre)
        some = some[some[:, 0] > 0]
        assert scene.is_passive(*some.T).all() == good
        assert scene.is_passive(*some.T).any() == good
    assert region.max_stiffness == scene.max_passive_stiffness()
    assert not Scene(mass=0.1, sampling_period=1e-3).passive_region().outline


def test_corners_of_the_passive_region_with_a_filter_are_on_its_border():
    scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, velocity=LowPass(cutoff=50))
    (outline,) = passive_region(scene, corners=8).outline
    stiff = outline[:-1][outline[:-1, 0] > 0]
    assert len(stiff) > 4
    assert scene.is_passive(*(0.999 * stiff).T).all()
    assert not scene.is_passive(1.001 * stiff[:, 0], stiff[:, 1]).any()


def test_words_have_units_and_agree_with_the_limits():
    scene = Scene(**SCENE)
    text, html = scene.describe(), scene._repr_html_()
    for said in ("0.1 kg", "2 Ns/m", "50 N/m", "1.5 sampling periods", "N/m with B = ", " Hz"):
        assert said in text
        assert said in html
    assert f"{scene.max_stable_stiffness():.4g} N/m" in text
    assert (
        "nothing, because the device has no damping"
        in Scene(mass=1.0, sampling_period=1e-3).describe()
    )
    assert r"\gamma = 0.0005" in scene._repr_latex_()


def test_help_shows_units():
    for unit in ("kg", "Ns/m", "N/m"):
        assert unit in Scene.__doc__
        assert unit in Arm.__doc__
    for name, method in vars(Scene).items():
        if callable(method) and not name.startswith("_") and name not in ("replace",):
            assert method.__doc__, name


def test_a_delay_in_s_that_was_meant_in_periods_is_remarked():
    with pytest.warns(UserWarning, match=r"1500 sampling periods; .* is delay_samples=1.5"):
        Scene(mass=0.1, sampling_period=1e-3, delay=1.5)


@pytest.fixture
def axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot.subplots(figsize=(7.2, 4.4), layout="constrained")[1]
    pyplot.close("all")


@pytest.mark.parametrize("wall", [(), (90000.0, 20.0)])
def test_a_picture_has_units_and_a_legend_beside_the_curves(axes, wall):
    assert Scene(**SCENE).plot(*wall, axes=axes) is axes
    axes.figure.canvas.draw()
    assert axes.get_xlabel().endswith("N/m")
    assert axes.get_ylabel().endswith("Ns/m")
    frame, legend = axes.get_window_extent(), axes.get_legend().get_window_extent()
    assert legend.y1 < frame.y0
    assert legend.x0 >= 0
    assert legend.x1 <= axes.figure.bbox.x1
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    edge, *marks = axes.lines
    assert np.nanmin(edge.get_xdata()) < 0 < np.nanmax(edge.get_xdata()) < 1.5 * right
    crosses = [m for m in marks if m.get_marker() == "x"]
    assert [(*m.get_xdata(), *m.get_ydata()) for m in crosses] == ([wall] if wall else [])
    for mark in (m for m in marks if m.get_marker() != "None"):
        assert left < mark.get_xdata()[0] < right
        assert bottom < mark.get_ydata()[0] < top


@pytest.mark.parametrize("more", [{}, {"velocity": LowPass(cutoff=50)}], ids=str)
@pytest.mark.parametrize("draw", [draw, draw_chart])
def test_what_a_picture_shows_as_stable_is_stable(draw, more, axes):
    """Points all over the picture, of which few may lie within its resolution of the boundary."""
    from matplotlib.colors import to_rgba

    scene = Scene(**SCENE, **more)
    draw(axes, scene, (3000.0, 20.0))
    rng = np.random.default_rng(1)
    ends = np.array([axes.get_xlim(), axes.get_ylim()])
    assert (np.array([3000.0, 20.0]) < ends[:, 1]).all()
    walls = rng.uniform(*ends.T, size=(500, 2))
    shapes = [path for kind in axes.collections for path in kind.get_paths()]
    shapes += [one.get_path() for one in axes.patches if one.get_facecolor() == to_rgba(STABLE)]
    shown = np.any([path.contains_points(walls) for path in shapes if len(path)], axis=0)
    stable = scene.is_stable(*walls.T)
    assert 50 < stable.sum() < 450
    assert (shown == stable).mean() > 0.98


def test_a_picture_fits_a_column_with_fonts_that_journals_take(tmp_path):
    """Everything within 3.5 in, and Type 42 fonts, whatever the settings of Matplotlib are."""
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure = Scene(**SCENE).plot(3000.0, 20.0).figure
    figure.canvas.draw()
    whole = figure.get_tightbbox()
    assert figure.get_figwidth() == 3.5
    assert 0 <= whole.x0 < whole.x1 <= 3.5
    assert 0 <= whole.y0 < whole.y1 <= figure.get_figheight()
    assert all(text.get_size() >= 7 for text in figure.axes[0].get_legend().get_texts())
    pyplot.savefig(tmp_path / "walls.pdf")
    written = (tmp_path / "walls.pdf").read_bytes()
    assert b"/CIDFontType2" in written
    assert b"/Type3" not in written
    pyplot.close("all")


def test_half_a_wall_is_refused():
    with pytest.raises(ValueError, match=r"K: 3.0 with B=None is no wall"):
        Scene(**SCENE).plot(K=3.0)


def test_the_limit_with_an_encoder_knows_the_delay_and_no_filter():
    """Without virtual damping the filter of the velocity does not matter."""
    own = {"mass": 0.04, "damping": 0.8, "sampling_period": 1e-3, "coulomb_friction": 0.1}
    for periods, velocity in ((0, None), (1.5, Measured()), (3, LowPass(cutoff=50))):
        scene = Scene(**own, delay_samples=periods, encoder=Encoder(resolution=1e-5))
        passive = scene.max_passive_stiffness(B=0.0)
        filtered = Scene(
            **own, delay_samples=periods, velocity=velocity, encoder=Encoder(resolution=1e-5)
        )
        for each in (scene, filtered):
            found = each.max_quantised_stiffness()
            assert (found, found.B) == (pytest.approx(passive), 0.0)
            assert "limited by damping; friction would allow 2e+04 N/m" in each.describe()
        fine = Scene(**own, delay_samples=periods, encoder=Encoder(resolution=1e-3))
        assert fine.max_quantised_stiffness() == pytest.approx(min(passive, 200.0))


def test_the_limit_with_an_encoder_is_not_told_without_one_or_behind_an_actuator():
    own = {"mass": 0.04, "damping": 0.8, "sampling_period": 1e-3, "coulomb_friction": 0.1}
    with pytest.raises(ValueError, match="encoder: is left out"):
        Scene(**own).max_quantised_stiffness()
    behind = Scene(**own, actuator=Lag(time_constant=1e-3), encoder=Encoder(resolution=1e-5))
    assert "with encoder" not in behind.describe()
    with pytest.raises(ValueError, match="without a lag"):
        behind.max_quantised_stiffness()
    undamped = Scene(mass=0.04, sampling_period=1e-3, encoder=Encoder(resolution=1e-5))
    assert undamped.max_quantised_stiffness() == 0
    assert "with encoder     nothing: without Coulomb friction, the steps" in undamped.describe()
