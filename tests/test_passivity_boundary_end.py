"""Where the passivity boundary ends: every wall on it is just passive, and beyond there is none.

Where it ends is found here from matrices (test_fractional_passivity.needed) and from mpmath's pi.
"""

import shutil
import subprocess
import sys

import mpmath
import numpy as np
import pytest
import sympy as sp
from export.covering import every_value
from test_fractional_passivity import needed

import symhaptic
from symhaptic import passivity_boundary, passivity_margin
from symhaptic.export import request
from symhaptic.export.accuracy import DERIVATIVES, MEASURED
from symhaptic.export.language import Refused
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.targets import TARGETS
from symhaptic.export.vectors import hexadecimal
from symhaptic.forms import required_damping, stable
from symhaptic.forms.derivatives import with_derivatives
from symhaptic.forms.entire import written_out
from symhaptic.notation import alpha, beta, epsilon, l, psi
from symhaptic.proof.decide import equal

RNG = np.random.default_rng(11)
BEYOND = [(2.0, 1.0, 1.5), (2.5, 1.0, 1.0), (3.0, 2.0, 2.0), (1.9, 0.3, 3.25), (3.1, 1.0, 0.75),
          (1e-3, 1.0, 1e6), (3.0, 1.0, 1e6), (2.9, 1.0, 0.4)]  # fmt: skip
BEFORE = [(1.0, 1.0, 1.5), (1.5, 1.0, 1.0), (0.9, 2.0, 2.0), (0.5, 0.3, 3.25), (1.5, 1.0, 0.75),
          (3e-6, 1.0, 1e6), (3.1, 1.0, 0.2), (2.0, 1.0, 0.4)]  # fmt: skip


def angles(count):
    """Angles on both sides of the end, dampings, and delays, a third of them whole."""
    delay = np.where(RNG.random(count) < 0.5, 10 ** RNG.uniform(-3, 3, count), RNG.random(count))
    delay = np.where(RNG.random(count) < 0.3, RNG.integers(0, 40, count), delay)
    theta = np.minimum(RNG.uniform(0, 2.5, count) * np.pi / (delay + 1), 3.14159)
    return theta, 10 ** RNG.uniform(-3, 3, count), delay


def rounding(wall, delta, delay):
    """A bound of the margin's error where the wall has the recorded error of the boundary.

    The need is at most |alpha| (d + 1/2) + |beta| and linear up to its size, so that a relative
    change of the wall changes it by no more than that part of this; both records are in last
    places, of the largest term.
    """
    places = 2 * MEASURED[DOUBLE]["passivity_boundary"].error
    places += MEASURED[DOUBLE]["passivity_margin"].error
    size = np.abs(wall[0]) * (delay + 0.5) + np.abs(wall[1]) + delta
    return places * np.finfo(float).eps * size


def test_every_wall_on_it_is_just_passive():
    theta, delta, delay = angles(60_000)
    wall = np.array(passivity_boundary(theta, delta, delay))
    there = np.isfinite(wall).all(axis=0)
    assert 20_000 < there.sum() < 40_000
    theta, delta, delay, wall = theta[there], delta[there], delay[there], wall[:, there]
    assert (wall[0] >= 0).all()
    margin = passivity_margin(*wall, delta, delay)
    assert (np.abs(margin) <= rounding(wall, delta, delay)).all()


def end(delay):
    """The worst angle of mere damping, from the eigenvalues of the form in two displacements."""
    low, high = 0.2 * np.pi / (delay + 1), min(1.6 * np.pi / (delay + 1), np.pi)
    for _ in range(6):
        grid = np.linspace(low, high, 201)
        best = int(np.argmax(needed(0.0, 1.0, delay, grid)))
        low, high = grid[max(best - 1, 0)], grid[min(best + 1, 200)]
    # of a maximum at pi, next to 2/9 as flat as a fourth power, floats tell 1e-4 or so
    return (low + high) / 2, high > np.pi - 1e-3


