"""Is a wall passive at a fractional delay if it is passive at the next integer delay?

The paper's formulas are exact for integer delays. If passivity at the next integer delay implies
passivity at a fractional delay, the formulas are safe with the delay rounded up. We prove this for
every wall.
"""

from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.late_damping import END, HERE, LOW, PAIR, all_between, begins, ends
from symhaptic.book.lemmas.late_passivity import GIVEN, MARGIN, passive_late
from symhaptic.book.lemmas.passivity import every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import chi
from symhaptic.proof.theorems.familiar import polar


def derive(page):
    page.say(
        r"For an integer delay, \chapter{s3a_passivity_condition} gives the required damping "
        r"$b_{\min}(\theta)$: a wall is passive if $K\ge0$ and $b\ge b_{\min}(\theta)$ at every "
        r"angle. Let $\psi=\theta/2$, $u=KT/(2b)$ and $w=(B+KT/2)/b$, and $N=2(\ell+2)$ for the "
        r"next integer delay $\ell+1$. At one angle we define $r$ and $\kappa$ by $w=r\sin\kappa$ "
        r"and $u\cot\psi=r\cos\kappa$. For $K>0$ these equations have a solution with $r>0$ and "
        r"$|\kappa|<\frac\pi2$."
    )
    polar = {K: 2 * b * u / T, B: b * (w - u), theta: 2 * psi}
    turned = {u: r * cos(kappa) * tan(psi), w: r * sin(kappa)}
    need = passivity.dirichlet_form().subs(polar).subs(turned).subs(d, N / 2 - 1) / b
    page.step(
        "The condition of the next integer delay contains one sine",
        need,
        r * sin(N * psi - kappa),
        name=r"b_{\min}\big|_{d=\ell+1}/b",
        because=r"here $\chi=N\psi-\kappa$; for the delay $\ell$ the required damping is "
        r"$r\sin(\chi-2\psi)$",
    )
    share = (fractional.margin() / b**2).subs(polar).subs(turned)
    page.step(
        "The exact condition contains two sines and one more term",
        share.subs(l, N / 2 - 2).subs(kappa, N * psi - chi),
        1
        - r * ((1 - epsilon) * sin(chi - 2 * psi) + epsilon * sin(chi))
        - epsilon * (1 - epsilon) * r**2 * sin(psi) ** 2,
        name="f",
        because=r"by \chapter{s6d_fractional_passivity} a wall is passive with the delay "
        r"$\ell+\varepsilon$ if $K\ge0$ and $f\ge0$ at every angle. We call $f$ the margin",
    )
    page.say(
        r"Let the wall be passive at the next integer delay: $r\sin\chi\le1$ at all angles. If "
        r"$\chi\ge\frac\pi2$, consider the smaller angle $\psi'$ with $N\psi'=\frac\pi2+\kappa$. "
        r"At $\psi'$ the wall requires $\cos\kappa\,u\cot\psi'+w\sin\kappa$. This damping is at "
        r"least $r$, as $\cot\psi'\ge\cot\psi$. So $r\le1$."
    )
    page.lemma(
        r"The margin is a sum of squares for $\chi\ge\frac\pi2$",
        beyond(room(r)),
        because="this case uses $r\\le1$",
    )
    page.lemma(
        r"The margin is a sum of terms that are not negative for $\frac12\psi\le\chi<\frac\pi2$",
        before(room(r * sin(N * psi - kappa))),
        because="this case uses $r\\sin\\chi\\le1$",
    )
    page.lemma(
        r"The margin is a sum of terms that are not negative for $\chi<\frac12\psi$",
        low(room(r * sin(kappa))),
        because=r"here $\kappa$ lies between $(N-\frac12)\psi$ and $\frac\pi2$. At $N\psi=\pi$ "
        r"the integer delay requires $w=r\sin\kappa$, so $r\sin\kappa\le1$",
    )
    found = page.lemma(
        "A delay that is rounded up to an integer is safe",
        safe_when_rounded_up(),
        because=r"the previous three steps prove $f\ge0$ for $K>0$. For $K=0$ the passive values "
        "of $B$ begin at $-b$ with every delay. They end at $b$ with the next integer delay, "
        "and not below $b$ with a fractional one",
        boxed=True,
    )
    page.state(
        "fractional-next-whole",
        r"a wall that is passive for the integer delay $\ell+1$ is passive for every delay "
        r"between $\ell$ and $\ell+1$",
        claim=rounded_up(),
    )
    page.settle(
        "fractional-next-whole",
        found,
        example=(NOTHING, nothing_is_passive()),
        note="therefore (5) to (9) and (11) are safe if $d$ is rounded up",
    )


