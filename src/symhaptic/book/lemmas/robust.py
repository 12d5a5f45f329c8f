"""How stiff a wall can be that is stable with every spring up to the Nyquist frequency.

From below by a wall that meets Jury's inequalities with each of these springs, or by the passive
wall of maximum stiffness. From above by one spring that excludes all stiffer walls; without delay
by two, none and that of the Nyquist frequency.
"""

from itertools import pairwise

from scipy.optimize import minimize_scalar

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.nyquist_triangle import needed
from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.passive_tip import at_unit, is_passive, passive_tip
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import least
from symhaptic.book.lemmas.stiffest_stable import inequalities
from symhaptic.book.lemmas.stiffness_claims import Wall, beside, from_bound
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.paper.propositions import robust as claims
from symhaptic.paper.propositions.plots import NYQUIST
from symhaptic.paper.propositions.ratio import BEST, outdoes, passive
from symhaptic.paper.propositions.robust import robust

STIFFEST = Rational(98702, 10**4)
"""A little more than the spring of the Nyquist frequency for delta = 0.02."""

WALLS: dict[int, Wall] = {
    0: (Rational("0.04441"), Rational("0.00225")),
    1: (Rational("0.017447"), Rational("0.0076")),
}
"""Robustly stable walls for delta = 0.02, nearly the stiffest."""


@cache
def stable_beside_all(delay: int) -> Theorem:
    """A wall of WALLS is robustly stable, by Jury's inequalities for each spring."""
    loop: Any = by_zeros(*WALLS[delay], gamma, delta, S(delay))
    zeros = loop.conclusion.of[1].of[0]
    criterion = closed(chained(loop, jury(zeros, z)), fact(whole(S(delay))))
    goals = conjuncts(criterion.conclusion.of[1])  # type: ignore[attr-defined]
    turn = Rational(1, 100)
    soft = _by_springs(goals, criterion, (S.Zero, turn))
    stiff = _by_springs(goals, criterion, (turn, STIFFEST))
    found = disj_cases(ordered(gamma, turn), Given(gamma < turn).closed(soft), stiff)
    return numbers_known(inst(of_every_plant(found), {delta: DAMPED}))


def _by_springs(goals: Any, criterion: Theorem, springs: tuple[Expr, Expr]) -> Theorem:
    """Jury's inequalities for the springs of an interval."""
    ranges = {gamma: springs, delta: (DAMPED, DAMPED)}
    shown = [combined(goal, [at_point(goal.right, ranges)]) for goal in goals]
    return mp(criterion, conj(*shown))


@cache
def is_robust(delay: int) -> Theorem:
    """The same as a statement on all springs."""
    claim: Any = robust(delay, WALLS[delay]).at({delta: DAMPED})
    given = conjuncts(claim.body.of[0])
    room = number(Relation(NYQUIST.subs(delta, DAMPED), "<=", STIFFEST))
    ends = positive(gamma <= STIFFEST, [assume(given[1])], [room])
    return for_all([gamma], given, add_assum(closed(stable_beside_all(delay), ends), *given))


@cache
def tip_is_robust() -> tuple[Theorem, Wall]:
    """The passive wall of maximum stiffness is robustly stable; 0 < delta, d whole. And it."""
    stable, tip = passive_tip()
    claim: Any = robust(d, tip)
    given = conjuncts(claim.body.of[0])
    return for_all([gamma], given, add_assum(stable, *given)), tip


# -- from above --------------------------------------------------------------------------------


@cache
def softest(delay: int, damper: Rational) -> Rational:
    """The spring with which the largest stable stiffness is smallest, about."""
    middle = (float(pi) / 2 / (delay + 1)) ** 2

    def most(spring: float) -> float:
        return float(max_stable_stiffness(spring, float(damper), delay).alpha)

    found = minimize_scalar(most, bounds=(0.85 * middle, 1.05 * middle), method="bounded")
    return Rational(round(float(found.x) * 10**5), 10**5)


@cache
def none_stiffer(delay: int, damper: Rational) -> tuple[Expr, Theorem]:
    """alpha < a number for every robustly stable wall; and the number."""
    held = assume(robust(delay).at({delta: damper}))
    if delay == 0:
        return _undelayed(damper, held)
    spring = softest(delay, damper)
    limit, softer = none_above((spring, damper), delay)
    ends = [fact(p.at({gamma: spring})) for p in conjuncts(held.conclusion.body.of[0])]  # type: ignore[attr-defined]
    return limit, closed(softer, at(held, {gamma: spring}, *ends))


