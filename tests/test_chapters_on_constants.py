"""The constants and claims of Secs. V and VI, by mpmath, by eigenvalues and by hand."""

from dataclasses import replace
from functools import cache

import mpmath
import numpy as np
import oracle
import pytest
from chapters import chapter, run_altered
from flint import arb, ctx
from sympy import Rational, S, pi, symbols, tan

from symhaptic.book.chapters import BadChapter
from symhaptic.bounds.walls import over, passive, undelayed
from symhaptic.proof.roots import zero
from symhaptic.proof.verdict import Kind

RNG = np.random.default_rng(17)
STIFF, DAMPED = Rational(1, 1000), Rational(1, 50)


@cache
def settled(name):
    return chapter(name).page.settled


# -- the largest stable stiffness -------------------------------------------------------------


def curve(theta, gamma, delta, delay):
    """alpha of the wall that is -z^d/P(z), with P from mpmath's matrix exponential."""
    moved = mpmath.expm(mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]), method="taylor")
    z = mpmath.expj(theta)
    free, push = moved[:2, :2], moved[:2, 2]
    p = mpmath.lu_solve(z * mpmath.eye(2) - free, push)[0]
    q = -(z**delay) / p
    return q.real - q.imag * (1 - mpmath.cos(theta)) / mpmath.sin(theta)


def tip(gamma, delta, delay, near):
    """The maximum of that curve next to an angle, to 40 digits."""
    with mpmath.workdps(60):
        g, dl = mpmath.mpf(gamma.p) / gamma.q, mpmath.mpf(delta.p) / delta.q

        def slope(theta):
            return mpmath.diff(lambda x: curve(x, g, dl, delay), theta)

        return curve(mpmath.findroot(slope, mpmath.mpf(near)), g, dl, delay)


@pytest.mark.parametrize("gamma", [S.Zero, STIFF])
def test_undelayed_is_the_maximum_that_mpmath_finds(gamma):
    value = undelayed(gamma, DAMPED).ball
    with mpmath.workdps(60), ctx.workprec(256):
        there = arb(mpmath.nstr(tip(gamma, DAMPED, 0, 1.154), 45))
        # 1e-30: mpmath's numerical derivative at the tip, squared by the parabola
        assert abs(value - there) < arb("1e-30")
        assert value.rad() < arb("1e-30")


NEAR = {0: 1.154, 1: 1.11, 2: 1.10, 5: 1.12, 12: 1.2}
"""About where the maximum is, (d+1) theta, by the delay."""


def stable_somewhere(alpha, gamma, delta, delay, dampings):
    return bool((oracle.radius(alpha, dampings, gamma, delta, delay) < 1).any())


@pytest.mark.parametrize("delay", NEAR)
@pytest.mark.parametrize("gamma", [S.Zero, STIFF])
def test_no_damping_makes_a_stiffer_wall_stable(gamma, delay):
    """By eigenvalues on a grid of damping: stable just below the largest alpha, never above."""
    high = float(tip(gamma, DAMPED, delay, NEAR[delay] / (delay + 1)))
    dampings = np.linspace(-0.1, 2.3, 2001) / (delay + 1)
    for factor, expected in ((0.9999, True), (1.0001, False), (1.3, False), (3.0, False)):
        found = stable_somewhere(high * factor, float(gamma), 0.02, delay, dampings)
        assert found == expected


def test_the_ratio_peaks_where_the_chapter_says():
    """eta at all whole delays up to 1000 and 48, by the kernels' floating-point maximum."""
    from symhaptic import max_passive_stiffness, max_stable_stiffness

    for gamma, last, best in ((0.0, 1000, 122), (1e-3, 48, 40)):
        delays = np.arange(last + 1)
        low = max_passive_stiffness(0.02, delays).alpha
        eta = low / max_stable_stiffness(gamma, 0.02, delays).alpha
        assert eta.argmax() == best
        assert eta.max() < 1
    assert 1 - eta[40] == pytest.approx(1.8149e-4, rel=1e-3)  # 0.99981851...


