"""The dampings for a stiffness, against roots of the closed loop and against each other."""

import itertools
import pickle

import numpy as np
import pytest
from once import registry

from symhaptic import Arm, LowPass, Scene
from symhaptic.loops.engine import Engine
from symhaptic.scene import damping

FREE = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay=1.5e-3)


def radius(scene, K, B):
    """Largest modulus of the roots of the sampled device with the wall K + B (z - 1)/(T z)."""
    device, T = scene.to_scipy(), scene.sampling_period
    loop = np.polymul(device.den, [T, 0.0])
    return np.abs(np.roots(np.polyadd(loop, np.polymul(device.num, [K * T + B, -B])))).max()


def some_scene(dice):
    mass, T = 10 ** dice.uniform(-2, 1), 10 ** dice.uniform(-4, -2)
    stiff, damped = mass / T**2, mass / T
    parts = {
        "damping": dice.choice([0.0, damped * 10 ** dice.uniform(-3, 0)]),
        "stiffness": dice.choice([0.0, stiff * 10 ** dice.uniform(-4, 0)]),
        "delay_samples": dice.choice([0, 1, 3, dice.uniform(0, 5)]),
    }
    return Scene(mass=mass, sampling_period=T, **parts)


@pytest.mark.parametrize("case", range(12))
def test_every_damping_inside_is_stable_and_none_outside(case):
    dice = np.random.default_rng(case)
    scene = some_scene(dice)
    K = scene.max_stable_stiffness() * dice.uniform(0.02, 1.1)
    found = scene.damping_for(K)
    ends = np.array(found.intervals).reshape(-1, 2)
    far = 10 * scene.mass / scene.sampling_period
    edges = np.concatenate([[-far], ends.ravel(), [far]])
    for i, (low, high) in enumerate(itertools.pairwise(edges)):
        for share in (0.001, 0.2, 0.5, 0.8, 0.999):
            B = low + share * (high - low)
            assert (radius(scene, K, B) < 1) == (i % 2 == 1)
            assert scene.is_stable(K, B) == (i % 2 == 1)
    for B in ends.ravel():
        assert radius(scene, K, B) == pytest.approx(1, abs=1e-6)


@pytest.mark.parametrize("case", range(4))
def test_no_other_damping_tolerates_more_delay(case):
    dice = np.random.default_rng(case)
    scene = some_scene(dice)
    K = scene.max_stable_stiffness() * dice.uniform(0.05, 0.95)
    found = scene.damping_for(K)
    many = [np.linspace(low, high, 100)[1:-1] for low, high in found.intervals]
    margins = scene.delay_margin(K, np.concatenate(many))
    if np.isnan(margins).all():  # not stable without delay, so that none is computed
        ((low, high),) = found.intervals
        assert float(found) == (low + high) / 2
        assert np.isnan(found.delay_margin)
        return
    assert found.delay_margin == scene.delay_margin(K, float(found))
    assert found.delay_margin >= np.nanmax(margins) * (1 - 1e-3)


FILTERED = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, velocity=LowPass(cutoff=80.0))


def test_with_a_filter_no_other_damping_tolerates_more_delay():
    found = FILTERED.damping_for(500.0)
    ((low, high),) = found.intervals
    margins = FILTERED.delay_margin(500.0, np.linspace(low, high, 9)[1:-1])
    assert found.delay_margin == FILTERED.delay_margin(500.0, float(found))
    assert found.delay_margin >= margins.max()


def test_a_fast_margin_that_is_too_large_does_not_choose(monkeypatch):
    """It is confirmed by the exact one, or the best is sought by exact ones."""
    monkeypatch.setattr(damping, "_GRID", np.array([0.2, 0.6]))
    monkeypatch.setattr(damping, "_ZOOMS", 0)
    right = FILTERED.damping_for(500.0)
    worse = np.argmin if float(right) > np.mean(right.intervals) else np.argmax

    def wrong(engine, alpha, beta):
        return np.where(np.arange(2) == worse(beta, axis=1)[:, None], 1e3, 0.5)

    monkeypatch.setattr(Engine, "most_delay", wrong)
    assert FILTERED.damping_for(500.0) == right


def test_the_free_mass_without_delay():
    """0 < K < 2 B (2 m - B T)/(T (2 m + B T)), by Jury's inequalities."""
    scene = Scene(mass=0.1, sampling_period=1e-3)
    for K in (1.0, 1e3, 5e4):
        ((low, high),) = scene.damping_for(K).intervals
        for B in (low, high):
            limit = 2 * B * (0.2 - B * 1e-3) / (1e-3 * (0.2 + B * 1e-3))
            assert limit == pytest.approx(K)


