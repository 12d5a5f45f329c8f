"""Angles beyond N psi = pi cut nothing off: there the margin is as large as at some angle before.

With u = KT/2 >= 0 and w = B + KT/2 the margin is margin(psi) = b - u cot psi sin N psi +
w cos N psi, for psi = theta/2 and N = 2(d+1) >= 2; all numbers are real.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, anywhere, lowest_coefficients, not_zero
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import b, u, w
from symhaptic.proof.theorems.familiar import bounded

SIZE = positive(N > 0, N >= 2, [2])


def margin(angle: Expr = psi) -> Expr:
    """b - u cot psi sin N psi + w cos N psi."""
    return b - u * cos(angle) * sin(N * angle) / sin(angle) + w * cos(N * angle)


def first_half_turn() -> Proposition:
    """The margin for 0 < phi < pi/N is not negative."""
    return ForAll((phi,), implied([phi > 0, N * phi < pi], margin(phi) >= 0))


@anywhere
def sine() -> Theorem:
    """0 < sin psi for 0 < psi < pi/2."""
    return closed(sign_of(sin, psi), positive(psi < pi, psi < pi / 2, [HALF, PI]))


@anywhere
def cotangent() -> Theorem:
    """0 < cot psi for 0 < psi < pi/2."""
    top = closed(sign_of(cos, psi), positive(psi > -pi / 2, psi > 0, [HALF, PI]))
    return closed(over(cos(psi) / sin(psi) > 0, top, sine()), not_zero(sine()))


@cache
def ends() -> tuple[Theorem, Theorem]:
    """0 <= b - w and 0 <= b + w - N u, from the ends of the first half turn."""
    angle, wave = pi / N, _sine_at_end()
    back = positive(N * phi < pi, [SIZE, assume(phi < angle)])
    given = assume(phi > 0), assume(N * phi < pi)
    inside = closed(at(assume(first_half_turn()), {phi: phi}, *given), back)
    interval = over(angle > 0, PI, SIZE)
    found = []
    for end, value in ((angle, b - w), (S.Zero, b - u * N + w)):
        known = in_the_limit(inside, phi, S.Zero, angle, tends(margin(phi), phi, end, value))
        divisors = lowest_coefficients(known, wave, angle)
        found.append(closed(known, *divisors, interval, not_zero(SIZE)))
    return found[0], found[1]


def _sine_at_end() -> Theorem:
    """0 < sin(pi/N)."""
    low = over(pi / N > 0, PI, SIZE)
    high = over(pi / N < pi, positive(pi * (N - 1) > 0, [PI, N >= 2], [PI]), SIZE)
    return closed(sign_of(sin, pi / N), low, high, not_zero(SIZE))


@cache
def weak_sine(angle: Expr) -> Theorem:
    """0 <= sin x for 0 <= x <= pi."""
    goal = sin(x) >= 0
    inside = positive(goal, [sign_of(sin, x)])
    zero = number(Relation(S.Zero, "<=", S.Zero))
    start, end = (
        subst(goal, x, zero, combined(Eq(e, x), [assume(Eq(x, e)), S.NegativeOne]))
        for e in (S.Zero, pi)
    )
    below = strictly(assume(x <= pi), assume(Ne(x, pi)))
    inside = disj_cases(decided(x, pi), end, closed(inside, below))
    above = closed(inside, strictly(assume(x >= 0), combined(Ne(S.Zero, x), [assume(Ne(x, 0))])))
    found = disj_cases(decided(x, S.Zero), start, above)
    return inst(found, {x: angle})


REST = N * psi - 2 * pi * l


@cache
def same_turn() -> tuple[Theorem, Theorem]:
    """sin N psi and cos N psi are those of N psi - 2 pi l."""
    turns = full_turns(REST, assume(whole(l)))
    return tuple(conjunct(turns, Relation(f(N * psi), "=", f(REST))) for f in (sin, cos))  # type: ignore[return-value]


@cache
def repeated() -> Theorem:
    """The margin where N psi is less than pi beyond l full turns, 0 < l: above that at phi."""
    low = REST / N
    positive_low, positive_l = over(low > 0, assume(REST > 0), SIZE), assume(l > 0)
    given = positive_low, positive(N * low < pi, pi > REST)
    known = at(assume(first_half_turn()), {phi: low}, *given)
    gap = over(psi - low > 0, positive(2 * pi * l > 0, [2, PI, positive_l]), SIZE)
    below = positive(low < pi / 2, [gap], psi < pi / 2)
    wave = closed(
        sign_of(sin, psi - low),
        gap,
        positive(psi - low < pi, psi < pi / 2, [positive_low], [HALF, PI]),
    )
    inside = sine(low)
    falls = over(
        cos(low) / sin(low) - cos(psi) / sin(psi) > 0,
        positive(sin(psi - low) > 0, [wave]),
        positive(sin(low) * sin(psi) > 0, [inside, sine()]),
    )
    up = closed(sign_of(sin, REST))
    by_sine, by_cosine = same_turn()
    found = combined(
        margin() >= 0,
        [known],
        [assume(u >= 0), falls, up],
        [by_sine, u * cos(psi) / sin(psi)],
        [by_cosine, -w],
    )
    product = positive(sin(low) * sin(psi) > 0, [inside, sine()])
    divisors = map(not_zero, (inside, sine(), SIZE, product))
    return closed(found, *divisors, positive_low, below)


@cache
def within_a_turn() -> Theorem:
    """The margin where 0 < N psi - 2 pi l < pi."""
    goal = margin() >= 0
    less = positive(N * psi < pi, pi > REST, [2, PI, positive(-l >= 0, l <= 0)])
    first = closed(at(assume(first_half_turn()), {phi: psi}, assume(psi > 0), less))
    return disj_cases(ordered(S.Zero, l), positive(goal, [repeated()]), positive(goal, [first]))


@cache
def beyond() -> Theorem:
    """The margin where sin N psi <= 0: at least b - |w|."""
    high, low = ends()
    wave, size = cos(N * psi), bounded(cos, N * psi)
    up, down = (
        combined(1 + s * wave >= 0, [HALF, square(1 + s * wave)], [HALF, size]) for s in (1, -1)
    )
    low = positive(b + w >= 0, [low], [SIZE, u >= 0])
    return positive(
        margin() >= 0,
        [HALF, low, up],
        [HALF, high, down],
        [u >= 0, cotangent(), -sin(N * psi) >= 0],
    )


@cache
def extent() -> Theorem:
    """The margin at every 0 < psi < pi/2, from that for 0 < N psi < pi; N >= 2 and u >= 0."""
    by_sine = same_turn()[0]
    falling = positive(-sin(N * psi) >= 0, -sin(REST) >= 0, [by_sine, S.One])
    outside = closed(beyond(), falling)
    zero = number(Relation(S.Zero, "<=", S.Zero))
    start = combined(
        Eq(S.Zero, REST), [both_ways(assume(REST <= 0), assume(REST >= 0)), S.NegativeOne]
    )
    at_start = closed(outside, subst(-sin(x) >= 0, x, zero, start))
    late = positive(REST - pi <= pi, N * psi < (l + 1) * (2 * pi))
    after = closed(outside, weak_sine(REST - pi), positive(REST - pi >= 0, pi <= REST), late)
    above = disj_cases(ordered(REST, pi), within_a_turn(), after)
    found = disj_cases(ordered(S.Zero, REST), above, at_start)
    found = closed(found, positive(REST >= 0, l * 2 * pi <= N * psi))
    turns = with_rest(N * psi, 2 * pi, l)
    found = choose(turns, found)
    return closed(
        found, positive(N * psi >= 0, [SIZE, psi > 0]), number(Relation(S.Zero, "<", 2 * pi))
    )
