"""Wrong implementations, each a plausible mistake: the default run of `check` refuses every one.

They are the package's functions with one thing changed.  The same comparison agrees with the
functions themselves, with plain implementations and with exported C.
"""

import json
import math
import subprocess
from functools import cache

import numpy as np
import pytest
from command import symhaptic

import symhaptic as sh
from symhaptic.check import compare, report
from symhaptic.check.callers import Theirs, called
from symhaptic.check.checked import exact
from symhaptic.check.compare import compared, error
from symhaptic.check.formulas import CHECKED, _first_maximum
from symhaptic.check.points import drawn
from symhaptic.check.report import covered

PI = math.pi


def on_arrays(function):
    """A function of arrays as one that takes points."""

    def call(points):
        with np.errstate(all="ignore"):
            values = function(*map(np.array, zip(*points, strict=True)))
        values = values if isinstance(values, tuple) else (values,)
        columns = np.broadcast_arrays(np.zeros(len(points)), *values)[1:]
        return list(zip(*(c.astype(float).tolist() for c in columns), strict=True))

    return call


def whole(d):
    return d == np.floor(d)


def stable(change):
    """is_stable with what is changed in its arguments or its answer."""
    return lambda *wall: change(sh.is_stable, *wall)


def seldom(values, *columns):
    """NaN at one of ten thousand points, where a hash of the arguments is 0."""
    bits = sum(np.asarray(c).view(np.int64) * k for k, c in enumerate(columns, 3))
    hit = np.zeros(bits.shape, dtype=bool)
    hit[np.argmin(bits)] = True
    return tuple(np.where(hit, np.nan, v) for v in values)


def eq5(K, B, T, omega, d):
    half = omega * T / 2
    return K * T * np.sin((2 * d + 1) * half) / (2 * np.sin(half)) - B * np.cos(2 * (d + 1) * half)


def eq11(b, T, d):
    n = PI / (2 * (d + 1))
    return 2 * b / T * np.tan(n / 2), b * (np.sin(n * d) - d / (d + 1)) / np.sin(n)


def truncated(values, d, last):
    """A table of delays that ends."""
    return tuple(np.where(d > last, 0 * v, v) for v in values)


def single(function):
    def inside(*columns):
        found = function(*(c.astype(np.float32).astype(float) for c in columns))
        found = found if isinstance(found, tuple) else (found,)
        return tuple(np.asarray(v) for v in found)

    return inside


@cache
def delay_margin(*wall):
    return float(sh.delay_margin(*wall))


def margin(change):
    """A delay margin that is changed."""
    return lambda points: [(change(delay_margin(*p), *p),) for p in points]


def stiffest(change):
    def call(gamma, delta, d):
        return change(_first_maximum, gamma, delta, d)

    return call