@pytest.mark.parametrize("delay", [0.25, 0.3, 0.5, 0.75, 0.97, 1.03, 1.5, 2.2, 4.6, 7.9])
def test_behind_a_fraction_it_ends_at_the_worst_angle_of_mere_damping(delay):
    angle, at_pi = end(delay)
    assert not at_pi
    # the grid sees a maximum no closer than the square root of the rounding of its value
    away = np.array([1e-9, 1e-6, 1e-3, 0.03, 0.3, 0.6, 0.9])
    assert np.isfinite(passivity_boundary(angle * (1 - 1e-6) * (1 - away), 1.0, delay)).all()
    later = angle * (1 + 1e-6) * (1 + away)
    assert np.isnan(passivity_boundary(later[later < np.pi], 1.0, delay)).all()
    stiffness, damping = passivity_boundary(angle * (1 - 1e-6), 1.0, delay)
    assert 0 < stiffness < 1e-4
    assert damping == pytest.approx(1 / needed(0.0, 1.0, delay, np.array([angle]))[0], rel=1e-5)


@pytest.mark.parametrize("delay", [1, 2, 3, 10, 1000, 10**6, 123_456_789])
def test_at_a_whole_delay_it_ends_with_the_last_float_before_pi_over_d_plus_1(delay):
    first = float(np.pi / (delay + 1))
    near = [first]
    for _ in range(3):
        near = [np.nextafter(near[0], 0), *near, np.nextafter(near[-1], 4)]
    stiffness, damping = passivity_boundary(near, 1.0, delay)
    with mpmath.workdps(60):
        before = np.array([mpmath.mpf(t) * (delay + 1) <= mpmath.pi for t in near])
    assert before.any()
    assert not before.all()
    assert (np.isfinite(stiffness) == before).all()
    assert (np.isfinite(damping) == before).all()
    # at pi/(d + 1) itself (27) is (0, delta)
    assert (stiffness[before] >= 0).all()
    assert stiffness[before] == pytest.approx(0, abs=1e-14 / delay)
    assert damping[before] == pytest.approx(1, rel=1e-14)


@pytest.mark.parametrize("delay", [1e-3, 0.1, 0.2, 0.222])
def test_behind_a_short_delay_it_goes_on_to_pi_and_a_straight_line_follows(delay):
    assert end(delay)[1]
    stiffness, damping = passivity_boundary(np.array([3.0, 3.14159265]), 1.0, delay)
    assert np.isfinite(stiffness).all()
    assert damping[1] + stiffness[1] / 2 == pytest.approx(1 / (1 - delay), rel=1e-7)
    along = np.linspace(0, 1, 12)[:-1] * stiffness[1]
    line = 1 / (1 - delay) - along / 2
    margin = passivity_margin(along, line, 1.0, delay)
    assert (np.abs(margin) <= rounding((along, line), 1.0, delay)).all()


def test_the_printed_curve_ends_where_it_bounds_nothing():
    """s3b_rise: for every real delay angles above pi/(d + 1) cut off nothing."""
    theta, delta, delay = angles(20_000)
    wall = np.array(passivity_boundary(theta, delta, delay, sheet="principal"))
    there = np.isfinite(wall).all(axis=0)
    far = np.abs(theta * (delay + 1) / np.pi - 1) > 1e-12
    assert (there == (theta * (delay + 1) < np.pi))[far].all()
    # without delay every angle gives the same wall, whose beta is a difference that is 0
    wall, delta, delay = wall[:, there], delta[there], delay[there]
    margin = passivity_margin(*wall, delta, delay, sheet="principal")
    assert (np.abs(margin) <= rounding(wall, delta, delay)).all()


