"""With little damping the boundary of the passive walls is the line (8), and nothing else.

A wall that leaves the line some room keeps a margin with less damping of the device.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, not_zero
from symhaptic.book.lemmas.linear_part import divisors, known, on_line, shares
from symhaptic.book.lemmas.passivity import PASSIVE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import first_half, limits, on_first_half, pushes, sufficient
from symhaptic.notation import b
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
    more, low, high = shares()
    room = of_border(positive(ROOM >= 0, [limits()[1]]))
    rest, pushing = _rest(), of_border(pushes())
    both_shares = positive((2 * d + 1) * (2 * d + 3) > 0, [low, high])
    of_corner = over((2 * d + 1) * (2 * d + 3) / (d + 1) > 0, both_shares, more)
    share = over((2 * d + 3) / (d + 1) > 0, high, more)
    late = over(d / (d + 1) >= 0, assume(d >= 0), more)
    margin = positive(
        first_half().body.of[1].at({b: LESS}),  # type: ignore[attr-defined]
        [THIRD * HALF, pushing, T > 0, of_corner, corner],
        [THIRD, late, room, steep],
        [THIRD, share, rest, flat],
    )
    always = on_first_half(closed(margin, *divisors()))
    passive = closed(inst(sufficient(), {b: LESS}), always, pushing, *divisors())
    three = positive(d + 3 > 0, [d >= 0], [3])
    part_of = over((d + 3) / (d + 1) > 0, three, more)
    enough = positive(
        LESS >= 0,
        [THIRD, part_of, rest],
        [over(b * d / (2 * d + 3) >= 0, positive(b * d >= 0, [b >= 0, d >= 0]), high)],
        [THIRD * HALF, part_of, low, pushing, T > 0],
    )
    least = closed(border_needs(LESS, passive, enough), *divisors())
    inverse = over((d + 1) / (d + 3) > 0, more, three)
    none = positive(b + B <= K * T * (d + HALF), [3, inverse, least])
    line = both_ways(none, positive(K * T * (d + HALF) <= b + B, [room]))
    return closed(line, *divisors(), not_zero(positive(3 * (d + 1) > 0, [3, more])))


def _rest() -> Theorem:
    """0 <= b d/(2d+3) - B."""
    return positive(b * d / (2 * d + 3) - B >= 0, LITTLE)


def _force() -> Theorem:
    """0 <= KT (d + 1/2)."""
    return positive(K * T * (d + HALF) >= 0, [of_border(pushes()), T > 0, shares()[1], HALF])


SHARE = (b + B) * (2 * d + 3) / (3 * b * (d + 1))
"""How far along the line a wall lies."""


def nothing_else(printed: Any) -> Theorem:
    """A wall of the boundary with B <= b d/(2d+3) is one of (8)."""
    wanted = Exists((y,), both([y >= 0, y <= 1, *printed]))
    apart = strictly(assume(b >= 0), combined(Ne(S.Zero, b), [assume(Ne(b, 0))]))
    damped = closed(_damped(wanted), apart)
    return closed(disj_cases(decided(b, 0), _undamped(wanted), damped), *divisors())


def lower_boundary(claim: Any) -> Theorem:
    """The walls of the boundary with B <= b d/(2d+3) are those of (8); d is whole."""
    lower, line = claim.of
    known = assume(lower)
    there = closed(nothing_else(line.body.of[2:]), conjunct(known, BORDER), conjunct(known, LITTLE))
    along = [assume(p) for p in line.body.of]
    more, _, high = shares()
    whole_way = over(
        b * (d + 1) / (2 * d + 3) >= 0, positive(b * (d + 1) >= 0, [b >= 0, more]), high
    )
    left = [3, whole_way, positive(1 - y >= 0, y <= 1)]
    little = closed(combined(LITTLE, left, [along[3], S.One]), *divisors())
    back = choose(assume(line), conj(on_line(*along[2:]), little))
    return either_way(there, back, lower, line)


def _damped(wanted: Any) -> Theorem:
    """With damping a wall lies at the share SHARE of the line."""
    line, (more, _, high), share = on_the_line(), shares(), assume(Eq(y, SHARE))
    _, _, stiffness, damping = wanted.body.of
    whole_way = positive(3 * b * (d + 1) > 0, [3, assume(b > 0), more])
    along = combined((b + B) * (2 * d + 3) >= 0, [high, _force()], [line, -2 * d - 3])
    left = positive(3 * b * (d + 1) - (b + B) * (2 * d + 3) >= 0, [high, _rest()])
    shown = [
        combined(y >= 0, [over(SHARE >= 0, along, whole_way)], [share, -S.One]),
        combined(y <= 1, [over(1 - SHARE >= 0, left, whole_way)], [share, S.One]),
        combined(
            stiffness,
            [line, -1 / ((d + HALF) * T)],
            [share, -6 * b * (d + 1) / (T * (2 * d + 1) * (2 * d + 3))],
        ),
        combined(damping, [share, -3 * b * (d + 1) / (2 * d + 3)]),
    ]
    found = choose(is_some(y, SHARE), exists(conj(*shown), wanted, {y: y}))
    return closed(found, not_zero(whole_way), not_zero(assume(b > 0)))


def is_some(symbol: Symbol, value: Expr) -> Theorem:
    """There is a number that is this one."""
    named = Exists((symbol,), proposition(Eq(symbol, value)))
    return exists(identity(value, value), named, {symbol: value})


def _undamped(wanted: Any) -> Theorem:
    """Without damping there is the origin only."""
    line, none, start = on_the_line(), assume(Eq(b, 0)), assume(Eq(y, 0))
    _, _, stiffness, damping = wanted.body.of
    weak = combined(B >= 0, [_force()], [line, -S.One], [none, S.One])
    zero = both_ways(combined(B <= 0, [_rest()], [none, d / (2 * d + 3)]), weak)
    share = 1 / ((d + HALF) * T)
    end, turn = (e.right.coeff(b * y) for e in (stiffness, damping))
    shown = [
        combined(y >= 0, [start, -S.One]),
        combined(y <= 1, [one()], [start, S.One]),
        combined(stiffness, [line, -share], [zero, share], [none, share], [start, -b * end]),
        combined(damping, [zero, S.One], [none, S.One], [start, -b * turn]),
    ]
    return choose(is_some(y, S.Zero), exists(conj(*shown), wanted, {y: y}))
