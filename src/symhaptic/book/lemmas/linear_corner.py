"""Next to the start of the boundary the error of the linear condition exceeds 2 per cent.

The wall is that whose chord y is 25 times the gap: so near to the start the gap decides.
"""

from symhaptic.book.lemmas.arm_numbers import TOTAL, gap, together
from symhaptic.book.lemmas.line_crossing import ROOM, slow
from symhaptic.book.lemmas.linear_far import OnArc, arc, quotient
from symhaptic.book.lemmas.linear_gap import MOST, narrow
from symhaptic.book.lemmas.linear_rays import share
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.model.linear import CHORD
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import LEVEL, far_in_the_corner

TIMES, TINY = 25, Rational(1, 10**6)
RANGE = {**RANGES, CHORD: (0, TINY)}
BY_GAP = Relation(TOTAL * CHORD, "<=", TIMES * ROOM)
"""The chord is no larger than 25 times the gap."""


@cache
def wall(delay: int) -> Theorem:
    """The claim for a chord that is small enough, of one delay."""
    chord, weight = assume(CHORD > 0), share(delay)
    arc_ = OnArc(delay, CHORD, chord, RANGE)
    slim = 10 * arc_.area - arc_.right
    slim_ = positive(CHORD * slim > 0, [chord, on_box(slim, RANGE)])
    quick = quotient(slim_, arc_.size), assume(gamma >= 0)
    near = combined(alpha < 10 * CHORD, *([t] for t in quick), [arc_.stiff, S.One])
    away = arc_.away(_away(delay))
    less = positive(
        beta < 0,
        [away],
        [LEVEL * weight, arc_.left],
        [delta >= 100 * CHORD],
        [100 - 10 * weight, chord],
        [weight, near],
    )
    return arc_.is_far(far_in_the_corner().at({d: S(delay)}), away, less)


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
