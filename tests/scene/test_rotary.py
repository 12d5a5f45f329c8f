"""Devices that turn: the numbers of those that move along a line, in kg m^2, N m and rad."""

import math

import numpy as np
import pytest
from once import registry

from symhaptic import Arm, ArmRange, Scene

NUMBERS = {"damping": 2e-3, "stiffness": 0.05, "sampling_period": 1e-3, "delay": 1.5e-3}
ARM = {"damping": 1e-3, "stiffness": 0.02}
KNOB = Scene(inertia=1e-4, **NUMBERS)
LINE = Scene(mass=1e-4, **NUMBERS)


def pairs():
    """A rotary scene and the linear one of the same numbers, without an arm and with one."""
    held = KNOB.held_by(Arm(inertia=2e-4, **ARM)), LINE.held_by(Arm(mass=2e-4, **ARM))
    return [(KNOB, LINE), held]


def test_the_numbers_are_those_of_a_line():
    for knob, line in pairs():
        assert knob.coupled == line.coupled
        assert knob.dimensionless == line.dimensionless
        assert knob.max_stable_stiffness() == line.max_stable_stiffness()
        assert knob.max_passive_stiffness() == line.max_passive_stiffness()
        assert knob.limit_at([0.0, 0.01]).K.tolist() == line.limit_at([0.0, 0.01]).K.tolist()
        assert knob.damping_for(1.0).intervals == line.damping_for(1.0).intervals
        for ask in ("is_stable", "is_passive", "passivity_margin", "delay_margin", "max_delay"):
            assert getattr(knob, ask)(1.0, 0.01) == getattr(line, ask)(1.0, 0.01)
        assert knob.stability_boundary(50.0) == line.stability_boundary(50.0)
        assert knob.stable_region().area == line.stable_region().area
        assert knob.passive_region().area == line.passive_region().area
        assert [*knob.sensitivity().values()] == [*line.sensitivity().values()]
        assert knob.to_scipy().num.tolist() == line.to_scipy().num.tolist()
        assert knob.to_sympy() == line.to_sympy()
    assert next(iter(KNOB.sensitivity())) == "inertia"
    assert "arm_inertia" in pairs()[1][0].sensitivity()
    assert KNOB != LINE
    assert (KNOB.mass, LINE.inertia) == (None, None)


def test_walls_in_degrees_and_turns():
    degree, turn = math.pi / 180, 2 * math.pi
    assert KNOB.is_stable("1 N m/rad", "0.01 N m s/rad")
    for K, B in (
        (f"{degree} N m/deg", f"{0.01 * degree} N m s/deg"),
        (f"{turn} N m/turn", f"{0.01 * turn} N m s/turn"),
        ("1000 mNm/rad", f"{0.01 * turn / 60} N m/rpm"),
    ):
        assert KNOB.delay_margin(K, B) == pytest.approx(KNOB.delay_margin(1.0, 0.01))


def test_words_have_rotary_units():
    for knob, _ in pairs():
        text = knob.describe()
        for said in ("0.0001 kg m^2", "0.002 N m s/rad", "0.05 N m/rad", " N m/rad with B = "):
            assert said in text
            assert said in knob._repr_html_()
        assert "N/m" not in text
        assert "Ns/m" not in text
        assert r"J" in knob._repr_latex_()
        assert r"\mathrm{kg\,m^2}" in knob._repr_latex_()
        assert "mass" not in repr(knob)
    assert str(Arm(inertia=1e-4, damping=2e-3)) == "0.0001 kg m^2, 0.002 N m s/rad, 0 N m/rad"
    assert str(ArmRange(inertia=(0, 1e-3))).startswith(
        "0 to 0.001 kg m^2, 0 to 20 N m s/rad per kg"
    )


def test_a_picture_has_rotary_units():
    pytest.importorskip("matplotlib").use("Agg")
    axes = KNOB.plot(K="0.02 N m/deg", B=0.01)
    assert axes.get_xlabel().endswith("N m/rad")
    assert axes.get_ylabel().endswith("N m s/rad")
    assert all("N/m" not in text.get_text() for text in axes.get_legend().get_texts())