MUTANTS = {
    # -- whether a wall is stable
    "is_stable: long delays are stable": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d) | (d > 3)),
    ),
    "is_stable: fractional delays are stable": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d) | ~whole(d)),
    ),
    "is_stable: alpha off by 0.1 %": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(1.001 * a, b, g, dl, d)),
    ),
    "is_stable: gamma off by 0.1 %": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, 1.001 * g, dl, d)),
    ),
    "is_stable: accepts walls 1e-3 beyond the boundary": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d) | f(a / 1.001, b / 1.001, g, dl, d)),
    ),
    "is_stable: accepts walls 1e-9 beyond the boundary": (
        "is_stable",
        stable(
            lambda f, a, b, g, dl, d: (
                f(a, b, g, dl, d) | f(a * (1 - 1e-9), b * (1 - 1e-9), g, dl, d)
            )
        ),
    ),
    "is_stable: principal sheet at fractions": (
        "is_stable",
        lambda *wall: sh.is_stable(*wall, sheet="principal"),
    ),
    "is_stable: the fraction is rounded": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, np.round(d))),
    ),
    "is_stable: the fraction is cut off": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, np.floor(d + 1e-9))),
    ),
    "is_stable: springs beyond a half swing count as the softest such": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, np.minimum(g, 9.8), dl, d)),
    ),
    "is_stable: alpha and beta are exchanged": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(b, a, g, dl, d)),
    ),
    "is_stable: only walls that push": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d) & (a > 0)),
    ),
    "is_stable: one delay more": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d + 1)),
    ),
    "is_stable: the left bound is stable": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, d) | (a == -g)),
    ),
    "is_stable: single precision inside": ("is_stable", single(sh.is_stable)),
    "is_stable: delays above 1000 as 1000": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, dl, np.minimum(d, 1000))),
    ),
    "is_stable: hardly damped devices as undamped": (
        "is_stable",
        stable(lambda f, a, b, g, dl, d: f(a, b, g, np.where(dl < 1e-4, 0, dl), d)),
    ),
    "is_stable: NaN once": (
        "is_stable",
        lambda *wall: seldom((sh.is_stable(*wall),), *wall),
    ),
    # -- counts
    "unstable_roots: at most 4": (
        "unstable_roots",
        lambda *wall: np.minimum(sh.unstable_roots(*wall), 4),
    ),
    "unstable_roots: one more at fractions": (
        "unstable_roots",
        lambda *wall: sh.unstable_roots(*wall) + ~whole(wall[4]),
    ),
    "unstable_roots: roots on the circle within 1e-6": (
        "unstable_roots",
        lambda a, b, *rest: sh.unstable_roots(a * (1 + 1e-6), b * (1 + 1e-6), *rest),
    ),
    "unstable_roots: the count of the inside": (
        "unstable_roots",
        lambda *wall: np.floor(wall[4]) + 3 - sh.unstable_roots(*wall),
    ),
    # -- the stability boundary and its extremes
    "stability_boundary: fraction as on the principal sheet": (
        "stability_boundary",
        lambda *at: sh.stability_boundary(*at, sheet="principal"),
    ),
    "stability_boundary: delta off by 0.1 %": (
        "stability_boundary",
        lambda theta, g, dl, d: sh.stability_boundary(theta, g, 1.001 * dl, d),
    ),
    "stability_boundary: beta with the other sign for long delays": (
        "stability_boundary",
        lambda theta, g, dl, d: (lambda w: (w[0], np.where(d > 10, -w[1], w[1])))(
            sh.stability_boundary(theta, g, dl, d)
        ),
    ),
    "stability_boundary: theta below 1e-6 as 1e-6": (
        "stability_boundary",
        lambda theta, g, dl, d: sh.stability_boundary(np.maximum(theta, 1e-6), g, dl, d),
    ),
    "max_stable_stiffness: (9, 9, 1) at fractions": (
        "max_stable_stiffness",
        stiffest(
            lambda f, g, dl, d: tuple(
                np.where(whole(d), v, w) for v, w in zip(f(g, dl, d), (9, 9, 1), strict=True)
            )
        ),
    ),
    "max_stable_stiffness: the first maximum for stiff springs": (
        "max_stable_stiffness",
        stiffest(lambda f, g, dl, d: f(np.minimum(g, 0.999 * (PI / (d + 1)) ** 2), dl, d)),
    ),
    "max_stable_stiffness: stiff springs get the value at 9.8": (
        "max_stable_stiffness",
        stiffest(
            lambda f, g, dl, d: tuple(
                np.where(np.isnan(v), 9.0, v) for v in f(np.minimum(g, 9.8), dl, d)
            )
        ),
    ),
    "max_stable_stiffness: alpha 0.1 % too large": (
        "max_stable_stiffness",
        stiffest(lambda f, g, dl, d: (1.001 * f(g, dl, d)[0], *f(g, dl, d)[1:])),
    ),
    "max_stable_stiffness: a table up to d = 20": (
        "max_stable_stiffness",
        stiffest(lambda f, g, dl, d: f(g, dl, np.minimum(d, 20))),
    ),
    "scene.max_stable_stiffness: the period not squared": (
        "scene.max_stable_stiffness",
        lambda m, b, k, T, d: tuple(
            v * s
            for v, s in zip(
                stiffest(lambda f, *p: f(*p)[:2])(k * T**2 / m, b * T / m, d),
                (m / T, m / T),
                strict=True,
            )
        ),
    ),
    "scene.max_stable_stiffness: a delay in seconds": (
        "scene.max_stable_stiffness",
        lambda m, b, k, T, d: tuple(
            v * s
            for v, s in zip(
                stiffest(lambda f, *p: f(*p)[:2])(k * T**2 / m, b * T / m, d * T),
                (m / T**2, m / T),
                strict=True,
            )
        ),
    ),
    "delay_margin: doubled beyond 20": (
        "delay_margin",
        margin(lambda m, *p: 2 * m if m > 20 else m),
    ),
    "delay_margin: whole periods": (
        "delay_margin",
        margin(lambda m, *p: float(np.floor(m)) if m < 1e9 else m),
    ),
    "delay_margin: long is infinite": (
        "delay_margin",
        margin(lambda m, *p: np.inf if m > 1000.0 else m),
    ),
    "delay_margin: infinite is 1000": ("delay_margin", margin(lambda m, *p: min(m, 1000.0))),
    "delay_margin: half a period too long": (
        "delay_margin",
        margin(lambda m, *p: m + 0.5 * (m > 0)),
    ),
    "max_delay: 0.1 % too long": ("max_delay", margin(lambda m, *p: 1.001 * m)),
    "max_delay: unstable walls get 1": ("max_delay", margin(lambda m, *p: m or 1.0)),
    # -- passivity
    "is_passive: pulling walls": (
        "is_passive",
        lambda a, *rest: sh.is_passive(abs(a), *rest),
    ),
    "is_passive: principal sheet at fractions": (
        "is_passive",
        lambda *wall: sh.is_passive(*wall, sheet="principal"),
    ),
    "is_passive: a tolerance of 1e-6": (
        "is_passive",
        lambda *wall: sh.passivity_margin(*wall) >= -1e-6 * np.maximum(abs(wall[0]), wall[2]),
    ),
    "is_passive: only at theta = 0 and pi/(d + 1)": (
        "is_passive",
        lambda a, b, dl, d: (a >= 0) & (dl >= a * (d + 0.5) - b) & (dl >= a / 2 + b),
    ),
    "is_passive: positive dampings only": (
        "is_passive",
        lambda a, b, dl, d: sh.is_passive(a, np.maximum(b, 0), dl, d),
    ),
    "passivity_margin: on a grid of angles": (
        "passivity_margin",
        lambda a, b, dl, d: np.where(
            d < 20,
            np.min(
                [sh.passivity_margin_at(t, a, b, dl, d) for t in np.linspace(1e-3, PI - 1e-3, 40)],
                axis=0,
            ),
            sh.passivity_margin(a, b, dl, d),
        ),
    ),
    "passivity_margin: no -inf": (
        "passivity_margin",
        lambda *wall: np.maximum(sh.passivity_margin(*wall), -1e300),
    ),
    "passivity_margin: beta's sign for d > 8": (
        "passivity_margin",
        lambda a, b, dl, d: sh.passivity_margin(a, np.where(d > 8, -b, b), dl, d),
    ),
    "passivity_margin_at: principal sheet at fractions": (
        "passivity_margin_at",
        lambda *at: sh.passivity_margin_at(*at, sheet="principal"),
    ),
    "passivity_margin_at: degrees": (
        "passivity_margin_at",
        lambda theta, *wall: sh.passivity_margin_at(np.radians(theta), *wall),
    ),
    "passivity_boundary: principal sheet at fractions": (
        "passivity_boundary",
        lambda *at: sh.passivity_boundary(*at, sheet="principal"),
    ),
    "passivity_boundary: theta in Hz": (
        "passivity_boundary",
        lambda theta, dl, d: sh.passivity_boundary(np.clip(theta / (2 * PI), 1e-300, 3.1), dl, d),
    ),
    "max_passive_stiffness: (11) at fractions": (
        "max_passive_stiffness",
        lambda dl, d: sh.max_passive_stiffness(dl, d, sheet="principal"),
    ),
    "max_passive_stiffness: a table up to d = 100": (
        "max_passive_stiffness",
        lambda dl, d: truncated(tuple(sh.max_passive_stiffness(dl, d)), d, 100),
    ),
    "linear_limit: t_d/T without the half of the hold": (
        "linear_limit",
        lambda b, dl, d: (b + dl) / np.where(d > 0, d, 0.5),
    ),
    "linear_limit: abs(beta)": ("linear_limit", lambda b, dl, d: (abs(b) + dl) / (d + 0.5)),
    "linear_limit: integer delays only": (
        "linear_limit",
        lambda b, dl, d: (b + dl) / (np.floor(d) + 0.5),
    ),
    # -- the sampled device
    "discretize: no series next to critical damping": (
        "discretize",
        lambda g, dl: tuple(
            np.where((g > 0) & (abs(dl**2 - 4 * g) < 1e-6 * g), np.nan, v)
            for v in sh.discretize(g, dl)
        ),
    ),
    "discretize: small gamma is 0": (
        "discretize",
        lambda g, dl: sh.discretize(np.where(g < 1e-6, 0, g), dl),
    ),
    "discretize: stiff springs as overdamped": (
        "discretize",
        lambda g, dl: sh.discretize(np.minimum(g, 100.0), dl),
    ),
    "discretize: n0 as n1 for small damping": (
        "discretize",
        lambda g, dl: (lambda n1, n0, a, e: (n1, np.where(dl < 1e-3, n1, n0), a, e))(
            *sh.discretize(g, dl)
        ),
    ),
    "discretize: single precision inside": (
        "discretize",
        single(lambda g, dl: tuple(sh.discretize(g, dl))),
    ),
    "discretize_fractional: the rest for the part": (
        "discretize_fractional",
        lambda g, dl, e: sh.discretize_fractional(g, dl, np.where(e > 0, 1 - e, 0) % 1),
    ),
    "discretize_fractional: m2 and m0 exchanged": (
        "discretize_fractional",
        lambda *at: (lambda v: (v[2], v[1], v[0], v[3], v[4]))(sh.discretize_fractional(*at)),
    ),
    "characteristic_polynomial: n1 for n0 in z0": (
        "characteristic_polynomial",
        lambda a, b, g, dl: (
            *CHECKED["characteristic_polynomial"].near(a, b, g, dl)[:4],
            -sh.discretize(g, dl)[0] * b,
        ),
    ),
    # -- the paper's equations
    "eq5: without d for d > 8": ("eq5", lambda K, B, T, o, d: eq5(K, B, T, o, np.minimum(d, 8))),
    "eq5: omega in Hz": ("eq5", lambda K, B, T, o, d: eq5(K, B, T, 2 * PI * o, d)),
    "eq6: B without its sign left out": ("eq6", lambda K, B, T: K * T / 2 + B),
    "eq7: one delay less": (
        "eq7",
        lambda b, T, o, d: tuple(
            v * s
            for v, s in zip(
                sh.passivity_boundary(np.clip(o * T, 0, 3.14), b, np.maximum(d - 1, 0)),
                (1 / T, 1),
                strict=True,
            )
        ),
    ),
    "eq9: the half left out": ("eq9", lambda b, B, T, d: (b + B) / (np.maximum(d, 0.5) * T)),
    "eq11: pi as 3.14159": (
        "eq11",
        lambda b, T, d: (2 * b / T * np.tan(3.14159 / (4 * (d + 1))), eq11(b, T, d)[1]),
    ),
    "eq11: a table up to d = 8": ("eq11", lambda b, T, d: truncated(eq11(b, T, d), d, 8)),
    "eq11: NaN once": ("eq11", lambda b, T, d: seldom(eq11(b, T, d), b, T, d)),
    "eq12: arguments m and T exchanged in n1": (
        "eq12",
        lambda b, k, m, T: (
            sh.discretize(k * T**2 / m, b * T / m)[0] * m**2 / T,
            *CHECKED["eq12"].near(b, k, m, T)[1:],
        ),
    ),
    "eq24: d for t_d": ("eq24", lambda b, B, t, T: (b + B) / (t * T + T / 2)),
    "eq24: half of the delay": ("eq24", lambda b, B, t, T: (b + B) / (t / 2 + T / 2)),
    "eq28: without damping": ("eq28", lambda k, b, m: np.sqrt(k / m)),
    "eq27: beyond d = 3 the curve of d = 3": (
        "eq27",
        lambda theta, dl, d: sh.passivity_boundary(theta, dl, np.minimum(d, 3)),
    ),
    "eq14: as published": (
        "eq14",
        lambda g, dl: (lambda n1, n0, a, e: (n0, n1, a, e))(*sh.discretize(g, dl)),
    ),
}


