"""The passivity condition without delay and its summary (6), which wants b > KT/2 + |B|."""

from symhaptic.book.lemmas.passivity import PASSIVE, every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.passivity import SIX

BORDER = K * T / 2 + Abs(B)
APART = proposition(Ne(b, BORDER))
OFF_BORDER = Or((proposition(Eq(B, 0)), APART))
NEED = K * T / 2 - B * cos(theta)
"""The damping that an angle needs."""
STEADY = PASSIVE.at({d: S.Zero})
PI = number(Relation(S.Zero, "<", pi))


def cosine_bounds(angle: Expr) -> list[Theorem]:
    """0 <= 1 + cos and 0 <= 1 - cos."""
    size = bounded(cos, angle)
    return [
        combined(1 + way * cos(angle) >= 0, [HALF, square(1 + way * cos(angle))], [HALF, size])
        for way in (1, -1)
    ]


def by_sign_of_damping(up: Theorem, down: Theorem) -> Theorem:
    """One conclusion for B >= 0 and for B < 0."""
    return disj_cases(ordered(B, S.Zero), down, up)


def enough(frequencies: Any) -> Theorem:
    """(6) gives the condition at every frequency: -B cos <= |B|."""
    angle = omega * T
    claim = frequencies.body.of[1]
    up, down = cosine_bounds(angle)
    above = combined(claim, [assume(SIX)], [magnitude(B), -1], [assume(B >= 0), up])
    below = combined(
        claim, [assume(SIX)], [magnitude(B, negative=True), -1], [positive(-B >= 0, B < 0), down]
    )
    below = closed(below, positive(B <= 0, B < 0))
    return for_all([omega], frequencies.body.of[0].of, by_sign_of_damping(above, below))


def damped_side() -> Theorem:
    """(6) is b > KT/2 + B, where B is not negative."""
    linear = proposition(b > K * T / 2 + B)
    there = combined(linear, [assume(SIX)], [magnitude(B), -1])
    back = combined(proposition(SIX), [assume(linear)], [magnitude(B)])
    return either_way(there, back, proposition(SIX), linear)


def at_an_angle(frequencies: Any) -> Theorem:
    """The condition at an angle between 0 and pi."""
    angle = theta / T
    inside = over(angle > 0, theta > 0, T > 0), over(angle < pi / T, assume(theta < pi), T > 0)
    return closed(at(assume(frequencies), {omega: angle}, *inside), positive(Ne(T, 0), T > 0))


def weakly_needed(frequencies: Any) -> Theorem:
    """The condition at every frequency gives b >= KT/2 + |B|, at one end of the interval."""
    return _on_the_border(at_an_angle(frequencies))


def _on_the_border(inside: Theorem) -> Theorem:
    """b >= KT/2 + |B| from b > KT/2 - B cos(theta), or >=, at every angle."""
    rest = b - NEED
    ends = [
        prove_hyp(in_the_limit(inside, theta, S.Zero, pi, tends(rest, theta, end, value)), PI)
        for end, value in ((pi, b - K * T / 2 - B), (S.Zero, b - K * T / 2 + B))
    ]
    above = combined(b >= BORDER, [ends[0]], [magnitude(B), 1])
    below = combined(b >= BORDER, [ends[1]], [magnitude(B, negative=True), 1])
    return by_sign_of_damping(above, closed(below, positive(B <= 0, B < 0)))


def off_the_border(frequencies: Any, sufficient: Theorem, needed: Theorem) -> Theorem:
    """(6) and the condition at every frequency, away from the border or without damping."""
    middle = at(assume(frequencies), {omega: pi / (2 * T)}, *middle_inside())
    none = assume(Eq(B, 0))
    calm = combined(SIX, [middle], [none, 1], [magnitude(B), 1])
    calm = closed(
        calm,
        combined(B >= 0, [none, -1]),
        positive(Ne(T, 0), T > 0),
        positive(Ne(2 * T, 0), [2, T > 0]),
    )
    apart = strictly(needed, assume(Ne(b, BORDER)))
    return either_way(disj_cases(assume(OFF_BORDER), calm, apart), sufficient, frequencies, SIX)


