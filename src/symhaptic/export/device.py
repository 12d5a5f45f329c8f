r"""The entire functions of the device as routines: where each form keeps its digits.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  Near p = q = 0 a power
series is used, beyond it closed forms that subtract no two nearly equal numbers:

    n1 = (Decay(q) - exp(-q) Decay(p - q))/p,   n0 = exp(-q) (Decay(p - q) - exp(-(p-q)) Decay(q))/p

for a creeping device, and those of cos and sin of sqrt(gamma - delta^2/4) for a swinging one,
where it is not near whole turns (whole_turns.py).
The poles are kept to twice the precision of a float, since exp(-q) magnifies their error by q.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, cos, exp, sin, sqrt
from sympy.logic.boolalg import Boolean

from symhaptic.export.device_series import NEAR
from symhaptic.export.double_word import Fading, Wave, fading, fallen, root_low, waving
from symhaptic.export.elementary import SIXTH, number_and
from symhaptic.export.pairs import (
    Pair,
    exact,
    fast_two_sum,
    minus,
    one_minus,
    one_plus,
    over,
    plus,
    rounded,
    scaled,
    squared,
    times,
    two_diff,
)
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, Steps, choose, expm1
from symhaptic.export.whole_turns import turned
from symhaptic.forms.entire import Decay
from symhaptic.notation import delta, gamma

SOFT = sp.Rational(9, 16)
"""The part of both up to which n1 and n0 use them."""

STIFF = sp.Integer(4)
"""Up to this gamma, the squared size of complex poles."""

# -- the motion: w = delta^2/4 - gamma and both poles, to twice the precision -----------------


@dataclass(frozen=True)
class Motion:
    """What the functions of gamma and delta share."""

    half: Expr
    """delta/2."""
    w: Expr
    w_low: Expr
    """Its rounding error."""
    root: Expr
    """sqrt |w|."""
    root_low: Expr
    """Its rounding error."""
    p: Expr
    """The larger pole, or 1 where it is 0."""
    p_low: Expr
    q: Expr
    q_low: Expr
    reach: Expr
    """The size of the poles, in parts of that up to which the power series serve."""


_MOTION = "w", "w_low", "root", "reach"
_POLES = "p", "p_low", "q", "q_low"
_KEPT = sp.symbols("half w w_low root")


def motion(do: Steps) -> Motion:
    """The steps that find it."""
    half = do("half", delta / 2)
    w, w_low, root, reach = do.several(_MOTION, "DeviceMotion", gamma, delta)
    low = do("root_low", root_low(w, w_low, root))
    p, p_low, q, q_low = do.several(_POLES, "RealPoles", gamma, half, w, w_low, root)
    return Motion(half, w, w_low, root, low, p, p_low, q, q_low, reach)


def device_motion() -> Routine:
    """What vanishes is a small difference."""
    do = Steps()
    half = do("half", delta / 2)
    square, square_low = squared(do, exact(half))
    most, lost = two_diff(do, square, gamma)
    w, w_low = fast_two_sum(do, most, do("rest", lost + square_low))
    root = do("root", sqrt(sp.Abs(w)))
    reach = do("reach", choose(w < 0, gamma / STIFF, (half + root) / NEAR))
    found = w, w_low, root, reach
    return do.routine("DeviceMotion", "w = delta^2/4 - gamma, what it misses, its root and the "
                      "size of the poles", (gamma, delta),
                      dict(zip(_MOTION, found, strict=True)), "Motion")  # fmt: skip


def real_poles() -> Routine:
    """Their sum is delta, and their product is gamma; 1 in place of a p of 0."""
    do = Steps()
    half, w, w_low, root = _KEPT
    p, p_lost = fast_two_sum(do, half, root)
    p_low = do("p_low", p_lost + root_low(w, w_low, root))
    larger = do.nonzero(p), p_low
    found = *larger, *over(do, exact(gamma), larger)
    return do.routine("RealPoles", "the poles p = half + root and q = gamma/p and what they miss",
                      (gamma, *_KEPT), dict(zip(_POLES, found, strict=True)), "Poles")  # fmt: skip


def _called(name: str, small: Boolean, *arguments: Expr) -> Expr:
    """A form near the origin, of 0 elsewhere."""
    return sp.Function(name)(*(choose(small, argument, 0) for argument in arguments))


def _n1_near(small: Boolean, *given: Expr) -> Expr:
    """n1 from its power series, of the pair exp(-half), half and w."""
    fall, low, half, w = (choose(small, argument, 0) for argument in given)
    return number_and(fall, sp.S.Half, "PlantN1Series", half, w, low=low)


def _one_near(small: Boolean, half: Expr, w: Expr, envelope: Expr | None = None) -> Expr:
    """The same of n1 + n0; of a device that swings exp(-half) is there."""
    half, w = choose(small, half, 0), choose(small, w, 0)
    return 2 * number_and(envelope or exp(-half), sp.S.Half, "NumeratorAtOneSeries", half, w)


def _gap_near(small: Boolean, half: Expr, w: Expr, envelope: Expr | None = None) -> Expr:
    """The same of (n1 - n0)/delta."""
    half, w = choose(small, half, 0), choose(small, w, 0)
    return number_and(envelope or exp(-half), SIXTH, "NumeratorGapSeries", half, w)


# -- of poles that creep ------------------------------------------------------------------------


@dataclass(frozen=True)
class Creeping:
    """Of both poles: exp and mean of the slower one and of their distance."""

    slow: Fading
    apart: Fading


def _creeping(do: Steps, m: Motion) -> Creeping:
    """Guarded: without distance for a device that swings."""
    return Creeping(fading(do, (m.q, m.q_low)), fading(do, (2 * m.root, 2 * m.root_low)))


_SLOW = Fading(sp.symbols("slow slow_low"), sp.symbols("mean mean_low"))
_APART = Fading(sp.symbols("ratio ratio_low"), sp.symbols("even even_low"))
_P = sp.symbols("p p_low")
_REACH, _HALF, _W = sp.symbols("reach half w")
_FADE = sp.symbols("fade fade_low")


def plant_n1_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    found = over(do, minus(do, s.mean, times(do, s.fall, far.mean)), _P)
    given = _REACH, *_FADE, _HALF, _W, *_P, *s.flat, *far.mean
    near = _n1_near(_REACH < SOFT, *_FADE, _HALF, _W)
    return do.routine("PlantN1Creep", "n1 of a creeping device", given,
                      choose(_REACH < SOFT, near, rounded(found)))  # fmt: skip


def plant_n0_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    rest = over(do, minus(do, far.mean, times(do, far.fall, s.mean)), _P)
    found = times(do, s.fall, rest)
    near = _called("PlantN0Near", _REACH < SOFT, *_FADE, gamma, delta)
    given = _REACH, *_FADE, gamma, delta, *_P, *s.flat, *far.flat
    return do.routine("PlantN0Creep", "n0 of a creeping device", given,
                      choose(_REACH < SOFT, near, rounded(found)))  # fmt: skip


def numerator_at_one_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    fast = times(do, s.fall, far.fall)
    found = over(do, times(do, s.mean, one_minus(do, fast)), _P)
    given = _REACH, _HALF, _W, *_P, *s.flat, *far.fall
    near = _one_near(_REACH < 1, _HALF, _W)
    return do.routine("NumeratorAtOneCreep", "n1 + n0 of a creeping device", given,
                      choose(_REACH < 1, near, rounded(found)))  # fmt: skip


def denominator_at_minus_one_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    fast = times(do, s.fall, far.fall)
    found = times(do, one_plus(do, s.fall), one_plus(do, fast))
    return do.routine("DenominatorAtMinusOneCreep", "1 + a + e of a creeping device",
                      (*s.fall, *far.fall), rounded(found))  # fmt: skip


def plant_trace_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    found = times(do, s.fall, one_plus(do, far.fall))
    return do.routine("PlantTraceCreep", "a of a creeping device",
                      (*s.fall, *far.fall), rounded(found))  # fmt: skip


def numerator_gap_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), _SLOW, _APART
    slow, ratio = s.fall[0], far.fall[0]
    top, top_low = minus(do, s.mean, scaled(do, do("twice", 2 * slow), far.mean))
    more, more_low = scaled(do, do("fast", slow * ratio), s.mean)
    top, low = do("top", top + more), do("low", top_low + more_low)
    found = (top + low) / do.nonzero(_P[0] * delta)
    known = slow, *s.mean, ratio, *far.mean
    near = _gap_near(_REACH < 1, _HALF, _W)
    return do.routine("NumeratorGapCreep", "(n1 - n0)/delta of a creeping device",
                      (_REACH, _HALF, _W, delta, _P[0], *known),
                      choose(_REACH < 1, near, found))  # fmt: skip


# -- of poles that swing ------------------------------------------------------------------------


@dataclass(frozen=True)
class Swinging:
    """exp(-delta/2); cos(root), sin(root)/root and what these miss."""

    envelope: Expr
    wave: Wave


def _swinging(do: Steps, m: Motion) -> Swinging:
    wave = waving(do, (choose(m.w < 0, m.w, 0), m.w_low), m.root)
    return Swinging(do("envelope", exp(-m.half)), wave)


_WAVE = Wave(sp.symbols("even even_low"), sp.symbols("wave wave_low"))
_ENVELOPE, _ROOT, _W_LOW, _NEAR, _KNOWN = sp.symbols("envelope root w_low near known")
_CLOSED = (
    _REACH, *_FADE, _HALF, _W, _ENVELOPE, *_WAVE.even, *_WAVE.odd, gamma, _NEAR, _KNOWN,
)  # fmt: skip


def _closed(
    m: Motion, v: Swinging, turns: tuple[Expr, Expr], fade: tuple[Expr, ...]
) -> tuple[Expr, ...]:
    return (m.reach, *fade, m.half, m.w, v.envelope, *v.wave.even, *v.wave.odd, gamma, *turns)


def _chosen(small: Boolean, near: Expr, far: Expr) -> Expr:
    """A form near the origin, else what is known near whole turns, else the closed form."""
    return choose(small, near, choose(_NEAR > 0, _KNOWN, far))


def plant_n1_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), _WAVE
    both = plus(do, v.even, scaled(do, _HALF, v.odd))
    top = one_minus(do, scaled(do, _ENVELOPE, both))
    swing = rounded(over(do, top, exact(do.nonzero(gamma))))
    found = _chosen(_REACH < SOFT, _n1_near(_REACH < SOFT, *_FADE, _HALF, _W), swing)
    return do.routine("PlantN1Swing", "n1 of a swinging device", _CLOSED, found)


def plant_n0_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), _WAVE
    both = minus(do, scaled(do, _HALF, v.odd), v.even)
    top = scaled(do, _ENVELOPE, plus(do, both, exact(_ENVELOPE)))
    swing = rounded(over(do, top, exact(do.nonzero(gamma))))
    near = _called("PlantN0Near", _REACH < SOFT, *_FADE, gamma, 2 * _HALF)
    given = tuple(s for s in _CLOSED if s != _W)
    return do.routine("PlantN0Swing", "n0 of a swinging device", given,
                      _chosen(_REACH < SOFT, near, swing))  # fmt: skip


def half_squares() -> Routine:
    """Of the half angle's cosine or sine, and what that misses."""
    do = Steps()
    given = half, envelope, wave, back = sp.symbols("half envelope wave back")
    grown = do("grown", -expm1(-half) / 2)
    turned_ = scaled(do, envelope, squared(do, two_diff(do, wave, back)))
    total, low = plus(do, turned_, exact(grown * grown))
    return do.routine("HalfSquares", "(1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it "
                      "misses", given, {"total": total, "total_low": low})  # fmt: skip


