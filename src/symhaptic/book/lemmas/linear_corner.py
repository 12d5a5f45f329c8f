"""Next to the start of the boundary the error of the linear condition exceeds 2 per cent.

The wall is that whose chord y is 25 times the gap: so near to the start the gap decides.
"""

from symhaptic.book.lemmas.arm_numbers import TOTAL, gap, together
from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.line_crossing import ROOM, slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW, TOP, reached
from symhaptic.book.lemmas.linear_far import arc, on_the_circle, quotient, unnamed
from symhaptic.book.lemmas.linear_gap import MOST, narrow
from symhaptic.book.lemmas.linear_rays import share
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import of_every_plant, on_box
from symhaptic.model.circle import expanded
from symhaptic.model.linear import CHORD
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import LEVEL, error, far_in_the_corner

TIMES, TINY = 25, Rational(1, 10**6)
RANGE = {**RANGES, CHORD: (0, TINY)}
BY_GAP = Relation(TOTAL * CHORD, "<=", TIMES * ROOM)
"""The chord is no larger than 25 times the gap."""


@cache
def wall(delay: int) -> Theorem:
    """The claim for a chord that is small enough, of one delay."""
    right, up, area = arc(delay)
    there = {alpha: CHORD * right / area - gamma, beta: up / area}
    stiff, damped = (assume(Relation(s, "=", w)) for s, w in there.items())
    size, wide = on_box(area, RANGE), on_box(right, RANGE)
    chord, weight = assume(CHORD > 0), share(delay)

    def by_stiffness(claim: Any, top: Theorem, share_: Any = -1) -> Theorem:
        return combined(claim, [quotient(top, size)], [stiff, share_])

    left = by_stiffness(-gamma < alpha, positive(CHORD * right > 0, [chord, wide]))
    soft = on_box(expanded(TOP[delay] * area - CHORD * right + gamma * area), RANGE)
    low = combined(beta > LOW, [quotient(on_box(up - LOW * area, RANGE), size)], [damped, -1])
    slim = positive(CHORD * (10 * area - right) > 0, [chord, on_box(10 * area - right, RANGE)])
    near = combined(
        alpha < 10 * CHORD, [quotient(slim, size)], [assume(gamma >= 0)], [stiff, S.One]
    )
    away = quotient(_away(delay), size)
    rest = -(beta + delta) + weight * alpha - LEVEL * weight * (alpha + gamma)
    away = combined(rest > 0, [away], [stiff, -(1 - LEVEL) * weight], [damped, S.One])
    less = positive(
        beta < 0,
        [away],
        [LEVEL * weight, left],
        [delta >= 100 * CHORD],
        [100 - 10 * weight, chord],
        [weight, near],
    )
    ends = (
        positive(alpha <= TOP[delay], [by_stiffness(alpha < TOP[delay], soft, 1)]),
        positive(beta >= LOW, [low]),
        positive(beta <= HIGH, [less], [HIGH]),
    )
    boundary = closed(reached(delay), left, on_the_circle(delay, stiff, damped), *ends)
    width = positive(weight * (alpha + gamma) > 0, [weight, left])
    value, wanted = error(delay), far_in_the_corner().at({d: S(delay)})
    down = combined(value < -LEVEL, [quotient(away, width)])
    far = combined(wanted.body.of[-1], [down], [magnitude(value, True), -S.One])  # type: ignore[attr-defined]
    far = closed(far, positive(value <= 0, [down], [LEVEL]))
    found = exists(conj(boundary, less, far), wanted, {s: s for s in there})
    apart = not_zero(size), not_zero(width), positive(Ne(alpha + gamma, 0), [left])
    return closed(unnamed(closed(found, *apart, slow()), there), not_zero(size))


def _away(delay: int) -> Theorem:
    """0 < -(error + 0.02) times its denominator: the gap is more than y takes away."""
    right, up, area = arc(delay)
    above = up + delta * area - share(delay) * (CHORD * right - gamma * area)
    value = expanded(-above - LEVEL * share(delay) * CHORD * right)
    rate = expanded((value - value.xreplace({CHORD: S.Zero})) / CHORD)
    room = on_box(expanded(TOTAL**2 / TIMES + rate), RANGE)
    return combined(
        Relation(S.Zero, "<", value),
        [Rational(1, TIMES), together(), assume(BY_GAP)],
        [assume(CHORD > 0), room],
    )


@cache
def in_the_corner() -> Theorem:
    """What the claim ``corner`` concludes, under its hypotheses."""
    chord = TIMES * ROOM / TOTAL
    wide = together()
    heavy = on_box(expanded(TOTAL - 100 * TIMES * MOST / delta), RANGES)
    small = on_box(expanded(TINY * TOTAL - TIMES * MOST), RANGES)
    least = combined(chord > 0, [TIMES, gap(strict=True)])
    first = positive(
        delta * TOTAL - 100 * TIMES * ROOM >= 0, [100 * TIMES, narrow()], [delta > 0, heavy]
    )
    second = positive(TINY * TOTAL - TIMES * ROOM >= 0, [TIMES, narrow()], [small])
    ends = (
        least,
        positive(chord >= 0, [least]),
        combined(100 * chord <= delta, [quotient(first, wide)]),
        combined(chord <= TINY, [quotient(second, wide)]),
        combined(BY_GAP.at({CHORD: chord})),
        not_zero(wide),
    )
    found = [closed(inst(wall(n), {CHORD: chord}), *ends, slow(), not_zero(wide)) for n in LATE]
    weak = positive(gamma >= 0, gamma > 0), positive(delta >= 0, delta > 0)
    return closed(of_every_plant(conj(*found)), *weak)