def _undelayed(damper: Rational, held: Theorem) -> tuple[Expr, Theorem]:
    """Without a spring and with that of the Nyquist frequency, no stiffer wall is stable."""
    here: dict[Any, Expr] = {gamma: S.Zero, delta: damper}
    limit = Rational(11179, 10**4) * 2 * damper
    springs = S.Zero, NYQUIST.subs(delta, damper)
    stable = []
    for spring in springs:
        ends = [fact(p.at({gamma: spring})) for p in conjuncts(held.conclusion.body.of[0])]  # type: ignore[attr-defined]
        stable.append(at(held, {gamma: spring}, *ends))
    triangle = numbers_known(inst(needed(), {delta: damper}))
    triangle = closed(triangle, stable[1])
    side: Any = conjunct(triangle, conjuncts(triangle.conclusion)[2])
    edge = Rational(int(float(side.conclusion.right) * 10**7) + 1, 10**7)
    more = number(Relation(S.Zero, "<", edge - side.conclusion.right))
    right = positive(alpha + 2 * beta < edge, [side], [more])
    # the wall is (limit + u, (edge - limit - u)/2 - v)
    u, v = symbols("u v")
    wall = {alpha: limit + u, beta: (edge - limit - u) / 2 - v}
    _, second, _, minor = inequalities(0)
    value: Expr = minor.conclusion.right  # type: ignore[attr-defined]
    plant = {s: (value_, value_) for s, value_ in here.items()}
    reach = {u: (S.Zero, 8 * damper), v: (S.Zero, 4 * damper)}
    none = inst(
        at_point(-value.xreplace(wall), {**plant, **reach}),
        {u: alpha - limit, v: (edge - alpha) / 2 - beta},
    )
    # the damping is not far below zero: a half plane of Jury's, and the triangle
    low = -2 * damper
    plane: Expr = second.conclusion.right  # type: ignore[attr-defined]
    room = expand(4 * n_0 * (beta - low) - plane - (n_1 - n_0) * (edge - alpha - 2 * beta))
    products = [second], [at_point(n_1 - n_0, plant), right], [at_point(room, plant)]
    weight = positive(4 * n_0 > 0, [4, at_point(n_0, plant)])
    slow = by_multiple(beta - low > 0, weight, *products)
    less = Given(alpha >= limit).closed(positive(value <= 0, [none]), right, slow)
    found = by_contradiction(alpha < limit, minor, less)
    found = numbers_known(inst(of_every_plant(found), here))
    return limit, closed(found, stable[0], stable[1], held)


# -- the claims ------------------------------------------------------------------------------------


Loop = tuple[int, Rational]
"""An integer delay and a damper."""


def outdone(kind: Proposition, held: Theorem, here: Loop, other: Loop, share: Expr) -> Theorem:
    """The wall (11) of one loop, that many times, is stiffer than all robust ones of another.

    ``held`` says that this wall is of a ``kind``.
    """
    limit, softer = none_stiffer(*other)
    _, tip = passive_tip()
    others = robust(other[0]).at({delta: other[1]})
    claim = outdoes(kind, others, alpha < share * x)
    room = assume(Relation(limit, "<", share * tip[0]))
    found = beside(claim, held, tip, lambda wanted: combined(wanted, [softer], [room]))
    found = inst(at_unit().closed(found), dict(zip((d, delta), (S(here[0]), here[1]), strict=True)))
    numbers = [p for p in found.hypotheses if isinstance(p, (Relation, Predicate)) and not p.free]
    return closed(found, *map(fact, numbers))


@cache
def shrinks() -> Theorem:
    """The largest robustly stable stiffness falls with each period."""
    best = robust(d, BEST), tip_is_robust()[0]
    later = ((n, DAMPED) for n in range(claims.LONGEST + 1))
    return conj(*(outdone(*best, one, other, S.One) for one, other in pairwise(later)))


@cache
def grows() -> Theorem:
    """It rises with the damper."""
    best, found = (robust(d, BEST), tip_is_robust()[0]), []
    for n in claims.DELAYS:
        for light, heavy in pairwise(claims.DAMPERS):
            found.append(outdone(*best, (n, heavy), (n, light), S.One))
    return conj(*found)


@cache
def conservative() -> Theorem:
    """By how much robustly stable walls can be stiffer than passive ones."""
    best, found = (passive(d, BEST), is_passive()), []
    for n, ends in claims.CONSERVATIVE.items():
        high = Rational(ends[1])
        more = claims.between(n).of[0]  # type: ignore[attr-defined]
        above = beside(more, is_robust(n), WALLS[n], from_bound(least(n)))
        found.append(conj(above, outdone(*best, (n, DAMPED), (n, DAMPED), high)))
    for n, end in claims.AT_MOST.items():
        found.append(outdone(*best, (n, DAMPED), (n, DAMPED), Rational(end)))
    return conj(*found)
