"""Walls for every arm of a range: no unstable one inside, few stable ones left out, twice shown.

The attacks come first: walls that one arm of the range makes unstable, by eigenvalues of loops that
are built here from matrix exponentials, and certificates that say more than what was shown.
"""

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise, product

import numpy as np
import pytest
from hands import growth, loops, moved
from scipy.optimize import brentq

from symhaptic.bounds.safe import prove
from symhaptic.bounds.safe.check import Certificate, recheck, stable
from symhaptic.bounds.safe.curve import left_out, walls
from symhaptic.bounds.safe.find import NothingSafe, certified, outlines
from symhaptic.bounds.safe.prove import Columns
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.stability import is_stable
from symhaptic.numeric.tracing.extremes import stiffest_at

CASES = {
    "phantom": loops("0.072", "0.005", "3/2"),
    "undelayed": loops("0.1", "0.5", 0),
    "undamped": loops("0.1", 0, "1/4"),
    "late": loops("0.1", "0.5", 5, ((0, 2), (0, 20), (0, 1000))),
    "hands": loops("0.1", "0.5", 1, (("0.5", "2"), (2, 10), (0, 600)), (False, False)),
    "slow": loops("0.05", "0.05", 3, T="0.002"),
    "one": loops("0.1", "0.5", 2, (("0.8", "0.8"), ("5.5", "5.5"), (568, 568)), (False, False)),
}


@cache
def shown(name):
    return certified(CASES[name], columns=24)


def inside(columns, K, B):
    return any(
        top > 0 and columns.low <= K <= top and left <= B <= right
        for left, right, top in zip(columns.edges, columns.edges[1:], columns.tops, strict=False)
    )


@pytest.mark.parametrize("name", CASES)
def test_a_wall_that_one_arm_makes_unstable_is_never_inside(name):
    case, columns = CASES[name], shown(name).columns
    rng = np.random.default_rng(7)
    T, delay = float(case.period), float(case.periods[0])
    tried = 0
    corners = [None] * 20 + list(product((0, 1), repeat=3))
    for at in corners:
        m, b, k = moved(case, rng, at)
        theta = rng.uniform(0.0, 1.0, 60) ** 3 * np.pi / (delay + 1)
        alpha, beta = stability_boundary(theta[theta > 1e-6], k * T * T / m, b * T / m, delay)
        for K, B in zip(alpha * m / T**2, beta * m / T, strict=True):
            if columns.low < K and columns.edges[0] <= B <= columns.edges[-1]:
                tried += 1
                assert not inside(columns, K, B), (K, B, m, b, k)
    assert tried > 30


@pytest.mark.parametrize("name", CASES)
def test_triedinside_are_stable_by_eigenvalues_for_random_arms(name):
    case, columns = CASES[name], shown(name).columns
    rng = np.random.default_rng(3)
    T, delay = float(case.period), float(case.periods[0])
    used = [i for i, top in enumerate(columns.tops) if top > 0]
    for _ in range(150):
        i = rng.choice(used)
        K = columns.tops[i] * rng.choice([1.0, 0.5, 0.01])
        left, right = columns.edges[i : i + 2]
        B = left + rng.choice([0.0, 0.5, 1.0]) * (right - left)
        at = None if rng.uniform() < 0.5 else rng.integers(0, 2, 3)
        assert growth(max(K, columns.low), B, *moved(case, rng, at), T, delay) < 1


@pytest.mark.parametrize("name", CASES)
def test_hardly_a_wall_is_left_out(name):
    """Beside the walls that are stable for many arms, on a grid."""
    case, columns = CASES[name], shown(name).columns
    rng = np.random.default_rng(5)
    T, delay = float(case.period), float(case.periods[0])
    some = [moved(case, rng) for _ in range(40)]
    corners = product((0, 1e-3, 1e-2, 1), (0, 1), (0, 1))
    some += [moved(case, rng, corner) for corner in corners]
    K, B = np.meshgrid(
        np.linspace(columns.low, 1.2 * max(columns.tops), 60),
        np.linspace(columns.edges[0], 1.1 * columns.edges[-1], 60),
    )
    good = np.ones_like(K, dtype=bool)
    for m, b, k in some:
        good &= is_stable(K * T * T / m, B * T / m, k * T * T / m, b * T / m, delay)
    kept = np.array([inside(columns, *wall) for wall in zip(K.flat, B.flat, strict=True)])
    assert not (kept & ~good.ravel()).any()
    assert kept.sum() > 0.9 * good.sum() - 2


