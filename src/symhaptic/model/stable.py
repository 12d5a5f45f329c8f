r"""Forms for computing: the same formulas, made so that no digits are lost.

A form is stated for one scene, with the arguments that the scene has, and with the expression
that it equals, derived from first principles for the same scene; ``written_out`` and the normal
form prove that both are the same.  Nothing is divided that can be 0/0, at no stiffness, at no
damping, at critical damping, or at a vanishing angle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Expr, Rational, Symbol, cos, exp, pi, sin

from symhaptic.model import boundary, delayed, jury, loop, passivity, plant, stiffest, worst
from symhaptic.model.counted import LateRoots, Stable, UnstableRoots
from symhaptic.model.entire import (
    C,
    Chord,
    CosNext,
    Creep,
    Decay,
    Fade,
    Lag,
    S,
    Sinc,
    SinNext,
    Spread,
    at_numbers,
)
from symhaptic.model.entire_device import Apart, Fall, Nyquist, Rise, Swing, Together
from symhaptic.model.searched import (
    LargestNeed,
    LatePart,
    PassiveAngle,
    Pushed,
    SomePart,
    StiffestAngle,
    Touching,
    WholePart,
)
from symhaptic.notation import (
    B,
    K,
    T,
    a,
    alpha,
    b,
    beta,
    d,
    delta,
    e,
    epsilon,
    gamma,
    l,
    m_0,
    m_1,
    m_2,
    n_0,
    n_1,
    phi,
    psi,
    theta,
    z,
)
from symhaptic.scene import FULL, Parts

HALF = Rational(1, 2)


class NoForm(ValueError):
    """The scene lacks what the form is about; the message says what."""


@dataclass(frozen=True)
class Form:
    """One function to compute."""

    name: str
    title: str
    """What it gives, in a line of plain text."""
    arguments: tuple[Symbol, ...]
    results: tuple[tuple[str, Expr], ...]
    """Each result's name and its stable form."""
    equal: tuple[tuple[Expr, Expr], ...]
    """Pairs, stable and derived from first principles, that together make it the same formula."""
    domain: tuple[str, ...]
    """Where it is meant, one condition each."""
    held: tuple[str, ...] = ()
    """Results that are largest at an angle that is searched for; the others are found there."""
    plain: Form | None = None
    """The form without the derivatives that are among the results."""

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """The stable forms alone."""
        return tuple(expr for _, expr in self.results)


# -- the device ---------------------------------------------------------------------------


@dataclass(frozen=True)
class _Device:
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


def _named(x: plant.Sampled) -> _Device:
    """The same, all made of n1, n0, a and e."""
    ends = 1 - x.a + x.e, 1 + x.a + x.e, 1 - x.e
    return _Device(x.n1, x.n0, x.a, x.e, *ends, x.n1 + x.n0, x.n1 - x.n0)


ANY = plant.Sampled(n_1, n_0, a, e)
"""A sampled device whose numbers are symbols."""


def _device(parts: Parts) -> _Device:
    one, two = sp.S.One, sp.S(2)
    none = sp.S.Zero
    numbers: tuple[Expr, Expr, Expr]
    ends: tuple[Expr, Expr, Expr]
    e = exp(-delta) if parts.damping else one
    if parts.stiffness and parts.damping:
        together, apart = Together(gamma, delta), delta * Apart(gamma, delta)
        numbers = Rise(gamma, delta), Fall(gamma, delta), Swing(gamma, delta)
        ends = gamma * together, Nyquist(gamma, delta), delta * Decay(delta)
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
    return _Device(n1, n0, trace, e, at_one, at_minus_one, loss, together, apart)


def _same_device(parts: Parts) -> tuple[tuple[Expr, Expr], ...]:
    """The scene's numbers beside those of the sampled plant."""
    exact = _named(plant.sampled(plant.normalised(parts)))
    return tuple(zip(_device(parts).numbers, exact.numbers, strict=True))


def _of(parts: Parts, *symbols: Symbol) -> tuple[Symbol, ...]:
    """Those of the symbols that the scene has."""
    missing = {
        gamma: not parts.stiffness,
        delta: not parts.damping,
        beta: not parts.virtual_damping,
        d: not parts.delay,
    }
    return tuple(s for s in symbols if not missing.get(s, False))


