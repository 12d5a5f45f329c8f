"""Walls in N/m and Ns/m beside eigenvalues of the loop in SI units and the energy per period."""

import numpy as np
import pytest
from test_scene import DEVICE, spectral_radius

from symhaptic import Scene

M, D, S, T = (DEVICE[n] for n in ("mass", "damping", "stiffness", "sampling_period"))


def late(periods):
    return Scene(**DEVICE, delay_samples=periods)


@pytest.mark.parametrize("periods", [0, 1, 3])
def test_stable_walls_are_those_whose_eigenvalues_lie_inside(periods):
    rng = np.random.default_rng(periods)
    K, B = rng.uniform(-50, 0.6 * M / T**2 / (periods + 1) ** 2, 150), rng.uniform(-5, 120, 150)
    seen = [spectral_radius(k, b, M, D, S, T, periods) for k, b in zip(K, B, strict=True)]
    found = late(periods).is_stable(K, B)
    assert found.tolist() == [x < 1 for x in seen]
    assert 5 < found.sum() < 145
    assert late(periods).stable_region().contains(K, B).tolist() == found.tolist()


@pytest.mark.parametrize("periods", [0, 1, 2])
def test_the_passive_margin_is_what_every_frequency_leaves(periods):
    """(3) and (4) of the paper in SI units, over a grid of frequencies.

    b > T/2/(1 - cos wT) Re[(1 - exp(-jwT)) H exp(-jwTd)], H = K + B (1 - exp(-jwT))/T.
    """
    w = np.linspace(1e-3, np.pi, 20001) / T
    step = 1 - np.exp(-1j * w * T)
    for K, B in ((100.0, 0.0), (150.0, 0.1), (900.0, -0.05), (30.0, 2.0)):
        wall = (K + B * step / T) * np.exp(-1j * w * T * periods)
        needed = (T / 2 / (1 - np.cos(w * T)) * (step * wall).real).max()
        margin = late(periods).passivity_margin(K, B)
        assert margin == pytest.approx(D - needed, abs=1e-5 * (abs(K) * T + abs(B)))
        assert late(periods).is_passive(K, B) == (margin >= 0)


@pytest.mark.parametrize("periods", [0, 1, 4])
def test_a_wall_of_the_boundary_swings_at_its_frequency(periods):
    f = np.array([3.0, 30.0, 150.0])
    for K, B, hz in zip(*late(periods).stability_boundary(f), f, strict=True):
        z = np.exp(2j * np.pi * hz * T)
        # x at this z: the device is m x'' + b x' + k x = F held over T
        A = np.array([[0, 1], [-S / M, -D / M]])
        vals, vecs = np.linalg.eig(A)
        into = np.linalg.solve(vecs, [0, 1 / M])
        held = ((np.exp(vals * T) - 1) / vals) * into
        device = (vecs[0] * held / (z - np.exp(vals * T))).sum()
        loop = 1 + device * (K + B * (1 - 1 / z) / T) / z**periods
        assert abs(loop) < 1e-9 * (1 + abs(device) * (abs(K) + abs(B) / T))


def test_the_region_in_si_units_has_the_limits_of_the_scene():
    scene = late(1)
    region = scene.stable_region()
    best = scene.max_stable_stiffness()
    assert region.max_stiffness == pytest.approx((best.K, best.B, best.frequency_hz), rel=1e-9)
    (outline,) = region.outline
    # the outline is the border: just inside by eigenvalues stable, just outside not
    centre = outline[:-1].mean(axis=0)
    for share, good in ((0.99, True), (1.01, False)):
        some = centre + share * (outline[::40] - centre)
        assert [spectral_radius(*w, M, D, S, T, 1) < 1 for w in some] == [good] * len(some)
    x, y = outline.T
    shoelace = abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2
    assert region.area == pytest.approx(shoelace, rel=1e-9)


def test_one_wall_gives_a_number_and_arrays_broadcast():
    scene = late(0)
    assert type(scene.is_stable(100.0, 1.0)) is bool
    assert type(scene.is_passive(100, 1)) is bool
    assert type(scene.passivity_margin(100.0, 1.0)) is float
    assert all(type(x) is float for x in scene.stability_boundary(10.0))
    assert scene.is_stable(np.ones((4, 1)), [1.0, 2.0, 3.0]).shape == (4, 3)
    assert not scene.is_stable(np.nan, 1.0)
    assert np.isnan(scene.passivity_margin(1.0, np.nan))


@pytest.mark.parametrize("name", ["is_stable", "is_passive", "passivity_margin"])
def test_what_is_no_wall_is_named(name):
    ask = getattr(late(0), name)
    with pytest.raises(ValueError, match=r"^K: inf is not allowed; give finite numbers$"):
        ask(np.inf, 1.0)
    with pytest.raises(ValueError, match=r"^B: '1' is not allowed; give a number and a unit"):
        ask(1.0, "1")
    with pytest.raises(ValueError, match=r"^K: 1e\+75 is not allowed; give numbers up to"):
        ask(1e75, 1.0)


@pytest.mark.parametrize("damping", [1e300, -1e290, [1.0, 1e300]])
@pytest.mark.parametrize("name", ["max_stable_stiffness", "max_passive_stiffness", "limit_at"])
def test_a_damping_that_is_too_large_is_named_as_it_was_given(name, damping):
    with pytest.raises(ValueError, match=r"^B: -?1e\+\d+ is not allowed; "):
        getattr(late(0), name)(B=damping)


@pytest.mark.parametrize("bad", [0.0, -1.0, 1e9, np.inf])
def test_what_is_no_frequency_is_named(bad):
    with pytest.raises(ValueError, match=r"^frequency_hz: .+ .*; give numbers 0 < freq"):
        late(0).stability_boundary([1.0, bad])


def test_labels_and_units_go_with_a_wall():
    xarray = pytest.importorskip("xarray", reason="no xarray here: its arrays are not tried")
    pint = pytest.importorskip("pint", reason="no Pint here: its quantities are not tried")
    K = xarray.DataArray([100.0, 1e6], dims="K")
    B = xarray.DataArray([0.0, 1.0, 2.0], dims="B")
    found = late(0).is_stable(K, B)
    assert dict(found.sizes) == {"K": 2, "B": 3}
    assert found.values.tolist() == late(0).is_stable([[100.0], [1e6]], [0.0, 1.0, 2.0]).tolist()
    unit = pint.UnitRegistry()
    same = late(0).passivity_margin(1 * unit("N/mm"), 5 * unit("N*s/m"))
    assert same.m_as("N*s/m") == late(0).passivity_margin(1000.0, 5.0)
    with pytest.raises(
        ValueError, match=r"^K: .+ is not allowed; give a quantity that converts to N/m$"
    ):
        late(0).is_stable(1 * unit.N, 1.0)
