"""Sweeps of scenes with parts beyond the paper's loop: each value is what the scene itself says."""

from dataclasses import replace

import numpy as np
import pytest

from symhaptic import Lag, LowPass, Scene, sweep

FILTERED = Scene(mass=0.1, damping=0.5, sampling_period=0.001, velocity=LowPass(cutoff=50))


def test_a_chart_over_damping_and_mass():
    mass, B = np.array([0.05, 0.1]), np.array([0.0, 2.0, 8.0])
    found = sweep("max_stable_stiffness", FILTERED, mass=mass, B=B)
    for m in mass:
        told = replace(FILTERED, mass=m).limit_at(B).K
        assert found.K.sel(mass=m).values.tolist() == np.asarray(told).tolist()
    assert found.attrs["velocity"].startswith("LowPass(cutoff=50.0")


@pytest.mark.parametrize("name", ["is_stable", "is_passive", "passivity_margin", "delay_margin"])
def test_walls_beside_the_scene_s_own_answers(name):
    K, B = np.array([100.0, 2000.0]), np.array([0.0, 5.0])
    found = sweep(name, FILTERED, K=K, B=B)[name]
    for k in K:
        for c in B:
            assert found.sel(K=k, B=c).item() == getattr(FILTERED, name)(k, c)


def test_the_delay_and_the_period_change_all_parts():
    scene = replace(FILTERED, actuator=Lag(time_constant=0.0005))
    found = sweep("max_stable_stiffness", scene, delay=[0.0, 0.001], sampling_period=[0.001, 0.002])
    for late in (0.0, 0.001):
        for period in (0.001, 0.002):
            own = replace(scene, delay=late or None, sampling_period=period)
            here = found.sel(delay=late, sampling_period=period)
            assert here.K.item() == own.max_stable_stiffness()
            assert here.frequency_hz.item() == own.max_stable_stiffness().frequency_hz


def test_nan_is_not_stable():
    found = sweep("is_stable", FILTERED, K=[100.0, np.nan], B=[1.0])
    assert found.is_stable.values.ravel().tolist() == [True, False]


def test_another_filter_does_not_resume_a_store(tmp_path):
    B = np.linspace(0.0, 5.0, 6)
    sweep("max_stable_stiffness", FILTERED, B=B, chunks=2, to=tmp_path / "walls.zarr")
    other = replace(FILTERED, velocity=LowPass(cutoff=60))
    with pytest.raises(ValueError, match=r"walls\.zarr"):
        sweep("max_stable_stiffness", other, B=B, chunks=2, to=tmp_path / "walls.zarr")


def test_what_such_a_scene_does_not_answer_is_refused():
    with pytest.raises(
        ValueError, match="quantity: discretize is not available for a scene with velocity"
    ):
        sweep("discretize", FILTERED)
