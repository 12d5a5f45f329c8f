r"""The entire functions of the device as routines: where each form keeps its digits.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  Near p = q = 0 a power
series is used, beyond it closed forms that subtract no two nearly equal numbers:

    n1 = (Decay(q) - exp(-q) Decay(p - q))/p,   n0 = exp(-q) (Decay(p - q) - exp(-(p-q)) Decay(q))/p

for a creeping device, and those of cos and sin of sqrt(gamma - delta^2/4) for a swinging one,
where it is not near whole turns (whole_turns.py).
The poles are kept to twice the precision of a float, since exp(-q) magnifies their error by q.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, cos, exp, sin, sqrt
from sympy.logic.boolalg import Boolean

from symhaptic.export import whole_turns
from symhaptic.export.device_series import NEAR
from symhaptic.export.elementary import SIXTH, number_and
from symhaptic.export.pairs import Fading, fading, fallen, waving
from symhaptic.export.precision import DOUBLE, Precision
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
from symhaptic.export.whole_turns import Turned, turned
from symhaptic.forms.entire import Decay
from symhaptic.notation import delta, gamma

SOFT = sp.Rational(9, 16)
"""The part of both up to which n1 and n0 use them."""

STIFF = sp.Integer(4)
"""Up to this gamma, the squared size of complex poles."""

# -- the motion: w = delta^2/4 - gamma and both poles, to twice the precision -----------------


@dataclass(frozen=True)
class Motion:
    """What the functions of gamma and delta share, as names of steps."""

    half: Expr
    """delta/2."""
    w: Expr
    w_low: Expr
    """Its rounding error."""
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
    small: Boolean
    """Whether the power series serve."""
    soft: Boolean
    """Whether those of n1 and n0 do, whose closed forms lose nothing earlier."""


def _cases(m: Motion, small: Boolean, near: Expr, swing: Expr, creep: Expr) -> Expr:
    """One of three: by the power series, for a swinging device, for a creeping one."""
    return choose(m.w < 0, choose(small, near, swing), choose(small, near, creep))


def motion(do: Steps) -> Motion:
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
    reach = do("reach", choose(value < 0, gamma / STIFF, p / NEAR))
    small, soft = reach < 1, reach < SOFT
    return Motion(half, value, low, root, root_low, some, p, whole, p_low, q, q_low, small, soft)


@dataclass(frozen=True)
class Creeping:
    """Of both poles: exp and mean of the slower one and of their distance."""

    slow: Fading
    apart: Fading


def _creeping(do: Steps, m: Motion) -> Creeping:
    """Guarded: without distance for a device that swings."""
    return Creeping(fading(do, m.q, m.q_low), fading(do, 2 * m.root, 2 * m.root_low))


@dataclass(frozen=True)
class Swinging:
    """exp(-delta/2), cos(root), sin(root)/root and delta/2 times that, with what these miss."""

    envelope: Expr
    even: Expr
    even_low: Expr
    wave: Expr
    wave_low: Expr
    odd: Expr
    odd_low: Expr
    stiff: Expr
    """gamma where the device swings."""


def _swinging(do: Steps, m: Motion) -> Swinging:
    swings = choose(m.soft, 1, choose(m.w < 0, gamma, 1))
    v = waving(do, choose(m.w < 0, m.w, 0), m.w_low, m.root, m.root_low)
    odd, odd_low = product(do, m.half, v.odd, v.odd_low)
    envelope = do("envelope", exp(-m.half))
    return Swinging(
        envelope, v.even, v.even_low, v.odd, v.odd_low, odd, odd_low, do("stiff", swings)
    )


def _turned(do: Steps, m: Motion, precision: Precision) -> Turned:
    return turned(do, m.half, m.w, m.w_low, m.root, m.root_low, precision)


def rise(precision: Precision = DOUBLE) -> Routine:
    """n_1."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    pulled, lost = product(do, c.slow.fall, c.apart.mean, c.apart.mean_low)
    pulled_low = do("pulled_low", lost + c.slow.fall_low * c.apart.mean)
    top, top_low = difference(do, c.slow.mean, pulled)
    creep, missed = quotient(do, top, m.whole, top_low + (c.slow.mean_low - pulled_low), m.p_low)
    v = _swinging(do, m)
    both, lost = difference(do, v.even, -v.odd)
    left, left_low = product(do, v.envelope, both, lost + (v.even_low + v.odd_low))
    top, lost = fast_sum(do, sp.S.One, -left)
    swing, more = quotient(do, top, v.stiff, lost - left_low)
    turns = _turned(do, m, precision)
    swing = choose(turns.near, whole_turns.risen(do, turns, v.stiff), swing + more)
    half = do("half", choose(m.soft, m.half, 0))
    decayed, lost = fallen(do, half)
    given = half, choose(m.soft, m.w, 0)
    near = number_and(do, decayed, sp.S.Half, "RiseSeries", *given, low=lost)
    return do.routine("Rise", "n1, how far a unit force moves the device in a period",
                      (gamma, delta),
                      _cases(m, m.soft, near, swing, creep + missed))  # fmt: skip


