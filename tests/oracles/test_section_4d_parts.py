"""Left bound, arm, damping, delay, period, mass: eigenvalues, and loops simulated in SI units."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.search import stiffest
from oracles.subject import counterexample, decimals, number, only, said, shown, value

pytestmark = pytest.mark.ci

LEFT, DELAYED = "s4d_left_bound", "s4d_left_bound_delayed"


def radius(wall, delay=None, **other):
    """Spectral radius at a point by names."""
    at = {**wall, **other}
    return oracle.moduli(*(at[n] for n in ("alpha", "beta", "gamma", "delta")), at["d"]).max()


PLANTS = [(0.3, 0.2), (4.0, 0.5), (0.1, 3.0), (9.0, 0.05)]


@guards("s4d_left_bound")
def test_the_polynomial_at_one_and_the_sum_of_the_plants_numbers():
    def agrees(at_one):
        for gamma, delta in PLANTS:
            for d in (0, 2):
                found = np.linalg.det(np.eye(d + 3) - oracle.loops(0.7, 0.4, gamma, delta, d))
                at = {"alpha": 0.7, "gamma": gamma, **oracle.named(gamma, delta)}
                assert number(at_one, **at) == pytest.approx(found, abs=1e-13)

    title = r"At $z=1$ the polynomial is a multiple of $\alpha+\gamma$"
    only(agrees, said(LEFT, title).conclusion.terms[1])

    def agrees_in_sum(overdamped, swinging, alone):
        for gamma, delta in ((0.1, 3.0), (0.2, 0.9)):
            c = mpmath.sqrt(mpmath.mpf(delta) ** 2 - 4 * mpmath.mpf(gamma))
            found = sum(oracle.numbers(gamma, delta)[:2]) * gamma
            assert abs(value(overdamped, c=c, delta=delta) - found) < 1e-45
        for gamma, delta in ((4.0, 0.5), (9.0, 0.05)):
            phi = mpmath.sqrt(mpmath.mpf(gamma) - mpmath.mpf(delta) ** 2 / 4)
            found = sum(oracle.numbers(gamma, delta)[:2]) * gamma
            assert abs(value(swinging, phi=phi, delta=delta) - found) < 1e-45
        found = sum(oracle.numbers(0, 0.7)[:2])
        assert abs(value(alone, delta=0.7) - found) < 1e-45

    titles = (
        "For an overdamped device $n_1+n_0>0$",
        "For an underdamped device $n_1+n_0>0$",
        "Without a spring $n_1+n_0>0$",
    )
    only(agrees_in_sum, *(shown(LEFT, title) for title in titles))


@guards("s4d_left_bound_delayed")
def test_polynomials_on_the_line():
    gamma = 4 * np.pi**2 / 9
    n1 = float(oracle.numbers(gamma, 0)[0])

    def agrees(others):
        for x in (-0.4, 0.3, 1.1):
            found = np.poly(oracle.loops(-gamma, x / n1, gamma, 0, 1))
            for z in (0.5, 2j):
                ours = complex(value(others, x=x, z=z)) * (z - 1)
                assert ours == pytest.approx(np.polyval(found, z), abs=1e-12)

    only(agrees, shown(DELAYED, "The other three roots are those of a cubic"))

    def agrees_on_soft(line):
        for gamma, delta in ((0.3, 0.2), (0.9, 1.0)):
            at = {"gamma": gamma, "z": 0.7 + 0.6j, **oracle.named(gamma, delta)}
            found = np.polyval(np.poly(oracle.loops(-gamma, 0, gamma, delta, 1)), at["z"])
            assert complex(value(line, **at)) == pytest.approx(found, abs=1e-13)

    title = (
        r"For one period of delay and $\beta=0$ the polynomial on the line has the roots 0 and 1"
    )
    only(agrees_on_soft, said(DELAYED, title).conclusion.terms[1])


@guards("s4d_parts_damping")
def test_damping_pulls_roots_inwards_inside_the_ranges():
    rng = np.random.default_rng(63)
    for _ in range(60):
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(0, 0.019)
        theta = rng.uniform(0.05, np.arccos(-0.1))
        alpha, beta = (float(x) for x in oracle.wall(theta, gamma, delta, 0))
        roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta + 1e-3, 0))
        assert np.abs(roots[np.abs(roots - np.exp(1j * theta)).argmin()]) < 1
    stiff = {"alpha": -4.0, "beta": 5.9, "gamma": 5.0, "d": 0}  # damping-destabilises
    assert radius(stiff, delta=1.2) < 1 < radius(stiff, delta=1.5)


@guards("s4d_parts_delay")
def test_a_period_of_delay_lowers_the_corner_and_can_stabilise():
    def agrees(corner):
        for gamma, delta, d in ((0.001, 0.01, 0), (0.3, 0.2, 1), (2.0, 0.5, 4)):
            beta = oracle.wall(mpmath.mpf("1e-20"), gamma, delta, d)[1]
            assert abs(value(corner, gamma=gamma, d=d, **oracle.named(gamma, delta)) - beta) < 1e-17

    only(agrees, shown("s4d_parts_delay", r"The boundary begins at the damping $\beta_0$"))
    wall = counterexample("s4d_parts_delay", "s4d-delay-shrinks")
    assert radius(wall, d=1) < 1 < radius(wall)
    stiff = {"alpha": 1e-4, "beta": -0.022, "gamma": 1e-3, "delta": 0.02}
    assert radius(stiff, d=40) < 1 < radius(stiff, d=0)


@guards("s4d_parts_of_the_arm")
def test_a_spring_and_a_mass_that_destabilise():
    """In SI units: a device of 0.1 kg at 1 kHz; then with twice the mass and all else kept."""
    at = counterexample("s4d_parts_of_the_arm", "s4d-all-stabilising")
    assert at["T"] == at["m"] == at["m'"] == 1
    loose = {"alpha": at["K"], "beta": at["B"], "gamma": at["k"], "delta": at["b"], "d": at["d"]}
    assert radius(loose) < 1 < radius(loose, gamma=at["k'"], delta=at["b'"])
    m, T = 0.1, 1e-3
    wall = 9 / 800 * m / T**2, -13 / 4000 * m / T
    light = {"alpha": 9 / 800, "beta": -13 / 4000, "gamma": 0, "delta": 0.02, "d": 1}
    heavy = {name: v if name == "d" else v / 2 for name, v in light.items()}
    assert radius(light) < 1 < radius(heavy)
    b, steps, start = 0.02 * m / T, 100_000, 1000  # a root at 1.0000119 grows by e in 1e5 periods
    for mass, grows in ((m, False), (2 * m, True)):
        place = np.abs(motion.positions(*wall, mass, b, 0.0, T, 1.0, steps=steps))
        assert (place[-start:].max() > place[start : 2 * start].max()) == grows


@guards("s4d_scaling_kept", "s6_scaling")
def test_with_the_same_damper_half_the_period_gives_less_than_four_times_the_stiffness():
    stiffness, damping = decimals(
        "s4d_scaling_kept",
        r"Intervals contain the largest damping and stiffness for $\delta=\frac1{100}$",
    )
    assert stiffest(0, 0.01, 0, 0.5, 1.2)[0] == pytest.approx(float(stiffness), rel=1e-10)
    # its digits are cut
    assert 0 <= 1 / oracle.numbers(0, mpmath.mpf("0.01"))[1] - damping < 1e-24
    assert oracle.stable(0.713, 33 / 40, 0, 0.02, 0)
    assert not any(oracle.stable(0.713, beta, 0, 0.01, 0) for beta in np.linspace(-1, 3, 101))
    assert oracle.stable(1e-3, 2.02, 0, 0.02, 0)
    assert not any(oracle.stable(a, 2.02, 0, 0.01, 0) for a in np.geomspace(1e-8, 1, 200))
    # a spring of (23), and a quarter of it: half the period, or four times the mass
    assert oracle.stable(0.686, 0.8283, 0.00025, 0, 0)
    betas = np.linspace(0.8, 0.86, 1201)
    assert oracle.moduli(0.686, betas, 0.001, 0, 0).max(axis=-1).min() > 1.00005
    assert oracle.stable(-0.00095, 2.00006, 0.001, 0, 0)
    alphas = np.linspace(-0.00025, 0.01, 2001)
    assert oracle.moduli(alphas, 2.00006, 0.00025, 0, 0).max(axis=-1).min() > 1
    # in SI units: m = 0.1 kg, b = 2 Ns/m; at T = 1 ms the stable wall, at 0.5 ms four times it
    m, b, T = 0.1, 2.0, 1e-3
    K, B = 0.713 * m / T**2, 0.825 * m / T
    slow = motion.positions(K, B, m, b, 0.0, T, steps=60_000)
    assert np.abs(slow[-500:]).max() < np.abs(slow[:500]).max() / 20
    fast = motion.positions(4 * K, 2 * B, m, b, 0.0, T / 2, steps=3_000)
    assert motion.grows(fast)