def test_quantities_of_pint_come_back_in_rotary_units():
    unit = registry()
    made = Scene(
        inertia=1 * unit("g*cm**2") * 1000, damping=2e-3 * unit("N*m*s"),
        stiffness=0.05 * unit("N*m/rad"), sampling_rate=1 * unit.kHz, delay=1.5 * unit.ms,
    )  # fmt: skip
    assert made == KNOB
    B = np.array([0.0, 0.01])
    found = KNOB.limit_at(B * math.pi / 180 * unit("N*m*s/deg"))
    names = "N*m/deg", "N*m*s/rad", "Hz"
    for ours, theirs, name in zip(KNOB.limit_at(B), found, names, strict=True):
        size = math.pi / 180 if name == "N*m/deg" else 1
        assert theirs.to(name).magnitude == pytest.approx(ours * size)
    margin = KNOB.passivity_margin(1.0, 0.01 * unit("N*m*s/rad"))
    assert margin.to("N*m*s/rad").magnitude == pytest.approx(KNOB.passivity_margin(1.0, 0.01))
    assert KNOB.stability_boundary(50 * unit.Hz)[0].check("[energy]")


def test_safe_walls_of_rotary_arms():
    ends = {"damping": (1e-3, 1e-3), "stiffness": (0.01, 0.01)}
    arms = ArmRange(inertia=(1e-4, 1e-4), **ends)
    knob, line = (
        Scene(**{name: 1e-4}, damping=2e-3, sampling_period=1e-3) for name in ("inertia", "mass")
    )
    safe = knob.safe_walls(arms)
    alike = line.safe_walls(ArmRange(mass=(1e-4, 1e-4), **ends))
    assert safe.stiffest == alike.stiffest
    assert "N m/rad with B = " in str(safe)
    K = safe.stiffest[0] / 2
    assert safe.contains(f"{K} N m/rad", safe.stiffest[1])
    with pytest.raises(ValueError, match=r"^inertia: is missing in the range of arms; the device"):
        knob.safe_walls()


def test_the_smallest_model_of_a_rotary_device():
    knob = Scene(inertia=1e-4, sampling_period=1e-3, delay=1e-3)
    line = Scene(mass=1e-4, sampling_period=1e-3, delay=1e-3)
    more = {"stiffness": ("0 N m/rad", "0.1 N m/rad"), "damping": (0, 2e-3)}
    found = knob.simplest(0.01, inertia=("1 g cm^2", 1e-4), **more)
    same = line.simplest(0.01, mass=(1e-7, 1e-4), stiffness=(0, 0.1), damping=(0, 2e-3))
    assert str(found) == str(same)
    with pytest.raises(ValueError, match="mass: this device has an inertia; give inertia="):
        knob.simplest(0.01, mass=1.0)


MIXED = [
    (lambda: Scene(mass=1, inertia=1, sampling_period=1), "inertia: 1 and mass=1 exclude"),
    (lambda: Scene(inertia="1 kg", sampling_period=1), "inertia: '1 kg' is not allowed; give a"),
    (lambda: Scene(mass="1 kg m^2", sampling_period=1), "mass: '1 kg m.2' is not allowed; give a"),
    (lambda: Scene(inertia=1, sampling_period=1, damping="1 Ns/m"), "damping: '1 Ns/m' is not al"),
    (lambda: Scene(mass=1, sampling_period=1, damping="1 N m s/rad"), "damping: '1 N m s/rad' is"),
    (lambda: KNOB.is_stable("1 N/m", 1), "K: '1 N/m' is not allowed; give a number and a unit"),
    (lambda: LINE.is_stable("1 N m/rad", 1), "K: '1 N m/rad' is not allowed; give a number and"),
    (lambda: KNOB.limit_at(B="1 Ns/m"), "B: '1 Ns/m' is not allowed; give a number and a unit"),
    (lambda: KNOB.held_by(Arm(mass=1)), r"arm: Arm\(mass=1.0, .* give Arm\(inertia=...\) for a r"),
    (lambda: LINE.held_by(Arm(inertia=1)), r"arm: Arm\(inertia=1.0, .* give Arm\(mass=...\)"),
    (lambda: KNOB.held_by(Arm.of("Hogan")), r"arm: Arm\(mass=0.8, .* give Arm\(inertia=...\)"),
    (lambda: Arm(mass=1, inertia=1), "inertia: 1 and mass=1 exclude each other; give one of them"),
    (lambda: Arm(), "mass: is missing; give mass or inertia"),
    (lambda: ArmRange.around([Arm(mass=1), Arm(inertia=1)]), "arms: some have a mass and some"),
    (lambda: Scene.of("Phantom Omni", inertia=1, sampling_period=1), "mass: is not published"),
    (lambda: Scene(inertia=1, sampling_period=1, damping=1e80).describe(), "with inertia=1.0 and"),
]  # fmt: skip


@pytest.mark.parametrize(("ask", "told"), MIXED, ids=range(len(MIXED)))
def test_what_turns_is_not_mixed_with_what_moves(ask, told):
    with pytest.raises(ValueError, match=told) as caught:
        ask()
    assert "\n" not in str(caught.value)
