"""The largest stable stiffness: searches with eigenvalues beside the enclosed ratios."""

import re

import mpmath
import numpy as np
import oracle
import pytest
from oracles.guarding import guards
from oracles.search import first_arc, stiffest
from oracles.subject import counterexample, decimals, meant, number, only, page, shown, value

pytestmark = pytest.mark.ci

UNDELAYED, WALL, NUMBERS, PEAK = (
    f"s5b_stiffest_{name}" for name in ("undelayed", "wall", "wall_numbers", "wall_peak")
)
FOR_EVER = 0.00059
with mpmath.workdps(60):
    DELTA = mpmath.mpf(1) / 50


def passive(delta, d):
    """(11), typed anew."""
    return 2 * delta * mpmath.tan(mpmath.pi / (4 * (mpmath.mpf(d) + 1)))


@guards("s5b_stiffest_undelayed")
def test_the_stiffest_wall_without_delay_by_a_search():
    rng = np.random.default_rng(55)
    arms = [(1e-3, 0.02), (0.01, 0.1), (rng.uniform(0, 0.01), rng.uniform(0, 0.1))]
    found = {(g, f): stiffest(g, f, 0, 0.3, 1.4)[0] for g, f in arms}

    def agrees(formula):
        for (gamma, delta), alpha in found.items():
            at = {"gamma": gamma, **oracle.named(gamma, delta)}
            assert number(formula, **at) == pytest.approx(alpha, rel=1e-10)

    only(agrees, meant(UNDELAYED, "The largest stable stiffness without delay has a closed form"))
    ratio = decimals(UNDELAYED, "The ratio of the largest stiffnesses is slightly more than 17.8")[
        0
    ]
    assert found[1e-3, 0.02] / (2 * 0.02) == pytest.approx(float(ratio), rel=1e-10)
    for _ in range(20):  # on all of (23)
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(1e-3, 0.02)
        assert oracle.stable(17.8 * 2 * delta, 0.83, gamma, delta, 0)
        # and no wall is stiffer than 0.72
        for alpha, beta in zip(rng.uniform(0.72, 5, 50), rng.uniform(-2, 3, 50), strict=True):
            assert not oracle.stable(alpha, beta, gamma, delta, 0)


@guards("s5b_stiffest_undelayed")
def test_the_minor_and_a_coefficient_of_a_cubic():
    """Delta_2 is the product of 1 - r_i r_j; c_1 is a coefficient in (1 + w)/(1 - w)."""

    def agrees(minor, second):
        for alpha, beta, gamma, delta in ((0.3, 0.7, 0.01, 0.1), (-0.2, 1.4, 2.0, 0.4)):
            p = np.poly(oracle.loops(alpha, beta, gamma, delta, 0))
            r = np.roots(p)
            turned = np.zeros(4)
            for k, coefficient in enumerate(p):
                turned += coefficient * np.poly([-1] * (3 - k) + [1] * k) * (-1) ** k
            at = {"alpha": alpha, "beta": beta, "gamma": gamma, **oracle.named(gamma, delta)}
            n1, n0, e = (at[name] for name in ("n_1", "n_0", "e"))
            at["s_1"] = (1 - e + gamma * n0) / (n1 + n0)
            pairs = np.prod([1 - r[i] * r[j] for i, j in ((0, 1), (0, 2), (1, 2))]).real
            assert number(minor, **at) == pytest.approx(pairs, abs=1e-12)
            # highest power of w first: -p(-1), c_2, c_1, p(1)
            assert number(second, **at) == pytest.approx(turned[2], abs=1e-12)

    both = (
        shown("s5b_soft_contacts_undelayed", "The minor falls with the stiffness"),
        shown("s5b_soft_contacts_undelayed", "The second inequality holds for $\\beta>-s_1$"),
    )
    only(agrees, *both)
    only(agrees, shown(UNDELAYED, "The minor is a difference of two products"), both[1])


@guards("s5b_stiffest_wall")
def test_what_the_wall_is_half_a_period_earlier():
    def agrees(wall):
        for theta in (mpmath.mpf("0.4"), mpmath.mpf("1.9")):
            z = mpmath.expj(theta)
            turned = (mpmath.mpf(0.4) - mpmath.mpf(0.7)) * z + mpmath.mpf(0.7)
            turned *= mpmath.expj(-theta / 2)
            assert abs(value(wall, theta=theta, alpha=0.4, beta=-0.7) - turned) < 1e-40

    title = "The real part of $z^{-1/2}W$ contains the stiffness only"
    only(agrees, shown(WALL, title))


