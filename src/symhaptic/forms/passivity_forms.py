"""Stable forms of passivity: its margin, its boundary and the stiffest passive wall."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import sympy as sp
from sympy import Expr, cos, pi

from symhaptic.forms import required_damping, stiffest_passive
from symhaptic.forms.entire import Chord, Sinc, SinNext, Spread, at_numbers
from symhaptic.forms.form import HALF, Form, NoForm, Pairs, domain, either, present, undelayed
from symhaptic.forms.implicit import (
    FractionalPart,
    LargestRequiredDamping,
    Lead,
    PassiveAngle,
    Pushed,
    Rated,
    Touching,
)
from symhaptic.forms.response import closed
from symhaptic.model import passivity
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, epsilon, l, phi, psi, theta


def _normalised(parts: Parts, expr: Expr) -> Expr:
    """In the dimensionless parameters of Table I, without what the scene does not have."""
    units = {K: alpha, B: beta if parts.virtual_damping else sp.S.Zero, T: sp.S.One, b: delta}
    return undelayed(parts, expr.xreplace(units))


def _needs_damping(parts: Parts, name: str) -> None:
    if not parts.damping:
        raise NoForm(f"{name}: a scene without damping has no passive walls with stiffness")


def passivity_margin_at(parts: Parts = FULL) -> Form:
    """delta minus the damping that the wall needs at one angle, for every real delay.

    For whole delays (5) of the paper, where sin((d+1/2) theta) is that of (2d+1) halves of theta
    and sin(theta/2) does not vanish; for fractions chapter s6d_fractional_passivity.
    """
    _needs_damping(parts, "passivity_margin_at")
    damping = beta if parts.virtual_damping else sp.S.Zero
    if parts.delay:
        whole = delta - required_damping.StraightAt(alpha, damping, d, theta)
    else:
        whole = delta - alpha * HALF + damping * cos(theta)
    margin = whole
    symbols = tuple(s for s in (theta, alpha, beta, delta, d) if margin.has(s))
    if parts.delay:
        need = required_damping.RequiredAt(alpha, damping, l, epsilon, theta)
        margin = either(whole, delta - need)

    def equal() -> Pairs:
        printed = _normalised(parts, passivity.margin())
        late = required_damping.derived_at() if parts.delay else ()
        return ((closed(whole), printed), *late)

    return Form(
        "passivity_margin_at",
        "physical damping minus the damping that the wall requires at the angle theta = omega T; "
        "a wall with alpha >= 0 is passive if this is not negative at any angle",
        symbols,
        (("margin", margin),),
        equal,
        domain(symbols),
    )


def passivity_margin(parts: Parts = FULL) -> Form:
    """delta minus the damping that the wall needs at its worst angle; -inf for alpha < 0.

    For every real delay, chapter s6d_fractional_passivity.  Proved are the need at an angle and
    its slope, whose zero is searched for; that the slope vanishes once up to the angle where wall
    and delay are in phase, beyond which no angle needs more, rests on comparison.  Without virtual
    damping the worst angle is 0, without delay it is 0 or pi, as the need is linear in cos(theta).
    """
    _needs_damping(parts, "passivity_margin")
    symbols = present(parts, alpha, beta, delta, d)
    equal: Callable[[], Pairs]
    if not parts.delay:
        need = alpha / 2 + (sp.Abs(beta) if parts.virtual_damping else 0)
        largest, equal = Pushed(alpha, need), partial(_at_both_ends, parts)
    elif not parts.virtual_damping:
        order, part = d + HALF, FractionalPart(d)
        largest = Pushed(alpha, alpha * (order + sp.sqrt(order * order + part * (1 - part))) / 2)
        equal = _springs
    else:
        largest, equal = LargestRequiredDamping(alpha, beta, d), required_damping.derived
    return Form(
        "passivity_margin",
        "physical damping minus the damping that the wall requires at its worst angle; the wall "
        "is passive if this is not negative",
        symbols,
        (("margin", delta - largest),),
        equal,
        domain(symbols, "-inf for alpha < 0"),
    )


def _at_both_ends(parts: Parts) -> Pairs:
    """Without delay the need is linear in cos(theta)."""
    damping = beta if parts.virtual_damping else 0
    margin = _normalised(parts, passivity.margin())
    ends = margin.subs(theta, 0), margin.subs(theta, pi)
    ours = delta - alpha / 2 + damping, delta - alpha / 2 - damping
    return tuple(zip(ours, ends, strict=True))


def passivity_boundary(parts: Parts = FULL) -> Form:
    """The wall that is just passive and whose worst angle is theta, (27) of the paper.

    Its denominator and its numerators are differences of sines that vanish with the angle; as
    functions of their own they do not.  At a fraction of a period the wall is searched for whose
    need has no slope at this angle; proved are the need and that slope.

    It ends where alpha vanishes, before Lead does: :mod:`symhaptic.forms.required_damping`
    says why.
    """
    _needs_damping(parts, "passivity_boundary")
    if not parts.virtual_damping:
        raise NoForm("passivity_boundary: a scene without virtual damping has no such curve")
    if not parts.delay:
        raise NoForm("passivity_boundary: without delay it is one point, max_passive_stiffness")
    symbols = (theta, delta, d)
    late = _touched(Touching(theta, l, epsilon), theta)
    push = (d + 1) * Sinc(theta / 2) ** 2 * SinNext(d, theta) / theta
    below = Spread(d, theta)
    curve = 2 * delta * push / below, delta * (Chord(d, theta) - push) / below

    def equal() -> Pairs:
        exact = tuple(_normalised(parts, side) for side in passivity.envelope())
        return (*zip(curve, exact, strict=True), *required_damping.derived())

    before = Lead(theta, d, sp.S.Zero), Lead(theta, l, epsilon)
    return Form(
        "passivity_boundary",
        "the wall that is just passive and whose worst angle is theta = omega T",
        symbols,
        tuple(
            (name, either(*map(Rated, before, both)))
            for name, *both in zip(("alpha", "beta"), curve, late, strict=True)
        ),
        equal,
        domain(
            symbols,
            "NaN beyond the angle where alpha is 0: pi/(d + 1) for integer delays",
            "for d <= 2/9 the curve continues to pi",
        ),
    )


def _touched(turn: Expr, angle: Expr) -> tuple[Expr, Expr]:
    """The wall of this direction that is just passive, if its worst angle is this one."""
    wall = {s: expr.xreplace({phi: turn}) for s, expr in required_damping.of_size_one().items()}
    need = required_damping.required(required_damping.compensated()).xreplace(
        {**wall, psi: angle / 2}
    )
    return delta * wall[alpha] / need, delta * wall[beta] / need


def max_passive_stiffness(parts: Parts = FULL) -> Form:
    """The passive wall of largest stiffness, with its damping and angle, (11) of the paper.

    At a fraction of a period its angle is searched for: there the least stiffness that any angle
    allows has no slope, see :mod:`symhaptic.forms.stiffest_passive`.
    """
    _needs_damping(parts, "max_passive_stiffness")
    symbols = present(parts, delta, d)
    if not parts.virtual_damping:
        return _stiffest_spring(parts)
    share = 1 / (d + 1)
    quarter = pi * share / 4
    stiffness = 2 * delta * sp.tan(quarter)
    angle = pi * share / 2
    damping = delta * (share / sp.sin(angle) - sp.tan(quarter))
    whole = [at_numbers(undelayed(parts, expr)) for expr in (stiffness, damping, angle)]

    def equal() -> Pairs:
        exact = [_normalised(parts, side.subs(theta, angle)) for side in passivity.envelope()]
        late = stiffest_passive.derived() if parts.delay else ()
        return (*zip(whole[:2], exact, strict=True), *late)

    names = "alpha", "beta", "theta"
    results = tuple(zip(names, whole, strict=True))
    if parts.delay:
        worst_angle = PassiveAngle(l, epsilon)
        late = (*stiffest_passive.wall(worst_angle), worst_angle)
        results = tuple(
            (name, either(*both)) for name, *both in zip(names, whole, late, strict=True)
        )
    return Form(
        "max_passive_stiffness",
        "the passive wall of largest stiffness, and its worst angle theta = omega T",
        symbols,
        results,
        equal,
        domain(symbols),
    )


def _stiffest_spring(parts: Parts) -> Form:
    """Without virtual damping slow motions are the worst ones."""
    symbols = present(parts, delta, d)
    order, part = (d + HALF, FractionalPart(d)) if parts.delay else (HALF, sp.S.Zero)
    stiffness = 2 * delta / (order + sp.sqrt(order * order + part * (1 - part)))
    return Form(
        "max_passive_stiffness",
        "the stiffest passive wall",
        symbols,
        (("alpha", stiffness),),
        _springs,
        domain(symbols),
    )


def _springs() -> Pairs:
    """What a wall without damping needs."""
    needs = (
        (ours.subs(beta, 0), exact.subs(beta, 0)) for ours, exact in required_damping.derived()[:-1]
    )
    mean = required_damping.between(
        required_damping.straight(l), required_damping.straight(l + 1)
    ).subs({beta: 0, psi: 0})
    return (*needs, (mean / alpha, l + epsilon + HALF))


def linear_limit(parts: Parts = FULL) -> Form:
    """The stiffness at which the linear condition (25) of the paper is an equality."""
    symbols = present(parts, beta, delta, d)
    push = (beta if parts.virtual_damping else 0) + (delta if parts.damping else 0)
    if push == 0:
        raise NoForm("linear_limit: a scene without any damping has no stable or passive walls")
    line = push / (HALF + d) if parts.delay else 2 * push

    def equal() -> Pairs:
        need = passivity.dirichlet_form()  # at theta -> 0 it is K T (d + 1/2) - B
        slope = sp.limit(_normalised(parts, need.diff(K)) * T, theta, 0)
        rest = sp.limit(_normalised(parts, need.subs(K, 0)), theta, 0)
        given = delta if parts.damping else sp.S.Zero
        return ((line, (given - rest) / slope.subs(T, 1)),)

    return Form(
        "linear_limit",
        "the stiffness alpha at which the linear condition is an equality",
        symbols,
        (("alpha", line),),
        equal,
        domain(symbols),
    )
