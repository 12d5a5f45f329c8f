"""How little damper and spring of (23) change without delay, and how much behind a long one.

Fifty periods late, d = 49, the spring (pi/100)^2, which (23) allows, excludes each wall that does
not pull if there is no damper.
"""

from symhaptic.book.lemmas.near_tip import FINE, none_above, wall_below
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import no_stiffer, stable_wall
from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, beside, from_bound, linear
from symhaptic.book.lemmas.undamped_robust import excluded
from symhaptic.paper.propositions import conclusion
from symhaptic.paper.propositions.conclusion import CHANGES, FACTOR
from symhaptic.paper.propositions.ratio import WALL

LIMIT = Rational("0.6899") + Rational("1.2") * delta
"""A little stiffer than every stable wall without delay, for all springs of (23)."""
NEAR = UNDELAYED[1]
SMALL = Rational(105, 100)
AT_ONCE = Eq(d, 0)
LONG = {gamma: (pi / 100) ** 2, d: S(49)}


def behind(delay: int, claim: Proposition, theorem: Theorem) -> Theorem:
    """What holds for one delay, with d in its place, under d = that."""
    place = d
    equal = combined(Relation(S(delay), "=", d), [assume(Eq(d, delay)), -1])
    return subst(claim, place, theorem, equal)


def by_a_factor(claim: Any, best: dict[Any, Expr], others: dict[Any, Expr]) -> Theorem:
    """Without delay some wall of one device is outdone by less than 5 per cent by the other's."""
    undelayed = claim.at({d: S.Zero})
    some = undelayed.body.at({FACTOR: SMALL}).of[1]
    wall = tuple(v.subs(best) for v in UNDELAYED)
    stable = _there(stable_wall(0, UNDELAYED, RANGES), best)
    limit = _there(no_stiffer(0, (LIMIT, NEAR), RANGES), others)
    rest = SMALL * wall[0] - LIMIT.subs(others)

    def bound(wanted: Any) -> Theorem:
        return positive(wanted, [limit], *linear(rest, RANGES[delta]))

    more = number(Relation(S.Zero, "<", SMALL))
    found = conj(more, beside(some, stable, wall, bound))
    return behind(0, claim, exists(found, undelayed, {FACTOR: SMALL}))


def _there(theorem: Theorem, values: dict[Any, Expr]) -> Theorem:
    """For one spring or one damper of the range."""
    return numbers_known(inst(theorem, values))


def none_pushes(claim: Exists, wall: tuple[Expr, Expr], stable: Theorem) -> Theorem:
    """No stable wall of the undamped device is within a factor of ``wall``, which is stable."""
    factor, some = (assume(p) for p in conjuncts(claim.body))
    inner: Any = some.conclusion
    best, others = (assume(p) for p in conjuncts(inner.body))
    below = at(others, dict(zip(WALL, wall, strict=True)), stable)
    push = over(x > 0, positive(FACTOR * x > 0, [below], [wall[0]]), factor)
    least = closed(positive(x >= 0, [push]), positive(Ne(FACTOR, 0), [factor]))
    false = inst(excluded(), {alpha: x, beta: y, d: S(49)})
    false = closed(false, least, best, *(fact(p) for p in false.hypotheses if not p.free))
    return reductio(choose(assume(claim), choose(some, false)), claim)


@cache
def changed(parameter: Symbol, other: Expr, delay: int) -> Theorem:
    """The change of the stiffness between two decimals: walls next to both tips, and bounds."""
    claim: Any = conclusion.changed(parameter, other, delay)
    rest, end = (delta, STIFF) if parameter == gamma else (gamma, DAMPED)
    strong, weak = (S.Zero, end) if parameter == gamma else (end, S.Zero)
    arms = [tuple({parameter: v, rest: other}[s] for s in (gamma, delta)) for v in (strong, weak)]
    found = []
    for some, best, others in zip(claim.of, arms, arms[::-1], strict=True):
        wall, held = wall_below(best, delay, FINE)
        _, softer = none_above(others, delay, FINE)
        found.append(beside(some, held, wall, from_bound(softer)))
    return conj(*found)


@cache
def changes(parameter: Symbol) -> Theorem:
    """All changes with one parameter."""
    rows = CHANGES[parameter]
    return conj(*(changed(parameter, v, n) for v, row in rows.items() for n in range(len(row))))
