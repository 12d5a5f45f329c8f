r"""The walls with a root on a piece of the unit circle, for a piece of the arms, in boxes.

With :math:`\kappa=d+1/2` and the late plant's
:math:`V=m_2z^{\varepsilon+1/2}+m_1z^{\varepsilon-1/2}+m_0z^{\varepsilon-3/2}` a wall with a root at
:math:`z=e^{j\theta}` is

.. math:: K+\frac BT(1-z^{-1}) = \frac{z^\kappa}{V}\Bigl(\bigl(1-\tfrac L2\bigr)\frac{ym}{T^2}-kS
          -j\frac{b\lambda}{T}\sin\theta\Bigr),\qquad y=4\sin^2\tfrac\theta2,

where :math:`L=1-e^{-\delta}=\lambda\delta` and :math:`S=m_2+m_1+m_0`.  The mass and the spring are
in one real number; without it remains K = (B + b sigma)/(T tau), which for a small angle is the
linear condition K = (B + b)/(T kappa), and nothing is divided by a small angle.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from flint import arb, arb_series

from symhaptic.bounds.balls import exact, sinc
from symhaptic.bounds.safe.arms import Ends, Hands, Loops, Moved, midway, moved, ratios, span

_TERMS = 24
"""Terms of the series of a period's motion."""


class Late(NamedTuple):
    """The sampled plants of a box of arms behind a part of a period, with S = m2 + m1 + m0."""

    second: arb
    """m2/S."""
    first: arb
    """m1/S."""
    last: arb
    """m0/S."""
    weight: arb
    """(1 - L/2)/S, of the mass."""
    share: arb
    """lambda/S, of the damper."""
    moved: Moved
    drift: tuple[arb, arb, arb]
    """How these m2, m1 and m0 change with the delay, per period; their sum does not."""


class Walls(NamedTuple):
    """Where the walls of a piece lie, in N/m and Ns/m; infinite where that is not known."""

    K: tuple[float, float]
    B: tuple[float, float]
    lag: tuple[float, float] | None
    """T tau in s: the slope of B over K, where it is positive."""
    held: tuple[float, float]
    """b sigma in Ns/m: B + b sigma = T tau K."""
    size: float
    """|K + B/T (1 - 1/z)| in N/m is not below this."""


NOWHERE = (-math.inf, math.inf)


Number: TypeAlias = arb | arb_series


class TooWide(ArithmeticError):
    """Plants so different that their numbers are not enclosed."""


def motion(g: Number, f: Number, time: arb, rest: Number) -> tuple[Number, Number]:
    """Position and speed after ``time`` <= 1 of unit force: the series of x'' + f x' + g x = 1.

    Its terms c_j t^j obey (j + 2)(j + 1) c_{j+2} = -f (j + 1) c_{j+1} - g c_j; with
    q = max(|f|, |g|, 1) they are not above (2 q)^(j - 2)/j!, and ``rest`` bounds what is left out.
    """
    terms: list[Number] = [arb(0) * f, arb(0) * f, arb(0) * f + arb(1) / 2]
    for j in range(1, _TERMS - 2):
        terms.append((f * terms[j + 1] * (j + 1) + g * terms[j]) * (arb(-1) / ((j + 2) * (j + 1))))
    x, v = terms[-1] * time, terms[-1] * (_TERMS - 1)
    for j in range(_TERMS - 2, 0, -1):
        x, v = (x + terms[j]) * time, v * time + terms[j] * j
    return x + rest, v + rest


def _rest(q: float) -> float:
    """A bound of all terms from ``_TERMS`` on, and of their derivatives, for times up to 1."""
    rate = 2 * q  # j! c_j grows by at most q rate + q <= rate^2 over two terms
    first = rate ** (_TERMS - 2) / math.factorial(_TERMS - 1)
    return math.inf if rate / _TERMS > 0.5 else 4 * first


