"""A spring at the Nyquist frequency: half swings by exponentials, walls by their eigenvalues."""

import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.search import edge
from oracles.subject import counterexample, number, only, page, settled, shown, value

pytestmark = pytest.mark.ci

NUMBERS, ARMS, REGION = "s5c_nyquist_numbers", "s5c_nyquist_arms", "s5c_nyquist_region"


def half_swing(m, b, T):
    """The stiffness at which a device is back after a period: its position changes sign there."""
    guess = np.pi**2 * m / T**2
    return edge(0.5 * guess, 2 * guess, lambda k: motion.held(m, b, k, T)[0][0, 1] > 0, steps=60)


@guards("s5c_nyquist_numbers")
def test_the_spring_of_the_example():
    found = {b: half_swing(0.1, b, 1e-3) for b in (0.0, 2.0, 14.6)}

    def agrees(stiffness):
        for b, k in found.items():
            assert number(stiffness, b=b) == pytest.approx(k, rel=1e-9)

    # rounding of the exponential hides 1e-10: a hundredth of b^2/(4m) at b = 14.6 is 5e-6
    only(agrees, shown(NUMBERS, "For $m=0.1$ kg and $T=1$ ms the damper adds $\\frac52b^2$"))

    def agrees_with_eq31(stiffness):
        for m, b, T in ((0.1, 14.6, 1e-3), (2.0, 30.0, 0.05)):
            k = half_swing(m, b, T)
            assert number(stiffness, m=m, b=b, T=T) == pytest.approx(k, rel=1e-9)

    only(agrees_with_eq31, settled(NUMBERS, "eq31")[0].rhs)

    def agrees_with_the_frequency(square):
        for T in (1e-3, 0.2):
            assert number(square, T=T) == pytest.approx(half_swing(1.0, 0.0, T), rel=1e-9)

    only(
        agrees_with_the_frequency,
        shown(NUMBERS, "With the spring (31) the device oscillates at the Nyquist frequency"),
    )
    # to three digits it is 987 000 N/m for all of these dampers, and no more for larger ones
    assert all(round(k / 1000) == 987 for k in found.values())
    assert round(half_swing(0.1, 15.0, 1e-3) / 1000) == 988


@guards("s5c_nyquist_numbers")
def test_the_share_of_the_damping():
    def agrees(share):
        for delta in (0.5, 2.0):
            found = half_swing(1.0, delta, 1.0) / half_swing(1.0, 0.0, 1.0) - 1
            assert number(share, delta=delta) == pytest.approx(found, rel=1e-7)

    share = shown(NUMBERS, r"The contribution of the damping depends only on $\delta$")
    only(agrees, share)
    assert number(share, delta=0.02) < 1.02e-5


@guards("s5c_nyquist_arms")
def test_against_the_stiffness_of_an_arm():
    arm, device = (half_swing(m, 0.0, 1e-3) / 568 for m in (0.8, 0.1))

    def agrees(hogan, example):
        assert number(hogan) == pytest.approx(arm, rel=1e-9)
        assert number(example) == pytest.approx(device, rel=1e-9)

    only(
        agrees,
        *(
            shown(ARMS, t)
            for t in (
                "For Hogan's arm the spring is 13\\,900 times as stiff",
                "For the device alone it is 1740 times as stiff as that arm",
            )
        ),
    )
    (limit,) = page(ARMS).settled["s5c-human-10000"].settlement.values
    assert number(limit) == pytest.approx(half_swing(1.0, 0.0, 1.0) / 1e-3, rel=1e-9)
    point = counterexample(ARMS, "s6-human-10000")
    assert half_swing(point["m"], 0.0, point["T"]) < 5000 * point["k_H"]
    assert half_swing(point["m"], 0.0, point["T"]) > 1700 * point["k_H"]


def at_nyquist(delta):
    """gamma there, and by how much half a swing shrinks."""
    gamma = np.pi**2 + delta**2 / 4
    move, _ = oracle.sampled(gamma, delta)
    assert move == pytest.approx(move[0, 0] * np.eye(2), abs=1e-12)
    return gamma, -move[0, 0]


@guards("s5c_nyquist_region")
def test_the_polynomial_there_and_the_root_of_every_wall():
    cases = [(0.7, 0.2, 0.3, 0), (-3.0, 4.4, 0.02, 2), (20.0, -1.0, 1.5, 1)]

    def agrees(polynomial):
        for alpha, beta, delta, d in cases:
            gamma, _ = at_nyquist(delta)
            roots = np.poly(oracle.loops(alpha, beta, gamma, delta, d))
            for z in (0.6 + 0.2j, -0.7):
                at = {"alpha": alpha, "beta": beta, "delta": delta, "d": d, "z": z}
                assert complex(value(polynomial, **at)) == pytest.approx(
                    np.polyval(roots, z), abs=1e-11
                )

    only(agrees, shown(REGION, "The polynomial has one zero at $-e^{-\\delta/2}$"))
    for alpha, beta, delta, d in cases:
        gamma, left = at_nyquist(delta)
        roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta, d))
        assert np.abs(roots + left).min() < 1e-7  # a root that can be nearly double
        assert left < 1


THIRD = r"The third side of the triangle is the line $\alpha+2\beta=(1-f)/\nu$"


@guards("s5c_nyquist_region")
def test_the_three_sides_of_the_triangle():
    rng = np.random.default_rng(85)
    walls = [(a, b, f) for f in (0.02, 0.6) for a, b in rng.uniform(-12, 12, size=(150, 2))]

    def others(alpha, beta, delta):
        gamma, left = at_nyquist(delta)
        roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta, 0))
        return np.delete(roots, np.abs(roots + left).argmin()), gamma, left

    def agrees(one, two, three):
        inside = 0
        for alpha, beta, delta in walls:
            (r, s), gamma, left = others(alpha, beta, delta)
            at = {"alpha": alpha, "beta": beta, "f": left, "nu": (1 + left) / gamma}
            values = [number(side, **at) for side in (one, two, three)]
            found = [(1 - r) * (1 - s), (1 + r) * (1 + s), 1 - r * s]
            assert values == pytest.approx(np.real(found), abs=1e-6)
            assert (min(values) > 0) == oracle.stable(alpha, beta, gamma, delta, 0)
            inside += min(values) > 0
        assert 20 < inside < 200

    only(
        agrees,
        *(
            shown(REGION, t)
            for t in (
                r"The quadratic is positive at 1 for $\alpha>-\gamma$",
                r"The quadratic at $-1$ bounds $\alpha+2\beta$",
                "The product of the other zeros bounds $\\beta$",
            )
        ),
    )

    def agrees_with_the_third_side(side):
        for delta in (0.02, 0.6):
            gamma, _ = at_nyquist(delta)
            for beta in (-2.0, 0.0, 3.0):
                high = edge(
                    -0.999 * gamma,
                    20.0,
                    lambda x, beta=beta, gamma=gamma, delta=delta: oracle.stable(
                        x, beta, gamma, delta, 0
                    ),
                )
                assert number(side, delta=delta) == pytest.approx(high + 2 * beta, abs=1e-9)

    only(agrees_with_the_third_side, shown(REGION, THIRD))
