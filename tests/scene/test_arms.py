"""Devices with their sources, arms of Table II, and both together by (2) of the paper."""

import numpy as np
import pytest

from symhaptic import Arm, Scene, lambdify

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
    from symhaptic.book.report.devices import DEVICES

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
    assert held.coupled == (0.572, 6.005, 40.0)
    assert held.dimensionless == same.dimensionless
    walls = np.meshgrid([100.0, 3000.0, 40000.0], [0.0, 5.0, 50.0])
    assert np.array_equal(held.is_stable(*walls), same.is_stable(*walls))
    assert held.stable_region().area == pytest.approx(same.stable_region().area)


def test_an_arm_that_was_measured_with_its_device_is_not_added():
    daniel = Arm.of("Daniel et al.")
    assert daniel.with_device
    held = Scene(mass=0.3, damping=1.0, sampling_period=1e-3).held_by(daniel)
    assert held.coupled == (1.0, 12.6, 39.5)
    assert (held.mass, held.damping, held.stiffness) == (0.3, 1.0, None)
    # 2 b/T of the device without delay (Colgate, Schenkel)
    assert held.max_passive_stiffness() == pytest.approx(2000.0)
    with pytest.raises(ValueError, match=r"^mass: 0.0 is not allowed; give finite numbers > 0$"):
        Scene(mass=0.3, sampling_period=1e-3, arm=Arm(mass=0, with_device=True))


ALONE = Scene(mass=0.072, damping=0.005, sampling_period=1e-3, delay=1.5e-3)
ARM = Arm(mass=0.5, damping=6.0, stiffness=40.0)
HELD = ALONE.held_by(ARM)
"""Phantom Premium 1.5 in the arm of Lawrence and Chapel, 1.5 ms: passive up to 3.3 N/m by (3)."""


def test_passivity_counts_the_device_alone():
    """3949 N/m and passive before: the arm's 6 Ns/m counted."""
    for scene in (
        HELD,
        Scene(mass=0.072, damping=0.005, sampling_period=1e-3, delay=1.5e-3, arm=ARM),
    ):
        assert 3.2 < scene.max_passive_stiffness() < 3.4
        assert scene.max_passive_stiffness() == ALONE.max_passive_stiffness()
        assert np.isnan(scene.max_passive_stiffness(B=5.0).K)
        assert scene.is_stable(800.0, 5.0)
        assert not scene.is_passive(800.0, 5.0)
        assert scene.passivity_margin(800.0, 5.0) == ALONE.passivity_margin(800.0, 5.0) < 0
        assert scene.passive_region() == ALONE.passive_region()
        assert not scene.passive_region().contains(800.0, 5.0)
    # without delay b > K T/2 + |B| (Colgate, Schenkel), with the damping of the device
    undelayed = Scene(mass=0.072, damping=0.005, sampling_period=1e-3, arm=ARM)
    assert undelayed.is_passive(9.999, 0.0)
    assert not undelayed.is_passive(10.001, 0.0)


def test_words_say_what_counts_for_which():
    said = HELD.describe()
    assert "arm              0.5 kg, 6 Ns/m, 40 N/m" in said
    assert "passive up to    3.289 N/m with B = 0.002027 Ns/m, at 97.76 Hz, device alone" in said
    assert "stable up to     5.43e+04 N/m with B = 197 Ns/m, at 69.85 Hz, device and arm" in said
    assert "3.289 N/m" in HELD._repr_html_()
    assert r"b_D = 0.005\,\mathrm{Ns/m}" in HELD._repr_latex_()
    assert r"b_H = 6\,\mathrm{Ns/m}" in HELD._repr_latex_()


def test_the_device_of_a_scene_has_no_arm():
    assert HELD.device == ALONE
    assert ALONE.device is ALONE
    assert HELD.arm == ARM
    assert "arm=Arm(mass=0.5" in repr(HELD)
    assert eval(repr(HELD), {"Scene": Scene, "Arm": Arm}) == HELD
    with pytest.raises(ValueError, match=r"^arm: Arm\(.* beside Arm\(.*; use scene"):
        HELD.held_by(ARM)
    with pytest.raises(ValueError, match=r"^arm: 'Hogan' is not allowed; give an Arm$"):
        Scene(mass=0.1, sampling_period=1e-3, arm="Hogan")


