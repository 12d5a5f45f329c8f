"""The loop with a lag: Hurwitz' conditions, and what is left of them without damping."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.notation import t_e
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
SLOW = Given(t_d >= 0, T > 0)
SLOW.have(lag.DELAY > 0)


@cache
def stable_with_lag() -> Theorem:
    """stable <=> 0 < K + k and 0 < m (b + B - K t_e) + b t_e (b + B + k t_e); m, t_e > 0 <= b."""
    here = Given(m > 0, t_e > 0, b >= 0)
    criterion = hurwitz(LAGGING.of[0], s)
    minors = criterion.conclusion.of[1]  # type: ignore[attr-defined]
    known = [conjunct(assume(minors), minor) for minor in minors.of]
    pushes, large = HELD.of  # type: ignore[attr-defined]
    there = conj(over(pushes, known[2], known[1]), show(large, known[1]))
    held = [conjunct(assume(HELD), p) for p in (pushes, large)]
    back = here.show(minors, *held)
    there = closed(there, show(Ne(known[1].conclusion.right, 0), known[1]))  # type: ignore[attr-defined]
    return here.closed(chained(criterion, either_way(there, back, minors, HELD)))


@cache
def undamped() -> Theorem:
    """stable <=> 0 < K + k and 0 < b + B - K t_e, for b = 0."""
    here = Given(m > 0, Eq(b, 0))
    pushes, large = HELD.of  # type: ignore[attr-defined]
    _, room = KEPT.of  # type: ignore[attr-defined]
    held, kept = (conjunct(assume(all_), p) for all_, p in ((HELD, large), (KEPT, room)))
    scaled = here.show(m * ROOM > 0, held)
    there = conj(conjunct(assume(HELD), pushes), over(room, scaled, m > 0))
    back = conj(conjunct(assume(KEPT), pushes), here.show(large, kept))
    found = either_way(here.closed(there), back, HELD, KEPT)
    return here.closed(chained(stable_with_lag(), found))


def effective(theorem: Theorem, other: Terms | None = None) -> Theorem:
    """A theorem of the lag, with t_e = t_d + T/2 > 0."""
    return SLOW.closed(inst(theorem, {t_e: lag.DELAY, **(other or {})}))


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
    known = [conjunct(assume(walls), p) for p in walls.of]  # type: ignore[attr-defined]
    back = [conjunct(assume(kept), p) for p in kept.of]
    same = either_way(SLOW.show(kept, *known), SLOW.show(walls, *back), walls, kept)
    return chained(same, without_damping())


def of_the_walls_in_units(walls: Proposition, table: Sequence[Expr]) -> Theorem:
    """(25) and -gamma < alpha <=> stable, for b = 0 and ``table``: d, alpha, beta, gamma, delta."""
    kept: Any = without_damping().conclusion.of[0]  # type: ignore[attr-defined]
    here = Given(m > 0, T > 0, *table)
    for scale in m / T**2 > 0, m / T > 0, T**2 / m > 0, T / m > 0:
        here.have(scale)
    there = here.show(kept, *(conjunct(assume(walls), p) for p in walls.of))  # type: ignore[attr-defined]
    back = here.show(walls, *(conjunct(assume(kept), p) for p in kept.of))
    return chained(either_way(there, back, walls, kept), without_damping())


def undamped_in_units() -> Theorem:
    """b = 0, from delta = b T/m = 0."""
    table, none = assume(*normalised(delta)), assume(Eq(delta, 0))
    return Given(m > 0, T > 0).closed(combined(Eq(b, 0), [none, m / T], [table, -m / T]))


@cache
def spring_is_free() -> Theorem:
    """With the spring k a wall is stable where it is with the spring x; for b = 0."""
    one = without_damping()
    kept, _ = one.conclusion.of  # type: ignore[attr-defined]
    other = inst(one, {k: x})
    pushes, room = kept.of
    here = conj(show(pushes, -k < K), conjunct(assume(other.conclusion.of[0]), room))  # type: ignore[attr-defined]
    there = conj(show(pushes.at({k: x}), -x < K), conjunct(assume(kept), room))
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
    here = SLOW.and_(b >= 0, m > 0, -k < K, K < LINEAR)
    found = effective(stable_with_lag())
    here.have(ROOM.xreplace({t_e: lag.DELAY}) > 0)
    here.have(K + k > 0)
    return mp(found, here.show(found.conclusion.of[1], degree=3))  # type: ignore[attr-defined]


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
    return Given().closed(mp(criterion, conj(*minors)))


def unstable_at(stable: Predicate) -> Theorem:
    """A loop with the lag in numbers is not stable, for one of the determinants is negative."""
    criterion = hurwitz(stable.of[0], s)
    held = mp(criterion, assume(stable))
    failing = [m for m in criterion.conclusion.of[1].of if not m.right > 0]  # type: ignore[attr-defined]
    found = not_intro(conjunct(held, failing[0]), number(negated(failing[0])), stable)
    return Given().closed(found)
