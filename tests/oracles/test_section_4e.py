"""The linear condition: a cubic's roots, the exact boundary in 60 digits, certified counts."""

from itertools import pairwise

import mpmath
import numpy as np
import oracle
import pytest
from oracles import energy
from oracles.guarding import guards
from oracles.search import edge
from oracles.subject import counterexample, decimals, number, only, page, settled, shown, value

pytestmark = pytest.mark.ci

LAG, DROPPED, LINE = "s4e_lag", "s4e_lag_dropped", "s4e_line"
CASES = [(0.4, 3.0, 250.0, 30.0, 2e-3), (2.0, 9.0, 10.0, -4.0, 0.1), (0.02, 0.3, 0.0, 0.1, 0.01)]
"""m, b, k, B and t_e."""


def lagging(m, b, k, K, B, t_e):
    """Roots of (m s^2 + b s + k)(1 + t_e s) + K + B s."""
    loop = np.polymul([m, b, k], [t_e, 1])
    loop[-2:] += B, K
    return np.roots(loop), loop[0]


@guards("s4e_lag")
def test_hurwitz_determinant_is_the_product_of_sums_of_roots():
    """Orlando: a_2 a_1 - a_3 a_0 = -a_3^2 times the three sums of two roots."""

    def agrees(determinant):
        for m, b, k, B, t_e in CASES:
            for K in (0.5 * (b + B) / t_e, 3 * (b + B) / t_e):
                (p, q, r), lead = lagging(m, b, k, K, B, t_e)
                found = -(lead**2) * ((p + q) * (q + r) * (p + r)).real / m
                at = {"m": m, "b": b, "k": k, "K": K, "B": B, "t_e": t_e}
                assert number(determinant, **at) == pytest.approx(found, rel=1e-9)

    only(
        agrees, shown(LAG, "Hurwitz' determinant of this loop is the margin of (24) plus one term")
    )


@guards("s4e_lag")
def test_what_hold_and_difference_are_beside_lag_and_derivative():
    s, T, t_d = mpmath.mpf("1e-12"), mpmath.mpf("0.3"), mpmath.mpf("0.7")

    def agrees(lag, derivative):
        held = mpmath.exp(-t_d * s) * (1 - mpmath.exp(-T * s)) / (T * s)
        found = (held - 1 / (1 + (t_d + T / 2) * s)) / s**2
        assert abs(found - value(lag, T=T, t_d=t_d)) < 1e-11  # the next term is of the order of s
        found = ((1 - mpmath.exp(-T * s)) / T - s) / s**2
        assert abs(found - value(derivative, T=T)) < 1e-11

    only(
        agrees,
        shown(LAG, "The error of the lag is of second order"),
        shown(LAG, "The error of the derivative is of second order"),
    )


@guards("s4e_lag", "s4e_lag_dropped")
def test_the_border_of_the_lagging_loop():
    def border(m, b, k, B, t_e):
        return edge(0.0, 1e9, lambda K: lagging(m, b, k, K, B, t_e)[0].real.max() < 0, 90)

    def agrees(stiffness):
        for m, b, k, B, t_e in CASES:
            at = {"m": m, "b": b, "k": k, "B": B, "t_e": t_e}
            # 90 halvings, roots to 1e-13
            assert number(stiffness, **at) == pytest.approx(border(m, b, k, B, t_e), rel=1e-7)

    only(agrees, shown(DROPPED, "Routh's condition allows more stiffness than (24)"))

    def agrees_for_a_heavy_mass(stiffness):
        for m, b, k, B, t_e in CASES:
            found = border(1e5 * m, b, k, B, t_e)  # the dropped term is 1e5 times smaller
            at = {"b": b, "B": B, "t_d": 0.4 * t_e, "T": 1.2 * t_e, "t_e": t_e}
            assert number(stiffness, **at) == pytest.approx(found, rel=1e-3)

    (condition,) = settled(LAG, "eq24")
    linear = condition.lhs if condition.rhs.is_Symbol else condition.rhs
    only(agrees_for_a_heavy_mass, linear)
    rng = np.random.default_rng(42)
    for _ in range(200):  # linear-lag: the condition errs on the safe side for the lag
        m, b, k, t_e = 10 ** rng.uniform(-2, 2, 4)
        B = rng.uniform(-b, 3 * b)
        K = rng.uniform(-k, (b + B) / t_e) if (b + B) / t_e > -k else -k / 2
        if -k < K < (b + B) / t_e:
            assert lagging(m, b, k, K, B, t_e)[0].real.max() < 0