def room(size):
    """0 <= 1 - size, if size <= 1."""
    return positive(1 - size >= 0, size <= 1)


# A wall that is passive at the next integer delay is passive at every fractional delay before it.
#
# At one angle theta = 2 psi the wall u = K T/(2 b), w = (B + K T/2)/b is written w = r sin kappa
# and u cot psi = r cos kappa.  Let N = 2 (l + 2) and chi = N psi - kappa.  The next integer delay
# requires the damping b r sin chi, and the margin over b^2 is
# 1 - r ((1 - epsilon) sin (chi - 2 psi) + epsilon sin chi) - epsilon (1 - epsilon) r^2 sin^2 psi.

CHI = N * psi - kappa
STIFF, DAMPED = 2 * b * r * cos(kappa) * tan(psi) / T, b * r * (sin(kappa) - cos(kappa) * tan(psi))
"""The stiffness K and the damping B of the wall."""
POLAR = {K: STIFF, B: DAMPED, l: N / 2 - 2}
NEXT = every_margin(l + 1).at(POLAR)
"""The margin at the next integer delay is not negative at any angle."""
LATE = MARGIN.xreplace({**POLAR, theta: 2 * psi})
REST, LOSS = 1 - epsilon, epsilon * (1 - epsilon) * r**2 * sin(psi) ** 2
SHARE = 1 - r * (REST * sin(CHI - 2 * psi) + epsilon * sin(CHI)) - LOSS
"""The margin divided by b^2."""
ANGLE = Given(epsilon >= 0, epsilon <= 1, r > 0, N >= 4, psi > 0, psi < pi / 2)
ANGLE = ANGLE.and_(kappa > -pi / 2, kappa < pi / 2)
for claim in REST >= 0, sin(psi) > 0, cos(psi) > 0, PAIR >= 0:
    ANGLE.have(claim)


def _chord(lower: Expr, upper: Expr, here: Given) -> Theorem:
    """0 < sin x - sin y, for -pi/2 <= y < x <= pi/2."""
    return here.have(sin(upper) - sin(lower) > 0, rising(sin, lower, upper))


# -- the margin at one angle, by chi ---------------------------------------------------


def beyond(room: Theorem) -> Theorem:
    """0 <= margin if r <= 1; the margin is a sum of squares."""
    size, part_, rest = assume(r > 0), assume(epsilon >= 0), ANGLE.show(REST >= 0)
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
    """0 <= margin if r sin chi <= 1 and psi/2 <= chi < pi/2."""
    here = ANGLE.and_(psi / 2 <= CHI, pi / 2 > CHI)
    wave, pair, rest = (here.show(e) for e in (sin(psi) > 0, PAIR >= 0, REST >= 0))
    here.have(CHI > 0)
    here.have(sin(CHI) > 0)
    size, double = assume(r > 0), here.closed(weak_sine(2 * CHI - psi))
    inverse = here.show(1 / sin(CHI) > 0)
    found = combined(
        SHARE >= 0,
        [size, rest, wave, double, inverse],
        [size, rest, rest, wave, wave, inverse],
        [room],
        [room, pair, size, wave, wave, inverse],
    )
    return here.closed(found)


