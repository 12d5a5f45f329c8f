"""The largest passive stiffness of a delay over that without delay, for every b > 0 and T > 0."""

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import largest_of


def both_sides(stiffness: Expr, delay: int, printed: Any, known: Any) -> tuple[Theorem, ...]:
    """What is the largest stiffness is at most, and at least, that of (11)."""
    there_is, others = known
    passive, bound, value = largest_of(printed, delay)
    below = choose(assume(there_is), inst(bound, {K: stiffness}))
    wall = passive.conclusion.of  # type: ignore[attr-defined]
    above = at(assume(others), {w: wall[0], B: wall[1]}, passive)
    return positive(stiffness <= value, [below]), positive(value <= stiffness, [above]), value


def ratio(claim: Proposition, printed: Any, delay: int) -> Theorem:
    """The bounds on y/x that a claim names."""
    symbols, given, then = taken_apart(claim)
    first = both_sides(x, 0, printed, given[2:4])
    other = both_sides(y, delay, printed, given[4:])
    period = over(1 / T > 0, one(), T > 0)
    size = positive(x > 0, [first[1]], [2, period, b > 0])
    bounds = []
    for relation in conjuncts(then):
        lower = not relation.left.free_symbols  # type: ignore[attr-defined]
        limit = relation.left if lower else relation.right  # type: ignore[attr-defined]
        way = 1 if lower else -1
        rest = number(Relation(S.Zero, "<", _per_damping(way * (other[2] - limit * first[2]))))
        known = [[other[lower]], [limit, first[not lower]], [rest, period, b > 0]]
        part = positive(way * (y - limit * x) > 0, *known)
        bounds.append(over(relation, part, size))
    apart = not_zero(size), not_zero(assume(T > 0))
    found = closed(conj(*bounds) if len(bounds) > 1 else bounds[0], *apart, *apart)
    found = closed(found, positive(b >= 0, b > 0))
    return for_all(symbols, given, add_assum(found, *given))


def _per_damping(stiffness: Expr) -> Expr:
    """A stiffness in units of b/T."""
    return stiffness.subs({b: 1, T: 1})


def case(claim: Proposition, printed: Any, delay: int) -> Case:
    """The walls of (11) for b = T = 1, at which all that the claim supposes is true."""
    _, given, _ = taken_apart(claim)
    unit: dict[Symbol, Expr] = {b: S.One, T: S.One}
    walls = [largest_of(printed, late) for late in (0, delay)]
    point = unit | {s: wall[2].xreplace(unit) for s, wall in zip((x, y), walls, strict=True)}
    known: list[Theorem] = []
    for (there_is, others), wall in zip((given[2:4], given[4:]), walls, strict=True):
        passive, bound = (inst(t, unit) for t in wall[:2])
        passive, bound = (closed(t, *_numbers(t)) for t in (passive, inst(bound, {K: w})))
        known.append(exists(passive, there_is.at(point), {B: passive.conclusion.of[1]}))  # type: ignore[attr-defined]
        goal, some = others.at(point), others.at(point).body.of[0]  # type: ignore[attr-defined]
        least = positive(goal.body.of[1], [bound])  # type: ignore[attr-defined]
        known.append(for_all([w, B], [some], least))
    return example(point, given, *known)


def _numbers(theorem: Theorem) -> list[Theorem]:
    """The hypotheses without symbols."""
    return [fact(claim) for claim in theorem.hypotheses if not claim.free]