def left_out(q: float) -> tuple[arb, arb]:
    """Balls around 0 of the terms that are left out, and of their derivatives by g or f.

    A derivative is at most the bound on a circle of radius 1 (Cauchy's estimate).
    """
    return arb(0, _rest(q)), arb(0, _rest(q + 1))


def _numbers(loops: Loops, g: Number, f: Number, rest: Number) -> tuple[Number, ...]:
    """What a :class:`Late` has, without the arm."""
    x, v = motion(g, f, arb(1), rest)
    m2, m1, m0 = x, v * v - (1 - f * v - g * x) * x, arb(0) * f
    if any(loops.part):
        kept = 1 - f * v - g * x
        m2, speed = motion(g, f, 1 - span(loops.part), rest)
        m1 = v * speed - kept * m2 + x - m2
        m0 = v * (v - speed) - kept * (x - m2)
    share = f * (arb(-1) / _TERMS) + 1  # (1 - exp(-f))/f, whose terms are those of exp at most
    for j in range(_TERMS - 1, 1, -1):
        share = f * share * (arb(-1) / j) + 1
    share = share + rest
    total = m2 + m1 + m0
    if (total if isinstance(total, arb) else total[0]).contains(0):
        raise TooWide
    return m2 / total, m1 / total, m0 / total, (1 - f * share / 2) / total, share / total


@lru_cache(maxsize=1 << 16)
def late(loops: Loops, hands: Hands) -> Late:
    """The plants of a box of arms: those of its middle, and slopes times the way from there."""
    if loops.periods[0] < loops.periods[1]:
        return _later(loops, hands)
    g, f = ratios(loops, hands)
    q = max(1.0, float(abs(f).upper()), float(abs(g).upper())) * (1 + 2**-40)
    near, beyond = left_out(q)
    g_0, f_0 = g.mid(), f.mid()
    slope = arb_series([near, beyond], 2)
    try:
        by_g = _numbers(loops, arb_series([g, 1], 2), arb_series([f, 0], 2), slope)
        by_f = _numbers(loops, arb_series([g, 0], 2), arb_series([f, 1], 2), slope)
    except TooWide:
        found = [arb("nan")] * 5
        return Late(found[0], found[1], found[2], found[3], found[4], moved(loops, hands), _STILL)
    middle = _numbers(loops, g_0, f_0, near)
    slopes = zip(middle, by_g, by_f, strict=True)
    found = [value + up[1] * (g - g_0) + far[1] * (f - f_0) for value, up, far in slopes]
    return Late(found[0], found[1], found[2], found[3], found[4], moved(loops, hands), _STILL)


_STILL = (arb(0), arb(0), arb(0))


def _later(loops: Loops, hands: Hands) -> Late:
    """The plants for all delays of a range: those of its middle, and how they change from there."""
    g, f = ratios(loops, hands)
    rest = arb(0, _rest(max(1.0, float(abs(f).upper()), float(abs(g).upper())) * (1 + 2**-40)))
    x, v = motion(g, f, arb(1), rest)
    first, speed = motion(g, f, 1 - span(loops.part), rest)
    kept, pull = 1 - f * v - g * x, 1 - f * speed - g * first
    total = x + v * v - kept * x
    back = v * pull - kept * speed
    drift = (-speed / total, (speed - back) / total, back / total)
    middle = late(midway(loops), hands)
    away = span(loops.periods) - exact(midway(loops).periods[0])
    ends = [m + away * by for m, by in zip(middle[:3], drift, strict=True)]
    return Late(ends[0], ends[1], ends[2], middle.weight, middle.share, middle.moved, drift)


