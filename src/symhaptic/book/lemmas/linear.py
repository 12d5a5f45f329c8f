"""The loop with a lag: Hurwitz' conditions, and what is left of them without damping."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.notation import b, t_e
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.linear import LAGGING
from symhaptic.proof.theorems.roots import hurwitz

ROOM = b + B - K * t_e
"""What (24) keeps of Hurwitz' determinant, per mass."""
LINEAR = (b + B) / lag.DELAY
DROPPED = b * t_e * (b + B + k * t_e)
"""What it drops."""
HELD = both([K + k > 0, m * ROOM + DROPPED > 0])
KEPT = both([K + k > 0, ROOM > 0])


@cache
def stable_with_lag() -> Theorem:
    """stable <=> 0 < K + k and 0 < m (b + B - K t_e) + b t_e (b + B + k t_e); m, t_e > 0 <= b."""
    heavy, late, loss = assume(m > 0), assume(t_e > 0), assume(b >= 0)
    criterion = hurwitz(LAGGING.of[0], s)
    lead = positive(m * t_e > 0, [heavy, late])
    first = positive(m + b * t_e > 0, [heavy], [loss, late])
    minors = criterion.conclusion.of[1]  # type: ignore[attr-defined]
    known = [conjunct(assume(minors), minor) for minor in minors.of]
    pushes, large = HELD.of  # type: ignore[attr-defined]
    there = conj(over(pushes, known[2], known[1]), combined(large, [known[1]]))
    spring, room = (conjunct(assume(HELD), p) for p in (pushes, large))
    back = conj(
        combined(minors.of[0], [first]),
        combined(minors.of[1], [room]),
        combined(minors.of[2], [spring, room]),
    )
    apart = not_zero(known[1])
    found = chained(criterion, either_way(closed(there, apart), back, minors, HELD))
    return closed(found, lead)


@cache
def undamped() -> Theorem:
    """stable <=> 0 < K + k and 0 < b + B - K t_e, for b = 0."""
    none = assume(Eq(b, 0))
    pushes, large = HELD.of  # type: ignore[attr-defined]
    _, room = KEPT.of  # type: ignore[attr-defined]
    share = t_e * (b + B + k * t_e)
    scaled = combined(m * ROOM > 0, [conjunct(assume(HELD), large)], [none, share])
    there = conj(conjunct(assume(HELD), pushes), over(room, scaled, m > 0))
    kept = conjunct(assume(KEPT), room)
    back = conj(
        conjunct(assume(KEPT), pushes), combined(large, [assume(m > 0), kept], [none, -share])
    )
    apart = positive(Relation(m, "!=", S.Zero), m > 0)
    found = either_way(closed(there, apart), closed(back, apart), HELD, KEPT)
    weak = combined(b >= 0, [none, -S.One])
    return closed(chained(stable_with_lag(), found), weak)


def effective(theorem: Theorem, other: Terms | None = None) -> Theorem:
    """A theorem of the lag, with t_e = t_d + T/2 > 0."""
    found = inst(theorem, {t_e: lag.DELAY, **(other or {})})
    return closed(found, positive_delay())


@cache
def positive_delay() -> Theorem:
    """0 < t_d + T/2."""
    return positive(lag.DELAY > 0, t_d >= 0, [S.Half, T > 0])


@cache
def without_damping() -> Theorem:
    """KEPT, with t_e = t_d + T/2, <=> stable; for b = 0."""
    found = effective(undamped())
    stable, kept = found.conclusion.of  # type: ignore[attr-defined]
    there, back = mp(found, assume(kept)), mp(found, assume(stable))
    return either_way(there, back, kept, stable)


def of_the_walls(walls: Proposition) -> Theorem:
    """(24) and -k < K <=> stable, for b = 0."""
    kept = without_damping().conclusion.of[0]  # type: ignore[attr-defined]
    pulled, linear = walls.of  # type: ignore[attr-defined]
    pushes, room = kept.of
    late = positive_delay()
    known = [conjunct(assume(walls), p) for p in walls.of]  # type: ignore[attr-defined]
    there = conj(combined(pushes, [known[0]]), combined(room, [late, known[1]]))
    back = conj(
        combined(pulled, [conjunct(assume(kept), pushes)]),
        over(linear, conjunct(assume(kept), room), late),
    )
    apart = positive(Relation(lag.DELAY, "!=", S.Zero), [late])
    same = either_way(closed(there, apart), closed(back, apart), walls, kept)
    return chained(same, without_damping())


