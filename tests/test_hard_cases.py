"""Where formulas for the loop break: no spring, no damper, critical damping, huge delays, edges."""

import itertools
import warnings

import numpy as np
import pytest
from oracle import certified, moduli

import symhaptic
from symhaptic import (
    delay_margin,
    discretize,
    is_stable,
    max_stable_stiffness,
    stability_boundary,
    stable_region,
    unstable_roots,
)

CRITICAL = 0.25  # gamma = delta^2/4 for delta = 1, exact in float64
PLANTS = [
    (0.0, 0.0),
    (0.0, 1e-300),
    (1e-300, 0.0),
    (1e-16, 1e-16),
    (1e-12, 1e-8),
    (CRITICAL, 1.0),
    (np.nextafter(CRITICAL, 0), 1.0),
    (np.nextafter(CRITICAL, 1), 1.0),
    (CRITICAL * (1 + 1e-15), 1.0),
    (CRITICAL * (1 - 1e-15), 1.0),
    (0.0, 20.0),
    (100.0, 20.0),
    (3.0, 20.0),
    (0.001, 700.0),
    (np.pi**2, 0.0),
    (np.pi**2, 0.02),
    (np.pi**2 + 1e-4, 0.02),
    (20.0, 0.5),
    (50.0, 0.0),
]
UNTOLD = [(np.pi**2, 0.0)]
"""Nothing makes it stable, and a last place of gamma moves a root through -1."""
DELAYS = [0, 1, 4, 0.5, 0.999999, 1.000001]
WALLS = [(0.3, 0.2), (-0.1, 0.4), (0.05, -0.05), (1.5, 0.9), (1e-9, 1e-9), (0.4, -0.4)]


@pytest.fixture(autouse=True)
def _no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


@pytest.mark.parametrize("plant", PLANTS, ids=str)
def test_counts_are_the_certified_ones(plant):
    for wall, delay in itertools.product(WALLS, DELAYS):
        if np.min(np.abs(moduli(*wall, *plant, delay) - 1)) < 1e-13:
            continue  # a root on the circle but for the plant's own rounding
        found = int(unstable_roots(*wall, *plant, delay))
        assert found == certified(*wall, *plant, delay) or (found == -1 and plant in UNTOLD), wall


@pytest.mark.parametrize("plant", PLANTS, ids=str)
def test_everything_is_finite_or_says_so(plant):
    assert np.all(np.isfinite(discretize(*plant)))
    for delay in DELAYS:
        alpha, beta = stability_boundary(np.linspace(0.01, 3.13, 50), *plant, delay)
        assert np.all(np.isfinite(alpha))
        assert np.all(np.isfinite(beta))
    assert delay_margin(0.3, 0.2, *plant) >= 0
    assert not np.isinf(max_stable_stiffness(*plant, 1).alpha)


@pytest.mark.parametrize("gamma", [0.0, 0.3, 5.0])
def test_alpha_at_minus_gamma_is_not_stable(gamma):
    for delay, beta in itertools.product(DELAYS, (-0.1, 0.0, 0.5)):
        assert not is_stable(-gamma, beta, gamma, 0.5, delay)


def test_no_wall():
    """The device alone: it comes to rest if something damps it and a spring holds it."""
    assert is_stable(0.0, 0.0, 0.3, 0.1, 2)
    assert not is_stable(0.0, 0.0, 0.3, 0.0, 2)
    assert not is_stable(0.0, 0.0, 0.0, 0.3, 2)
    assert not is_stable(0.0, 0.0, 0.0, 0.0, 0)


@pytest.mark.parametrize("delay", [1e3, 1e6, 1e6 + 0.5])
def test_huge_delays(delay):
    """Virtual damping over delay: far inside the linear limit stable, far outside not."""
    delta, beta = 0.02, 0.0
    limit = (beta + delta) / (delay + 0.5)
    assert is_stable(0.5 * limit, beta, 0.0, delta, delay)
    assert not is_stable(3 * limit, beta, 0.0, delta, delay)
    largest = float(max_stable_stiffness(0.0, 0.0, delay).alpha)
    # phi^2 cos phi with phi tan phi = 2, the limit of (d + 1)^2 alpha (mpmath.findroot)
    assert largest * (delay + 1) ** 2 == pytest.approx(0.5497740256054985, rel=3 / delay)


@pytest.mark.parametrize("near", [0.999999, 1.000001])
def test_delays_next_to_a_whole_one_change_little(near):
    """One part in a million of the delay moves the stiffness by about as much."""
    whole = float(max_stable_stiffness(0.001, 0.02, 1).alpha)
    assert float(max_stable_stiffness(0.001, 0.02, near).alpha) == pytest.approx(whole, rel=1e-5)


