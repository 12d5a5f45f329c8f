"""Ends, slopes and extremes of the stability boundary, seen by eigenvalues and by mpmath.

The plants here are SciPy's zero-order hold or mpmath's matrix exponential, the loops their
companion matrices; none of it is the package's code.
"""

import dataclasses
import itertools

import mpmath
import numpy as np
import pytest
import sympy as sp
from chapters import chapter, equalities
from scipy.optimize import minimize_scalar
from scipy.signal import cont2discrete

from symhaptic.proof.decide import compare
from symhaptic.proof.mutants import wrong
from symhaptic.proof.verdict import Unfounded

RNG = np.random.default_rng(7)
DELAYS = range(9)
CHAPTERS = [
    "s4d_explicit_boundary_ends",
    "s4d_explicit_boundary",
    "s4d_free_mass",
    "s4d_free_mass_extremes",
    "s4d_free_mass_long_delay",
    "s4d_mass_with_damper",
    "s4d_scaling_kept",
]


def shown(name, title):
    """What stands on the right of the equations of a step, by their left sides."""
    (block,) = (b for b in chapter(name).page.blocks if b.title == title)
    return {str(left): right for left, _, right in block.lines}


def number(text):
    """Decimals as printed, without the dots that say that they go on."""
    with mpmath.workdps(40):
        return mpmath.mpf(text.removesuffix(r"\ldots"))


# -- by eigenvalues -----------------------------------------------------------------------


def growth(alpha, beta, gamma, delta, d):
    """Largest modulus of the roots, from SciPy's zero-order hold."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    p = np.concatenate([bottom, np.zeros(d + 1)])
    p[-3:] += np.convolve(top[0][1:], [alpha + beta, -beta])
    return np.abs(np.roots(p)).max()


def last_stable(stable, inside, outside):
    """Bisection: the last stable value between a stable and an unstable one."""
    assert stable(inside)
    assert not stable(outside)
    for _ in range(45):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if stable(middle) else (inside, middle)
    return inside


def stiffest(gamma, delta, d, beta_range, alpha_range):
    """Largest stable alpha by brute force: over beta, by bisection in alpha."""

    def edge(beta):
        return last_stable(lambda alpha: growth(alpha, beta, gamma, delta, d) < 1, *alpha_range)

    found = minimize_scalar(
        lambda beta: -edge(beta), bounds=beta_range, method="bounded", options={"xatol": 1e-7}
    )
    return -found.fun


@pytest.mark.parametrize("d", DELAYS)
def test_largest_stable_stiffness_of_a_free_mass(d):
    expected = float(
        number(
            shown(
                "s4d_free_mass_extremes",
                "The largest stable stiffnesses of a free mass are enclosed",
            )[rf"\alpha_{{\max}}({d})"]
        )
    )
    span = np.tan(np.pi / (4 * (d + 1)))  # half of the largest damping; the best beta is below it
    found = stiffest(0.0, 0.0, d, (0.6 * span, 1.2 * span), (0.5 * expected, 2 * expected))
    # a flat maximum: 1e-7 in beta is 1e-12 in alpha; the roots next to the circle are simple
    assert found == pytest.approx(expected, rel=1e-9)
    # the same number from the minimal polynomial, whose roots NumPy finds
    polynomial = shown(
        "s4d_free_mass_extremes",
        "The largest stiffnesses are algebraic, with these minimal polynomials",
    )[rf"\mu_{d}(\rho)"]
    all_roots = np.roots([float(c) for c in sp.Poly(polynomial).all_coeffs()])
    real = all_roots[np.abs(all_roots.imag) < 1e-9].real
    # the coefficients cover up to 14 decades
    assert 4 * min(r for r in real if r > 0) == pytest.approx(expected, rel=1e-9)
    assert len(all_roots) == d + 2


@pytest.mark.parametrize("d", DELAYS)
def test_minimal_polynomial_vanishes_at_fifty_digits_and_has_no_factor(d):
    polynomial = sp.Poly(
        shown(
            "s4d_free_mass_extremes",
            "The largest stiffnesses are algebraic, with these minimal polynomials",
        )[rf"\mu_{d}(\rho)"]
    )
    assert len(sp.factor_list(polynomial)[1]) == 1  # SymPy's own factorisation
    with mpmath.workdps(60):
        rho = largest(d) / 4
        coefficients = [mpmath.mpf(int(c)) for c in polynomial.all_coeffs()]
        size = sum(abs(c) * rho**k for k, c in enumerate(reversed(coefficients)))
        assert abs(mpmath.polyval(coefficients, rho)) < mpmath.mpf(10) ** -50 * size


@pytest.mark.parametrize("d", DELAYS)
def test_largest_stable_damping_of_a_free_mass(d):
    alpha, n, tau = 1e-6, d + 1, np.tan(np.pi / (4 * (d + 1)))
    found = last_stable(lambda beta: growth(alpha, beta, 0, 0, d) < 1, tau, 4 * tau)
    # dbeta/dalpha at the end of the arc, differentiated by hand at (d+1) theta = pi/2
    slope = -(1 + tau**2 + 2 * n * tau**2) / (4 * n * tau**2)
    assert found == pytest.approx(2 * tau + slope * alpha, abs=1e-9)  # alpha^2 times a curvature


@pytest.mark.parametrize("d", [0, 1, 2, 5])
def test_stable_walls_of_a_free_mass_are_those_below_the_first_arc(d):
    theta = np.linspace(1e-4, np.pi / (2 * (d + 1)), 4000)
    tau = np.tan(theta / 2)
    alpha = 4 * tau**2 * np.cos((d + 1) * theta)
    beta = 2 * tau * np.sin((d + 1) * theta) - alpha / 2
    assert (np.diff(beta) > 0).all()
    inside = 0
    for _ in range(500):
        a, b = RNG.uniform(-0.2, 1.4) * alpha.max(), RNG.uniform(-0.3, 1.4) * beta[-1]
        edge = np.interp(b, beta, alpha)
        if min(abs(a), abs(a - edge), abs(b)) < 1e-3 * alpha.max():
            continue  # too close for a polygon of 4000 corners
        expected = 0 < b < beta[-1] and 0 < a < edge
        inside += expected
        assert (growth(a, b, 0, 0, d) < 1) == expected
    assert inside > 50


def damped(delta):
    """n1, n0, e of a damped mass in 30 digits, by mpmath's matrix exponential."""
    a, e, n1, n0 = plant(0, delta)
    assert a == pytest.approx(1 + e)
    return n1, n0, e