_RANGES = {
    gamma: "gamma >= 0",
    delta: "delta >= 0",
    d: "d >= 0",
    epsilon: "0 <= epsilon < 1",
    theta: "0 < theta < pi",
}


def _domain(symbols: tuple[Symbol, ...], *more: str) -> tuple[str, ...]:
    return (*(_RANGES[s] for s in symbols if s in _RANGES), *more)


def discretize(parts: Parts = FULL) -> Form:
    """n1, n0, a and e of the sampled device P(z) = (n1 z + n0)/(z^2 - a z + e)."""
    symbols = _of(parts, gamma, delta)
    device = _device(parts)
    return Form(
        "discretize",
        "the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m",
        symbols,
        (("n1", device.n1), ("n0", device.n0), ("a", device.a), ("e", device.e)),
        _same_device(parts)[:4],
        _domain(symbols),
    )


def discretize_late(parts: Parts = FULL) -> Form:
    """m2, m1, m0, a and e of the device behind a fraction of a period."""
    if not parts.delay:
        raise NoForm("discretize_late: the scene has no delay")
    symbols = (*_of(parts, gamma, delta), epsilon)
    device = _device(parts)
    first, last = delayed.ends(parts)
    middle = device.together - (first + last)
    return Form(
        "discretize_late",
        "the sampled device behind a delay of epsilon periods, "
        "P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)) in units of T^2/m",
        symbols,
        (("m2", first), ("m1", middle), ("m0", last), ("a", device.a), ("e", device.e)),
        (*_same_device(parts), *delayed.derived(parts)),
        _domain(symbols),
    )


def _either(whole: Expr, late: Expr) -> Expr:
    """One form for whole delays, another one for those with a fraction."""
    found = late.xreplace({epsilon: SomePart(d), l: WholePart(d)})
    return sp.Piecewise((whole, sp.Eq(LatePart(d), 0)), (found, True))


def characteristic_polynomial(parts: Parts = FULL, delay: int | None = None) -> Form:
    """Coefficients of the characteristic polynomial, its highest power first.

    For one whole number of periods; without it only for a scene without delay.
    """
    steps = _whole(parts, delay, "characteristic_polynomial")
    symbols = _of(parts, alpha, beta, gamma, delta)
    device = _device(parts)
    polynomial = sp.Poly(loop.closing(ANY, parts).subs(d, steps), z)
    coefficients = [sp.collect(c, (n_1, n_0)) for c in polynomial.all_coeffs()]
    known = {n_1: device.n1, n_0: device.n0, a: device.a, e: device.e}
    degree = len(coefficients) - 1
    return Form(
        "characteristic_polynomial",
        f"coefficients p{degree} to p0 of the monic characteristic polynomial, d = {steps}",
        symbols,
        tuple((f"p{degree - i}", c.xreplace(known)) for i, c in enumerate(coefficients)),
        _same_device(parts)[:4],
        _domain(symbols),
    )


def _whole(parts: Parts, delay: int | None, name: str) -> int:
    if not parts.delay:
        if delay:
            raise NoForm(f"{name}: the scene has no delay, and {delay} periods are asked for")
        return 0
    if delay is None:
        raise NoForm(f"{name}: is made for one whole delay, which has to be given")
    return delay


# -- passivity ----------------------------------------------------------------------------


def _undelayed(parts: Parts, expr: Expr) -> Expr:
    return expr if parts.delay else expr.subs(d, 0)


def _normalised(parts: Parts, expr: Expr) -> Expr:
    """In the dimensionless parameters of Table I, without what the scene does not have."""
    units = {K: alpha, B: beta if parts.virtual_damping else sp.S.Zero, T: sp.S.One, b: delta}
    return _undelayed(parts, expr.xreplace(units))


def _needs_damping(parts: Parts, name: str) -> None:
    if not parts.damping:
        raise NoForm(f"{name}: a scene without damping has no passive walls to speak of")


