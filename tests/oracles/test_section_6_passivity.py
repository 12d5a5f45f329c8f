"""Passivity with a delay of any length: energies of motions in two parts per period."""

import numpy as np
import oracle
import pytest
import sympy as sp
from oracles import energy
from oracles.guarding import guards
from oracles.search import edge
from oracles.subject import decimals, meant, number, only, settled, shown

pytestmark = pytest.mark.ci

LATES = (0.1, 0.5, 0.8)


@guards("s6d_fractional_passivity")
@pytest.mark.parametrize("late", [0.5, 0.2, 1.7])
def test_the_fractional_condition_is_that_of_motions_with_two_parts(late):
    b, T = 1.6, 1e-3
    angles = np.linspace(0.004, np.pi - 0.004, 120)

    def agrees(margin):
        for direction in (-0.6, 0.2, 0.9, 1.3):
            K, B = np.cos(direction) / T, np.sin(direction)

            def passive(scale, K=K, B=B):
                at = {"K": scale * K, "B": scale * B, "b": b, "T": T}
                at |= {"l": int(late), "epsilon": late % 1}
                return all(number(margin, theta=t, **at) >= 0 for t in angles)

            scale = edge(0.01, 20.0, passive, steps=9)  # to 4 per cent over 512
            assert energy.left(0.985 * scale * K, 0.985 * scale * B, b, T, late, 100) > -1e-12
            # 100 periods miss by some (d+1)^2 pi^2/100^2 = 0.007, which is 2 and more per cent of
            # a wall whose damping is negative: such walls lose most where their stiffness gains
            assert energy.left(1.1 * scale * K, 1.1 * scale * B, b, T, late, 100) < 0

    (condition,) = settled("s6d_fractional_passivity", "fractional-passivity")
    assert condition.rel_op == ">="
    # theta only runs; a factor does not change the sign
    agrees(condition.lhs)
    for name in ("K", "B", "b", "T", "l", "epsilon"):
        if name in ("l", "epsilon") and late != 1.7:
            continue
        (symbol,) = (s for s in condition.lhs.free_symbols if s.name == name)
        with pytest.raises(AssertionError):
            agrees(condition.lhs.xreplace({symbol: 1.4 * symbol}))


@guards("s6e_fractional_passive_is_stable")
def test_walls_that_give_no_energy_away_are_stable_at_fractional_delays():
    rng = np.random.default_rng(92)
    found = 0
    while found < 60:
        late, delta = rng.uniform(0, 3), rng.uniform(0.02, 2)
        direction, gamma = rng.uniform(-1.5, 1.5), rng.choice([0.0, 1e-3, rng.uniform(0, 12)])
        wall = (
            delta
            * rng.uniform(0.3, 2)
            / (late + 0.5)
            * np.array([np.cos(direction), np.sin(direction)])
        )
        if energy.left(*wall, delta, 1.0, late, 50) < 0.02:
            continue
        found += 1
        assert oracle.stable(*wall, gamma, delta, late)
    # a wall that gives energy away need not be
    assert energy.left(0.5, 0.0, 0.1, 1.0, 0.5, 50) < 0
    assert not oracle.stable(0.5, 0.0, 0.0, 0.1, 0.5)


REGION = "s6e_fractional_region"


@guards("s6e_fractional_region")
def test_low_frequencies_bend_the_lower_part():
    def agrees(low):
        for late, B in ((0.5, -0.4), (1.3, 0.1)):
            at = {"B": B, "b": 1.0, "T": 1.0, "l": int(late), "epsilon": late % 1}
            for K in (0.2, 0.7):
                # rounding over theta, and the next term, of its square
                found = energy.determinant(K, B, late, 1e-4)
                assert number(low, K=K, **at) == pytest.approx(found, abs=1e-6)
            K = edge(0.0, 4.0, lambda k, at=at: number(low, K=k, **at) > 0)
            assert energy.left(0.99 * K, B, late=late) > -1e-12
            assert energy.left(1.04 * K, B, late=late) < 0

    low = shown(REGION, "At low frequencies the condition is (9) with one more term")
    only(agrees, low)
    # half a period late, B = 0: 0.944 b in place of the paper's 1
    at = {"B": 0, "b": 1, "T": 1, "l": 0, "epsilon": 0.5}
    assert edge(0.0, 4.0, lambda k: number(low, K=k, **at) > 0) == pytest.approx(0.944, abs=5e-4)


