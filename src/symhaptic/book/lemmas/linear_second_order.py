"""The boundary leaves the line by terms of second order only, for d = 0 and d = 1.

All that makes an arm differ from a free mass is small with delta and gamma: n_1 - n_0 and the gap.
On the line Jury's minor is a sum of products of A with one of these, less a multiple of A^2: a
surplus over the line that is larger has its sign.
"""

from symhaptic.book.lemmas.arm_numbers import SLOW, TOTAL, damped_or_not, pushed, undamped
from symhaptic.book.lemmas.line_crossing import ROOM, divided, room, slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW, on_it
from symhaptic.book.lemmas.linear_gap import MOST, narrow
from symhaptic.book.lemmas.linear_rays import (
    A,
    at_start,
    b_1,
    coordinates,
    minor_at,
    share,
    slope,
    start_by_gap,
    zero,
    zero_of,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.model.circle import powers
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import CONSTANT, SMALL, on_boundary_at, second_order
from symhaptic.proof.theorems.analysis import grows
from symhaptic.proof.theorems.samples import after_a_blow

UNEVEN, GAP = symbols("w G")
"""n_1 - n_0, and the gap times n_1 + n_0."""
MEANT = {UNEVEN: n_1 - n_0, GAP: ROOM}
BOX: dict[Symbol, tuple[Any, Any]] = {**RANGES, A: (0, SMALL + STIFF)}
_PLACE, _BEFORE = Symbol("q"), Symbol("v")


@cache
def nearly_even() -> Theorem:
    """n_1 - n_0 <= delta/6: a device that burns little answers to both periods alike."""
    claim, given = Relation(n_1 - n_0, "<=", delta / 6), (DEVICE, gamma >= 0, SLOW)
    implied = Implies((both(given), claim))
    none = number(Relation(S.Zero, "<=", S.Zero))
    free = after_a_blow(assume(undamped(DEVICE)), -1, 1, u, 0, none)
    bare = [undamped(p) for p in given]
    free = disch(add_assum(combined(undamped(claim), [free]), *bare), *bare)
    damped = disch(add_assum(combined(claim, [_late()]), *given), *given)
    return undisch(damped_or_not(implied, damped, free))


def _late() -> Theorem:
    """0 <= n_0 - n_1 + delta/6, from exp(-x) > 1 - x."""
    way = delta * u
    kernel = exp(-way) - 1 + way + way**2 / 2 + gamma * delta * u**3 / 6
    above = Given(delta > 0, u > 0).closed(inst(_tangent(), {_PLACE: way}))
    more = [HALF, *[delta > 0, u > 0] * 2], [Rational(1, 6), gamma >= 0, delta > 0, *[u > 0] * 3]
    shown = positive(kernel >= 0, [above], *more)
    return after_a_blow(assume(DEVICE), -1, 1, u, -delta * u**3 / 6, shown)


def _tangent() -> Theorem:
    """0 < exp(-q) - 1 + q for 0 < q."""
    rest = exp(-_BEFORE) - 1 + _BEFORE
    slope_ = Given(_BEFORE > 0).show(derivative(rest, _BEFORE) > 0, rising(exp, -_BEFORE, S.Zero))
    found = grows(rest, _BEFORE, S.Zero, _PLACE, slope_)
    return show(rest.xreplace({_BEFORE: _PLACE}) > 0, found)


def on_line(delay: int) -> Expr:
    """The minor on the line, as a function of A."""
    return expanded(minor_at(delay).xreplace({b: share(delay) * A}))


@cache
def along(delay: int) -> dict[int, Expr]:
    """The coefficients of the minor on the line, by power of A."""
    return powers(on_line(delay), A)


def curvature(delay: int) -> Expr:
    """The minor on the line without its terms of order 0 and 1, over A^2."""
    return expanded(Add(*(c * A ** (k - 2) for k, c in along(delay).items() if k > 1)))


@cache
def rates(delay: int) -> dict[Symbol, Expr]:
    """How the slope of the minor at the start of the line is made of what is small."""
    loss = 1 + gamma * n_0 - (delta + gamma / 2) * TOTAL - GAP
    slope_ = along(delay)[1].xreplace({e: loss}).xreplace({n_1: n_0 + UNEVEN})
    rest, found = expanded(slope_), {}
    for small in (UNEVEN, delta, gamma, GAP):
        found[small] = divided(rest, small, S.Zero).xreplace(MEANT)
        rest = rest.xreplace({small: S.Zero})
    assert rest == 0
    return found


def curved(delay: int, bow: Expr) -> Expr:
    """(f(A, line + bow) - f(A, line))/bow of the minor f."""
    ends = {b: share(delay) * A, b_1: share(delay) * A + bow}
    return slope(delay, b, b_1).xreplace(ends)


ABOVE = CONSTANT * A**2
BELOW = -CONSTANT * (delta + gamma) * (A + gamma)
"""Surpluses over the line between which the boundary lies."""


@cache
def positive_above(delay: int) -> Theorem:
    """The minor is positive at the surplus 3 A^2."""
    rate = rates(delay)
    value = minor_at(delay).xreplace({b: share(delay) * A + ABOVE})
    bent = CONSTANT * curved(delay, ABOVE) + curvature(delay)
    width = A > 0
    return positive(
        value > 0,
        [at_start(delay)],
        [width, on_box(rate[UNEVEN], RANGES), pushed()[2]],
        [width, on_box(rate[delta], RANGES), delta >= 0],
        [width, on_box(rate[gamma] + rate[GAP] * MOST / gamma, RANGES), gamma >= 0],
        [width, on_box(-rate[GAP], RANGES), narrow()],
        [width, width, on_box(expanded(bent), BOX)],
    )


@cache
def negative_below(delay: int) -> Theorem:
    """The minor is not positive at the surplus -3 (delta + gamma) (A + gamma)."""
    rate, weight = rates(delay), start_by_gap(delay)
    value = minor_at(delay).xreplace({b: share(delay) * A + BELOW})
    push = CONSTANT * curved(delay, BELOW)
    width, spring, loss = A > 0, gamma >= 0, delta >= 0
    by_loss = push - rate[delta] - rate[UNEVEN] / 6
    return positive(
        value <= 0,
        [loss, width, on_box(expanded(by_loss), BOX)],
        [spring, width, on_box(expanded(push - rate[gamma]), BOX)],
        [width, on_box(rate[UNEVEN], RANGES), nearly_even()],
        [width, on_box(-rate[GAP], RANGES), room()],
        [width, width, on_box(-curvature(delay), BOX)],
        [spring, loss, on_box(expanded(push - weight * gamma / 32), BOX)],
        [spring, spring, on_box(expanded(push), BOX)],
        [on_box(weight, RANGES), narrow()],
    )


MOST_B = HIGH + DAMPED + 2 * STIFF


def _between(delay: int, low: Expr, high: Expr) -> Theorem:
    """0 < (f(high) - f(low))/(high - low) of the minor f."""
    wide = {**BOX, b: (LOW, MOST_B), b_1: (LOW, MOST_B)}
    return inst(on_box(slope(delay, b, b_1), wide), {b: low, b_1: high})


@cache
def not_above(delay: int) -> Theorem:
    """b <= (d + 1/2) A + 3 A^2 of a wall with a minor of zero."""
    value, bow = minor_at(delay), share(delay) * A + ABOVE
    gain = positive(value > 0, [bow < b, _between(delay, bow, b)], [positive_above(delay)])
    gain = Given(bow < b, A > 0, b <= MOST_B).closed(gain)
    return by_contradiction(b <= bow, gain, zero_of(value))


@cache
def not_below(delay: int) -> Theorem:
    """(d + 1/2) A - 3 (delta + gamma) (A + gamma) <= b of a wall with a minor of zero."""
    value, bow = minor_at(delay), share(delay) * A + BELOW
    lift = inst(_between(delay, b_1, b), {b: bow, b_1: b})
    gain = positive(value.xreplace({b: bow}) > 0, [b < bow, lift], [zero_of(value), -S.One])
    here = Given(b < bow, b >= LOW, A > 0, BOX[A][1] >= A, gamma >= 0, delta >= 0)
    return by_contradiction(bow <= b, here.closed(gain), negative_below(delay))


@cache
def near_the_line(delay: int) -> Theorem:
    """The claim of second order for the wall (alpha, beta), on the boundary."""
    place = coordinates(delay)
    _, low = (conjunct(on_it(delay), c) for c in conjuncts(on_it(delay).conclusion))
    left = conjunct(assume(on_boundary_at(delay)), -gamma < alpha)
    arm = gamma >= 0, gamma <= STIFF, delta >= 0, delta <= DAMPED
    here = Given(alpha <= SMALL, beta <= HIGH, *arm).and_(left, low, zero(delay))
    found = [here.closed(inst(f(delay), place)) for f in (not_above, not_below)]
    claims = second_order(delay)
    shown = [combined(c, [t]) for c, t in zip(claims, found, strict=True)]
    return closed(of_every_plant(conj(*shown)), slow())


@cache
def linearised() -> Theorem:
    """What the claim of the paper concludes, under its hypotheses."""
    return conj(*(disch(near_the_line(n), on_boundary_at(n)) for n in LATE))
