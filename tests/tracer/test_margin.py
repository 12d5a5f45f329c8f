"""Delay margins beside a scan over real delays with the eigenvalues of the delayed loop."""

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from oracle import moduli, radius

from symhaptic import delay_margin, is_stable


def stable_loops(rng, count):
    """Walls that are stable without delay; half of them on stiff springs."""
    gamma = np.where(rng.random(count) < 0.5, rng.uniform(0, 14, count), 1e-3 * rng.random(count))
    delta = rng.choice([0.0, 1e-3, 0.02, 2.0], count) * rng.random(count)
    alpha, beta = rng.normal(size=(2, count)) * 10 ** rng.uniform(-4, 0, count)
    alpha = np.where(alpha < -gamma, -alpha, alpha)
    keep = np.asarray(is_stable(alpha, beta, gamma, delta, 0))
    return tuple(v[keep] for v in (alpha, beta, gamma, delta))


def test_every_delay_of_a_scan_below_the_margin_is_stable():
    """500 loops at all multiples of 1/16 up to 4 periods, by eigenvalues."""
    case = stable_loops(np.random.default_rng(41), 1000)
    margin = delay_margin(*case)
    assert np.all(margin > 0)
    for delay in np.arange(0, 4, 1 / 16):
        largest = radius(*case, delay)
        wrong = (delay < margin - 1e-9) & (largest > 1 + 1e-9)
        assert not wrong.any(), ([float(v[wrong][0]) for v in case], delay)


def test_just_above_a_finite_margin_the_loop_is_lost():
    """By eigenvalues, a relative 1e-5 beside the margin, which is at most some periods here."""
    case = stable_loops(np.random.default_rng(42), 400)
    margin = delay_margin(*case)
    some = np.flatnonzero(margin < 6)[:120]
    assert some.size > 60
    for i in some:
        loop, step = [float(v[i]) for v in case], 1e-5 * (1 + margin[i])
        assert moduli(*loop, margin[i] + step).max() > 1 - 1e-12
        assert moduli(*loop, max(margin[i] - step, 0)).max() < 1 + 1e-12


def test_an_infinite_margin_bears_any_delay():
    """A wall weaker than the damped spring at every frequency: at ten random delays to 60."""
    rng = np.random.default_rng(43)
    case = stable_loops(rng, 1500)
    endless = np.isinf(delay_margin(*case))
    some = [v[endless][:100] for v in case]
    assert len(some[0]) == 100
    for delay in np.round(rng.uniform(0, 60, 10), 2):
        assert np.all(radius(*some, delay) < 1 + 1e-9)


def test_no_margin_for_a_loop_that_is_unstable_without_delay():
    assert delay_margin(5.0, 1.0, 0.0, 0.0) == 0
    assert delay_margin(0.0, 0.0, 0.3, 0.0) == 0  # nothing damps the swing
    assert delay_margin(-0.2, 0.1, 0.1, 0.5) == 0
    assert np.isinf(delay_margin(0.0, 0.0, 0.3, 0.1))
    assert np.isnan(delay_margin(np.nan, 0.1, 0.0, 0.0))


@pytest.mark.parametrize("sheet", ["exact", "principal"])
def test_free_mass_by_the_angle_alone(sheet):
    """alpha = 4 t^2 cos (d+1) theta, beta = 2 t sin((d+1/2) theta)/cos(theta/2), t = tan(theta/2).

    The boundary of a free mass with d whole periods of delay, whose first arc ends its region.
    """
    for d in (1, 2, 5):
        theta = 0.4 * np.pi / 2 / (d + 1)
        t = np.tan(theta / 2)
        alpha = 4 * t**2 * np.cos((d + 1) * theta)
        beta = 2 * t * np.sin((d + 0.5) * theta) / np.cos(theta / 2)
        assert delay_margin(alpha, beta, 0.0, 0.0, sheet=sheet) == pytest.approx(d, rel=1e-9)


def test_the_margin_of_a_slow_creep_is_that_of_the_linear_rule():
    """Weak spring against strong damping is an integrator: alpha/delta (d + 1/2) = pi/2."""
    for delta in (1e4, 1e7):
        margin = float(delay_margin(0.1, 0.1, 0.0, delta))
        assert margin == pytest.approx(np.pi / 2 * delta / 0.1, rel=2e-4)
    assert np.isinf(delay_margin(0.1, 0.1, 0.0, 1e60))  # beyond 1e15 periods


MANY_LEFT_OUT = [HealthCheck.filter_too_much]  # most walls have no margin, or an infinite one


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=MANY_LEFT_OUT)
@given(
    st.floats(1e-4, 1), st.floats(-0.5, 2), st.floats(0, 9), st.floats(0, 2),
    st.sampled_from(["exact", "principal"]),
)  # fmt: skip
def test_stable_just_below_and_not_just_above(alpha, beta, gamma, delta, sheet):
    margin = float(delay_margin(alpha, beta, gamma, delta, sheet=sheet))
    assume(0 < margin < 1e6)
    step = 1e-8 * (1 + margin)
    loop = alpha, beta, gamma, delta
    assert is_stable(*loop, max(margin - step, 0), sheet=sheet)
    assert not is_stable(*loop, margin + step, sheet=sheet)