SEARCHES = "delay_margin", "max_delay"
FEW = 100
"""Points of a first run: what it refuses, the default run of ten times as many refuses, too."""
ENOUGH = 25
"""Wrong results among those that are compared, after which the others count as right."""


@pytest.mark.parametrize("name", MUTANTS)
def test_a_wrong_implementation_is_refused_by_the_default_run(name, monkeypatch):
    """As it is where all results are compared, since none of these lowers the worst error."""
    id, function = MUTANTS[name]
    call = function if id in SEARCHES else on_arrays(function)
    wrong = []

    def first(checked, point, got):
        if len(wrong) == ENOUGH:
            return 0.0, checked.results[0]
        found = error(checked, point, got)
        wrong.extend([found] * (found[0] > 8))
        return found

    monkeypatch.setattr(compare, "error", first)
    if id not in SEARCHES and not compared(CHECKED[id], call, count=FEW, explained=False).agrees:
        return  # at some of the points, and so at all
    wrong.clear()
    found = compared(CHECKED[id], call, explained=False)
    assert not found.agrees


# -- right implementations: no false alarm -------------------------------------------------------


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("exported")
    assert symhaptic("export", "--target", "c", "-o", "c", cwd=folder).returncode == 0
    build = ["gcc", "-O2", "-shared", "-fPIC", "-o", "lib.so", "c/haptic.c", "-lm"]
    subprocess.run(build, cwd=folder, check=True)
    return folder / "lib.so"