def _squares(do: Steps, wave: type[sp.Function]) -> Pair:
    """(1 - exp(-delta/2))^2/4 and exp(-delta/2) times the square of sin or cos of root/2, added."""
    angle = do("angle", _ROOT / 2)
    own, other = (sin(angle), cos(angle)) if wave is sin else (cos(angle), -sin(angle))
    back = do("back", -root_low(_W, _W_LOW, _ROOT) / 2 * other)
    total, low = do.several(("total", "total_low"), "HalfSquares", _HALF, _ENVELOPE, own, back)
    return total, low


def numerator_at_one_swing() -> Routine:
    """Of a swinging device."""
    do = Steps()
    found = rounded(over(do, _squares(do, sin), exact(do.nonzero(gamma))))
    near = _one_near(_REACH < 1, _HALF, _W, _ENVELOPE)
    given = _REACH, _HALF, _W, _W_LOW, _ENVELOPE, _ROOT, gamma, _NEAR, _KNOWN
    return do.routine("NumeratorAtOneSwing", "n1 + n0 of a swinging device", given,
                      _chosen(_REACH < 1, near, 4 * found))  # fmt: skip


def denominator_at_minus_one_swing() -> Routine:
    """A sum where a > 0, a sum of squares where it is not."""
    do, v = Steps(), _WAVE
    squares = _squares(do, cos)
    turn = scaled(do, 2 * _ENVELOPE, v.even)
    both = plus(do, one_plus(do, exact(do("e", exp(-2 * _HALF)))), turn)
    return do.routine("DenominatorAtMinusOneSwing", "1 + a + e of a swinging device",
                      (_HALF, _W, _W_LOW, _ENVELOPE, *v.even, _ROOT),
                      choose(turn[0] > 0, rounded(both), 4 * rounded(squares)))  # fmt: skip