@pytest.mark.parametrize("delta", [0.01, 0.02, 0.3, 1.0, 2.5])
def test_largest_stiffness_of_a_damped_mass_without_delay(delta):
    n1, n0, e = (float(v) for v in damped(delta))
    expected = (n1 + n0 - np.sqrt(n0 * (n0 + e * n1))) ** 2 / (n0 * n1**2)
    found = stiffest(0.0, delta, 0, (0.2, 0.9), (0.5 * expected, 1.6 * expected))
    assert found == pytest.approx(expected, rel=1e-9)  # as above
    # the bound of the damping is reached on the line alpha = 0
    if delta < 2:  # beyond, the line of a root at -1 is lower
        edge = last_stable(lambda beta: growth(1e-7, beta, 0, delta, 0) < 1, 0.5 / n0, 2 / n0)
        assert edge == pytest.approx(1 / n0, rel=1e-6)


def test_walls_that_four_times_the_stiffness_and_twice_the_damping_lose():
    # the counterexamples of s4d-quadratic-in-period and s4d-damping-bound, by eigenvalues
    assert growth(0.713, 0.825, 0, 0.02, 0) < 1
    assert growth(0.001, 2.02, 0, 0.02, 0) < 1
    beta = np.linspace(-3, 5, 2001)
    assert min(growth(0.713, b, 0, 0.01, 0) for b in beta) > 1
    assert min(growth(a, 2.02, 0, 0.01, 0) for a in np.geomspace(1e-6, 5, 500)) > 1
    largest = [stiffest(0.0, delta, 0, (0.2, 0.9), (0.5, 1)) for delta in (0.02, 0.01)]
    assert 3.92 < 4 * largest[1] / largest[0] < 3.93
    # without a damper and spring the ratio is exact: the same dimensionless loop
    assert growth(0.686, 0.8284, 0, 0, 0) < 1


# -- by mpmath ----------------------------------------------------------------------------


def plant(gamma, delta):
    """a, e, n1, n0 from the exponential of the state matrix with the held force as a state."""
    matrix = mpmath.matrix([[0, 1, 0], [-mpmath.mpf(gamma), -mpmath.mpf(delta), 1], [0, 0, 0]])
    step = mpmath.expm(matrix)
    e = mpmath.exp(-mpmath.mpf(delta))
    return step[0, 0] + step[1, 1], e, step[0, 2], step[0, 1] * step[1, 2] - step[1, 1] * step[0, 2]