def low(room: Theorem) -> Theorem:
    """0 <= margin if r sin kappa <= 1 and chi < psi/2."""
    here = ANGLE.and_(psi / 2 > CHI)
    wave, pair, rest = (here.show(e) for e in (sin(psi) > 0, PAIR >= 0, REST >= 0))
    size = assume(r > 0)
    here.have(psi < kappa)
    here.have(pi / 2 > 7 * psi / 2)
    half = here.have(sin(psi / 2) > 0)
    wide, first = _chord(psi, kappa, here), _chord(CHI, psi / 2, here)
    second = _chord(CHI - 2 * psi, psi / 2, here)
    steep = _chord(pi / 4, pi / 2 - psi / 2, here)
    root = number(Relation(S.Zero, "<", 3 * sqrt(2) / 4 - 1))
    flat = combined(3 * cos(psi / 2) / 2 - 1 > 0, [Rational(3, 2), steep], [root])
    wider = combined(
        sin(kappa) + sin(psi) - sin(psi / 2) > 0,
        [wide],
        [Rational(8, 3), half, flat],
        [Rational(5, 3), half],
    )
    here.have(sin(kappa) > 0)
    inverse = here.show(1 / sin(kappa) > 0)
    found = combined(
        SHARE >= 0,
        [size, rest, second],
        [size, assume(epsilon >= 0), first],
        [size, square(HALF - epsilon), wave, wave, inverse],
        [size, wide, wider, inverse],
        [size, wave, half, flat, inverse],
        [room],
        [room, pair, size, wave, wave, inverse],
    )
    return here.closed(found)


# -- the condition of the next integer delay -------------------------------------------


def _needed(angle: Expr, room: Expr, here: Given, *more: Any) -> Theorem:
    """0 <= room, from the margin of the next integer delay at the angle 2 x."""
    here = here.and_(b > 0, T > 0)
    here.have(angle > 0)
    here.have(angle < pi / 2)
    known = at(
        assume(NEXT), {theta: 2 * angle}, here.show(2 * angle > 0), here.show(2 * angle < pi)
    )
    share = over(known.conclusion.right / b >= 0, known, b > 0)
    return here.closed(combined(room >= 0, [share], *more), here.show(sin(angle) > 0))


def _here() -> Theorem:
    """r sin chi <= 1, from the margin at the angle psi."""
    return _needed(psi, 1 - r * sin(CHI), ANGLE)


def _at_the_end() -> Theorem:
    """r sin kappa <= 1, from the margin at N x = pi."""
    return _needed(pi / N, 1 - r * sin(kappa), ANGLE)


def _early() -> Theorem:
    """r <= 1 if pi/2 <= chi, from the margin at the smaller angle N x = pi/2 + kappa."""
    here = ANGLE.and_(pi / 2 <= CHI)
    angle = (pi / 2 + kappa) / N
    here.have((CHI - pi / 2) / N >= 0)
    here.have(angle > 0)
    here.have(sin(angle) > 0)
    side = here.show(cos(kappa) > 0)
    turns = here.show(1 / cos(psi) > 0), here.show(1 / sin(angle) > 0)
    larger = assume(r > 0), side, side, *turns, here.closed(weak_sine(psi - angle))
    return _needed(angle, 1 - r, here, larger)


@cache
def at_one_angle() -> Theorem:
    """The margin at an angle is not negative if those of the next integer delay are not."""
    late, early, first = beyond(_early()), before(_here()), low(_at_the_end())
    later = disj_cases(ordered(CHI, pi / 2), early, late)
    return disj_cases(ordered(CHI, psi / 2), first, later)


# -- the wall --------------------------------------------------------------------------

NEXT_WALL = Predicate("passive_wall", (), (K, B, b, T, l + 1))
LATE_WALL = Predicate("passive_wall", (), (K, B, b, T, l + epsilon))
WALLS = (K, B, b, T, l, epsilon)


def rounded_up() -> Proposition:
    """A wall that is passive for the delay l + 1 is passive for every delay between l and l + 1."""
    return every(WALLS, [*GIVEN, NEXT_WALL], LATE_WALL)


@cache
def safe_when_rounded_up() -> Theorem:
    found = mp(HERE.closed(inst(passive_by_angle(), {d: l + 1})), assume(NEXT_WALL))
    stiff = strictly(conjunct(found, K >= 0), show(Ne(0, K), Ne(K, 0)))
    sprung = prove_hyp(closed(_sprung(), stiff), conjunct(found, every_margin(l + 1)))
    either = disj_cases(decided(K, S.Zero), _soft(), sprung)
    return for_all(WALLS, [*GIVEN, NEXT_WALL], add_assum(either, *GIVEN, NEXT_WALL))


