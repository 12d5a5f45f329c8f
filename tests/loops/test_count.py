"""Roots of loops with further parts, beside eigenvalues of matrices that know no polynomial."""

import numpy as np
import pytest
from loops.oracle import (
    HALF,
    device,
    difference_equation,
    euler_steps,
    low_pass,
    matrix,
    sizes,
)

from symhaptic.loops.actuator import Lag
from symhaptic.loops.engine import Engine
from symhaptic.loops.structure import SecondMass
from symhaptic.loops.velocity import Average, Difference, Filter, LowPass, Measured, Window


def low_passed(dice, order, mapping):
    """A low-pass of random size, and its difference equation by substitution."""
    tau = 10 ** dice.uniform(-1.5, 1.5)
    ratio = HALF if dice.random() < 0.5 else dice.uniform(0.1, 2)
    given = {"damping_ratio": ratio} if order == 2 else {}
    mine = LowPass(time_constant=tau, order=order, mapping=mapping, **given)
    return mine, difference_equation(*low_pass(tau, order, mapping, ratio))


def weighted(dice):
    new = dice.uniform(0.02, 1)
    return LowPass(weight=new), difference_equation([new], [1.0, new - 1])


def exact_pole(dice):
    tau = 10 ** dice.uniform(-1, 1.5)
    fall = np.exp(-1 / tau)
    mine = LowPass(time_constant=tau, mapping="exact pole")
    return mine, difference_equation([1 - fall], [1.0, -fall])


def mean(dice, kind, longest):
    n = int(dice.integers(1, longest))
    return kind(n), difference_equation([1 / n] * n, [1.0])


def filtered(dice):
    """A pair of poles and a real one at random in the unit circle, and any numerator."""
    pole = dice.uniform(0, 0.97) * np.exp(1j * dice.uniform(0, np.pi))
    below = np.poly([pole, pole.conj(), dice.uniform(-0.9, 0.9)]).real
    above = dice.uniform(0, 1, dice.integers(1, 5))
    above *= sum(below) / sum(above)
    return Filter(list(above), list(below)), difference_equation(list(above), list(below))


VELOCITIES = {
    "difference": lambda dice: (Difference(), difference_equation([1.0], [1.0])),
    "weight": weighted,
    "exact pole": exact_pole,
    "backward Euler": lambda dice: low_passed(dice, 1, "backward Euler"),
    "Tustin": lambda dice: low_passed(dice, 1, "Tustin"),
    "second order": lambda dice: low_passed(dice, 2, "backward Euler"),
    "second order by Tustin": lambda dice: low_passed(dice, 2, "Tustin"),
    "window": lambda dice: mean(dice, Window, 13),
    "mean": lambda dice: mean(dice, Average, 50 if dice.random() < 0.1 else 8),
    "filter": filtered,
    "measured": lambda dice: (Measured(), (None, {"past": 2, "outs": 0, "measured": True})),
}


def lag(dice):
    tau = 10 ** dice.uniform(-1.5, 1)
    return Lag(time_constant=tau), {"lag": tau}


def second(dice, sensor):
    mass, stiffness = 10 ** dice.uniform(-1, 1), 10 ** dice.uniform(-2, 1)
    damping = dice.choice([0.0, 10 ** dice.uniform(-3, 0)])
    mine = SecondMass(mass=mass, stiffness=stiffness, damping=damping, sensor=sensor)
    return mine, {"second": (mass, stiffness, damping, sensor)}


PARTS = {
    "plain": lambda dice: [],
    "lag": lambda dice: [lag(dice)],
    "handle": lambda dice: [second(dice, "handle")],
    "motor": lambda dice: [second(dice, "motor"), lag(dice)],
}

NEAR = 1e-9
"""Walls whose largest root is this near to the circle have no verdict to compare."""


def told(engine, own, dice, **more):
    """The number of roots outside and by eigenvalues, for a wall far from the boundary or near."""
    K = 10 ** dice.uniform(-4, 0.5) * dice.choice([1, 1, 1, -1])
    B = 10 ** dice.uniform(-3, 0.5) * dice.choice([1, 1, -1])
    if dice.random() < 0.5:
        near = engine.stability_boundary(dice.uniform(0, np.pi))
        if np.isfinite(near).all() and np.abs(near).max() < 100:
            K, B = (
                float(x) * (1 + dice.choice([1, -1]) * 10 ** dice.uniform(-8, -1)) for x in near
            )
    radii = sizes(matrix(*own, K, B, engine.delay, **more))
    mine = float(engine.unstable_roots(K, B))
    if np.abs(radii - 1).min() < NEAR:
        return None
    assert mine == np.sum(radii > 1), (engine, K, B, np.sum(radii > 1))
    return mine


@pytest.mark.parametrize("parts", PARTS)
@pytest.mark.parametrize("velocity", VELOCITIES)
def test_roots_beside_eigenvalues(velocity, parts, loops):
    """Each velocity with each part, resonant or free, delayed by parts of a period."""
    dice = np.random.default_rng([*map(ord, velocity + parts)])
    found = []
    for _ in range(loops):
        gamma = dice.choice([0.0, 10 ** dice.uniform(-4, 0.3)])
        delta = dice.choice([0.0, 10 ** dice.uniform(-3, 0.3)])
        delay = float(dice.choice([0, 1, dice.integers(2, 8), dice.uniform(0, 4)]))
        mine, (wall, kind) = VELOCITIES[velocity](dice)
        given = PARTS[parts](dice)
        own = {name: value for _, each in given for name, value in each.items()}
        heavy = dice.choice([0.0, 10 ** dice.uniform(-2, 0.3)])
        more = {"wall": wall, "kind": {**kind, "past": max(kind["past"], 3)}, "virtual_mass": heavy}
        each = tuple(part for part, _ in given)
        engine = Engine(gamma, delta, delay, 1.0, 1.0, mine, each, virtual_mass=heavy)
        found.append(told(engine, device(gamma, delta, **own), dice, **more))
    assert sum(each is not None for each in found) > 0.9 * loops
    assert len(set(found)) > 2  # verdicts of all kinds


@pytest.mark.parametrize("integrator", ["explicit Euler", "semi-implicit Euler"])
@pytest.mark.parametrize("velocity", ["difference", "measured", "weight"])
def test_simulators_beside_eigenvalues(integrator, velocity, loops):
    dice = np.random.default_rng([*map(ord, velocity + integrator)])
    found = []
    for _ in range(loops):
        gamma, delta = (dice.choice([0.0, 10 ** dice.uniform(-3, 0.3)]) for _ in range(2))
        mine, (wall, kind) = VELOCITIES[velocity](dice)
        delay = float(dice.integers(0, 4))
        engine = Engine(gamma, delta, delay, 1.0, 1.0, mine, integrator=integrator)
        own = device(gamma, delta)
        more = {"wall": wall, "kind": kind, "euler": euler_steps(integrator)}
        found.append(told(engine, own, dice, **more))
    assert sum(each is not None for each in found) > 0.9 * loops


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
