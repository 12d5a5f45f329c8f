"""The filter is certain only of what is so: its rules, constants, verdicts and delay margins."""

import ctypes
import operator
import shutil
import subprocess
from fractions import Fraction
from math import factorial
from pathlib import Path

import flint
import numpy as np
import pytest
from flint import arb, arb_series
from hypothesis import given
from hypothesis import strategies as st

import symhaptic
from symhaptic.balls import closed, winding

pytestmark = pytest.mark.ci

ufuncs = pytest.importorskip(
    "symhaptic.kernels._compiled", reason="the install found no compiler", exc_type=ImportError
)

KERNELS = Path(symhaptic.__file__).parent / "kernels"
FLAGS = ["-std=c++17", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared", "-Wall",
         "-Werror", f"-I{KERNELS}"]  # fmt: skip
UNIT = Fraction(1, 2**53)

HARNESS = """
#include "delay.cpp"
using namespace filter;
extern "C" {
void rule(int which, const double *x, double *out) {
    const Ball a = {x[0], x[1]}, b = {x[2], x[3]};
    const Ball found = which == 0 ? a + b : which == 1 ? a - b : which == 2 ? a*b
                     : which == 3 ? x[0]*b : which == 4 ? a/b : root(a);
    out[0] = found.v, out[1] = SLACK*found.e;
}
void sampled(double gamma, double delta, double part, double *out) {
    const Device x = part > 0 ? device<true>(gamma, delta, part) : device<false>(gamma, delta, 0);
    const Ball all[] = {x.force, x.apart, x.sums, x.gap, x.both, x.loss, x.far};
    for (int i = 0; i < 7; ++i) out[2*i] = all[i].v, out[2*i + 1] = SLACK*all[i].e;
}
void part(double gamma, double delta, double middle, double half, double *out) {
    const Part p = part_of({0, 0, gamma, delta, false, {}}, middle, half);
    const Ball all[] = {p.x.sums, p.x.gap, p.x.both, p.x.apart, p.gap, p.cross, p.tilt, p.twist};
    for (int i = 0; i < 8; ++i) out[2*i] = all[i].v, out[2*i + 1] = SLACK*all[i].e;
}
double angle(double up, double along) { return arctangent(up, along); }
void all(int n, const double *x, double *out, int fraction, int once) {
    Block b;
    for (int i = 0; i < n; ++i) {
        b.alpha[i] = x[i], b.beta[i] = x[BLOCK + i], b.gamma[i] = x[2*BLOCK + i];
        b.delta[i] = x[3*BLOCK + i], b.steps[i] = x[4*BLOCK + i], b.part[i] = x[5*BLOCK + i];
    }
    counted(b, n, fraction, once);
    for (int i = 0; i < n; ++i) out[i] = b.found[i];
}
}
"""


def built(folder, *flags):
    """The filter as a library with its rules in reach."""
    if shutil.which("g++") is None:
        pytest.skip("no g++")
    source, library = folder / "harness.cpp", folder / f"filter{len(flags)}.so"
    source.write_text(HARNESS)
    files = [source, KERNELS / "filter.cpp"]
    subprocess.run(["g++", *FLAGS, *flags, *files, "-o", library], check=True)
    found = ctypes.CDLL(str(library))
    found.angle.restype = ctypes.c_double
    return found


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    return built(tmp_path_factory.mktemp("filter"))


def doubles(*numbers):
    return (ctypes.c_double * len(numbers))(*numbers)


number = st.floats(-(2.0**60), 2.0**60).filter(lambda x: x == 0 or abs(x) > 2.0**-60)
share = st.sampled_from([0.0, 2.0**-53, 2.0**-30, 0.5, 3.0])


@given(st.integers(0, 4), number, share, number, share, st.booleans())
def test_each_rule_encloses_all_results(library, which, a, off_a, b, off_b, near):
    """The extreme results of a sum or product are those of the ends."""
    b = -a * (1 + 2.0**-50) if near else b  # sums that cancel
    off_a = 0.0 if which == 3 else off_a  # a plain double
    x = [a, off_a * abs(a), b, off_b * abs(b)]
    out = doubles(0, 0)
    library.rule(which, doubles(*x), out)
    if which == 4 and not abs(x[2]) > x[3]:  # the divisor may be zero
        assert not out[1] < np.inf
        return
    value, off = map(Fraction, out)
    ways = operator.add, operator.sub, operator.mul, operator.mul, operator.truediv
    for p in (Fraction(x[0]) - Fraction(x[1]), Fraction(x[0]) + Fraction(x[1])):
        for q in (Fraction(x[2]) - Fraction(x[3]), Fraction(x[2]) + Fraction(x[3])):
            assert abs(ways[which](p, q) - value) <= off


