"""A part of one's own, a notch filter: one class says its ratio, and everything else knows it."""

import math
from dataclasses import dataclass

import numpy as np
import pytest
from loops.oracle import device, difference_equation, matrix

from symhaptic import Scene
from symhaptic.loops.number import product, total
from symhaptic.loops.velocity import DIFFERENCE, Ratio, Velocity
from symhaptic.scene.controller import files


@dataclass(frozen=True)
class Notch(Velocity):
    """(s^2 + w^2)/(s^2 + w s + w^2) by Tustin's rule, prewarped at w."""

    hertz: float

    def ratio(self, period):
        t = math.tan(math.pi * self.hertz * period)
        square, sum_ = (0, 0, 1), (2, 1)  # (z - 1)^2 and z + 1 in powers of w = z - 1
        even = total(square, tuple(t * t * c for c in product(sum_, sum_)))
        middle = tuple(t * c for c in product((0, 1), sum_))
        return DIFFERENCE.times(Ratio(even, total(even, middle)))

    @property
    def words(self):
        return f"difference behind a notch at {self.hertz:g} Hz"


@pytest.fixture
def scene():
    return Scene(mass=0.1, damping=0.5, sampling_period=0.001, velocity=Notch(80.0))


def test_its_roots_beside_eigenvalues(scene):
    """The notch once more, by its coefficients in powers of 1/z from the same substitution."""
    t = math.tan(math.pi * 0.08)
    above = [1 + t * t, -2 + 2 * t * t, 1 + t * t]
    below = [1 + t + t * t, -2 + 2 * t * t, 1 - t + t * t]
    wall, kind = difference_equation(above, below)
    limit = scene.limit_at(B=5.0).K
    A = device(0.0, 0.005)
    for K, stable in ((limit * (1 - 1e-6), True), (limit * (1 + 1e-6), False)):
        step = matrix(*A, K * 1e-5, 0.05, 0.0, wall, kind)
        assert (np.abs(np.linalg.eigvals(step)).max() < 1) == stable
        assert scene.is_stable(K, 5.0) == stable


@pytest.mark.ci  # describe() computes the stiffest passive wall, which takes long
def test_the_questions_that_it_answers_without_being_named_anywhere(scene):
    assert pytest.approx(scene.max_stable_stiffness()) == scene.stable_region().max_stiffness.K
    assert scene.delay_margin(400.0, 1.0) > 0
    assert "notch at 80 Hz" in scene.describe()
    assert "notch at 80 Hz" in files(scene, 400.0, 1.0)["wall.h"]
    found = scene.simulate(400.0, 1.0, duration=0.5, position0=1e-3)
    assert abs(found.position[-50:]).max() < 0.2 * 1e-3


def test_a_notch_above_half_of_the_rate_is_unstable_and_nothing_is_passive_with_it():
    """tan(0.7 pi) < 0: its poles have the product (1 - t + t^2)/(1 + t + t^2) > 1."""
    scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, velocity=Notch(700.0))
    assert not scene.is_stable(100.0, 0.5)
    with pytest.raises(ValueError, match=r"^velocity: .*notch at 700 Hz is unstable"):
        scene.is_passive(100.0, 0.0)


@pytest.mark.ci  # a sharp notch has a worst angle that is hard to enclose
def test_its_stiffest_passive_wall(scene):
    assert scene.max_passive_stiffness() == pytest.approx(1000.0, rel=1e-12)