def test_a_wall_one_part_in_a_million_larger_is_not_passive():
    """The curve is the boundary, not a curve inside."""
    theta, delta, delay = angles(3000)
    stiffness, damping = passivity_boundary(theta, delta, delay)
    there = np.isfinite(stiffness)
    larger = (stiffness * (1 + 1e-6), damping * (1 + 1e-6), delta, delay)
    assert (passivity_margin(*larger)[there] < 0).all()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("language", "precision"),
    every_value(TARGETS, [DOUBLE, SINGLE]),
    ids=lambda given: getattr(given, "name", given),
)
def test_beyond_its_end_every_language_gives_nan(language, precision, tmp_path):
    """A self-test with endless tolerance misses NaN alone: all values beyond, and none before."""
    try:
        target = TARGETS[language].at(precision)
    except Refused as other:
        pytest.skip(str(other))
    form = with_derivatives(stable.form("passivity_boundary"), ("delta",))
    built, files = request.built(target, [form])
    folder = tmp_path / "out"
    request.write(files, folder)
    count = len(built.public[0].results)
    *compiling, running = ([sys.executable if c[0] == "python" else c[0], *c[1:]]
                           for c in target.commands("haptic"))  # fmt: skip
    for program, *_ in (*compiling, running):
        if not program.startswith("./") and shutil.which(program) is None:
            pytest.skip(f"no {program} here: the export to {target.title} is not run")
    for command in compiling:
        subprocess.run(command, cwd=folder, check=True, capture_output=True)
    for points, missed in ((BEFORE, 0), (BEYOND, count * len(BEYOND))):
        lines = [
            " ".join([form.name, *map(hexadecimal, map(precision.nearest, point)),
                      *[hexadecimal(0.0), hexadecimal(precision.huge)] * count])
            for point in points
        ]  # fmt: skip
        (folder / "vectors.txt").write_text("\n".join(lines) + "\n")
        run = subprocess.run(running, cwd=folder, capture_output=True, text=True, check=False)
        said = run.stdout.splitlines()[-1].replace(",", " ").split()
        assert said[0] == str(count * len(points)), run.stderr
        assert said[2] == str(missed), run.stdout


def test_formulas_of_other_digits_end_there_too():
    exact = symhaptic.lambdify("passivity_boundary", modules="mpmath")
    for point in BEYOND:
        with pytest.raises(ArithmeticError, match=r"there is none|no wall is worst"):
            exact(*point)
    with mpmath.workdps(30):
        assert exact(1, 1, 1)[0] == pytest.approx(float(passivity_boundary(1.0, 1.0, 1)[0]))


def test_derivatives_by_the_damping_are_the_wall_of_damping_one():
    form = with_derivatives(stable.form("passivity_boundary"), ("delta",))
    run = symhaptic.scene.callables._on_arrays(form, ())
    theta, delta, delay = angles(2000)
    found = np.array(run(theta, delta, delay))
    unit = np.array(passivity_boundary(theta, 1.0, delay))
    assert (np.isnan(found) == np.isnan(unit)[[0, 1, 0, 1]]).all()
    there = np.isfinite(unit[0])
    places = DERIVATIVES[DOUBLE]["passivity_boundary"].error
    places += MEASURED[DOUBLE]["passivity_boundary"].error
    # the record is in last places of the largest term, here that of push over what is below
    assert found[2:, there] == pytest.approx(unit[:, there], rel=4 * places * 2**-52, abs=1e-15)


@pytest.mark.parametrize("whole", range(6))
def test_the_need_of_mere_damping_has_one_maximum(whole):
    """The identity of model.worst, exactly; and that U_l and U_(l+1) do not rise.

    c = cos(theta); F of that docstring is, with b = delta, chapter s6d's margin at alpha = 0.
    """
    b, c, theta = sp.symbols("b c theta", positive=True)
    mere = {alpha: 0, beta: 1, l: whole, psi: theta / 2}
    straight = required_damping.between(
        required_damping.straight(l), required_damping.straight(l + 1)
    )
    wave = (1 - epsilon) * sp.cos((whole + 1) * theta) + epsilon * sp.cos((whole + 2) * theta)
    left = b**2 + b * wave - epsilon * (1 - epsilon) * (1 - sp.cos(theta)) / 2
    needs = written_out(straight).xreplace(mere)
    model = b**2 - b * needs - written_out(required_damping.extra()).xreplace(mere) / 4
    assert equal(left, model)
    first, second = sp.chebyshevu(whole, c), sp.chebyshevu(whole + 1, c)
    polynomial = (
        b**2
        - epsilon * (1 - epsilon) * (1 - c) / 2
        + b * ((1 - epsilon) * sp.chebyshevt(whole + 1, c) + epsilon * sp.chebyshevt(whole + 2, c))
    )
    slope = -b * ((whole + 1) * (1 - epsilon) * first + (whole + 2) * epsilon * second)
    slope -= epsilon * (1 - epsilon) / 2
    assert sp.expand(-polynomial.diff(c) - slope) == 0  # dc/dtheta = -sin(theta)
    last = sp.cos(sp.pi / (whole + 1))
    for wave in (first, second):
        rises = sp.Poly(wave.diff(c), c)
        if rises.degree() > 0:  # all zeros of the slope lie below c = cos(pi/(l + 1))
            assert max(map(sp.N, sp.real_roots(rises))) <= sp.N(last) + 1e-12
