"""The entire functions of one variable as routines, and products whose rounding is put back."""

from __future__ import annotations

import sympy as sp
from sympy import Expr, cos, exp, factorial, floor, sin, sqrt

from symhaptic.export.pairs import rounded, times, two_diff
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, TwoProdError, choose, expm1
from symhaptic.export.steps import Steps
from symhaptic.forms.entire import CosNext, Decay, Gap, Lag, Sinc, SinNext

x, w, k, y, z = sp.symbols("x w k y z")

_QUARTER = sp.Rational(3, 2)
"""Near a quarter turn."""

SIXTH = DOUBLE.parts(sp.Rational(1, 6), 1)[0]
"""The float next to 1/6, in any precision; its series has what it misses."""


def two_prod_error(precision: Precision = DOUBLE) -> Routine:
    """Dekker's product, for targets without a fused one."""
    do = Steps()
    product = do("product", y * z)
    halves = []
    for number in (y, z):
        big = do("big", precision.split * number)
        away = do("away", big - number)
        high = do("high", big - away)
        halves.append((high, do("low", number - high)))
    (high, low), (most, least) = halves
    left = do("left", high * most)
    left = do("left", left - product)
    left = do("left", left + high * least)
    left = do("left", left + low * most)
    return do.routine("TwoProdError", "y z minus the float nearest to it", (y, z),
                      left + low * least)  # fmt: skip


def decay() -> Routine:
    """(1 - exp(-x))/x."""
    do = Steps()
    whole = do.nonzero(x)
    return do.routine("Decay", "(1 - exp(-x))/x", (x,), choose(sp.Eq(x, 0), 1, -expm1(-x) / whole))


def number_and(
    fall: Expr, number: Expr, series: str, *arguments: Expr, low: Expr = sp.S.Zero
) -> Expr:
    """(fall + low) (number + series), rounded once."""
    return sp.Function("ScaledSum")(fall, low, sp.Function(series)(*arguments), number)


def scaled_sum() -> Routine:
    """Of a float or a pair, and a sum that is not rounded."""
    do = Steps()
    fall = sp.symbols("fall fall_low")
    found = times(do, fall, two_diff(do, y, -z))
    return do.routine("ScaledSum", "(fall + fall_low) (y + z), rounded once",
                      (*fall, y, z), rounded(found))  # fmt: skip


def creep() -> Routine:
    """Half of the sum of Creep and Fade and of their difference, both of which are positive."""
    do = Steps()
    return do.routine("Creep", "(exp(-x) - 1 + x)/x^2", (x,), (Decay(x) + x * Lag(x)) / 2)


def fade() -> Routine:
    """The same without the difference, for small x."""
    do = Steps()
    near = (Decay(x) - x * Lag(x)) / 2
    far = (Decay(x) - exp(-x)) / do.nonzero(x)
    return do.routine("Fade", "(1 - (1 + x) exp(-x))/x^2", (x,), choose(x < 2, near, far))


def lag() -> Routine:
    """exp(-x/2) times an even function, for small x from its series."""
    do = Steps()
    near = exp(-x / 2) * sp.Function("BendSeries")(choose(x >= 4, 0, x * x / 4))
    whole = do("whole", choose(x < 4, 4, x))
    two = do("two", x - 2)
    far = (two + (x + 2) * exp(-x)) / whole / (whole * whole)
    return do.routine("Lag", "(x - 2 + (x + 2) exp(-x))/x^3", (x,), choose(x < 4, near, far))


def sinc() -> Routine:
    """sin(x)/x, for small x from the gap between x and sin x."""
    do = Steps()
    near = do("near", choose(sp.Abs(x) >= 1, 0, x))
    far = sin(x) / do.nonzero(x)
    near = 1 - near * near * Gap(near)
    return do.routine("Sinc", "sin(x)/x", (x,), choose(sp.Abs(x) < 1, near, far))


def gap(precision: Precision = DOUBLE) -> Routine:
    """(x - sin(x))/x^3; from 2 on the difference keeps its digits."""
    do = Steps()
    near = do("near", choose(sp.Abs(x) >= 2, 0, x))
    square = do("square", -near * near)
    sixth, low = precision.parts(sp.Rational(1, 6))  # what the float misses goes into the next term
    terms = precision.terms(lambda k: 6 * sp.Integer(4) ** k / factorial(2 * k + 3))
    (total,) = do.sum(
        {"total": sp.S.Zero},
        lambda _, states, number: [number + square * states[0]],
        range(2 * terms + 1, 4, -2),
    )
    rest = do("rest", square * total + low)
    total = do("total", sixth + rest)
    whole = do("whole", choose(sp.Abs(x) < 2, 2, x))
    far = (x - sin(x)) / whole / (whole * whole)
    return do.routine("Gap", "(x - sin(x))/x^3", (x,), choose(sp.Abs(x) < 2, total, far))


def cosh_root() -> Routine:
    """cosh(sqrt w), cos(sqrt -w)."""
    do = Steps()
    root, low, _ = _root(do)
    cosine = do("cosine", cos(root))
    swing = cosine - low * sin(root)
    grown = do("grown", exp(choose(w < 0, 0, root)))
    return do.routine("C", "cosh(sqrt(w))", (w,), choose(w < 0, swing, (grown + 1 / grown) / 2))


def sinhc_root() -> Routine:
    """sinh(sqrt w)/sqrt w, sin(sqrt -w)/sqrt -w."""
    do = Steps()
    root, low, some = _root(do)
    sine = do("sine", sin(root))
    turned = do("turned", sine + low * cos(root))
    swing = turned / some
    grown = do("grown", expm1(choose(w < 0, 0, root)))
    creep = (grown + grown / (1 + grown)) / 2 / some
    return do.routine("S", "sinh(sqrt(w))/sqrt(w)", (w,),
                      choose(sp.Eq(w, 0), 1, choose(w < 0, swing, creep)))  # fmt: skip