def plant_trace_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), _WAVE
    turn = scaled(do, _ENVELOPE, v.even)
    return do.routine("PlantTraceSwing", "a of a swinging device", (_ENVELOPE, *v.even),
                      2 * rounded(turn))  # fmt: skip


def numerator_gap_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), _WAVE
    mean = do("mean", Decay(delta))
    top = minus(do, exact(mean), scaled(do, _ENVELOPE, v.odd))
    swing = rounded(over(do, top, exact(do.nonzero(gamma))))
    given = _REACH, _HALF, _W, _ENVELOPE, *v.odd, gamma, delta
    near = _gap_near(_REACH < 1, _HALF, _W, _ENVELOPE)
    return do.routine("NumeratorGapSwing", "(n1 - n0)/delta of a swinging device", given,
                      choose(_REACH < 1, near, swing))  # fmt: skip


# -- near the origin, and all together ----------------------------------------------------------


def slow_fade() -> Routine:
    """Of a device that is not slow it is asked by nobody."""
    do = Steps()
    small = _REACH < SOFT
    fall, low = fallen(do, choose(small, _HALF, 0))
    return do.routine("SlowFade", "exp(-half) of a device with slow poles, and what it misses",
                      (_REACH, _HALF),
                      {"fade": choose(small, fall, 0), "fade_low": choose(small, low, 0)})  # fmt: skip