@pytest.mark.ci
@pytest.mark.parametrize(
    "name",
    [
        *("discretize", "discretize_fractional", "characteristic_polynomial", "is_stable:bool"),
        *("unstable_roots", "stability_boundary", "max_stable_stiffness", "passivity_margin"),
        *("passivity_boundary", "max_passive_stiffness", "linear_limit"),
    ],
)
def test_exported_c_agrees(library, name):
    checked = CHECKED[name.partition(":")[0]]
    numbers = len(checked.arguments), len(checked.results)
    with Theirs("library", f"{library}:haptic_{name}", *numbers) as theirs:
        found = compared(checked, theirs)
    assert found.agrees, report.text(report.Report(found, name, 0.0))


def by_roots(alpha, beta, gamma, delta, d):
    """All roots of the polynomial by numpy.roots, as one writes it down."""
    whole = int(d)
    m2, m1, m0, a, e = map(float, sh.discretize_fractional(gamma, delta, d - whole))
    row = np.zeros(whole + 5)
    row[:3] = 1, -a, e
    row[-4:] += np.convolve([m2, m1, m0], [alpha + beta, -beta])
    return bool(np.abs(np.roots(row)).max() < 1)


ORDINARY = {
    "alpha": (-1, 10),
    "beta": (-5, 10),
    "gamma": (0.01, 9),
    "delta": (0.01, 2),
    "d": (0, 12),
}