@given(number.map(abs), st.sampled_from([0.0, 2.0**-53, 0.5, 0.999, 1.0, 3.0]))
def test_a_root_encloses_all_results(library, a, off):
    out = doubles(0, 0)
    library.rule(5, doubles(a, off * a, 0, 0), out)
    if a == 0 or off >= 1:
        assert not out[1] < np.inf
        return
    value, wide = map(Fraction, out)
    below, above = Fraction(a) - Fraction(off * a), Fraction(a) + Fraction(off * a)
    assert max(value - wide, 0) ** 2 <= below
    assert above <= (value + wide) ** 2


def test_the_bounds_of_the_series_cover_roundings_and_remainder():
    """With 2 delta + gamma = 4 share <= 4 each term y_k, k > 2, is at most share 2^(k-2)/k!.

    A term has 4 roundings more than its predecessor; its power of the time has at most 2 k - 3, and
    the two products with it and with k have 3.  Each of the 22 sums rounds once, and its size is at
    most that of all terms together.
    """
    terms = 24

    def size(k):
        return Fraction(2 ** (k - 2), factorial(k))

    for speed, (plain, more) in ((False, (16, 32)), (True, (32, 96))):
        weigh = [Fraction(k if speed else 1) for k in range(60)]
        roundings = [4 * (k - 2) + 2 * k - 3 + 3 for k in range(60)]
        rest = sum(weigh[k] * size(k) for k in range(terms + 1, 60)) * Fraction(1001, 1000)
        kept = sum(weigh[k] * size(k) for k in range(3, terms + 1))
        lost = sum(weigh[k] * size(k) * roundings[k] for k in range(3, terms + 1))
        compounded = Fraction(1001, 1000)  # (1 + UNIT)^200 - 1 <= 200.1 UNIT
        first = weigh[2] * size(2) * (roundings[2] + terms - 2)
        assert compounded * first <= plain
        assert compounded * (lost + (terms - 2) * kept) + rest / UNIT <= more


fraction_of = st.floats(0, 1).filter(lambda x: x == 0 or x > 2.0**-59)


@given(fraction_of.map(lambda x: 4 * x), fraction_of, st.floats(0, 0.999))
def test_the_device_is_enclosed(library, gamma, share, part):
    delta = share * (4 - gamma) / 2 if gamma < 3.99 else 0.0
    out = doubles(*[0] * 14)
    library.sampled(ctypes.c_double(gamma), ctypes.c_double(delta), ctypes.c_double(part), out)
    with flint.ctx.workprec(200):
        x = winding.plant(gamma, delta, arb(part))
        m2, m1, m0 = (x.m2, x.m1, x.m0) if part > 0 else (*closed.device(gamma, delta)[:2], arb(0))
        exact = [x.force, m2 - m1 + m0, m2 + m0, m2 - m0, m2 * m0, x.loss, 1 + x.a + x.e]
        for value, off, right in zip(out[::2], out[1::2], exact, strict=True):
            assert abs(right - value) <= off
            assert off < 1e-12  # and narrow


def test_the_arctangent_is_as_close_as_it_says(library):
    """The polynomial in balls on pieces of (0, 1), and its roundings by Horner's bound."""
    text = (KERNELS / "filter.h").read_text()
    row = text.split("double ATAN[] = {")[1].split("}")[0]
    terms = [float(term) for term in row.split(",")]
    said = 2.0**-46
    worst, pieces, order = arb(0), 512, 8
    with flint.ctx.workprec(200):
        for k in range(pieces):
            middle, half = arb(2 * k + 1) / (2 * pieces), arb(1) / (2 * pieces)

            def missed(at):
                x = arb_series([at, 1], prec=order + 1)
                square, total = x * x, arb_series([0], prec=order + 1)
                for c in reversed(terms):
                    total = total * square + arb(c)
                return x * total - x.atan()

            flint.ctx.cap = order + 1
            near, over = missed(middle), missed(middle + arb(0, half))
            off = sum((abs(near[i]) * half**i for i in range(order)), arb(0))
            worst = max(worst, (off + abs(over[order]) * half**order).upper(), key=float)
    roundings = sum((2 * i + 4) * abs(Fraction(c)) for i, c in enumerate(terms)) * UNIT
    # the quotient moves the angle by UNIT; pi/2, pi and what is taken from them round to 8 UNIT
    assert worst + arb(float(roundings)) + 9 * 2.0**-53 < said
    rng = np.random.default_rng(3)
    for up, along in rng.normal(size=(500, 2)) * 10.0 ** rng.integers(-9, 9, (500, 1)):
        angle = library.angle(ctypes.c_double(up), ctypes.c_double(along))
        assert abs(arb.atan2(arb(up), arb(along)) - angle) < said


