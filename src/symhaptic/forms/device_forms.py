"""Stable forms of the sampled device and of the polynomial that it makes."""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp
from sympy import Expr, exp

from symhaptic.forms import fractional_delay
from symhaptic.forms.entire import (
    C,
    Creep,
    Decay,
    DenominatorAtMinusOne,
    Fade,
    Lag,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
    S,
)
from symhaptic.forms.form import HALF, Form, NoForm, domain, present, steps_of
from symhaptic.model import loop, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import a, alpha, beta, d, delta, e, epsilon, gamma, n_0, n_1, z


@dataclass(frozen=True)
class Device:
    """The sampled device of a scene, and its values at z = 1 and z = -1."""

    n1: Expr
    n0: Expr
    a: Expr
    e: Expr
    at_one: Expr
    """1 - a + e."""
    at_minus_one: Expr
    """1 + a + e."""
    loss: Expr
    """1 - e."""
    together: Expr
    """n1 + n0."""
    apart: Expr
    """n1 - n0."""

    @property
    def numbers(self) -> tuple[Expr, ...]:
        """All of them."""
        own = self.n1, self.n0, self.a, self.e, self.at_one, self.at_minus_one
        return (*own, self.loss, self.together, self.apart)


def made_of(x: plant.Sampled) -> Device:
    """The same, all made of n1, n0, a and e."""
    ends = 1 - x.a + x.e, 1 + x.a + x.e, 1 - x.e
    return Device(x.n1, x.n0, x.a, x.e, *ends, x.n1 + x.n0, x.n1 - x.n0)


ANY = plant.Sampled(n_1, n_0, a, e)
"""A sampled device whose numbers are symbols."""


def device_of(parts: Parts) -> Device:
    """The scene's own, in stable forms."""
    one, two = sp.S.One, sp.S(2)
    none = sp.S.Zero
    numbers: tuple[Expr, Expr, Expr]
    ends: tuple[Expr, Expr, Expr]
    e = exp(-delta) if parts.damping else one
    if parts.stiffness and parts.damping:
        together, apart = NumeratorAtOne(gamma, delta), delta * NumeratorGap(gamma, delta)
        numbers = PlantN1(gamma, delta), PlantN0(gamma, delta), PlantTrace(gamma, delta)
        ends = gamma * together, DenominatorAtMinusOne(gamma, delta), delta * Decay(delta)
    elif parts.damping:
        together, apart = Decay(delta), delta * Lag(delta)
        numbers = Creep(delta), Fade(delta), 1 + e
        ends = none, 2 * (1 + e), delta * Decay(delta)
    elif parts.stiffness:
        together, apart = S(-gamma / 4) ** 2, none
        numbers = together / 2, together / 2, 2 * C(-gamma)
        ends = gamma * together, 4 * C(-gamma / 4) ** 2, none
    else:
        together, apart = one, none
        numbers = HALF, HALF, two
        ends = none, 2 * two, none
    n1, n0, trace = numbers
    at_one, at_minus_one, loss = ends
    return Device(n1, n0, trace, e, at_one, at_minus_one, loss, together, apart)


def same_device(parts: Parts) -> tuple[tuple[Expr, Expr], ...]:
    """The scene's numbers beside those of the sampled plant."""
    exact = made_of(plant.sampled(plant.normalised(parts)))
    return tuple(zip(device_of(parts).numbers, exact.numbers, strict=True))


def fractional_of(parts: Parts) -> Device:
    """The same device, with M = m2 z + m1 + m0/z instead of n1 z + n0 at z = -1."""
    two = (fractional_delay.brief(parts, time) for time in (1 - epsilon, epsilon))
    return replace(device_of(parts), apart=fractional_delay.at_minus_one(parts, *two))


def across_of(parts: Parts) -> Expr:
    """2 (m2 - m0) of it."""
    x, rest = device_of(parts), fractional_delay.brief(parts, 1 - epsilon)
    kick = fractional_delay.brief(parts, sp.S.One).kick
    return fractional_delay.across(parts, rest, x.together, x.apart, x.loss, kick)


def discretize(parts: Parts = FULL) -> Form:
    """n1, n0, a and e of the sampled device P(z) = (n1 z + n0)/(z^2 - a z + e)."""
    symbols = present(parts, gamma, delta)
    device = device_of(parts)
    return Form(
        "discretize",
        "the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m",
        symbols,
        (("n1", device.n1), ("n0", device.n0), ("a", device.a), ("e", device.e)),
        lambda: same_device(parts)[:4],
        domain(symbols),
    )


def discretize_fractional(parts: Parts = FULL) -> Form:
    """m2, m1, m0, a and e of the device behind a fraction of a period."""
    if not parts.delay:
        raise NoForm("discretize_fractional: the scene has no delay")
    symbols = (*present(parts, gamma, delta), epsilon)
    device = device_of(parts)
    first, last = fractional_delay.ends(parts)
    middle = device.together - (first + last)
    return Form(
        "discretize_fractional",
        "the sampled device with a delay of epsilon periods, "
        "P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)) in units of T^2/m",
        symbols,
        (("m2", first), ("m1", middle), ("m0", last), ("a", device.a), ("e", device.e)),
        lambda: (*same_device(parts), *fractional_delay.derived(parts)),
        domain(symbols),
    )


def characteristic_polynomial(parts: Parts = FULL, delay: int | None = None) -> Form:
    """Coefficients of the characteristic polynomial, its highest power first.

    For one whole number of periods; without it only for a scene without delay.
    """
    steps = steps_of(parts, delay, "characteristic_polynomial")
    symbols = present(parts, alpha, beta, gamma, delta)
    device = device_of(parts)
    polynomial = sp.Poly(loop.closing(ANY, parts).subs(d, steps), z)
    coefficients = [sp.collect(c, (n_1, n_0)) for c in polynomial.all_coeffs()]
    known = {n_1: device.n1, n_0: device.n0, a: device.a, e: device.e}
    degree = len(coefficients) - 1
    return Form(
        "characteristic_polynomial",
        f"coefficients p{degree} to p0 of the monic characteristic polynomial, d = {steps}",
        symbols,
        tuple((f"p{degree - i}", c.xreplace(known)) for i, c in enumerate(coefficients)),
        lambda: same_device(parts)[:4],
        domain(symbols),
    )
