"""The sampled plant beside balls of the exact matrix exponential; errors may only shrink."""

import flint
import mpmath
import numpy as np
import pytest
from oracle import sampled
from scipy.linalg import expm

from symhaptic import discretize
from symhaptic.numeric.plant import device, impulse


def exact(gamma, delta):
    """n1, n0, a, e as balls, from the exponential of [[0, 1, 0], [-g, -d, 1], [0, 0, 0]]."""
    g, d = flint.arb(float(gamma)), flint.arb(float(delta))
    moved = flint.arb_mat([[0, 1, 0], [-g, -d, 1], [0, 0, 0]]).exp()
    n1, late = moved[0, 2], moved[1, 2]
    n0 = moved[0, 1] * late - moved[1, 1] * n1
    return n1, n0, moved[0, 0] + moved[1, 1], (-d).exp()


def worst(plants):
    """Largest errors of n1 and n0 over their sum, of a and of e absolutely."""
    errors = np.zeros(4)
    with flint.ctx.workprec(4000):
        for gamma, delta in plants:
            true = exact(gamma, delta)
            found = discretize(gamma, delta)
            off = [float(abs(flint.arb(float(v)) - t)) for v, t in zip(found, true, strict=True)]
            total = float(true[0]) + float(true[1])
            errors = np.maximum(errors, [off[0] / total, off[1] / total, off[2], off[3]])
    return errors


def near_critical(rng):
    delta = 10 ** rng.uniform(-8, 1.5)
    return (delta / 2) ** 2 * (1 + rng.choice([0, 1e-15, -1e-15, 1e-12, 1e-8])), delta


REGIONS = {
    "the paper's": (lambda r: (r.uniform(0, 1e-3), r.uniform(0, 0.02)), 4e-16, 1.5e-15),
    "up to Nyquist": (lambda r: (r.uniform(0, np.pi**2), r.uniform(0, 2)), 4e-16, 1.5e-15),
    "critical": (near_critical, 4e-16, 1.5e-15),
    "no spring": (lambda r: (0.0, 10 ** r.uniform(-12, 2.8)), 4e-16, 1.5e-15),
    "no damper": (lambda r: (10 ** r.uniform(-12, 1), 0.0), 1e-15, 2e-15),
    "stiff, beyond Nyquist": (lambda r: (r.uniform(10, 36), r.uniform(0, 5)), 3e-15, 2e-15),
    "strongly damped": (lambda r: (10 ** r.uniform(-3, 4), r.uniform(20, 700)), 2e-15, 1.5e-15),
}


@pytest.mark.parametrize("name", REGIONS)
def test_error(name):
    """Relative to n1 + n0 and absolute for a; measured half as large, on 50 plants."""
    draw, top, trace = REGIONS[name]
    rng = np.random.default_rng(61)
    n1, n0, a, e = worst([draw(rng) for _ in range(50)])
    assert max(n1, n0) <= top
    assert a <= trace
    assert e <= 1.2e-16


def test_beside_mpmath_and_scipy():
    """The oracles agree with each other: mpmath's and SciPy's exponential, Taylor on stacks."""
    gamma, delta = 2.7, 0.4
    motion = [[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]
    with mpmath.workdps(30):
        by_mpmath = np.array(mpmath.expm(mpmath.matrix(motion)).tolist(), dtype=float)
    assert expm(np.array(motion)) == pytest.approx(by_mpmath, rel=1e-13, abs=1e-15)
    free, held = sampled(gamma, delta)
    assert free == pytest.approx(by_mpmath[:2, :2], rel=1e-13)
    assert held == pytest.approx(by_mpmath[:2, 2], rel=1e-13)
    assert float(discretize(gamma, delta)[0]) == pytest.approx(by_mpmath[0, 2], rel=1e-14)


@pytest.mark.parametrize("delta", [1419.0, 4100.0, 1e5, 6e7])
def test_damping_beyond_the_range_of_exp(delta):
    """Creep that is over within a period: the first sample is that of the spring, 1/gamma."""
    n1, n0, a, e = discretize(delta**2 / 4 * 0.9, delta)
    total = 4 / delta**2 / 0.9
    assert float(n1) == pytest.approx(total, rel=1e-6)
    assert abs(n0) <= 1e-15 * n1
    assert (a, e) == (0.0, 0.0) or max(abs(a), e) < 1e-15
    assert np.all(np.isfinite(discretize([0.0, delta, 4e6], delta)))


@pytest.mark.parametrize("gamma", [1e12, 3.7e14, 1e15])
def test_a_device_that_swings_millions_of_turns_in_a_period(gamma):
    """Up to where a float tells the part of a turn that is left, it is told to the last place."""
    n1, n0, a, _ = discretize(gamma, 0.0)
    with mpmath.workdps(60):
        swing = mpmath.cos(mpmath.sqrt(gamma))
        assert abs(a - 2 * swing) <= 2**-51
        assert max(abs(n1 - (1 - swing) / gamma), abs(n0 - (1 - swing) / gamma)) <= 2**-52 / gamma


def test_a_subnormal_spring_is_none():
    assert discretize(5e-324, 0.0) == discretize(0.0, 0.0)


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_what_the_ends_of_a_late_force_differ_by(turns):
    """m2 - m0 next to half and to whole swings in a period, where an impulse moves nothing."""
    rng = np.random.default_rng(turns)
    for _ in range(40):
        gamma = (np.pi * turns) ** 2 * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-12, -4))
        delta = rng.choice([0.0, 10 ** rng.uniform(-14, -6)])
        part = 0.5 + rng.choice([-1, 1]) * 10 ** rng.uniform(-6, -0.4)
        with mpmath.workdps(50):
            half, part = mpmath.mpf(delta) / 2, mpmath.mpf(part)
            w = mpmath.sqrt(gamma - half**2)
            swings = [mpmath.exp(-half * t) * mpmath.sin(w * t) / w for t in (1 - part, part)]
            rests = [1 - mpmath.exp(-half * t) * mpmath.cos(w * t) for t in (1 - part, part)]
            early = (rests[0] - half * swings[0]) / gamma
            # of the time reversed: the whole period's e, less what the beginning has left
            left = mpmath.exp(-2 * half * part) - 1 + rests[1] + half * swings[1]
            late = mpmath.exp(-2 * half * (1 - part)) * left / gamma
            exact = float(early - late)
        found = device(*(np.asarray(float(v)) for v in (gamma, delta, part))).gap
        assert found == pytest.approx(exact, rel=1e-14, abs=1e-22)


@pytest.mark.parametrize("delta", [0.0, 0.3, 2.0, 9.0, 60.0])
def test_a_unit_impulse_moves_the_device_as_its_matrix_says(delta):
    """Swinging, critically damped at (1, 2), and creeping."""
    for gamma in (0.0, 1e-6, 1.0, 40.0):
        for time in (0.1, 0.5, 1.0):
            moved = expm(np.array([[0, 1], [-gamma, -delta]]) * time)[0, 1]
            found = impulse(np.array(gamma), np.array(delta), np.array(time))
            assert found == pytest.approx(moved, rel=1e-12)
