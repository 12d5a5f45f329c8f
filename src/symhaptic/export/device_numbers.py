"""The numbers of the device as routines: where each form keeps its digits.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  Near p = q = 0 a power
series is used, beyond it closed forms that subtract no two nearly equal numbers:

    n1 = (Decay(q) - exp(-q) Decay(p - q))/p,   n0 = exp(-q) (Decay(p - q) - exp(-(p-q)) Decay(q))/p

for a creeping device, and those of cos and sin of sqrt(gamma - delta^2/4) for a swinging one,
where it is not near whole turns (whole_turns.py).
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import Expr, cos, exp, sin
from sympy.logic.boolalg import Boolean

from symhaptic.export.device import (
    APART,
    ENVELOPE,
    FADE,
    HALF,
    MOVED,
    NEAR_TURNS,
    REACH,
    RISEN,
    ROOT,
    SLOW,
    SOFT,
    SUNK,
    WAVE,
    P,
    W,
    of_device,
    shared,
)
from symhaptic.export.double_word import root_low
from symhaptic.export.elementary import SIXTH, number_and
from symhaptic.export.pairs import (
    Pair,
    exact,
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
from symhaptic.export.routine import Routine, choose, expm1
from symhaptic.export.steps import Steps
from symhaptic.forms.entire import Decay
from symhaptic.notation import delta, gamma

_SWINGING, _CREEPING = ("Motion", "Swinging"), ("Motion", "Creeping")
"""The records that a function of each kind takes its numbers from."""


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


def plant_n1_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), SLOW, APART
    found = over(do, minus(do, s.mean, times(do, s.fall, far.mean)), P)
    given = REACH, HALF, W[0], *P, *s.flat, *far.mean, *FADE
    near = _n1_near(REACH < SOFT, *FADE, HALF, W[0])
    return do.routine("PlantN1Creep", "n1 of a creeping device", given,
                      choose(REACH < SOFT, near, rounded(found)), takes=_CREEPING)  # fmt: skip


def plant_n0_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), SLOW, APART
    rest = over(do, minus(do, far.mean, times(do, far.fall, s.mean)), P)
    found = times(do, s.fall, rest)
    near = _called("PlantN0Near", REACH < SOFT, *FADE, gamma, delta)
    given = REACH, *P, *s.flat, *far.flat, *FADE, gamma, delta
    return do.routine("PlantN0Creep", "n0 of a creeping device", given,
                      choose(REACH < SOFT, near, rounded(found)), takes=_CREEPING)  # fmt: skip


def numerator_at_one_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), SLOW, APART
    fast = times(do, s.fall, far.fall)
    found = over(do, times(do, s.mean, one_minus(do, fast)), P)
    given = REACH, HALF, W[0], *P, *s.flat, *far.fall
    near = _one_near(REACH < 1, HALF, W[0])
    return do.routine("NumeratorAtOneCreep", "n1 + n0 of a creeping device", given,
                      choose(REACH < 1, near, rounded(found)), takes=_CREEPING)  # fmt: skip


def denominator_at_minus_one_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), SLOW, APART
    fast = times(do, s.fall, far.fall)
    found = times(do, one_plus(do, s.fall), one_plus(do, fast))
    return do.routine("DenominatorAtMinusOneCreep", "1 + a + e of a creeping device",
                      (*s.fall, *far.fall), rounded(found), takes=_CREEPING)  # fmt: skip


def numerator_gap_creep() -> Routine:
    """Of a creeping device."""
    do, s, far = Steps(), SLOW, APART
    slow, ratio = s.fall[0], far.fall[0]
    top, top_low = minus(do, s.mean, scaled(do, do("twice", 2 * slow), far.mean))
    more, more_low = scaled(do, do("fast", slow * ratio), s.mean)
    top, low = do("top", top + more), do("low", top_low + more_low)
    found = (top + low) / do.divisor(P[0] * delta)
    known = slow, *s.mean, ratio, *far.mean
    given = REACH, HALF, W[0], P[0], *known, delta
    near = _gap_near(REACH < 1, HALF, W[0])
    return do.routine("NumeratorGapCreep", "(n1 - n0)/delta of a creeping device",
                      given, choose(REACH < 1, near, found), takes=_CREEPING)  # fmt: skip


# -- of poles that swing ------------------------------------------------------------------------


def _chosen(small: Boolean, near: Expr, known: Expr, far: Expr) -> Expr:
    """A form near the origin, else what is known near whole turns, else the closed form."""
    return choose(small, near, choose(NEAR_TURNS > 0, known, far))


def plant_n1_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), WAVE
    both = plus(do, v.even, scaled(do, HALF, v.odd))
    top = one_minus(do, scaled(do, ENVELOPE, both))
    swing = rounded(over(do, top, exact(do.divisor(gamma))))
    near = _n1_near(REACH < SOFT, *FADE, HALF, W[0])
    given = REACH, HALF, W[0], ENVELOPE, *v.even, *v.odd, NEAR_TURNS, RISEN, *FADE, gamma
    return do.routine("PlantN1Swing", "n1 of a swinging device", given,
                      _chosen(REACH < SOFT, near, RISEN, swing), takes=_SWINGING)  # fmt: skip


def plant_n0_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), WAVE
    both = minus(do, scaled(do, HALF, v.odd), v.even)
    top = scaled(do, ENVELOPE, plus(do, both, exact(ENVELOPE)))
    swing = rounded(over(do, top, exact(do.divisor(gamma))))
    near = _called("PlantN0Near", REACH < SOFT, *FADE, gamma, 2 * HALF)
    given = REACH, HALF, ENVELOPE, *v.even, *v.odd, NEAR_TURNS, SUNK, *FADE, gamma
    return do.routine("PlantN0Swing", "n0 of a swinging device", given,
                      _chosen(REACH < SOFT, near, SUNK, swing), takes=_SWINGING)  # fmt: skip


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
    angle = do("angle", ROOT / 2)
    own, other = (sin(angle), cos(angle)) if wave is sin else (cos(angle), -sin(angle))
    back = do("back", -root_low(*W, ROOT) / 2 * other)
    total, low = do.several(("total", "total_low"), "HalfSquares", HALF, ENVELOPE, own, back)
    return total, low


def numerator_at_one_swing() -> Routine:
    """Of a swinging device."""
    do = Steps()
    found = rounded(over(do, _squares(do, sin), exact(do.divisor(gamma))))
    near = _one_near(REACH < 1, HALF, W[0], ENVELOPE)
    given = REACH, HALF, *W, ROOT, ENVELOPE, NEAR_TURNS, MOVED, gamma
    return do.routine("NumeratorAtOneSwing", "n1 + n0 of a swinging device", given,
                      _chosen(REACH < 1, near, MOVED, 4 * found), takes=_SWINGING)  # fmt: skip


def denominator_at_minus_one_swing() -> Routine:
    """A sum where a > 0, a sum of squares where it is not."""
    do, v = Steps(), WAVE
    squares = _squares(do, cos)
    turn = scaled(do, 2 * ENVELOPE, v.even)
    both = plus(do, one_plus(do, exact(do("e", exp(-2 * HALF)))), turn)
    return do.routine("DenominatorAtMinusOneSwing", "1 + a + e of a swinging device",
                      (HALF, *W, ROOT, ENVELOPE, *v.even),
                      choose(turn[0] > 0, rounded(both), 4 * rounded(squares)),
                      takes=_SWINGING)  # fmt: skip


def numerator_gap_swing() -> Routine:
    """Of a swinging device."""
    do, v = Steps(), WAVE
    mean = do("mean", Decay(delta))
    top = minus(do, exact(mean), scaled(do, ENVELOPE, v.odd))
    swing = rounded(over(do, top, exact(do.divisor(gamma))))
    given = REACH, HALF, W[0], ENVELOPE, *v.odd, gamma, delta
    near = _gap_near(REACH < 1, HALF, W[0], ENVELOPE)
    return do.routine("NumeratorGapSwing", "(n1 - n0)/delta of a swinging device", given,
                      choose(REACH < 1, near, swing), takes=_SWINGING)  # fmt: skip


# -- near the origin, and all together ----------------------------------------------------------


def plant_n0_near() -> Routine:
    """From its power series."""
    do = Steps()
    fall, low = squared(do, FADE)
    found = number_and(fall, sp.S.Half, "PlantN0Series", gamma, delta, low=low)
    return do.routine("PlantN0Near", "n0 of a device with slow poles", (*FADE, gamma, delta), found)


def plant_n1() -> Routine:
    """n_1; its series first: of a function alone nothing else is found in vain then."""
    do = Steps()
    v = shared(do, fades=True)
    small = v.m.reach < SOFT
    near = _n1_near(small, *(v.creep[s] for s in (*FADE, HALF, W[0])))
    return of_device(do, "PlantN1", "n1, how far a unit force moves the device in a period",
                  choose(small, near, v.called(plant_n1_swing, plant_n1_creep)))  # fmt: skip


def plant_n0() -> Routine:
    """n_0; its series first."""
    do = Steps()
    v = shared(do, fades=True)
    small = v.m.reach < SOFT
    near = _called("PlantN0Near", small, *(v.creep[s] for s in (*FADE, gamma, delta)))
    return of_device(do, "PlantN0", "n0, the same device with its time reversed, times exp(-delta)",
                  choose(small, near, v.called(plant_n0_swing, plant_n0_creep)))  # fmt: skip


def numerator_at_one() -> Routine:
    """n_1 + n_0: a product for a creeping device, a sum of squares for a swinging one."""
    do = Steps()
    v = shared(do)
    small = v.m.reach < 1
    near = _one_near(small, v.m.half, v.m.w)
    return of_device(do, "NumeratorAtOne", "n1 + n0",
                  choose(small, near, v.called(numerator_at_one_swing,
                                               numerator_at_one_creep)))  # fmt: skip


def denominator_at_minus_one() -> Routine:
    """1 + a + e: a sum where a > 0, a sum of squares where it is not."""
    do = Steps()
    found = shared(do).called(denominator_at_minus_one_swing, denominator_at_minus_one_creep)
    return of_device(do, "DenominatorAtMinusOne", "1 + a + e", found)


def plant_trace() -> Routine:
    """a, the sum of the poles of the sampled device."""
    do = Steps()
    v = shared(do)
    even, slow, ratio = v.swing_pair(WAVE.even), v.creep_pair(SLOW.fall), v.creep_pair(APART.fall)
    swing = 2 * rounded(scaled(do, v.swing[ENVELOPE], even))
    creep = rounded(times(do, slow, one_plus(do, ratio)))
    return of_device(do, "PlantTrace", "a, the sum of the sampled device's poles",
                  choose(v.m.w < 0, swing, creep))  # fmt: skip


def numerator_gap() -> Routine:
    """(n_1 - n_0)/delta; for delta = 0 and a stiff spring only a finite number.

    Forms have delta NumeratorGap alone, which is 0 there.
    """
    do = Steps()
    v = shared(do)
    small = v.m.reach < 1
    near = _gap_near(small, v.m.half, v.m.w)
    found = v.called(numerator_gap_swing, numerator_gap_creep)
    return of_device(do, "NumeratorGap", "(n1 - n0)/delta", choose(small, near, found))


ROUTINES = (
    plant_n1_creep, plant_n0_creep, numerator_at_one_creep, denominator_at_minus_one_creep,
    numerator_gap_creep, plant_n1_swing, plant_n0_swing, half_squares, numerator_at_one_swing,
    denominator_at_minus_one_swing, numerator_gap_swing, plant_n0_near, plant_n1, plant_n0,
    numerator_at_one, denominator_at_minus_one, plant_trace, numerator_gap,
)  # fmt: skip
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
