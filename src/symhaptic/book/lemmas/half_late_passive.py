"""Passive walls with a delay of half a period: a quadratic in cos(theta/2)^2."""

from sympy import atan

from symhaptic.book.lemmas.late_passivity import passive_late
from symhaptic.book.lemmas.passivity import at_every_angle, passive_by_angle
from symhaptic.book.lemmas.prelude import *

QUADRATIC = (
    b**2
    - b * K * T * x
    + b * B * (4 * x**2 - 3 * x)
    - K**2 * T**2 / 16
    - B * (K * T + B) * (1 - x) / 4
)
"""The margin with a delay of half a period, x = cos(theta/2)^2."""
AT_ANGLE = QUADRATIC.subs(x, cos(theta / 2) ** 2)


def wall(stiffness: Expr = K, damping: Expr = B, late: Expr = HALF) -> Predicate:
    """A wall is passive, with a delay of half a period if nothing else is said."""
    return Predicate("passive_wall", (), (stiffness, damping, b, T, late))


@cache
def passive_half_late() -> Theorem:
    """passive <=> 0 <= K and 0 <= the quadratic at every angle, for T > 0 and b > 0."""
    found = inst(passive_late(), {l: S.Zero, epsilon: HALF})
    condition = found.conclusion.parts[1]
    spring, always = condition.parts
    wanted = And((spring, at_every_angle(AT_ANGLE >= 0)))
    apart = positive(Ne(sin(theta / 2), 0), [sine_of_half(theta)])
    inside = [assume(p) for p in INSIDE]

    def same(known: Proposition, margin: Proposition) -> Theorem:
        given = conjunct(assume(known), known.parts[1])
        there = closed(positive(margin, [at(given, {theta: theta}, *inside)]), apart)
        return conj(conjunct(assume(known), spring), for_all([theta], INSIDE, there))

    there = same(condition, wanted.parts[1].body.of[1])  # type: ignore[attr-defined]
    back = same(wanted, always.body.of[1])  # type: ignore[attr-defined]
    found = chained(found, either_way(there, back, condition, wanted))
    return closed(found, *(fact(h) for h in found.hypotheses if not h.free))


def at_slope(slope: Rational, known: Theorem) -> Theorem:
    """0 <= the quadratic at x = 1/(1 + t^2), of a passive wall: theta = 2 atan(t)."""
    angle = 2 * atan(slope)
    inside = [number(Relation(S.Zero, "<", angle)), number(Relation(angle, "<", pi))]
    margin = conjunct(mp(passive_half_late(), known), at_every_angle(AT_ANGLE >= 0))
    return at(margin, {theta: angle}, *inside)


# -- the stiffest passive wall ---------------------------------------------------------

BELOW, ABOVE = Rational("1.175869"), Rational("1.175870")
BRAKE = Rational("0.324")
STIFFEST = 2 * tan(pi / 6), sqrt(3) / 9
"""K T/b and B/b of (11)."""
LOW = Rational(1, 10)
"""tan(theta/2) at which the wall of (11) does."""
TIP = Rational(5283, 10000)
"""tan(theta/2) at which a stiffer wall delivers energy."""


def stiffest() -> Proposition:
    r"""A wall with K T/b = 1.175869 is passive, none is with 1.175870 or more, nor is that of (11),
    and both numbers are 1.8\,\% above (11), to a tenth of a per cent."""
    most = ForAll((K, B), implied([wall()], ABOVE * b > K * T))
    eleven = Not((wall(STIFFEST[0] * b / T, STIFFEST[1] * b),))
    less, more = (STIFFEST[0] * Rational(f"1.01{n}5") for n in (7, 8))
    ends = [Relation(less, "<", BELOW), Relation(ABOVE, "<", more)]
    given = [T > 0, b > 0]
    return every([b, T], given, both([wall(BELOW * b / T, BRAKE * b), most, eleven, *ends]))


@cache
def stiffest_half_late() -> Theorem:
    """That."""
    claim = stiffest()
    given, then = claim.body.of  # type: ignore[attr-defined]
    _, _, eleven, *ends = then.of
    size = positive(b**2 > 0, [b > 0, b > 0])
    found = conj(
        passive_with(BELOW, BRAKE),
        for_all([K, B], [wall()], _less_stiff(size)),
        denied_at(LOW, eleven.of[0], [_lost(), size]),
        *map(number, ends),
    )
    return for_all([b, T], given.of, add_assum(found, *given.of))