def surplus(alpha, beta, delta, d):
    return beta + delta - (d + mpmath.mpf(1) / 2) * alpha


def arm(gamma, delta):
    """nu, s_1 and s_2 by the expansion of 1/P at z = 1, from differences."""
    at = oracle.named(gamma, delta)
    total = at["n_1"] + at["n_0"]
    nu, s_1 = at["n_0"] / total, (1 - at["e"] + gamma * at["n_0"]) / total
    return {"nu": nu, "s_1": s_1, "s_2": 1 / total - (1 - nu) * s_1}


@guards("s4e_line")
def test_the_boundary_beside_the_line_at_its_start_and_for_short_periods():
    small = mpmath.mpf("1e-15")

    def agrees(start, onwards):
        for gamma, delta, d in ((0.3, 0.2, 0), (2.0, 0.5, 2), (1e-3, 0.02, 1)):
            gamma, delta = mpmath.mpf(gamma), mpmath.mpf(delta)
            at = {"gamma": gamma, "delta": delta, "d": d, **arm(gamma, delta)}
            lies = surplus(*oracle.wall(small, gamma, delta, d, 90), delta, d)
            assert abs(lies - value(start, **at)) < 1e-28
            assert abs((lies - value(start, **at)) / small**2 - value(onwards, **at)) < 1e-20

    only(
        agrees,
        shown(LINE, r"At the start of the boundary, the surplus $\Delta$ is minus the gap"),
        shown(LINE, "The initial slope of the boundary is smaller than that of the line"),
    )

    def agrees_at_the_crossing(crossing):
        for d in (0, 1, 4):
            delta = mpmath.mpf("1e-8")  # the next terms are of this size
            guess = mpmath.sqrt(
                delta * (6 * (d + 1) ** 2 + 1) / ((d + 1) * (2 * d + 1) * (2 * d + 3))
            )
            angle = mpmath.findroot(
                lambda t, d=d, delta=delta: (
                    surplus(*oracle.wall(t, delta**2, delta, d, 90), delta, d) / t**2
                ),
                (guess, 1.1 * guess),
            )
            alpha = oracle.wall(angle, delta**2, delta, d, 90)[0]
            assert abs(value(crossing, delta=delta, d=d) / alpha - 1) < 1e-5

    title = "For short periods the boundary crosses the line at one stiffness"
    only(agrees_at_the_crossing, shown(LINE, title))


@guards("s4e_line_error", "s4e_line_error_start")
def test_the_error_along_the_boundary_and_at_its_start():
    def error(theta, gamma, delta, d):
        alpha, beta = oracle.wall(theta, gamma, delta, d, 90)
        lin = (beta + delta) / (d + mpmath.mpf(1) / 2)
        return (lin - alpha) / (alpha + gamma), alpha, beta, lin

    def agrees(definition, by_surplus, free):
        for gamma, delta, d, theta in ((0.3, 0.2, 0, 0.5), (1e-3, 0.02, 1, 0.1)):
            found, alpha, beta, lin = error(theta, gamma, delta, d)
            at = {"alpha": alpha, "beta": beta, "gamma": gamma, "delta": delta, "d": d}
            assert abs(value(definition, alpha_lin=lin, **at) - abs(found)) < 1e-40
            assert abs(value(by_surplus, **at) - found) < 1e-40
        for d, theta in ((0, 0.5), (2, 0.3)):
            assert abs(value(free, d=d, theta=theta) - error(theta, 0, 0, d)[0]) < 1e-40

    titles = [
        "The relative error compares stiffnesses at the same $\\beta$",
        r"The error is the surplus $\Delta$ divided by $(d+\frac12)(\alpha+\gamma)$",
    ]
    titles.append("For a free mass the error is a quotient of sines")
    only(agrees, *(shown("s4e_line_error", title) for title in titles))

    def agrees_at_the_start(bare, undamped):
        small = mpmath.mpf("1e-12")  # the next term is of its square
        for delta, d in ((mpmath.mpf("0.02"), 0), (mpmath.mpf(1), 2)):
            ours = value(bare, delta=delta, d=d, **arm(mpmath.mpf(0), delta))
            assert abs(error(small, 0, delta, d)[0] - ours) < 1e-15
        for gamma, d in ((mpmath.mpf("0.001"), 1), (mpmath.mpf(2), 3)):
            ours = value(undamped, gamma=gamma, d=d, **arm(gamma, mpmath.mpf(0)))
            assert abs(error(small, gamma, 0, d)[0] - ours) < 1e-15

    titles = (
        r"Without a spring the initial error is a quotient in $\delta$",
        "Without damping the initial error is negative",
    )
    only(agrees_at_the_start, *(shown("s4e_line_error_start", title) for title in titles))
    for gamma, delta in ((mpmath.mpf(2), mpmath.mpf("0.5")), (mpmath.mpf("0.001"), 0.02)):
        assert error(mpmath.mpf("1e-12"), gamma, delta, 1)[0] < -1e3


