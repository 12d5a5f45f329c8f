"""What is the largest stiffness that can be passive?

The largest passive stiffness belongs to the rightmost point of the boundary. At this point the
coefficient of the virtual damping in the condition vanishes. This gives the frequency and the
wall.
"""

from symhaptic.book.lemmas.motions import half_late, not_passive
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import TURN, bound, largest_of, stiffest_wall, waves


def derive(page):
    need = passivity.dirichlet_form()
    page.say(
        r"By \chapter{s3a_passivity_condition} a wall is passive if "
        r"$b>\frac{KT\sin(d+\frac12)\theta}{2\sin\frac\theta2}-B\cos(d+1)\theta$ at every angle "
        r"$\theta=\omega T$. The right side is the required damping $b_{\min}$, and "
        r"$b-b_{\min}$ is the margin."
    )
    page.step(
        "The coefficient of the virtual damping is a cosine",
        diff(need, B),
        -cos((d + 1) * theta),
        name=r"\partial b_{\min}/\partial B",
    )
    angle = pi / (2 * (d + 1))
    page.step(
        "The coefficient of $B$ vanishes first at $\\theta=\\pi/(2(d+1))$",
        cos((d + 1) * angle),
        S.Zero,
        name=r"\cos(d+1)\theta\,|_{\theta=\pi/(2(d+1))}",
        because=r"the next zeros lie beyond $\pi/(d+1)$, where the condition is redundant",
    )
    _frequency(page, Eq(omega, angle / T))
    left = b - need.subs(theta, angle)
    largest = -left.subs(K, 0) / diff(left, K)
    stiffness = page.step(
        r"At $\theta=\pi/(2(d+1))$ the condition limits only the stiffness",
        largest,
        2 * b / T * tan(pi / (4 * (d + 1))),
        name=K,
        because="at this angle the condition does not contain the virtual damping",
        boxed=True,
        paper="11",
    )
    on_curve = [e.subs(theta, angle) for e in passivity.envelope()]
    page.step(
        "The passive wall of maximum stiffness lies on the envelope",
        on_curve[0] - stiffness,
        S.Zero,
        name=r"K\big|_{\text{(7)}}-K",
        because=r"at the angle $\theta=\pi/(2(d+1))$, (7) gives the stiffness of the previous "
        "step",
    )
    damping = page.step(
        "The wall of maximum stiffness has this damping",
        on_curve[1],
        b * (cos(angle) - d / (d + 1)) / sin(angle),
        name=B,
        paper="11",
        because=r"by \chapter{s3b_rise} the stiffness of the envelope rises up to this frequency "
        "and falls beyond it, for every real $d>0$",
    )
    _stiffest(page, Eq(K, stiffness), Eq(B, damping))
    page.say(
        "Without delay the largest stiffness is $2b/T$. With a delay, a fraction of this "
        "stiffness remains:"
    )
    share = stiffness / stiffness.subs(d, 0)
    one = page.step(
        r"One period of delay leaves 41\,\% of the stiffness",
        share.subs(d, 1),
        sqrt(2) - 1,
        name=r"K_{\max}(1)/K_{\max}(0)",
    )
    two = page.step(
        r"Two periods of delay leave 27\,\% of the stiffness",
        share.subs(d, 2),
        2 - sqrt(3),
        name=r"K_{\max}(2)/K_{\max}(0)",
    )
    for id, delay, value in (("s3c-kmax-41", 1, one), ("s3c-kmax-27", 2, two)):
        claim = page.claim(id)
        found = ratio(claim, PRINTED, delay)
        page.settle(id, found, example=case(claim, PRINTED, delay), enclosed=True, value=value)


PRINTED = STATEMENTS["eq11"].printed


def _frequency(page, derived):
    """At the first frequency where the coefficient of B vanishes, (11) meets (5) with equality."""
    [printed] = STATEMENTS["s3c-kmax-frequency"].printed
    then = taken_apart(CLAIMED["s3c-kmax-frequency"]((printed,)))[2]
    found = first_without_damping(printed, then)
    page.settle(
        "s3c-kmax-frequency",
        found,
        derived,
        example={T: S.One, d: S.Zero, omega: pi / 2},
        note="for $d=0$, every frequency gives this point, which is then a corner. In the "
        "formula of the paper the denominator is the whole product after the slash",
    )


def _stiffest(page, *derived):
    """With an integer delay the wall of (11) is passive, and no passive wall is stiffer."""
    page.lemma(
        "No passive wall is stiffer than (11)",
        bound(),
        because=r"by \chapter{s3a_passivity_condition} the margin of a passive wall is not "
        r"negative at $\theta=\pi/(2(d+1))$. At this angle $\cos(d+1)\theta=0$ and "
        r"$\sin(d+\frac12)\theta=\cos\frac\theta2$, so $b\ge\frac12KT\cot\frac\theta2$",
    )
    _, given, then = taken_apart(CLAIMED["eq11"](PRINTED))
    found = page.lemma(
        "The wall of (11) is passive and has the maximum stiffness",
        stiffest_wall(*map(assume, given[-2:])),
        because=r"by \chapter{s3b_rise} the stiffness of the envelope is smaller on either side of "
        r"this angle. So the margin of this wall, divided by $\cos(d+1)\theta$, changes from plus "
        "to minus at this angle, and the margin itself is not negative. The same chapter shows "
        "this for larger angles. By the previous step no passive wall is stiffer",
        boxed=True,
    )
    at_half = {d: S.Half, T: S.One, b: S.One}
    wall = at_half | {line.lhs: line.rhs.subs(at_half) for line in PRINTED}
    page.settle(
        "eq11",
        found,
        *derived,
        example={d: S.Zero, T: S.One, b: S.One, K: S(2), B: S.Zero},
        unless={whole(d): (wall, not_passive(then, wall, half_late(Rational(17, 10))))},
        shows="with a delay of half a period, this wall delivers energy in 60 periods",
        note="for every real $d$, (11) is the largest stiffness that satisfies (5)",
    )


