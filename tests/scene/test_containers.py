"""Labels, units, masks and laziness through a scene: they come back, or one line refuses them."""

import numpy as np
import pytest
from once import registry

from symhaptic import Scene, characteristic_polynomial, is_stable, lambdify, robust_region

SCENE = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
WALLS = np.array([100.0, 4000.0])
METHODS = {
    "is_stable": "", "is_passive": "", "passivity_margin": "N*s/m", "delay_margin": "s"
}  # fmt: skip


def library(name):
    return pytest.importorskip(name, reason=f"no {name} here: its arrays are not tried")


def labelled(kind):
    """The two stiffnesses as arrays of a library, and how they are read again."""
    if kind == "xarray":
        made = library("xarray").DataArray(WALLS, dims="wall", coords={"wall": ["p", "q"]})
        return made, lambda found: (found.wall.to_numpy().tolist() == ["p", "q"], found.to_numpy())
    if kind == "pandas":
        made = library("pandas").Series(WALLS, index=["p", "q"])
        return made, lambda found: (found.index.tolist() == ["p", "q"], found.to_numpy())
    if kind == "dask":
        made = library("dask.array").from_array(WALLS, chunks=1)
        return made, lambda found: (found.chunks == ((1, 1),), found.compute(scheduler="sync"))
    made = np.ma.MaskedArray(WALLS, mask=[False, True])
    return made, lambda found: (found.mask.tolist() == [False, True], found.compressed())


@pytest.mark.parametrize("kind", ["xarray", "pandas", "dask", "masked"])
@pytest.mark.parametrize("method", METHODS)
def test_labels_and_laziness_come_back(method, kind):
    made, read = labelled(kind)
    found = getattr(SCENE, method)(K=made, B=5.0)
    assert type(found) is type(made)
    kept, numbers = read(found)
    assert kept
    wanted = np.asarray(getattr(SCENE, method)(K=WALLS, B=5.0))
    assert np.array_equal(numbers, wanted[: len(numbers)])
    assert wanted[0] == getattr(SCENE, method)(K=100.0, B=5.0)


@pytest.mark.parametrize("method", METHODS)
def test_quantities_are_converted_and_come_back(method):
    unit, xarray = registry(), library("xarray")
    wanted = getattr(SCENE, method)(K=WALLS, B=5.0)
    K, B = WALLS / 1000 * unit("N/mm"), 5.0 * unit("kg/s")
    inside = xarray.DataArray(K, dims="wall")
    for stiffness, damping in ((K, B), (K, 5.0), (WALLS, B), (inside, 5.0), (inside, B)):
        found = getattr(SCENE, method)(K=stiffness, B=damping)
        if stiffness is inside:
            assert isinstance(found, xarray.DataArray)
            found = found.data
        if METHODS[method]:
            assert isinstance(found, unit.Quantity)
            assert found.units == unit(METHODS[method]).units
            found = found.magnitude
        assert found == pytest.approx(wanted)
    with pytest.raises(
        ValueError, match=r"^K: .+ is not allowed; give a quantity that converts to N/m$"
    ):
        getattr(SCENE, method)(K=K * unit("m"), B=5.0)
    with pytest.raises(
        ValueError, match=r"^K: .+ is not allowed; give a quantity that converts to N/m$"
    ):
        getattr(SCENE, method)(K=xarray.DataArray(K * unit("m"), dims="wall"), B=5.0)


def test_the_boundary_at_a_frequency_has_units():
    unit, xarray = registry(), library("xarray")
    K, B = SCENE.stability_boundary(100.0)
    for hz in (0.1 * unit("kHz"), 100.0 * unit("1/s")):
        stiffness, damping = SCENE.stability_boundary(hz)
        assert stiffness.to("N/m").magnitude == pytest.approx(K)
        assert damping.to("N*s/m").magnitude == pytest.approx(B)
    stiffness, _ = SCENE.stability_boundary(xarray.DataArray([0.1] * unit("kHz"), dims="f"))
    assert stiffness.dims == ("f",)
    assert stiffness.data.to("N/mm").magnitude == pytest.approx([K / 1000])


@pytest.mark.parametrize("name", ["rad/s", "rpm", "degree/s", "turn/s"])
def test_a_frequency_with_an_angle_is_no_number_of_hertz(name):
    """Pint takes 1 rad/s for 1 Hz."""
    unit = registry()
    for rate in (100 * unit(name), [100.0] * unit(name)):
        with pytest.raises(ValueError, match=r"^frequency_hz: .* without an angle: 2 pi rad/s"):
            SCENE.stability_boundary(rate)