@guards("s4e_line_figure")
@pytest.mark.parametrize("d", [0, 1])
def test_the_points_of_figure_10_are_all_there(d):
    """Each listed point by an independent wall, and as many sign changes as points."""
    tables = [block for block in page("s4e_line_figure").blocks if block.kind == "table"]
    _, *rows = tables[d].rows
    gamma = mpmath.mpf("0.001")
    listed = {}
    for damping, level, *point in rows:
        theta, alpha, beta = (mpmath.mpf(cell.strip("$")) / 1000 for cell in point)
        delta = mpmath.mpf(str(damping)) / 1000
        listed.setdefault(delta, []).append((mpmath.mpf(str(level)) / 100, theta))
        found = oracle.wall(theta, gamma, delta, d)
        # fifteen digits of theta, times the slope of the curve
        assert abs(found[0] - alpha) < 1e-15
        assert abs(found[1] - beta) < 1e-15
    angles = [mpmath.mpf(10) ** (mpmath.mpf(i) / 16 - 6) for i in range(108)]
    for delta, points in listed.items():
        walls = [oracle.wall(t, gamma, delta, d) for t in angles if t < 1.4]
        walls = walls[: next((i for i, w in enumerate(walls) if i > 9 and w[0] < -gamma), None)]
        for percent in (-5, -2, 0, 2, 5):
            level = mpmath.mpf(percent) / 100
            half = d + mpmath.mpf(1) / 2
            signs = [surplus(a, b, delta, d) > level * half * (a + gamma) for a, b in walls]
            changes = sum(one != two for one, two in pairwise(signs))
            assert changes == sum(abs(e - level) < 1e-9 for e, _ in points)


def crossing(gamma, delta, d):
    """alpha where the line meets the boundary, the last sign change of the surplus going up."""
    guess = delta * (6 * (d + 1) ** 2 + 1) / ((d + 1) * (2 * d + 1) * (2 * d + 3))
    low, high = 0.3 * np.sqrt(guess), 3 * np.sqrt(guess) + 0.1
    theta = edge(
        low, high, lambda t: surplus(*oracle.wall(t, gamma, delta, d), delta, d) < 0, steps=30
    )
    return float(oracle.wall(theta, gamma, delta, d)[0])


@guards("s4e_line_unstable")
@pytest.mark.parametrize("d", [0, 1])
def test_the_line_is_stable_below_the_crossing_and_unstable_above(d):
    rng = np.random.default_rng(43 + d)
    for _ in range(15):
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(1e-3, 0.02)
        most = crossing(gamma, delta, d)
        for alpha in (*(most * np.array([0.2, 0.95, 1.05, 1.5, 6, 40])), -0.3 * gamma):
            # certified: on the line some roots are within 1e-9 of the circle
            outside = oracle.certified(alpha, alpha * (d + 0.5) - delta, gamma, delta, d)
            assert (outside > 0) == (alpha > most)


@guards("s4e_line_unstable_below")
@pytest.mark.parametrize("d", [0, 1])
def test_walls_of_the_linear_condition_below_the_crossing_are_stable(d):
    rng = np.random.default_rng(45 + d)
    for _ in range(20):
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(1e-3, 0.02)
        top = crossing(gamma, delta, d) * (d + 0.5) - delta
        beta = rng.uniform(-delta - gamma * (d + 0.5), top)
        alpha = -gamma + rng.uniform(0.001, 0.999) * ((beta + delta) / (d + 0.5) + gamma)
        assert oracle.certified(alpha, beta, gamma, delta, d) == 0

    def agrees(damping):
        for delta in (1e-6, 3e-6):  # short periods: the next terms are of this size
            found = crossing(1e-12, delta, d) * (d + 0.5) - delta
            assert number(damping, delta=delta, d=d) == pytest.approx(found, rel=1e-3)

    title = (
        r"For short periods, the damping $\beta_\times$ of the crossing is a multiple of $\delta$"
    )
    kept = () if d else ("d",)
    only(agrees, shown("s4e_line_unstable_below", title), by=0.05, kept=kept)


