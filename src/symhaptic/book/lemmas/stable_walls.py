"""Walls that are just passive, and the linear condition, in entire functions."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_forms import Block, Later, nonzero
from symhaptic.book.lemmas.stable_need import (
    ANGLE,
    S_0,
    Z_1,
    Z_2,
    defined,
    half_angle,
    kernel,
    named,
)
from symhaptic.forms import stable, stiffest_passive
from symhaptic.forms.entire import Chord, Sinc, Spread, written_out
from symhaptic.proof.theorems.familiar import divided

LINE = (x, kernel(d, theta)), (y, derivative(kernel(d, theta), theta))
"""The line of an angle, delta = alpha x - beta cos((d + 1) theta), and how its x changes."""
TURN, PUSH = 2 * (d + 1) * theta, 2 * (d + 1) * sin(theta)
ENVELOPE = {Sinc(theta / 2): S_0, Spread(d, theta): Z_1, Chord(d, theta): Z_2}


def _envelope() -> Block:
    """The wall in which the line of an angle meets that of the next."""
    computed = (ours for ours, _ in stable.form("passivity_boundary").equal[:2])
    below = (d + 1) * x * sin((d + 1) * theta) + y * cos((d + 1) * theta)
    exact = delta * (d + 1) * sin((d + 1) * theta) / below, -delta * y / below
    pairs = (
        Relation(named(o, ENVELOPE), "=", known) for o, known in zip(computed, exact, strict=True)
    )
    where = (*ANGLE, Relation(sin(TURN), "!=", PUSH))
    names = (*defined(ENVELOPE), *LINE)
    return Block(
        (theta, d, delta),
        where,
        names,
        tuple(pairs),
        {theta: S.One, d: S.One, delta: S(2)},
        _crossed,
    )


WORST = pi * (1 / (d + 1)) / 2
"""The worst angle of the passive wall of maximum stiffness."""
STIFFEST_LINE = tuple((name, of.subs(theta, WORST)) for name, of in LINE)


def _stiffest() -> Block:
    """The passive wall of largest stiffness with integer delays: there cos((d + 1) theta) = 0."""
    entire = {Sinc(WORST): S_0}
    computed = (ours for ours, _ in stable.form("max_passive_stiffness").equal[:2])
    exact = delta / x, -delta * y / ((d + 1) * x)
    pairs = (
        Relation(named(o, entire), "=", known) for o, known in zip(computed, exact, strict=True)
    )
    names = *defined(entire), *STIFFEST_LINE
    point = {d: S(6), delta: S(2)}
    return Block((d, delta), (proposition(d >= 0),), names, tuple(pairs), point, _worst)


def _late_stiffest() -> Block:
    """The same at a fraction of a period: the wall with the least stiffness that an angle allows.

    Of any angle: it needs delta there, more or less damping needs no less, and what is computed is
    this wall where the slope of its stiffness vanishes.
    """
    up, along = map(written_out, (stiffest_passive.sine(), stiffest_passive.cosine()))
    falls = written_out(stiffest_passive.falling(x, y))
    names = (x, up), (y, along), (v, falls)
    share = epsilon * (1 - epsilon)
    below = (l + epsilon + 1) * (1 + x) * sin(theta) + y * cos(theta)
    bound = 2 * delta * (1 - x) / (share * sin(theta))
    off = 2 * delta * y * v / (share * sin(theta) * below)
    lost = 2 * delta * v / (share * sin(theta)) - off * cos(theta)
    exact = (
        S.Zero,
        S.Zero,
        -2 * delta * v / (share * sin(theta) ** 2),
        bound - off,
        delta * y / (share * sin(theta / 2) ** 2)
        - lost / (2 * (l + epsilon + 1) * sin(theta / 2) ** 2),
    )
    computed = (ours for ours, _ in stiffest_passive.derived())
    pairs = tuple(Relation(ours, "=", known) for ours, known in zip(computed, exact, strict=True))
    where = (*ANGLE, *map(proposition, (l >= 0, epsilon > 0, epsilon < 1)))
    where = (*where, Relation(below.xreplace({x: up, y: along}), "!=", S.Zero))
    point = {theta: S.One, l: S.One, epsilon: HALF, delta: S(2)}
    return Block((theta, l, epsilon, delta), where, names, pairs, point, _late)


def _linear() -> Block:
    """Where the linear condition is an equality the margin of slow motions is zero."""
    ((computed, exact),) = stable.form("linear_limit").equal
    margin = delta - (x * kernel(d, theta) - beta * cos((d + 1) * theta))
    limit = Predicate("limit", (theta,), (margin, S.Zero, S.Zero))
    pairs = Relation(written_out(computed), "=", exact), limit
    point = {d: S.One, beta: S.One, delta: S(2)}
    return Block((d, beta, delta), (proposition(d >= 0),), ((x, computed),), pairs, point, _order)


def _crossed() -> list[Theorem]:
    """The lines of an angle and of the next are not parallel."""
    known = dict(LINE)
    spread = combined(Ne(PUSH - sin(TURN), 0), [-1, assume(Relation(sin(TURN), "!=", PUSH))])
    below = (d + 1) * known[x] * sin((d + 1) * theta) + known[y] * cos((d + 1) * theta)
    crossed = nonzero(below, spread, times=8 * sin(theta / 2) ** 2)
    own = nonzero((PUSH - sin(TURN)) / theta**3, spread, times=theta**3)
    return [*half_angle(), spread, crossed, own]


def _worst() -> list[Theorem]:
    """The worst angle of the stiffest wall is one between 0 and pi."""
    turn = number(Relation(S.Zero, "<", pi))
    late = positive(d + 1 > 0, [d >= 0], [one()])
    twice, rest = (
        combined(2 * (d + 1) > 0, [2, late]),
        positive(2 * d + 1 > 0, [2, d >= 0], [one()]),
    )
    low = divided(WORST > 0, turn, twice)
    high = divided(pi > WORST, combined(pi * (2 * d + 1) > 0, [turn, rest]), twice)
    sine, half = closed(sign_of(sin, WORST), low, high), closed(sine_of_half(WORST), low, high)
    cosine = nonzero(cos(WORST / 2), sine, times=2 * sin(WORST / 2))
    other = sin((d + HALF) * WORST)
    known = [nonzero(sin(WORST), sine, times=S.One), nonzero(sin(WORST / 2), half, times=S.One)]
    known += [cosine, nonzero(other, cosine, times=S.One), nonzero(d + 1, late, times=S.One)]
    known.append(nonzero(other / (2 * sin(WORST / 2)), cosine, times=2 * sin(WORST / 2)))
    return known


def _late() -> list[Theorem]:
    """Neither fraction of the period is empty, and no sine vanishes."""
    wave = closed(sign_of(sin, theta), assume(theta > 0), assume(theta < pi))
    late = positive(l + epsilon + 1 > 0, [l >= 0], [epsilon > 0], [one()])
    rest = positive(1 - epsilon > 0, epsilon < 1)
    shown = (epsilon, assume(epsilon > 0)), (1 - epsilon, rest), (l + epsilon + 1, late)
    known = [nonzero(of, why, times=S.One) for of, why in (*shown, (sin(theta), wave))]
    return [*half_angle(), *known, nonzero(2 * l + 2 * epsilon + 2, late, times=S.Half)]


def _order() -> list[Theorem]:
    """d + 1/2 is positive."""
    above = positive(d + HALF > 0, [d >= 0], [HALF, one()])
    return [combined(Ne(d + HALF, 0), [above])]


TOUCHED, STIFFEST, LINEAR = Later(_envelope), Later(_stiffest), Later(_linear)
LATE_STIFFEST = Later(_late_stiffest)
