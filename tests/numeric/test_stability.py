"""Root counts where they are hard: weak walls, double roots, the principal sheet, the boundary."""

from fractions import Fraction
from inspect import signature

import numpy as np
import pytest
from oracle import certified, principal

from symhaptic import delay_margin, is_stable, lambdify, stability_boundary, unstable_roots
from symhaptic.numeric.stability import Angle, turns


@pytest.mark.parametrize("delta", [0.0, 1e-10, 1e-6, 1e-3])
@pytest.mark.parametrize("part", [0.0, 0.375])
def test_walls_that_hardly_touch_a_spring_without_damping(delta, part):
    """|A| at the spring's own frequency is as small as the wall, down to 1e-12."""
    rng = np.random.default_rng(91)
    for size in (1e-2, 1e-6, 1e-8, 1e-10, 1e-12):
        for _ in range(12):
            alpha, beta = (float(v) for v in rng.normal(size=2) * size)
            case = alpha, beta, rng.uniform(0.01, 9.8), delta, rng.integers(0, 9) + part
            assert int(unstable_roots(*case)) == certified(*case), case


WEAK = [  # alpha, beta, gamma, delta
    (1.1846412522561189e-4, 2.6941183355201387e-4, 2.763245321481284, 1.6408720287e-4),
    (-4.3255876351941456e-4, -2.006717262228217e-4, 4.294311055789182, 2.92149798e-4),
]


@pytest.mark.parametrize(("which", "delay"), [(0, 0.25198146964470475), (1, 1.772162413996871)])
def test_delays_next_to_the_loss_of_a_weak_wall(which, delay):
    """Two crossings beside the spring's own frequency, 4e-4 apart."""
    loop = WEAK[which]
    for step in (1e-6, 1e-8, 1e-9):
        for late in (delay - step, delay + step):
            assert int(unstable_roots(*loop, late)) == certified(*loop, late)


@pytest.mark.parametrize(("least", "untold"), [(-13, 9), (-12, 1)])
@pytest.mark.parametrize("end", [0.0, np.pi], ids=["root at 1", "root at -1"])
def test_beside_the_boundary_close_to_its_ends(end, least, untold):
    """300 walls a relative 1e-13 to 1e-11 beside points whose pair nearly meets at 1 or at -1.

    At right angles to the boundary: along it a wall may come back to it.  -1, which is no answer,
    is given to few, most of them nearer than 1e-12.
    """
    rng = np.random.default_rng(92)
    unknown = 0
    for _ in range(300):
        size = 10 ** rng.uniform(-4, -2)
        gamma, delta, delay = rng.uniform(0, 9.5), rng.uniform(0.05, 2), int(rng.integers(0, 9))
        angles = np.abs(end - size * np.array([0.999, 1, 1.001]))
        walls = np.array(stability_boundary(angles, gamma, delta, delay))
        along = (walls[:, 2] - walls[:, 0]) / walls[:, 1]
        aside = np.array([-along[1], along[0]]) / np.hypot(*along)
        away = rng.choice([-1, 1]) * 10 ** rng.uniform(least, least + 1) * aside
        alpha, beta = (float(v) for v in walls[:, 1] * (1 + away))
        case = alpha, beta, gamma, delta, delay
        found = int(unstable_roots(*case))
        unknown += found == -1
        assert found in (-1, certified(*case)), (size, case)
    assert unknown <= untold


def test_principal_sheet_beside_the_roots_in_the_cut_plane():
    """Roots of the polynomial in z^(1/q) with |arg z| < pi, for delays in eighths and sevenths."""
    rng = np.random.default_rng(93)
    compared = 0
    for _ in range(150):
        delay = Fraction(int(rng.integers(0, 40)), int(rng.choice([7, 8])))
        if delay.denominator == 1:
            continue
        gamma = rng.choice([0.0, rng.uniform(0, np.pi**2)])
        delta = rng.choice([0.0, rng.uniform(0, 2)])
        alpha, beta = (float(v) for v in rng.normal(size=2) * 10 ** rng.uniform(-4, 1))
        sizes = principal(alpha, beta, gamma, delta, delay)
        if np.min(np.abs(sizes - 1), initial=1) < 1e-7:
            continue
        compared += 1
        found = unstable_roots(alpha, beta, gamma, delta, float(delay), sheet="principal")
        assert int(found) == np.sum(sizes > 1), (alpha, beta, gamma, delta, delay)
    assert compared > 75