def passivity_margin_at(parts: Parts = FULL) -> Form:
    """delta minus the damping that the wall needs at one angle, (5) of the paper.

    sin((d+1/2) theta) is that of (2d+1) halves of theta, and sin(theta/2) does not vanish.
    """
    _needs_damping(parts, "passivity_margin_at")
    half = theta / 2
    if parts.delay:
        kernel = SinNext(2 * d, half) / (2 * sin(half))
        swing = CosNext(d, theta)
    else:
        kernel, swing = HALF, cos(theta)
    margin = delta - alpha * kernel + (beta * swing if parts.virtual_damping else 0)
    symbols = tuple(s for s in (theta, alpha, beta, delta, d) if margin.has(s))
    return Form(
        "passivity_margin_at",
        "physical damping minus the damping that the wall needs at the angle theta = omega T; "
        "the wall is passive where it is positive at every angle",
        symbols,
        (("margin", margin),),
        ((margin, _normalised(parts, passivity.margin())),),
        _domain(symbols, *(("d whole, or fractional on the principal sheet",) * parts.delay)),
    )


def passivity_margin(parts: Parts = FULL) -> Form:
    """delta minus the damping that the wall needs at its worst angle; -inf for alpha < 0.

    For every real delay, chapter s6d_fractional_passivity.  Proved are the need at an angle and
    its slope, whose zero is searched for; that the slope vanishes once up to the angle where wall
    and delay are in phase, beyond which no angle needs more, rests on comparison.  Without virtual
    damping the worst angle is 0, without delay it is 0 or pi, as the need is linear in cos(theta).
    """
    _needs_damping(parts, "passivity_margin")
    symbols = _of(parts, alpha, beta, delta, d)
    equal: tuple[tuple[Expr, Expr], ...]
    if not parts.delay:
        need = alpha / 2 + (sp.Abs(beta) if parts.virtual_damping else 0)
        damping = beta if parts.virtual_damping else 0
        margin = _normalised(parts, passivity.margin())
        ends = margin.subs(theta, 0), margin.subs(theta, pi)
        ours = delta - alpha / 2 + damping, delta - alpha / 2 - damping
        equal = tuple(zip(ours, ends, strict=True))
        largest = Pushed(alpha, need)
    elif not parts.virtual_damping:
        order, part = d + HALF, LatePart(d)
        largest = Pushed(alpha, alpha * (order + sp.sqrt(order * order + part * (1 - part))) / 2)
        none = {beta: 0, psi: 0}
        equal = _springs()
        order = worst.between(worst.straight(l), worst.straight(l + 1)).subs(none) / alpha
        equal += ((order, l + epsilon + HALF),)
    else:
        largest, equal = LargestNeed(alpha, beta, d), worst.derived()
    return Form(
        "passivity_margin",
        "physical damping minus the damping that the wall needs at its worst angle; the wall is "
        "passive where it is not negative",
        symbols,
        (("margin", delta - largest),),
        equal,
        _domain(symbols, "-inf for alpha < 0"),
    )