def test_one_number_in_a_container_is_that_number():
    xarray = library("xarray")
    made = Scene(mass=xarray.DataArray(0.1), damping=0.5, sampling_period=1e-3)
    assert made == SCENE
    assert SCENE.limit_at(xarray.DataArray(5.0)) == SCENE.limit_at(5.0)


def test_limits_at_many_dampings_keep_labels_units_and_laziness():
    pandas, xarray, dask = library("pandas"), library("xarray"), library("dask.array")
    unit = registry()
    B = np.array([0.0, 5.0])
    wanted = SCENE.limit_at(B)
    rows = SCENE.limit_at(pandas.Series(B, index=["a", "b"]))
    named = SCENE.limit_at(xarray.DataArray(B, dims="wall"))
    lazy = SCENE.limit_at(dask.from_array(B))
    measured = SCENE.limit_at(B / 1000 * unit("N*s/mm"))
    assert list(rows.K.index) == ["a", "b"]
    assert named.frequency_hz.dims == ("wall",)
    for found in (rows, named, [one.compute() for one in lazy]):
        assert [list(one) for one in found] == [list(one) for one in wanted]
    for one, expected, name in zip(measured, wanted, ("N/m", "N*s/m", "Hz"), strict=True):
        assert one.to(name).magnitude == pytest.approx(expected)


@pytest.mark.parametrize("name", ["max_stable_stiffness", "max_passive_stiffness"])
def test_the_stiffest_walls_of_many_dampings_keep_labels_units_and_laziness(name):
    pandas, xarray, dask = library("pandas"), library("xarray"), library("dask.array")
    unit = registry()
    asked, B = getattr(SCENE, name), np.array([0.0, 0.2])
    wanted = [[asked(b).K for b in B], B.tolist(), [asked(b).frequency_hz for b in B]]
    rows = asked(pandas.Series(B, index=["a", "b"]))
    named = asked(xarray.DataArray(B, dims="wall"))
    assert list(rows.K.index) == ["a", "b"]
    assert named.frequency_hz.dims == ("wall",)
    for found in (rows, named, [one.compute() for one in asked(dask.from_array(B))]):
        assert [list(one) for one in found] == wanted
    measured = asked(B / 1000 * unit("N*s/mm"))
    for one, expected, name in zip(measured, wanted, ("N/m", "N*s/m", "Hz"), strict=True):
        assert one.to(name).magnitude == pytest.approx(expected)
    assert asked(0.2 * unit("N*s/m")) == asked(0.2)


def test_a_bound_takes_units():
    unit = registry()
    arm = Scene(mass=1.0, damping=2.0, stiffness=50.0, sampling_period=1e-3, delay=1e-3)
    found = arm.simplest(0.01, damping=(0.0 * unit("N*s/m"), 20.0 * unit("kg/s")))
    assert str(found) == str(arm.simplest(0.01, damping=(0.0, 20.0)))


def test_what_cannot_be_kept_is_refused_on_one_line():
    pandas = library("pandas")
    walls, words = pandas.Series(WALLS), pandas.Series(["a", "b"])
    refused = {
        "damping": lambda: Scene(mass=0.1, damping=walls, sampling_period=1e-3),
        "B": lambda: SCENE.limit_at(words),
        "alpha": lambda: SCENE.limit(walls, 1.0, 1.0),
        "K": lambda: SCENE.is_stable(words, 1.0),
        "beta": lambda: is_stable(0.1, words, 0.0, 0.0, 0.0),
        "stiffness": lambda: SCENE.simplest(0.01, stiffness=walls),
        "delta": lambda: robust_region(walls, 0.0),
        "gamma": lambda: characteristic_polynomial(0.1, 0.1, walls, 0.0, 0),
    }
    for name, call in refused.items():
        with pytest.raises(ValueError, match=rf"^{name}: .+ give .+$") as caught:
            call()
        assert "\n" not in str(caught.value)


def test_printed_forms_keep_labels_by_the_library_itself():
    xarray = library("xarray")
    found = lambdify("eq11", form="derived")(1.0, 1e-3, xarray.DataArray([0.0, 1.0], dims="d"))
    assert found[0].dims == ("d",)
