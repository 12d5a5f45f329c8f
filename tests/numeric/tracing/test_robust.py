"""Robustly stable walls against eigenvalues for dense springs, passivity and first-order theory."""

from functools import cache

import numpy as np
import pytest
import shapely
from oracle import radius

from symhaptic.numeric.tracing.robust import robust_region

LONG = pytest.mark.slow
WHOLE = (0, 1, pytest.param(2, marks=LONG))
region = cache(robust_region)


def springs(delta, count=600):
    """gamma from 0 to the Nyquist frequency, denser where the device is slow."""
    return np.linspace(0, np.sqrt(np.pi**2 + delta**2 / 4), count) ** 2


def passive(alpha, beta, delta, d):
    """Fejer's textbook form of the passivity margin, its minimum over a fine grid of angles."""
    theta = np.linspace(1e-4, np.pi, 4000)
    kernel = 0.5 + sum(np.cos(i * theta) for i in range(1, d + 1))
    margin = delta - np.multiply.outer(alpha, kernel * np.ones_like(theta))
    margin += np.multiply.outer(beta, np.cos((d + 1) * theta))
    return margin.min(axis=-1)


@pytest.mark.parametrize("d", WHOLE)
def test_passive_walls_lie_inside(d):
    rng = np.random.default_rng(d)
    alpha, beta = rng.uniform(0, 0.041, 800), rng.uniform(-0.02, 0.02, 800)
    kept = passive(alpha, beta, 0.02, d) > 0
    assert kept.sum() > 25
    found = region(0.02, d)
    shape = found.polygon.buffer(found.error)
    assert np.all(shapely.contains_xy(shape, alpha[kept], beta[kept]))