@guards("s4e_line_error_rises")
@pytest.mark.parametrize("d", [0, 1])
def test_the_error_rises_while_the_damping_is_negative(d):
    rng = np.random.default_rng(47 + d)
    for _ in range(8):
        gamma, delta = mpmath.mpf(rng.uniform(0, 1e-3)), mpmath.mpf(rng.uniform(1e-3, 0.02))
        errors = []
        for exponent in range(-80, 0):
            theta = mpmath.mpf(10) ** (mpmath.mpf(exponent) / 20)
            alpha, beta = oracle.wall(theta, gamma, delta, d)
            if beta > 0:
                break
            lies = surplus(alpha, beta, delta, d)
            errors.append(lies / (d + mpmath.mpf(1) / 2) / (alpha + gamma))
        assert len(errors) > 40
        assert all(one < two for one, two in pairwise(errors))
        assert errors[-1] < 0.02


@guards("s4e_line_second_order")
@pytest.mark.parametrize("d", [0, 1])
def test_the_boundary_leaves_the_line_by_terms_of_second_order(d):
    """Walls with a zero on the circle, alpha <= 0.03; less than half of the bound is not enough."""
    rng = np.random.default_rng(71 + d)
    nearest = 0.0
    for gamma, delta in (*rng.uniform(0, (1e-3, 0.02), (12, 2)), (0, 0), (1e-3, 0), (0, 0.02)):
        for theta in np.sqrt(0.03 * rng.uniform(1e-6, 1, 12)):
            alpha, beta = oracle.wall(mpmath.mpf(theta), gamma, delta, d)
            lies = surplus(alpha, beta, delta, d)
            if alpha <= 0.03:
                above, below = 3 * (alpha + gamma) ** 2, 3 * (delta + gamma) * (alpha + 2 * gamma)
                assert -below - 1e-15 <= lies <= above
                nearest = max(nearest, lies / above, -lies / below if below else 0)
    assert nearest > (0.05, 0.5)[d]


@guards("s4e_line_second_order")
def test_with_short_periods_the_surplus_is_of_the_order_of_the_period():
    """b + B - K T (d + 1/2) for m = 0.4, b = 3, k = 250 at K T = 100, over T."""
    m, b, k, push = 0.4, 3.0, 250.0, 100.0
    for d in (0, 1):
        found = []
        for T in (mpmath.mpf("1e-5"), mpmath.mpf("1e-6")):
            gamma, delta, alpha = k * T**2 / m, b * T / m, push * T / m
            guess = mpmath.sqrt(alpha + gamma)
            angle = _angle(alpha, gamma, delta, d, guess)
            beta = oracle.wall(angle, gamma, delta, d, 60)[1]
            surplus_ = b + beta * m / T - push * (d + 0.5)
            assert abs(surplus_) <= 3 * (push + b) ** 2 * T / m * 1.01
            found.append(surplus_ / T)
        assert abs(found[0] / found[1] - 1) < 0.02


def _angle(alpha, gamma, delta, d, guess):
    """Where the boundary has a stiffness."""

    def away(theta):
        return oracle.wall(theta, gamma, delta, d, 60)[0] / alpha - 1

    return mpmath.findroot(away, (guess, 1.001 * guess))


@guards("s4e_line_error_rises")
@pytest.mark.parametrize("d", [0, 1])
def test_the_boundary_is_what_ends_the_stable_walls_of_a_damping(d):
    """The walls with a zero on the circle are not stable, all that are softer are."""
    rng = np.random.default_rng(61 + d)
    for _ in range(12):
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(5e-4, 0.02)
        theta = np.sqrt(gamma + delta * rng.uniform(0.05, 1.5))
        alpha, beta = map(float, oracle.wall(mpmath.mpf(theta), gamma, delta, d))
        assert oracle.certified(alpha + 1e-6, beta, gamma, delta, d) > 0
        for share in (1e-3, 0.3, 0.7, 1):
            softer = -gamma + share * (alpha - 1e-6 + gamma)
            assert oracle.certified(softer, beta, gamma, delta, d) == 0