def test_numpys_roots_are_off_next_to_the_boundary_by_a_distance_that_is_told():
    """Of ordinary devices they are right to 1000 roundings of the wall."""
    found = compared(CHECKED["is_stable"], called(by_roots), 1000, over=ORDINARY)
    assert found.agrees
    assert found.worst > 0
    said = report.text(report.Report(found, "numpy.roots", 0.0))
    assert f"wrong answers within {found.worst:.3g} ulp (" in said
    assert " relative) of the boundary; agrees" in said
    wrong = [i for i, got, error in found.looked if error > 0]
    assert all(not found.points.distance[i] > 1e-9 for i in wrong)


@pytest.mark.parametrize("id", ["eq5", "eq6", "eq7", "eq9", "eq11", "eq24", "eq25", "eq27", "eq28"])
def test_an_equation_as_published_agrees(id):
    """Those that are no misprints, evaluated by NumPy as they stand."""
    from symhaptic.check.mistakes import _print, _values

    function = _values(CHECKED[id], _print(CHECKED[id]))
    found = compared(CHECKED[id], on_arrays(lambda *at: tuple(function(list(at)))))
    assert found.agrees, report.text(report.Report(found, id, 0.0))


def test_a_count_that_is_not_told_is_counted_apart():
    """-1 is no answer: no error where a root is next to the circle, and no excuse elsewhere."""
    package = compared(CHECKED["unstable_roots"], on_arrays(sh.unstable_roots))
    assert package.agrees
    assert any('at which -1 was accepted for "not known"' in m for m in covered(package)["missing"])
    silent = compared(CHECKED["unstable_roots"], on_arrays(lambda a, *_: -1 + 0 * a))
    assert not silent.agrees