@guards("s6e_fractional_region")
def test_without_stiffness_the_damping_ends_at_minus_b_and_above_b():
    for late in LATES:
        assert energy.left(0.0, -0.99, late=late) > -1e-12
        assert energy.left(0.0, -1.03, late=late) < 0
        assert energy.left(0.0, 1.02, late=late) > 0

    def agrees(lower, upper):
        for late, theta in ((0.2, 0.5), (1.5, 1.9), (2.8, 2.7)):
            at = {"l": int(late), "epsilon": late % 1, "theta": theta}
            found = energy.determinant(0, -1, late, theta)
            assert number(lower, **at) == pytest.approx(found, abs=1e-13)
            found = energy.determinant(0, 1, late, theta)
            assert number(upper, **at) == pytest.approx(found, abs=1e-13)

    titles = ("The damping $-b$ is passive", "The damping $b$ is passive, with a positive margin")
    only(agrees, *(shown(REGION, title) for title in titles))
    # the ends that the theorem names: one that is passive, one beyond which none is
    for late in LATES:
        end = 1 + late * (1 - late) * np.sin(np.pi / 8) ** 2 / 2
        assert energy.left(0.0, end, late=late) > 0
        assert energy.left(0.0, 1.02 / late, late=late) < 0


STIFF = "s6f_half_a_period_passive"


@guards("s6f_half_a_period_passive")
def test_the_stiffest_and_the_most_damped_wall_half_a_period_late():
    damping, stiffness = (
        float(n)
        for n in decimals(
            STIFF, "Intervals contain the end of the upper part and the maximum stiffness"
        )
    )
    assert energy.left(0.995 * stiffness, 0.324, late=0.5) > 0
    tried = [energy.left(1.01 * stiffness, B, late=0.5) for B in np.linspace(-0.2, 1, 25)]
    assert max(tried) < 0
    assert energy.left(0.0, 0.995 * damping, late=0.5) > 0
    assert energy.left(0.0, 1.01 * damping, late=0.5) < 0
    # the wall of (11), 2 tan(pi/6) and (cos(pi/3) - 1/3)/sin(pi/3)
    assert energy.left(2 / np.sqrt(3), (0.5 - 1 / 3) / np.sin(np.pi / 3), late=0.5) < 0
    # and a delay that helps
    assert energy.left(0.0, 1.2, late=0.5) > 0
    assert max(energy.left(0.0, 1.2, late=late) for late in (0, 1)) < 0

    def agrees(quadratic, double):
        for K, B in ((0.3, 0.9), (1.1, -0.2)):
            for theta in (0.5, 2.0):
                found = energy.determinant(K, B, 0.5, theta)
                assert number(quadratic, theta=theta, K=K, B=B) == pytest.approx(found, abs=1e-13)
            angles = np.array([0.5, 1.5, 2.5])
            bend, fall, rest = np.polyfit(
                np.cos(angles / 2) ** 2, [energy.determinant(K, B, 0.5, t) for t in angles], 2
            )
            found = 16 * (fall**2 - 4 * bend * rest)
            assert number(double, K=K, B=B) == pytest.approx(found, abs=1e-10)

    only(
        agrees,
        meant(STIFF, "The exact condition is quadratic in $y$"),
        shown(STIFF, "The discriminant of the quadratic gives the upper part of the boundary"),
    )


WALLS = "s6f_stiffest_passive_wall"