@guards("s5b_stiffest_wall_numbers")
def test_the_tables_of_the_ratios():
    stiff, damped = (b.rows for b in page(NUMBERS).blocks if b.kind == "table")
    assert [int(row[0]) for row in stiff[1:]] == [0, 1, 2, 4, 8, 40]
    for d, *cells in stiff[1:]:
        for gamma, cell in zip(("0", "0.001"), cells, strict=True):
            printed = mpmath.mpf(str(cell))
            if d == 0:  # a search with ten digits
                ratio = stiffest(float(gamma), 0.02, 0, 0.3, 1.4)[0] / passive(DELTA, 0)
            else:
                ratio = first_arc(mpmath.mpf(gamma), DELTA, d) / passive(DELTA, d)
            assert 0 <= ratio - printed < 1e-6
    for head, cell in zip(*damped, strict=True):
        d = int(re.search(r"\d+", head)[0])
        beta = float(str(cell)) * float(DELTA)
        alphas = np.geomspace(1e-6, 1, 800)
        assert oracle.moduli(alphas, beta, 1e-3, 0.02, d).max(axis=-1).min() < 1


@guards("s5b_stiffest_wall_peak")
def test_with_a_spring_the_ratio_is_below_one_and_falls_behind_forty_periods():
    """Through the tips of the first arc up to d = 48, and beyond by eigenvalues of one wall."""
    spring = mpmath.mpf("0.001")
    ratios = {
        d: passive(DELTA, d) / first_arc(spring, DELTA, d)
        for d in (1, 7, 20, 35, 38, 39, 40, 41, 48)
    }
    peak = ratios.pop(40)
    assert max(ratios.values()) < 0.9998 < peak < 1
    for d in (49, 50, 51, 52):
        assert passive(DELTA, d) / 0.9998 < 0.00063
        assert oracle.stable(0.00063, 0.005, 1e-3, 0.02, d)
    for d in (53, 60, 68, 300):
        assert passive(DELTA, d) / 0.9998 < FOR_EVER
        assert oracle.stable(FOR_EVER, 0.0, 1e-3, 0.02, d)
    assert passive(DELTA, 1000) / first_arc(0, DELTA, 1000) < 0.91
    assert passive(DELTA, 122) / first_arc(0, DELTA, 122) > 0.9999
    assert counterexample(PEAK, "s5b-eta-grows") == {"gamma": 0.001}


@guards("s5b_weaker_damping")
def test_less_damping_makes_the_ratio_larger_for_short_delays_and_smaller_for_long_ones():
    walls = ((0, 0.3, 1.4, 2.0), (1, 0.1, 0.7, 0.5), (4, 0.05, 0.3, 0.1), (8, 0.03, 0.17, 0.05))
    for gamma in (0.0, 1e-3):
        for d, low, high, top in walls:
            light, heavy = (stiffest(gamma, f, d, low, high, top)[0] / f for f in (0.01, 0.02))
            assert light > heavy
    late = {
        f: passive(f, 200) / first_arc(mpmath.mpf(0), f, 200)
        for f in map(mpmath.mpf, ("0.01", "0.02"))
    }
    light, heavy = late.values()
    assert light > heavy
    assert 1 - light == pytest.approx(0.004, abs=5e-4)
    assert 1 - heavy == pytest.approx(0.014, abs=5e-4)


@guards("s5b_soft_contacts_undelayed")
def test_without_delay_every_softer_wall_is_stable_too():
    rng = np.random.default_rng(59)
    found = 0
    while found < 60:
        gamma, delta = rng.uniform(0, 0.01), rng.uniform(1e-3, 0.1)
        alpha, beta = rng.uniform(0, 0.75), rng.uniform(-0.1, 2)
        if oracle.stable(alpha, beta, gamma, delta, 0):
            found += 1
            softer = np.linspace(-0.99 * gamma, alpha, 20)
            assert oracle.moduli(softer, beta, gamma, delta, 0).max() < 1
    # n_1 > n_0, and its slope
    for gamma, delta in ((0.0, 0.05), (0.01, 0.1), (0.005, 0.001)):

        def apart(f, gamma=gamma):
            n1, n0, *_ = oracle.numbers(gamma, f)
            return n1 - n0

        assert apart(delta) > 0
        assert apart(delta * 1.001) > apart(delta)


@guards("s5b_soft_contacts_undelayed")
def test_a_wall_that_only_its_stiffness_keeps_stable_one_period_late():
    assert oracle.certified(0.0, -2.5, 5.0, 0.5, 1) > 0
    assert oracle.certified(4.0, -2.5, 5.0, 0.5, 1) == 0