@pytest.mark.parametrize("delay", [1.0, 1.5])
@pytest.mark.parametrize("sheet", ["exact", "principal"])
def test_nan_has_no_count_and_a_root_on_the_circle_is_not_counted(delay, sheet):
    """A damped mass without a wall has a root at 1, not outside: the count is 0 or unknown."""
    loop = [0.5, 0.1, 0.3, 0.2, delay]
    for at in range(5):
        wrong = [np.nan if i == at else v for i, v in enumerate(loop)]
        assert unstable_roots(*wrong, sheet=sheet) == -1
        assert not is_stable(*wrong, sheet=sheet)
    spring = 0.5, 0.0, 0.0, 0.2
    outside = np.sum(principal(*spring, Fraction(delay)) > 1)
    assert unstable_roots(*spring, delay, sheet="principal") == outside > 0
    assert unstable_roots(0.0, 0.0, 0.0, 0.2, delay, sheet=sheet) <= 0


@pytest.mark.parametrize(
    "wall", [(-0.2, -3.4, 9.5, 2.1), (0.3, -1.8, 8.8, 0.35), (-0.03, -0.18, 9.65, 0.05)]
)
def test_a_wall_that_leads_at_minus_one_keeps_to_the_next_whole_delay(wall):
    """On the principal sheet a pair comes round -1 there: none is outside before, two behind."""
    for delay, outside in ((Fraction(1, 8), 0), (Fraction(63, 64), 0), (Fraction(65, 64), 2)):
        assert np.sum(principal(*wall, delay) > 1) == outside
    assert delay_margin(*wall, sheet="principal") == 1


def test_the_principal_sheet_of_a_whole_delay_is_the_delay_itself():
    rng = np.random.default_rng(94)
    count = 20_000
    loops = (*rng.normal(size=(2, count)) * 5, rng.uniform(0, 10, count), rng.uniform(0, 2, count))
    delay = rng.integers(0, 6, count)
    exact = unstable_roots(*loops, delay)
    assert np.array_equal(unstable_roots(*loops, delay, sheet="principal"), exact)
    odd = exact % 2 == 1  # a real root left of -1 or right of 1, which a sheet might lose
    assert odd.sum() > 1000
    assert not is_stable(*loops, delay, sheet="principal")[odd].any()


@pytest.mark.parametrize("delay", [0, 3, 0.5])
def test_points_of_the_boundary_themselves_are_not_called_stable(delay):
    """A root is on the circle but for the rounding of the wall, which is not told."""
    theta = np.linspace(0.05, 3.1, 200)
    alpha, beta = stability_boundary(theta, 1.7, 0.3, delay)
    here = unstable_roots(alpha, beta, 1.7, 0.3, delay)
    assert not is_stable(alpha, beta, 1.7, 0.3, delay).any()
    sides = [
        unstable_roots(alpha + a, beta + b, 1.7, 0.3, delay)
        for a in (-1e-6, 0, 1e-6)
        for b in (-1e-6, 0, 1e-6)
    ]
    assert np.all(here == -1)
    assert np.max(sides) >= 2


FAINT = [  # double precision, then single: the square of each is 0
    (float, 1e-170),
    (float, 1e-300),
    (np.float32, 1e-24),
    (np.float32, 1e-36),
]