def _sprung() -> Theorem:
    """A wall with 0 < K is passive, since it has an r and a kappa at each angle."""
    margin = for_all([theta], INSIDE, _margin())
    return mp(passive_late(), conj(show(K >= 0, K > 0), margin))


def _margin() -> Theorem:
    """A wall with 0 < K has 0 <= margin at an angle."""
    along, across = K * T * cos(theta / 2) / (2 * b * sin(theta / 2)), (B + K * T / 2) / b
    one_, two = (assume(Eq(v, r * f(kappa))) for v, f in ((along, cos), (across, sin)))
    stiff, damped = (v.subs(psi, theta / 2) for v in (STIFF, DAMPED))
    equal = (
        combined(Eq(K, stiff), [one_, 2 * b * tan(theta / 2) / T]),
        combined(Eq(B, damped), [two, b], [one_, -b * tan(theta / 2)]),
    )
    here = Given(K > 0, T > 0, b > 0, *INSIDE).and_(sine_of_half(theta))
    here.have(cos(theta / 2) > 0)
    found = here.closed(closed(_turned(stiff, damped), _written(every_margin(l + 1), *equal)))
    found = _written(proposition(MARGIN >= 0), _back(equal[0]), _back(equal[1]), found)
    return here.closed(choose(here.closed(polar(along, across, r, kappa)), here.closed(found)))


def _turned(stiff: Expr, damped: Expr) -> Theorem:
    """0 <= margin at an angle, in terms of r and kappa."""
    found = inst(at_one_angle(), {N: 2 * l + 4, psi: theta / 2})
    wall = {K: stiff, B: damped}
    x = Symbol("x")  # theta is in the wall
    always = every_margin(l + 1).at(wall)
    given = [assume(proposition(p).at({theta: x})) for p in INSIDE]
    goal = NEXT.at({N: 2 * l + 4, psi: theta / 2})
    there = goal.body.at({goal.over[0]: x}).parts[1]
    here = at(assume(always), {always.over[0]: x}, *given)
    same = Given(*given).show(there, here, sine_of_half(x))
    same = for_all([x], [p.conclusion for p in given], same)
    found = Given(whole(l)).closed(closed(found, same))
    return positive(MARGIN.xreplace(wall) >= 0, [assume(b > 0), assume(b > 0), found])


def _back(equation: Theorem) -> Theorem:
    """From a = b, b = a."""
    left, right = equation.conclusion.terms
    return combined(Relation(right, "=", left), [equation, -S.One])


def _written(
    claim: Proposition, stiff: Theorem, damped: Theorem, known: Theorem | None = None
) -> Theorem:
    """A claim on K and B, rewritten by two equations K = ... and B = ..."""
    place = Symbol("q")
    one_, other = stiff.conclusion.terms, damped.conclusion.terms
    found = known or assume(claim)
    found = subst(claim.at({K: place, B: other[0]}), place, found, stiff)
    return subst(claim.at({K: one_[1], B: place}), place, found, damped)


def _soft() -> Theorem:
    """A wall with K = 0 is passive, since its damping is at most b."""
    at_once, place = {epsilon: S.One}, Symbol("q")
    none = assume(Eq(K, 0))
    damper = subst(NEXT_WALL.at({K: place}), place, assume(NEXT_WALL), none)
    low_, high = (HERE.closed(closed(inst(t, at_once), damper)) for t in (begins(), ends()))
    share = HERE.show(b * PAIR * LOW**2 >= 0)
    below = show(B <= END, high, share)
    found = closed(all_between(), low_, below)
    found = subst(LATE_WALL.at({K: place}), place, found, show(Eq(0, K), none))
    return HERE.closed(found)


NOTHING = {K: S.Zero, B: S.Zero, b: S.One, T: S.One, l: S.Zero, epsilon: HALF}
"""The wall K = B = 0."""


@cache
def nothing_is_passive() -> Theorem:
    """The wall K = B = 0 is passive with one period of delay."""
    found = inst(all_between(), {s: v for s, v in {**NOTHING, epsilon: S.One}.items() if s != K})
    return Given().closed(found)