def _root(do: Steps) -> tuple[Expr, Expr, Expr]:
    """sqrt |w|, its rounding error, and the root with 1 in place of 0."""
    size = do("size", sp.Abs(w))
    root = do("root", sqrt(size))
    some = do.nonzero(root)
    left = do("left", size - root * root)
    left = do("left", left - TwoProdError(root, root))
    return root, do("low", left / some / 2), some


def next_wave(precision: Precision = DOUBLE) -> Routine:
    """Both with the rounding of sum and product put back."""
    do = Steps()
    if precision.bits < DOUBLE.bits:
        turn, sine, cosine = _turned(do, precision)
        odd = sp.Or(sp.Eq(turn, 1), sp.Eq(turn, 3))
        even_wave, odd_wave = (do("value", choose(odd, *pair))
                               for pair in ((sine, cosine), (cosine, sine)))  # fmt: skip
        cosine = choose(sp.And(turn >= 1, turn <= 2), -even_wave, even_wave)
        sine = choose(turn >= 2, -odd_wave, odd_wave)
    else:
        angle, off, missed = _next_parts(do)
        off = do("off", off + missed * x)
        wave, still = do("sine", sin(angle)), do("cosine", cos(angle))
        small = sp.Abs(off) < sp.sqrt(precision.last) / 2
        cosine = choose(small, still - off * wave, still * cos(off) - wave * sin(off))
        sine = choose(small, wave + off * still, wave * cos(off) + still * sin(off))
    return do.routine("NextWave", "cos((k + 1) x) and sin((k + 1) x)", (k, x),
                      {"cosine": cosine, "sine": sine}, "CosSin")  # fmt: skip


def cos_next() -> Routine:
    """One of both."""
    do = Steps()
    cosine, _ = do.several(("cosine", "sine"), "NextWave", k, x)
    return do.routine("CosNext", "cos((k + 1) x)", (k, x), cosine)


def sin_next() -> Routine:
    """The other one."""
    do = Steps()
    _, sine = do.several(("cosine", "sine"), "NextWave", k, x)
    return do.routine("SinNext", "sin((k + 1) x)", (k, x), sine)


def spread() -> Routine:
    """Sines of two angles; up to a quarter turn of the delay they are close, beyond it they add."""
    do = Steps()
    order, turn, angle, some = _delayed(do)
    near = order * (order * order * Gap(2 * angle) - Gap(x))
    far = (order * sin(x) - 2 * SinNext(k, x) * CosNext(k, x)) / some / (some * some)
    return do.routine("Spread", "((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3", (k, x),
                      choose(turn < _QUARTER, near, far))  # fmt: skip


def chord() -> Routine:
    """The same for 2 sin - (2 k + 2) sin(x) cos."""
    do = Steps()
    order, turn, angle, some = _delayed(do)
    along = do("along", CosNext(k, x))
    wave = do("wave", Sinc(angle / 2))
    inner = do("inner", wave * wave / 2 - Gap(angle))
    near = order * (order * order * inner / 4 + Gap(x) * along)
    far = (2 * SinNext(k, x) - order * sin(x) * along) / some / (some * some)
    return do.routine("Chord", "(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3", (k, x),
                      choose(turn < _QUARTER, near, far))  # fmt: skip


def _delayed(do: Steps) -> tuple[Expr, Expr, Expr, Expr]:
    """2 (k + 1), the angle (k + 1) x, the same where it is small, and x where it is not."""
    turn = do("turn", (k + 1) * x)
    angle = do("angle", choose(turn >= _QUARTER, 0, turn))
    some = do("some", choose(turn < _QUARTER, 1, x))
    return do("order", 2 * (k + 1)), turn, angle, some


def _next_parts(do: Steps) -> tuple[Expr, Expr, Expr]:
    """The product of x and k + 1 rounded, its rounding error, and the sum's rounding error."""
    count = do("count", k + 1)
    before = do("before", count - 1)
    angle = do("angle", count * x)
    missed = do("missed", k - before)
    return angle, TwoProdError(count, x), missed


def _turned(do: Steps, precision: Precision) -> tuple[Expr, Expr, Expr]:
    """Quarter turns in (k + 1) x, modulo 4, with sine and cosine of what is left.

    For few digits: the rounding of a long angle is no small angle then.
    """
    angle, off, missed = _next_parts(do)
    large, middle, small = precision.parts(sp.pi / 2, 3)
    count = do("quarters", floor(angle * 2 / sp.pi + sp.S.Half))
    left = do("left", angle - count * large)  # exact
    left, one = two_diff(do, left, TwoProdError(count, large))
    left, two = two_diff(do, left, count * middle)
    left, three = two_diff(do, left, -off)
    left, four = two_diff(do, left, -missed * x)
    low = do("low", one + two + three + four - (TwoProdError(count, middle) + count * small))
    low = do("low", low + TwoProdError(missed, x))
    sine, cosine = do("wave", sin(left)), do("still", cos(left))
    turn = do("turn", count - 4 * floor(count / 4))
    return turn, do("sine", sine + low * cosine), do("cosine", cosine - low * sine)


ROUTINES = (
    decay, scaled_sum, creep, fade, lag, sinc, cosh_root, sinhc_root, cos_next, sin_next, spread,
    chord,
)  # fmt: skip
PRECISE = (gap, next_wave)
