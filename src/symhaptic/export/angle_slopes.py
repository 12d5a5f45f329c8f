"""The derivatives of the functions of an angle and a delay as routines."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, cos, factorial, sin

from symhaptic.export.device_series import w
from symhaptic.export.elementary import k, x
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.slopes import powers
from symhaptic.export.steps import Steps
from symhaptic.forms.entire import Chord, CosNext, Gap, Sinc, SinNext, Spread

TURN = sp.Rational(3, 2)
"""Up to this angle (k + 1) x the functions of an angle are series, as in elementary."""


@dataclass(frozen=True)
class _Turn:
    """(k + 1), (k + 1) x, and x and that angle, which are 0 where the angle is not small."""

    n: Expr
    turn: Expr
    near: Expr
    angle: Expr
    some: Expr
    """x, or 1 where the angle is small."""


def _turn(do: Steps) -> _Turn:
    n = do("n", k + 1)
    turn = do("turn", n * x)
    near, angle = (do("near", choose(turn >= TURN, 0, v)) for v in (x, turn))
    return _Turn(n, turn, near, angle, do("some", choose(turn < TURN, 1, x)))


def ripple() -> Routine:
    """From Chord, where the angle is small."""
    do = Steps()
    t = _turn(do)
    wave = Sinc(t.near)
    near = SinNext(k, x) / (2 * cos(t.near / 2) ** 2) - t.near * Chord(k, x) / (2 * wave * wave)
    own = do("own", choose(t.turn < TURN, 1, sin(x)))
    far = (t.n * CosNext(k, x) - SinNext(k, x) * cos(x) / own) / own
    return do.routine("Ripple", "derivative of sin((k + 1) x)/sin(x) by x", (k, x),
                      choose(t.turn < TURN, near, far))  # fmt: skip


def spread_slope() -> Routine:
    """Differences of sines, or of the slopes of x - sin(x)."""
    do = Steps()
    t = _turn(do)
    order, square = do("order", 2 * t.n), do("square", 4 * t.n * t.n)
    slope = sp.Function("GapSlopeSeries")
    near = -order * t.near * (square * square * slope(2 * t.angle) - slope(t.near))
    wave, half = do("wave", SinNext(k, x)), do("half", sin(x / 2))
    far = 2 * order * (wave * wave - half * half) / (t.some * t.some) - 3 * Spread(k, x)
    return do.routine("SpreadSlope", "derivative of Spread by x", (k, x),
                      choose(t.turn < TURN, near, far / t.some))  # fmt: skip


def chord_slope() -> Routine:
    """The same for Chord."""
    do = Steps()
    t = _turn(do)
    square = do("square", t.n * t.n)
    first = 4 * square * square * sp.Function("CurlSeries")(-t.angle * t.angle)
    rest = sp.Function("GapSlopeSeries")(t.near) * CosNext(k, x)
    inner = first + rest + square * Gap(t.near) * Sinc(t.angle)
    near = -2 * t.n * t.near * inner
    half = do("half", sin(x / 2))
    turned = 2 * half * half * CosNext(k, x) + t.n * sin(x) * SinNext(k, x)
    far = 2 * t.n * turned / (t.some * t.some) - 3 * Chord(k, x)
    return do.routine("ChordSlope", "derivative of Chord by x", (k, x),
                      choose(t.turn < TURN, near, far / t.some))  # fmt: skip


def gap_slope_series(precision: Precision = DOUBLE) -> Routine:
    """(2 x + x cos(x) - 3 sin(x))/x^5."""
    return powers("GapSlopeSeries", "(2 x + x cos(x) - 3 sin(x))/x^5", x, -x * x,
                   (2 * TURN) ** 2, precision,
                   lambda i: 2 * (i + 1) / factorial(2 * i + 5))  # fmt: skip


def curl_series(precision: Precision = DOUBLE) -> Routine:
    """Second derivative of sinh(sqrt w)/sqrt w."""
    return powers("CurlSeries", "second derivative of sinh(sqrt(w))/sqrt(w)", w, w, TURN**2,
                   precision,
                   lambda i: (i + 1) * (i + 2) / factorial(2 * i + 5))  # fmt: skip


ROUTINES = (ripple, spread_slope, chord_slope)
PRECISE = (gap_slope_series, curl_series)