def walls(count, seed):
    """Ordinary devices and such that are slow to 2 delta + gamma = 4, with walls at all distances
    from the boundary, a third behind a fraction of a period."""
    rng = np.random.default_rng(seed)
    share, gamma = rng.uniform(0, 1, (2, count))
    small = 10.0 ** rng.uniform(-6, 0, count)
    gamma, delta = 4 * gamma * small, 2 * (1 - gamma) * share * small
    gamma = np.where(rng.random(count) < 0.2, 0.0, gamma)
    delta = np.where(rng.random(count) < 0.2, 0.0, delta)
    delay = np.floor(10.0 ** rng.uniform(-1, 2, count))
    delay += np.where(rng.random(count) < 0.33, rng.random(count), 0.0)
    theta = rng.uniform(1e-3, 1, count) * np.pi / (delay + 1)
    alpha, beta = symhaptic.stability_boundary(theta, gamma, delta, delay)
    off = 1 + rng.choice([-1, 1], count) * 10.0 ** rng.uniform(-16, 0.3, count)
    free = rng.random(count) < 0.2
    alpha = np.where(free, rng.normal(size=count), alpha * off)
    return alpha, np.where(free, rng.normal(size=count), beta * off), gamma, delta, delay


def test_what_is_certain_is_so():
    rows = walls(3000, 8)
    found = ufuncs.certain_roots(*rows)
    assert np.mean(found != -1) > 0.7
    for said, *wall in zip(found.tolist(), *(a.tolist() for a in rows), strict=True):
        exact = winding.unstable(*wall) if said != -1 else None
        if exact is not None:
            assert said == exact if said >= 0 else exact > 0, wall


@pytest.mark.parametrize("fraction", [False, True])
def test_bits_depend_neither_on_the_place_nor_on_the_instructions(library, tmp_path, fraction):
    alpha, beta, gamma, delta, delay = walls(2000, 9)
    some = np.flatnonzero((delay != np.floor(delay)) == fraction)[:256]
    steps = np.floor(delay)
    rows = np.zeros((6, 256))
    rows[:, : some.size] = [a[some] for a in (alpha, beta, gamma, delta, steps, delay - steps)]

    def counts(filter_, order):
        x, out = np.ascontiguousarray(rows[:, order]), np.zeros(256)
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (x, out)]
        filter_.all(256, *pointers, int(fraction), 0)
        return out

    first = counts(library, np.arange(256))
    turned = np.random.default_rng(1).permutation(256)
    assert np.array_equal(counts(library, turned), first[turned])
    plain = built(tmp_path, "-DONE_SET", "-fno-tree-vectorize")
    assert np.array_equal(counts(plain, np.arange(256)), first)


def test_one_device_is_as_many(library):
    rng = np.random.default_rng(4)
    alpha, beta = rng.uniform(0, 0.5, (2, 1000))
    for delay in (2.0, 2.3):
        found = ufuncs.certain_roots(alpha, beta, 1e-3, 0.01, delay)
        apart = ufuncs.certain_roots(alpha, beta, *(np.full(1000, v) for v in (1e-3, 0.01, delay)))
        assert np.array_equal(found, apart)
        assert np.all(found >= 0)


slow_gamma = fraction_of.map(lambda x: 4 * x)


@given(slow_gamma, fraction_of, st.sampled_from([1, 4, 16]), st.integers(0, 15), st.floats(0, 1))
def test_a_part_of_the_period_encloses_the_device_at_all_its_delays(
    library, gamma, share, cut, at, inside
):
    """The device is that of the balls, its slopes are differences over 1e-40 of a period."""
    delta = share * (4 - gamma) / 2 if gamma < 3.99 else 0.0
    half = 0.5 / cut
    middle = half * (2 * (at % cut) + 1)
    out, arguments = doubles(*[0] * 16), (gamma, delta, middle, half)
    library.part(*map(ctypes.c_double, arguments), out)
    with flint.ctx.workprec(600):
        part, step = arb(middle) + arb(half) * (2 * arb(inside) - 1), arb(10) ** -40

        def numbers(part):
            x = winding.plant(gamma, delta, part)
            sums, gap = x.m2 + x.m0, x.m2 - x.m0
            both, apart = x.m2 * x.m0, x.m2 - x.m1 + x.m0
            return sums, gap, both, apart, gap * gap - x.force * sums

        now, before, after = (numbers(part + k * step) for k in (0, -1, 1))
        slope = [(b - a) / (2 * step) for a, b in zip(before, after, strict=True)]
        twist = slope[0] * now[1] - slope[1] * now[0]
        exact = *now[:4], slope[1], now[4], slope[4], twist
        for value, off, right in zip(out[::2], out[1::2], exact, strict=True):
            assert abs(right - value) <= off + 1e-30


