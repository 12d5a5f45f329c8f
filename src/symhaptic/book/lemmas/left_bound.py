"""Stable walls lie to the right of alpha = -gamma, and passive ones of damped arms come near it."""

from symhaptic.book.lemmas import figure9
from symhaptic.book.lemmas.boundary import at_rest
from symhaptic.book.lemmas.lower_boundary import is_some
from symhaptic.book.lemmas.passive_is_stable import MARGIN, NUMBERS, passive_is_stable
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import of_every_plant, on_box
from symhaptic.book.lemmas.undelayed_curve import WEIGHT, between, plants
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.plots import CURVE
from symhaptic.paper.propositions.stability import OTHER, PIECE

LINE = proposition(Eq(alpha, -gamma))
NONE, ONE = (Relation(d, "=", n) for n in (S.Zero, S.One))
SOFT = Or(
    (
        And((proposition(delta > 0), NONE)),
        And((proposition(delta > 0), ONE, proposition(gamma < 2 * delta))),
    )
)
"""A damper, and no delay, or one of a period beside a spring that is not too stiff."""

STEP = delta * x / (delta + 2 * x)
"""Less than x and delta/2."""
REACH = {S.Zero: delta / 2, S.One: delta / 4 - gamma / 8}
"""Up to which virtual damping the line is reached, for each delay."""


@cache
def right_of_the_line(delay: Expr) -> Theorem:
    """A stable wall has alpha < alpha', on the line, for a damped device and a whole delay."""
    late = Relation(d, "=", delay)
    static, pushed = at_rest()
    readings = loop_of_device(NUMBERS, (OTHER, beta, gamma, delta, delay))
    loop = conjunct(readings, readings.conclusion.parts[1])
    zeros = loop.conclusion.parts[1].terms[0]
    left = show(-gamma - OTHER >= 0, -gamma >= OTHER)
    value = combined(zeros.subs(z, 1) <= 0, [pushed, left], [static, 1])
    never = choose(
        device_exists(gamma, delta, NUMBERS),
        closed(denied_by(loop, zero_beyond(zeros, z, value)), fact(whole(delay))),
    )
    place = sp.Symbol("q")
    stable = STABLE.at({alpha: OTHER})
    here = subst(STABLE.at({alpha: OTHER, d: place}), place, assume(stable), assume(late))
    wanted = Relation(alpha, "<", OTHER)
    inside = show(wanted, -gamma < OTHER, LINE)
    found = disj_cases(ordered(-gamma, OTHER), inside, contr(not_intro(here, never), wanted))
    return for_all((OTHER, beta), [stable], found)


@cache
def near_the_line(delay: Expr) -> Theorem:
    """The wall STEP to the right of the line is passive and stable, with little virtual damping."""
    late, reach = Relation(d, "=", delay), REACH[delay]
    place = sp.Symbol("q")
    pattern = Relation(S.Zero, "<=", MARGIN.xreplace({d: place}))
    there = pattern.at({place: delay})
    low, high = (assume(p) for p in _between(reach))
    less, more = _turns((delay + 1) * theta)
    room: list[list[Any]] = [[S.Half, low, more], [S.Half, high, less]]
    if delay == 0:
        room.append([S.Half, assume(2 * delta - alpha - 2 * reach >= 0)])
    else:
        back, front = (assume(2 * delta + n * alpha - 2 * reach >= 0) for n in (1, -3))
        below, above = _turns(theta)
        room += [S.Half / 2, below, back], [S.Half / 2, above, front]
    bare = combined(there, *room)
    equal = show(Relation(delay, "=", d), late)
    margin = Given(*INSIDE).closed(subst(pattern, place, bare, equal), sine_of_half(theta))
    margins = for_all([theta], INSIDE, margin)
    counted = subst(whole(place), place, is_whole(delay), equal)
    stable = closed(conjunct(passive_is_stable(), STABLE), margins, counted)
    return _placed(stable, reach)


def _between(reach: Expr) -> tuple[Proposition, ...]:
    """-y <= beta <= y."""
    return tuple(map(proposition, (-reach <= beta, beta <= reach)))


