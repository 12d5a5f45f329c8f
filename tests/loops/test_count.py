"""Roots of loops with further parts, beside eigenvalues of matrices that know no polynomial."""

import numpy as np
import pytest
from loops.oracle import device, difference_equation, euler_steps, low_pass, matrix

from symhaptic.loops.actuator import Lag
from symhaptic.loops.engine import Engine
from symhaptic.loops.structure import SecondMass
from symhaptic.loops.velocity import Average, Difference, Filter, LowPass, Measured, Window

VELOCITIES = {
    "difference": (Difference(), difference_equation([1.0], [1.0])),
    "weight": (LowPass(weight=0.2), difference_equation([0.2], [1.0, -0.8])),
    "exact pole": (
        LowPass(time_constant=3.0, mapping="exact pole"),
        difference_equation([1 - np.exp(-1 / 3)], [1.0, -np.exp(-1 / 3)]),
    ),
    "backward Euler": (
        LowPass(cutoff=0.03),
        difference_equation(*low_pass(1 / (2 * np.pi * 0.03), 1, "backward Euler")),
    ),
    "Tustin": (
        LowPass(time_constant=2.5, mapping="Tustin"),
        difference_equation(*low_pass(2.5, 1, "Tustin")),
    ),
    "second order": (
        LowPass(time_constant=2.0, order=2),
        difference_equation(*low_pass(2.0, 2, "backward Euler")),
    ),
    "second order by Tustin": (
        LowPass(time_constant=1.5, order=2, damping_ratio=0.9, mapping="Tustin"),
        difference_equation(*low_pass(1.5, 2, "Tustin", 0.9)),
    ),
    "window": (Window(3), difference_equation([1 / 3] * 3, [1.0])),
    "long window": (Window(12), difference_equation([1 / 12] * 12, [1.0])),
    "mean of 50": (Average(50), difference_equation([1 / 50] * 50, [1.0])),
    "filter": (
        Filter([0.5, 0.1], [1.0, -0.7, 0.3]),
        difference_equation([0.5, 0.1], [1.0, -0.7, 0.3]),
    ),
    "long filter": (Filter([0.2, 0.3, 0.5]), difference_equation([0.2, 0.3, 0.5], [1.0])),
    "measured": (Measured(), (None, {"past": 2, "outs": 0, "measured": True})),
}

PARTS = {
    "plain": ((), {}),
    "lag": ((Lag(time_constant=1.7),), {"lag": 1.7}),
    "handle": (
        (SecondMass(mass=0.6, stiffness=0.3, damping=0.02, sensor="handle"),),
        {"second": (0.6, 0.3, 0.02, "handle")},
    ),
    "motor": (
        (SecondMass(mass=3.0, stiffness=0.8, damping=0.1), Lag(time_constant=0.4)),
        {"second": (3.0, 0.8, 0.1, "motor"), "lag": 0.4},
    ),
}

NEAR = 1e-7
"""Walls whose largest root is this near to the circle are not counted by eigenvalues."""


def told(engine, own, delays, rng, walls, **more):
    """Walls of which the verdicts differ, with how many there were."""
    A, b, x, v = own
    K = 10 ** rng.uniform(-4, 0.5, walls) * rng.choice([1, 1, 1, -1], walls)
    B = 10 ** rng.uniform(-3, 0.5, walls) * rng.choice([1, 1, -1], walls)
    found = engine.unstable_roots(K, B)
    wrong, seen = [], 0
    for k, c, n in zip(K, B, found, strict=True):
        roots = np.abs(np.linalg.eigvals(matrix(A, b, x, v, k, c, delays, **more)))
        if np.abs(roots - 1).min() > NEAR:
            seen += 1
            if np.sum(roots > 1) != n:
                wrong.append((k, c, n, np.sum(roots > 1)))
    return wrong, seen


@pytest.mark.parametrize("parts", PARTS)
@pytest.mark.parametrize("velocity", VELOCITIES)
def test_roots_beside_eigenvalues(velocity, parts, walls):
    """Each velocity with each part, resonant or free, delayed by parts of a period."""
    rng = np.random.default_rng([*map(ord, velocity + parts)])
    seen = 0
    for delay in (0.0, 1.0, 2.4):
        gamma = rng.choice([0.0, 10 ** rng.uniform(-4, 0.3)])
        delta = rng.choice([0.0, 10 ** rng.uniform(-3, 0.3)])
        mine, (wall, kind) = VELOCITIES[velocity]
        given, own = PARTS[parts]
        engine = Engine(gamma, delta, delay, 1.0, 1.0, mine, given)
        of = device(gamma, delta, **own)
        heavy = 0.3 if delay == 1.0 else 0.0
        kind = {**kind, "past": max(kind["past"], 3)}
        engine = Engine(gamma, delta, delay, 1.0, 1.0, mine, given, virtual_mass=heavy)
        wrong, told_ = told(engine, of, delay, rng, walls, wall=wall, kind=kind, virtual_mass=heavy)
        assert not wrong, (gamma, delta, delay)
        seen += told_
    assert seen > 2.8 * walls


@pytest.mark.parametrize("integrator", ["explicit Euler", "semi-implicit Euler"])
@pytest.mark.parametrize("velocity", ["difference", "measured", "weight"])
def test_simulators_beside_eigenvalues(integrator, velocity, walls):
    rng = np.random.default_rng([*map(ord, velocity + integrator)])
    mine, (wall, kind) = VELOCITIES[velocity]
    for delay, gamma, delta in ((0.0, 0.0, 0.0), (2.0, 0.1, 0.3)):
        engine = Engine(gamma, delta, delay, 1.0, 1.0, mine, integrator=integrator)
        of = device(gamma, delta)
        wrong, seen = told(
            engine, of, delay, rng, walls, wall=wall, kind=kind, euler=euler_steps(integrator)
        )
        assert not wrong
        assert seen > 0.9 * walls


def test_a_loop_on_its_boundary_is_not_stable():
    """Free mass, semi-implicit Euler, K = 4 m/T^2 - 2 B/T: a root at -1 exactly."""
    engine = Engine(0.0, 0.0, 0.0, 1.0, 1.0, Measured(), integrator="semi-implicit Euler")
    K = np.array([4.0 - 2 * 0.5, 3.0 * (1 - 1e-12), 0.0])
    assert engine.is_stable(K, np.full(3, 0.5)).tolist() == [False, True, False]
    assert np.isnan(engine.unstable_roots(K, np.full(3, 0.5))).tolist() == [True, False, True]


def test_nan_and_infinity_are_not_stable():
    engine = Engine(0.0, 0.01, 0.0, 1.0, 1.0, LowPass(weight=0.5))
    walls = np.array([np.nan, np.inf, -np.inf])
    assert not engine.is_stable(walls, np.zeros(3)).any()
    assert np.isnan(engine.unstable_roots(walls, np.zeros(3))).all()


def test_the_delay_costs_nothing():
    """A million periods: the wall that is stable there is below pi/2 per turn of the circle."""
    engine = Engine(1e-3, 0.5, 1e6, 1.0, 1.0, LowPass(time_constant=2.0, order=2))
    assert engine.is_stable(np.array([9e-4, 1.1e-3]), np.zeros(2)).tolist() == [True, False]
