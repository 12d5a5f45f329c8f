"""Stable regions beside eigenvalues, certified corners and a boundary sampled anew."""

import pickle

import matplotlib
import mpmath
import numpy as np
import pytest
import shapely
from matplotlib.figure import Figure
from oracle import certified, coefficients, moduli, numbers, radius

from symhaptic import Scene, robust_region, stability_boundary, stable_region
from symhaptic.numeric.tracing.arcs import Loop
from symhaptic.numeric.tracing.sides import chords

matplotlib.use("Agg")

NYQUIST = np.pi**2
CASES = [
    (share * (NYQUIST + delta**2 / 4), delta, delay)
    for delta in (0.0, 0.02, 2.0)
    for delay in (0, 0.5, 1, 2, 8)
    for share in (0.0, 1e-4, 0.3, 0.7, 0.975)
]
HARD = [
    (NYQUIST * (1 - 1e-3), 0.02, 8),  # a sliver with corners 1e-7 apart
    (NYQUIST * 1.5, 0.0, 0.5),  # a zero of the plant on the circle: walls of 1e9
    (NYQUIST, 0.0, 3.25),
    (NYQUIST + 1e-4, 0.02, 2),
]


def classified(region, rng, count=600):
    """Random walls, many of them near corners, with what eigenvalues and the outline say."""
    loop = region.loop
    low, high = np.array(region.polygon.bounds).reshape(2, 2)
    size = high - low
    walls = rng.uniform(low - 0.3 * size, high + 0.3 * size, (count, 2))
    near = region.corners[rng.integers(0, len(region.corners), count // 2)]
    walls[: count // 2] = near + rng.normal(size=near.shape) * size * 10 ** rng.uniform(
        -5, -1, (len(near), 1)
    )
    largest = radius(*walls.T, loop.gamma, loop.delta, loop.delay)
    inside = shapely.contains_xy(region.polygon, *walls.T)
    away = shapely.distance(shapely.points(walls), region.polygon.boundary)
    clear = (away > region.error + 1e-10 * size.max()) & (np.abs(largest - 1) > 1e-9)
    return largest[clear] < 1, inside[clear]


@pytest.mark.parametrize("case", CASES + HARD, ids=str)
def test_inside_is_stable_and_outside_is_not(case):
    region = stable_region(*case)
    if region.polygon.is_empty:
        walls = np.random.default_rng(7).uniform(-3, 3, (600, 2))
        assert not np.any(radius(*walls.T, *case) < 1 - 1e-9)
        return
    stable, inside = classified(region, np.random.default_rng(7))
    assert np.array_equal(stable, inside)
    assert stable.any()
    assert not stable.all()


def test_poles_next_to_minus_one():
    """A swing 5e-9 beyond half a turn: n_1 = n_0, and eigenvalues cannot tell a root at -1 + e.

    p = z^3 ((z + 1)^2 - q z) + n_1 (z + 1) ((alpha + beta) z - beta) with q = 2 + a = 2.5e-16, so
    that e = -q/(n_1 (alpha + 2 beta)) and the other roots are those of p/(z + 1) without q.
    """
    gamma = NYQUIST * (1 + 1e-8)
    region = stable_region(gamma, 0.0, 2)
    rng = np.random.default_rng(7)
    low, high = np.array(region.polygon.bounds).reshape(2, 2)
    walls = rng.uniform(low, high, (2000, 2))
    n1 = 2 / gamma  # (1 - cos(sqrt(gamma)))/gamma
    largest = [
        np.abs(np.roots([1, 1, 0, n1 * (alpha + beta), -n1 * beta])).max() for alpha, beta in walls
    ]
    stable = (np.array(largest) < 1) & (walls @ [1, 2] < 0) & (walls[:, 0] > -gamma)
    away = shapely.distance(shapely.points(walls), region.polygon.boundary) > region.error + 1e-6
    inside = shapely.contains_xy(region.polygon, *walls.T)
    assert np.array_equal(stable[away], inside[away])
    assert inside.any()


def on_circle(wall, case):
    """How many roots lie on the unit circle to 1e-12 in modulus, a double root as two."""
    with mpmath.workdps(40):
        numbers = [mpmath.mpf(c.str(38, radius=False)) for c in coefficients(*wall, *case).coeffs()]
        roots = mpmath.polyroots(numbers[::-1], maxsteps=200, extraprec=300)
        # a double root splits by the square root of an error of 1e-15
        return sum(abs(abs(root) - 1) < mpmath.mpf(10) ** -12 for root in roots), roots


@pytest.mark.parametrize(
    "case",
    [(0.001, 0.02, 1), (0.001, 0.02, 2), (0.001, 0.02, 0.5), (5.0, 0.02, 1), (2.0, 0.5, 2.5),
     (7.0, 0.02, 2)],
    ids=str,
)  # fmt: skip
def test_corners_have_two_of_the_boundaries(case):
    """Three roots on the circle or four; at an end of the curve a double root at 1 or -1."""
    region = stable_region(*case)
    assert len(region.corners) >= 1
    for corner in region.corners:
        count, roots = on_circle(corner, case)
        double = sum(abs(root**2 - 1) < 3e-7 for root in roots)
        assert count >= 3 or double >= 2, (corner, count)


def test_a_corner_where_two_arcs_hardly_cross_has_all_digits():
    """Next to half a swing in a period: an end of either arc is off by 5e-9 of the stiffness."""
    case = 9.86, 0.02, 8
    corners = stable_region(*case).corners
    assert on_circle(corners[corners[:, 0].argmax()], case)[0] == 4


@pytest.mark.parametrize("case", [(0.001, 0.02, 2), (5.0, 0.02, 1), (2.0, 0.5, 2.5)], ids=str)
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_error_bounds_the_distance_to_the_boundary(case, tolerance):
    """Every bordering arc sampled 2 000 times is that close to the outline, and not much less."""
    region = stable_region(*case, tolerance=tolerance)
    worst = 0.0
    for low, high in region.loop.arcs:
        theta = np.linspace(low, high, 2_002)[1:-1]
        walls = np.stack(stability_boundary(theta, *case), axis=-1)
        worst = max(worst, shapely.distance(shapely.points(walls), region.polygon.boundary).max())
    assert worst <= region.error
    size = np.linalg.norm(np.ptp(region.outline[0], axis=0))
    assert region.error <= 2 * tolerance * size


def test_area_of_the_free_mass():
    """Green's integral of alpha d beta along 4 tan(t/2)^2 cos t, 2 tan(t/2) sin(t/2)/cos(t/2).

    The boundary of d = 0, gamma = delta = 0 ends at theta = pi/2, on alpha = 0.
    """

    def alpha(t):
        return 4 * mpmath.tan(t / 2) ** 2 * mpmath.cos(t)

    def beta(t):
        return 2 * mpmath.tan(t / 2) ** 2

    area = mpmath.quad(lambda t: alpha(t) * mpmath.diff(beta, t), [0, mpmath.pi / 2])
    region = stable_region(0.0, 0.0, 0, tolerance=2e-9)
    assert region.area == pytest.approx(float(area), rel=1e-8)
    assert region.error < 5e-9


def test_area_by_counting():
    case = (0.001, 0.02, 1)
    region = stable_region(*case)
    low, high = np.array(region.polygon.bounds).reshape(2, 2)
    count = 300
    sides = [np.linspace(a, b, count, endpoint=False) + (b - a) / count / 2
             for a, b in zip(low, high, strict=True)]  # fmt: skip
    walls = np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)
    share = np.mean(radius(*walls.T, *case) < 1)
    assert region.area == pytest.approx(share * np.prod(high - low), rel=3e-3)


def test_the_left_bound():
    """s4d-left-bound: a part of alpha = -gamma borders the region, or only a point or nothing."""
    assert stable_region(0.001, 0.02, 1).touches_left_bound
    assert not stable_region(5.0, 0.02, 1).touches_left_bound


def test_no_stable_wall_gives_an_empty_region():
    region = stable_region(NYQUIST, 0.0, 1)
    assert region.polygon.is_empty
    assert region.area == 0
    assert region.outline == ()
    assert region.corners.shape == (0, 2)
    assert not region.touches_left_bound


@pytest.mark.parametrize("delay", [0.5, 1.5])
@pytest.mark.parametrize("damping", [1e-7, 6e-9, 1e-10, 1e-12])
def test_half_swings_hardly_damped_behind_half_a_period(damping, delay):
    """M(-1) is then a billionth of its terms; the area was twice that of all stable walls."""
    region = stable_region(NYQUIST, damping, delay)
    low, high = np.array(region.polygon.bounds).reshape(2, 2)
    walls = np.random.default_rng(3).uniform(low, high, (60, 2))
    inside = shapely.contains_xy(region.polygon, *walls.T)
    assert 10 < inside.sum() < 50
    assert inside.tolist() == [certified(*w, NYQUIST, damping, delay) == 0 for w in walls]


def test_plot_draws_one_closed_line():
    axes = Figure().add_subplot()
    region = stable_region(0.001, 0.02, 1)
    region.plot(axes, color="k", fill="0.9")
    assert len(axes.lines) == len(region.outline) == 1
    drawn = axes.lines[0].get_xydata()
    assert np.array_equal(drawn[0], drawn[-1])
    assert len(axes.patches) == 1


def test_regions_are_compared_by_what_they_are_of():
    scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
    for make in (
        lambda: stable_region(0.001, 0.02, 1),
        lambda: robust_region(0.1, 0, tolerance=0.1),
        scene.stable_region,
    ):
        region = make()
        assert region == make() == pickle.loads(pickle.dumps(region))
        assert len({region, make()}) == 1
        assert region != stable_region(0.001, 0.03, 1)


@pytest.mark.parametrize(
    ("direction", "said"),
    [
        (("1", 0.0), "alpha: '1' is not allowed; give real numbers"),
        ((0.0, np.nan), "beta: nan is not allowed; give finite numbers"),
        ((np.inf, 0.0), "alpha: inf is not allowed; give finite numbers"),
        (([1.0, 2.0], 0.0), "alpha: .* is not allowed; give one number"),
        ((0.0, 0.0), "alpha: 0.0 with beta=0.0 is no direction; give one"),
    ],
)
def test_what_is_no_direction_is_named(direction, said):
    with pytest.raises(ValueError, match=f"^{said}"):
        stable_region(0.001, 0.02, 1).farthest(*direction)


@pytest.mark.parametrize("bad", [0.0, 1.0, -1e-3, 1e-13, np.nan])
def test_tolerance_is_checked(bad):
    with pytest.raises(ValueError, match=r"^tolerance: .* .*; give 1e-12 <= tolerance < 1"):
        stable_region(0.001, 0.02, 1, tolerance=bad)


@pytest.mark.parametrize("damping", [1e-42, 1e-63, 1e-150])
@pytest.mark.parametrize("delay", [0, 1, 2])
def test_next_to_no_damping_is_as_good_as_none(damping, delay):
    """Roots at -1 then belong to walls that no float holds, which border nothing that is stable."""
    found, none = stable_region(0.3, damping, delay), stable_region(0.3, 0.0, delay)
    assert found.area == pytest.approx(none.area, rel=1e-12)
    assert np.allclose(found.corners, none.corners, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize(
    ("device", "delay", "sheet", "wall"),
    [
        ((9.8696, 0.0), 0.3, "exact", None),  # half a swing in a period
        ((9.8696044, 0.0), 0.0, "exact", None),
        ((9.8696044, 0.0), 1.0, "exact", None),
        ((1.9340278253360927, 2.78), 1 + 2**-30, "principal", None),
        ((6.82, 0.7), 2 + 1e-11, "principal", None),
        # not one piece is found, and nothing is loose
        ((6.909924236901929, 2.677593357711269), 1e-8, "principal", None),
        ((0.0, 5.116789492756621), 2**-52, "principal", None),
    ],
)
def test_pieces_that_do_not_meet_are_no_empty_region(device, delay, sheet, wall):
    """There are stable walls: the empty region that was once the answer is wrong."""
    if wall is not None:
        assert radius(*wall, *device, delay) < 1
    with pytest.raises(ValueError, match=r"^gamma: .* the pieces of its boundary do not meet"):
        stable_region(*device, delay, sheet)


@pytest.mark.parametrize(
    ("device", "delay", "area"),
    [
        ((9.8696, 0.0), 0.0, np.pi**4),
        ((np.pi**2 * (1 + 1e-7), 0.0), 1.0, np.pi**4 / 3),
        ((9 * np.pi**2 * (1 - 1e-7), 0.0), 0.0, 81 * np.pi**4),
    ],
)
def test_next_to_half_swings_the_region_is_that_a_little_farther(device, delay, area):
    """All of it was lost within 4e-6 of gamma = pi^2, where the boundary turns within that.

    By hand at gamma = pi^2, with u = 2 (alpha + beta)/gamma and w = -2 beta/gamma: the polynomial
    is z + 1 times z^2 + (1 + u) z + w without delay, z^3 + z^2 + u z + w behind one period.  Jury
    leaves an area of 4 and of 4/3 of (u, w), which is gamma^2/4 times as large of (alpha, beta).
    """
    assert stable_region(*device, delay).area == pytest.approx(area, rel=1e-5)


def test_axes_without_labels_get_those_of_the_plane_and_others_keep_theirs():
    figure = Figure()
    one, other = figure.subplots(1, 2)
    other.set_ylabel("mine")
    region = stable_region(0.001, 0.02, 1)
    for axes in (one, other):
        region.plot(axes)
    assert (one.get_xlabel(), one.get_ylabel()) == region.labels
    assert (other.get_xlabel(), other.get_ylabel()) == ("", "mine")


@pytest.mark.parametrize("delay", [0.0, 1.0, 2.5])
def test_every_chord_of_the_boundary_ends_at_walls_with_a_root_on_the_circle(delay):
    ends = chords(Loop(0.5, 0.3, delay), (-1.0, -3.0, 8.0, 8.0), 1e-3).reshape(-1, 2)
    assert len(ends) > 20
    for wall in ends:
        assert np.abs(moduli(*wall, 0.5, 0.3, delay) - 1).min() < 1e-6


@pytest.mark.parametrize("delay", [0, 1, 2, 2.5])
def test_chords_follow_the_whole_boundary_in_a_box(delay):
    """Walls on the curve, and on the line of a root at -1, are as near to a chord as asked for.

    p(-1) = 0 is alpha + 2 beta = (-1)^d (1 + a + e)/(n1 - n0).
    """
    gamma, delta, share, box = 0.5, 0.3, 1e-6, np.array([[-1.0, -8.0], [8.0, 60.0]])
    ends = chords(Loop(gamma, delta, float(delay)), tuple(box.ravel()), share)
    assert len(ends) < 6000
    theta = np.linspace(0, np.pi, 5002)[1:-1]
    walls = np.stack(stability_boundary(theta, gamma, delta, delay), axis=-1)
    if delay in (0, 2):
        n1, n0, a, e = map(float, numbers(gamma, delta))
        alpha, line = np.linspace(-1, 8, 1000), (1 + a + e) / (n1 - n0)
        walls = np.vstack([walls, np.stack([alpha, (line - alpha) / 2], axis=-1)])
    walls = walls[((walls >= box[0]) & (walls <= box[1])).all(axis=1)]
    assert len(walls) > 1000
    away = shapely.distance(shapely.points(walls), shapely.multilinestrings(list(ends)))
    assert (away < share * np.maximum(delta, np.linalg.norm(walls, axis=1))).all()


@pytest.mark.parametrize("delay", [0, 3, 0.4])
def test_a_wall_is_too_large_to_be_stable_by_the_coefficients_that_it_adds(delay):
    """M ((alpha + beta) z - beta); as large as those of (z + 1)^n and of the device together."""
    loop = Loop(0.5, 0.3, float(delay))
    alpha, beta = np.random.default_rng(1).normal(size=(2, 400)) * 10 ** (1 + delay / 3)
    x, degree = loop.device, int(delay) + 4
    added = [np.convolve([x.m2, x.m1, x.m0], [a + b, -b]) for a, b in zip(alpha, beta, strict=True)]
    most = degree * (degree - 1) * (degree - 2) / 6 + 2
    possible = np.abs(added).max(axis=1) <= most
    assert 50 < possible.sum() < 350
    assert loop._possible(alpha, beta).tolist() == possible.tolist()


def test_the_curve_and_the_line_of_a_root_at_minus_one_meet_in_the_end_of_their_chords():
    """The wall has a double root there: p(-1) = p'(-1) = 0."""
    n1, n0, a, e = map(float, numbers(0.5, 8.0))
    bare, *parts = (
        np.array([np.polyval(p, -1.0), np.polyval(np.polyder(p), -1.0)])
        for p in ([1, -a, e, 0], [n1, n0, 0], [n1, n0 - n1, -n0])
    )
    wall = np.linalg.solve(np.transpose(parts), -bare)
    ends = chords(Loop(0.5, 8.0, 0.0), (*(wall - 5), *(wall + 5)), 1e-3)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    (one, two), curve = ends[length > 2], ends[length < 2].reshape(-1, 2)  # of the line, and others
    assert one[1] == pytest.approx(wall, rel=1e-9)
    assert one[1].tolist() == two[0].tolist()
    assert one[1].tolist() in curve.tolist()


@pytest.mark.parametrize("angle", [-1.5, -0.5, 0.0, 0.5, 1.0, 1.5, 3.0])
def test_the_farthest_wall_of_a_free_mass_in_a_direction(angle):
    """Stable are those between alpha = 0 and (4 t^2 cos(theta), 2 t^2), where t = tan(theta/2)."""
    direction = np.cos(angle), np.sin(angle)
    theta = np.linspace(0, np.pi / 2, 200_001)
    square = np.tan(theta / 2) ** 2
    reach = direction @ np.array([4 * square * np.cos(theta), 2 * square])
    alpha, beta, at = stable_region(0.0, 0.0, 0).farthest(*direction)
    assert direction @ np.array([alpha, beta]) == pytest.approx(reach.max(), rel=1e-9)
    assert at == pytest.approx(theta[reach.argmax()], abs=2e-5)
