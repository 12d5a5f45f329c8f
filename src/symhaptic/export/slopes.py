r"""The derivatives of the entire functions as routines: where each form keeps its digits.

Divided differences of exp with repeated nodes.  For real poles all of them are positive, and one
with a node less comes from two that are no nearly equal numbers:

    exp[0, -p, -p, -q, -q] = ((Fade(q) - exp(-q) Creep(p - q))/p - exp(-q) Lag(p - q))/p.

For complex poles of some size they are sums of cos and sin of sqrt(gamma - delta^2/4), and for
small poles power series about their mean.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import sympy as sp
from sympy import And, Expr, Max, Symbol, binomial, cos, exp, factorial, sin

from symhaptic.export import device
from symhaptic.export.device import ENVELOPE, WAVE, Motion, motion, of_device, poles, shared
from symhaptic.export.device_series import h, w
from symhaptic.export.double_word import root_low
from symhaptic.export.elementary import x
from symhaptic.export.pairs import fast_two_sum, scaled, times
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.forms.entire import Creep, Decay, Fade, Lag
from symhaptic.forms.entire_device import PlantN0, PlantN1
from symhaptic.forms.slopes import Echo, Kick, PlantN0Drop, PlantN1Drop
from symhaptic.notation import delta, gamma

STIFF = sp.Integer(9)
"""Up to this gamma of complex poles the series of repeated nodes are used."""

RISE, FALL, APART = sp.Integer(5), sp.Integer(3), sp.Integer(5)
"""Up to this size of the larger real pole, for PlantN1Drop, PlantN0Drop and NumeratorGapDrop."""

BENT = sp.Integer(4)
"""Up to this |w| Bend is a series."""


@dataclass(frozen=True)
class _Shared:
    """What the functions of the device share."""

    m: Motion
    p: Expr
    q: Expr
    gap: Expr
    """p - q."""
    fall: Expr
    """exp(-q)."""
    ratio: Expr
    """exp(-(p - q))."""
    cosine: Expr
    sine: Expr
    envelope: Expr

    @property
    def swings(self) -> sp.logic.boolalg.Boolean:
        """Whether the poles are complex."""
        return self.m.w < 0


def _shared(do: Steps) -> _Shared:
    m = motion(do)
    (p, _), (q, q_low) = poles(do, m)
    low = do("root_low", root_low(m.w, m.w_low, m.root))
    fall = do("fall", exp(-q))
    fall = do("fall", fall - fall * q_low)
    gap = do("gap", 2 * m.root)
    ratio = do("ratio", exp(-gap))
    ratio = do("ratio", ratio - ratio * (2 * low))
    sine, cosine = do("sine", sin(m.root)), do("cosine", cos(m.root))
    turned = do("turned", cosine - low * sine)
    swung = do("swung", (sine + low * cosine) / do.nonzero(m.root))
    return _Shared(m, p, q, gap, fall, ratio, turned, swung, do("envelope", exp(-m.half)))


# -- of the device ------------------------------------------------------------------------


def _kick(do: Steps) -> tuple[Expr, Expr]:
    """The nearest float, and what it misses."""
    v = shared(do)
    odd = v.swing_pair(WAVE.odd)
    fall, mean = v.creep_pair(device.SLOW.fall), v.creep_pair(device.APART.mean)
    swing, swing_low = fast_two_sum(do, *scaled(do, v.swing[ENVELOPE], odd))
    creep, creep_low = fast_two_sum(do, *times(do, fall, mean))
    return choose(v.m.w < 0, swing, creep), choose(v.m.w < 0, swing_low, creep_low)


def kick() -> Routine:
    """exp[-p, -q]."""
    do = Steps()
    found, _ = _kick(do)
    return of_device(do, "Kick", "displacement by a unit impulse after a period", found)


def kick_low() -> Routine:
    """What Kick misses."""
    do = Steps()
    _, low = _kick(do)
    return of_device(do, "KickLow", "what the last rounding of Kick takes", low)


def coast() -> Routine:
    """exp(-p) - q exp[-p, -q], and the same with cos and sin."""
    do = Steps()
    v = _shared(do)
    creep = v.fall * (v.ratio - v.q * Decay(v.gap))
    swing = v.envelope * (v.cosine - v.m.half * v.sine)
    return of_device(do, "Coast", "speed by a unit impulse after a period",
                choose(v.swings, swing, creep))  # fmt: skip


def echo() -> Routine:
    """exp[-p, -p, -q, -q]."""
    do = Steps()
    v = _shared(do)
    slow = v.m.w > -BENT
    near = sp.Function("BendSeries")(choose(And(v.swings, slow), v.m.w, 0))
    far = (v.sine - v.cosine) / (2 * Max(-v.m.w, BENT))
    swing = v.envelope * choose(slow, near, far)
    return of_device(do, "Echo", "-d n1/d delta", choose(v.swings, swing, v.fall * Lag(v.gap)))


def ebb() -> Routine:
    """Echo - n_0; for poles far apart without the difference."""
    do = Steps()
    v = _shared(do)
    p, q = do("large", Max(v.p, 2)), v.q
    far = do("far", Max(v.gap, 2))
    slow = do("slow", q * (far - 2) - 2 * far)
    fast = do("fast", 2 * far * (far + 1) + q * (far + 2) + far * far * far * Decay(q))
    creep = v.fall * (slow + v.ratio * fast) / (p * (far * far * far))
    near = Echo(gamma, delta) - PlantN0(gamma, delta)
    apart = And(sp.Not(v.swings), v.gap > 2)
    return of_device(do, "Ebb", "d n0/d delta", choose(apart, creep, near))


def _small(do: Steps, v: _Shared, near: Expr) -> tuple[Expr, Expr, Expr]:
    """Whether a series serves, and its arguments, which are 0 where it does not."""
    reach = do("range", choose(v.swings, gamma / STIFF, v.p / near))
    small = reach < 1
    return small, choose(sp.Not(small), 0, v.m.half), choose(sp.Not(small), 0, v.m.w)


def plant_n1_drop() -> Routine:
    """exp[0, -p, -p, -q, -q]."""
    do = Steps()
    v = _shared(do)
    small, half, mean = _small(do, v, RISE)
    near = v.envelope * sp.Function("DropSeries")(half, mean)
    top = do("top", (Fade(v.q) - v.fall * Creep(v.gap)) / v.p)
    creep = (top - v.fall * Lag(v.gap)) / v.p
    own, other = Kick(gamma, delta), Echo(gamma, delta)
    swing = (PlantN1(gamma, delta) - (own + delta * other) / 2) / Max(gamma, STIFF)
    return of_device(do, "PlantN1Drop", "-d n1/d gamma",
                choose(small, near, choose(v.swings, swing, creep)))  # fmt: skip


def plant_n0_drop() -> Routine:
    """exp[-p - q, -p, -p, -q, -q]."""
    do = Steps()
    v = _shared(do)
    small, half, mean = _small(do, v, FALL)
    near = v.envelope * sp.Function("DropSeries")(-half, mean)
    top = do("top", (Fade(v.gap) - v.ratio * Creep(v.q)) / v.p)
    creep = v.fall * (Lag(v.gap) - top) / v.p
    own, other = Kick(gamma, delta), Echo(gamma, delta)
    swing = (PlantN0(gamma, delta) - (own - delta * other) / 2) / Max(gamma, STIFF)
    return of_device(do, "PlantN0Drop", "-d n0/d gamma",
                choose(small, near, choose(v.swings, swing, creep)))  # fmt: skip


def numerator_gap_drop() -> Routine:
    """exp[0, -p - q, -p, -p, -q, -q]."""
    do = Steps()
    v = _shared(do)
    small, half, mean = _small(do, v, APART)
    near = v.envelope * sp.Function("LeanSeries")(half, mean)
    creep = (PlantN1Drop(gamma, delta) - PlantN0Drop(gamma, delta)) / do.nonzero(delta)
    stiff = do("stiff", Max(gamma, STIFF))
    swing = ((Decay(delta) - v.envelope * v.sine) / stiff - Echo(gamma, delta)) / stiff
    return of_device(do, "NumeratorGapDrop", "-d ((n1 - n0)/delta)/d gamma",
                choose(small, near, choose(v.swings, swing, creep)))  # fmt: skip


def drop_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at h and twice at sqrt w and -sqrt w."""
    do = Steps()
    terms = precision.terms(lambda i: 48 * binomial(i + 4, 4) * RISE**i / factorial(i + 4))

    def step(do: Steps, states: tuple[Symbol, ...], number: Symbol) -> Iterable[Expr]:
        total, one, two, first, second = states
        once = do("once", number + w * two)
        twice = do("twice", once + w * second)
        return twice + h * total, once, one, twice, first

    names = "total", "one", "two", "first", "second"
    total, *_ = do.sum(dict.fromkeys(names, sp.S.Zero), step, range(terms + 3, 3, -1))
    return do.routine("DropSeries", "divided difference of exp at h, twice at sqrt(w), -sqrt(w)",
                      (h, w), total)  # fmt: skip