@pytest.mark.parametrize("delay", [0, 3, 49, 51, 60, 130])
def test_the_wall_for_every_delay(delay):
    assert oracle.radius(0.00059, 0.0, 1e-3, 0.02, delay) < 1


def test_the_walls_between():
    for delay in range(49, 53):
        assert oracle.radius(0.00063, 0.005, 1e-3, 0.02, delay) < 1
        assert 0.04 * np.tan(np.pi / (4 * (delay + 1))) < 0.00063


def test_a_zero_in_a_ball_of_a_parameter():
    """cos(c x) for c within 1/1000 of 1: the zero is within 1/500 of pi/2."""
    x, c = symbols("x c")
    from sympy import cos

    at = zero(cos(c * x), x, S.One, S(2), {c: arb(1, 0.001)}).ball
    assert at.contains(arb.pi() / 2)
    assert at.rad() < 0.01


def test_over_keeps_the_digits():
    assert over(passive(DAMPED, 1), tan(pi / 8)).ball.overlaps(arb("0.04"))


# -- what is said of it -----------------------------------------------------------------------

CONSTANTS = {
    # statement: chapter and its number to 12 digits, from the mpmath maxima above
    "s5b-eta-d0": ("s5b_stiffest_undelayed", "17.8171701158"),
    "s5c-human-10000": ("s5c_nyquist_arms", "9869.60440108"),
    "eq31": ("s5c_nyquist_numbers", "986960.440108"),
}


@pytest.mark.parametrize("id", CONSTANTS)
def test_constant(id):
    name, digits = CONSTANTS[id]
    verdict = settled(name)[id].verdict
    assert verdict.kind is Kind.ENCLOSED
    assert verdict.value.startswith(digits)
    assert float(verdict.radius) < 1e-20


@pytest.mark.parametrize("id", CONSTANTS)
def test_no_tighter_digit_is_accepted(id):
    """Every printed digit one up and one down; what is looser than the print remains true."""
    one = settled(CONSTANTS[id][0])[id]
    count = 0
    for i, quoted in enumerate(one.settlement.quoted):
        for changed in quoted.changed():
            tighter = {
                "about": True,
                "above": float(changed.digits) > float(quoted.digits),
                "below": float(changed.digits) < float(quoted.digits),
            }[quoted.how]
            if not tighter:
                continue
            count += 1
            others = list(one.settlement.quoted)
            others[i] = changed
            verdict = replace(one.settlement, quoted=tuple(others)).decide(one.statement.printed)
            assert verdict.kind is Kind.REFUTED, changed
    assert count >= len(one.settlement.quoted)


def test_eta_falls_after_its_peak():
    verdict = settled("s5b_stiffest_wall_peak")["s5b-eta-grows"].verdict
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample == {"gamma": "1/1000"}
    with mpmath.workdps(40):
        far = mpmath.findroot(lambda x: mpmath.sin(x) + x * mpmath.cos(x), 2)
        limit = mpmath.pi / 2 / (far * mpmath.sin(far))
    assert mpmath.nstr(limit, 20) == "0.86321446993614875867"


def test_the_pole_of_a_nyquist_spring():
    """-exp(-delta/2) for random walls and delays."""
    for delay in (0, 1, 4):
        for delta in (0.02, 0.7):
            alpha, beta = RNG.normal(size=2)
            gamma = np.pi**2 + delta**2 / 4
            roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta, delay))
            assert np.abs(roots + np.exp(-delta / 2)).min() < 1e-12


def test_the_triangle_of_a_nyquist_spring():
    """s5c-shape: three half planes against eigenvalues of 4000 walls."""
    delta = 0.02
    gamma, f = np.pi**2 + delta**2 / 4, np.exp(-delta / 2)
    alpha, beta = RNG.uniform(-12, 12, 4000), RNG.uniform(-6, 6, 4000)
    edges = np.minimum(alpha + gamma, beta + gamma / (1 + f))
    edges = np.minimum(edges, gamma * np.tanh(delta / 4) - alpha - 2 * beta)
    clear = np.abs(edges) > 1e-6
    stable = oracle.radius(alpha, beta, gamma, delta, 0) < 1
    assert np.array_equal(stable[clear], edges[clear] > 0)


