"""A wall beside all others: that a stable wall outdoes the passive ones, and the other way."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import largest_of
from symhaptic.book.lemmas.stiffest_stable import Ranges, no_stiffer, stable_wall
from symhaptic.paper.propositions.ratio import ARM, WALL

Wall: TypeAlias = tuple[Expr, Expr]
ELEVEN = transcribed("eq11")

UNDELAYED: Wall = (
    Rational("0.68") + Rational("1.604") * delta,
    Rational("0.8282") - Rational("0.195") * delta,
)
"""A wall without delay that is nearly the stiffest stable one where delta = 0.02."""

LATE: Wall = (
    Rational("0.142") + Rational("0.614") * delta,
    Rational("0.4239") - Rational("0.093") * delta,
)
"""The same with one period of delay."""

HERE: Ranges = {s: (v, v) for s, v in ARM.items()}
"""The plant of the figures alone."""
CORNER = {0: (Rational("0.713"), Rational("0.824")), 1: (Rational("0.1544"), Rational("0.422"))}
"""A little stiffer than every stable wall of the figures, and where the minor is largest."""


def beside(
    claim: Proposition, best: Theorem, wall: Wall, bounds: Callable[[Any], Theorem]
) -> Theorem:
    """There is a wall (x, y), this one, such that the bounds hold for all others."""
    values: dict[Any, Expr] = dict(zip((x, y), wall, strict=True))
    _, rest = claim.body.of  # type: ignore[attr-defined]
    given, then = rest.at(values).body.of
    shown = conj(*map(bounds, conjuncts(then))) if then.parts else bounds(then)
    others = for_all(WALL, [given], shown)
    return exists(conj(best, others), claim, values)


def from_bound(softer: Theorem) -> Callable[[Any], Theorem]:
    """What shows c alpha < r, or <=, of all walls with alpha < L, or <=, as c L is less than r."""
    bound = relation(softer)

    def shown(wanted: Any) -> Theorem:
        share = wanted.left.coeff(alpha)
        rest = wanted.right - share * bound.right
        sign = "<=" if wanted.sign == "<=" or bound.sign == "<" else "<"
        room = rest if rest.is_Rational and rest > 0 else number(Relation(S.Zero, sign, rest))
        return combined(wanted, [share, softer], [room])

    return shown


def passive_walls(delay: int, printed: Any) -> tuple[Theorem, Theorem, Wall]:
    """(11): that wall is passive, none is stiffer, and its values; for delta >= 0 and T = 1."""
    unit = {b: delta, T: S.One}
    passive, least, _ = largest_of(printed, delay)
    found = inst(passive, unit)
    wall = found.conclusion.of[:2]  # type: ignore[attr-defined]
    known = [fact(Relation(S.Zero, "<", S.One))]
    bound = inst(least, {**unit, K: alpha, B: beta})
    return closed(found, *known), closed(bound, *known), wall


def stable_beside_passive(
    claim: Proposition, delay: int, wall: Wall, ranges: Ranges, printed: Any
) -> Theorem:
    """A stable wall beside all passive ones, from the largest stiffness (11)."""
    _, least, _ = passive_walls(delay, printed)
    most = least.conclusion.right.subs(delta, 1)  # type: ignore[attr-defined]

    def bound(wanted: Any) -> Theorem:
        # c alpha < g x, where alpha <= most delta and delta <= 0.02
        share = wanted.left.coeff(alpha)
        rest = wanted.right - share * most * delta
        return positive(wanted, [share, least], *linear(rest, ranges[delta]))

    return beside(claim, stable_wall(delay, wall, ranges), wall, bound)


def linear(expr: Expr, ends: tuple[Any, Any]) -> list[list[Any]]:
    """A linear function of delta by its value at one end and its slope."""
    low, high = ends
    steep = diff(expr, delta)
    rises = steep.is_number and bool(steep >= 0)
    end = number(Relation(S.Zero, "<", expr.subs(delta, low if rises else high)))
    slope = number(Relation(S.Zero, "<=", steep if rises else -steep))
    return [[end], [slope, delta >= low if rises else delta <= high]]


def passive_beside_stable(claim: Proposition, delay: int, printed: Any) -> Theorem:
    """A passive wall beside all stable ones, at the arm of the figures."""
    passive, _, wall = passive_walls(delay, printed)
    passive = inst(passive, {delta: ARM[delta]})
    wall = tuple(v.subs(delta, ARM[delta]) for v in wall)
    above = numbers_known(inst(no_stiffer(delay, CORNER[delay], HERE), ARM))
    return beside(claim, numbers_known(passive), wall, from_bound(above))


def of_ratio(claim: Proposition, delay: int, wall: Wall) -> Theorem:
    """How much stiffer a stable wall can be than a passive one, at least and at most."""
    then = taken_apart(claim)[2]
    more, digits = conjuncts(then)
    found = conj(
        stable_beside_passive(more, delay, wall, RANGES, ELEVEN),
        passive_beside_stable(digits, delay, ELEVEN),
    )
    return as_claimed(claim, found)


@cache
def one_period() -> Theorem:
    """What is claimed of one period of delay."""
    return of_delay(CLAIMED["s6-stable-22"](()))


def of_delay(claim: Proposition) -> Theorem:
    """How much of the stable stiffness one period of delay leaves, at most and at least."""
    then = taken_apart(claim)[2]
    below, digits = conjuncts(then)
    first = no_stiffer(1, (Rational("0.22") * UNDELAYED[0], Rational("0.424")), RANGES)
    stable = stable_wall(0, UNDELAYED, RANGES)
    less = beside(below, stable, UNDELAYED, lambda wanted: combined(wanted, [first]))
    best: Wall = tuple(v.subs(delta, ARM[delta]) for v in LATE)
    late = inst(stable_wall(1, LATE, RANGES), ARM)
    most = inst(no_stiffer(0, CORNER[0], HERE), ARM)
    late, most = map(numbers_known, (late, most))
    return as_claimed(claim, conj(less, beside(digits, late, best, from_bound(most))))
