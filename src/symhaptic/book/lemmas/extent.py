"""Angles beyond N psi = pi cut nothing off: there the margin is as large as at some angle before.

With u = KT/2 >= 0 and w = B + KT/2 the margin is margin(psi) = b - u cot psi sin N psi +
w cos N psi, for psi = theta/2 and N = 2(d+1) >= 2; all numbers are real.
"""

from symhaptic.book.lemmas.chords import lowest_coefficients
from symhaptic.book.lemmas.prelude import *

HERE = Given(N >= 2)
QUARTER = Given(psi > 0, psi < pi / 2)
sine = QUARTER.about(psi)(sin(psi) > 0)
cotangent = QUARTER.lemma(cos(psi) / sin(psi) > 0)


def margin(angle: Expr = psi) -> Expr:
    """b - u cot psi sin N psi + w cos N psi."""
    return b - u * cos(angle) * sin(N * angle) / sin(angle) + w * cos(N * angle)


def first_half_turn() -> Proposition:
    """The margin for 0 < phi < pi/N is not negative."""
    return ForAll((phi,), implied([phi > 0, N * phi < pi], margin(phi) >= 0))


@cache
def ends() -> tuple[Theorem, Theorem]:
    """0 <= b - w and 0 <= b + w - N u, from the ends of the first half turn."""
    angle, wave = pi / N, HERE.show(sin(pi / N) > 0)
    given = assume(phi > 0), assume(N * phi < pi)
    inside = HERE.closed(at(assume(first_half_turn()), {phi: phi}, *given), phi < angle)
    found = []
    for end, value in ((angle, b - w), (S.Zero, b - u * N + w)):
        known = in_the_limit(inside, phi, S.Zero, angle, tends(margin(phi), phi, end, value))
        found.append(HERE.closed(closed(known, *lowest_coefficients(known, wave, angle)), wave))
    return found[0], found[1]


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
    return inst(disj_cases(decided(x, S.Zero), start, above), {x: angle})


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
    here = Given(N >= 2, u >= 0, l > 0, REST > 0, pi > REST, psi < pi / 2)
    for claim in low > 0, psi - low > 0, sin(low) > 0, sin(psi) > 0:
        here.have(claim)
    first = first_half_turn()
    known = at(assume(first), {phi: low}, here.show(low > 0), here.show(N * low < pi))
    falls = over(
        cos(low) / sin(low) - cos(psi) / sin(psi) > 0, sin(psi - low) > 0, sin(low) * sin(psi) > 0
    )
    by_sine, by_cosine = same_turn()
    found = combined(
        margin() >= 0,
        [known],
        [assume(u >= 0), falls, sign_of(sin, REST)],
        [by_sine, u * cos(psi) / sin(psi)],
        [by_cosine, -w],
    )
    return here.closed(found)


@cache
def within_a_turn() -> Theorem:
    """The margin where 0 < N psi - 2 pi l < pi."""
    less = show(N * psi < pi, pi > REST, l <= 0)
    first = closed(at(assume(first_half_turn()), {phi: psi}, assume(psi > 0), less))
    goal = margin() >= 0
    return disj_cases(ordered(S.Zero, l), show(goal, repeated()), show(goal, first))


@cache
def beyond() -> Theorem:
    """The margin where sin N psi <= 0: at least b - |w|."""
    wave = cos(N * psi)
    squares = square(1 + wave), square(1 - wave), bounded(cos, N * psi)
    up, down = (show(1 + s * wave >= 0, *squares) for s in (1, -1))
    known = *ends(), up, down, cotangent(), -sin(N * psi) >= 0
    return Given(N >= 2, u >= 0, psi > 0, psi < pi / 2).show(margin() >= 0, *known, degree=3)


@cache
def extent() -> Theorem:
    """The margin at every 0 < psi < pi/2, from that for 0 < N psi < pi; N >= 2 and u >= 0."""
    falling = show(-sin(N * psi) >= 0, -sin(REST) >= 0, same_turn()[0])
    outside = closed(beyond(), falling)
    zero = number(Relation(S.Zero, "<=", S.Zero))
    start = both_ways(assume(REST <= 0), assume(REST >= 0))
    at_start = closed(outside, subst(-sin(x) >= 0, x, zero, show(Eq(S.Zero, REST), start)))
    here = Given(pi <= REST, N * psi < (l + 1) * (2 * pi))
    after = here.closed(outside, here.closed(weak_sine(REST - pi)))
    above = disj_cases(ordered(REST, pi), within_a_turn(), after)
    found = disj_cases(ordered(S.Zero, REST), above, at_start)
    found = closed(found, show(REST >= 0, l * 2 * pi <= N * psi))
    return Given(N >= 2, psi > 0).closed(choose(with_rest(N * psi, 2 * pi, l), found))