def passivity_boundary(parts: Parts = FULL) -> Form:
    """The wall that is just passive and whose worst angle is theta, (27) of the paper.

    Its denominator and its numerators are differences of sines that vanish with the angle; as
    functions of their own they do not.  At a fraction of a period the wall is searched for whose
    need has no slope at this angle; proved are the need and that slope.
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
    exact = tuple(_normalised(parts, side) for side in passivity.envelope())
    return Form(
        "passivity_boundary",
        "the wall that is just passive and whose worst angle is theta = omega T",
        symbols,
        tuple(
            (name, _either(*both))
            for name, *both in zip(("alpha", "beta"), curve, late, strict=True)
        ),
        (*zip(curve, exact, strict=True), *worst.derived()),
        _domain(symbols, "theta <= pi/(d + 1), beyond which it bounds nothing"),
    )


def _touched(turn: Expr, angle: Expr) -> tuple[Expr, Expr]:
    """The wall of this direction that is just passive, if its worst angle is this one."""
    wall = {s: expr.xreplace({phi: turn}) for s, expr in worst.of_size_one().items()}
    need = worst.need().xreplace({**wall, psi: angle / 2})
    return delta * wall[alpha] / need, delta * wall[beta] / need


def max_passive_stiffness(parts: Parts = FULL) -> Form:
    """The passive wall of largest stiffness, with its damping and angle, (11) of the paper.

    At a fraction of a period its angle is searched for: there, less damping would need neither
    more nor less; proved are the need and its derivatives.
    """
    _needs_damping(parts, "max_passive_stiffness")
    symbols = _of(parts, delta, d)
    if not parts.virtual_damping:
        return _stiffest_spring(parts)
    share = 1 / (d + 1)
    quarter = pi * share / 4
    stiffness = 2 * delta * sp.tan(quarter)
    angle = pi * share / 2
    damping = delta * (2 / (pi * Sinc(angle)) - sp.tan(quarter))
    whole = [at_numbers(_undelayed(parts, expr)) for expr in (stiffness, damping, angle)]
    exact = [_normalised(parts, side.subs(theta, angle)) for side in passivity.envelope()]
    equal = tuple(zip(whole[:2], exact, strict=True))
    names = "alpha", "beta", "theta"
    results = tuple(zip(names, whole, strict=True))
    if parts.delay:
        worst_angle = PassiveAngle(l, epsilon)
        late = (*_touched(Touching(worst_angle, l, epsilon), worst_angle), worst_angle)
        results = tuple(
            (name, _either(*both)) for name, *both in zip(names, whole, late, strict=True)
        )
        equal += worst.derived()
    return Form(
        "max_passive_stiffness",
        "the passive wall of largest stiffness, and its worst angle theta = omega T",
        symbols,
        results,
        equal,
        _domain(symbols),
    )


def _stiffest_spring(parts: Parts) -> Form:
    """Without virtual damping slow motions are the worst ones."""
    symbols = _of(parts, delta, d)
    order, part = (d + HALF, LatePart(d)) if parts.delay else (HALF, sp.S.Zero)
    stiffness = 2 * delta / (order + sp.sqrt(order * order + part * (1 - part)))
    n = worst.between(worst.straight(l), worst.straight(l + 1)).subs({beta: 0, psi: 0})
    return Form(
        "max_passive_stiffness",
        "the stiffest passive wall",
        symbols,
        (("alpha", stiffness),),
        (*_springs(), (n / alpha, l + epsilon + HALF)),
        _domain(symbols),
    )


def _springs() -> tuple[tuple[Expr, Expr], ...]:
    """What a wall without damping needs."""
    return tuple((ours.subs(beta, 0), exact.subs(beta, 0)) for ours, exact in worst.derived()[:-1])


def linear_limit(parts: Parts = FULL) -> Form:
    """The stiffness at which the linear condition (25) of the paper is an equality."""
    symbols = _of(parts, beta, delta, d)
    push = (beta if parts.virtual_damping else 0) + (delta if parts.damping else 0)
    if push == 0:
        raise NoForm("linear_limit: a scene without any damping has no stable or passive walls")
    line = push / (HALF + d) if parts.delay else 2 * push
    need = passivity.dirichlet_form()  # at theta -> 0 it is K T (d + 1/2) - B
    slope = sp.limit(_normalised(parts, need.diff(K)) * T, theta, 0)
    rest = sp.limit(_normalised(parts, need.subs(K, 0)), theta, 0)
    given = delta if parts.damping else sp.S.Zero
    return Form(
        "linear_limit",
        "the stiffness alpha at which the linear condition is an equality",
        symbols,
        (("alpha", line),),
        ((line, (given - rest) / slope.subs(T, 1)),),
        _domain(symbols),
    )


# -- stability ----------------------------------------------------------------------------


def stability_boundary(parts: Parts = FULL) -> Form:
    """The wall that puts a root at exp(j theta), for every real delay.

    A and M on the circle from their values at 1 and -1, so that no cosines are subtracted: with
    cosine c and sine s of theta/2, A/z = A(1) c^2 - A(-1) s^2 + 2 j s c (1 - e), and for a whole
    delay M = (n1 + n0) c^2 - (n1 - n0) s^2 + 2 j s c n1.  A fraction leaves m2 - m0 in place of n1
    and m2 - m1 + m0 in place of n1 - n0.
    """
    if not parts.virtual_damping:
        raise NoForm("stability_boundary: a scene without virtual damping has no such curve")
    symbols = _of(parts, theta, gamma, delta, d)
    delay = d if parts.delay else None
    named = _boundary(_named(ANY), 2 * n_1, delay)
    exact = (_undelayed(parts, side) for side in boundary.wall(ANY))
    device = _device(parts)
    curve = _boundary(device, device.together + device.apart, delay)
    equal = (*zip(named, exact, strict=True), *_same_device(parts))
    if parts.delay:
        first, last = delayed.ends(parts)
        late = _boundary(_late(parts), 2 * (first - last), l)
        curve = tuple(_either(*both) for both in zip(curve, late, strict=True))
        any_late = replace(_named(ANY), together=m_2 + m_1 + m_0, apart=m_2 - m_1 + m_0)
        named = _boundary(any_late, 2 * (m_2 - m_0), l)
        equal += (*zip(named, delayed.wall(), strict=True), *delayed.derived(parts))
    return Form(
        "stability_boundary",
        "the wall (alpha, beta) that puts a characteristic root at z = exp(j theta)",
        symbols,
        tuple(zip(("alpha", "beta"), curve, strict=True)),
        equal,
        _domain(symbols),
    )


def _late(parts: Parts) -> _Device:
    """The same device, with M = m2 z + m1 + m0/z instead of n1 z + n0 at z = -1."""
    two = (delayed.brief(parts, time) for time in (1 - epsilon, epsilon))
    return replace(_device(parts), apart=delayed.at_minus_one(parts, *two))


def _boundary(x: _Device, across: Expr, delay: Expr | None) -> tuple[Expr, Expr]:
    """With 2 n1, or 2 (m2 - m0), as ``across``."""
    return curve(x.at_one, x.at_minus_one, x.loss, x.together, x.apart, across, theta, delay)


def curve(
    at_one: Expr,
    at_minus_one: Expr,
    loss: Expr,
    together: Expr,
    apart: Expr,
    across: Expr,
    angle: Expr,
    delay: Expr | None,
) -> tuple[Expr, Expr]:
    """The wall that puts a root at exp(j angle)."""
    c, s = cos(angle / 2), sin(angle / 2)
    above, above_j = at_one * c**2 - at_minus_one * s**2, 2 * loss
    below = together * c**2 - apart * s**2
    flat = (s * c) ** 2  # the imaginary parts are without s c
    size = below**2 + flat * across**2
    ratio = (above * below + flat * above_j * across) / size
    ratio_j = (above_j * below - above * across) / size
    if delay is not None:
        cosine, sine = CosNext(delay, angle), SinNext(delay, angle)
        fan = sine / sin(angle)
    else:
        cosine, sine, fan = cos(angle), sin(angle), sp.S.One
    damping = -(ratio_j * cosine / 2 + ratio * fan)
    return s * c * ratio_j * sine - ratio * cosine - 2 * s**2 * damping, damping


def max_stable_stiffness(parts: Parts = FULL) -> Form:
    """The first maximum of alpha on the explicit boundary, with its beta and angle.

    Proved are the curve and its slope, whose zero is searched for; that this is the farthest
    point of the stable region rests on comparison with whole regions.
    """
    if not parts.virtual_damping:
        raise NoForm("max_stable_stiffness: a scene without virtual damping has no such curve")
    symbols = _of(parts, gamma, delta, d)
    given = gamma if parts.stiffness else sp.S.Zero, delta if parts.damping else sp.S.Zero
    x, steps = _device(parts), d if parts.delay else sp.S.Zero
    values = x.at_one, x.at_minus_one, x.loss, x.together
    angle = StiffestAngle(*given, steps, steps, sp.S.Zero, x.n1, x.n0, *values, x.apart)
    delay = d if parts.delay else None
    results = (*curve(*values, x.apart, x.together + x.apart, angle, delay), angle)
    equal = _same_device(parts)
    if parts.delay:
        first, last = delayed.ends(parts)
        apart = _late(parts).apart
        angle = StiffestAngle(*given, d, l, epsilon, first, last, *values, apart)
        late = (*curve(*values, apart, 2 * (first - last), angle, l), angle)
        results = tuple(_either(*both) for both in zip(results, late, strict=True))
        equal += delayed.derived(parts)
    if parts == FULL:  # the same for every device
        equal += stiffest.derived()
    return Form(
        "max_stable_stiffness",
        "the wall of largest stable stiffness, a limit that is not stable itself, and the angle "
        "theta = omega T of its roots on the unit circle",
        symbols,
        tuple(zip(("alpha", "beta", "theta"), results, strict=True)),
        equal,
        _domain(
            symbols,
            *(("gamma <= 9.8",) * parts.stiffness),
            *(("sqrt(gamma) (d + 1) <= pi or d <= 1",) * (parts.stiffness and parts.delay)),
            "NaN elsewhere and where no wall is stable",
        ),
        held=("alpha",),
    )


def stability_conditions(parts: Parts = FULL, delay: int | None = None) -> Form:
    """Jury's inequalities for one whole delay, in numbers that stay small for a slow device.

    Made of 1 - e and of 1 - a + e instead of e and a, so that what cancels has cancelled already.
    """
    steps = _whole(parts, delay, "stability_conditions")
    loss, at_one = sp.symbols("L q")
    named = plant.Sampled(n_1, n_0, 2 - loss - at_one, 1 - loss)
    polynomial = sp.Poly(loop.closing(named, parts).subs(d, steps), z)
    device = _device(parts)
    known = {n_1: device.n1, n_0: device.n0, loss: device.loss, at_one: device.at_one}
    found = [c.xreplace(known) for c in jury.criterion(polynomial.all_coeffs()).expressions]
    found = [c for c in found if not (c.is_number and c > 0)]
    same = _same_device(parts)
    return Form(
        "stability_conditions",
        f"numbers that are all positive exactly where the loop is stable, d = {steps}",
        tuple(s for s in (alpha, beta, gamma, delta) if any(c.has(s) for c in found)),
        tuple((f"c{i}", c) for i, c in enumerate(found)),
        (*same[:2], same[4], same[6]),
        _domain(_of(parts, gamma, delta)),
    )


def is_stable(parts: Parts = FULL) -> Form:
    """Roots outside the unit circle, and whether the loop is stable, for every real delay."""
    wall = alpha, beta if parts.virtual_damping else sp.S.Zero
    symbols = _of(parts, alpha, beta, gamma, delta, d)
    given = gamma if parts.stiffness else sp.S.Zero, delta if parts.damping else sp.S.Zero
    x = _device(parts)
    numbers = x.n1, x.n0, x.at_one, x.at_minus_one, x.loss, x.together, x.apart
    count = UnstableRoots(*wall, d if parts.delay else sp.S.Zero, *numbers)
    results = count, Stable(count, *wall, *given)
    equal = _same_device(parts)
    if parts.delay:
        x = _late(parts)
        numbers = *delayed.ends(parts), *numbers[2:-1], x.apart
        count = LateRoots(*wall, l, *numbers)
        late = count, Stable(count, *wall, *given)
        results = tuple(_either(*both) for both in zip(results, late, strict=True))
        equal += delayed.derived(parts)
    return Form(
        "is_stable",
        "roots outside the unit circle, and 1 where the loop is stable, else 0",
        symbols,
        tuple(zip(("outside", "stable"), results, strict=True)),
        equal,
        _domain(symbols),
    )


FORMS: dict[str, Callable[..., Form]] = {
    f.__name__: f
    for f in (
        discretize,
        discretize_late,
        characteristic_polynomial,
        is_stable,
        stability_conditions,
        stability_boundary,
        max_stable_stiffness,
        passivity_margin_at,
        passivity_margin,
        passivity_boundary,
        max_passive_stiffness,
        linear_limit,
    )
}

STATEMENTS = {
    "discretize": ("eq14",),
    "characteristic_polynomial": ("eq18",),
    "passivity_margin_at": ("eq5",),
    "passivity_boundary": ("eq27",),
    "max_passive_stiffness": ("eq11",),
    "linear_limit": ("eq25",),
}
"""Formulas of the paper that the forms compute."""

FOR_ONE_DELAY = ("characteristic_polynomial", "stability_conditions")
"""Forms that are made for one whole delay."""


def form(name: str, parts: Parts = FULL, delay: int | None = None) -> Form:
    """The form of one function, for one scene and, where it needs one, for one whole delay.

    Raises :class:`NoForm` where the scene has not what it is about.
    """
    return FORMS[name](parts, delay) if name in FOR_ONE_DELAY else FORMS[name](parts)


def forms(parts: Parts = FULL, delay: int | None = None) -> Iterator[Form]:
    """All forms of a scene, those left out that it has not."""
    for name in FORMS:
        try:
            yield form(name, parts, delay)
        except NoForm:
            continue
