"""Exact values at hard points, by another road: roots in balls, mpmath, and fine grids."""

import math

import flint
import mpmath
import numpy as np
import pytest
from flint import acb_poly, arb

from symhaptic.balls import implicit, winding
from symhaptic.balls.closed import delayed, device
from symhaptic.balls.exact import EXACT
from symhaptic.bench import verdicts

HARD = [
    # nearly undamped, next to 9 half swings in a period
    (0.1888771289301374, -0.0944385653056962, 799.437956488238, 7.904912326835295e-12, 0.32),
    # a rounding beside a root at 1
    (-4.9523233699257964e-11, 0.2694959703289722, 4.9523233699307485e-11, 2.978e-09, 0.0),
    # the false stable of tiny walls that was found once
    (-1.000001e-160, 0.01, 1e-160, 0.02, 0.0),
    (0.08256, 1.5, 0.0, 0.0, 0.5),  # symmetric: m2 = m0
    (0.3, -0.3, 0.2, 0.1, 1.5),  # alpha + beta = 0: the wall's argument does not turn
    (2.25, 0.5, 2.25, 3.0, 2.0),  # critical damping, and |A| = |M W| at theta = 0
    (1e-3, 0.02, 1e-300, 1e-300, 3.0),
    (1e3, 10.0, 1e6, 1e-3, 2.25),
    (0.0, 0.0, 1.0, 0.5, 4.0),  # no wall
]


