"""The damping of walls that meet (5), for every real delay, and the frequency that bounds it."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.extent import ends, sine
from symhaptic.book.lemmas.linear_part import shares
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import WHOLE_WALL, first_half
from symhaptic.model import passivity
from symhaptic.notation import b
from symhaptic.proof.theorems.familiar import bounded


def divisors(angle: Any) -> tuple[Theorem, ...]:
    """2 - 2 cos and sin(theta/2) are not zero, for 0 < theta < pi."""
    half = sine_of_half(angle)
    return not_zero(half), not_zero(positive(2 - 2 * cos(angle) > 0, [4, half, half]))


def margins(frequencies: Any) -> Theorem:
    """The margin at every angle between 0 and pi, from (5) at every frequency."""
    angle = theta / T
    inside = over(angle > 0, theta > 0, T > 0), over(angle < pi / T, assume(theta < pi), T > 0)
    met = at(assume(frequencies), {omega: angle}, *inside)
    found = closed(positive(passivity.margin() >= 0, [met]), not_zero(assume(T > 0)))
    return for_all([theta], INSIDE, closed(found, *divisors(theta)))


def on_first_half(frequencies: Any) -> Theorem:
    """The margin on the first half turn, from (5) at every frequency."""
    claim = first_half()
    frequency = 2 * phi / T
    half = positive(2 * phi < pi, phi * (2 * d + 2) < pi, [2, d >= 0, phi > 0])
    inside = (
        over(frequency > 0, positive(2 * phi > 0, [2, phi > 0]), T > 0),
        over(frequency < pi / T, positive(pi - 2 * phi > 0, [half]), T > 0),
    )
    met = at(assume(frequencies), {omega: frequency}, *inside)
    found = positive(claim.body.of[1], [met])  # type: ignore[attr-defined]
    low = positive(2 * phi > 0, [2, phi > 0])
    wave = closed(sine(phi), positive(phi < pi / 2, [HALF, half]))
    apart = *divisors(2 * phi), not_zero(wave), not_zero(assume(T > 0)), low, half
    return for_all([phi], claim.body.of[0].of, closed(found, *apart))  # type: ignore[attr-defined]


def between(frequencies: Any) -> tuple[Theorem, Theorem]:
    """B <= b and -b <= B for a wall that meets (5) and does not pull; d >= 0 is real."""
    high, low = (inst(end, WHOLE_WALL) for end in ends())
    size = positive(2 * d + 2 >= 2, [2, d >= 0])
    pushes = assume(K >= 0), assume(T > 0)
    above = positive(b >= B, [high], [HALF, *pushes])
    below = positive(-b <= B, [low], [HALF, *pushes, shares()[1]])
    known = on_first_half(frequencies)
    return closed(above, size, known), closed(below, size, known)


def limit_points(claim: Any, frequencies: Any) -> Theorem:
    """The largest and the smallest damping, and that they just meet (5)."""
    found = []
    for end, bound, way in zip(claim.of, between(frequencies), (1, -1), strict=True):
        spring, damper = map(assume, end.of[0].of)
        met, order = end.of[1].of
        angle = omega * T
        turn = (d + 1) * angle
        wave = combined(
            1 + way * cos(turn) >= 0,
            [HALF, square(1 + way * cos(turn))],
            [HALF, bounded(cos, turn)],
        )
        need = met.body.of[1]
        of = [derivative(need.right, s) for s in (x, y)]
        inside = (
            positive(angle > 0, [omega > 0, T > 0]),
            positive(angle < pi, [T > 0, omega < pi / T]),
        )
        weak = combined(need, [assume(b >= 0), wave], [spring, -of[0]], [damper, -of[1]])
        weak = closed(weak, *divisors(angle), *inside, not_zero(assume(T > 0)))
        weak = for_all([omega], met.body.of[0].of, weak)
        last = combined(order, [bound], [damper, S(-way)])
        found.append(disch(conj(weak, last), *end.of[0].of))
    return conj(*found)


def upper_frequency(equation: Any, claim: Any) -> Theorem:
    """The claim at omega = pi/(T (d+1)), for d > 0."""
    there = equation.rhs
    low, high, same, reached = claim.at({omega: there}).of
    period, more = assume(T > 0), shares()[0]
    size = positive(T * (d + 1) > 0, [period, more])
    apart = [not_zero(t) for t in (size, more, period)]
    above = over(low, PI, size)
    below = over(high, positive(pi * d > 0, [PI, d > 0]), size)
    angle = there * T
    inside = positive(angle > 0, [period, above]), positive(angle < pi, [period, below])
    level = divisors(angle)
    five, linear = same.of
    either = either_way(positive(linear, [five]), positive(five, [linear]), five, linear)
    equal = identity(reached.left, reached.right)
    found = conj(above, below, either, equal)
    turned = combined(Eq(there, omega), [assume(equation), -S.One])
    found = subst(claim, omega, found, turned)
    return closed(found, *level, *inside, *apart, positive(d >= 0, d > 0))