@guards("s4e_line_free_mass")
@pytest.mark.parametrize("d", [0, 1, 3])
def test_stable_walls_of_a_free_mass_lie_above_the_line(d):
    rng = np.random.default_rng(49 + d)
    size = np.tan(np.pi / 4 / (d + 1))
    found = 0
    for _ in range(400):
        alpha, beta = rng.uniform(0, 1.2 * size**2), rng.uniform(0, 2 * size)
        if oracle.stable(alpha, beta, 0, 0, d):
            found += 1
            assert beta > (d + 0.5) * alpha
    assert found > 40
    for alpha in size**2 * np.array([0.001, 0.1, 0.5, 1.0]):
        assert oracle.certified(alpha, (d + 0.5) * alpha, 0, 0, d) > 0


@guards("s4e_line_passive")
def test_low_frequencies_are_what_the_linear_condition_sees():
    def agrees(low):
        for d, K, B in ((0, 0.7, 0.2), (2, 0.3, -0.4)):
            # rounding of K/theta^2 at theta = 1e-4, and the next term, of order (d+1)^3 theta^2
            found = 1 - energy.need(K, B, d, np.array([1e-4]))[0]
            assert number(low, b=1, K=K, B=B, T=1, d=d) == pytest.approx(found, abs=1e-5)

    only(
        agrees,
        shown("s4e_line_passive", r"The limit of (5) for $\omega\to0$ is (9)"),
        kept=("T",),
    )
    # K = T = 1, B = d = 0: b_D + b_H = 1 is more than K T/2, the device's own 0.01 is not enough
    assert energy.left(1.0, 0.0, b=1.01) > 0
    assert energy.left(1.0, 0.0, b=0.01) < 0


@guards("s4e_line_trade")
def test_physical_damping_is_worth_more_than_virtual_damping():
    step = mpmath.mpf("1e-20")

    def damping(alpha, gamma, delta, d):
        """Of the boundary at a stiffness."""
        guess = mpmath.sqrt(alpha + gamma)
        angle = mpmath.findroot(
            lambda t: oracle.wall(t, gamma, delta, d, 90)[0] / alpha - 1, (guess, 1.001 * guess)
        )
        return oracle.wall(angle, gamma, delta, d, 90)[1]

    def agrees(worth):
        alpha = delta = mpmath.mpf("1e-7")  # the next terms are smaller by this
        for d in (0, 1, 3):
            low, high = (damping(alpha, alpha**2, delta + s, d) for s in (-step, step))
            found = (low - high) / (2 * step)
            ours = value(worth, alpha=alpha, d=d)
            assert abs((found - 1) / (ours - 1) - 1) < 1e-4

    title = "A unit of physical damping replaces more than one unit of virtual damping"
    only(agrees, shown("s4e_line_trade", title))
    virtual = counterexample("s4e_line_trade", "s6-linear-dissipation")
    assert not oracle.stable(*(virtual[n] for n in ("alpha", "beta", "gamma", "delta", "d")))
    assert oracle.stable(0.01, -0.005, 0.001, 0.02, 1)


@guards("s4e_line_two_percent")
def test_at_the_thresholds_the_error_without_stiffness_is_two_per_cent():
    found = decimals(
        "s4e_line_two_percent",
        r"Intervals contain the dampings $\delta$ at which the error at "
        r"$\alpha=0$ is $-2\,\%$",
    )
    cases = [(0, "0"), (0, "0.001"), (1, "0"), (1, "0.001")]
    for (d, spring), delta in zip(cases, found, strict=True):
        gamma, half = mpmath.mpf(spring), d + mpmath.mpf(1) / 2

        def error(theta, d=d, gamma=gamma, delta=delta, half=half):
            alpha, beta = oracle.wall(theta, gamma, delta, d, 90)
            return alpha, surplus(alpha, beta, delta, d) / half / (alpha + gamma)

        theta = mpmath.mpf("1e-15")  # without a spring: the limit at the start
        if gamma:
            root = mpmath.sqrt(gamma)
            theta = mpmath.findroot(lambda t: error(t)[0], (root, 1.01 * root))
        # 22 digits of the damping, times a slope of about (d+1)^2
        assert abs(error(theta)[1] + mpmath.mpf("0.02")) < 1e-18