def middle_inside() -> tuple[Theorem, Theorem]:
    """pi/(2T) lies between 0 and pi/T."""
    half = number(Relation(S.Zero, "<", pi / 2))
    return (over(pi / (2 * T) > 0, half, T > 0), over(pi / (2 * T) < pi / T, half, T > 0))


def passive() -> Theorem:
    """b >= KT/2 + |B| and K >= 0 make the wall passive without delay."""
    found = passive_by_angle(S.Zero)
    margin, enough_ = passivity.margin().subs(d, 0), assume(b >= BORDER)
    up, down = cosine_bounds(theta)
    above = combined(margin >= 0, [enough_], [magnitude(B), -1], [assume(B >= 0), up])
    below = combined(
        margin >= 0, [enough_], [magnitude(B, negative=True), -1], [positive(-B >= 0, B < 0), down]
    )
    below = closed(below, positive(B <= 0, B < 0))
    always = for_all([theta], INSIDE, by_sign_of_damping(above, below))
    return follows(found, assume(K >= 0), always)


def passive_in_numbers(point: Mapping[Expr, Expr]) -> Theorem:
    """A wall without delay in numbers is passive, for B >= 0."""
    up, _ = cosine_bounds(theta)
    level = K * T / 2 + B
    margin = combined(
        passivity.margin().subs(d, 0) >= 0, [assume(b >= level)], [assume(B >= 0), up]
    )
    found = follows(passive_by_angle(S.Zero), assume(K >= 0), for_all([theta], INSIDE, margin))
    found = inst(found, point)
    return closed(found, *map(fact, found.hypotheses))


def decides() -> Theorem:
    """(6) <=> passive, for K >= 0 and b != KT/2 + |B|."""
    held = mp(passive_by_angle(S.Zero), assume(STEADY))
    always = conjunct(held, every_margin(S.Zero))
    inside = positive(b >= NEED, [at(always, {theta: theta}, *map(assume, INSIDE))])
    needed = strictly(_on_the_border(inside), assume(Ne(b, BORDER)))
    enough_ = closed(passive(), positive(b >= BORDER, [assume(SIX)]))
    return either_way(enough_, needed, SIX, STEADY)


def undelayed_form(claim: Any) -> Theorem:
    """(5) without delay is the form, at each frequency (``claim``)."""
    inside, same = claim.body.of
    five, form = same.of
    angle = omega * T
    within = (
        positive(angle > 0, [omega > 0, T > 0]),
        closed(positive(angle < pi, [omega < pi / T, T > 0]), not_zero(assume(T > 0))),
    )
    half = sine_of_half(angle)
    turned = not_zero(positive(1 - cos(angle) > 0, [2, half, half]))
    doubled = not_zero(positive(2 - 2 * cos(angle) > 0, [4, half, half]))
    ways = combined(form, [assume(five)]), combined(five, [assume(form)])
    there, back = (closed(closed(way, turned, doubled), *within) for way in ways)
    return for_all([omega], inside.of, either_way(there, back, five, form))


def on_the_border(frequencies: Any) -> Theorem:
    """1/2 - cos(omega) < 3/2 at every frequency."""
    half = closed(
        sign_of(cos, omega / 2),
        positive(omega / 2 > -pi / 2, [HALF, omega > 0], [HALF, PI]),
        positive(omega / 2 < pi / 2, [HALF, omega < pi]),
    )
    found = combined(frequencies.body.of[1], [2, half, half])
    return for_all([omega], frequencies.body.of[0].of, found)


def not_six(point: dict[Expr, Expr]) -> Theorem:
    """The border itself is no wall of (6)."""
    edge = (K * T / 2 + Abs(B)).subs(point)
    return identity(edge, point[b])


def either(claim: Any, theorem: Theorem) -> Theorem:
    """One of two cases, from one of them."""
    return disj(theorem, claim)
