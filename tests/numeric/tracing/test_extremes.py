"""The largest stable stiffness beside whole traced regions and beside companion eigenvalues."""

import numpy as np
import pytest
from oracle import principal, principal_outside, radius

from symhaptic import is_stable, limit_at, max_stable_stiffness, stable_region
from symhaptic.balls import winding
from symhaptic.numeric.tracing import extremes
from symhaptic.numeric.tracing.arcs import Loop
from symhaptic.numeric.tracing.extremes import dampings_at, stiffest_at
from symhaptic.numeric.tracing.region import farthest


def plants(rng, count):
    """Plants and delays for which the first maximum is trusted, most of them near its limits."""
    delay = np.where(rng.random(count) < 0.5, rng.integers(0, 5, count), rng.uniform(0, 8, count))
    delay[: count // 4] = 0.0
    limit = np.minimum(np.where(delay <= 1, 9.8, (np.pi / (delay + 1)) ** 2), 9.8)
    gamma = limit * rng.choice([0.0, 0.5, 0.9, 0.999, 1.0], count) * rng.uniform(0.9, 1, count)
    delta = rng.choice([0.0, 0.05, 2.0, 20.0], count) * rng.random(count)
    return gamma, delta, delay


def test_the_first_maximum_is_that_of_the_traced_region():
    rng = np.random.default_rng(31)
    case = plants(rng, 40)
    found = max_stable_stiffness(*case).alpha
    traced = [
        farthest(Loop(*map(float, one)), np.array([1.0, 0.0]))[0] for one in np.stack(case, 1)
    ]
    assert found == pytest.approx(np.array(traced), rel=1e-9)


@pytest.mark.parametrize(
    "case",
    [
        (9.824044752280086, 0.09448959101690874, 0.0),  # a maximum at 3.05, beyond 23/24 pi
        (9.821654053881902, 2.7016296147788734e-08, 0.0),  # the curve ends at -3e12
        (8.0, 1.2849501345701888, 0.0),
        (5.882765301260491, 1.995207574845061, 0.0),
        (0.001, 0.02, 8.0),
        (0.001, 0.02, 3.7),
        (3.0, 0.1, 4.0),  # traced: the spring swings faster than the delay allows
        (9.0, 0.02, 2.5),
    ],
    ids=str,
)
def test_stable_on_the_left_and_not_on_the_right(case):
    """Along the line of its own damping, by eigenvalues."""
    alpha, beta, theta = max_stable_stiffness(*case)
    step = 1e-5 * (alpha + case[0])
    inside, outside = radius(np.array([alpha - step, alpha + step]), beta, *case)
    assert inside < 1 < outside
    assert 0 < theta <= np.pi


@pytest.mark.parametrize("case", [(0.5, 0.1, 1), (2.0, 0.5, 0), (3.0, 0.1, 4), (1e-3, 0.02, 2.5)])
def test_no_grid_finds_a_stiffer_wall(case):
    """Brute force: 120 x 120 walls around the maximum, by eigenvalues."""
    best = max_stable_stiffness(*case)
    alphas = np.linspace(0, 1.6 * best.alpha, 120)
    betas = best.beta + (best.alpha + 0.1) * np.linspace(-2, 2, 120)
    alpha, beta = (v.ravel() for v in np.meshgrid(alphas, betas))
    stable = radius(alpha, beta, *case) < 1 - 1e-9
    reached = alpha[stable].max()
    assert reached <= best.alpha * (1 + 1e-12)
    assert reached >= 0.95 * best.alpha  # the grid is fine enough to come close


def test_arrays_longer_than_a_block_are_what_their_elements_are():
    rng = np.random.default_rng(32)
    gamma, delta = rng.uniform(0, 1e-3, 40_000), rng.uniform(0, 0.02, 40_000)
    delay = rng.choice([0.0, 0.5, 1.0, 6.0], 40_000)
    many = max_stable_stiffness(gamma, delta, delay)
    for i in rng.integers(0, 40_000, 40):
        one = max_stable_stiffness(gamma[i], delta[i], delay[i])
        assert np.array(one) == pytest.approx(np.array([v[i] for v in many]), rel=1e-10)


def test_the_region_says_the_same():
    for case in [(0.0, 0.0, 0), (0.001, 0.02, 1), (2.0, 0.3, 1.5)]:
        region, found = stable_region(*case), max_stable_stiffness(*case)
        assert float(region.max_stiffness.alpha) == pytest.approx(float(found.alpha), rel=1e-12)
        assert region.outline[0][:, 0].max() == pytest.approx(float(found.alpha), rel=1e-5)


def test_the_count_by_the_argument_is_that_by_all_roots():
    rng = np.random.default_rng(2)
    for delay in (0.5, 1.5, 1.75):
        case = *rng.uniform((0, -1, 0, 0), (2, 1, 8, 1)), delay
        assert principal_outside(*case) == np.sum(principal(*case) > 1)


def test_next_to_a_whole_delay_the_principal_sheet_is_bounded():
    """Its curve goes to infinity within pi - theta = 1e-8, and borders nothing there.

    The result was 5e8.  What is right lies beyond the exact one: where a root is at -1 for a whole
    delay, one of this sheet passes through the cut and is lost from sight.
    """
    loop = 8.932747372012944, 0.1879732294715988, 1.9999999937605732
    alpha, beta, _ = (float(v) for v in max_stable_stiffness(*loop, sheet="principal"))
    exact = float(max_stable_stiffness(*loop).alpha)
    assert exact == pytest.approx(7.518742463137421, rel=1e-9)
    assert alpha == pytest.approx(
        8.86487735893144078, rel=1e-14
    )  # mpmath, where the curve meets itself
    assert principal_outside(8.85, -3.5577, *loop) == 0
    assert radius(8.85, -3.5577, *loop[:2], 2.0) > 1.1
    beside = beta + np.linspace(-2, 2, 4001)
    assert not is_stable(alpha * (1 + 1e-6), beside, *loop, sheet="principal").any()
    for wall in ((8.9, -3.5577), (8.9, beta), (5e8, -2.5e8)):
        assert principal_outside(*wall, *loop) > 0
    with pytest.raises(ValueError, match="the pieces of its boundary do not meet"):
        max_stable_stiffness(38.34550658404032, 0.17688191338806936, 2**-53, sheet="principal")


@pytest.mark.parametrize("delta", [1e-9, 1e-12, 1e-15, 1e-28])
@pytest.mark.parametrize("delay", [0.0, 1.0, 1.5, 7.0])
def test_the_stiffest_wall_beside_next_to_no_damping(delta, delay):
    """As delta -> 0 it is delta/(delay + 1/2), at an angle of some sqrt(delta): once NaN."""
    found = stiffest_at(0.0, 0.0, delta, delay)
    assert found.alpha == pytest.approx(delta / (delay + 0.5), rel=max(1e-9, 10 * delta))
    assert 0 < found.theta < 2 * np.sqrt(delta) or delay == 0


def test_a_loop_that_is_not_traced_leaves_the_others_their_limits():
    """Next to half a swing in a period and undamped: refused alone, NaN among others."""
    missed = 9.8696044
    with pytest.raises(ValueError, match=r"gamma: 9.8696044 .* is not traced"):
        max_stable_stiffness(missed, 0.0, 1.0)
    with pytest.warns(RuntimeWarning, match=r"gamma: 9.8696044 .* it is NaN here"):
        among = max_stable_stiffness([0.1, missed, 0.5], 0.0, 1.0)
    assert np.isnan([v[1] for v in among]).all()
    for at, gamma in ((0, 0.1), (2, 0.5)):
        assert [v[at] for v in among] == pytest.approx(max_stable_stiffness(gamma, 0.0, 1.0))


def test_limits_of_arrays_are_those_of_each_and_the_reverse_of_dampings():
    rng = np.random.default_rng(5)
    gamma, delta, delay = plants(rng, 40)
    beta = rng.uniform(-0.1, 1, 40)
    alpha, theta = limit_at(beta, gamma, delta, delay)
    for i in range(40):
        one = stiffest_at(beta[i], gamma[i], delta[i], delay[i])
        assert (alpha[i], theta[i]) == pytest.approx((one.alpha, one.theta), nan_ok=True)
        below = alpha[i] - 1e-9 * (1 + abs(alpha[i]))
        if is_stable(below, beta[i], gamma[i], delta[i], delay[i]):
            ends = dampings_at(below, gamma[i], delta[i], delay[i])
            assert any(low <= beta[i] <= high for low, high in ends)
    assert np.isnan(limit_at([np.nan, 3.0], 0.0, 0.0, 0)).all()
    with pytest.warns(RuntimeWarning, match=r"gamma: 9.8696044 .* it is NaN here"):
        among, _ = limit_at(0.4, [0.1, 9.8696044], 0.0, 1.0)
    assert np.isnan(among[1])
    assert among[0] == stiffest_at(0.4, 0.1, 0.0, 1.0).alpha


@pytest.mark.parametrize(
    ("gamma", "delay", "largest"),
    [(9.869604184849056, 75.0, 0.102668), (88.82643974056, 1.0, 44.41322), (9.8696, 1.0, 4.9348)],
)
def test_without_any_damping_the_limit_next_to_half_swings_is_there(gamma, delay, largest):
    """It was NaN, which says that no stiffness is stable; found by roots of the polynomial.

    One period late it is gamma/2: of z^3 + z^2 + u z, with u = 2 alpha/gamma, at most u = 1.
    """
    assert stiffest_at(0.0, gamma, 0.0, delay).alpha == pytest.approx(largest, rel=1e-5)


def test_where_the_limit_at_a_damping_is_missed_it_is_not_said_that_there_is_none():
    with pytest.raises(ValueError, match=r"^gamma: 9.869604469157307 .* is not traced"):
        stiffest_at(0.0, 9.869604469157307, 0.0, 0.8537173244680607)


@pytest.mark.parametrize(
    ("delta", "off", "stiffest"),
    [  # where the curve meets itself, by Newton's method at 50 digits in mpmath
        (0.0, 1e-4, 9.87023270494449594),
        (1e-10, 1e-6, 9.86961068427319783),
        (0.0, -1e-6, 9.86959811790258175),
        (1e-10, 1e-9, 9.86960440737254352),
        (0.0, -1e-9, 9.86960439480617246),
    ],
)
def test_a_corner_next_to_pi_is_told_by_its_other_angle(delta, off, stiffest):
    """An angle's last place is 1e-10 to 1e-6 of what it is away from pi, and so of the wall."""
    found = max_stable_stiffness((np.pi + off) ** 2, delta, 1)
    assert found.alpha == pytest.approx(stiffest, rel=1e-14)
    assert found.beta == pytest.approx(-stiffest / 2, rel=1e-5)


def test_at_whole_delays_both_sheets_have_the_same_stiffest_wall(monkeypatch):
    """z^-d has one value there; found by the kernel, and by a search in Python without tracing."""
    monkeypatch.setattr(extremes, "farthest", lambda *_: pytest.fail("traced"))
    rng = np.random.default_rng(32)
    gamma, delta = rng.uniform(0, 9.8, 60), rng.uniform(0, 3, 60) * rng.choice([0, 1], 60)
    for delay in (0, 1):
        exact = max_stable_stiffness(gamma, delta, delay)
        assert np.isfinite(exact.alpha).any()
        for one, other in zip(
            max_stable_stiffness(gamma, delta, delay, sheet="principal"), exact, strict=True
        ):
            assert one == pytest.approx(other, rel=1e-6, nan_ok=True)


def dampings(rng, count):
    """Dampings beside that of the stiffest wall, of devices of all kinds."""
    gamma = rng.choice([0.0, 1e-3, 9.0], count) * rng.random(count)
    delta = rng.choice([0.0, 0.02, 2.0], count) * rng.random(count)
    delay = rng.choice([0.0, 1.0, 2.0, 5.0, 0.5, 3.7], count)
    beta = max_stable_stiffness(gamma, delta, delay).beta * rng.uniform(-0.2, 3, count)
    beta = np.where(rng.random(count) < 0.1, 10.0 ** rng.uniform(-300, -3, count), beta)
    return beta, gamma, delta, delay


@pytest.mark.skipif(extremes.MODULE is None, reason="the install found no compiler")
def test_limits_without_tracing_are_those_of_the_whole_boundary(monkeypatch):
    """And balls find the wall below stable, that above not, nor walls up to the stiffest of all."""
    loops = dampings(np.random.default_rng(5), 150)
    quick = extremes.MODULE.limit_at(*loops)[0]
    monkeypatch.setattr(extremes, "MODULE", None)
    known = np.flatnonzero(np.isfinite(quick))
    assert known.size > 60
    for i in known:
        alpha, (beta, *loop) = float(quick[i]), [float(a[i]) for a in loops]
        try:
            traced = extremes.stiffest_at(beta, *loop).alpha
        except ValueError:  # of dampings that are hardly any, it does not find the boundary
            traced = alpha
        off = 1e-11 * (abs(alpha) + loop[0])
        assert abs(alpha - traced) < off
        top = max(max_stable_stiffness(*loop).alpha * 1.01 - alpha, 0.0)
        verdicts = [winding.stable(alpha + x, beta, *loop) for x in (-off, off, top / 3, top)]
        assert verdicts[0]
        assert not any(verdicts[1:])


@pytest.mark.skipif(extremes.MODULE is None, reason="the install found no compiler")
@pytest.mark.parametrize("beta", [0.0, -0.0, 5e-324, 1e300, np.inf, np.nan, 2.0, -1.0])
def test_dampings_that_no_wall_has_give_no_quick_limit(beta):
    """A free mass is stable for 0 < beta < 2 alone, by Jury's conditions."""
    assert np.isnan(extremes.MODULE.limit_at(beta, 0.0, 0.0, [0.0, 1e6, 0.5])[0][0])
    assert np.isnan(extremes.MODULE.limit_at(0.1, [np.nan, -1.0, 1e9], 0.0, 0.0)[0]).all()
