r"""Does the stable region still reach the line $\alpha=-\gamma$ with a delay?

Without delay the region reaches this line for the arms of (23). With one period of delay the region
still reaches the line for a spring as soft as that of an arm, but not for some stiff springs.
"""

from symhaptic.book.lemmas import figure9
from symhaptic.book.lemmas.boundary import at_rest
from symhaptic.book.lemmas.lower_boundary import is_some
from symhaptic.book.lemmas.passive_is_stable import MARGIN, passive_is_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.book.lemmas.undelayed_curve import WEIGHT, between, plants
from symhaptic.model import loop
from symhaptic.paper.propositions.plots import CURVE
from symhaptic.paper.propositions.stability import OTHER, PIECE, damped_region_ends_on_the_line


def derive(page):
    soft_spring(page)
    page.say(
        r"Take a spring that is far stiffer than an arm, without damping: $\sqrt\gamma=2\pi/3$, "
        r"so $\cos\sqrt\gamma=-\tfrac12$. On the line $\alpha=-\gamma$ one root is 1. Let "
        r"$x=n_1\beta$:"
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)))
    spring = {gamma: 4 * pi**2 / 9}
    poly = loop.characteristic(Parts(damping=False)).subs(d, 1)
    poly = poly.subs({alpha: -gamma, beta: x / swinging.n1}).subs(spring)
    page.step(
        "The other three roots are those of a cubic",
        poly / (z - 1),
        z**3 + 2 * z**2 + (x + Rational(3, 2)) * z + x,
        name=r"p_1(z)/(z-1)",
    )
    roots, names = symbols("r_1 r_2 r_3"), symbols("q_0 q_1 q_2")
    one, two, three = roots
    made = ((z - one) * (z - two) * (z - three)).expand()
    by_roots = -one * two * three, one * two + one * three + two * three, -one - two - three
    for power, (name, value) in enumerate(zip(names, by_roots, strict=True)):
        page.step(
            f"Three roots give the coefficient of power {power}",
            made.coeff(z, power),
            value,
            name=name,
        )
    page.step(
        "A product is positive if all three roots lie inside",
        1 - names[1] + names[0] * names[2] - names[0] ** 2,
        (1 - one * two) * (1 - one * three) * (1 - two * three),
        because="the product is positive if all $|r_i|<1$, as non-real roots come in conjugate "
        "pairs",
    )
    page.step(
        "On the line this product is negative",
        1 - (x + Rational(3, 2)) + 2 * x - x**2,
        -((x - Rational(1, 2)) ** 2) - Rational(1, 4),
        because="the product is negative for every $x$, so the line is not a border of the "
        "region for any damping",
    )
    damping = (-1 / (10 * swinging.n1)).subs(spring)
    page.lemma(
        "With this spring and one period of delay a wall away from the line is stable",
        stable_at({alpha: S.Zero, beta: damping, delta: S.Zero, d: S.One, **spring}),
        because=r"the wall is $\alpha=0$, $n_1\beta=-\tfrac1{10}$",
    )
    _settled(page)


def _settled(page):
    """Theorems for the arms of (23), and for damped arms with any spring."""
    page.say(
        "For the arms of (23) and without delay, the exact curve of "
        r"\chapter{s4d_figure7_undelayed} shows that the region ends on the line. With a delay "
        "every stable wall lies to the right of the line."
    )
    claim = CLAIMED["s4d-left-bound"]([Eq(alpha, -gamma)])
    arms = page.lemma(
        "For the arms of (23) the left bound of the stable region is "
        r"$\alpha=-\gamma$",
        bound_of_arms(),
    )
    page.settle(
        "s4d-left-bound",
        Eq(alpha, -gamma),
        as_claimed(claim, arms),
        example={alpha: S.Zero, gamma: S.Zero, delta: S.Zero},
        note=r"for $d\ge1$ inside (23) we show only $\alpha>-\gamma$. At the limits of (23), for "
        "$d=1$ and $d=2$, some stable walls are within the thickness of a printed line of this "
        r"bound (\texttt{fig9}). With a spring that is stiffer than (23), the region may not "
        r"reach the line, as for $\sqrt\gamma=\tfrac23\pi$, $d=1$ and $\delta=0$",
    )
    page.say(
        r"For a damped device without delay, or with one period of delay and $\gamma<2\delta$, "
        "there is a simpler argument. A wall of negative stiffness and little virtual damping "
        r"then satisfies (5) and is therefore stable (\chapter{s5a_passive_is_stable}):"
    )
    found = page.lemma("The region of a damped device ends on the line", left_bound(), boxed=True)
    claim = damped_region_ends_on_the_line()
    easy = {alpha: -S.One, gamma: S.One, delta: S.One, d: S.Zero}
    soft = SOFT.at(easy)
    there = disj(conj(*(fact(p) for p in soft.parts[0].parts)), soft)
    page.state(
        "left-bound-damped",
        "for a damped arm the stable region ends on the line $\\alpha=-\\gamma$ without delay, and "
        "for $d=1$ if $\\gamma<2\\delta$",
        claim=claim,
    )
    page.settle("left-bound-damped", found, example=(easy, there))


