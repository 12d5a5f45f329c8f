"""A wall that is passive at the next whole delay is passive at every fraction before it.

At one angle theta = 2 psi the wall u = K T/(2 b), w = (B + K T/2)/b is written w = r sin kappa and
u cot psi = r cos kappa.  With N = 2 (l + 2) and chi = N psi - kappa the next whole delay needs
r sin chi, and the margin over b^2 is 1 - r ((1 - epsilon) sin (chi - 2 psi) + epsilon sin chi)
- epsilon (1 - epsilon) r^2 sin^2 psi.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.late_damping import END, LOW, all_between, begins, divisors, ends
from symhaptic.book.lemmas.late_passivity import GIVEN, MARGIN, passive_late
from symhaptic.book.lemmas.passivity import INSIDE, every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import b, kappa, r
from symhaptic.proof.theorems.familiar import polar

CHI = N * psi - kappa
STIFF, DAMPED = 2 * b * r * cos(kappa) * tan(psi) / T, b * r * (sin(kappa) - cos(kappa) * tan(psi))
"""K and B of the wall."""
POLAR = {K: STIFF, B: DAMPED, l: N / 2 - 2}
NEXT = every_margin(l + 1).at(POLAR)
"""It is passive at the next whole delay, as far as the angles say."""
LATE = MARGIN.xreplace({**POLAR, theta: 2 * psi})
REST, LOSS = 1 - epsilon, epsilon * (1 - epsilon) * r**2 * sin(psi) ** 2
SHARE = 1 - r * (REST * sin(CHI - 2 * psi) + epsilon * sin(CHI)) - LOSS
"""The margin over b^2."""


def _more(expr: Expr, *products: Any) -> Theorem:
    """0 < expr."""
    return positive(Relation(S.Zero, "<", expr), *products)


def _chord(lower: Expr, upper: Expr, *known: Theorem) -> Theorem:
    """0 < sin x - sin y, for -pi/2 <= y < x <= pi/2."""
    found = closed(rising(sin, lower, upper), *known)
    return _more(sin(upper) - sin(lower), [found])


@cache
def _small() -> dict[str, Theorem]:
    """What is known of epsilon, r and psi."""
    rest = positive(REST >= 0, epsilon <= 1)
    pair = positive(epsilon * REST >= 0, [rest, epsilon >= 0])
    wave = closed(sign_of(sin, psi), positive(psi < pi, psi < pi / 2, [HALF, PI]))
    along = closed(sign_of(cos, psi), positive(psi > -pi / 2, psi > 0, [HALF, PI]))
    return {"rest": rest, "pair": pair, "sin": wave, "cos": along}


# -- the margin at one angle, by chi ---------------------------------------------------


def beyond(room: Theorem) -> Theorem:
    """0 <= margin from r <= 1: all squares."""
    known, size = _small(), assume(r > 0)
    part_, rest = assume(epsilon >= 0), known["rest"]
    first, second = pi / 4 - CHI / 2 + psi, pi / 4 - CHI / 2
    return combined(
        SHARE >= 0,
        [2, size, rest, rest, square(sin(first))],
        [2, size, part_, part_, square(sin(second))],
        [size, part_, rest, square(cos(CHI - psi))],
        [4, size, part_, rest, square(sin(first) * sin(second))],
        [room],
        [room, part_, rest, size, square(sin(psi))],
    )


def before(room: Theorem) -> Theorem:
    """0 <= margin from r sin chi <= 1 and psi/2 <= chi < pi/2."""
    known, size = _small(), assume(r > 0)
    wave, pair, rest = known["sin"], known["pair"], known["rest"]
    up, down = _more(pi / 2 - CHI, pi / 2 > CHI), positive(CHI - psi / 2 >= 0, psi / 2 <= CHI)
    rises = _more(CHI, [down], [HALF, assume(psi > 0)])
    sine = closed(sign_of(sin, CHI), rises, positive(pi > CHI, [up], [HALF, PI]))
    double = closed(
        weak_sine(2 * CHI - psi),
        positive(2 * CHI - psi >= 0, [2, down]),
        positive(2 * CHI - psi <= pi, [2, up], psi > 0),
    )
    inverse = over(1 / sin(CHI) > 0, one(), sine)
    found = combined(
        SHARE >= 0,
        [size, rest, wave, double, inverse],
        [size, rest, rest, wave, wave, inverse],
        [room],
        [room, pair, size, wave, wave, inverse],
    )
    return closed(found, not_zero(sine))


def low(room: Theorem) -> Theorem:
    """0 <= margin from r sin kappa <= 1 and chi < psi/2."""
    known, size, angle = _small(), assume(r > 0), assume(psi > 0)
    wave, rest = known["sin"], known["rest"]
    small, up = _more(psi / 2 - CHI, psi / 2 > CHI), _more(pi / 2 - kappa, kappa < pi / 2)
    more, quarter = positive(N - 4 >= 0, N >= 4), Rational(5, 2)
    left = _more(pi / 2 - 7 * psi / 2, [up], [small], [more, angle])
    ends = (
        positive(psi / 2 <= pi / 2, [left], [3, angle]),
        positive(kappa <= pi / 2, [up]),
        positive(-pi / 2 <= CHI, [up], [more, angle], [4, angle]),
        positive(CHI - 2 * psi >= -pi / 2, [up], [more, angle], [2, angle]),
        positive(psi >= -pi / 2, angle, [HALF, PI]),
        number(Relation(-pi / 2, "<=", pi / 4)),
        positive(pi / 2 - psi / 2 <= pi / 2, [HALF, angle]),
        positive(psi < kappa, [small], [more, angle], [quarter, angle]),
        positive(psi / 2 > CHI, [small]),
        positive(CHI - 2 * psi < psi / 2, [small], [2, angle]),
        positive(pi / 4 < pi / 2 - psi / 2, [Rational(1, 7), left], [Rational(5, 28), PI]),
    )
    half = closed(
        sign_of(sin, psi / 2),
        _more(psi / 2, [HALF, angle]),
        positive(psi / 2 < pi, [left], [3, angle], [HALF, PI]),
    )
    wide, first = _chord(psi, kappa, *ends), _chord(CHI, psi / 2, *ends)
    second = _chord(CHI - 2 * psi, psi / 2, *ends)
    steep = _chord(pi / 4, pi / 2 - psi / 2, *ends)
    root = number(Relation(S.Zero, "<", 3 * sqrt(2) / 4 - 1))
    flat = _more(3 * cos(psi / 2) / 2 - 1, [Rational(3, 2), steep], [root])
    wider = _more(
        sin(kappa) + sin(psi) - sin(psi / 2),
        [wide],
        [Rational(8, 3), half, flat],
        [Rational(5, 3), half],
    )
    sine = _more(sin(kappa), [wide], [wave])
    inverse = over(1 / sin(kappa) > 0, one(), sine)
    found = combined(
        SHARE >= 0,
        [size, rest, second],
        [size, assume(epsilon >= 0), first],
        [size, square(HALF - epsilon), wave, wave, inverse],
        [size, wide, wider, inverse],
        [size, wave, half, flat, inverse],
        [room],
        [room, known["pair"], size, wave, wave, inverse],
    )
    return closed(found, not_zero(sine))


# -- what the next whole delay asks for ------------------------------------------------


def _needed(angle: Expr, room: Expr, low_: Theorem, high: Theorem, *more: Any) -> Theorem:
    """0 <= room, which is what is left at an angle x, and more: b - need at theta = 2 x."""
    inside = _more(2 * angle, [2, low_]), positive(2 * angle < pi, [2, high])
    known = at(assume(NEXT), {theta: 2 * angle}, *inside)
    share = over(known.conclusion.right / b >= 0, known, b > 0)  # type: ignore[attr-defined]
    wave = closed(sign_of(sin, angle), low_, positive(angle < pi, [high], [HALF, PI]))
    found = combined(room >= 0, [share], *more)
    apart = (
        not_zero(wave),
        not_zero(_small()["cos"]),
        not_zero(assume(b > 0)),
        not_zero(assume(T > 0)),
    )
    return closed(found, *apart)


def _here() -> Theorem:
    """r sin chi <= 1."""
    return _needed(psi, 1 - r * sin(CHI), assume(psi > 0), assume(psi < pi / 2))


def _at_the_end() -> Theorem:
    """r sin kappa <= 1, from N x = pi."""
    size = positive(N > 0, N >= 4, [4])
    low_ = over(pi / N > 0, PI, size)
    rest = positive(pi * (N / 2 - 1) > 0, [HALF, PI, positive(N - 4 >= 0, N >= 4)], [PI])
    high = positive(pi / N < pi / 2, [over(pi * (N / 2 - 1) / N > 0, rest, size)])
    return closed(_needed(pi / N, 1 - r * sin(kappa), low_, high), not_zero(size))


def _early() -> Theorem:
    """r <= 1 for pi/2 <= chi, from N x = pi/2 + kappa, where u cot x is larger still."""
    size, known = positive(N > 0, N >= 4, [4]), _small()
    angle = (pi / 2 + kappa) / N
    low_ = over(angle > 0, _more(pi / 2 + kappa, kappa > -pi / 2), size)
    ahead = over((CHI - pi / 2) / N >= 0, positive(CHI - pi / 2 >= 0, pi / 2 <= CHI), size)
    high = positive(angle < pi / 2, [ahead], psi < pi / 2)
    apart = psi - angle
    ends = positive(apart >= 0, [ahead]), positive(apart <= pi, [low_], [HALF, PI], psi < pi / 2)
    wave = closed(sign_of(sin, angle), low_, positive(angle < pi, [high], [HALF, PI]))
    side = sign_of(cos, kappa)
    larger = (
        assume(r > 0),
        side,
        side,
        over(1 / cos(psi) > 0, one(), known["cos"]),
        over(1 / sin(angle) > 0, one(), wave),
        closed(weak_sine(apart), *ends),
    )
    found = _needed(angle, 1 - r, low_, high, larger)
    return closed(found, not_zero(size), not_zero(known["sin"]))


@cache
def at_one_angle() -> Theorem:
    """0 <= margin over b^2 at an angle, from the margins of the next whole delay."""
    late, early, first = beyond(_early()), before(_here()), low(_at_the_end())
    later = disj_cases(ordered(CHI, pi / 2), early, late)
    return disj_cases(ordered(CHI, psi / 2), first, later)


# -- the wall --------------------------------------------------------------------------

NEXT_WALL = Predicate("passive_wall", (), (K, B, b, T, l + 1))
LATE_WALL = Predicate("passive_wall", (), (K, B, b, T, l + epsilon))
WALLS = (K, B, b, T, l, epsilon)


def rounded_up() -> Proposition:
    """What is passive for the delay l + 1 is passive for every delay between l and l + 1."""
    return every(WALLS, [*GIVEN, NEXT_WALL], LATE_WALL)


@cache
def safe_when_rounded_up() -> Theorem:
    """That."""
    by_angle = closed(inst(passive_by_angle(), {d: l + 1}), is_whole(l + 1, assume(whole(l))))
    found = mp(by_angle, assume(NEXT_WALL))
    pushes = conjunct(found, K >= 0)
    stiff = strictly(pushes, combined(Ne(0, K), [assume(Ne(K, 0))]))
    sprung = prove_hyp(closed(_sprung(), stiff), conjunct(found, every_margin(l + 1)))
    either = disj_cases(decided(K, S.Zero), _soft(), sprung)
    return for_all(WALLS, [*GIVEN, NEXT_WALL], add_assum(either, *GIVEN, NEXT_WALL))


def _sprung() -> Theorem:
    """passive, for 0 < K: at each angle the wall has an r and a kappa."""
    margin = for_all([theta], INSIDE, _margin())
    return mp(passive_late(), conj(positive(K >= 0, K > 0), margin))


def _margin() -> Theorem:
    """0 <= margin of a wall with 0 < K at an angle, from those of the next whole delay."""
    half = [HALF, assume(theta > 0)], [HALF, assume(theta < pi)]
    inside = positive(theta / 2 > 0, half[0]), positive(theta / 2 < pi / 2, half[1])
    left = positive(theta / 2 > -pi / 2, half[0], [HALF, PI])
    wave, side = sine_of_half(theta), closed(sign_of(cos, theta / 2), left, inside[1])
    along, across = K * T * cos(theta / 2) / (2 * b * sin(theta / 2)), (B + K * T / 2) / b
    one_, two = (assume(Eq(v, r * f(kappa))) for v, f in ((along, cos), (across, sin)))
    stiff, damped = (v.subs(psi, theta / 2) for v in (STIFF, DAMPED))
    equal = (
        combined(Eq(K, stiff), [one_, 2 * b * tan(theta / 2) / T]),
        combined(Eq(B, damped), [two, b], [one_, -b * tan(theta / 2)]),
    )
    found = closed(_turned(stiff, damped), *inside, _written(every_margin(l + 1), *equal))
    found = _written(proposition(MARGIN >= 0), _back(equal[0]), _back(equal[1]), found)
    top = positive(K * T * cos(theta / 2) > 0, [assume(K > 0), assume(T > 0), side])
    bottom = positive(2 * b * sin(theta / 2) > 0, [2, assume(b > 0), wave])
    apart = [not_zero(t) for t in (wave, side, assume(b > 0), assume(T > 0))]
    names = closed(polar(along, across, r, kappa), over(along > 0, top, bottom))
    return closed(choose(names, closed(found, *apart)), *apart)


def _turned(stiff: Expr, damped: Expr) -> Theorem:
    """0 <= margin at an angle, by r and kappa."""
    found = inst(at_one_angle(), {N: 2 * l + 4, psi: theta / 2})
    size = positive(2 * l + 4 >= 4, [2, not_negative(assume(whole(l)))])
    wall = {K: stiff, B: damped}
    x = Symbol("x")  # theta is in the wall
    always = every_margin(l + 1).at(wall)
    given = [assume(proposition(p).at({theta: x})) for p in INSIDE]
    goal = NEXT.at({N: 2 * l + 4, psi: theta / 2})
    there = goal.body.at({goal.over[0]: x}).parts[1]  # type: ignore[attr-defined]
    apart = positive(Ne(sin(x / 2), 0), [sine_of_half(x)])
    here = at(assume(always), {always.over[0]: x}, *given)  # type: ignore[attr-defined]
    same = closed(positive(there, [here]), apart)
    same = for_all([x], [p.conclusion for p in given], same)
    margin = MARGIN.xreplace(wall) >= 0
    return positive(margin, [assume(b > 0), assume(b > 0), closed(found, size, same)])


def _back(equation: Theorem) -> Theorem:
    """b = a from a = b."""
    left, right = equation.conclusion.terms
    return combined(Relation(right, "=", left), [equation, -S.One])


def _written(
    claim: Proposition, stiff: Theorem, damped: Theorem, known: Theorem | None = None
) -> Theorem:
    """A claim on the wall K, B with the right sides of two equations for their left sides."""
    place = Symbol("q")
    one_, other = stiff.conclusion.terms, damped.conclusion.terms
    found = known or assume(claim)
    found = subst(claim.at({K: place, B: other[0]}), place, found, stiff)
    return subst(claim.at({K: one_[1], B: place}), place, found, damped)


def _soft() -> Theorem:
    """passive, for K = 0: the damping is b at most."""
    at_once, place = {epsilon: S.One}, Symbol("q")
    none = assume(Eq(K, 0))
    damper = subst(NEXT_WALL.at({K: place}), place, assume(NEXT_WALL), none)
    bounds = [closed(inst(t, at_once), damper) for t in (begins(), ends())]
    rest = positive(1 - epsilon >= 0, epsilon <= 1)
    share = positive(END - b >= 0, [HALF, assume(b > 0), assume(epsilon >= 0), rest, square(LOW)])
    below = positive(B <= END, [bounds[1]], [share])
    found = closed(all_between(), bounds[0], below)
    back = combined(Eq(0, K), [none, -S.One])
    numbers = (fact(Relation(S(n), "<=", S.One)) for n in (0, 1))
    found = subst(LATE_WALL.at({K: place}), place, found, back)
    return closed(found, *numbers, *divisors())


NOTHING = {K: S.Zero, B: S.Zero, b: S.One, T: S.One, l: S.Zero, epsilon: HALF}
"""No wall at all."""


@cache
def nothing_is_passive() -> Theorem:
    """No wall is passive one period late."""
    found = inst(all_between(), {s: v for s, v in {**NOTHING, epsilon: S.One}.items() if s != K})
    return closed(found, *map(fact, found.hypotheses))