# Ratio of the largest passive stiffness with a delay to that without, for b > 0 and T > 0.


def both_sides(stiffness: Expr, delay: int, printed: Any, known: Any) -> tuple[Theorem, ...]:
    """The largest stiffness is at most, and at least, that of (11)."""
    there_is, others = known
    passive, bound, value = largest_of(printed, delay)
    below = choose(assume(there_is), inst(bound, {K: stiffness}))
    wall = passive.conclusion.of
    above = at(assume(others), {w: wall[0], B: wall[1]}, passive)
    return positive(stiffness <= value, [below]), positive(value <= stiffness, [above]), value


def ratio(claim: Proposition, printed: Any, delay: int) -> Theorem:
    """The bounds on y/x in a claim."""
    _, given, then = taken_apart(claim)
    first = both_sides(x, 0, printed, given[2:4])
    other = both_sides(y, delay, printed, given[4:])
    period = over(1 / T > 0, one(), T > 0)
    size = positive(x > 0, [first[1]], [2, period, b > 0])
    bounds = []
    for relation in conjuncts(then):
        lower = not relation.left.free_symbols
        limit = relation.left if lower else relation.right
        way = 1 if lower else -1
        rest = number(Relation(S.Zero, "<", _per_damping(way * (other[2] - limit * first[2]))))
        known = [[other[lower]], [limit, first[not lower]], [rest, period, b > 0]]
        part = positive(way * (y - limit * x) > 0, *known)
        bounds.append(over(relation, part, size))
    apart = not_zero(size), not_zero(assume(T > 0))
    found = closed(conj(*bounds) if len(bounds) > 1 else bounds[0], *apart, *apart)
    found = closed(found, positive(b >= 0, b > 0))
    return as_claimed(claim, found)


def _per_damping(stiffness: Expr) -> Expr:
    """A stiffness in units of b/T."""
    return stiffness.subs({b: 1, T: 1})


def case(claim: Proposition, printed: Any, delay: int) -> Case:
    """The walls of (11) for b = T = 1, which meet all hypotheses of the claim."""
    given = taken_apart(claim)[1]
    unit: dict[Symbol, Expr] = {b: S.One, T: S.One}
    walls = [largest_of(printed, late) for late in (0, delay)]
    point = unit | {s: wall[2].xreplace(unit) for s, wall in zip((x, y), walls, strict=True)}
    known: list[Theorem] = []
    for (there_is, others), wall in zip((given[2:4], given[4:]), walls, strict=True):
        passive, bound = (inst(t, unit) for t in wall[:2])
        passive, bound = (closed(t, *_numbers(t)) for t in (passive, inst(bound, {K: w})))
        known.append(exists(passive, there_is.at(point), {B: passive.conclusion.of[1]}))
        goal, some = others.at(point), others.at(point).body.of[0]
        least = positive(goal.body.of[1], [bound])
        known.append(for_all([w, B], [some], least))
    return example(point, given, *known)


def _numbers(theorem: Theorem) -> list[Theorem]:
    """Prove the hypotheses that contain no symbols."""
    return [fact(claim) for claim in theorem.hypotheses if not claim.free]


# The lowest frequency at which the coefficient of B vanishes, that of the stiffest wall.


def first_without_damping(equation: Any, claim: Any) -> Theorem:
    """The claim at omega = pi/(2 T (d+1))."""
    at = equation.rhs
    low, high, none, first, touched = claim.at({omega: at}).of
    here = waves()
    above, below = here.show(low), here.show(high)
    nothing = identity(none.left, none.right)
    before = here.and_(x > 0, x < at)
    before.have((d + 1) * T * x < pi / 2, degree=3)
    wave = before.show(cos((d + 1) * T * x) > 0, degree=3)
    before.have(T * x < pi, degree=3)
    goal = show(first.body.of[1], wave)
    first = for_all([x], first.body.of[0].of, before.closed(goal, sine_of_half(T * x)))
    stiffness, need = touched.body.of[0].of[-1], touched.body.of[1]
    met = show(need, stiffness)
    met = for_all(touched.over, touched.body.of[0].of, add_assum(met, b >= 0))
    everything = conj(above, below, nothing, first, met)
    found = subst(claim, omega, everything, show(Eq(at, omega), equation))
    level = here.show(2 - 2 * cos(2 * TURN) > 0)
    return here.closed(found, level)
