"""What parts cost: searches with eigenvalues beside the bounds in balls."""

from itertools import product

import numpy as np
import oracle
import pytest
from oracles.guarding import guards
from oracles.search import edge, first_arc, stiffest
from oracles.subject import number, only, page, shown

COSTS, UNDAMPED = "s5d_what_each_part_costs", "s5b_stiffest_wall_undamped"


def largest(gamma, delta, delay):
    """Over all walls; the best damping is about 0.83/(delay + 1)."""
    low, high = 0.3 / (delay + 1), 1.3 / (delay + 1)
    return stiffest(gamma, delta, delay, low, high, top=1.5)[0]


def off(beta, gamma, delta, delay):
    """The error of (25): small walls are stable up to one stiffness."""
    exact = edge(1e-7, 0.2, lambda x: oracle.stable(x, beta, gamma, delta, delay), steps=40)
    return (beta + delta) / (delay + 0.5) / exact - 1


def table():
    (found,) = [block for block in page(COSTS).blocks if block.kind == "table"]
    head, *rows = found.rows
    assert list(head[1:]) == ["$d=0$", "$d=1$", "$d=2$"]
    return {row[0]: [float(cell) / 100 for cell in row[1:]] for row in rows}


@guards("s5d_what_each_part_costs")
def test_the_costs_are_those_of_a_search():
    """The largest errors are at the far corner, or without a spring; none inside is larger."""
    rng = np.random.default_rng(5)
    inside = [tuple(rng.uniform(0, 1, 2) * (1e-3, 0.02)) for _ in range(3)]
    arms = [(1e-3, 0.02), (0.0, 0.02), (1e-3, 0.0), *inside]
    for delay in (0, 1, 2):
        seen = dict.fromkeys(("Without the spring", "Without the damper", "Without both"), 0.0)
        for gamma, delta in arms:
            full = largest(gamma, delta, delay)
            for title, less in zip(seen, ((0.0, delta), (gamma, 0.0), (0.0, 0.0)), strict=True):
                seen[title] = max(seen[title], abs(largest(*less, delay) / full - 1))
        for title, error in seen.items():
            bound = table()[title][delay]
            assert error <= bound + 1e-9
            assert error >= bound * 0.97 - 1e-5  # one per cent, and the rounding up


@guards("s5d_what_each_part_costs")
def test_the_linear_condition_costs_what_it_does_by_trying():
    for delay in (0, 1, 2):
        walls = product((0.0, 0.007, 0.02), (0.0, 1e-3), (0.01, 0.013, 0.02))
        worst = max(abs(off(*wall, delay)) for wall in walls)
        bound = table()["The linear condition (25)"][delay]
        assert 0.97 * bound - 1e-5 <= worst <= bound + 1e-9


@guards("s5b_stiffest_wall_undamped")
@pytest.mark.parametrize(("gamma", "delay"), [(1e-3, 1), (1e-3, 3), (0.02, 1), (0.0, 2)])
def test_an_undamped_arm_has_its_stiffest_wall_on_the_arc(gamma, delay):
    arc = float(first_arc(gamma, 0, delay))
    assert largest(gamma, 0.0, delay) == pytest.approx(arc, rel=1e-6)


@guards("s5b_stiffest_wall_undamped")
def test_the_plant_without_damping_on_the_circle():
    def agrees(ratio, force):
        for gamma, theta, delay in ((0.3, 0.7, 2), (0.001, 0.2, 5)):
            n1, n0, a, e = (float(x) for x in oracle.numbers(gamma, 0))
            assert n1 == pytest.approx(n0)
            assert e == pytest.approx(1)
            z = np.exp(1j * theta)
            assert number(ratio, a=a, theta=theta) == pytest.approx((z - a + e / z).real)
            wanted = np.exp(1j * theta * (delay + 0.5)) * (z * z - a * z + e) / (n1 * z + n0)
            values = {"theta": theta, "d": delay, "a": a, "n_0": n0}
            at = {s: values[s.name] for s in force.free_symbols}
            assert complex(force.subs(at).evalf()) == pytest.approx(wanted)

    only(
        agrees,
        shown(UNDAMPED, "Without damping the plant is real on the circle"),
        shown(UNDAMPED, "With its delay the force is real times a turn"),
    )