NUMERIC = {
    "is_stable": (0.1, 0.1, 0.001, 0.02, 1.0),
    "unstable_roots": (0.1, 0.1, 0.001, 0.02, 1.0),
    "stability_boundary": (1.0, 0.001, 0.02, 1.0),
    "max_stable_stiffness": (0.001, 0.02, 1.0),
    "delay_margin": (0.1, 0.1, 0.001, 0.02, 1.0),
    "max_delay": (0.1, 0.1, 0.001, 0.02),
    "discretize": (0.001, 0.02),
    "is_passive": (0.01, 0.0, 0.02, 1.0),
    "passivity_margin": (0.01, 0.0, 0.02, 1.0),
    "passivity_boundary": (0.5, 0.02, 1.0),
    "max_passive_stiffness": (0.02, 1.0),
    "linear_limit": (0.0, 0.02, 1.0),
}
POSITIONS = [(name, i) for name, given in NUMERIC.items() for i in range(len(given))]


@pytest.mark.parametrize(("name", "position"), POSITIONS)
def test_nan_spoils_its_own_element_only(name, position):
    function, given = getattr(symhaptic, name), list(NUMERIC[name])
    clean = np.atleast_2d(np.array(function(*given), dtype=float))
    given[position] = np.array([given[position], np.nan, given[position]])
    found = np.array(function(*given), dtype=float).reshape(-1, 3)
    assert np.array_equal(found[:, 0], clean.ravel())
    assert np.array_equal(found[:, 2], clean.ravel())
    spoilt = {"is_stable": 0.0, "is_passive": 0.0, "unstable_roots": -1.0}
    if name in spoilt:
        assert found[0, 1] == spoilt[name]
    elif name == "linear_limit" or position < len(given):
        assert np.isnan(found[:, 1]).all()


@pytest.mark.parametrize(("name", "position"), POSITIONS)
@pytest.mark.parametrize("bad", [np.inf, -np.inf])
def test_an_infinite_argument_is_named(name, position, bad):
    given = list(NUMERIC[name])
    given[position] = [given[position], bad]
    with pytest.raises(ValueError, match=r"^\w+: -?inf is not allowed; give .+$"):
        getattr(symhaptic, name)(*given)


def test_a_negative_plant_or_delay_is_named():
    with pytest.raises(ValueError, match=r"gamma: -1\.0 .*; give finite numbers gamma >= 0"):
        is_stable(0.1, 0.1, [0.1, -1.0], 0.0, 0)
    with pytest.raises(ValueError, match=r"delay: -0\.5 is not allowed"):
        max_stable_stiffness(0.0, 0.0, -0.5)
    with pytest.raises(ValueError, match=r"delta: -1 is not|delta: -1\.0 is not"):
        stable_region(0.0, -1, 0)
    with pytest.raises(ValueError, match="theta"):
        stability_boundary(0.0, 0.0, 0.0, 0)
    with pytest.raises(ValueError, match="sheet"):
        is_stable(0.1, 0.1, 0.0, 0.0, 0, sheet="third")


@pytest.mark.parametrize("name", NUMERIC)
def test_any_argument_may_be_an_array(name):
    """Every choice of arrays and scalars gives what the scalars give."""
    function, given = getattr(symhaptic, name), NUMERIC[name]
    clean = np.atleast_1d(np.array(function(*given), dtype=float))
    for choice in itertools.product((False, True), repeat=len(given)):
        mixed = [np.full(3, v) if many else v for v, many in zip(given, choice, strict=True)]
        found = np.array(function(*mixed), dtype=float).reshape(len(clean), -1)
        assert np.array_equal(found, np.broadcast_to(clean[:, None], found.shape)), choice


@pytest.mark.parametrize("swings", [1, 2, 3])
@pytest.mark.parametrize("delay", [0, 1, 2.5])
def test_an_undamped_whole_half_swing_is_never_stable(swings, delay):
    """Chapter s4d_left_bound: the root at 1 or -1 is there for every wall."""
    gamma = (swings * np.pi) ** 2
    assert not is_stable([0.1, 1.0, -0.1], 0.1, gamma, 0.0, delay).any()
    assert np.isnan(max_stable_stiffness(gamma, 0.0, delay).alpha)
    assert stable_region(gamma, 0.0, delay).area == 0


def test_shapes_that_do_not_fit_give_one_line():
    with pytest.raises(ValueError, match=r"shapes of the arguments: .+ that broadcast$"):
        is_stable([1, 2], [1, 2, 3], 0.0, 0.0, 0)


def test_shapes():
    assert is_stable(np.zeros((0,)), 0.1, 0.0, 0.0, 0).shape == (0,)
    assert is_stable(0.1, 0.1, 0.0, 0.0, 0).shape == ()
    many = np.full((3, 5000), 0.1)[:, ::2]
    many.flags.writeable = False
    found = is_stable(many, np.ones((3, 1)), np.float32(0.5), [[0.5]], np.arange(2500) % 3)
    assert found.shape == (3, 2500)
    assert found[1, 4] == is_stable(0.1, 1.0, 0.5, 0.5, 1)
