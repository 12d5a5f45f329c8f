r"""The entire functions of the device as routines: where each form keeps its digits.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  Near p = q = 0 a power
series is used, beyond it closed forms that subtract no two nearly equal numbers:

    n1 = (Decay(q) - exp(-q) Decay(p - q))/p,   n0 = exp(-q) (Decay(p - q) - exp(-(p-q)) Decay(q))/p

for a creeping device, and those of cos and sin of sqrt(gamma - delta^2/4) for a swinging one.
The poles are kept to twice the precision of a float, since exp(-q) magnifies their error by q.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Max, cos, exp, factorial, sin, sqrt

from symhaptic.export.elementary import half_and
from symhaptic.export.routine import (
    ProductError,
    Routine,
    Steps,
    choose,
    difference,
    expm1,
    fast_sum,
    product,
    quotient,
)
from symhaptic.model.entire import Decay, S
from symhaptic.notation import delta, gamma

NEAR = sp.Rational(9, 4)
"""Up to this size of the larger real pole power series are used."""

FAR = sp.Rational(8, 3)
"""The same for a series whose terms have all one sign."""

STIFF = sp.Integer(4)
"""Up to this gamma, the squared size of complex poles."""

TERMS = 34
"""Their terms: the next one is below 35 FAR^34/36! = 3e-26."""

_CAREFUL = 4
"""Last terms of a series with signs that are added up to twice the precision."""

w, h = sp.symbols("w h")


# -- the motion: w = delta^2/4 - gamma and both poles, to twice the precision -----------------


@dataclass(frozen=True)
class Motion:
    """What the functions of gamma and delta share, as names of steps."""

    half: Expr
    """delta/2."""
    w: Expr
    root: Expr
    """sqrt |w|."""
    root_low: Expr
    """Its rounding error."""
    some: Expr
    """The root, or 1 where it is 0."""
    p: Expr
    whole: Expr
    """The same, or 1 where it is 0."""
    p_low: Expr
    q: Expr
    q_low: Expr
    small: Expr
    """Whether the power series serve."""


def motion(do: Steps, near: Expr = NEAR) -> Motion:
    """The steps that find it."""
    half = do("half", delta / 2)
    square = do("square", half * half)
    most, lost = difference(do, square, gamma)
    rest = do("rest", lost + ProductError(half, half))
    value, low = fast_sum(do, most, rest)
    size = do("size", sp.Abs(value))
    root = do("root", sqrt(size))
    sign_low = do("sign_low", choose(value < 0, -low, low))
    left = do("left", size - root * root)
    left = do("left", left - ProductError(root, root))
    left = do("left", left + sign_low)
    some = do.nonzero(root)
    root_low = do("root_low", left / some / 2)
    p, p_lost = fast_sum(do, half, root)
    p_low = do("p_low", p_lost + root_low)
    whole = do.nonzero(p)
    q = do("q", gamma / whole)
    off = do("off", gamma - whole * q)
    off = do("off", off - ProductError(whole, q))
    off = do("off", off - q * p_low)
    q_low = do("q_low", off / whole)
    do.share("Motion", "w = delta^2/4 - gamma and both poles, to twice the precision of a float")
    reach = do("reach", choose(value < 0, gamma / STIFF, p / near))
    small = reach < 1
    return Motion(half, value, root, root_low, some, p, whole, p_low, q, q_low, small)


@dataclass(frozen=True)
class Creeping:
    """exp(-q), Decay(q), Decay(p - q) and exp(-(p - q)), the quotients with what they miss."""

    fall: Expr
    ratio: Expr
    slow: Expr
    slow_low: Expr
    between: Expr
    between_low: Expr


def _creeping(do: Steps, m: Motion) -> Creeping:
    fall = do("fall", exp(-m.q))
    fall = do("fall", fall - fall * m.q_low)
    apart, apart_low = 2 * m.root, 2 * m.root_low
    ratio = do("ratio", exp(-apart))
    ratio = do("ratio", ratio - ratio * apart_low)
    slow = _decay(do, m.q, m.q_low, fall)
    return Creeping(fall, ratio, *slow, *_decay(do, apart, apart_low, ratio))


def _decay(do: Steps, rate: Expr, low: Expr, fall: Expr) -> tuple[Expr, Expr]:
    """(1 - exp(-rate))/rate and what the float misses."""
    whole = do.nonzero(rate)
    none = do("none", whole - rate)  # 1 where the rate is 0
    top = do("top", none - expm1(-rate))
    total, lost = quotient(do, top, whole, low * fall, low)
    return total, lost


@dataclass(frozen=True)
class Swinging:
    """exp(-delta/2), cos(root) and (delta/2) sin(root)/root, with what these two miss."""

    envelope: Expr
    even: Expr
    even_low: Expr
    odd: Expr
    odd_low: Expr


def _swinging(do: Steps, m: Motion) -> Swinging:
    sine, cosine = do("sine", sin(m.root)), do("cosine", cos(m.root))
    low = do("low", -m.root_low * sine)
    top, top_low = product(do, m.half, sine, m.root_low * cosine)
    odd = quotient(do, top, m.some, top_low, m.root_low)
    return Swinging(do("envelope", exp(-m.half)), cosine, low, *odd)


def rise() -> Routine:
    """n_1."""
    do = Steps()
    m = motion(do, FAR)
    c = _creeping(do, m)
    pulled, pulled_low = product(do, c.fall, c.between, c.between_low)
    top, top_low = difference(do, c.slow, pulled)
    short, missed = quotient(do, top, m.whole, top_low + (c.slow_low - pulled_low), m.p_low)
    long = (1 - c.fall * (1 + m.q * c.between)) / do.nonzero(gamma)
    v = _swinging(do, m)
    swing = (1 - v.envelope * (v.even + v.odd + v.even_low)) / Max(gamma, STIFF)
    far = choose(m.w < 0, swing, choose(m.q < 2, short + missed, long))
    given = choose(sp.Not(m.small), 0, m.half), choose(sp.Not(m.small), 0, m.w)
    near = half_and(do, exp(-m.half), "RiseSeries", *given)
    return do.routine("Rise", "n1, how far a unit force moves the device in a period",
                      (gamma, delta), choose(m.small, near, far))  # fmt: skip


def fall() -> Routine:
    """n_0."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    pulled, pulled_low = product(do, c.ratio, c.slow, c.slow_low)
    top, top_low = difference(do, c.between, pulled)
    rest, missed = quotient(do, top, m.whole, top_low + (c.between_low - pulled_low), m.p_low)
    creep, lost = product(do, c.fall, rest, missed)
    creep = do("creep", creep + lost)
    v = _swinging(do, m)
    top, top_low = difference(do, v.odd, v.even)
    top, lost = difference(do, top, -v.envelope)
    top, top_low = product(do, v.envelope, top, lost + (top_low + v.odd_low - v.even_low))
    stiff = do("stiff", Max(gamma, STIFF))
    swing, missed = quotient(do, top, stiff, top_low)
    given = choose(sp.Not(m.small), 0, gamma), choose(sp.Not(m.small), 0, delta)
    near = half_and(do, exp(-delta), "FallSeries", *given)
    far = choose(m.w < 0, swing + missed, creep)
    return do.routine("Fall", "n0, the same device with its time reversed, times exp(-delta)",
                      (gamma, delta), choose(m.small, near, far))  # fmt: skip