@cache
def passive_with(stiffness: Rational, damping: Rational) -> Theorem:
    """A wall of so many b/T and b is passive with a delay of half a period, for T > 0 and b > 0."""
    apart = positive(Ne(T, 0), T > 0)
    units = {K: stiffness * b / T, B: damping * b}
    found = inst(passive_half_late(), units)
    condition = found.conclusion.parts[1]
    spring, always = condition.parts
    period = over(1 / T > 0, one(), T > 0)
    value = QUADRATIC.subs(units)
    bend, fall, rest = (expand(value / b**2).coeff(x, n) for n in (2, 1, 0))
    x_ = cos(theta / 2) ** 2
    size = positive(b**2 > 0, [b > 0, b > 0])
    margin = combined(
        always.body.of[1],  # type: ignore[attr-defined]
        [size, bend, square(x_ + fall / (2 * bend))],
        [size, rest - fall**2 / (4 * bend)],
    )
    stiff = positive(spring, [stiffness, assume(b > 0), period]) if stiffness else fact(spring)
    return closed(mp(found, conj(stiff, for_all([theta], INSIDE, margin))), apart)


def _less_stiff(size: Theorem) -> Theorem:
    """K T < 1.175870 b for a passive wall: at one angle the quadratic is negative beyond it."""
    known = at_slope(TIP, assume(wall()))
    more = K * T - ABOVE * b
    beyond = positive(more >= 0, ABOVE * b <= K * T)
    value = -QUADRATIC.subs(x, 1 / (1 + TIP**2)).subs(K, (x + ABOVE * b) / T)
    bend, slope = (expand(value).coeff(B, n) for n in (2, 1))
    rest = expand(value - bend * (B + slope / (2 * bend)) ** 2)
    double, single, last = (rest.coeff(x, n) for n in (2, 1, 0))
    denial = combined(
        Relation(known.conclusion.terms[1], "<", S.Zero),
        [bend, square(B + slope.subs(x, more) / (2 * bend))],
        [double, square(more)],
        [single / b, beyond, assume(b > 0)],
        [last / b**2, size],
    )
    wanted = proposition(ABOVE * b > K * T)
    contrary = contr(not_intro(known, denial), wanted)
    return disj_cases(ordered(K * T, ABOVE * b), assume(wanted), contrary)


def _lost() -> Theorem:
    """The quadratic of the wall of (11) there, over b^2, with its sign reversed."""
    units = {K: STIFFEST[0] * b / T, B: STIFFEST[1] * b, x: 1 / (1 + LOW**2)}
    return number(Relation(S.Zero, "<", expand(-QUADRATIC.subs(units) / b**2)))


def denied_at(slope: Rational, claim: Predicate, *products: Any) -> Theorem:
    """A wall is not passive, by the quadratic at one angle; products show that it is negative."""
    stiff, damping = claim.of[:2]
    apart = positive(Ne(T, 0), T > 0)
    found = closed(inst(at_slope(slope, assume(wall())), {K: stiff, B: damping}), apart)
    (negative,) = (Relation(found.conclusion.terms[1], "<", S.Zero),)
    return not_intro(found, combined(negative, *products), claim)


# -- a delay that helps ----------------------------------------------------------------

DAMPER = Rational(6, 5)
"""B/b of a wall without stiffness."""


def a_delay_helps() -> Proposition:
    """It is passive with a delay of half a period, and neither without delay nor with one period
    of delay."""
    damping = DAMPER * b
    others = [Not((wall(S.Zero, damping, S(n)),)) for n in (0, 1)]
    return every([b, T], [T > 0, b > 0], both([wall(S.Zero, damping), *others]))


@cache
def delay_helps() -> Theorem:
    """That."""
    given = [T > 0, b > 0]
    late = (_whole_denied(S(n), angle) for n, angle in ((0, 5 * pi / 6), (1, pi / 2)))
    return for_all([b, T], given, add_assum(conj(passive_with(S.Zero, DAMPER), *late), *given))


def _whole_denied(late: Expr, angle: Expr) -> Theorem:
    """The damped wall is not passive with an integer delay, by its margin at one angle."""
    claim = wall(S.Zero, DAMPER * b, late)
    found = mp(passive_by_angle(late), assume(wall(late=late)))
    inside = [fact(Relation(S.Zero, "<", angle)), fact(Relation(angle, "<", pi))]
    known = at(conjunct(found, found.conclusion.parts[1]), {theta: angle}, *inside)
    margin = inst(known, {K: S.Zero, B: DAMPER * b})
    lost = Relation(margin.conclusion.terms[1], "<", S.Zero)
    share = number(Relation(S.Zero, "<", expand(-lost.left / b)))
    return not_intro(margin, combined(lost, [share, assume(b > 0)]), claim)