def plant_n0_near() -> Routine:
    """From its power series."""
    do = Steps()
    fall, low = squared(do, _FADE)
    found = number_and(fall, sp.S.Half, "PlantN0Series", gamma, delta, low=low)
    return do.routine(
        "PlantN0Near", "n0 of a device with slow poles", (*_FADE, gamma, delta), found
    )


def _asked(small: Boolean, near: Expr, m: Motion, swing: Expr, creep: Expr) -> Expr:
    """Its series first: of a function alone nothing else is found in vain then."""
    return choose(small, near, choose(m.w < 0, swing, creep))


def _turned(do: Steps, m: Motion) -> tuple[Expr, Expr, Expr, Expr]:
    return turned(do, m.half, m.w, m.w_low, m.root, do("stiff", gamma))


def plant_n1() -> Routine:
    """n_1."""
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    near, risen, _, _ = _turned(do, m)
    fade = do.several(("fade", "fade_low"), "SlowFade", m.reach, m.half)
    swing = sp.Function("PlantN1Swing")(*_closed(m, v, (near, risen), fade))
    own = m.reach, *fade, m.half, m.w, m.p, m.p_low, *c.slow.flat, *c.apart.mean
    creep = sp.Function("PlantN1Creep")(*own)
    found = _asked(m.reach < SOFT, _n1_near(m.reach < SOFT, *fade, m.half, m.w), m, swing, creep)
    return do.routine("PlantN1", "n1, how far a unit force moves the device in a period",
                      (gamma, delta), found)  # fmt: skip


