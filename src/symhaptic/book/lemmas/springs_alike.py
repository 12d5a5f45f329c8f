"""Without delay two springs of (23) have nearly the same stable walls."""

from symhaptic.book.lemmas.moved_wall import Moved
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed_curve import between
from symhaptic.paper.propositions.plots import (
    BESIDE,
    OTHER,
    THICK,
    alike,
    between_line_and_curve,
    near,
    undelayed,
)


def both_orders(made: Any) -> Theorem:
    """What holds where the other spring is softer and where it is stiffer."""
    stiffer = positive(gamma <= OTHER, gamma < OTHER)
    return disj_cases(ordered(gamma, OTHER), closed(made(False), stiffer), made(True))


@cache
def moves(softer: bool) -> tuple[Moved, Theorem]:
    """A moved wall, and that it is stable."""
    moved = Moved(softer)
    return moved, moved.stable()


def steps(moved: Moved) -> tuple[Theorem, ...]:
    """The way of a moved wall is at most THICK (1 - eta), in each direction."""
    ways, room = (moved.stiffness - alpha, moved.damping - beta), THICK * (1 - moved.share)
    here = moved.around.and_(moved.low, moved.high)
    return tuple(here.show(room + sign * way >= 0) for way in ways for sign in (1, -1))


def kept(softer: bool) -> Theorem:
    """Near a stable wall one is stable with the other spring."""
    moved, stable = moves(softer)
    wall = dict(zip(BESIDE, (moved.stiffness, moved.damping), strict=True))
    claim = Exists(BESIDE, both([*near(), undelayed(BESIDE, OTHER)]))
    ways = [
        combined(p.at(wall), [step], [THICK, moved.low])
        for p, step in zip(map(proposition, near()), steps(moved), strict=True)
    ]
    return exists(conj(*ways, stable), claim, wall)


def filled(softer: bool) -> Theorem:
    """Where all near walls are stable with the other spring, a wall is stable.

    It is what one of them is moved to, from the other spring to this one.
    """
    moved, stable = moves(not softer)
    swap = {gamma: OTHER, OTHER: gamma}
    share = moved.share.xreplace(swap)
    wall = {alpha: (alpha + gamma) / (1 - share) - OTHER, beta: (beta - share) / (1 - share)}
    other = undelayed(BESIDE, OTHER)
    around = ForAll(BESIDE, implied(near(), other))
    zero = [number(Relation(-THICK, "<=", S.Zero)), number(Relation(S.Zero, "<=", THICK))]
    itself = at(assume(around), dict(zip(BESIDE, (alpha, beta), strict=True)), *zero, *zero)
    back = [inst(t, swap) for t in steps(moved)]
    eased = inst(moved.eased(), swap)
    beside = dict(zip(BESIDE, (wall[alpha], wall[beta]), strict=True))
    left, right, down, up = back
    ways = [
        over(p.at(beside), step, eased)
        for p, step in zip(map(proposition, near()), (right, left, up, down), strict=True)
    ]
    there = at(assume(around), beside, *ways)
    found = inst(inst(stable, swap), wall)
    for s in (alpha, beta):
        found = _renamed(found, s)
    apart = combined(Relation(1 - share, "!=", S.Zero), [eased])
    found = closed(found, closed(there, apart), apart)
    return closed(found, itself)


def _renamed(theorem: Theorem, to: Symbol) -> Theorem:
    """A stable wall whose stiffness or damping is another expression for this one."""
    said: Any = theorem.conclusion
    index = (alpha, beta).index(to)
    place = Symbol("q")
    terms = [place if i == index else t for i, t in enumerate(said.of)]
    pattern = Predicate(said.name, (), tuple(terms))
    return subst(pattern, place, theorem, identity(said.of[index], to))


@cache
def springs_alike() -> Theorem:
    """Two springs of (23) have the same stable walls, within THICK of each coordinate."""
    walls = taken_apart(alike())[2]
    parts = []
    for claim, made in zip(walls.body.of, (kept, filled), strict=True):  # type: ignore[attr-defined]
        parts.append(disch(both_orders(made), claim.of[0]))
    inner = gen(conj(*parts), alpha, beta)
    return as_claimed(alike(), inner)


@cache
def line_and_curve() -> Theorem:
    """The stable walls lie above beta = -1, between alpha = -gamma and the curve."""
    return as_claimed(between_line_and_curve(), between())
