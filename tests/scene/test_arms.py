"""Devices with their sources, arms of Table II, and both together by (2) of the paper."""

import numpy as np
import pytest

from symhaptic import Arm, Scene

PHANTOM = {"sampling_period": 1e-3, "delay_samples": 1.5}


def test_at_least_eight_devices_each_with_its_source():
    found = Scene.devices()
    assert len(found) >= 8
    for name, said in found.items():
        assert len(said["source"]) > 30, name
        assert said["mass"] is not None or said["K"] is not None
        for number in ("K", "B"):  # the source of a driver's limit names it
            if said[number] and "CHAI3D" in said["source"]:
                assert f"{said[number]:g} N" in said["source"]


def test_a_device_of_unknown_mass_asks_for_one():
    with pytest.raises(ValueError, match="mass: is not published of the Novint Falcon; give one"):
        Scene.of("Novint Falcon", sampling_period=1e-3)
    assert Scene.of("Novint Falcon", mass=0.2, sampling_period=1e-3).damping is None


def test_the_explorer_has_the_same_devices():
    from symhaptic.book.site.devices import DEVICES

    for preset, (name, said) in zip(DEVICES, Scene.devices().items(), strict=True):
        assert preset.name.startswith(name)
        assert preset.source.startswith(said["source"])
        for key, number in (("m", "mass"), ("b", "damping"), ("K", "K"), ("B", "B")):
            if said[number] is not None:
                assert float(preset.values[key]) == said[number]


def test_an_arm_adds_its_mass_its_damper_and_its_spring():
    alone = Scene.of("Phantom Premium 1.5", **PHANTOM)
    arm = Arm(mass=0.5, damping=6, stiffness=40)
    held = alone.held_by(arm)
    same = Scene(mass=0.572, damping=6.005, stiffness=40.0, **PHANTOM)
    assert held == same
    walls = np.meshgrid([100.0, 3000.0, 40000.0], [0.0, 5.0, 50.0])
    assert np.array_equal(held.is_stable(*walls), same.is_stable(*walls))
    assert held.stable_region().area == pytest.approx(same.stable_region().area)


def test_an_arm_that_was_measured_with_its_device_is_not_added():
    daniel = Arm.of("Daniel et al.")
    assert daniel.with_device
    held = Scene(mass=0.3, damping=1.0, sampling_period=1e-3).held_by(daniel)
    assert (held.mass, held.damping, held.stiffness) == (1.0, 12.6, 39.5)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: Arm(mass=-1), "mass: -1 is not allowed; finite numbers >= 0 are"),
        (lambda: Arm(mass=1, stiffness=float("nan")), "stiffness: nan is not allowed"),
        (lambda: Arm.of("Hogen"), "name: 'Hogen' is not allowed; did you mean 'Hogan'"),
        (lambda: Arm.of(3), "name: 3 is not allowed"),
        (lambda: Scene.of("Omni"), "device: 'Omni' is not allowed; "),
    ],
)
def test_what_is_refused_in_one_line(call, told):
    with pytest.raises(ValueError, match="^" + told.replace("(", r"\(")) as wrong:
        call()
    assert "\n" not in str(wrong.value)


def test_pint_is_understood():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    arm = Arm(mass=500 * unit.gram, stiffness=0.04 * unit.newton / unit.millimeter)
    assert (arm.mass, arm.stiffness) == (0.5, pytest.approx(40.0))


@pytest.mark.parametrize("arm", ["Daniel", None, 1.0])
def test_only_an_arm_holds_a_device(arm):
    with pytest.raises(ValueError, match=r"^arm: .+ is not allowed; an Arm is$"):
        Scene(mass=0.3, sampling_period=1e-3).held_by(arm)