AT = (799.44, 6e-6, 1.0)
"""A stiff device next to 9 half swings in a period.  Its stiffest stable wall is hard to find."""


@pytest.mark.parametrize(
    ("share", "why"),
    [(1.0, ""), (1.001, "no damping makes a wall"), (0.5, "is stable, and stiffer")],
)
def test_a_stiffness_without_an_exact_value_is_refuted_by_walls(share, why):
    alpha = float(sh.max_stable_stiffness(*AT)[0])
    one = CHECKED["max_stable_stiffness"]
    off, _ = error(one, AT, [share * alpha, math.nan, math.nan])
    assert (off == math.inf) == bool(why)
    assert one.refutes is not None
    assert why in one.refutes(AT, [share * alpha])
    gamma, delta, d = AT
    m, T = 0.1, 0.01
    said = CHECKED["scene.max_stable_stiffness"].refutes(
        (m, delta * m / T, gamma * m / T**2, T, d), [share * alpha * m / T**2]
    )
    assert why in said
    assert bool(said) == bool(why)


# -- what is covered -----------------------------------------------------------------------------


def test_the_points_are_the_same_every_time():
    one, other = (drawn(CHECKED["is_passive"], 400) for _ in range(2))
    assert one.all == other.all
    assert one.all != drawn(CHECKED["is_passive"], 400, seed=21).all


def test_what_is_covered_is_told():
    found = compared(CHECKED["is_stable"], on_arrays(sh.is_stable))
    what = covered(found)
    assert set(what["beside"]) == {f"{10.0**-k:.0e}" for k in range(3, 13)}
    assert all(count >= 50 for count in what["beside"].values())
    assert all(what['kinds'][kind] >= 50 for kind in (
        "no delay", "fractional delays", "delays next to an integer",
        "delays above 100 periods",
        "natural frequencies above pi/T", "device damping below 1e-6", "damping next to critical",
        "omega_d T next to a multiple of pi", "no device stiffness", "no device damping",
        "negative wall stiffness", "negative wall damping",
    ))  # fmt: skip
    assert what["ranges"]["d"][1] > 1e14
    assert what["ranges"]["gamma"][1] > 1e14
    said = report.text(report.Report(found, "mine", 0.0))
    assert "covered: alpha " in said
    assert "both sides of the boundary, at relative distances: 100 at 1e-12, " in said
    data = json.loads(report.json_text(report.Report(found, "mine", 0.0)))["covered"]
    assert data["beside"]["1e-12"] == 100
    assert data["kinds"]["no delay"] == what["kinds"]["no delay"]


def test_both_sides_of_every_boundary_are_among_the_points():
    for id in ("is_stable", "unstable_roots", "is_passive"):
        points = drawn(CHECKED[id], 2000)
        beside = [p for p, far in zip(points.all, points.distance, strict=True) if far == far]
        values = [exact(CHECKED[id], p)[0][0] for p in beside]
        assert len(beside) >= 200
        if id != "unstable_roots":
            assert values.count(True) == values.count(False)


def test_what_is_not_covered_is_told():
    found = compared(CHECKED["eq11"], on_arrays(eq11))
    assert (
        "not covered: fractional delays: the published equation is for integer ones"
        in report.text(report.Report(found, "mine", 0.0))
    )
    found = compared(CHECKED["is_stable"], on_arrays(sh.is_stable), count=300, over={"d": (0, 0)})
    assert {"integer delays", "fractional delays"} <= set(covered(found)["missing"])


@pytest.mark.parametrize(("turns", "delta"), [(1, 2.0), (3, 5.0), (0, 2.0), (1.3, 2.0)])
def test_swings_of_whole_half_turns_are_counted_as_such(turns, delta):
    """omega_d T = sqrt(gamma - delta^2/4) is a multiple of pi; none at all is no swing."""
    gamma = (turns * PI) ** 2 + delta**2 / 4
    ends = {"gamma": (gamma, gamma), "delta": (delta, delta)}
    found = compared(CHECKED["discretize"], on_arrays(sh.discretize), count=20, over=ends)
    kinds = covered(found)["kinds"]
    hit = found.called if turns in (1, 3) else 0
    assert kinds.get("omega_d T next to a multiple of pi", 0) == hit