def test_the_limit_at_the_ends_is_the_stiffness():
    ((low, high),) = FREE.damping_for(1000.0).intervals
    for limit in FREE.limit_at([low, high]).K:
        assert limit == pytest.approx(1000.0)


def test_the_best_of_several_intervals(monkeypatch):
    """As loops may have that are not among these: here one interval in two parts."""
    from symhaptic.scene import damping

    whole = FREE.damping_for(1000.0)
    scale = FREE.sampling_period / FREE.mass
    (low, high), cut = whole.intervals[0], float(whole) - 1
    parts = scale * np.array([[low, cut], [cut, high]])
    monkeypatch.setattr(damping, "dampings_at", lambda *loop: parts)
    found = FREE.damping_for(1000.0)
    assert found == pytest.approx(whole, rel=1e-3)
    assert np.ravel(found.intervals) == pytest.approx([low, cut, cut, high])
    assert FREE.damping_for([1000.0]).low == pytest.approx([cut])


def test_where_no_damping_makes_it_stable_there_is_none():
    most = FREE.max_stable_stiffness()
    for K in (1.001 * most, 0.0, -1.0):
        found = FREE.damping_for(K)
        assert np.isnan(found)
        assert (found.K, found.intervals, found.delay_margin) == (K, (), 0.0)
    assert len(FREE.damping_for(0.999 * most).intervals) == 1


def test_a_damping_that_tolerates_every_delay():
    sprung = Scene(mass=1, damping=30, stiffness=1e3, sampling_period=1e-3)
    found = sprung.damping_for(1.0)
    assert found.delay_margin == np.inf
    assert sprung.delay_margin(1.0, float(found)) == np.inf


def test_many_stiffnesses_are_those_of_each_and_keep_their_labels_and_units():
    K = np.array([[1000.0, 9000.0], [1e6, 10.0]])
    found = FREE.damping_for(K)
    for i in np.ndindex(K.shape):
        one = FREE.damping_for(K[i])
        numbers = [float(one), *(one.intervals or [(np.nan, np.nan)])[0], one.delay_margin]
        assert [v[i] for v in found] == pytest.approx(numbers, nan_ok=True)
    xarray = pytest.importorskip("xarray")
    assert FREE.damping_for(xarray.DataArray(K[0], dims="wall")).B.dims == ("wall",)
    pandas = pytest.importorskip("pandas")
    assert list(FREE.damping_for(pandas.Series(K[0], index=["a", "b"])).low.index) == ["a", "b"]
    unit = registry()
    measured = FREE.damping_for(K[0] / 1000 * unit("N/mm"))
    for ours, theirs, name in zip(found, measured, ("N*s/m",) * 3 + ("s",), strict=True):
        assert theirs.to(name).magnitude == pytest.approx(ours[0])
    assert FREE.damping_for("1 N/mm") == FREE.damping_for(1000.0)
    assert FREE.damping_for(["1 N/mm", "9 N/mm"]).B.tolist() == found.B[0].tolist()


def test_an_arm_counts():
    held = FREE.held_by(Arm(mass=0.5, damping=6, stiffness=40))
    together = Scene(mass=0.6, damping=6.5, stiffness=40, sampling_period=1e-3, delay=1.5e-3)
    assert held.damping_for(800.0) == together.damping_for(800.0)


def test_it_can_be_sent_to_another_process():
    found = FREE.damping_for(1000.0)
    again = pickle.loads(pickle.dumps(found))
    assert (again, again.intervals) == (found, found.intervals)
    assert (again.K, again.delay_margin) == (found.K, found.delay_margin)


@pytest.mark.parametrize("bad", [np.nan, np.inf, "5", "5 Ns/m", True, 1j, [1.0, np.inf], None])
def test_what_is_no_stiffness_is_named(bad):
    with pytest.raises(ValueError, match=r"^K: .+ is not allowed; give (finite|real|a) number"):
        FREE.damping_for(bad)


def test_a_wall_that_is_too_large_without_its_unit_is_refused_by_its_name():
    """With T^2/m = 1e5 and T/m = 1e4, walls of 1e69 are beyond 1e70."""
    light = Scene(mass=1e-3, sampling_period=10.0)
    with pytest.raises(ValueError, match=r"^K: 1e\+69 is not allowed; give at most 1e\+70 in size"):
        light.damping_for(K=1e69)
    for limit in (light.limit_at, light.max_passive_stiffness):
        with pytest.raises(ValueError, match=r"^B: 1e\+69 is not allowed; give at most 1e\+70 in"):
            limit(B=1e69)
