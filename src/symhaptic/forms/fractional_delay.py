r"""The device behind a delay of l + epsilon periods, in forms for computing.

With :math:`M=m_2z^2+m_1z+m_0`, where :math:`m_2=(1-\varepsilon)^2n_1` of a period
:math:`1-\varepsilon` times as long, :math:`m_0=\varepsilon^2e^{-\delta(1-\varepsilon)}n_0` of one
:math:`\varepsilon` times as long, and :math:`m_2+m_1+m_0=n_1+n_0`; chapter s6a_fractional_plant.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy import Expr, Rational, cosh, exp, sinh

from symhaptic.forms.entire import Creep, Decay, Fade, Kick, Lag, NumeratorGap, PlantN0, PlantN1, S
from symhaptic.forms.response import FractionalNumeratorGap, HalfTurned, KickLow, closed
from symhaptic.model import boundary, fractional, plant
from symhaptic.model.fractional import Late
from symhaptic.model.parts import Parts
from symhaptic.model.passivity import on_circle
from symhaptic.model.plant import Plant, Sampled
from symhaptic.notation import a, c, delta, e, epsilon, gamma, l, m_0, m_1, m_2, n_0, n_1, z

HALF = Rational(1, 2)


def rise(parts: Parts, time: Expr) -> Expr:
    """n_1 of a period ``time`` times as long, in units of the squared period."""
    if parts.stiffness and parts.damping:
        return PlantN1(gamma * time**2, delta * time)
    if parts.damping:
        return Creep(delta * time)
    return S(-gamma * time**2 / 4) ** 2 / 2 if parts.stiffness else HALF


def fall(parts: Parts, time: Expr) -> Expr:
    """n_0 of such a period."""
    if parts.stiffness and parts.damping:
        return PlantN0(gamma * time**2, delta * time)
    return Fade(delta * time) if parts.damping else rise(parts, time)


def ends(parts: Parts, part: Expr = epsilon) -> tuple[Expr, Expr]:
    """m_2 and m_0."""
    rest = 1 - part
    kept = exp(-delta * rest) if parts.damping else sp.S.One
    return rest**2 * rise(parts, rest), part**2 * kept * fall(parts, part)


@dataclass(frozen=True)
class Brief:
    """The device after a part of a period, in units of the whole one."""

    rise: Expr
    """n_1 of that part."""
    fall: Expr
    """n_0."""
    apart: Expr
    """n_1 - n_0."""
    kick: Expr
    """Its displacement by a unit impulse."""
    kick_low: Expr
    """What the float of that over the time misses."""
    loss: Expr
    """1 - e."""


def brief(parts: Parts, time: Expr) -> Brief:
    """In entire functions."""
    own, sunk = rise(parts, time), fall(parts, time)
    loss = delta * time * Decay(delta * time) if parts.damping else sp.S.Zero
    low = sp.S.Zero
    if parts.stiffness and parts.damping:
        given = gamma * time**2, delta * time
        apart, kick, low = delta * time * NumeratorGap(*given), Kick(*given), KickLow(*given)
    elif parts.damping:
        apart, kick = delta * time * Lag(delta * time), Decay(delta * time)
    else:
        apart, kick = sp.S.Zero, S(-gamma * time**2) if parts.stiffness else sp.S.One
    return Brief(time**2 * own, time**2 * sunk, time**2 * apart, time * kick, low, loss)


def at_minus_one(parts: Parts, first: Brief, last: Brief) -> Expr:
    """m_2 - m_1 + m_0, made of the period's rest and of its beginning.

    A period is one part after the other, so that n_1 = R + (1 - gamma R) r + k K, in capitals what
    belongs to the rest, and n_0 is found from the time reversed.  Nothing is as large as n_1 here,
    where little is left of it.
    """
    spring = gamma if parts.stiffness else sp.S.Zero
    damper = delta if parts.damping else sp.S.Zero
    slowed = damper * last.kick + spring * last.rise
    turned = slowed * first.fall - first.loss * last.fall + spring * first.rise * last.rise
    kicks = first.kick / (1 - epsilon), first.kick_low, last.kick / epsilon, last.kick_low
    found = FractionalNumeratorGap(epsilon, *kicks, first.apart, last.apart, turned)
    return HalfTurned(found, gamma, damper, epsilon) if parts.stiffness else found


def half_turned(parts: Parts) -> Expr:
    """m_2 - m_1 + m_0 as a sum of terms that vanish with the damping or with cosh(c/4).

    c is the difference of the poles: cosh(c/4) is the cosine of half of what an undamped device
    turns in a period, and 0 at an odd number of half turns.
    """
    half = delta / 2 if parts.damping else sp.S.Zero
    before = HALF - epsilon
    grown, strong, weak = exp(-half * before), cosh(half / 2), sinh(half / 2)
    even, odd = cosh(c / 4), sinh(c / 4)
    along, across = cosh(c * before / 2), sinh(c * before / 2)
    ratio = 2 * half / c
    total = (
        2 * even * sinh(c * (1 - epsilon) / 4) * sinh(c * epsilon / 4)
        + weak**2
        - even * along * (grown * strong - 1)
        - grown * strong * even * ratio * across
        - grown * weak * odd * (across + ratio * along)
    )
    return 4 * exp(-half) * total / gamma


def across(parts: Parts, rest: Brief, together: Expr, apart: Expr, loss: Expr, kick: Expr) -> Expr:
    """2 (m_2 - m_0) = k (2 k_1 + delta x_1) + (gamma (n_1 + n_0) + 1 - e) x_1 - 2 n_0.

    k is the way by an impulse in the whole period; k_1, and x_1 = m_2 by a force, are those in the
    rest of it.  Where the device swings nearly whole turns m_2 and m_0 are alike, and each of these
    terms is as small as their difference.
    """
    if not parts.stiffness:
        return (1 - 2 * epsilon) * together + apart
    damper = delta if parts.damping else sp.S.Zero
    pushed = kick * (2 * rest.kick + damper * rest.rise) + (gamma * together + loss) * rest.rise
    return pushed - (together - apart)


def _shortened(parts: Parts, time: Expr) -> Brief:
    """Such a part, derived; c is that of the whole period."""
    damping = delta * time if parts.damping else None
    stiffness = gamma * time**2 if parts.stiffness else None
    split = c * time if parts.stiffness else None
    short = Plant(sp.S.One, damping, stiffness)
    x, kick = plant.sampled(short, split=split), short.transition(sp.S.One, split)[0, 1]
    moved = time**2 * x.n1, time**2 * x.n0, time**2 * (x.n1 - x.n0)
    return Brief(*moved, time * kick, sp.S.Zero, 1 - x.e)


@cache
def derived(parts: Parts) -> tuple[tuple[Expr, Expr], ...]:
    """What is made of the two parts of a period beside the late force; and the impulse."""
    split = c if parts.stiffness else None
    given = {gamma: ((delta**2 if parts.damping else sp.S.Zero) - c**2) / 4}
    late = fractional.late(plant.normalised(parts), split=split)
    whole = plant.sampled(plant.normalised(parts), split=split)
    first, last = _shortened(parts, 1 - epsilon), _shortened(parts, epsilon)
    kept = exp(-delta * (1 - epsilon)) if parts.damping else sp.S.One
    impulse = plant.normalised(parts).transition(sp.S.One, split)[0, 1]
    own = whole.n1 + whole.n0, whole.n1 - whole.n0, 1 - whole.e, impulse
    pairs: tuple[tuple[Expr, Expr], ...] = (
        (first.rise, late.m2),
        (kept * last.fall, late.m0),
        (whole.n1 + whole.n0, late.m2 + late.m1 + late.m0),
        (closed(at_minus_one(parts, first, last)), late.m2 - late.m1 + late.m0),
        (across(parts, first, *own), 2 * (late.m2 - late.m0)),
    )
    if parts.stiffness:
        pairs = (*pairs, (half_turned(parts), late.m2 - late.m1 + late.m0))
    found = tuple((ours.xreplace(given), exact.xreplace(given)) for ours, exact in pairs)
    impulse = plant.normalised(parts).transition(sp.S.One)[0, 1]
    return (*found, (brief(parts, sp.S.One).kick, impulse))


ANY = Late(m_2, m_1, m_0, Sampled(n_1, n_0, a, e))
"""A late device whose numbers are symbols."""


def wall() -> tuple[Expr, Expr]:
    """(alpha, beta) with a root at exp(j theta), of any late device."""
    return boundary.solved(on_circle(-(z**l) / ANY.transfer.subs(l, 0)))