@pytest.mark.parametrize(
    "delay", [0, 1, pytest.param(2, marks=LONG), pytest.param(0.5, marks=LONG)]
)
def test_inside_is_stable_with_every_spring_and_outside_is_not(delay):
    """Walls a little inside and outside of the outline; eigenvalues for 600 springs each."""
    found = region(0.02, delay)
    away = 3 * found.error
    for sign in (-1, 1):
        ring = np.asarray(found.polygon.buffer(sign * away).exterior.segmentize(2e-3).coords)
        ring = ring[:: max(len(ring) // 40, 1)]
        gamma = springs(found.delta)
        shape = (len(ring), len(gamma))
        alpha, beta = (np.broadcast_to(ring[:, i, None], shape) for i in (0, 1))
        largest = radius(alpha, beta, np.broadcast_to(gamma, shape), 0.02, float(delay)).max(axis=1)
        assert np.all(largest < 1) if sign < 0 else np.all(largest > 1)


@pytest.mark.parametrize(("delta", "delay"), [(1.0, 0), (3.887, 1.5), (8.0, 1)])
def test_inside_is_stable_where_the_device_is_damped_much(delta, delay):
    """Springs with which it creeps, and those next to the Nyquist frequency, by eigenvalues."""
    found = region(delta, delay)
    ring = np.asarray(found.polygon.buffer(-found.error).exterior.segmentize(0.05).coords)
    ring = ring[:: max(len(ring) // 60, 1)]
    gamma = springs(delta)
    shape = (len(ring), len(gamma))
    alpha, beta = (np.broadcast_to(ring[:, i, None], shape) for i in (0, 1))
    largest = radius(alpha, beta, np.broadcast_to(gamma, shape), delta, float(delay))
    assert largest.max() < 1 + 1e-12


@pytest.mark.ci
@pytest.mark.parametrize("d", [1, 20])
def test_for_little_damping_it_is_passivity_with_more_damping_at_high_frequencies(d):
    """First order by hand: alpha D - beta cos (d+1) theta < delta (theta/2)^2/sin(theta/2)^2."""
    delta = 1e-4
    theta = np.linspace(1e-3, np.pi - 0.05, 800 * (1 + d // 4))  # at pi two poles of the plant meet
    kernel = 0.5 + sum(np.cos(i * theta) for i in range(1, d + 1))
    allowed = delta * (theta / 2) ** 2 / np.sin(theta / 2) ** 2
    shape = shapely.box(0, -3 * delta, 3 * delta, 3 * delta)
    turn = np.cos((d + 1) * theta)
    near = allowed < 10 * delta * np.hypot(kernel, turn)  # the border meets the box
    for k, c, room in zip(kernel[near], turn[near], allowed[near], strict=True):
        # the half plane k alpha - c beta < room, as a large square beside its border
        normal = np.array([k, -c]) / np.hypot(k, c)
        foot, along = normal * room / np.hypot(k, c), 30 * delta * np.array([-normal[1], normal[0]])
        back = -40 * delta * normal
        corners = [foot + along, foot - along, foot - along + back, foot + along + back]
        shape = shape.intersection(shapely.Polygon(corners))
    found = region(delta, d, "exact", 0.005)
    assert found.polygon.hausdorff_distance(shape) < 0.005 * delta


def test_without_delay_it_is_a_triangle_with_known_corners():
    """(0, -delta) from the free mass, (0, delta pi^2/8) to first order from both poles at -1."""
    left, low, _, high = region(0.02, 0).polygon.bounds
    assert left == pytest.approx(0, abs=1e-9)
    assert low == pytest.approx(-0.02, rel=1e-4)
    assert high == pytest.approx(0.02 * np.pi**2 / 8, rel=1e-3)


@pytest.mark.parametrize("delay", [0, 0.5, 3])
def test_without_damping_nothing_is_left(delay):
    found = robust_region(0.0, delay)
    assert found.area == 0
    assert found.outline == ()


@pytest.mark.parametrize("delay", [0, 0.25, 0.5, 0.9, 1, 2, 3])
def test_two_springs_leave_no_wall_without_damping(delay):
    """alpha > 0 is needed without a spring; with (d+1) sqrt(gamma) = pi/2 it is too much."""
    rng = np.random.default_rng(4)
    alpha = 10.0 ** rng.uniform(-6, 1, 3000)
    beta = rng.normal(size=3000) * 10.0 ** rng.uniform(-6, 1, 3000)
    gamma = (np.pi / (2 * (delay + 1))) ** 2
    assert np.all(radius(alpha, beta, gamma, 0.0, float(delay)) > 1 - 1e-12)
    assert np.any(radius(alpha, beta, 0.0, 0.0, float(delay)) < 1 - 1e-9)


def test_a_finer_tolerance_moves_the_outline_by_less_than_the_stated_error():
    rough, fine = region(0.02, 1, "exact", 0.05), region(0.02, 1)
    assert rough.polygon.hausdorff_distance(fine.polygon) < rough.error + fine.error
    assert len(rough.springs) < len(fine.springs)
    assert fine.springs[0] == 0
    assert fine.springs[-1] == pytest.approx(np.pi**2 + 1e-4)


@pytest.mark.ci
def test_for_little_damping_the_paper_s_reading_of_half_a_period_agrees():
    """At the device's own angle a late force is exactly e^(-j theta/2) times an undelayed one."""
    exact, read = (region(1e-3, 0.5, sheet, 0.02) for sheet in ("exact", "principal"))
    assert exact.polygon.hausdorff_distance(read.polygon) < 1e-3 * 0.02


@pytest.mark.slow
def test_the_longest_delay_ends_and_a_longer_one_is_refused_at_once():
    """To first order -cos (d+1) theta is largest first at pi/(d+1): so much damping of the wall."""
    top = np.pi / 101
    _, low, _, high = region(0.02, 100).polygon.bounds
    assert low == pytest.approx(-0.02, rel=1e-4)
    assert high == pytest.approx(0.02 * (top / 2) ** 2 / np.sin(top / 2) ** 2, rel=1e-3)
    with pytest.raises(ValueError, match=r"delay: 100\.5 is not allowed; give at most 100 periods"):
        robust_region(0.02, 100.5)


@pytest.mark.parametrize("delta", [1e-6, 200.0])
def test_without_delay_the_triangle_is_found_for_next_to_no_damping_and_for_very_much(delta):
    """Areas by hand: lines from (0, -1) and (0, c), c = pi^2/8, to (1 + c, 0) in parts of delta,
    and with e^-delta = n_0 = 0 and n_1 = (delta - 1)/delta^2 from (0, -1), (0, 1), (4, -1)/n_1."""
    area = {1e-6: delta**2 * (1 + np.pi**2 / 8) ** 2 / 2, 200.0: 4 * delta**4 / (delta - 1) ** 2}
    assert robust_region(delta, 0).area == pytest.approx(area[delta], rel=1e-3)


def test_a_whole_delay_has_one_reading():
    whole = [region(0.02, 1, sheet, 0.05) for sheet in ("exact", "principal")]
    assert whole[0].polygon.equals(whole[1].polygon)


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ((-0.1, 0), "delta"),
        ((0.1, -1), "delay"),
        ((np.nan, 0), "delta"),
        ((0.1, 0, "other"), "sheet"),
        ((0.1, 0, "exact", 0.0), "tolerance"),
    ],
)
def test_impossible_arguments_are_refused_by_name(arguments, name):
    with pytest.raises(ValueError, match=name):
        robust_region(*arguments)
