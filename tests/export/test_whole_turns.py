"""n1, n0 and n1 + n0 in relative accuracy where the device has just swung whole turns.

The reference is the closed form in 120 digits of mpmath at the very floats.  Of the 2 last places
of n1 and n1 + n0 half are the last rounding; n0 is a difference next to delta = eta^2, where
eta = sqrt(gamma) - 2 pi k: there a part of delta of the last place of n1 + n0 counts, too.
"""

import mpmath
import numpy as np
import pytest
from mpmath import mpf

import symhaptic
from symhaptic.bench.error import functions
from symhaptic.export import readme, request
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable

TURNS = [1, 2, 3, 10, 450, 1500, 10**5, 4 * 10**6]  # of them 450 is the most in single
DAMPINGS = [0.0, 1e-300, 1e-200, 1e-100, 1e-30, 1e-20, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6,
            1e-4, 1e-2, 0.1, 0.5, 1.0, 1.4]  # fmt: skip


def exact(gamma, delta):
    """n1 and n0 from C(w) and S(w), without any of our forms."""
    g, d = mpf(float(gamma)), mpf(float(delta))
    root = mpmath.sqrt(g - d * d / 4)
    fall, even, odd = mpmath.exp(-d / 2), mpmath.cos(root), mpmath.sin(root) / root * d / 2
    return (1 - fall * (even + odd)) / g, fall * (fall - even + odd) / g


def next_to_turns(precision):
    """The floats next to (2 pi k)^2, and others beside them at all distances."""
    kind, found = precision.kind, []
    for k in (k for k in TURNS if (2 * np.pi * k) ** 2 < precision.stiffest):
        with mpmath.workdps(60):
            near = [kind(float((2 * mpmath.pi * k) ** 2))]
        for _ in range(3):
            near = [np.nextafter(near[0], kind(0)), *near, np.nextafter(near[-1], kind(1e30))]
        near += [near[3] * (1 + sign * 10.0**-j) for j in range(1, 16) for sign in (1, -1)]
        found += [(kind(g), kind(d)) for g in near for d in DAMPINGS if d == 0 or kind(d) > 1e-40]
    return np.array(found, dtype=kind)


def where_n0_vanishes(count):
    """delta next to eta^2, of several k."""
    rng = np.random.default_rng(4)
    eta = rng.choice([-1, 1], count) * 10 ** rng.uniform(-9, -0.1, count)
    root = 2 * np.pi * rng.choice(TURNS, count) + eta
    near = 1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-15, 0, count)
    return np.stack([root**2, np.minimum(eta**2 * near, 1.4)], axis=1)


@pytest.fixture(scope="module")
def routines():
    return functions(stable.form("stability_boundary"))


def misses(routines, points, precision):
    """How far off each is, in last places of itself; the terms of n0 by itself; signs."""
    gamma, delta = points.T
    device = functions(stable.form("discretize"))
    found = (device.plant_n1(np, gamma, delta), device.plant_n0(np, gamma, delta),
             routines.numerator_at_one(np, gamma, delta))  # fmt: skip
    assert all(f.dtype == precision.kind for f in found)
    off, terms, signs = np.zeros((3, len(gamma))), np.zeros(len(gamma)), []
    with mpmath.workdps(120):
        for i, point in enumerate(points):
            n1, n0 = exact(*point)
            for k, value in enumerate((n1, n0, n1 + n0)):
                last = mpf(precision.ulp(float(value)))
                off[k, i] = abs(mpf(float(found[k][i])) - value) / last
                signs.append(mpmath.sign(value) == np.sign(found[k][i]))
            terms[i] = (n1 + abs(n0)) / abs(n0)
    return off, terms, signs


@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=["double", "single"])
def test_floats_next_to_whole_turns_lose_no_digits(routines, precision):
    """Before: all digits, and the wrong sign, at 252 of these with the damping 0 to 1e-20."""
    points = next_to_turns(precision)
    off, terms, signs = misses(routines, points, precision)
    assert all(signs)
    assert off[0].max() < 2
    assert (off[1] < 2 + points[:, 1] * terms).all()
    assert off[2].max() < 3