def by_roots(alpha, beta, gamma, delta, d, bits=2000):
    """All roots of the polynomial in balls, those outside counted."""
    whole = math.floor(d)
    with flint.ctx.workprec(bits):
        m2, m1, m0, a, e = delayed(gamma, delta, arb(d) - whole)
        row = [arb(1), -a, e, *[arb(0)] * (whole + 2)]
        for i, force in enumerate((arb(alpha) + beta, -arb(beta))):
            for j, moved in enumerate((m2, m1, m0)):
                row[len(row) - 4 + i + j] += force * moved
        while row[-1].contains(0) and row[-1].rad() < 1e-200:  # roots at 0
            row.pop()
        polynomial = acb_poly([c.mid() for c in row[::-1]])
        sizes = [abs(root) for root in polynomial.roots(tol=arb(2) ** (-bits // 3))]
        assert all(size > 1 or size < 1 for size in sizes)
        return sum(size > 1 for size in sizes)


@pytest.mark.parametrize("wall", HARD)
def test_unstable_roots_at_hard_points(wall):
    assert winding.unstable(*wall) == by_roots(*wall)


def test_unstable_roots_of_random_walls_and_long_delays():
    rng = np.random.default_rng(3)
    for _ in range(150):
        gamma = float(rng.choice([0.0, 10 ** rng.uniform(-12, 4), rng.uniform(0, 1)]))
        delta = float(rng.choice([0.0, 10 ** rng.uniform(-9, 2), rng.uniform(0, 1)]))
        d = float(rng.choice([rng.integers(0, 9), rng.uniform(0, 9)]))
        size = 10 ** rng.uniform(-4, 2)
        wall = (*(float(x) for x in rng.normal(0, size, 2)), gamma, delta, d)
        assert winding.unstable(*wall) == by_roots(*wall), wall
    for wall in ((0.02, 0.1, 0.3, 0.2, 180.0), (1.0, -2.0, 40.0, 1e-4, 120.37)):
        assert winding.unstable(*wall) == by_roots(*wall, bits=700)


def test_a_root_on_the_circle_is_not_counted():
    """p(1) = (gamma + alpha) M(1), and an undamped device swings on without a wall."""
    for wall in ((-0.25, 0.1, 0.25, 0.5, 1.5), (0.0, 0.0, 0.5, 0.0, 3.0)):
        assert winding.unstable(*wall) is None
        assert winding.stable(*wall) is False


def by_jury(alpha, beta, gamma, delta, delay, bits=512):
    """Jury's table in balls."""
    with flint.ctx.workprec(bits):
        n1, n0, a, e = device(gamma, delta)
        row = [arb(1), -a, e] + [arb(0)] * (delay + 1)
        row[-3] += n1 * (arb(alpha) + beta)
        row[-2] += n0 * (arb(alpha) + beta) - n1 * beta
        row[-1] += -n0 * beta
        while len(row) > 1:
            share = row[-1] / row[0]
            assert abs(share) < 1 or abs(share) >= 1, "the balls are too wide"
            if abs(share) >= 1:
                return False
            row = [x - share * y for x, y in zip(row[:-1], row[:0:-1], strict=True)]
        return True


@pytest.mark.parametrize("delay", [0, 2, 16])
def test_jurys_table_agrees_with_the_counted_roots(delay):
    """Of walls on both sides of the boundary, at relative distances down to 1e-14."""
    for distance in verdicts.DISTANCES:
        walls, truth = verdicts.near(delay, distance, 4)
        rows = [tuple(map(float, row)) for row in zip(*walls, strict=True)]
        assert [by_jury(*row, delay) for row in rows] == truth.tolist()


@pytest.mark.parametrize(
    "wall",
    [
        (0.01, 0.05, 0.0, 0.0),
        (0.11208291295233416, 0.24070449129046373, 0.09912269303220922, 0.5882535983956898),
        (7.583964992387642e-07, 7.598290210618373e-05, 0.0, 0.0),
        (0.27460290060846054, -1.8458123145229184, 0.0, 2.938750836481219),
    ],
)
def test_a_delay_margin_is_the_first_delay_that_is_not_stable(wall):
    """Of 300 delays before it each is stable by all roots in balls, and a little more is not."""
    most = winding.largest_delay(*wall, most=1e4)
    assert most.rad() < 1e-13 * most.mid()
    margin = float(most.mid())
    tried = np.append(np.linspace(0, margin, 300)[:-1], margin * (1 - 1e-9))
    assert all(by_roots(*wall, float(d), bits=400) == 0 for d in tried if d < 20)
    assert winding.stable(*wall, margin * (1 - 1e-12))
    assert winding.stable(*wall, margin * (1 + 1e-12)) is False


def test_delay_margins_that_are_0_or_infinite():
    """Softer than the device at every angle, |M W| < |A|: alpha < gamma, and well damped."""
    assert winding.largest_delay(0.01, 0.01, 0.5, 1.0, most=1e6) == arb("inf")
    assert winding.largest_delay(1.0, 0.0, 0.0, 0.0, most=1e6) == 0


FLAT = [
    (1.0, 1.6775903515460318, 5.37758117896037),  # the need hardly bends at 0, where it is largest
    (0.0005847863209369106, 0.058535222074622924, 0.2221359375853755),  # next to 2/9
    (0.0, -1.9187922583276484, 0.999999999),
    (1.3359001321000095, 0.933828551283679, 0.17566314077674589),
    (2.0, -0.7, 3.0),
    (1e-6, 5.0, 40.5),
    (1e-9, 3.0, 1e12),
]


@pytest.mark.parametrize("wall", FLAT)
def test_no_angle_needs_more_than_the_largest_need(wall):
    """(5) of the paper, at a fraction with the term of the worst motion, at 400 angles."""
    alpha, beta, d = wall
    with flint.ctx.workprec(300):
        need, _ = implicit.largest_required_damping(alpha, beta, d)
    assert need.rad() < 1e-20
    with mpmath.workdps(60):
        whole, part = mpmath.floor(d), mpmath.mpf(d) - mpmath.floor(d)

        def straight(t, n):
            kernel = mpmath.sin((n + 0.5) * t) / mpmath.sin(t / 2) / 2
            return alpha * kernel - beta * mpmath.cos((n + 1) * t)

        def required(t):
            n = (1 - part) * straight(t, whole) + part * straight(t, whole + 1)
            if not part:
                return n
            extra = alpha**2 + 4 * mpmath.mpf(beta) * (alpha + beta) * mpmath.sin(t / 2) ** 2
            return (n + mpmath.sqrt(n * n + part * (1 - part) * extra)) / 2

        turn = mpmath.pi / (d + 1)
        last = min(4 * turn, mpmath.pi)
        most = max(required(last * (k + mpmath.mpf(1) / 2) / 400) for k in range(400))
        upper, lower = (mpmath.mpf(v.str(40, radius=False)) for v in (need.upper(), need.lower()))
        assert most <= upper * (1 + mpmath.mpf(10) ** -18)
        assert most >= lower * (1 - mpmath.mpf(10) ** -3)


@pytest.mark.parametrize(
    ("plant", "alpha"),
    [
        ((0.0, 0.0, 0.0), 4 * (3 - 2 * math.sqrt(2))),  # a free mass, by Jury's conditions by hand
        ((25.7827, 0.095, 3.0), None),
        ((144.865, 0.000153, 3.1355), None),
        ((2.2955, 0.0008, 2.2), None),
        ((40.0, 0.47, 0.0), None),
    ],
)
def test_no_wall_is_stable_beyond_the_stiffest_that_is_found(plant, alpha):
    """Of 60 000 walls on a grid, whose roots NumPy has, none is."""
    top, beta = winding.stiff_wall(*plant)
    assert by_roots(top, beta, *plant) == 0
    if alpha is not None:
        assert top == pytest.approx(alpha, rel=1e-6)
    whole = math.floor(plant[2])
    with flint.ctx.workprec(200):
        m2, m1, m0, a, e = (float(v) for v in delayed(*plant[:2], plant[2] - whole))
    stiff = np.geomspace(1.0005, 30, 150) * (top + plant[0]) - plant[0]
    span = 6 * (abs(top) + plant[0] + 1)
    rows = np.zeros((400, whole + 5))
    for al in stiff:
        be = np.linspace(-span, span, 400)
        rows[:] = 0
        rows[:, :3] = 1, -a, e
        for i, force in enumerate((al + be, -be)):
            for j, moved in enumerate((m2, m1, m0)):
                rows[:, whole + 1 + i + j] += force * moved
        companion = np.zeros((400, whole + 4, whole + 4))
        companion[:, 0] = -rows[:, 1:]
        companion[:, np.arange(1, whole + 4), np.arange(whole + 3)] = 1
        assert (abs(np.linalg.eigvals(companion)).max(axis=1) >= 1 - 1e-9).all(), al


@pytest.mark.parametrize(
    ("gamma", "delta"),
    [(1e15, 0.1), (1e10, 1e-10), (9.869604401089358, 1e-12), (2.25, 3.0 - 1e-12)],
)
def test_the_sampled_device_of_stiff_and_nearly_critical_springs(gamma, delta):
    """n1 = (1 - exp(-delta/2) (cos w + delta/(2 w) sin w))/gamma by mpmath, with 80 digits."""
    with flint.ctx.workprec(3000):
        n1 = EXACT["discretize"](gamma, delta)[0]
    with mpmath.workdps(80):
        g, h = mpmath.mpf(gamma), mpmath.mpf(delta) / 2
        w = mpmath.sqrt(g - h * h)
        wanted = (1 - mpmath.exp(-h) * (mpmath.cos(w) + h / w * mpmath.sin(w))) / g
        assert abs(mpmath.mpf(n1.mid().str(60, radius=False)) / mpmath.re(wanted) - 1) < 1e-45