def lean_series(precision: Precision = DOUBLE) -> Routine:
    """Divided difference of exp at h, -h and twice at sqrt w and -sqrt w."""
    do = Steps()
    terms = precision.terms(
        lambda i: 240 * binomial(2 * i + 5, 5) * APART ** (2 * i) / factorial(2 * i + 5)
    )
    square = do("square", h * h)

    def step(do: Steps, states: tuple[Symbol, ...], number: Symbol) -> Iterable[Expr]:
        total, once, twice = states
        once = do("own", number + w * once)
        twice = do("both", once + w * twice)
        return twice + square * total, once, twice

    start = dict.fromkeys(("total", "once", "twice"), sp.S.Zero)
    total, *_ = do.sum(start, step, range(2 * terms + 3, 4, -2))
    return do.routine("LeanSeries", "divided difference of exp at h, -h, twice at sqrt(w), "
                      "-sqrt(w)", (h, w), total)  # fmt: skip


# -- of one variable ----------------------------------------------------------------------


def bend() -> Routine:
    """(C(w) - S(w))/(2 w)."""
    do = Steps()
    size = do("size", sp.Abs(w))
    root = do("root", sp.sqrt(size))
    some = do.nonzero(root)
    left = do("left", size - root * root)
    low = do("low", left / some / 2)
    sine, cosine = do("sine", sin(root)), do("cosine", cos(root))
    whole = do("whole", 2 * Max(size, BENT))
    swing = ((sine + low * cosine) / some - (cosine - low * sine)) / whole
    grown = do("grown", exp(choose(w < 0, 0, root)))
    creep = ((grown + 1 / grown) - (grown - 1 / grown) / some) / 2 / whole
    near = sp.Function("BendSeries")(choose(size >= BENT, 0, w))
    return do.routine("Bend", "(C(w) - S(w))/(2 w)", (w,),
                      choose(size < BENT, near, choose(w < 0, swing, creep)))  # fmt: skip


