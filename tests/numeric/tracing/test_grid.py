"""The paper's grid beside the explicit boundary, and its spectral radius beside the loop's own."""

from fractions import Fraction

import numpy as np
import pytest
from oracle import radius

from symhaptic import grid_boundary, stable_region
from symhaptic.numeric.tracing.grid import spectral_radius


@pytest.mark.parametrize("delay", [0, 1, 3, 8])
def test_whole_delays_by_the_states_of_the_loop(delay):
    rng = np.random.default_rng(51)
    alpha, beta = rng.normal(size=(2, 50))
    found = spectral_radius(alpha, beta, 0.7, 0.2, delay)
    assert found == pytest.approx(radius(alpha, beta, 0.7, 0.2, delay), rel=1e-7)


@pytest.mark.parametrize("delay", [Fraction(1, 2), Fraction(5, 3), 0.25])
def test_a_rational_delay_is_the_substitution_to_the_letter(delay):
    """z = w^q in the free mass's z^(d+1) (z-1)^2 + (z+1)/2 ((alpha+beta) z - beta)."""
    late, (alpha, beta) = Fraction(delay), (0.05, 0.3)
    q, r = late.denominator, late.numerator
    p = np.zeros(r + 3 * q + 1)
    for power, value in (
        (r + 3 * q, 1.0), (r + 2 * q, -2.0), (r + q, 1.0),
        (2 * q, (alpha + beta) / 2), (q, alpha / 2), (0, -beta / 2),
    ):  # fmt: skip
        p[len(p) - 1 - power] += value
    expected = np.abs(np.roots(p)).max()
    assert spectral_radius(alpha, beta, 0.0, 0.0, delay) == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize(("delay", "threshold"), [(0, 1e-8), (1, 1e-8), (2, 1e-6)])
def test_points_lie_on_the_outline_of_the_region(delay, threshold):
    import shapely

    region = stable_region(0.001, 0.02, delay, tolerance=1e-9)
    low, high = np.array(region.polygon.bounds).reshape(2, 2)
    size = high - low
    sides = [np.linspace(a - 0.1 * s, b + 0.1 * s, 23)
             for a, b, s in zip(low, high, size, strict=True)]  # fmt: skip
    points = grid_boundary(0.001, 0.02, delay, *sides, threshold)
    for column, lines in zip(points.T, sides, strict=True):
        assert np.isin(column, lines).sum() > 5  # found along the other lines of the grid
    off = shapely.distance(shapely.points(points), region.polygon.boundary)
    # eigenvalues decide a root at 1, of multiplicity 2 near the corner, to the root of 1e-16
    assert off.max() <= threshold + region.error + 1e-7 * size.max()


def test_a_threshold_below_rounding_ends():
    points = grid_boundary(0.0, 0.0, 0, [0.1, 0.5, 1.0], [0.5, 0.8], 1e-300)
    assert len(points)


@pytest.mark.parametrize(
    ("delay", "says"),
    [
        (0.1, r"delay: 0\.1 is not allowed; give rational numbers r/q >= 0 with r \+ 3 q <= 2000"),
        (1998, "delay: 1998 is not allowed"),  # with 3 more the degree is 2001
        (np.nan, "delay: nan is not allowed"),
        (Fraction(-1, 2), r"delay: -0\.5 is not allowed"),
        ("1/2", "delay: '1/2' is not allowed; give real numbers"),
        ([1, 2], "delay: .* is not allowed; give one number"),
    ],
)
def test_delays_without_a_polynomial_are_refused(delay, says):
    with pytest.raises(ValueError, match=says):
        spectral_radius(0.1, 0.1, 0.0, 0.0, delay)


def test_nan_spoils_its_own_wall_only():
    found = spectral_radius([0.1, np.nan], 0.1, 0.0, 0.0, 0)
    assert np.isfinite(found[0])
    assert np.isnan(found[1])
    with pytest.raises(ValueError, match="alphas: nan is not allowed; give finite numbers"):
        grid_boundary(0.0, 0.0, 0, [0.1, np.nan], [0.1])