def test_where_n0_changes_its_sign_its_digits_are_those_of_a_part_of_the_damping(routines):
    points = where_n0_vanishes(4000)
    off, terms, signs = misses(routines, points, DOUBLE)
    assert off[0].max() < 2
    assert off[2].max() < 3
    assert (off[1] < 2 + points[:, 1] * terms).all()
    few = points[:, 1] < 1e-6
    assert terms[few].max() > 1e6
    sure = 2 + points[:, 1] * terms < 2.0**52
    assert np.array(signs).reshape(-1, 3)[sure].all()


def test_the_example_of_the_report():
    """(39.47841760435752, 1e-12) was off by 9e-5 of its value, and n1 of less damping negative."""
    for delta in (1e-12, 1e-14, 1e-16, 1e-20, 1e-300, 0.0):
        with mpmath.workdps(60):
            expected = [float(x) for x in exact(39.47841760435752, delta)]
        found = [float(x) for x in symhaptic.discretize(39.47841760435752, delta)[:2]]
        assert found == pytest.approx(expected, rel=4e-16, abs=0)


def test_n1_is_the_larger_one_and_positive():
    """Both are (n1 + n0 +- delta NumeratorGap)/2, and S(w) <= 1 <= S(delta^2/4)."""
    points = np.concatenate([next_to_turns(DOUBLE), where_n0_vanishes(1000)])
    n1, n0 = symhaptic.discretize(*points.T)[:2]
    assert (n1 > 0).all()
    assert (n1 >= n0).all()


@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=lambda p: p.name)
def test_a_readme_says_where_that_ends(precision):
    forms = request.chosen(["discretize"])
    target = TARGETS["c"].at(precision)
    made, _ = request.built(target, forms, vectors=False)
    text = " ".join(readme.readme(made, target, 1).split())
    assert "Next to gamma = (2 pi k)^2" in text
    # a last place of gamma is less than 1 there, so that the turns can be told
    assert precision.stiffest < 2.0**precision.bits
    end = {DOUBLE: "1e15", SINGLE: "1e7"}[precision]
    assert f"gamma larger than {end}" in text


def late_wall(theta, gamma, delta, part):
    """alpha and beta behind less than a period, from what the force before and the new one move."""
    t, g, d, ep = map(mpf, (theta, gamma, delta, part))
    root, z = mpmath.sqrt(d * d / 4 - g), mpmath.expj(t)

    def moved(time):
        """The way under a unit force that is held, and the speed that is left of a unit speed."""
        fall, even = mpmath.exp(-d * time / 2), mpmath.cosh(root * time)
        odd = d / 2 * mpmath.sinh(root * time) / root
        return (1 - fall * (even + odd)) / g, fall * (even - odd)

    (whole, speed), (new, _), (_, slow) = map(moved, (mpf(1), 1 - ep, ep))
    lost = mpmath.exp(-d)
    old = (lost - mpmath.exp(-d * (1 - ep)) * slow) / g
    middle = whole + (lost - speed) / g - new - old
    trace = 1 - g * whole + speed
    force = -z * (z * z - trace * z + lost) / (new * z * z + middle * z + old)
    beta = mpmath.im(force) / mpmath.sin(t)
    return mpmath.re(mpmath.re(force) - beta * (1 - mpmath.cos(t))), mpmath.re(beta)


@pytest.mark.parametrize("delta", [1e-300, 1e-12, 1e-6, 1e-3])
@pytest.mark.parametrize("far", [-1e-6, 1e-9, -1e-12, 1e-15])
def test_the_boundary_behind_a_fraction_keeps_its_digits_there(delta, far):
    """m2 and m0 are alike: beta was off by up to 0.87 of itself, its slope by the delay by 8e-6."""
    slopes = symhaptic.lambdify("stability_boundary", derivatives=["gamma", "d"])
    for theta, k, part in ((4e-5, 1, 0.21), (2e-4, 1, 0.79), (3e-3, 2, 0.34)):
        point = theta, (2 * np.pi * k) ** 2 * (1 + far), delta, part
        with mpmath.workdps(60):
            exact = late_wall(*point)
            by = [
                mpmath.diff(lambda *p, j=j: late_wall(*p)[j], point, n=order)
                for order in ((0, 1, 0, 0), (0, 0, 0, 1))
                for j in (0, 1)
            ]
        expected = [*map(float, (*exact, *by))]
        assert list(slopes(*point)) == pytest.approx(expected, rel=2e-11, abs=0), point
        assert symhaptic.stability_boundary(*point) == pytest.approx(
            expected[:2], rel=1e-13, abs=0
        ), point