def loops(count, seed):
    """Loops at all distances from instability without delay and from the spring's stiffness."""
    alpha, beta, gamma, delta, _ = walls(4 * count, seed)
    rng = np.random.default_rng(seed)
    beside = rng.random(alpha.size) < 0.2
    near = gamma * (1 + rng.choice([-1, 1], alpha.size) * 10.0 ** rng.uniform(-14, -1, alpha.size))
    alpha = np.where(beside, near, alpha * 10.0 ** rng.uniform(-4, 0, alpha.size))
    beta = np.where(beside, 10.0 ** rng.uniform(-3, 0, alpha.size), beta)
    good = symhaptic.is_stable(alpha, beta, gamma, delta, 0)
    return [a[good][:count] for a in (alpha, beta, gamma, delta)]


def test_delay_margins_are_those_of_the_balls():
    rows = loops(150, 1)
    found = ufuncs.max_delay(*rows)
    assert np.mean(~np.isnan(found)) > 0.6
    seen = 0
    for most, *loop in zip(found.tolist(), *(a.tolist() for a in rows), strict=True):
        exact = winding.largest_delay(*loop, most=1e3) if most == most else None
        if exact is None or (most > 1e3 and not np.isinf(most)):
            continue
        seen += 1
        near = arb(most) if np.isinf(most) else arb(most, 2e-14 * (1 + most))
        assert exact == near if np.isinf(most) else near.overlaps(exact), loop
    assert seen > 60


HARD_LOOPS = [
    (5e-324, 0.1, 0.0, 0.0), (1e-300, 1e-300, 0.0, 1e-3), (1e300, 0.1, 0.0, 0.0),
    (0.01, 1e70, 0.0, 0.0), (np.inf, 0.1, 0.0, 0.0), (np.nan, 0.1, 0.0, 0.0),
    (-0.0, 0.1, 0.0, 0.1), (0.01, 0.05, -0.0, -0.0), (0.01, -0.0, 0.0, 0.5),
    (1e-3, 0.1, 1e-3, 0.1), (0.6862915010152394, 0.8284271247461901, 0.0, 0.0),
    (1e-12, 2e-6, 0.0, 0.0), (0.3, 0.1, 4.0, 0.0), (0.3, 0.1, 39.5, 1e-9), (0.1, 0.1, 0.0, 2.0),
    (0.01, 0.05, 5e-324, 0.0), (0.01, 0.05, 0.0, 5e-324), (0.1, -0.1, 0.0, 0.5),
]  # fmt: skip


@pytest.mark.parametrize("loop", HARD_LOOPS)
def test_hard_loops_get_the_balls_answer_or_none(loop):
    found = float(ufuncs.max_delay(*loop))
    if not np.all(np.isfinite(loop)):
        assert np.isnan(found)
    elif found == found:
        exact = winding.largest_delay(*loop, most=1e4)
        if found > 1e4 and np.isfinite(found):
            sides = [winding.stable(*loop, found * (1 + off)) for off in (-1e-9, 1e-9)]
            assert sides == [True, False]
        else:
            near = arb(found, 2e-14 * (1 + found)) if np.isfinite(found) else arb("inf")
            assert near.overlaps(exact)
        delays = np.array([0.0, found / 3, 0.999 * found, 1.01 * found + 0.1, 1e6, 1e15])
        margins = ufuncs.delay_margin(*loop, delays)
        for delay, margin in zip(delays.tolist(), margins.tolist(), strict=True):
            if delay < found:
                assert margin == found - delay
            elif margin == margin:
                assert margin == 0
                assert winding.stable(*loop, delay) is not True
    assert np.isnan(ufuncs.delay_margin(*loop, -1.0))
    assert np.isnan(ufuncs.delay_margin(*loop, np.nan))


def test_margins_do_not_depend_on_the_place_in_the_array():
    rows = loops(500, 5)
    turned = np.random.default_rng(2).permutation(rows[0].size)
    found, again = ufuncs.max_delay(*rows), ufuncs.max_delay(*(a[turned] for a in rows))
    assert np.array_equal(found[turned], again, equal_nan=True)
    one = [ufuncs.one_max_delay(*map(float, loop)) for loop in zip(*rows, strict=True)]
    assert np.array_equal([np.nan if o is None else o for o in one], found, equal_nan=True)
