"""Every question that may be asked of a scene uses its parts, or refuses them in one line."""

import math

import numpy as np
import pytest

from symhaptic import (
    Average,
    Encoder,
    Lag,
    LinearDevice,
    LowPass,
    Measured,
    Oversampled,
    Scene,
    SecondMass,
)

DEVICE = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001}
NOT_TOLD = {
    "dynamics": Scene(
        dynamics=LinearDevice([[0, 1], [0, -5]], [0, 10], [1, 0]), sampling_period=0.001
    ),
    "actuator": Scene(**DEVICE, actuator=Lag(time_constant=0.001)),
    "measured": Scene(**DEVICE, velocity=Measured()),
    "delay": Scene(**DEVICE, velocity=LowPass(cutoff=50), delay_samples=0.5),
    "simulator": Scene(**DEVICE, integrator="explicit Euler"),
}
"""Scenes for which (4) does not tell which walls are passive."""


@pytest.mark.parametrize("name", NOT_TOLD)
def test_passivity_is_refused_and_not_empty(name):
    scene = NOT_TOLD[name]
    for ask in (
        scene.passive_region,
        scene.max_passive_stiffness,
        lambda: scene.is_passive(1.0, 0.0),
        lambda: scene.passivity_margin(1.0, 0.0),
    ):
        with pytest.raises(
            ValueError, match=r"^[^\n]*passivity is not computed, ask for stability$"
        ):
            ask()


def test_a_region_without_passive_walls_is_empty():
    """A virtual mass of more than b T/2; a device without damping."""
    heavy = Scene(**DEVICE, virtual_mass=1.0)
    free = Scene(mass=0.1, sampling_period=0.001, velocity=LowPass(cutoff=50))
    for scene in (heavy, free):
        assert scene.passive_region().area == 0
        assert not scene.passive_region().outline


def test_numbers_of_any_dynamics_count_in_units_of_a_mass_of_1_kg():
    """K = alpha m/T^2 and B = beta m/T with m = 1 kg and T = 1 ms."""
    found = NOT_TOLD["dynamics"].limit(0.5, 0.25, math.pi)
    assert found == pytest.approx((5e5, 250.0, 500.0))


def test_a_simulator_has_no_windows_of_the_delay():
    with pytest.raises(ValueError, match=r"^integrator: 'explicit Euler' has no wind"):
        NOT_TOLD["simulator"].stable_delays(1.0, 0.0, up_to=0.01)


def test_long_delays_are_refused_where_every_turn_is_searched():
    scene = Scene(**DEVICE, velocity=LowPass(cutoff=50), delay_samples=1e6)
    with pytest.raises(ValueError, match=r"^delay: 1000000.0 periods are too long for passi"):
        scene.is_passive(1e-3, 0.0)
    assert not scene.is_stable(1.0, 0.0)


@pytest.mark.parametrize("part", [{"velocity": LowPass(cutoff=50)}, {"velocity": Average(5)}])
def test_of_no_walls_there_are_no_limits(part):
    scene = Scene(**DEVICE, **part)
    empty = np.zeros((0, 3))
    assert scene.limit_at(empty).K.shape == scene.damping_for(empty).B.shape == (0, 3)
    assert scene.max_passive_stiffness(empty).K.shape == (0, 3)


def test_sensitivities_of_parts_beside_central_differences():
    scene = Scene(
        **DEVICE,
        velocity=LowPass(cutoff=50),
        actuator=Lag(time_constant=0.001),
        structure=SecondMass(mass=0.02, stiffness=2000.0, damping=0.5),
        virtual_mass=0.001,
    )
    found = scene.sensitivity(B=2.0)
    for name, change in {
        "velocity_cutoff": lambda x: {"velocity": LowPass(cutoff=50 * x)},
        "actuator_time_constant": lambda x: {"actuator": Lag(time_constant=0.001 * x)},
        "structure_stiffness": lambda x: {
            "structure": SecondMass(mass=0.02, stiffness=2000.0 * x, damping=0.5)
        },
        "virtual_mass": lambda x: {"virtual_mass": 0.001 * x},
    }.items():
        own = {
            **DEVICE,
            **{part: getattr(scene, part) for part in scene.further},
        }
        more, less = (Scene(**{**own, **change(x)}).limit_at(2.0).K for x in (1.001, 0.999))
        assert found[name] == pytest.approx((more - less) / 0.002 / scene.limit_at(2.0).K, rel=1e-3)
    assert "velocity_damping_ratio" not in found  # of the first order it has none


def test_sensitivities_of_a_weight_of_1_of_two_rates_and_of_a_simulator():
    assert "velocity_weight" in Scene(**DEVICE, velocity=LowPass(weight=1.0)).sensitivity(2.0)
    fast = Scene(**DEVICE, velocity=Oversampled(LowPass(cutoff=50), 4))
    assert fast.sensitivity(2.0)["velocity_cutoff"] > 0
    given = ({"delay": 0.002}, {"delay_samples": 2.0})
    one, two = (Scene(**DEVICE, **x, integrator="explicit Euler").sensitivity(2.0) for x in given)
    assert one == pytest.approx(two, rel=1e-9)
    assert [*one] == ["mass", "damping", "sampling_period"]


def test_a_virtual_mass_takes_from_the_friction_of_an_encoder():
    """Three positions that are each wrong by half a step: K + 4 M/T^2 instead of K."""
    own = {**DEVICE, "encoder": Encoder(resolution=1e-5), "coulomb_friction": 0.002}
    free, heavy = (Scene(**own, virtual_mass=mass) for mass in (0.0, 5e-5))
    assert free.max_quantised_stiffness() == pytest.approx(400.0)
    assert heavy.max_quantised_stiffness() == pytest.approx(400.0 - 4 * 5e-5 / 0.001**2)
    for mass, friction, short in ((2e-4, 0.002, "friction"), (1.5e-3, 0.1, "damping")):
        none = Scene(**{**own, "coulomb_friction": friction}, virtual_mass=mass)
        assert math.isnan(none.max_quantised_stiffness())  # 0 is a wall of K = 0 that is passive
        assert f"nothing without B: {short} does not suffice" in none.describe()


@pytest.mark.parametrize("name", NOT_TOLD)
def test_proofs_are_of_the_loop_of_the_paper(name):
    for question, ask in (
        ("simplest", lambda: NOT_TOLD[name].simplest(0.01)),
        ("safe_walls", NOT_TOLD[name].safe_walls),
    ):
        words = rf"^[^\n]* is not allowed for {question}, whose proofs are of the paper's loop; "
        with pytest.raises(ValueError, match=words):
            ask()


def test_parts_are_in_the_latex_of_a_scene():
    scene = Scene(**DEVICE, velocity=LowPass(cutoff=50), virtual_mass=0.001)
    for words in (r"\text{velocity: difference filtered by", r"\text{virtual mass: 0.001 kg}"):
        assert words in scene._repr_latex_()
    assert r"\text" not in Scene(**DEVICE)._repr_latex_()


@pytest.mark.parametrize("integrator", ["trapezoidal", "", None, ["hold"]])
def test_an_integrator_that_is_none_is_refused(integrator):
    with pytest.raises(ValueError, match=r"^integrator: .* is not allowed; give 'hold', "):
        Scene(**DEVICE, integrator=integrator)
