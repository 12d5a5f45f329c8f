"""The damping of walls that meet (5), for every real delay, and the frequency that bounds it."""

from symhaptic.book.lemmas.extent import ends
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import DELAY, TURN, WHOLE_WALL, first_half


def divisors(angle: Any) -> tuple[Theorem, ...]:
    """2 - 2 cos and sin(theta/2) are not zero, for 0 < theta < pi."""
    half = sine_of_half(angle)
    return show(Ne(sin(angle / 2), 0), half), show(Ne(2 - 2 * cos(angle), 0), half)


def margins(frequencies: Any) -> Theorem:
    """The margin at every angle between 0 and pi, from (5) at every frequency."""
    here = Given(T > 0, *INSIDE)
    angle = theta / T
    met = at(assume(frequencies), {omega: angle}, here.show(angle > 0), here.show(angle < pi / T))
    found = show(passivity.margin() >= 0, met)
    return for_all([theta], INSIDE, here.closed(found, sine_of_half(theta)))


def on_first_half(frequencies: Any) -> Theorem:
    """The margin on the first half turn, from (5) at every frequency."""
    claim: Any = first_half()
    frequency = 2 * phi / T
    inside = TURN.show(frequency > 0), TURN.show(frequency < pi / T)
    met = at(assume(frequencies), {omega: frequency}, *inside)
    found = show(claim.body.of[1], met)
    found = TURN.closed(found, TURN.closed(sine_of_half(2 * phi)))
    return for_all([phi], claim.body.of[0].of, found)


def between(frequencies: Any) -> tuple[Theorem, Theorem]:
    """B <= b and -b <= B for a wall that meets (5) and does not pull; d >= 0 is real."""
    high, low = (inst(end, WHOLE_WALL) for end in ends())
    here, known = DELAY.and_(K >= 0), on_first_half(frequencies)
    above, below = here.show(b >= B, high), here.show(-b <= B, low, degree=3)
    return closed(above, known), closed(below, known)


def limit_points(claim: Any, frequencies: Any) -> Theorem:
    """The largest and the smallest damping, and that they just meet (5)."""
    found = []
    for end, bound, way in zip(claim.of, between(frequencies), (1, -1), strict=True):
        spring, damper = map(assume, end.of[0].of)
        met, order = end.of[1].of
        angle = omega * T
        turn = (d + 1) * angle
        wave = show(1 + way * cos(turn) >= 0, square(1 + way * cos(turn)), bounded(cos, turn))
        need = met.body.of[1]
        of = [derivative(need.right, s) for s in (x, y)]
        here = Given(T > 0, omega > 0, omega < pi / T)
        weak = combined(need, [assume(b >= 0), wave], [spring, -of[0]], [damper, -of[1]])
        weak = for_all([omega], met.body.of[0].of, here.closed(weak, sine_of_half(angle)))
        found.append(disch(conj(weak, show(order, bound, damper)), *end.of[0].of))
    return conj(*found)


def upper_frequency(equation: Any, claim: Any) -> Theorem:
    """The claim at omega = pi/(T (d+1)), for d > 0."""
    there = equation.rhs
    low, high, same, reached = claim.at({omega: there}).of
    here = Given(T > 0, d > 0)
    above, below = here.show(low), here.show(high)
    five, linear = same.of
    either = either_way(show(linear, five), show(five, linear), five, linear)
    equal = identity(reached.left, reached.right)
    found = conj(above, below, either, equal)
    found = subst(claim, omega, found, show(Eq(there, omega), equation))
    return here.closed(found, above, below, sine_of_half(there * T))