def rise_series() -> Routine:
    """Divided difference of exp at h, sqrt w and -sqrt w, less 1/2."""
    do = Steps()
    even = [sp.S.Zero] * (TERMS + 2)
    total: Expr = sp.S.Zero
    for k in range(TERMS - 1, -1, -1):
        own = 1 / factorial(k + 2) if k else sp.S.Zero
        even[k] = do(f"e{k}", own + w * even[k + 2])
        total = do(f"b{k}", even[k] + h * total)
    return do.routine("RiseSeries", "divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2",
                      (h, w), total)  # fmt: skip


def fall_series() -> Routine:
    """Divided difference of exp at 0, p and q, with p + q = delta and p q = gamma, less 1/2."""
    do = Steps()
    one: Expr = sp.S.Zero
    two: Expr = sp.S.Zero
    for k in range(TERMS - 1, _CAREFUL - 1, -1):
        one, two = do(f"b{k}", 1 / factorial(k + 2) + delta * one - gamma * two), one
    one_low: Expr = sp.S.Zero
    two_low: Expr = sp.S.Zero
    for k in range(_CAREFUL - 1, -1, -1):
        own = 1 / factorial(k + 2) if k else sp.S.Zero
        grown, grown_low = product(do, delta, one, one_low)
        less, less_low = product(do, gamma, two, two_low)
        total, lost = difference(do, grown, less)
        total, more = difference(do, total, -own)
        low = do("low", lost + more + (grown_low - less_low))
        one, one_low, two, two_low = total, low, one, one_low
    return do.routine("FallSeries", "divided difference of exp at 0, p and q, less 1/2",
                      (gamma, delta), one + one_low)  # fmt: skip


