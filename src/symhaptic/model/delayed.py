r"""The device behind a delay of l + epsilon periods, in forms for computing.

With :math:`M=m_2z^2+m_1z+m_0`, where :math:`m_2=(1-\varepsilon)^2n_1` of a period
:math:`1-\varepsilon` times as long, :math:`m_0=\varepsilon^2e^{-\delta(1-\varepsilon)}n_0` of one
:math:`\varepsilon` times as long, and :math:`m_2+m_1+m_0=n_1+n_0`; chapter s6a_fractional_plant.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Expr, Rational, exp

from symhaptic.model import boundary, fractional, plant
from symhaptic.model.entire import Creep, Fade, S
from symhaptic.model.entire_device import Fall, Rise
from symhaptic.model.fractional import Late
from symhaptic.model.passivity import on_circle
from symhaptic.model.plant import Plant, Sampled
from symhaptic.notation import a, c, delta, e, epsilon, gamma, l, m_0, m_1, m_2, n_0, n_1, z
from symhaptic.scene import Parts

HALF = Rational(1, 2)


def rise(parts: Parts, time: Expr) -> Expr:
    """n_1 of a period ``time`` times as long, in units of the squared period."""
    if parts.stiffness and parts.damping:
        return Rise(gamma * time**2, delta * time)
    if parts.damping:
        return Creep(delta * time)
    return S(-gamma * time**2 / 4) ** 2 / 2 if parts.stiffness else HALF


def fall(parts: Parts, time: Expr) -> Expr:
    """n_0 of such a period."""
    if parts.stiffness and parts.damping:
        return Fall(gamma * time**2, delta * time)
    return Fade(delta * time) if parts.damping else rise(parts, time)


def ends(parts: Parts, part: Expr = epsilon) -> tuple[Expr, Expr]:
    """m_2 and m_0."""
    rest = 1 - part
    kept = exp(-delta * rest) if parts.damping else sp.S.One
    return rest**2 * rise(parts, rest), part**2 * kept * fall(parts, part)


def _shortened(parts: Parts, time: Expr) -> Sampled:
    """A sampled device of such a period, derived; c is that of the whole one."""
    damping = delta * time if parts.damping else None
    stiffness = gamma * time**2 if parts.stiffness else None
    apart = c * time if parts.stiffness else None
    return plant.sampled(Plant(sp.S.One, damping, stiffness), split=apart)


@cache
def derived(parts: Parts) -> tuple[tuple[Expr, Expr], ...]:
    """m_2 and m_0 of the two shortened periods, and all three, beside those of the late force."""
    split = c if parts.stiffness else None
    given = {gamma: ((delta**2 if parts.damping else sp.S.Zero) - c**2) / 4}
    late = fractional.late(plant.normalised(parts), split=split)
    whole = plant.sampled(plant.normalised(parts), split=split)
    first, last = _shortened(parts, 1 - epsilon), _shortened(parts, epsilon)
    kept = exp(-delta * (1 - epsilon)) if parts.damping else sp.S.One
    pairs = (
        ((1 - epsilon) ** 2 * first.n1, late.m2),
        (epsilon**2 * kept * last.n0, late.m0),
        (whole.n1 + whole.n0, late.m2 + late.m1 + late.m0),
    )
    return tuple((ours.xreplace(given), exact.xreplace(given)) for ours, exact in pairs)


ANY = Late(m_2, m_1, m_0, Sampled(n_1, n_0, a, e))
"""A late device whose numbers are symbols."""


def wall() -> tuple[Expr, Expr]:
    """(alpha, beta) with a root at exp(j theta), of any late device."""
    return boundary.solved(on_circle(-(z**l) / ANY.transfer.subs(l, 0)))
