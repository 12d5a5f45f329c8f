"""`certified=True` is right or says that it cannot tell; the default errs on the safe side."""

from fractions import Fraction

import flint
import numpy as np
import pytest

from symhaptic import (
    LowPass,
    Scene,
    is_passive,
    is_stable,
    passivity_margin,
    stability_boundary,
    unstable_roots,
)
from symhaptic.balls import implicit, winding
from symhaptic.numeric import certified, compiled

LIMIT = 0.8284271247461901  # 2 (sqrt(2) - 1): the wall of largest stiffness of a free mass


def near(count, seed):
    """Walls of devices of all kinds, a part in 1e14 to 1e10 inside or outside of the boundary."""
    rng = np.random.default_rng(seed)
    kind = rng.integers(0, 4, count)
    turns = (np.pi * rng.integers(1, 12, count) * (1 + 10.0 ** rng.uniform(-14, -1, count))) ** 2
    gamma = np.choose(
        kind, [rng.uniform(0, 1e-3, count), 0, turns, 10 ** rng.uniform(-8, 2, count)]
    )
    delta = np.where(kind == 1, 0.0, 10.0 ** rng.uniform(-14, 1, count))
    delay = np.floor(10.0 ** rng.uniform(0, 4, count)) - 1
    delay += np.where(rng.random(count) < 0.35, rng.random(count), 0.0)
    theta = (
        rng.uniform(1e-3, 0.999, count) * np.pi / np.where(rng.random(count) < 0.7, delay + 1, 1)
    )
    off = rng.choice([-1, 1], count) * 10.0 ** rng.uniform(-14, -10, count)
    alpha, beta = stability_boundary(theta, gamma, delta, delay)
    rows = alpha * (1 + off), beta * (1 + off * rng.random(count)), gamma, delta, delay
    good = np.isfinite(alpha + beta) & (abs(alpha) < 1e60) & (abs(beta) < 1e60)
    return [a[good] for a in rows]


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_what_is_stable_by_default_is_stable(kind):
    """Also of float32 numbers, which are judged in double precision."""
    rows = [a.astype(kind) for a in near(2000, 3)]
    with np.errstate(over="ignore"):
        said, counts = is_stable(*rows), unstable_roots(*rows)
    sure = unstable_roots(*rows, certified=True)
    assert np.all(sure[said] == 0)
    assert np.array_equal(sure[counts >= 0], counts[counts >= 0])
    assert (sure >= 0).sum() > (counts >= 0).sum()


def test_certified_verdicts_are_those_of_the_balls():
    rows = near(300, 4)
    exact = [winding.stable(*wall) for wall in zip(*(a.tolist() for a in rows), strict=True)]
    keep = np.array([e is not None for e in exact])
    found = is_stable(*(a[keep] for a in rows), certified=True)
    assert found.tolist() == [e for e in exact if e is not None]


def test_without_a_compiler_the_balls_count_alone(monkeypatch):
    rows = [a[:50] for a in near(100, 5)]
    one = unstable_roots(*rows, certified=True)
    monkeypatch.setattr(certified, "MODULE", None)
    assert np.array_equal(unstable_roots(*rows, certified=True), one)
    assert compiled.MODULE is None or np.array_equal(one >= 0, np.ones(len(one), dtype=bool))


def test_last_places_of_a_limit_are_told_apart():
    alpha = 0.6862915010152396  # 12 - 8 sqrt(2) = 0.68629150101523960...
    below, above = np.nextafter(alpha, 0), np.nextafter(alpha, 1)
    assert is_stable([below, above], LIMIT, 0.0, 0.0, 0, certified=True).tolist() == [True, False]


def test_what_no_precision_tells_is_named(monkeypatch):
    monkeypatch.setattr(winding, "BITS", (20,))
    with pytest.raises(ArithmeticError, match=r"alpha=0\.6862915.*1 of 2 loops.*certified=True"):
        is_stable([0.6862915010152396, -1.0], LIMIT, 0.0, 0.0, 0, certified=True)
    assert unstable_roots(0.6862915010152396, LIMIT, 0.0, 0.0, 0, certified=True) == -1


