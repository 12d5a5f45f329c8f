"""With little damping the boundary of the passive walls is the line (8), and nothing else.

A wall that leaves the line some room keeps a margin with less damping of the device.
"""

from symhaptic.book.lemmas.linear_part import known, on_line
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import (
    DELAY,
    first_half,
    limits,
    on_first_half,
    pushes,
    sufficient,
)
from symhaptic.paper.propositions.passivity import BORDER, LITTLE, MINIMAL

THIRD = Rational(1, 3)
ROOM = b + B - K * T * (d + HALF)
"""What the line leaves of the damping."""
LESS = b - ROOM * (d + 3) / (3 * (d + 1))
"""A damping that is enough."""


def border_needs(damping: Expr, passive: Theorem, *known: Theorem) -> Theorem:
    """b <= x for a wall of the boundary that is passive with a damping x >= 0."""
    denied = at(conjunct(assume(BORDER), MINIMAL), {x: damping}, *known, assume(damping < b))
    never = contr(not_intro(passive, denied), b <= damping)
    return disj_cases(ordered(damping, b), never, assume(b <= damping))


def of_border(theorem: Theorem) -> Theorem:
    """What is known of a passive wall, of one on the boundary."""
    return closed(theorem, conjunct(assume(BORDER), PASSIVE))


@cache
def on_the_line() -> Theorem:
    """b + B = KT (d + 1/2) on the boundary, for B <= b d/(2d+3); d is whole."""
    corner, flat, steep = known()
    room, pushing = of_border(show(ROOM >= 0, limits()[1])), of_border(pushes())
    of_corner, share, late, part_of, inverse, end = map(
        DELAY.and_(b >= 0).show,
        (
            (2 * d + 1) * (2 * d + 3) / (d + 1) > 0,
            (2 * d + 3) / (d + 1) > 0,
            d / (d + 1) >= 0,
            (d + 3) / (d + 1) > 0,
            (d + 1) / (d + 3) > 0,
            b * d / (2 * d + 3) >= 0,
        ),
    )
    margin = positive(
        first_half().body.of[1].at({b: LESS}),  # type: ignore[attr-defined]
        [THIRD * HALF, pushing, T > 0, of_corner, corner],
        [THIRD, late, room, steep],
        [THIRD, share, _rest(), flat],
    )
    always = on_first_half(DELAY.closed(margin))
    passive = closed(inst(sufficient(), {b: LESS}), always, pushing)
    low = [THIRD * HALF, part_of, DELAY.show(2 * d + 1 > 0), pushing, T > 0]
    enough = positive(LESS >= 0, [THIRD, part_of, _rest()], [end], low)
    least = DELAY.closed(border_needs(LESS, DELAY.closed(passive), enough))
    line = K * T * (d + HALF)
    return DELAY.closed(both_ways(show(b + B <= line, inverse, least), show(line <= b + B, room)))


def _rest() -> Theorem:
    """0 <= b d/(2d+3) - B."""
    return show(b * d / (2 * d + 3) - B >= 0, LITTLE)


SHARE = (b + B) * (2 * d + 3) / (3 * b * (d + 1))
"""How far along the line a wall lies."""


def nothing_else(printed: Any) -> Theorem:
    """A wall of the boundary with B <= b d/(2d+3) is one of (8)."""
    wanted = Exists((y,), both([y >= 0, y <= 1, *printed]))
    apart = strictly(assume(b >= 0), combined(Ne(S.Zero, b), [assume(Ne(b, 0))]))
    damped = closed(_damped(wanted), apart)
    return DELAY.closed(disj_cases(decided(b, 0), _undamped(wanted), damped))


def lower_boundary(claim: Any) -> Theorem:
    """The walls of the boundary with B <= b d/(2d+3) are those of (8); d is whole."""
    lower, line = claim.of
    known = assume(lower)
    there = closed(nothing_else(line.body.of[2:]), conjunct(known, BORDER), conjunct(known, LITTLE))
    along = [assume(p) for p in line.body.of]
    whole_way = DELAY.and_(b >= 0).show(b * (d + 1) / (2 * d + 3) >= 0)
    left = [3, whole_way, show(1 - y >= 0, y <= 1)]
    little = DELAY.closed(combined(LITTLE, left, [along[3], S.One]))
    back = choose(assume(line), conj(on_line(*along[2:]), little))
    return either_way(there, back, lower, line)


def _damped(wanted: Any) -> Theorem:
    """With damping a wall lies at the share SHARE of the line."""
    here = DELAY.and_(b > 0, of_border(pushes()), _rest(), on_the_line(), Eq(y, SHARE))
    shown = here.show(both(wanted.body.of))
    return here.closed(choose(is_some(y, SHARE), exists(shown, wanted, {y: y})))


def is_some(symbol: Symbol, value: Expr) -> Theorem:
    """There is a number that is this one."""
    named = Exists((symbol,), proposition(Eq(symbol, value)))
    return exists(identity(value, value), named, {symbol: value})


def _undamped(wanted: Any) -> Theorem:
    """Without damping there is the origin only."""
    here = DELAY.and_(of_border(pushes()), on_the_line(), Eq(b, 0))
    weak = here.show(B >= 0, degree=3)
    zero = both_ways(show(B <= 0, LITTLE, Eq(b, 0)), weak)
    share = 1 / ((d + HALF) * T)
    stiff = combined(Eq(K, (b + B) * share), [on_the_line(), -share])
    shown = show(both(wanted.body.of), Eq(y, 0), stiff, zero, Eq(b, 0))
    return choose(is_some(y, S.Zero), exists(shown, wanted, {y: y}))