def soft_spring(page):
    """One period of delay and gamma <= 1: the wall alpha = -gamma, beta = 0 has one root at 1."""
    line = loop.named().subs({d: 1, alpha: -gamma, beta: 0})
    roots = Eq(line, z * (z - 1) * (z**2 + (1 - a) * z + gamma * n_0))
    static = device_static(assume(DEVICE))
    page.lemma(
        "For one period of delay and $\\beta=0$ the polynomial on the line has the roots 0 and 1",
        combined(roots, [static, z**2]),
        because=r"both roots of the quadratic factor lie inside if $\gamma n_0<1$, $2-a+\gamma "
        r"n_0>0$ and $a+\gamma n_0>0$",
    )
    page.say(
        "A unit force that is held for a period moves the mass by at most half a unit, so "
        r"$n_0\le n_1\le\frac12$. For $\gamma\le1$ this gives the three inequalities: $\gamma "
        r"n_0<1$, $a+\gamma n_0=1+e-\gamma n_1>0$ and $2-a+\gamma n_0=1-e+\gamma(n_1+2n_0)>0$. The "
        r"last one fails for $\gamma=\delta=0$ only. For this free mass take $\beta=\tfrac12$ "
        "instead:"
    )
    free = loop.characteristic(Parts(False, False)).subs({d: 1, alpha: 0, beta: S.Half})
    cubic = z**3 - z**2 + z / 4 + Rational(1, 4)
    page.step("For a free mass the polynomial has the root 1", free, (z - 1) * cubic, name="p_1(z)")
    page.lemma("All zeros of this cubic lie inside the unit circle", roots_inside(cubic, z, {}))


# Stable walls lie to the right of alpha = -gamma; with damped arms passive walls come near it.

LINE = proposition(Eq(alpha, -gamma))
NONE, ONE = (Relation(d, "=", n) for n in (S.Zero, S.One))
SOFT = Or(
    (
        And((proposition(delta > 0), NONE)),
        And((proposition(delta > 0), ONE, proposition(gamma < 2 * delta))),
    )
)
"""A damped device without delay, or with one period of delay and gamma < 2 delta."""

STEP = delta * x / (delta + 2 * x)
"""A number less than x and delta/2."""
REACH = {S.Zero: delta / 2, S.One: delta / 4 - gamma / 8}
"""The virtual damping up to which the region reaches the line, for each delay."""


@cache
def right_of_the_line(delay: Expr) -> Theorem:
    """Every stable wall of a damped device lies to the right of the line alpha = -gamma."""
    late = Relation(d, "=", delay)
    static, pushed = at_rest()
    loop = by_zeros(OTHER, beta, gamma, delta, delay)
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
    """With little virtual damping, the wall STEP to the right of the line is stable."""
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
    return _placed(closed(conjunct(passive_is_stable(), STABLE), margins, counted), reach)


def _between(reach: Expr) -> tuple[Proposition, ...]:
    """-y <= beta <= y."""
    return tuple(map(proposition, (-reach <= beta, beta <= reach)))


def _turns(angle: Expr) -> tuple[Theorem, ...]:
    """0 <= 1 - cos(angle) and 0 <= 1 + cos(angle)."""
    sides = 1 - cos(angle), 1 + cos(angle)
    return tuple(show(side >= 0, square(side), bounded(cos, angle)) for side in sides)


def _placed(stable: Theorem, reach: Expr) -> Theorem:
    """A stable wall at alpha = -gamma + STEP, for every x and every beta up to the reach."""
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
    """Under SOFT, stable walls lie to the right of the line and come arbitrarily close to it."""
    cases = (conj(right_of_the_line(d_), near_the_line(d_)) for d_ in (S.Zero, S.One))
    return disj_cases(assume(SOFT), *cases)


# -- arms of (23) without delay --------------------------------------------------------

NEAR = Rational(1, 100)
"""Walls within this distance of the line are stable without delay."""
SHORT = NEAR * x / (NEAR + 2 * x)
"""A number less than x and NEAR/2."""


@cache
def bound_of_arms() -> Theorem:
    """The conclusion of s4d-left-bound, under its hypotheses."""
    place = sp.Symbol("q")
    right = show(alpha < place, inst(figure9.right_of_the_line(), {alpha: place}), LINE)
    right = inst(right, {place: OTHER})
    right = for_all((OTHER, beta, d), [whole(d), STABLE.at({alpha: OTHER})], right)
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