def bend_series(precision: Precision = DOUBLE) -> Routine:
    """Derivative of sinh(sqrt w)/sqrt w."""
    return powers("BendSeries", "derivative of sinh(sqrt(w))/sqrt(w)", w, w, BENT, precision,
                   lambda i: (i + 1) / factorial(2 * i + 3))  # fmt: skip


def wane() -> Routine:
    """(2 - (x^2 + 2 x + 2) exp(-x))/x^3; for small x exp(-x) times a positive series."""
    do = Steps()
    near = exp(-x) * sp.Function("WaneSeries")(choose(x >= 3, 0, x))
    whole = do("whole", Max(x, 3))
    far = (2 - (x * (x + 2) + 2) * exp(-x)) / (whole * whole) / whole
    return do.routine("Wane", "(2 - (x^2 + 2 x + 2) exp(-x))/x^3", (x,), choose(x < 3, near, far))


def wane_series(precision: Precision = DOUBLE) -> Routine:
    """2/3! + 2 x/4! + ..."""
    return powers("WaneSeries", "sum of 2 x^k/(k+3)!", x, x, sp.Integer(3), precision,
                   lambda i: 2 / factorial(i + 3))  # fmt: skip


def powers(
    name: str,
    about: str,
    symbol: Expr,
    variable: Expr,
    most: Expr,
    precision: Precision,
    number: Callable[[int], Expr],
) -> Routine:
    """A sum of powers of an expression up to a size, after Horner."""
    do = Steps()
    count = precision.terms(lambda i: 2 * number(i) / number(0) * most**i)
    numbers = [number(i) for i in range(count)]
    step = symbol if variable == symbol else do("step", variable)
    total: Expr = numbers[-1]
    for i in range(len(numbers) - 2, -1, -1):
        total = numbers[i] + step * total
    return do.routine(name, about, (symbol,), total)


ROUTINES = (
    kick, kick_low, coast, echo, ebb, plant_n1_drop, plant_n0_drop, numerator_gap_drop, bend, wane,
)  # fmt: skip
PRECISE = (drop_series, lean_series, bend_series, wane_series)