def of_the_walls_in_units(walls: Proposition, table: Sequence[Expr]) -> Theorem:
    """(25) and -gamma < alpha <=> stable, for b = 0 and ``table``: d, alpha, beta, gamma, delta."""
    kept = without_damping().conclusion.of[0]  # type: ignore[attr-defined]
    pulled, linear = walls.of  # type: ignore[attr-defined]
    pushes, room = kept.of
    late, stiff, damped, sprung, lossy = map(assume, table)
    mass, period = assume(m > 0), assume(T > 0)
    spring = over(m / T**2 > 0, mass, positive(T**2 > 0, [period, period]))
    damper = over(m / T > 0, mass, period)
    low, high = (conjunct(assume(walls), p) for p in walls.of)  # type: ignore[attr-defined]
    there = conj(
        combined(pushes, [spring, low], [stiff, m / T**2], [sprung, m / T**2]),
        combined(
            room,
            [damper, high],
            [damped, m / T],
            [lossy, m / T],
            [stiff, -m / T * (S.Half + d)],
            [late, -K * T],
        ),
    )
    square = over(T**2 / m > 0, positive(T**2 > 0, [period, period]), mass)
    length = over(T / m > 0, period, mass)
    pushing, wide = (conjunct(assume(kept), p) for p in kept.of)
    back = conj(
        combined(pulled, [square, pushing], [stiff, -S.One], [sprung, -S.One]),
        combined(
            linear,
            [length, wide],
            [damped, -S.One],
            [lossy, -S.One],
            [stiff, S.Half + d],
            [late, K * T**2 / m],
        ),
    )
    apart = [positive(Relation(e, "!=", S.Zero), e > 0) for e in (m, T)]
    same = either_way(closed(there, *apart), closed(back, *apart), walls, kept)
    return chained(same, without_damping())


def undamped_in_units() -> Theorem:
    """b = 0, from delta = b T/m = 0."""
    none = assume(Eq(delta, 0))
    apart = [positive(Relation(e, "!=", S.Zero), e > 0) for e in (m, T)]
    table = assume(*normalised(delta))
    return closed(combined(Eq(b, 0), [none, m / T], [table, -m / T]), *apart)


@cache
def spring_is_free() -> Theorem:
    """With the spring k a wall is stable where it is with the spring x; for b = 0."""
    one = without_damping()
    kept, _ = one.conclusion.of  # type: ignore[attr-defined]
    other = inst(one, {k: x})
    pushes, room = kept.of
    here = conj(positive(pushes, -k < K), conjunct(assume(other.conclusion.of[0]), room))  # type: ignore[attr-defined]
    there = conj(positive(pushes.at({k: x}), -x < K), conjunct(assume(kept), room))
    same = either_way(there, here, kept, other.conclusion.of[0])  # type: ignore[attr-defined]
    return chained(chained(turned(one), same), other)


def turned(equivalence: Theorem) -> Theorem:
    """q <=> p from p <=> q."""
    p, q = equivalence.conclusion.of  # type: ignore[attr-defined]
    back, there = mp(equivalence, assume(q)), mp(equivalence, assume(p))
    return either_way(back, there, q, p)


def more_with_a_spring(same: Proposition, point: Terms) -> Theorem:
    """At a point a wall is stable with the one spring and not with the other."""
    one, other = same.at(point).of  # type: ignore[attr-defined]
    held = mp(assume(same.at(point)), stable_at(one))
    return not_intro(held, unstable_at(other), same.at(point))


@cache
def safe() -> Theorem:
    """Walls with -k < K and (24) are stable."""
    late, loss, mass = positive_delay(), assume(b >= 0), assume(m > 0)
    found = effective(stable_with_lag())
    held = found.conclusion.of[1]  # type: ignore[attr-defined]
    pushes, large = held.of
    pull = positive(pushes, [-k < K])
    room = positive(ROOM.xreplace({t_e: lag.DELAY}) > 0, [late, assume(K < LINEAR)])
    all_of_it = combined(large, [mass, room], [loss, late, room], [loss, late, pull, late])
    apart = positive(Relation(lag.DELAY, "!=", S.Zero), [late])
    return closed(mp(found, conj(pull, all_of_it)), apart)


def forbidden(claim: Proposition, point: Terms) -> Theorem:
    """At a point walls are stable that the linear condition forbids."""
    there = claim.at(point)
    walls, stable = there.of  # type: ignore[attr-defined]
    held = mp(assume(there), stable_at(stable))
    return not_intro(conjunct(held, walls.of[1]), number(negated(walls.of[1])), there)


def stable_at(stable: Predicate) -> Theorem:
    """A loop with the lag in numbers is stable, by Hurwitz' determinants."""
    criterion = hurwitz(stable.of[0], s)
    minors = [number(minor) for minor in criterion.conclusion.of[1].of]  # type: ignore[attr-defined]
    found = mp(criterion, conj(*minors))
    return closed(found, *map(fact, found.hypotheses))


def unstable_at(stable: Predicate) -> Theorem:
    """A loop with the lag in numbers is not stable, for one of the determinants is negative."""
    criterion = hurwitz(stable.of[0], s)
    held = mp(criterion, assume(stable))
    failing = [m for m in criterion.conclusion.of[1].of if not m.right > 0]  # type: ignore[attr-defined]
    found = not_intro(conjunct(held, failing[0]), number(negated(failing[0])), stable)
    return closed(found, *map(fact, found.hypotheses))