@guards("s6f_stiffest_passive_wall")
def test_no_motion_lets_a_passive_wall_be_stiffer_than_an_angle_allows():
    """By the energies of motions, and by the largest stiffness at one angle over all dampings."""

    def allowed(left, right, late, theta):
        at = {"K": 1, "B": 0, "b": 1, "T": 1, "l": int(late), "epsilon": late % 1, "theta": theta}
        return number(right, **at) / number(left, **at)

    def agrees(bound):
        for late, theta in ((0.3, 0.9), (0.5, 1.4), (1.8, 0.7), (2.6, 2.0)):
            stiffness = allowed(bound.lhs, bound.rhs, late, theta)
            dampings = np.linspace(-30, 30, 4001)
            here, beyond = (
                max(energy.determinant(share * stiffness, B, late, theta) for B in dampings)
                for share in (0.99, 1.01)
            )
            assert here > 0 > beyond

    (bound,) = settled(WALLS, "fractional-stiffness-bound")
    assert bound.rel_op == "<="
    agrees(bound)
    for wrong in (bound.rhs * 1.05, bound.rhs.subs(sp.Symbol("l"), sp.Symbol("l") + 0.05)):
        with pytest.raises(AssertionError):
            agrees(sp.Le(bound.lhs, wrong))
    for late in (0.3, 1.5):
        angles = np.linspace(0.05, np.pi / (late + 1), 200)
        least = min(allowed(bound.lhs, bound.rhs, late, theta) for theta in angles)
        tried = np.linspace(-0.2, 1, 61)
        assert max(energy.left(0.99 * least, B, late=late) for B in tried) > 0
        assert max(energy.left(1.02 * least, B, late=late) for B in tried) < 0

    def turns(rest, slope):
        for late, theta in ((0.3, 0.9), (2.6, 2.0)):
            at = {"l": int(late), "epsilon": late % 1}
            mean = np.exp(1j * theta * (int(late) + 1)) * (1 + late % 1 * np.expm1(1j * theta))
            found = number(rest, theta=theta, **at)
            assert found == pytest.approx(1 - abs(mean) ** 2, abs=1e-13)
            near = [
                allowed(bound.lhs, bound.rhs, late, theta + step) * (late % 1) * (1 - late % 1) / 2
                for step in (-1e-5, 1e-5)
            ]
            found = number(slope, theta=theta, **at) / np.sin(theta) ** 2
            assert found == pytest.approx((near[1] - near[0]) / 2e-5, rel=1e-6)

    titles = (r"The squares of the two means add up to $1-4\kappa\sin^2\psi$",
              "The slope of the bound has the sign of a sum")  # fmt: skip
    only(turns, *(shown(WALLS, title) for title in titles))


@guards("s6g_next_whole_delay")
def test_walls_that_are_passive_at_the_next_whole_delay_are_passive_before():
    rng = np.random.default_rng(94)
    worse = 0
    for _ in range(40):
        whole, direction = rng.integers(0, 3), rng.uniform(-np.pi / 2, np.pi / 2)
        wall = np.array([np.cos(direction), np.sin(direction)])
        # the share left falls linearly with the size of a wall
        share = 1 - energy.left(*wall, late=whole + 1, periods=80)
        wall = wall * 0.98 / share
        for part in (0.15, 0.5, 0.85):
            assert energy.left(*wall, late=whole + part, periods=60) > 0
        share = 1 - energy.left(*wall, late=whole, periods=80)
        worse += energy.left(*(wall * 0.98 / share), late=whole + 0.5, periods=60) < 0
    assert worse > 10  # the whole delay before is no help

    def agrees(needed, condition):
        for psi, kappa, r, N in ((0.3, 0.4, 0.7, 4), (1.1, -0.9, 1.5, 8)):
            u, w = r * np.cos(kappa) * np.tan(psi), r * np.sin(kappa)
            K, B = 2 * u, w - u
            z = np.exp(2j * psi)
            law = (K + B * (1 - 1 / z)) * z ** -(N / 2 - 1) / (z - 1)
            at = {"psi": psi, "kappa": kappa, "r": r, "N": N}
            assert number(needed, **at) == pytest.approx(-law.real, abs=1e-13)
            for part in (0.2, 0.7):
                found = energy.determinant(K, B, N / 2 - 2 + part, 2 * psi)
                chi = N * psi - kappa
                ours = number(condition, psi=psi, r=r, epsilon=part, chi=chi)
                assert ours == pytest.approx(found, abs=1e-13)

    titles = (
        "The condition of the next integer delay contains one sine",
        "The exact condition contains two sines and one more term",
    )
    only(agrees, *(shown("s6g_next_whole_delay", title) for title in titles))