def wall(theta, gamma, delta, d):
    """(alpha, beta) that put a root at exp(j theta), solved by hand."""
    a, e, n1, n0 = plant(gamma, delta)
    z = mpmath.expj(theta)
    q = -(z**d) * (z**2 - a * z + e) / (n1 * z + n0)
    beta = q.imag / mpmath.sin(theta)
    return q.real - beta * (1 - mpmath.cos(theta)), beta


ARMS = [("1e-3", "0.02"), ("0", "0.02"), ("0", "3"), ("0.5", "0.3"), ("7", "0"), ("2", "4")]
SMALL = mpmath.mpf("1e-12")


@pytest.mark.parametrize("d", [0, 1, 3])
@pytest.mark.parametrize(("gamma", "delta"), ARMS)
def test_start_of_the_boundary_and_its_slope(gamma, delta, d):
    with mpmath.workdps(60):
        gamma, delta = mpmath.mpf(gamma), mpmath.mpf(delta)
        _, e, n1, n0 = plant(gamma, delta)
        nu = n0 / (n1 + n0)
        s1 = (1 - e + gamma * n0) / (n1 + n0)
        s2 = 1 / (n1 + n0) - (1 - nu) * s1
        first, second = wall(SMALL, gamma, delta, d), wall(2 * SMALL, gamma, delta, d)
        # everything is even in theta: errors are of the order of its square
        assert abs(first[0] + gamma) < mpmath.mpf("1e-21")
        assert abs(first[1] + s1 + d * gamma) < mpmath.mpf("1e-21")
        slope = (second[1] - first[1]) / (second[0] - first[0])
        top = gamma * d * (d + 1) * (4 * d + 5) + 6 * (d + 1) ** 2 * s1 + 6 * (1 - 2 * nu) * s2
        bottom = 6 * gamma * d * (d + 1) + 12 * (d + 1) * s1 + 12 * s2
        assert abs(slope - (d + 0.5 - top / bottom)) < mpmath.mpf("1e-20")
        assert slope < d + 0.5  # the line of (25) is steeper
        assert -s1 <= -delta - gamma / 2 + mpmath.mpf("1e-40")  # and starts no lower


@pytest.mark.parametrize("d", [0, 2])
@pytest.mark.parametrize("delta", ["0.02", "1", "5"])
def test_slope_at_minus_delta_without_a_spring(delta, d):
    with mpmath.workdps(60):
        delta = mpmath.mpf(delta)
        first, second = wall(SMALL, 0, delta, d), wall(2 * SMALL, 0, delta, d)
        slope = (second[1] - first[1]) / (second[0] - first[0])
        excess = (d + 1) ** 2 * delta + mpmath.coth(delta / 2) - 2 / delta
        assert abs(slope - (d + 0.5 - excess / (2 + 2 * (d + 1) * delta))) < mpmath.mpf("1e-20")


def test_gap_between_the_start_and_the_line():
    with mpmath.workdps(50):
        gamma, delta = mpmath.mpf("0.001"), mpmath.mpf("0.02")
        _, e, n1, n0 = plant(gamma, delta)
        gap = (1 - e + gamma * n0) / (n1 + n0) - delta - gamma / 2
        title = "At the corner of (23) the distance is enclosed"
        printed = number(*shown("s4d_explicit_boundary_ends", title).values())
        assert abs(gap - printed) < mpmath.mpf("1e-24")  # the last of its decimals
        # leading order: the next terms are smaller by delta^2 and gamma
        assert abs(gap / (delta * gamma**2 / 720) - 1) < mpmath.mpf("1e-3")


@pytest.mark.parametrize("d", [0, 1, 2, 3])
@pytest.mark.parametrize(("gamma", "delta"), [("0", "0.5"), ("1", "0.2"), ("6", "2")])
def test_end_of_the_boundary(gamma, delta, d):
    with mpmath.workdps(60):
        a, e, n1, n0 = plant(gamma, delta)
        alpha, beta = wall(mpmath.pi - SMALL, gamma, delta, d)
        total = (1 + a + e) / (n1 - n0)
        end = n1 * (1 + a + e) / (n1 - n0) ** 2 - (2 + a + d * (1 + a + e)) / (n1 - n0)
        size = abs(end) + abs(total) + 1
        # even in pi - theta: 1e-24 times a curvature, which is of the size of (n1-n0)^-4
        assert abs((-1) ** d * beta - end) < mpmath.mpf("1e-19") * size
        assert abs((-1) ** d * (alpha + 2 * beta) - total) < mpmath.mpf("1e-19") * size


