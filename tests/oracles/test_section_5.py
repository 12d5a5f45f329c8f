"""Passive and stable walls: finite-horizon energies beside eigenvalues, and swinging springs."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles import energy, motion
from oracles.guarding import guards
from oracles.subject import number, only, settled, shown, value

pytestmark = pytest.mark.ci

PLANTS = [(1e-3, 0.02), (2.0, 0.5), (0.1, 3.0), (9.0, 0.05)]


@guards("s5a_figure")
def test_at_the_angle_of_a_root_passivity_wants_more_than_the_damper():
    """For a wall with that root, from its energy at that angle; d fractional too."""
    cases = [(g, f, d, t) for g, f in PLANTS for d in (0, 0.25, 2) for t in (0.2, 1.5, 3.0)]

    def agrees(wanted):
        for gamma, delta, d, theta in cases:
            alpha, beta = (float(x) for x in oracle.wall(theta, gamma, delta, d))
            found = energy.need(alpha, beta, d, np.array([theta]))[0]
            ours = number(wanted, theta=theta, **oracle.named(gamma, delta))
            assert ours == pytest.approx(found, rel=1e-9)
            assert ours > delta

    only(
        agrees,
        shown(
            "s5a_figure", r"At the angle of the root the required damping is $\Re\{A/((z-1)N)\}$"
        ),
    )


@guards("s5a_passive_is_stable", "s5a_passive_is_robust")
def test_a_pulling_wall_runs_away_and_the_need_is_proportional():
    place = motion.positions(-0.5, 0.0, b=1.0, steps=100)
    assert motion.grows(place)
    assert energy.need(-0.5, 0.0, 0).max() < 1  # though (5) allows it

    def agrees(scaled):
        for y, theta in ((0.4, 0.9), (2.5, 2.2)):
            at = {"y": y, "K": 0.7, "B": -0.3, "T": 1.0, "d": 2, "theta": theta}
            found = energy.need(0.7 * y, -0.3 * y, 2, np.array([theta]))[0]
            assert number(scaled, **at) == pytest.approx(found, abs=1e-14)

    only(
        agrees,
        shown(
            "s5a_passive_is_robust",
            "A wall with $y$ times the stiffness and damping requires $y$ times the damping",
        ),
    )


TIP = "s5b_figure"


@guards("s5b_figure")
def test_the_tips_of_both_regions():
    def agrees(passive, stable):
        for gamma, delta in PLANTS:
            for d in (0.4, 1, 6):
                theta = np.pi / (2 * (d + 1))
                found = oracle.wall(theta, gamma, delta, d)[0]
                assert number(stable, theta=theta, **oracle.named(gamma, delta)) == pytest.approx(
                    float(found), rel=1e-12
                )
                wanted = energy.need(0.8, 0.3, d, np.array([theta]))[0]
                assert number(passive, alpha=0.8, theta=theta) == pytest.approx(wanted, rel=1e-12)

    titles = (
        r"At $(d+1)\theta=\frac\pi2$ the required damping does not contain $\beta$",
        r"At $(d+1)\theta=\frac\pi2$ the stability boundary has this stiffness",
    )
    only(agrees, *(shown(TIP, title) for title in titles))

    def agrees_at_low_angles(more):
        theta = mpmath.mpf("1e-15")  # the next term is of its square
        for delta in (0.02, 1.0):
            alpha = oracle.wall(theta, 0, delta, mpmath.pi / (2 * theta) - 1, 90)[0]
            found = (alpha / (2 * delta * mpmath.tan(theta / 2)) - 1) / theta**2
            assert abs(found - value(more, delta=delta)) < 1e-9

    only(
        agrees_at_low_angles,
        shown(
            TIP, "Without a spring the bound exceeds that of passivity by a term of second order"
        ),
    )


@guards("s5b_figure")
def test_long_delays_and_a_wall_that_no_delay_destabilises():
    def agrees(stable, passive):
        u = mpmath.mpf("1e-15")  # the next term is of this size
        for phi, delta in ((0.7, 0.02), (2.029, 1.0)):
            alpha = oracle.wall(phi * u, 0, delta, 1 / u - 1, 90)[0]
            assert abs(alpha / u - value(stable, phi=phi, delta=delta)) < 1e-12
            tip = 1 / energy.need(1.0, 0.0, 1e4 - 1, np.array([np.pi / 2e4]))[0]
            assert number(passive, delta=delta) == pytest.approx(1e4 * delta * tip, rel=1e-7)

    only(
        agrees,
        shown(TIP, "Without a spring the stable stiffness falls like the inverse of a long delay"),
        shown(TIP, "The passive wall of maximum stiffness falls like the inverse of the delay"),
    )
    phi = np.linspace(0, np.pi, 100_001)
    assert (phi * np.sin(phi)).max() == pytest.approx(1.8197, abs=5e-5)
    assert phi[(phi * np.sin(phi)).argmax()] == pytest.approx(2.029, abs=5e-4)
    assert np.pi / 2 / 1.8197 == pytest.approx(0.863, abs=5e-4)
    for d in (0, 1, 4, 15, 40, 90, 150):
        assert oracle.stable(0.0005, 0.0, 1e-3, 0.02, d)
    assert not oracle.stable(0.002, 0.0, 1e-3, 0.02, 40)
    # the ratio at the two delays that the chapter names
    for d, gamma, ratio in ((122, 0.0, 0.99999), (40, 1e-3, 0.9998)):
        angles = np.linspace(0.2, 1.6, 1500) / (d + 1)
        n1, n0, a, e = (float(n) for n in oracle.numbers(gamma, 0.02))
        z = np.exp(1j * angles)
        q = -np.exp(1j * d * angles) * (z * z - a * z + e) / (n1 * z + n0)
        alpha = q.real - q.imag / np.sin(angles) * (1 - np.cos(angles))
        found = 2 * 0.02 * np.tan(np.pi / 4 / (d + 1)) / alpha.max()
        assert found == pytest.approx(ratio, abs=1e-5 if gamma == 0 else 1e-4)
        assert found < 1


@guards("s5c_nyquist")
def test_a_device_swings_with_the_frequency_that_is_said():
    devices = [(0.4, 3.0, 250.0), (0.1, 0.0, 987_000.0), (2.0, 9.0, 90.0)]

    def agrees(frequency):
        for m, b, k in devices:
            half = np.pi / number(frequency, m=m, b=b, k=k)
            state, _ = motion.held(m, b, k, half)
            # after half a swing the device is back, with its speed reversed
            assert state[0, 1] == pytest.approx(0, abs=1e-10 * half)
            assert state[1, 1] == pytest.approx(-np.exp(-b * half / (2 * m)), rel=1e-10)

    only(agrees, settled("s5c_nyquist", "eq28")[0].rhs)

    def agrees_in_numbers(frequency):
        for gamma, delta, T in ((0.5, 0.2, 1e-3), (9.0, 1.0, 0.2)):
            half = np.pi / number(frequency, gamma=gamma, delta=delta, T=T) / T
            assert motion.held(1, delta, gamma, half)[0][0, 1] == pytest.approx(0, abs=1e-12)

    only(agrees_in_numbers, settled("s5c_nyquist", "eq29")[0].rhs)
    limit = settled("s5c_nyquist", "eq30")[0]
    for delta in (0.0, 0.02, 1.0):
        # half a swing per period: the sampled device turns into its mirror image
        move, _ = oracle.sampled(np.pi**2 + delta**2 / 4, delta)
        assert move == pytest.approx(-np.exp(-delta / 2) * np.eye(2), abs=1e-12)
        for off, holds in ((-1e-6, True), (1e-6, False)):
            at = {"gamma": np.pi**2 + delta**2 / 4 + off, "delta": delta}
            assert (number(limit.lhs, **at) <= number(limit.rhs)) == holds


@guards("s5c_nyquist_pole")
def test_the_polynomial_at_half_a_swing_per_period():
    def agrees(polynomial):
        for alpha, beta, d in ((0.7, 0.2, 0), (-1.0, 0.4, 2)):
            roots = np.poly(oracle.loops(alpha, beta, np.pi**2, 0, d))
            for z in (0.6 + 0.2j, -1):
                at = {"alpha": alpha, "beta": beta, "d": d, "z": z}
                found = np.polyval(roots, z)
                assert complex(value(polynomial, **at)) == pytest.approx(found, abs=1e-12)

    only(
        agrees,
        shown(
            "s5c_nyquist_pole",
            "At $\\gamma=\\pi^2$, $\\delta=0$ the polynomial has the factor $z+1$",
        ),
    )


@guards("s5c_robust")
def test_what_zeros_inside_have_to_outpace_at_the_angle_of_the_device():
    """By the zeros themselves: |p|^2 times the sum of 2 Re z/(z - a) - 1."""

    def agrees(surplus):
        for swing, d in ((0.7, 0), (1.9, 2), (2.8, 1)):
            n1, n0, a, e = oracle.numbers(mpmath.mpf(swing) ** 2, 0)
            alpha, beta = mpmath.mpf("0.8"), mpmath.mpf("-0.3")
            falling = [mpmath.mpf(1), -a, e, *([mpmath.mpf(0)] * (d + 1))]
            for place, c in ((-3, n1 * (alpha + beta)), (-2, n0 * (alpha + beta) - n1 * beta)):
                falling[place] += c
            falling[-1] -= n0 * beta
            with mpmath.workdps(40):
                zeros = mpmath.polyroots(falling, maxsteps=400, extraprec=400)
                z = mpmath.expj(swing)
                found = sum(2 * (z / (z - zero)).real - 1 for zero in zeros)
                found *= abs(mpmath.polyval(falling, z)) ** 2
            at = {"alpha": alpha, "beta": beta, "d": d, "Omega": mpmath.mpf(swing), "n_0": n0}
            assert abs(found - value(surplus, **at)) < 1e-15

    only(
        agrees,
        shown("s5c_robust", r"At the angle $\theta=\Omega$ of the device two terms remain"),
    )


@guards("s5c_robust_figure")
def test_how_far_a_weak_wall_pulls_the_roots_out():
    def agrees(pull):
        for swing, d in ((0.7, 0), (1.9, 2), (2.8, 1)):
            n1, n0, a, e = oracle.numbers(mpmath.mpf(swing) ** 2, 0)
            weak = mpmath.mpf("1e-20")  # the next term is of this size

            def polynomial(z, d=d, weak=weak, four=(n1, n0, a, e)):
                n1, n0, a, e = four
                wall = weak * (mpmath.mpf("0.8") * z - mpmath.mpf("-0.3") * (1 - z))
                return z ** (d + 1) * (z * z - a * z + e) + (n1 * z + n0) * wall

            root = mpmath.findroot(polynomial, mpmath.expj(swing))
            at = {"alpha": 0.8, "beta": -0.3, "d": d, "theta": swing, "n_1": n1}
            assert abs((abs(root) - 1) / weak - value(pull, **at)) < 1e-12

    only(
        agrees,
        shown(
            "s5c_robust_figure",
            "The wall moves a root outwards by a multiple of the required damping",
        ),
    )