def plant_n0() -> Routine:
    """n_0."""
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    near, _, sunk, _ = _turned(do, m)
    fade = do.several(("fade", "fade_low"), "SlowFade", m.reach, m.half)
    given = zip(_CLOSED, _closed(m, v, (near, sunk), fade), strict=True)
    swing = sp.Function("PlantN0Swing")(*(value for s, value in given if s != _W))
    own = m.reach, *fade, gamma, delta, m.p, m.p_low, *c.slow.flat, *c.apart.flat
    creep = sp.Function("PlantN0Creep")(*own)
    near_ = _called("PlantN0Near", m.reach < SOFT, *fade, gamma, delta)
    found = _asked(m.reach < SOFT, near_, m, swing, creep)
    return do.routine("PlantN0", "n0, the same device with its time reversed, times exp(-delta)",
                      (gamma, delta), found)  # fmt: skip


def numerator_at_one() -> Routine:
    """n_1 + n_0: a product for a creeping device, a sum of squares for a swinging one."""
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    near, _, _, both = _turned(do, m)
    given = m.reach, m.half, m.w, m.w_low, v.envelope, m.root, gamma, near, both
    swing = sp.Function("NumeratorAtOneSwing")(*given)
    own = m.reach, m.half, m.w, m.p, m.p_low, *c.slow.flat, *c.apart.fall
    creep = sp.Function("NumeratorAtOneCreep")(*own)
    found = _asked(m.reach < 1, _one_near(m.reach < 1, m.half, m.w), m, swing, creep)
    return do.routine("NumeratorAtOne", "n1 + n0",
                      (gamma, delta), found)  # fmt: skip


def denominator_at_minus_one() -> Routine:
    """1 + a + e: a sum where a > 0, a sum of squares where it is not."""
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    given = m.half, m.w, m.w_low, v.envelope, *v.wave.even, m.root
    swing = sp.Function("DenominatorAtMinusOneSwing")(*given)
    own = *c.slow.fall, *c.apart.fall
    creep = sp.Function("DenominatorAtMinusOneCreep")(*own)
    return do.routine("DenominatorAtMinusOne", "1 + a + e", (gamma, delta),
                      choose(m.w < 0, swing, creep))  # fmt: skip


def plant_trace() -> Routine:
    """a, the sum of the poles of the sampled device."""
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    swing = sp.Function("PlantTraceSwing")(v.envelope, *v.wave.even)
    own = *c.slow.fall, *c.apart.fall
    return do.routine("PlantTrace", "a, the sum of the sampled device's poles", (gamma, delta),
                      choose(m.w < 0, swing, sp.Function("PlantTraceCreep")(*own)))  # fmt: skip


def numerator_gap() -> Routine:
    """(n_1 - n_0)/delta; for delta = 0 and a stiff spring only a finite number.

    Forms have delta NumeratorGap alone, which is 0 there.
    """
    do = Steps()
    m = motion(do)
    c, v = _creeping(do, m), _swinging(do, m)
    slow, far = c.slow, c.apart
    own = slow.fall[0], *slow.mean, far.fall[0], *far.mean
    creep = sp.Function("NumeratorGapCreep")(m.reach, m.half, m.w, delta, m.p, *own)
    wave = v.envelope, *v.wave.odd, gamma, delta
    swing = sp.Function("NumeratorGapSwing")(m.reach, m.half, m.w, *wave)
    return do.routine("NumeratorGap", "(n1 - n0)/delta", (gamma, delta),
                      _asked(m.reach < 1, _gap_near(m.reach < 1, m.half, m.w), m,
                             swing, creep))  # fmt: skip


ROUTINES = (
    device_motion, real_poles, plant_n1_creep, plant_n0_creep, numerator_at_one_creep,
    denominator_at_minus_one_creep, plant_trace_creep, numerator_gap_creep, plant_n1_swing,
    plant_n0_swing, half_squares, numerator_at_one_swing, denominator_at_minus_one_swing,
    plant_trace_swing, numerator_gap_swing, slow_fade, plant_n0_near, plant_n1, plant_n0,
    numerator_at_one,
    denominator_at_minus_one, plant_trace, numerator_gap,
)  # fmt: skip
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
