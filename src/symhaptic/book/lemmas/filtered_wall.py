"""Which walls are passive whose damper takes an exponential average of the velocity."""

from __future__ import annotations

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import PI, by_sign_of_damping, cosine_bounds
from symhaptic.notation import f_v
from symhaptic.paper.propositions.passivity import SIX
from symhaptic.proof.theorems.energy import filtered
from symhaptic.proof.theorems.familiar import linear
from symhaptic.rules.other_loops import AVERAGED, LATE_AVERAGED, POLE

FAST: Any = proposition(b >= K * T / 2 + B * (1 - f_v) / (1 + f_v))
SLOW: Any = proposition(b >= K * T / 2 - B)
"""What motions near Nyquist's frequency and slow motions ask for."""

SIZE = 1 - 2 * f_v * cos(theta) + f_v**2
"""|z - f_v|^2 on the circle."""

MARGIN: Any = proposition(b - K * T / 2 + B * (1 - f_v) * (cos(theta) - f_v) / SIZE >= 0)
"""Of the virtual damping that is filtered a part counts as a damper at an angle."""

HERE = Given(T > 0, *POLE)


@cache
def _there() -> Given:
    """At an angle, where no divisor vanishes."""
    above, below = cosine_bounds(theta)
    here = HERE.and_(*INSIDE, sine_of_half(theta), above, below)
    near = positive(SIZE > 0, [f_v < 1, f_v < 1], [2, f_v >= 0, below])
    apart = here.show(2 - 2 * cos(theta) > 0)
    circle = (
        factor(exp(way * theta) - root, size, exp(-way * theta) - root)
        for size, root in ((near, f_v), (apart, 1))
        for way in (I, -I)
    )
    return here.and_(near, *circle)


@cache
def by_angle() -> Theorem:
    """passive <=> H(1) >= 0 and the margin of the rule at every angle."""
    energy = filtered(AVERAGED.of[0], z - f_v, z, AVERAGED.of[1], theta)
    return HERE.closed(energy, linear(z, HERE.show(f_v > -1), HERE.show(f_v < 1)))


def at_an_angle() -> Theorem:
    """0 <= b - KT/2 + B (1 - f_v)(cos - f_v)/|z - f_v|^2 of a passive wall."""
    _, always = by_angle().conclusion.of[1].of  # type: ignore[attr-defined]
    known = conjunct(mp(by_angle(), assume(AVERAGED)), always)
    there = at(known, {theta: theta}, *map(assume, INSIDE))
    return _there().closed(positive(MARGIN, [T > 0, there]))


def needed() -> Theorem:
    """Both bounds of a passive wall, as limits of the margin at pi and at 0."""
    found = []
    for end, claim in ((pi, FAST), (S.Zero, SLOW)):
        value = claim.right - claim.left
        limit = HERE.closed(tends(MARGIN.right, theta, end, value), square(1 - f_v))
        weak = prove_hyp(in_the_limit(at_an_angle(), theta, S.Zero, pi, limit), PI)
        found.append(HERE.closed(combined(claim, [weak])))
    return conj(*found)


def enough() -> Theorem:
    """The margin lies between both bounds at every angle: it is a mean of them."""
    static, always = by_angle().conclusion.of[1].of  # type: ignore[attr-defined]
    here = _there()
    above, below = cosine_bounds(theta)
    share = here.show(1 / (2 * T * SIZE) > 0)
    rows = [share, square(1 + f_v), below, FAST], [share, square(1 - f_v), above, SLOW]
    margin = here.closed(positive(always.body.of[1], *rows))
    at_rest = HERE.closed(positive(static, [K >= 0]))
    return HERE.closed(mp(by_angle(), conj(at_rest, for_all([theta], INSIDE, margin))))


@cache
def decides() -> Theorem:
    """passive <=> both bounds, for K >= 0."""
    bounds = And((FAST, SLOW))
    return either_way(prove_hyp(enough(), assume(bounds)), needed(), bounds, AVERAGED)


@cache
def without_filter() -> Theorem:
    """What is passive by (6) is passive with every filter: it lets less through."""
    given, share = assume(SIX), HERE.show(2 * f_v / (1 + f_v) >= 0)
    less = HERE.show((1 - f_v) / (1 + f_v) > 0)
    up, down = magnitude(B), magnitude(B, negative=True)
    push, brake = assume(B >= 0), positive(-B >= 0, B < 0)
    damped = conj(
        combined(FAST, [given], [up, -1], [push, share]),
        combined(SLOW, [given], [up, -1], [2, push]),
    )
    driven = conj(
        combined(FAST, [given], [down, -1], [brake, less], [brake]),
        combined(SLOW, [given], [down, -1]),
    )
    bounds = by_sign_of_damping(damped, closed(driven, positive(B <= 0, B < 0)))
    found = mp(decides(), HERE.closed(bounds))
    place, zero = Symbol("q"), show(Eq(S.Zero, d), Eq(d, 0))
    pattern = LATE_AVERAGED.at({d: place})
    return HERE.closed(subst(pattern, place, found, zero), Eq(d, 0))


def gives_energy(point: Mapping[Any, Any], angle: Expr) -> Theorem:
    """That a wall in numbers is not passive behind whole periods of delay, by its margin there."""
    claim: Any = LATE_AVERAGED.at(point)
    pole = point[f_v]
    energy = filtered(claim.of[0], z ** point[d] * (z - pole), z, claim.of[1], theta)
    _, always = energy.conclusion.of[1].of  # type: ignore[attr-defined]
    inside = [fact(proposition(p).at({theta: angle})) for p in INSIDE]
    there = at(assume(always), {theta: angle}, *inside)
    margin: Any = there.conclusion
    never = not_intro(there, number(negated(margin)), always)
    found = denied_by(energy, not_all(energy.conclusion.of[1], never))  # type: ignore[attr-defined]
    [fades] = found.hypotheses
    return closed(found, roots_inside(fades.of[0], z, {}))  # type: ignore[attr-defined]
