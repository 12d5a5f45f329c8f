"""Without delay a wall that is stable with an arm of (23) is stable with a more damped one.

The largest of Jury's minors is positive on one side of the curve that bounds the stable walls, and
it rises with the damper.
"""

from symhaptic.book.lemmas.marginal import LIMIT, NEAR
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.book.lemmas.stiffest_stable import damping_between, inequalities, no_stiffer, on_box
from symhaptic.book.lemmas.undelayed_curve import (
    above_minus_one,
    above_one,
    away,
    between,
    needed,
    plants,
)
from symhaptic.paper.propositions.plots import CURVE
from symhaptic.paper.propositions.stability import (
    HEAVIER,
    START,
    WAY,
    damping_can_destabilise,
    reached,
)
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, SLOPES, named
from symhaptic.proof.plants import NUMBERS as SAMPLED
from symhaptic.proof.theorems.leaves import more_damped

OTHERS = sp.symbols("n_1'' n_0'' a'' e''")
BARE = STABLE.at({d: S.Zero})
AT_ONCE = reached().at({d: S.Zero})
HEAVY = Given(delta >= 0, delta < HEAVIER, HEAVIER <= DAMPED)
SIDES = {**RANGES, alpha: (-STIFF, 1), beta: (-1, Rational(21, 10))}


@cache
def minor_rises() -> Theorem:
    """The minor of a wall rises with the damper, on a box of arms and walls."""
    minor: Any = inequalities(0)[-1].conclusion.right  # type: ignore[attr-defined]
    by_balls = minor.subs(BALLS)
    slope = derivative(by_balls, delta) + sum(
        derivative(by_balls, x) * dx for x, dx in zip(SAMPLED, SLOPES, strict=True)
    )
    names = {s: s for s in (*SAMPLED, *SLOPES)}
    certificate = box.positive(sp.expand(slope), SIDES, named(names))
    return more_damped(certificate, minor, HEAVIER, OTHERS)


@cache
def at_the_end() -> dict[str, Theorem]:
    """What holds weakly of the wall (alpha, beta) where all walls on the way to it are stable."""
    begin = dict(zip((alpha, beta), START, strict=True))
    way = {end: start + WAY * (end - start) for end, start in begin.items()}
    on_it = at(assume(AT_ONCE), {WAY: WAY}, positive(WAY >= 0, WAY > 0), assume(WAY < 1))
    _, high, _ = damping_between(0, RANGES)
    softer = no_stiffer(0, (LIMIT, NEAR), RANGES)
    known = {
        "minor": inequalities(0)[-1],
        "above": above_minus_one(),
        "high": high,
        "softer": softer,
    }

    def ended(theorem: Theorem) -> Theorem:
        here: Any = closed(inst(theorem, way), on_it)
        rest = here.conclusion.right - here.conclusion.left
        end: Any = theorem.conclusion
        end = tends(rest, WAY, S.One, sp.expand(end.right - end.left))
        return prove_hyp(in_the_limit(here, WAY, S.Zero, S.One, end), one())

    return {name: ended(theorem) for name, theorem in known.items()}


@cache
def grows() -> Theorem:
    """The wall at which stable walls end right of alpha = -gamma is stable with a larger damper."""
    end, value = at_the_end(), away()[0]
    minor = positive(value >= 0, [end["minor"]])
    here = Given(alpha > -gamma, gamma <= STIFF, delta <= DAMPED)
    here = here.and_(end["above"], end["high"], end["softer"])
    toward = here.show(1 + n_1 * beta > 0, on_box(1 - n_1, RANGES), on_box(n_1, RANGES))
    above = here.closed(above_one(minor, toward, here.show(alpha + gamma > 0)))
    rise = minor_rises()
    after = rise.conclusion.right  # type: ignore[attr-defined]
    known = plants()
    left = by_multiple(alpha < CURVE, known["weight"], [inequalities(0)[-1].conclusion])
    left = closed(left, *(not_zero(known[n]) for n in ("weight", "late", "toward", "total")))
    other = {delta: HEAVIER, **dict(zip(NUMBERS, OTHERS, strict=True))}
    there = closed(inst(left, other), positive(after > 0, [minor], [rise]))
    found = mp(inst(between(), other), conj(assume(beta > -1), assume(alpha > -gamma), there))
    found = here.closed(closed(found, above))
    return HEAVY.closed(of_every_plant(choose(device_exists(gamma, HEAVIER, OTHERS), found)))


@cache
def more_damped_is_stable() -> Theorem:
    """A stable wall is one of these, the end of no way."""
    begin = dict(zip(START, (alpha, beta), strict=True))
    still = for_all([WAY], [WAY >= 0, WAY < 1], add_assum(assume(BARE), WAY >= 0, WAY < 1))
    right = of_every_plant(conjunct(needed(), alpha > -gamma))
    return HEAVY.closed(closed(inst(grows(), begin), still, closed(right, above_minus_one())))


def kept() -> Theorem:
    """A wall that is stable with the larger damper is right of alpha = -gamma."""
    right = of_every_plant(conjunct(needed(), alpha > -gamma))
    return HEAVY.closed(inst(closed(right, above_minus_one()), {delta: HEAVIER}))


def grown(then: Proposition) -> Theorem:
    """What the claim s4d-delta-grows concludes."""
    more, wider, right = then.parts
    wide: Any = wider
    there = for_all(wide.over, [wide.body.of[0]], grows())
    return conj(disch(more_damped_is_stable(), more.parts[0]), there, disch(kept(), right.parts[0]))


STIFF_ONE = {
    alpha: S(-4),
    beta: Rational(59, 10),
    gamma: S(5),
    delta: Rational(6, 5),
    HEAVIER: Rational(3, 2),
    d: S.Zero,
}
"""A wall that more damping makes unstable, beside a stiff spring."""


@cache
def lost_by_a_damper() -> Theorem:
    """The claim ``damping_can_destabilise``, by this wall."""
    some: Any = damping_can_destabilise()
    before, after = stable_at(STIFF_ONE), {**STIFF_ONE, delta: STIFF_ONE[HEAVIER]}
    larger = number(Relation(STIFF_ONE[delta], "<", STIFF_ONE[HEAVIER]))
    values = {s: STIFF_ONE[s] for s in some.over}
    return exists(conj(larger, before, unstable_at(after)), some, values)
