"""What the conclusion says of delay, rate, mass, damper and spring: searches and simulations."""

import re
from functools import cache

import mpmath
import numpy as np
import oracle
import pytest
from oracles import energy, motion
from oracles.guarding import guards
from oracles.search import first_arc, stiffest
from oracles.subject import counterexample, number, only, page, shown

pytestmark = pytest.mark.ci

with mpmath.workdps(60):
    DELTA = mpmath.mpf(1) / 50
    SPRING = mpmath.mpf(1) / 1000


@cache
def most(gamma, delta, d):
    """The largest stable stiffness by a search, and by the first arc for longer delays."""
    if d == 0:
        return stiffest(float(gamma), float(delta), 0, 0.3, 1.4)[0]
    return first_arc(mpmath.mpf(gamma), mpmath.mpf(delta), d)


@guards("s6_delay_one_period")
def test_what_one_period_of_delay_leaves_by_a_search():
    arms = [(1e-3, 0.02, 0.21654783), (0.0, 0.0, 0.21050726)]
    for gamma, delta, cut in arms:
        late, _ = stiffest(gamma, delta, 1, 0.1, 0.7, top=0.5)
        assert late / most(gamma, delta, 0) == pytest.approx(cut + 5e-9, abs=6e-9)
    rng = np.random.default_rng(94)
    for _ in range(2):  # inside (23)
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(0, 0.02)
        assert most(gamma, delta, 1) / most(gamma, delta, 0) < 0.22
    assert most(0.0, 0.0, 1) / most(0.0, 0.0, 0) == pytest.approx(0.2105, abs=5e-5)


@guards("s6_gains")
def test_what_faster_sampling_gains_at_the_same_delay():
    def agrees(scaled, limit):
        for d in (1, 5, 40):
            # K t_d/b with b = T = 1: where the damping of the wall drops out of its need
            K = 1 / energy.need(1.0, 0.0, d, np.array([np.pi / (2 * (d + 1))]))[0]
            assert number(scaled, d=d) == pytest.approx(K * d, rel=1e-12)
            assert K * d < number(limit) < (1 + 1 / d) * K * d
        far = 1e6
        K = 1 / energy.need(1.0, 0.0, far, np.array([np.pi / (2 * (far + 1))]))[0]
        assert number(limit) == pytest.approx(K * (far + 1), rel=1e-8)

    titles = (
        "With $T=t_d/d$ the stiffness (11) is inversely proportional to the delay",
        r"For $T\to0$ the passive limit $K_{\max}t_d/b$ tends to $\pi/2$",
    )
    only(agrees, *(shown("s6_gains", title) for title in titles))
    late = 10**8  # endlessly fast to 1e-16
    limit = first_arc(0, 0, late) * (late + 1) ** 2
    for d in (1, 2, 10, 60):
        now = first_arc(0, 0, d) * d**2
        assert 1 < limit / now < (1 + mpmath.mpf(1) / d) ** 2
    assert limit / first_arc(0, 0, int(counterexample("s6_gains", "s6-faster-sampling")["d"])) > 2


@guards("s6_gains")
def test_ten_times_as_fast_gains_less_than_a_quarter_at_ten_periods_and_a_lot_at_one():
    """For a free mass and the arm of the figures, by searches along the first arc."""

    def scaled(gamma, delta, d, q):
        arm = mpmath.mpf(gamma) / q**2, mpmath.mpf(delta) / q
        return q**2 * first_arc(*arm, q * d)

    for arm in ((0, 0), ("0.001", "0.02")):
        now = scaled(*arm, 10, 1)
        assert all(now < scaled(*arm, 10, q) < 1.25 * now for q in (2, 3, 10))
    assert 3.7 < scaled(0, 0, 1, 100) / scaled(0, 0, 1, 1) < 3.9
    assert counterexample("s6_gains", "s6-faster-sampling")["q"] == 100


@guards("s6_gains")
def test_more_mass_with_all_the_rest_moves_as_before():
    one = {"K": 300.0, "B": 0.6, "m": 0.4, "b": 1.0, "k": 50.0}
    two = {name: 2 * number for name, number in one.items()}
    for late in (0.0, 1.0, 2.4):
        places = [motion.positions(**wall, T=1e-2, late=late) for wall in (one, two)]
        # 200 periods of rounding
        assert np.allclose(*places, rtol=0, atol=1e-12 * np.abs(places[0]).max())
    alone = motion.positions(**{**one, "m": 0.8}, T=1e-2)
    assert not np.allclose(alone, motion.positions(**one, T=1e-2))


def printed(cell):
    """Leading decimals of a table's cell, which were cut."""
    return mpmath.mpf(re.search(r"[\d.]*\d", str(cell))[0])


def cut(exact, cell, d):
    """Whether a cell has the leading decimals of a number; the search has ten of them."""
    off = 1e-6 if d == 0 else 0
    text = re.search(r"[\d.]*\d", str(cell))[0]
    last = mpmath.mpf(10) ** -len(text.partition(".")[2])
    return -off <= exact - printed(cell) < last + off


@guards("s6_marginal")
def test_how_much_damper_and_spring_matter():
    growth, springs = (b.rows[1:] for b in page("s6_marginal").blocks if b.kind == "table")
    for d, (_, *cells) in enumerate(growth):
        for gamma, cell in zip((0, SPRING), cells, strict=True):
            assert cut(100 * (most(gamma, DELTA, d) / most(gamma, 0, d) - 1), cell, d)
    for d, (_, *cells) in enumerate(springs):
        for delta, cell in zip((0, DELTA), cells, strict=True):
            assert cut(100 * (most(0, delta, d) / most(SPRING, delta, d) - 1), cell, d)
    assert len(growth) == len(springs) == 8
    rng = np.random.default_rng(95)
    for gamma, delta in [(0, 0), (1e-3, 0), *rng.uniform(0, [1e-3, 0.02], size=(2, 2))]:
        found = most(gamma, delta, 0)
        assert found < 1.042 * 0.6848
        assert delta > 0 or found > 0.6848


@guards("s6_marginal")
def test_the_plant_for_which_damper_and_spring_matter():
    """By eigenvalues: beside the spring nothing that does not pull is stable without a damper."""
    points = [
        counterexample("s6_marginal", f"s6-{name}-any-delay") for name in ("damping", "stiffness")
    ]
    spring, d = points[0]["gamma"], int(points[0]["d"])
    assert all(p["gamma"] == spring < 1e-3 and p["d"] == d for p in points)
    assert [p["delta"] for p in points] == [0.02, 0]
    betas = np.linspace(-0.03, 0.03, 121)

    def least(alpha, gamma, delta):
        return oracle.moduli(alpha, betas, gamma, delta, d).max(axis=-1).min()

    for alpha in (0.0, 1e-5, 1e-4, 5e-4):
        assert least(alpha, spring, 0.0) > 1 - 1e-9  # without a wall its zeros are on the circle
    assert least(5e-4, spring, 0.02) < 1
    assert least(2e-4, 0.0, 0.0) < 1
    # and sixteen times the stiffness at d = 1000, as the note says
    assert 16 * first_arc(0, DELTA, 1000) < 0.00059
    for late in (0, 10, 60, 200):
        assert oracle.stable(0.00059, 0.0, SPRING, DELTA, late)
    assert not oracle.stable(0.00059, 0.0, 0.0, DELTA, 100)