def test_nan_is_not_stable_and_has_no_count():
    wall = [np.nan, 0.5], 1.0, 0.0, 0.0, 0
    assert is_stable(*wall, certified=True).tolist() == [False, True]
    assert unstable_roots(*wall, certified=True).tolist() == [-1, 0]
    assert unstable_roots([[0.5]], [1.0], 0.0, 0.0, 0, certified=True).shape == (1, 1)
    assert is_stable([], 1.0, 0.0, 0.0, 0, certified=True).shape == (0,)


def test_the_principal_sheet_is_certified_for_integers():
    wall = 0.5, 1.0, 0.0, 0.0
    assert is_stable(*wall, 0, "principal", certified=True)
    with pytest.raises(ValueError, match=r"certified: .*sheet='principal'.*give sheet='exact'"):
        is_stable(*wall, 0.5, "principal", certified=True)


def passive_walls(count, seed):
    rng = np.random.default_rng(seed)
    delay = rng.integers(0, 9, count) + np.where(rng.random(count) < 0.4, rng.random(count), 0.0)
    alpha, beta = rng.uniform(0, 1, count) ** 3, rng.uniform(-0.3, 1, count)
    need = -passivity_margin(alpha, beta, 0.0, delay)
    need = np.where(need > 0, need, 1.0)
    off = rng.choice([-1, 1], count) * 10.0 ** rng.uniform(-16.5, -13, count)
    return alpha, beta, need * (1 + off), delay


def exact_margin(alpha, beta, delta, delay):
    with flint.ctx.workprec(200):
        return implicit.passivity_margin(alpha, beta, delta, delay)[0]


def test_what_is_passive_is_passive():
    """Of all walls next to the boundary, and the kernel is far more exact than is relied on."""
    rows = passive_walls(400, 6)
    margins = [exact_margin(*wall) for wall in zip(*(a.tolist() for a in rows), strict=True)]
    truth = [True if m > 0 else False if m < 0 else None for m in margins]
    keep = np.array([t is not None for t in truth])
    expected = [t for t in truth if t is not None]
    assert is_passive(*(a[keep] for a in rows)).tolist() == expected
    assert is_passive(*(a[keep] for a in rows), certified=True).tolist() == expected
    alpha, beta, delta, delay = rows
    off = abs(passivity_margin(*rows) - np.array([float(m.mid()) for m in margins]))
    assert np.max(off / (alpha * (delay + 1) + abs(beta) + delta)) < 8 * 2.0**-53


def test_a_margin_of_zero_is_passive_where_it_is_known():
    assert is_passive(2.0, 0.0, 1.0, 0)
    assert is_passive([0.25, 0.25], [-0.5, 0.5], 0.625, 0.0, certified=True).all()
    assert not is_passive(np.nan, 0.0, 1.0, 0, certified=True)
    assert not is_passive(np.nextafter(2, 3), 0.0, 1.0, 0)


def test_a_margin_as_small_as_a_last_place_of_balls_has_its_sign():
    """By (5) alpha = 1 needs 3/2 one period late: 1/2 + cos(theta) is largest at theta = 0."""
    for tiny in (2.0**-100, 2.0**-150, 2.0**-400):
        assert is_passive([1.0, 1.0], [tiny, -tiny], 1.5, 1).tolist() == [True, False]


@pytest.mark.parametrize(
    ("wall", "end"),
    [
        ((0.5352795347115132, 0.42163321858412384, 1.2615436732442804, 2.61947719933489), 1),
        ((0.9164497715796742, 0.18581027904274672, 0.8762578983058045, 0.5959336620293743), 1),
        ((4.7419643878678254e-05, 8.00047146121685e-14, 2.3709821979341478e-05,
          1.687163982640032e-09), -1),
    ],
)  # fmt: skip
def test_a_wall_that_gains_energy_at_an_end_of_the_circle_is_decided(wall, end):
    """The energy that is lost, times 4 delta, at the angle 0 or pi, in fractions.

    With the wall W = alpha + beta (1 - 1/z) and the part f of a period this is
    4 delta (delta + Re((1 - f (1 - 1/z)) W z^-l/(z - 1))) - f (1 - f) |W|^2.
    """
    alpha, beta, delta, delay = map(Fraction, wall)
    part = delay % 1
    if end == 1:  # at z = 1 the real part is beta - alpha (d + 1/2), at -1 it is that of W/(z - 1)
        left, size = delta + beta - alpha * (delay + Fraction(1, 2)), alpha
    else:
        assert delay < 1
        left, size = delta - (1 - 2 * part) * (alpha + 2 * beta) / 2, alpha + 2 * beta
    assert 4 * delta * left < part * (1 - part) * size**2
    assert not is_passive(*wall, certified=True)