def together() -> Routine:
    """n_1 + n_0: a product for a creeping device, a sum of squares for a swinging one."""
    do = Steps()
    m = motion(do)
    grown, turned = _halved(do, m, sin)
    still = S(choose(sp.Ne(delta, 0), 0, -gamma / 4))
    swing = (grown**2 + turned) / Max(gamma, STIFF) * 4
    creep = Decay(m.p) * Decay(m.q)
    given = choose(sp.Not(m.small), 0, m.half), choose(sp.Not(m.small), 0, m.w)
    near = 2 * half_and(do, exp(-m.half), "TogetherSeries", *given)
    far = choose(m.w < 0, choose(sp.Eq(delta, 0), still**2, swing), creep)
    return do.routine("Together", "n1 + n0", (gamma, delta), choose(m.small, near, far))


def together_series() -> Routine:
    """Divided difference of cosh(sqrt) at h^2 and w, less 1/2."""
    do = Steps()
    total = _mixed(do, [sp.S.Zero, *(1 / factorial(2 * k + 2) for k in range(1, 16))])
    return do.routine("TogetherSeries", "divided difference of cosh(sqrt) at h^2 and w, less 1/2",
                      (h, w), total)  # fmt: skip


def _mixed(do: Steps, coefficients: list[Expr]) -> Expr:
    """Sum over i and j of (h^2)^j w^i times coefficient i + j."""
    y = do("y", h * h)
    inner: Expr = sp.S.Zero
    total: Expr = sp.S.Zero
    for k in range(len(coefficients) - 1, -1, -1):
        inner = do(f"e{k}", coefficients[k] + w * inner)
        total = do(f"b{k}", inner + y * total)
    return total


def _halved(do: Steps, m: Motion, wave: type[sp.Function]) -> tuple[Expr, Expr]:
    """(1 - exp(-delta/2))/2 and exp(-delta/2) times the square of sin or cos of root/2."""
    grown = do("grown", -expm1(-m.half) / 2)
    angle = do("angle", m.root / 2)
    own, other = (sin(angle), cos(angle)) if wave is sin else (cos(angle), -sin(angle))
    first = do("wave", own)
    turned = do("wave", first + m.root_low / 2 * other)
    return grown, exp(-m.half) * turned**2


def nyquist() -> Routine:
    """1 + a + e: a sum where a > 0, a sum of squares where it is not."""
    do = Steps()
    m = motion(do)
    grown, turned = _halved(do, m, cos)
    v = _swinging(do, m)
    fast = do("fast", exp(-m.p))
    slow = do("slow", exp(-m.q))
    slow = do("slow", slow - slow * m.q_low)
    ends = do("ends", 1 + exp(-delta))
    swing = choose(
        v.even > 0, ends + 2 * v.envelope * (v.even + v.even_low), 4 * (grown**2 + turned)
    )
    return do.routine("Nyquist", "1 + a + e", (gamma, delta),
                      choose(m.w < 0, swing, (1 + fast) * (1 + slow)))  # fmt: skip


def swing() -> Routine:
    """a, the sum of the poles of the sampled device."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    sine, cosine = do("sine", sin(m.root)), do("cosine", cos(m.root))
    turn, lost = product(do, do("envelope", exp(-m.half)), cosine, -m.root_low * sine)
    return do.routine("Swing", "a, the sum of the sampled device's poles", (gamma, delta),
                      choose(m.w < 0, 2 * (turn + lost), c.fall + c.fall * c.ratio))  # fmt: skip


def apart() -> Routine:
    """(n_1 - n_0)/delta."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    fast = do("fast", c.fall * c.ratio)
    twice = do("twice", 2 * c.fall)
    pulled, pulled_low = product(do, twice, c.between, c.between_low)
    top, top_low = difference(do, c.slow, pulled)
    more, more_low = product(do, fast, c.slow, c.slow_low)
    top = do("top", top + more)
    low = do("low", top_low + (c.slow_low + more_low - pulled_low))
    creep = (top + low) / do.nonzero(m.p * delta)
    v = _swinging(do, m)
    swing = (Decay(delta) - 2 * v.envelope * v.odd / do.nonzero(delta)) / Max(gamma, STIFF)
    series = sp.Function("ApartSeries")(
        choose(sp.Not(m.small), 0, m.half), choose(sp.Not(m.small), 0, m.w)
    )
    near = exp(-m.half) * series
    far = choose(m.w < 0, swing, creep)
    return do.routine("Apart", "(n1 - n0)/delta", (gamma, delta), choose(m.small, near, far))


def apart_series() -> Routine:
    """Divided difference of sinh(sqrt)/sqrt at h^2 and w."""
    do = Steps()
    total = _mixed(do, [1 / factorial(2 * k + 3) for k in range(16)])
    return do.routine("ApartSeries", "divided difference of sinh(sqrt)/sqrt at h^2 and w",
                      (h, w), total)  # fmt: skip


ROUTINES = (
    rise, rise_series, fall, fall_series, together, together_series, nyquist, swing, apart,
    apart_series,
)  # fmt: skip
