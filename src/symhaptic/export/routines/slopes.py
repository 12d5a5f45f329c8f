r"""The derivatives of the entire functions: where each form keeps its digits.

Divided differences of exp with repeated nodes.  For real poles all of them are positive, and one
with a node less comes from two that are no nearly equal numbers:

    exp[0, -p, -p, -q, -q] = ((Fade(q) - exp(-q) Creep(p - q))/p - exp(-q) Lag(p - q))/p.

For complex poles of some size they are sums of cos and sin of sqrt(gamma - delta^2/4), and for
small poles power series about their mean.
"""

from __future__ import annotations

from symhaptic.export.routines.arithmetic import *
from symhaptic.export.routines.device import device_motion, real_poles
from symhaptic.export.routines.prelude import *
from symhaptic.forms.entire import (
    Chord,
    CosNext,
    Creep,
    Decay,
    Echo,
    Fade,
    Gap,
    Kick,
    Lag,
    PlantN0,
    PlantN0Drop,
    PlantN1,
    PlantN1Drop,
    Sinc,
    SinNext,
    Spread,
)

STIFF = sp.Integer(9)
"""Up to this gamma of complex poles the series of repeated nodes are used."""

RISE, FALL, APART = sp.Integer(5), sp.Integer(3), sp.Integer(5)
"""Up to this size of the larger real pole, for PlantN1Drop, PlantN0Drop and NumeratorGapDrop."""

BENT = sp.Integer(4)
"""Up to this |w| Bend is a series."""

TURN = Rational(3, 2)
"""Up to this angle (k + 1) x the functions of an angle are series, as in arithmetic."""


class _Device:
    """What the functions of the device share."""

    def __init__(self, gamma, delta) -> None:
        self.gamma = gamma
        self.half, (self.w, low), root, _ = device_motion(gamma, delta)
        (self.p, _), (self.q, q_low) = real_poles(gamma, self.half, (self.w, low), root)
        low = do("root_low", root_miss((self.w, low), root))
        fall = do("fall", exp(-self.q))
        self.fall = do("fall", fall - fall * q_low)
        self.gap = do("gap", 2 * root)
        ratio = do("ratio", exp(-self.gap))
        self.ratio = do("ratio", ratio - ratio * (2 * low))
        sine, cosine = do("sine", sin(root)), do("cosine", cos(root))
        self.cosine = do("turned", cosine - low * sine)
        self.sine = do("swung", (sine + low * cosine) / do.nonzero(root))
        self.envelope = do("envelope", exp(-self.half))
        self.swings = self.w < 0

    def small(self, near):
        """Whether a series serves, and its arguments, which are 0 where it does not."""
        reach = do("range", choose(self.swings, self.gamma / STIFF, self.p / near))
        small = reach < 1
        return small, *(choose(Not(small), 0, of) for of in (self.half, self.w))


# -- of the device -----------------------------------------------------------------------------


@routine()
def coast(gamma, delta):
    """speed by a unit impulse after a period"""
    v = _Device(gamma, delta)
    creep = v.fall * (v.ratio - v.q * Decay(v.gap))
    return choose(v.swings, v.envelope * (v.cosine - v.half * v.sine), creep)


@routine()
def echo(gamma, delta):
    """-d n1/d delta"""
    v = _Device(gamma, delta)
    slow = v.w > -BENT
    near = bend_series(choose(And(v.swings, slow), v.w, 0))
    far = (v.sine - v.cosine) / (2 * Max(-v.w, BENT))
    return choose(v.swings, v.envelope * choose(slow, near, far), v.fall * Lag(v.gap))


@routine()
def ebb(gamma, delta):
    """d n0/d delta"""
    v = _Device(gamma, delta)  # Echo - n_0; for poles far apart without the difference
    p, q = do("large", Max(v.p, 2)), v.q
    far = do("far", Max(v.gap, 2))
    slow = do("slow", q * (far - 2) - 2 * far)
    fast = do("fast", 2 * far * (far + 1) + q * (far + 2) + far * far * far * Decay(q))
    creep = v.fall * (slow + v.ratio * fast) / (p * (far * far * far))
    apart = And(Not(v.swings), v.gap > 2)
    return choose(apart, creep, Echo(gamma, delta) - PlantN0(gamma, delta))


