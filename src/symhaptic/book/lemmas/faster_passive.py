"""What faster sampling gains for the largest passive stiffness at the same delay in seconds.

By (11) that stiffness is 2 b/T tan(pi/(4 (d+1))), and the tangent over its angle rises.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.passive_tip import known, passive_wall
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import TURN, bound, waves
from symhaptic.notation import b
from symhaptic.paper.propositions.conclusion import FASTER
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.proof.theorems.analysis import grows

u, v, w = symbols("u v w")


@cache
def above_the_sine() -> Theorem:
    """sin v cos v < v for 0 < v < pi/2."""
    rest = w - sin(w) * cos(w)
    # the derivative is 2 sin(w)^2
    sine = closed(
        sign_of(sin, w),
        positive(w < pi, w < v, v < pi / 2, [HALF, PI]),
    )
    rise = grows(rest, w, S.Zero, v, positive(derivative(rest, w) > 0, [2, sine, sine]))
    return positive(v - sin(v) * cos(v) > 0, [rise])


@cache
def tangent_over_angle() -> Theorem:
    """0 < w sin w'/cos w' - w' sin w/cos w for the angles 0 < w < w' < pi/2, w' being u."""
    quotient = sin(v) / (v * cos(v))

    def waves(angle: Expr, low: Theorem, high: Theorem) -> Theorem:
        """0 < cos of an angle in the first quarter."""
        return closed(sign_of(cos, angle), positive(-pi / 2 < angle, [low], [HALF, PI]), high)

    cosine = waves(v, assume(v > 0), assume(v < pi / 2))
    size = positive(v * cos(v) > 0, [v > 0, cosine])
    slope_ = over(
        derivative(quotient, v) > 0,
        above_the_sine(),
        positive(v**2 * cos(v) ** 2 > 0, [size, size]),
    )
    inner = positive(v > 0, w < v, w > 0), positive(v < pi / 2, v < u, u < pi / 2)
    apart = not_zero(size), not_zero(assume(v > 0)), not_zero(cosine)
    slope_ = closed(slope_, *apart, *inner)
    rise = grows(quotient, v, w, u, slope_, *(closed(t, *inner) for t in apart))
    larger = positive(u > 0, w < u, w > 0)
    ends = [
        (w, waves(w, assume(w > 0), positive(w < pi / 2, w < u, u < pi / 2)), assume(w > 0)),
        (u, waves(u, larger, assume(u < pi / 2)), larger),
    ]
    rest = [not_zero(t) for _, *some in ends for t in some]
    rest += [not_zero(positive(a * cos(a) > 0, [t, c])) for a, c, t in ends]
    goal = w * sin(u) / cos(u) - u * sin(w) / cos(w)
    found = positive(goal > 0, [larger, assume(w > 0), rise])
    return closed(found, *rest, larger)


LATER = FASTER * d
"""The delay in the shorter periods."""


def claim() -> Proposition:
    """At q times the rate a passive wall is at most 1 + 1/d times as stiff as some passive one.

    The delay is the same in seconds, d periods of the slower rate; d and q are whole, 1 <= d.
    """
    best, others = PASSIVE.at({K: x, B: y}), PASSIVE.at({T: T / FASTER, d: LATER})
    rest = ForAll((K, B), implied([others], (1 + 1 / d) * x >= K))
    given = [T > 0, b >= 0, whole(d), d >= 1, whole(FASTER), FASTER >= 1]
    return ForAll((b, T, d, FASTER), implied(given, Exists((x, y), both([best, rest]))))


@cache
def weakly() -> Theorem:
    """0 <= w tan u - u tan w for 0 < w <= u < pi/2."""
    goal = w * sin(u) / cos(u) - u * sin(w) / cos(w)
    strict = positive(goal >= 0, [tangent_over_angle()])
    equal = both_ways(assume(w <= u), assume(u <= w))
    place = Symbol("t")
    there = goal.xreplace({w: place})
    low = positive(u > 0, w <= u, w > 0)
    cosine = closed(sign_of(cos, u), positive(-pi / 2 < u, [low], [HALF, PI]))
    same = number(Relation(S.Zero, "<=", S.Zero))
    back = combined(Eq(u, w), [equal, -S.One])
    turned = subst(there >= 0, place, same, back)
    other = closed(sign_of(cos, w), positive(-pi / 2 < w, w > 0, [HALF, PI]))
    other = closed(other, positive(w < pi / 2, w <= u, u < pi / 2))
    found = disj_cases(ordered(w, u), strict, turned)
    return closed(found, not_zero(cosine), not_zero(other))


@cache
def gains_little() -> Theorem:
    """:func:`claim`, by (11) for both rates."""
    symbols, given, some = taken_apart(claim())
    best = passive_wall()
    stiffness, damping = best.conclusion.of[:2]  # type: ignore[attr-defined]
    later = {T: T / FASTER, d: LATER}
    small, large = TURN.xreplace({d: LATER}), TURN
    late = positive(d > 0, d >= 1, [1])
    rate = positive(FASTER > 0, FASTER >= 1, [1])
    more, many = positive(d + 1 > 0, [late], [1]), positive(LATER + 1 > 0, [late, rate], [1])
    order = positive(
        large - small >= 0,
        [
            over(
                (FASTER - 1) * d * pi / (4 * (d + 1) * (LATER + 1)) >= 0,
                positive(
                    (FASTER - 1) * d * pi >= 0, [positive(FASTER - 1 >= 0, FASTER >= 1), late, PI]
                ),
                positive(4 * (d + 1) * (LATER + 1) > 0, [4, more, many]),
            )
        ],
    )
    turn = over(small > 0, number(Relation(S.Zero, "<", pi / 4)), many)
    below = waves()["below"]
    ratio = closed(
        inst(weakly(), {w: small, u: large}), turn, positive(small <= large, [order]), below
    )
    softer = inst(bound(), later)
    period = over(1 / T > 0, one(), T > 0)
    share = over((d + 1) / (d * (LATER + 1)) > 0, more, positive(d * (LATER + 1) > 0, [late, many]))
    factor_ = over(
        4 * (d + 1) * FASTER / pi > 0, positive(4 * (d + 1) * FASTER > 0, [4, more, rate]), PI
    )
    tangent = positive(
        sin(large) / cos(large) > 0,
        [over(sin(large) / cos(large) > 0, waves()["sine"], waves()["cosine"])],
    )
    wanted = (1 + 1 / d) * stiffness >= K
    room = positive(
        wanted,
        [2, assume(b >= 0), period, share, tangent],
        [2, assume(b >= 0), period, factor_, ratio],
        [softer],
    )
    quick = over(T / FASTER > 0, assume(T > 0), rate)
    rest = [
        *(not_zero(t) for t in (rate, quick, late, more, many)),
        *(not_zero(positive(4 * t.conclusion.right > 0, [4, t])) for t in (more, many)),  # type: ignore[attr-defined]
        quick,
        is_whole(LATER, assume(whole(d)), assume(whole(FASTER))),
        positive(LATER >= 0, [late, rate]),
        positive(d >= 0, [late]),
        *known(),
    ]
    others = some.body.of[1]  # type: ignore[attr-defined]
    values = {x: stiffness, y: damping}
    bare = for_all([K, B], [others.at(values).body.of[0]], closed(room, *rest))
    found = closed(exists(conj(best, bare), some, values), *rest, *rest)
    return for_all(symbols, given, add_assum(found, *given))