def _seen(loops: Loops, hands: Hands, low: arb, high: arb) -> tuple[arb, arb]:
    """The real part of V/S, and its imaginary part over theta, on a piece of the circle."""
    plant, theta = late(loops, hands), low.union(high)
    if loops.periods[0] == loops.periods[1]:
        eps = exact(loops.part[0])
        terms = list(zip(plant[:3], (eps + _HALF, eps - _HALF, eps - 3 * _HALF), strict=True))
        right = sum((m * (c * theta).cos() for m, c in terms), arb(0))
        return right, sum((m * c * _turned(c, low, high) for m, c in terms), arb(0))
    middle = midway(loops)
    right, up = _seen(middle, hands, low, high)
    away, eps = span(loops.periods) - exact(middle.periods[0]), span(loops.part)
    by_right, by_up = arb(0), arb(0)
    for m, by, c in zip(
        plant[:3], plant.drift, (eps + _HALF, eps - _HALF, eps - 3 * _HALF), strict=True
    ):
        cosine = (c * theta).cos()
        by_right += by * cosine - m * theta * (c * theta).sin()
        by_up += by * c * _turned(c, low, high) + m * cosine
    return right + away * by_right, up + away * by_up


def walls(loops: Loops, angles: Ends, hands: Hands) -> Walls:
    """Where the walls lie that have a root exp(j theta) for some arm and angle of the piece."""
    plant = late(loops, hands)
    low, high = exact(angles[0]), exact(angles[1])
    theta = low.union(high)
    period, turns = exact(loops.period), span(loops.periods) + _HALF
    psi = theta * turns
    sine, s = theta.sin(), (low / 2).sin().union((high / 2).sin())
    tangent, cosine, across = s / (theta / 2).cos(), psi.cos(), psi.sin()
    spread = sinc(low, high)
    right, lifted = _seen(loops, hands, low, high)
    up, aside = lifted / spread, lifted * theta
    size = right * right + aside * aside  # a ball around 0 itself to the second power is NaN
    along = (right * cosine + aside * across) / size
    beside = (right * across - aside * cosine) / size
    pushed, dragged = along - tangent * beside, sine * (beside + tangent * along)
    ratio = sinc(low * turns.lower(), high * turns.upper()) / spread
    rise = (right * turns * ratio - up * cosine) / size
    mass, damping, stiffness = plant.moved
    heavy = (
        mass[0] * (2 * (low / 2).sin() / period) ** 2,
        mass[1] * (2 * (high / 2).sin() / period) ** 2,
    )
    weight, share = plant.weight, plant.share

    def push(c: arb) -> arb:
        """((1 - L/2)/S y m/T^2 - k) c."""
        return _times(heavy, weight * c) - _times(stiffness, c)

    K = push(pushed) + _times(damping, share * dragged / period)
    B = period * push(rise) - _times(damping, share * along)
    slope = rise / pushed
    held = _times(damping, share * (along + dragged * slope))
    strong, lost = push(arb(1)), _times(damping, share * sine / period)
    least = (strong.abs_lower() ** 2 + lost.abs_lower() ** 2) / size.abs_upper()
    known = size.is_finite() and least.is_finite()
    return Walls(
        _ends(K),
        _ends(B),
        _ends(period * slope) if pushed > 0 and slope > 0 else None,
        _ends(held),
        max(0.0, _low(least.sqrt())) if known else 0.0,
    )


def _times(ends: tuple[arb, arb], c: arb) -> arb:
    """c times all numbers between two; a ball around these would lose their sign."""
    return (ends[0] * c).union(ends[1] * c)


_HALF = arb(1) / 2


def _turned(c: arb, low: arb, high: arb) -> arb:
    """sin(c theta)/(c theta)."""
    return sinc(low * c.abs_lower(), high * c.abs_upper())


def _ends(value: arb) -> tuple[float, float]:
    return (_low(value), _high(value)) if value.is_finite() else NOWHERE


def _low(value: arb) -> float:
    found = math.nextafter(float(value.lower()), -math.inf)
    return found if math.isfinite(found) else -math.inf


def _high(value: arb) -> float:
    found = math.nextafter(float(value.upper()), math.inf)
    return found if math.isfinite(found) else math.inf