@routine()
def plant_n1_drop(gamma, delta):
    """-d n1/d gamma"""
    v = _Device(gamma, delta)
    small, half, mean = v.small(RISE)
    near = v.envelope * drop_series(half, mean)
    top = do("top", (Fade(v.q) - v.fall * Creep(v.gap)) / v.p)
    creep = (top - v.fall * Lag(v.gap)) / v.p
    own, other = Kick(gamma, delta), Echo(gamma, delta)
    swing = (PlantN1(gamma, delta) - (own + delta * other) / 2) / Max(gamma, STIFF)
    return choose(small, near, choose(v.swings, swing, creep))


@routine()
def plant_n0_drop(gamma, delta):
    """-d n0/d gamma"""
    v = _Device(gamma, delta)
    small, half, mean = v.small(FALL)
    near = v.envelope * drop_series(-half, mean)
    top = do("top", (Fade(v.gap) - v.ratio * Creep(v.q)) / v.p)
    creep = v.fall * (Lag(v.gap) - top) / v.p
    own, other = Kick(gamma, delta), Echo(gamma, delta)
    swing = (PlantN0(gamma, delta) - (own - delta * other) / 2) / Max(gamma, STIFF)
    return choose(small, near, choose(v.swings, swing, creep))


@routine()
def numerator_gap_drop(gamma, delta):
    """-d ((n1 - n0)/delta)/d gamma"""
    v = _Device(gamma, delta)
    small, half, mean = v.small(APART)
    near = v.envelope * lean_series(half, mean)
    creep = (PlantN1Drop(gamma, delta) - PlantN0Drop(gamma, delta)) / do.nonzero(delta)
    stiff = do("stiff", Max(gamma, STIFF))
    swing = ((Decay(delta) - v.envelope * v.sine) / stiff - Echo(gamma, delta)) / stiff
    return choose(small, near, choose(v.swings, swing, creep))


@routine()
def drop_series(h, w, precision):
    """divided difference of exp at h, twice at sqrt(w), -sqrt(w)"""
    terms = precision.terms(lambda i: 48 * binomial(i + 4, 4) * RISE**i / factorial(i + 4))

    def step(total, one, two, first, second, number):
        once = do("once", number + w * two)
        twice = do("twice", once + w * second)
        return twice + h * total, once, one, twice, first

    return do.sum("total one two first second", step, range(terms + 3, 3, -1))[0]


@routine()
def lean_series(h, w, precision):
    """divided difference of exp at h, -h, twice at sqrt(w), -sqrt(w)"""
    terms = precision.terms(
        lambda i: 240 * binomial(2 * i + 5, 5) * APART ** (2 * i) / factorial(2 * i + 5)
    )
    square = do("square", h * h)

    def step(total, once, twice, number):
        once = do("own", number + w * once)
        twice = do("both", once + w * twice)
        return twice + square * total, once, twice

    return do.sum("total once twice", step, range(2 * terms + 3, 4, -2))[0]


# -- of one variable ---------------------------------------------------------------------------


@routine()
def bend(w):
    """(C(w) - S(w))/(2 w)"""
    size = do("size", Abs(w))
    root = do("root", sqrt(size))
    some = do.nonzero(root)
    low = do("low", do("left", size - root * root) / some / 2)
    sine, cosine = do("sine", sin(root)), do("cosine", cos(root))
    whole = do("whole", 2 * Max(size, BENT))
    swing = ((sine + low * cosine) / some - (cosine - low * sine)) / whole
    grown = do("grown", exp(choose(w < 0, 0, root)))
    creep = ((grown + 1 / grown) - (grown - 1 / grown) / some) / 2 / whole
    near = bend_series(choose(size >= BENT, 0, w))
    return choose(size < BENT, near, choose(w < 0, swing, creep))