@pytest.mark.parametrize(("kind", "size"), FAINT)
@pytest.mark.parametrize("delay", [4, 4.5])
@pytest.mark.parametrize("sheet", ["exact", "principal"])
def test_a_wall_whose_squares_vanish_is_not_called_stable(kind, size, delay, sheet):
    """A slow loop needs alpha (d + 1/2) < delta + beta; these have ten times as much, or pull.

    Before: stable, with no root outside.
    """
    for alpha, beta, gamma, delta in [(10, 0, 0, 1), (10, 0, 0.04, 1), (0, -10, 0.04, 0)]:
        wall = np.array([alpha, beta, delta], dtype=kind) * kind(size)
        loop = wall[:1], wall[1:2], kind(gamma), wall[2:], kind(delay)
        assert not is_stable(*loop, sheet=sheet).any()
        assert unstable_roots(*loop, sheet=sheet).tolist() in ([-1], [2])  # not known, or right


def test_such_a_wall_has_no_margin():
    """Before: infinite without a spring, and with one the search did not end."""
    assert delay_margin(1e-170, 0.0, [0.0, 0.04], 4.5e-170).tolist() == [0.0, 0.0]


@pytest.mark.parametrize(
    "scene",
    ["", "no-stiffness", *(pytest.param(scene, marks=pytest.mark.ci) for scene in (
        "no-delay", "no-damping", "no-virtual-damping", "no-stiffness,no-delay"))],
)  # fmt: skip
def test_no_scene_calls_it_stable(scene):
    stable = lambdify("is_stable", scene=scene or None)
    wall = {"alpha": 1e-169, "beta": -1e-168, "gamma": 0.04, "delta": 1e-170, "d": 4.0}
    assert not stable(*(wall[name] for name in signature(stable).parameters))


def test_a_device_alone_is_stable_however_little_it_is_damped():
    assert is_stable(0.0, 0.0, 0.04, 1e-300, [0, 4, 4.5]).all()


@pytest.mark.parametrize("sheet", ["exact", "principal"])
@pytest.mark.parametrize("size", [1e-28, 1e-32, 1e-60, 1e-100, 1e-119])
def test_a_faint_wall_behind_a_fraction_is_stable_where_it_is(size, sheet):
    """A free mass needs alpha (d + 1/2) < delta + beta then, and alpha > 0.

    From 1e-30 on more than every other stable one was called unstable: its root of the size of the
    wall was approached by half a step each, and not reached.
    """
    rng = np.random.default_rng(0)
    for delay in (0.5, 1.5, 0.3, 2.7):
        alpha, beta, delta = size * rng.uniform([[0.1], [-1], [0]], [[2], [1], [1]], (3, 200))
        spare = (beta + delta - alpha * (delay + 0.5)) / size
        clear = abs(spare) > 0.01
        found = unstable_roots(alpha, beta, 0.0, delta, delay, sheet=sheet)
        assert np.array_equal((found == 0)[clear], (spare > 0)[clear])


NEXT_TO_HALF_SWINGS = [  # alpha, beta, gamma, delta, delay: the root at -1 is what rounding leaves
    (
        0.007569336682797176,
        4.5760184197443285,
        9.86960440108936,
        4.24703083e-09,
        0.4999999999988011,
    ),
    (-0.015280417357600337, -9.492991578310109, 246.74011002723395, 2.0592359e-10, 1.5000000091641),
    (3.599901126398317, 0.002540243070512862, 9.86960440108936, 1.9140031650037573e-10, 0.5),
    (0.1, 0.3, 88.82643960980424, 3.1502929274844845e-10, 0.5),
]


@pytest.mark.parametrize("loop", NEXT_TO_HALF_SWINGS)
def test_half_a_period_late_the_count_is_that_of_a_gamma_next_to_it(loop):
    alpha, beta, gamma, delta, delay = loop
    near = np.nextafter(gamma, 0), gamma, np.nextafter(gamma, np.inf)
    exact = [certified(alpha, beta, float(g), delta, delay) for g in near]
    assert int(unstable_roots(*loop)) in exact


def test_of_two_and_a_half_turns_the_least_rest_decides():
    """A hair less is nearest to two turns, a hair more to three; their sum with 2.5 is 2.5."""
    bare = Angle(np.full(2, 5.0), np.array([-1e-30, 1e-30]))
    assert turns(bare, Angle(np.zeros(2), np.zeros(2)), np.zeros(2)).tolist() == [2, 3]