@pytest.mark.parametrize(
    ("mass", "damping", "T", "delay"),
    [
        ("0.05", "0.05", "0.002", 3),
        pytest.param("0.1", "0.5", "0.001", 30, marks=pytest.mark.ci),
    ],
)
def test_long_delays_are_proved_with_less_stiffness_within_a_bounded_effort(
    mass, damping, T, delay
):
    """No wall was shown for any of them after 60 000 pieces."""
    case = loops(mass, damping, delay, T=T)
    claim = certified(case, columns=48)
    assert len(claim.cuts) < 13_000
    columns = claim.columns
    edges, tops = np.array(columns.edges), np.array(columns.tops)
    rng, period = np.random.default_rng(11), float(case.period)
    share = rng.uniform(size=tops.size)
    K = np.concatenate([tops, share * tops])
    B = np.concatenate([edges[:-1], edges[:-1] + share * np.diff(edges)])
    kept = columns.low <= K
    good = np.ones(K.shape, dtype=bool)
    for i in range(200):
        m, b, k = moved(case, rng, None if i % 4 else rng.integers(0, 2, 3))
        good &= is_stable(
            K * period**2 / m, B * period / m, k * period**2 / m, b * period / m, delay
        )
    assert good[kept].all()
    alone = stiffest_at(edges[24] * period / float(case.mass), 0.0,
                        float(case.damping) * period / float(case.mass), delay)  # fmt: skip
    assert tops[24] > 0.5 * float(alone.alpha) * float(case.mass) / period**2


def test_a_wall_of_one_plant_and_angle_lies_where_the_compiled_boundary_has_it():
    case = CASES["phantom"]
    for h, r, s, theta in ((0.5, 7, 300, 0.03), (0, 0, 0, 0.6), (23, 20, 1000, 1.2)):
        point = tuple((Fraction(x), Fraction(x)) for x in (h, r, s))
        found = walls(case, (Fraction(theta), Fraction(theta)), point)
        m, b, k = 0.072 + h, 0.005 + r * h, s * h
        alpha, beta = stability_boundary(theta, k * 1e-6 / m, b * 1e-3 / m, 1.5)
        for (low, high), value in ((found.K, alpha * m * 1e6), (found.B, beta * m * 1e3)):
            assert low - 1e-9 * abs(value) <= value <= high + 1e-9 * abs(value)
            assert high - low < 1e-8 * abs(value) + 1e-9


CLAIM = "phantom"


def raised(claim, i, share=0.5):
    """A column a little higher than the device without an arm bears somewhere in it."""
    columns, one = claim.columns, claim.loops
    m, b, T = map(float, (one.mass, one.damping, one.period))
    left, right = columns.edges[i : i + 2]
    beta = (left + share * (right - left)) * T / m
    limit = stiffest_at(beta, 0.0, b * T / m, float(one.periods[0])).alpha * m / T**2
    tops = list(columns.tops)
    tops[i] = 1.001 * float(limit)
    return replace(claim, columns=replace(columns, tops=tuple(tops)))


def narrower(claim):
    """The same walls in 16 times as many columns, so that a piece of the circle passes several."""
    columns = claim.columns
    left = (np.linspace(*ends, 16, endpoint=False) for ends in pairwise(columns.edges))
    edges = (*np.concatenate([*left]).tolist(), columns.edges[-1])
    tops = tuple(np.repeat(columns.tops, 16).tolist())
    return replace(claim, columns=replace(columns, edges=edges, tops=tops))


def opened(claim, change):
    return replace(claim, columns=replace(claim.columns, **change(claim.columns)))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda c: raised(c, 12),
        lambda c: raised(c, 12, 0.0),
        lambda c: raised(c, 12, 1.0),
        lambda c: raised(c, 3),
        lambda c: raised(c, 21),
        lambda c: raised(narrower(c), 1),
        lambda c: opened(c, lambda x: {"low": 0.0}),
        lambda c: opened(c, lambda x: {"edges": tuple(e + 0.7 for e in x.edges)}),
        lambda c: opened(
            c, lambda x: {"edges": (*x.edges, 1.1 * x.edges[-1]), "tops": (*x.tops, 5.0)}
        ),
        lambda c: replace(c, cuts=c.cuts[:-1]),
        lambda c: replace(c, cuts=c.cuts + "."),
        lambda c: replace(c, cuts="." * 3),
        lambda c: replace(c, cuts=c.cuts.replace("0", "4", 1)),
        lambda c: replace(c, angles=(*c.angles[:-1], Fraction(3))),
        lambda c: replace(c, angles=c.angles[1:]),
        lambda c: replace(c, stable=()),
        lambda c: replace(c, stable=((1e5, 10.0),)),
        lambda c: replace(c, loops=c.loops._replace(mass=Fraction("0.07"))),
        lambda c: replace(c, loops=c.loops._replace(damping=Fraction(0))),
        lambda c: replace(c, loops=c.loops._replace(periods=(Fraction(8, 5), Fraction(8, 5)))),
        lambda c: replace(c, loops=c.loops._replace(periods=(Fraction(1), Fraction(5, 2)))),
    ],
)
def test_a_certificate_that_says_more_than_was_shown_is_refused(wrong):
    assert not recheck(wrong(shown(CLAIM)))