def test_a_device_without_damping_has_no_passive_walls_in_any_arm():
    bare = Scene(mass=0.072, sampling_period=1e-3, delay=1.5e-3, arm=ARM)
    assert bare.parts.damping
    assert bare.max_passive_stiffness() == 0
    assert bare.passive_region().area == 0
    assert not bare.is_passive(1.0, 0.0)
    assert "passive up to    nothing" in bare.describe()
    with pytest.raises(ValueError, match="a scene without damping has no passive walls"):
        lambdify("max_passive_stiffness", scene=bare)


def test_a_formula_of_a_scene_takes_the_damping_that_it_counts():
    _, delta, d = HELD.device.dimensionless
    K = lambdify("max_passive_stiffness", scene=HELD)(delta, d)[0] * 0.072 / 1e-3**2
    assert pytest.approx(HELD.max_passive_stiffness(), rel=1e-12) == K


def test_a_picture_shows_the_passive_walls_of_the_device():
    pytest.importorskip("matplotlib")
    axes = HELD.plot(800.0, 5.0)
    said = [text.get_text() for text in axes.get_legend().get_texts()]
    assert "max. passive stiffness: 3.29 N/m, 0.00203 Ns/m" in said
    assert any(text.startswith("max. stable stiffness: 54296 N/m") for text in said)
    same = ALONE.plot(arm=ARM)
    assert said[:2] == [text.get_text() for text in same.get_legend().get_texts()][:2]


def test_the_sensitivity_names_the_parameters_of_the_arm():
    found = HELD.sensitivity()
    both = Scene(mass=0.572, damping=6.005, stiffness=40.0, sampling_period=1e-3, delay=1.5e-3)
    same = both.sensitivity()
    for name, own, whole in (("mass", 0.072, 0.572), ("damping", 0.005, 6.005)):
        assert found[name] == pytest.approx(same[name] * own / whole, abs=1e-5)
        assert found[f"arm_{name}"] == pytest.approx(same[name] * (1 - own / whole), abs=1e-5)
    assert found["arm_stiffness"] == pytest.approx(same["stiffness"], abs=1e-5)
    assert found["delay"] == pytest.approx(same["delay"], abs=1e-5)


def test_systems_and_models_are_those_of_device_and_arm():
    both = Scene(mass=0.572, damping=6.005, stiffness=40.0, sampling_period=1e-3, delay=1.5e-3)
    assert HELD.to_scipy().num.tolist() == both.to_scipy().num.tolist()
    assert HELD.to_scipy().den.tolist() == both.to_scipy().den.tolist()
    assert HELD.to_sympy() == both.to_sympy()
    assert HELD.stable_region().area == pytest.approx(both.stable_region().area)
    assert HELD.stability_boundary(20.0) == both.stability_boundary(20.0)
    assert HELD.limit_at(5.0) == both.limit_at(5.0)
    assert HELD.delay_margin(800.0, 5.0) == both.delay_margin(800.0, 5.0)
    whole = {"mass": 0.5, "damping": 6.0, "stiffness": 40.0}
    device = Scene(mass=0.072, damping=0.005, sampling_period=1e-3, delay=1e-3, arm=Arm(**whole))
    same = Scene(mass=0.572, damping=6.005, stiffness=40.0, sampling_period=1e-3, delay=1e-3)
    assert str(device.simplest(0.1)) == str(same.simplest(0.1))


def test_safe_walls_of_a_scene_are_those_of_its_arm():
    safe = HELD.safe_walls()
    assert safe.arms.mass == (0.5, 0.5)
    assert safe.scene == ALONE
    assert safe.stiffest[0] > 0.9 * 54296
    assert safe.stiffest_passive[0] < 3.289
    with pytest.raises(ValueError, match=r"^arm: Arm.* beside the scene's Arm.*; "):
        HELD.safe_walls(ARM)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: Arm(mass=-1), "mass: -1 is not allowed; give finite numbers >= 0"),
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
    with pytest.raises(ValueError, match=r"^arm: .+ is not allowed; give an Arm$"):
        Scene(mass=0.3, sampling_period=1e-3).held_by(arm)