def _turns(angle: Expr) -> tuple[Theorem, ...]:
    """0 <= 1 - cos and 0 <= 1 + cos."""
    sides = 1 - cos(angle), 1 + cos(angle)
    return tuple(show(side >= 0, square(side), bounded(cos, angle)) for side in sides)


def _placed(stable: Theorem, reach: Expr) -> Theorem:
    """With alpha = -gamma + STEP, for every x and every beta up to the reach."""
    here = Given(x > 0, delta > 0, gamma >= 0)
    values = {OTHER: -gamma + STEP}
    for claim in STEP > 0, delta / 2 - STEP > 0, x - STEP > 0:
        here.have(claim)
    where = here.closed(inst(stable, {alpha: values[OTHER]}), gamma < 2 * delta)
    beside = here.show(Relation(values[OTHER], "<", alpha + x), LINE)
    claim = And((Relation(OTHER, "<", alpha + x), STABLE.at({alpha: OTHER})))
    some = here.closed(exists(conj(beside, where), Exists((OTHER,), claim), values))
    given, ends = [proposition(x > 0), *_between(y)], assume(Eq(y, reach))
    inside = (show(p, *given[1:], ends) for p in _between(reach))
    walls = for_all([x, beta], given, closed(some, *inside))
    long = show(y > 0, ends, delta > 0, *([gamma < 2 * delta] if reach.has(gamma) else []))
    piece = Exists((y,), And((proposition(y > 0), walls.conclusion)))
    return choose(is_some(y, reach), exists(conj(long, walls), piece, {y: y}))


@cache
def left_bound() -> Theorem:
    """Both, under SOFT."""
    cases = (conj(right_of_the_line(d_), near_the_line(d_)) for d_ in (S.Zero, S.One))
    return disj_cases(assume(SOFT), *cases)


# -- arms of (23) without delay --------------------------------------------------------

NEAR = Rational(1, 100)
"""Walls so near to the line are stable without delay."""
SHORT = NEAR * x / (NEAR + 2 * x)
"""Less than x and NEAR/2."""


@cache
def bound_of_arms() -> Theorem:
    """What the claim s4d-left-bound says, under its hypotheses."""
    place = sp.Symbol("q")
    found = inst(figure9.right_of_the_line(), {alpha: place})
    right = show(alpha < place, found, LINE)
    right = inst(right, {place: OTHER})
    stable = STABLE.at({alpha: OTHER})
    right = for_all((OTHER, beta, d), [whole(d), stable], right)
    return conj(right, _reached())


def _reached() -> Theorem:
    """The wall SHORT to the right of the line is stable, for 1/4 <= beta <= 1/2."""
    low, high = PIECE
    given = [*map(proposition, (x > 0, beta >= low, beta <= high))]
    here = Given(x > 0)
    for claim in SHORT > 0, NEAR - SHORT > 0, x - SHORT > 0:
        here.have(claim)
    wall = -gamma + y
    ranges = {**RANGES, beta: PIECE, y: (0, NEAR)}
    known = plants()
    top = on_box(sp.expand(sp.fraction(CURVE)[0] - wall * WEIGHT), ranges)
    below = over(CURVE - wall > 0, top, known["weight"])
    right = beta > -1, -gamma < wall, wall < CURVE
    between_ = conj(*(show(p, beta >= low, y > 0, below) for p in right))
    stable = mp(inst(between(), {alpha: wall}), between_)
    nonzero = (known[n] for n in ("weight", "late", "toward"))
    stable = of_every_plant(Given(beta >= low).closed(stable, *nonzero))
    stable = here.closed(inst(stable, {y: SHORT}), beta >= low)
    values = {OTHER: -gamma + SHORT}
    beside = here.show(Relation(values[OTHER], "<", alpha + x), LINE)
    claim = And((Relation(OTHER, "<", alpha + x), STABLE.at({alpha: OTHER, d: S.Zero})))
    some = here.closed(exists(conj(beside, stable), Exists((OTHER,), claim), values))
    return for_all((x, beta), given, some)