def test_the_certificate_itself_is_confirmed():
    assert recheck(shown(CLAIM))
    assert recheck(narrower(shown(CLAIM)))


@pytest.mark.parametrize("name", ["phantom", "one"])
def test_the_wall_of_a_run_is_stable_as_its_eigenvalues_are(name):
    case, rng, seen = CASES[name], np.random.default_rng(3), set()
    m, b, k = moved(case, rng, (0, 0, 0))
    T, delay = float(case.period), float(case.periods[0])
    tried = zip(rng.uniform(-2 * k, 4 * b / T, 400), rng.uniform(-b, 4 * b, 400), strict=True)
    for K, B in tried:
        size = growth(K, B, m, b, k, T, delay)
        if abs(size - 1) > 1e-5:  # a double root near 1 has half the digits
            seen.add(size < 1)
            assert stable(case, (K, B)) == (size < 1), (K, B)
    assert seen == {True, False}


def test_a_run_that_is_unstable_everywhere_is_no_run():
    """All columns stand where no root crosses, but beyond the last stable damping."""
    claim = shown("undelayed")
    columns = claim.columns
    beyond = replace(columns, edges=(300.0, 310.0), tops=(5.0,))
    assert not recheck(replace(claim, columns=beyond, stable=((3.0, 305.0),)))


def test_a_column_below_the_softest_wall_joins_no_walls():
    """Without delay a stiff wall's largest damping has a root at -1, which passes a thin column.

    That column has no wall: those on its other side are unstable, and no root need cross for it.
    """
    arm = ((0, 0), (0, 0), (100, 100))
    case, low, thin = loops("0.5", "2.5", 0, arm, (False, False)), 2e4, 2.5

    def size(B):
        return growth(low, B, 0.5, 2.5, 100.0, 1e-3, 0)

    most = float(brentq(lambda B: size(B) - 1, 900, 1100))
    assert size(most - 20) < 1 < size(most + 20)
    edges = (most - 30, most - thin, most + thin, most + 30)
    for bridge in (1e-300, 0.999 * low):
        columns = Columns(edges, (1.0001 * low, bridge, 1.0001 * low), low)
        found = prove.shown(case, columns)
        assert found.columns == columns
        claim = Certificate(case, columns, found.cuts, found.angles, ((low, most - 20),))
        assert not recheck(claim)


@pytest.mark.parametrize(
    ("case", "told"),
    [
        (loops("0.1", "0.5", 200), "delay: nothing is shown for more than"),
        (loops("0.1", 0, 1, ((0, 0), (0, 0), (10**7, 10**7)), (False, False)), "arms: "),
    ],
)
def test_what_is_not_shown_is_said_in_one_line(case, told):
    with pytest.raises(NothingSafe, match=f"^{told}") as wrong:
        certified(case)
    assert "\n" not in str(wrong.value)


@pytest.mark.filterwarnings("error")
def test_an_arm_whose_triedno_float_holds_is_no_bound():
    """1e306 kg at 1 kHz: alpha m/T^2 overflows; the command said so twice before its one line."""
    largest = [K.max() for K, _ in outlines(loops("0.1", "0.5", 0, ((0, 10**306), (0, 0), (0, 0))))]
    assert np.isinf(largest).any()


@pytest.mark.parametrize("q", [1.0, 1.3, 2.0, 4.9])
def test_what_a_series_leaves_out_is_bounded_with_its_derivatives(q):
    """j! c_j is at most (2 q)^(j - 2); a speed has j c_j, and Cauchy's circle has the radius 1."""
    near, beyond = (float(ball.upper()) for ball in left_out(q))
    terms = [(2 * q, j - 2, math.factorial(j - 1)) for j in range(24, 150)]
    assert sum(rate**n / many for rate, n, many in terms) <= near
    assert sum(2 * n * rate ** (n - 1) / many for rate, n, many in terms) <= beyond
    assert beyond == pytest.approx(4 * (2 * (q + 1)) ** 22 / math.factorial(23), rel=1e-6)
    assert all(ball.contains(0) and ball.mid() == 0 for ball in left_out(q))


def test_beyond_the_series_nothing_is_known():
    assert not any(ball.is_finite() for ball in left_out(6.1))