@routine()
def wane(x):
    """(2 - (x^2 + 2 x + 2) exp(-x))/x^3"""
    near = exp(-x) * wane_series(choose(x >= 3, 0, x))
    whole = do("whole", Max(x, 3))
    far = (2 - (x * (x + 2) + 2) * exp(-x)) / (whole * whole) / whole
    return choose(x < 3, near, far)


def _powers(step, most, precision, number):
    """A sum of powers of an expression up to a size, after Horner."""
    count = precision.terms(lambda i: 2 * number(i) / number(0) * most**i)
    total = number(count - 1)
    for i in range(count - 2, -1, -1):
        total = number(i) + step * total
    return total


@routine()
def bend_series(w, precision):
    """derivative of sinh(sqrt(w))/sqrt(w)"""
    return _powers(w, BENT, precision, lambda i: (i + 1) / factorial(2 * i + 3))


@routine()
def wane_series(x, precision):
    """sum of 2 x^k/(k+3)!"""
    return _powers(x, sp.Integer(3), precision, lambda i: 2 / factorial(i + 3))


@routine()
def gap_slope_series(x, precision):
    """(2 x + x cos(x) - 3 sin(x))/x^5"""
    step, most = do("step", -x * x), (2 * TURN) ** 2
    return _powers(step, most, precision, lambda i: 2 * (i + 1) / factorial(2 * i + 5))


@routine()
def curl_series(w, precision):
    """second derivative of sinh(sqrt(w))/sqrt(w)"""
    return _powers(w, TURN**2, precision, lambda i: (i + 1) * (i + 2) / factorial(2 * i + 5))


# -- of an angle and a delay -------------------------------------------------------------------


def _turn(k, x):
    """k + 1, (k + 1) x, and x and that angle, which are 0 where the angle is not small.

    And x, or 1 where the angle is small.
    """
    n = do("n", k + 1)
    turn = do("turn", n * x)
    near, angle = (do("near", choose(turn >= TURN, 0, v)) for v in (x, turn))
    return n, turn, near, angle, do("some", choose(turn < TURN, 1, x))


@routine()
def ripple(k, x):
    """derivative of sin((k + 1) x)/sin(x) by x"""
    n, turn, small, _, _ = _turn(k, x)
    wave = Sinc(small)
    near = SinNext(k, x) / (2 * cos(small / 2) ** 2) - small * Chord(k, x) / (2 * wave * wave)
    own = do("own", choose(turn < TURN, 1, sin(x)))
    far = (n * CosNext(k, x) - SinNext(k, x) * cos(x) / own) / own
    return choose(turn < TURN, near, far)


@routine()
def spread_slope(k, x):
    """derivative of Spread by x"""
    n, turn, small, angle, some = _turn(k, x)
    order, square = do("order", 2 * n), do("square", 4 * n * n)
    near = -order * small * (square * square * gap_slope_series(2 * angle)
                             - gap_slope_series(small))  # fmt: skip
    wave, half = do("wave", SinNext(k, x)), do("half", sin(x / 2))
    far = 2 * order * (wave * wave - half * half) / (some * some) - 3 * Spread(k, x)
    return choose(turn < TURN, near, far / some)


@routine()
def chord_slope(k, x):
    """derivative of Chord by x"""
    n, turn, small, angle, some = _turn(k, x)
    square = do("square", n * n)
    first = 4 * square * square * curl_series(-angle * angle)
    rest = gap_slope_series(small) * CosNext(k, x)
    inner = first + rest + square * Gap(small) * Sinc(angle)
    half = do("half", sin(x / 2))
    turned = 2 * half * half * CosNext(k, x) + n * sin(x) * SinNext(k, x)
    far = 2 * n * turned / (some * some) - 3 * Chord(k, x)
    return choose(turn < TURN, -2 * n * small * inner, far / some)
