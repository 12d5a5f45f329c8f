"""Stable forms of stability: its boundary, the stiffest stable wall, and verdicts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp
from sympy import Expr, cos, sin

from symhaptic.forms import fractional_delay, max_stiffness_slope
from symhaptic.forms.device_forms import (
    ANY,
    Device,
    across_of,
    device_of,
    fractional_of,
    made_of,
    same_device,
)
from symhaptic.forms.entire import CosNext, SinNext
from symhaptic.forms.form import Form, NoForm, Pairs, domain, either, present, steps_of, undelayed
from symhaptic.forms.implicit import MaxStiffnessAngle, WholePart
from symhaptic.forms.response import Ahead, InPhase, closed
from symhaptic.forms.response import parts as parts_of_response
from symhaptic.forms.root_count import FractionalRoots, Stable, WholeRoots
from symhaptic.model import boundary, jury, loop, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import (
    alpha,
    beta,
    d,
    delta,
    epsilon,
    gamma,
    l,
    m_0,
    m_1,
    m_2,
    n_0,
    n_1,
    theta,
    z,
)


def stability_boundary(parts: Parts = FULL) -> Form:
    """The wall that puts a root at exp(j theta), for every real delay: see ``response``."""
    if not parts.virtual_damping:
        raise NoForm("stability_boundary: a scene without virtual damping has no such curve")
    symbols = present(parts, theta, gamma, delta, d)
    delay = d if parts.delay else None
    device = device_of(parts)
    across = device.together + device.apart
    wall, smooth = _boundary(device, across, delay)
    if parts.delay:
        late, late_across = fractional_of(parts), across_of(parts)
        found = replace(device, apart=either(device.apart, late.apart))
        wall, _ = _boundary(found, either(across, late_across), WholePart(d))
        _, slopes = _boundary(late, late_across, l)
        smooth = tuple(either(*both) for both in zip(smooth, slopes, strict=True))

    def equal() -> Pairs:
        exact = tuple(undelayed(parts, side) for side in boundary.wall(ANY))
        same = *_same(made_of(ANY), 2 * n_1, delay, exact), *same_device(parts)
        if not parts.delay:
            return same
        any_fractional = replace(made_of(ANY), together=m_2 + m_1 + m_0, apart=m_2 - m_1 + m_0)
        late = _same(any_fractional, 2 * (m_2 - m_0), l, fractional_delay.wall())
        return (*same, *late, *fractional_delay.derived(parts))

    return Form(
        "stability_boundary",
        "the wall (alpha, beta) that puts a characteristic root at z = exp(j theta)",
        symbols,
        tuple(zip(("alpha", "beta"), wall, strict=True)),
        equal,
        domain(symbols),
        smooth=smooth,
    )


def _same(x: Device, across: Expr, delay: Expr | None, exact: Iterable[Expr]) -> Pairs:
    """Both ways to write the boundary beside the derived one."""
    ways = ((closed(side) for side in way) for way in _boundary(x, across, delay))
    return tuple(pair for way in ways for pair in zip(way, exact, strict=True))


def _boundary(
    x: Device, across: Expr, delay: Expr | None
) -> tuple[tuple[Expr, ...], tuple[Expr, ...]]:
    """With 2 n1, or 2 (m2 - m0), as ``across``; and the same for slopes."""
    device = x.at_one, x.at_minus_one, x.loss, x.together, x.apart, across
    in_phase, ahead = (part(theta / 2, *device) for part in (InPhase, Ahead))
    cosine, sine = _turned(theta, delay)
    pull = in_phase * sine + ahead * cosine
    stiffness = ahead * sine - in_phase * cosine + pull * sp.tan(theta / 2)
    return (stiffness, -pull / sin(theta)), curve(device, theta, delay)


def _turned(angle: Expr, delay: Expr | None) -> tuple[Expr, Expr]:
    if delay is None:
        return cos(angle), sin(angle)
    return CosNext(delay, angle), SinNext(delay, angle)


def curve(device: tuple[Expr, ...], angle: Expr, delay: Expr | None) -> tuple[Expr, Expr]:
    """The wall that puts a root at exp(j angle), without a quotient that is 0/0 at the angle 0."""
    c, s = cos(angle / 2), sin(angle / 2)
    ratio, ratio_j = parts_of_response(angle / 2, *device)
    cosine, sine = _turned(angle, delay)
    fan = sine / sin(angle) if delay is not None else sp.S.One
    damping = -(ratio_j * cosine / 2 + ratio * fan)
    return s * c * ratio_j * sine - ratio * cosine - 2 * s**2 * damping, damping


def max_stable_stiffness(parts: Parts = FULL) -> Form:
    """The first maximum of alpha on the explicit boundary, with its beta and angle.

    Proved are the curve and its slope, whose zero is searched for; that this is the farthest
    point of the stable region rests on comparison with whole regions.
    """
    if not parts.virtual_damping:
        raise NoForm("max_stable_stiffness: a scene without virtual damping has no such curve")
    symbols = present(parts, gamma, delta, d)
    given = gamma if parts.stiffness else sp.S.Zero, delta if parts.damping else sp.S.Zero
    x, steps = device_of(parts), d if parts.delay else sp.S.Zero
    values = x.at_one, x.at_minus_one, x.loss, x.together
    angle = MaxStiffnessAngle(*given, steps, steps, sp.S.Zero, x.n1, x.n0, *values, x.apart)
    delay = d if parts.delay else None
    results = (*curve((*values, x.apart, x.together + x.apart), angle, delay), angle)
    if parts.delay:
        first, last = fractional_delay.ends(parts)
        apart = fractional_of(parts).apart
        angle = MaxStiffnessAngle(*given, d, l, epsilon, first, last, *values, apart)
        late = (*curve((*values, apart, 2 * (first - last)), angle, l), angle)
        results = tuple(either(*both) for both in zip(results, late, strict=True))

    def equal() -> Pairs:
        late = fractional_delay.derived(parts) if parts.delay else ()
        search = max_stiffness_slope.derived() if parts == FULL else ()  # the same for every device
        return (*same_device(parts), *late, *search)

    far = "sqrt(gamma) (d + 1)" if parts.delay else "sqrt(gamma)"
    return Form(
        "max_stable_stiffness",
        "the wall of largest stable stiffness, a limit that is not stable itself, and the angle "
        "theta = omega T of its roots on the unit circle",
        symbols,
        tuple(zip(("alpha", "beta", "theta"), results, strict=True)),
        equal,
        domain(
            symbols,
            *(("gamma <= 9.8",) * parts.stiffness),
            *(("sqrt(gamma) (d + 1) <= pi or d <= 1",) * (parts.stiffness and parts.delay)),
            *(
                (f"delta = 0 or delta >= 5 ulp(1) if {far} > pi",)
                * (parts.stiffness and parts.damping)
            ),
            "NaN elsewhere, and if no wall is stable, or none that is slightly softer",
        ),
        held=("alpha",),
    )


def stability_conditions(parts: Parts = FULL, delay: int | None = None) -> Form:
    """Jury's inequalities for one whole delay, in numbers that stay small for a slow device.

    Made of 1 - e and of 1 - a + e instead of e and a, so that what cancels has cancelled already.
    """
    steps = steps_of(parts, delay, "stability_conditions")
    loss, at_one = sp.symbols("L q")
    named = plant.Sampled(n_1, n_0, 2 - loss - at_one, 1 - loss)
    polynomial = sp.Poly(loop.closing(named, parts).subs(d, steps), z)
    device = device_of(parts)
    known = {n_1: device.n1, n_0: device.n0, loss: device.loss, at_one: device.at_one}
    found = [c.xreplace(known) for c in jury.criterion(polynomial.all_coeffs()).expressions]
    found = [c for c in found if not (c.is_number and c > 0)]

    def equal() -> Pairs:
        same = same_device(parts)
        return (*same[:2], same[4], same[6])

    return Form(
        "stability_conditions",
        f"numbers that are all positive if and only if the loop is stable, d = {steps}",
        tuple(s for s in (alpha, beta, gamma, delta) if any(c.has(s) for c in found)),
        tuple((f"c{i}", c) for i, c in enumerate(found)),
        equal,
        domain(present(parts, gamma, delta)),
    )


def _counted(parts: Parts) -> list[tuple[Expr, Expr]]:
    """Roots outside the unit circle and, made of these, 1 where the loop is stable, else 0.

    For whole delays and, where the scene has a delay, for those with a fraction.
    """
    wall = alpha, beta if parts.virtual_damping else sp.S.Zero
    given = gamma if parts.stiffness else sp.S.Zero, delta if parts.damping else sp.S.Zero
    x = device_of(parts)
    numbers = x.n1, x.n0, given[0], x.at_minus_one, x.loss, x.together, x.apart
    counts: list[Expr] = [WholeRoots(*wall, d if parts.delay else sp.S.Zero, *numbers)]
    if parts.delay:
        late = fractional_of(parts).apart, across_of(parts) / 2
        ends = fractional_delay.ends(parts)
        counts.append(FractionalRoots(*wall, l, *ends, *numbers[2:-1], *late, given[1]))
    return [(count, Stable(count, *wall, *given)) for count in counts]


def _counting(parts: Parts, name: str, title: str, which: int, outside: sp.Basic) -> Form:
    symbols, faint = present(parts, alpha, beta, gamma, delta, d), (alpha, beta, delta)
    found = [pair[which] for pair in _counted(parts)]
    result = either(*found) if parts.delay else found[0]

    def equal() -> Pairs:
        return (*same_device(parts), *(fractional_delay.derived(parts) if parts.delay else ()))

    sizes = " + ".join(f"|{s}|" if s in (alpha, beta) else s.name for s in symbols if s in faint)
    largest = "max(|alpha|, gamma)" if parts.stiffness else "|alpha|"
    seen = f"no wall with {sizes} < 2^-400 or 0 < {largest} < 2^-400 (single: 2^-40)"
    hidden = ["delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) rounds to a multiple of pi"]
    return Form(
        name,
        title,
        symbols,
        (("roots" if which == 0 else "stable", result),),
        equal,
        domain(symbols, *hidden * (parts.stiffness and parts.damping), seen),
        outside=outside,
    )


def is_stable(parts: Parts = FULL) -> Form:
    """Whether the loop is stable, for every real delay."""
    title = "whether all characteristic roots lie inside the unit circle"
    return _counting(parts, "is_stable", title, 1, sp.false)


def unstable_roots(parts: Parts = FULL) -> Form:
    """Roots outside the unit circle, for every real delay."""
    title = "number of characteristic roots outside the unit circle"
    return _counting(parts, "unstable_roots", title, 0, sp.Integer(-1))