def test_a_scene_is_judged_by_its_decimals():
    """No number is rounded: 0.1 kg is a tenth."""
    scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
    K = [np.nextafter(1000, 0), 1000.0, np.nextafter(1000, 2000)]
    assert scene.is_passive(K, 0.0, certified=True).tolist() == [True, True, False]
    delayed = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.0015)
    wall = (Fraction(250) / 10**5, Fraction(1, 100), 0, Fraction(5, 1000), Fraction(3, 2))
    exact = winding.stable(*(flint.fmpq(n.numerator, n.denominator) for n in map(Fraction, wall)))
    assert delayed.is_stable(250.0, 1.0, certified=True) is exact
    assert delayed.is_stable("250 N/m", "1 N*s/m", certified=True) is exact
    assert delayed.is_stable([250.0, np.nan], 1.0, certified=True).tolist() == [exact, False]


def test_a_scene_with_more_than_a_delay_is_refused():
    scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, velocity=LowPass(cutoff=100.0))
    with pytest.raises(ValueError, match="certified: True is not allowed for a loop with a filter"):
        scene.is_stable(100.0, 1.0, certified=True)


def test_a_wall_that_is_clearly_passive_or_not_needs_no_balls(monkeypatch):
    """They take a thousand times as long."""

    def none(*_):
        pytest.fail("asked in balls")

    monkeypatch.setattr(certified, "passive", none)
    assert is_passive([1.9, 2.1], 0.0, 1.0, 0).tolist() == [True, False]
    assert is_passive(1.9, 0.0, 1.0, 0)


def test_a_free_mass_is_judged_by_its_closed_form():
    """Beside Jury's table in fractions, up to last places from the boundary and to its corners."""
    rng = np.random.default_rng(8)
    beta = np.concatenate([rng.uniform(0, 2, 300), 10 ** rng.uniform(-300, 0, 100), [2.0, -0.0]])
    alpha = 2 * beta * (2 - beta) / (2 + beta)
    alpha *= 1 + rng.choice([-1, 1], beta.size) * 10 ** rng.uniform(-16, 0, beta.size)
    alpha[:50] = np.nextafter(alpha[:50], rng.choice([-1, 9], 50))
    odd = [-1.0, -0.0, 0.0, 5e-324, 1e-30, 1e70, np.nan]
    alpha, beta = np.concatenate([alpha, odd, np.full(7, 0.1)]), np.concatenate([beta, odd, odd])
    said = is_stable(alpha, beta, 0.0, 0.0, 0.0)
    assert np.array_equal(said, [is_stable(*wall, 0.0, 0.0, 0.0) for wall in zip(
        alpha.tolist(), beta.tolist(), strict=True)])  # fmt: skip
    for verdict, a, b in zip(said.tolist(), alpha.tolist(), beta.tolist(), strict=True):
        exact = np.isfinite(a + b) and a > 0 and b > 0 and (
            2 * Fraction(b) * (2 - Fraction(b)) - Fraction(a) * (2 + Fraction(b)) > 0
        )  # fmt: skip
        assert not verdict or exact
        if 1e-60 < b < 2 and abs(a * (2 + b) / (2 * b * (2 - b)) - 1) > 1e-12:
            assert verdict == exact
    with pytest.raises(ValueError, match=r"^alpha: inf is not allowed"):
        is_stable([0.1, np.inf], 0.5, 0.0, 0.0, 0.0)