def fall(precision: Precision = DOUBLE) -> Routine:
    """n_0."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    pulled, lost = product(do, c.apart.fall, c.slow.mean, c.slow.mean_low)
    pulled_low = do("pulled_low", lost + c.apart.fall_low * c.slow.mean)
    top, top_low = difference(do, c.apart.mean, pulled)
    rest, missed = quotient(do, top, m.whole, top_low + (c.apart.mean_low - pulled_low), m.p_low)
    creep, lost = product(do, c.slow.fall, rest, missed)
    creep = do("creep", creep + (lost + c.slow.fall_low * rest))
    v = _swinging(do, m)
    top, top_low = difference(do, v.odd, v.even)
    top, lost = difference(do, top, -v.envelope)
    top, top_low = product(do, v.envelope, top, lost + (top_low + v.odd_low - v.even_low))
    swing, missed = quotient(do, top, v.stiff, top_low)
    turns = _turned(do, m, precision)
    swing = choose(turns.near, whole_turns.fallen(do, turns, v.stiff), swing + missed)
    decayed, lost = fallen(do, choose(m.soft, m.half, 0))
    decayed, lost = product(do, decayed, decayed, 2 * lost)
    given = choose(m.soft, gamma, 0), choose(m.soft, delta, 0)
    near = number_and(do, decayed, sp.S.Half, "FallSeries", *given, low=lost)
    return do.routine("Fall", "n0, the same device with its time reversed, times exp(-delta)",
                      (gamma, delta), _cases(m, m.soft, near, swing, creep))  # fmt: skip


def together(precision: Precision = DOUBLE) -> Routine:
    """n_1 + n_0: a product for a creeping device, a sum of squares for a swinging one."""
    do = Steps()
    m = motion(do)
    v = _swinging(do, m)
    total, low = _squares(do, m, v, sin)
    swing, missed = quotient(do, total, v.stiff, low)
    turns = _turned(do, m, precision)
    swing = choose(turns.near, whole_turns.both(do, turns, v.stiff), 4 * (swing + missed))
    c = _creeping(do, m)
    fast, fast_low = _faster(do, c)
    gone, lost = fast_sum(do, sp.S.One, -fast)
    moved, moved_low = product(do, c.slow.mean, gone, lost - fast_low)
    moved_low = do("moved_low", moved_low + c.slow.mean_low * gone)
    creep, rest = quotient(do, moved, m.whole, moved_low, m.p_low)
    given = choose(m.small, m.half, 0), choose(m.small, m.w, 0)
    near = 2 * number_and(do, exp(-m.half), sp.S.Half, "TogetherSeries", *given)
    return do.routine("Together", "n1 + n0", (gamma, delta),
                      _cases(m, m.small, near, swing, creep + rest))  # fmt: skip


def _faster(do: Steps, c: Creeping) -> tuple[Expr, Expr]:
    """exp(-p), of the faster pole."""
    fast, low = product(do, c.slow.fall, c.apart.fall, c.apart.fall_low)
    return fast, do("low", low + c.slow.fall_low * c.apart.fall)


def _squares(do: Steps, m: Motion, v: Swinging, wave: type[sp.Function]) -> tuple[Expr, Expr]:
    """(1 - exp(-delta/2))^2/4 and exp(-delta/2) times the square of sin or cos of root/2, added."""
    grown = do("grown", -expm1(-m.half) / 2)
    angle = do("angle", m.root / 2)
    own, other = (sin(angle), cos(angle)) if wave is sin else (cos(angle), -sin(angle))
    first, lost = difference(do, do("wave", own), do("back", -m.root_low / 2 * other))
    square, low = product(do, first, first)
    turned, turned_low = product(do, v.envelope, square, do("low", low + 2 * first * lost))
    total, rest = difference(do, turned, -grown * grown)
    return total, do("low", rest + turned_low)


def nyquist() -> Routine:
    """1 + a + e: a sum where a > 0, a sum of squares where it is not."""
    do = Steps()
    m = motion(do)
    v = _swinging(do, m)
    total, low = _squares(do, m, v, cos)
    c = _creeping(do, m)
    ends, lost = fast_sum(do, sp.S.One, do("e", exp(-delta)))
    turn, turn_low = product(do, do("twice", 2 * v.envelope), v.even, v.even_low)
    both, rest = fast_sum(do, ends, turn)
    swing = choose(turn > 0, both + (rest + lost + turn_low), 4 * (total + low))
    one, one_low = fast_sum(do, sp.S.One, c.slow.fall)
    fast, fast_low = _faster(do, c)
    two, two_low = fast_sum(do, sp.S.One, fast)
    found, missed = product(do, one, two, two_low + fast_low)
    creep = found + (missed + (one_low + c.slow.fall_low) * two)
    return do.routine("Nyquist", "1 + a + e", (gamma, delta), choose(m.w < 0, swing, creep))


def swing() -> Routine:
    """a, the sum of the poles of the sampled device."""
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    v = _swinging(do, m)
    turn, lost = product(do, v.envelope, v.even, v.even_low)
    both, rest = fast_sum(do, sp.S.One, c.apart.fall)
    creep, more = product(do, c.slow.fall, both, rest + c.apart.fall_low)
    creep = do("creep", creep + (more + c.slow.fall_low * both))
    return do.routine("Swing", "a, the sum of the sampled device's poles", (gamma, delta),
                      choose(m.w < 0, 2 * (turn + lost), creep))  # fmt: skip


def apart() -> Routine:
    """(n_1 - n_0)/delta; for delta = 0 and a stiff spring only a finite number.

    Forms have delta Apart alone, which is 0 there.
    """
    do = Steps()
    m = motion(do)
    c = _creeping(do, m)
    fast = do("fast", c.slow.fall * c.apart.fall)
    twice = do("twice", 2 * c.slow.fall)
    pulled, pulled_low = product(do, twice, c.apart.mean, c.apart.mean_low)
    top, top_low = difference(do, c.slow.mean, pulled)
    more, more_low = product(do, fast, c.slow.mean, c.slow.mean_low)
    top = do("top", top + more)
    low = do("low", top_low + (c.slow.mean_low + more_low - pulled_low))
    creep = (top + low) / do.nonzero(m.p * delta)
    v = _swinging(do, m)
    mean = do("mean", Decay(delta))
    turn, turn_low = product(do, v.envelope, v.wave, v.wave_low)
    top, rest = difference(do, mean, turn)
    swing, missed = quotient(do, top, v.stiff, rest - turn_low)
    swing = swing + missed
    given = choose(m.small, m.half, 0), choose(m.small, m.w, 0)
    near = number_and(do, exp(-m.half), SIXTH, "ApartSeries", *given)
    return do.routine(
        "Apart", "(n1 - n0)/delta", (gamma, delta), _cases(m, m.small, near, swing, creep)
    )


ROUTINES = (nyquist, swing, apart)
PRECISE = (rise, fall, together)