def test_a_wall_that_cannot_be_turned_down():
    assert oracle.radius(4.0, -2.5, 5.0, 0.5, 1) < 1 < oracle.radius(0.0, -2.5, 5.0, 0.5, 1)


def test_without_delay_walls_can_be_turned_down():
    gamma, delta = RNG.uniform(0, 0.01, 4000), RNG.uniform(0, 0.1, 4000)
    alpha, beta = RNG.uniform(0, 0.8, 4000), RNG.uniform(-0.1, 2.1, 4000)
    stable = oracle.radius(alpha, beta, gamma, delta, 0) < 1
    assert stable.sum() > 500
    softer = RNG.uniform(0, 1, 4000) * alpha
    assert (oracle.radius(softer, beta, gamma, delta, 0)[stable] < 1).all()


# -- mutants ----------------------------------------------------------------------------------

MUTANTS = [
    # a number, a sign or a factor of what the chapter proves
    ("s5b_stiffest_undelayed", "* (1 - n_0 * beta) *", "* (1 + n_0 * beta) *"),
    ("s5b_stiffest_undelayed", "(1 + n_1 * beta) - w)", "(1 + n_1 * beta) + w)"),
    ("s5b_stiffest_wall", "(u * y - v * x),", "(u * y + v * x),"),
    ("s5b_stiffest_wall", "(alpha + 2 * beta) * sin", "(alpha + beta) * sin"),
    ("s5b_stiffest_wall_numbers", "2 * delta * tan(", "delta * tan("),
    ("s5b_stiffest_wall_numbers", "delta: DAMPED}", "delta: 2 * DAMPED}"),
    ("s5b_stiffest_wall_peak", "point = {gamma: STIFF}", "point = {gamma: 2 * STIFF}"),
    ("s5b_soft_contacts_undelayed", "alpha: S.Zero}", "alpha: S(3)}"),
    ("s5b_weaker_damping", "HEAVIER: Rational(1, 50)", "HEAVIER: Rational(1, 100)"),
    ("s5c_nyquist_numbers", "spring = pi**2 * m / T**2", "spring = 2 * pi**2 * m / T**2"),
    ("s5c_nyquist_numbers", "Rational(102, 10**7)", "Rational(101, 10**7)"),
    ("s5c_nyquist", "turns**2 <= pi**2,)", "turns**2 <= pi,)"),
    ("s5c_nyquist_pole", "mirrored_pole(delta)", "mirrored_pole(2 * delta)"),
    ("s5c_nyquist_arms", "k_H: S(100)}", "k_H: S(101)}"),
    ("s5c_nyquist_arms", "Rational(1, 1000))\n", "Rational(1, 1100))\n"),
    ("s5b_soft_contacts", "alpha: Rational(1, 5000)", "alpha: Rational(1, 10**6)"),
    ("s5b_soft_contacts", "d: S.Zero, y: S.Zero}", "d: S.Zero, y: S.Half}"),
    ("s5c_nyquist_region", "LEFT = exp(-delta / 2)", "LEFT = exp(-delta)"),
    ("s5c_nyquist_region", "2 / force, most", "2 / force, -most"),
    (
        "s6_delay_one_period",
        "one_period(),\n        example",
        "far_higher.left_by_one_period(),\n        example",
    ),
    ("s6_marginal", "alpha: Rational(1, 2000)", "alpha: Rational(1, 200)"),
    ("s6_marginal", "alpha: Rational(1, 5000)", "alpha: Rational(1, 500)"),
    ("s6_gains", "t_d / d),\n        2 * d", "t_d / d),\n        d"),
    ("s6_gains", "b: 2 * b", "b: b"),
]


@pytest.mark.parametrize(("name", "right", "wrong"), MUTANTS)
def test_a_chapter_with_one_thing_changed_proves_nothing(tmp_path, name, right, wrong):
    with pytest.raises(BadChapter):
        run_altered(name, right, wrong, tmp_path)