@pytest.mark.parametrize("d", [0, 1, 2.5])
@pytest.mark.parametrize("gamma", ["0.3", "4", "20"])
def test_boundary_of_an_undamped_arm(gamma, d):
    with mpmath.workdps(40):
        gamma = mpmath.mpf(gamma)
        c = mpmath.cos(mpmath.sqrt(gamma))
        for theta in map(mpmath.mpf, ("0.1", "0.9", "2", "3.1")):
            alpha, beta = wall(theta, gamma, 0, d)
            kappa = gamma * (c - mpmath.cos(theta)) / (1 - c)
            expected = kappa * mpmath.cos((d + 1) * theta) / mpmath.cos(theta / 2) ** 2
            both = 2 * kappa * mpmath.sin((d + 1) * theta) / mpmath.sin(theta)
            assert abs(alpha - expected) < mpmath.mpf("1e-33") * (1 + abs(alpha))
            assert abs(alpha + 2 * beta - both) < mpmath.mpf("1e-33") * (1 + abs(alpha))
        if d == int(d):
            alpha, beta = wall(mpmath.pi - mpmath.mpf("1e-8"), gamma, 0, d)
            line = (-1) ** int(d) * 2 * (d + 1) * gamma * (1 + c) / (1 - c)
            assert abs(alpha + 2 * beta - line) < mpmath.mpf("1e-12")  # 1e-16 times a curvature


def largest(d):
    """alpha_max of a free mass, from the stationary angle on the first arc."""
    n = mpmath.mpf(d) + 1
    angle = mpmath.findroot(
        lambda f: n * mpmath.tan(f) * mpmath.sin(f / n) - 2, (1, 1.2), solver="anderson"
    )
    return 4 * mpmath.tan(angle / n / 2) ** 2 * mpmath.cos(angle)


def test_largest_stiffness_for_long_delays():
    name = "s4d_free_mass_long_delay"
    blocks = [b for b in chapter(name).page.blocks if b.title.endswith("are enclosed")]
    values = {str(left): number(right) for b in blocks for left, _, right in b.lines}
    with mpmath.workdps(40):
        angle = mpmath.findroot(lambda f: f * mpmath.tan(f) - 2, 1.08)
        limit = angle**2 * mpmath.cos(angle)
        assert abs(values[r"\varphi_*"] - angle) < mpmath.mpf("1e-24")
        assert abs(values[r"\varphi_*^2\cos\varphi_*"] - limit) < mpmath.mpf("1e-24")
        before = mpmath.inf
        for d in (0, 0.5, 1, 4, 20, 100, 1000):
            scaled, h = largest(d) * (d + 1) ** 2, 1 / mpmath.mpf(d + 1)
            assert limit < scaled < before
            upper = mpmath.tan(h * mpmath.pi / 4) / (h * mpmath.pi / 4)
            assert scaled < limit * upper**2
            series = limit * (1 + values["a_2"] * h**2 + values["a_4"] * h**4)
            # the next coefficient is about 0.01, as d = 4 and 20 show; the decimals end at 1e-24
            assert abs(scaled - series) < 0.02 * h**6 + mpmath.mpf("1e-23")
            before = scaled


# -- mutants ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [n for n in CHAPTERS if n != "s4d_scaling_kept"])
def test_no_wrong_variant_of_a_step_is_proved(name, monkeypatch, record_property):
    count = 0
    for title, left, right in equalities(name, monkeypatch):
        if isinstance(right, sp.Expr):
            for mutant in itertools.islice(wrong((right,)), 3):
                count += 1
                assert not compare(left, mutant.form[0]).equal, f"{title}: {mutant.change}"
    record_property("mutants", count)
    assert count > 3


SCALED = {
    "s4d-quadratic-in-period": "s4d_scaling_kept",
    "s4d-damping-bound": "s4d_scaling_kept",
    "s6-sampling": "s6_scaling",
    "s6-mass": "s6_scaling",
}


@pytest.mark.parametrize("id", SCALED)
def test_scaling_needs_a_point_for_each_condition(id):
    settled = chapter(SCALED[id]).page.settled[id]
    assert settled.verdict.kind == "qualified"
    judged, claim = settled.settlement.judged, settled.settlement.claim(())
    for left_out in range(2):
        cases = tuple(case for i, case in enumerate(judged.unless) if i != left_out)
        with pytest.raises(Unfounded, match="no counterexample violates just"):
            dataclasses.replace(judged, unless=cases).decide(claim)
