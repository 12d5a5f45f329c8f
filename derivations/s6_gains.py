"""What is the benefit of faster sampling and of more mass?

The paper concludes that much faster sampling has little benefit if the delay dominates, and that
more mass has no benefit. For faster sampling we keep the delay $t_d=dT$ constant while $T$
decreases.
"""

from symhaptic.book.lemmas.faster import SLOW, SOON, farthest, gained, much, not_slow, slow
from symhaptic.book.lemmas.passive_tip import passive_wall
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import TURN, bound, waves
from symhaptic.model import wall
from symhaptic.paper.propositions.conclusion import FASTER
from symhaptic.paper.propositions.passivity import PASSIVE
from symhaptic.proof.theorems.analysis import grows


def derive(page):
    passive(page)
    settled(page)
    heavier(page)


def passive(page):
    """The largest passive stiffness for a given delay in seconds."""
    stiffness = 2 * b / T * tan(pi / (4 * (d + 1)))
    scaled = page.step(
        "With $T=t_d/d$ the stiffness (11) is inversely proportional to the delay",
        (stiffness * t_d / b).subs(T, t_d / d),
        2 * d * tan(pi / (4 * (d + 1))),
        name=r"K_{\max}t_d/b",
    )
    page.say("We write (11) with $h=1/(d+1)$:")
    page.limit(
        r"For $T\to0$ the passive limit $K_{\max}t_d/b$ tends to $\pi/2$",
        scaled.subs(d, 1 / h - 1),
        h,
        S.Zero,
        pi / 2,
        name=r"K_{\max}t_d/b",
        because="",
    )
    page.state(
        "faster-sampling",
        r"if the rate is $q$ times as high and the delay stays $d\ge1$ old periods, every passive "
        r"wall has at most $1+\frac1d$ times the stiffness of some wall that is passive at the old "
        "rate",
        claim=claim(),
    )
    symbols = taken_apart(claim())[0]
    ones = dict.fromkeys(symbols, S.One)
    page.settle(
        "faster-sampling",
        gains_little(),
        example=(ones, fact(whole(S.One))),
        note="the statement holds for every device, integer delay and integer ratio of rates, "
        r"because $\tan x/x$ increases with $x$, the angle in (11)",
    )


def settled(page):
    """Settle faster sampling, for a delay of one period and of ten."""
    page.say(
        "For stable walls no such bound is shown for all delays. We call a gain significant if "
        "it is at least a quarter. At ten periods of delay we check every integer ratio of rates "
        "up to ten, for a free mass and for the arm of Figs. 11 and 12. A stable wall near the "
        "tip is a lower bound of the largest stiffness at the old rate. A bound on all stable "
        "walls is an upper bound at the new rate:"
    )
    page.lemma(
        "With a delay of a hundred periods the stable walls of a free mass have "
        r"$\alpha<0.000053896$",
        farthest(),
    )
    then = taken_apart(page.claim("s6-faster-sampling"))[2]
    point = {gamma: S.Zero, delta: S.Zero, d: S(10), FASTER: S.One}
    page.settle(
        "s6-faster-sampling",
        gained(),
        example=(point, slow(point)),
        unless={SLOW: (SOON, much(then.at(SOON)), not_slow())},
        shows=r"at $d=1$, where the delay is twice the half period of the hold, sampling a hundred "
        r"times as fast gives a free mass more than 3.7 times the stable stiffness",
        note="the statement holds for integer delays and ratios of rates, if a quarter is a "
        "significant gain. The largest passive stiffness of every device grows by a factor of "
        r"at most $1+1/d$ (\texttt{faster-sampling}). For stable walls other delays are undecided",
    )


def heavier(page):
    """The mass and the stiffness are multiplied by the same factor."""
    device = plant.sampled(plant.Plant(), T)
    physical = device.denominator + device.numerator * wall.delayed()
    grown = {m: 2 * m, K: 2 * K, B: 2 * B, b: 2 * b, k: 2 * k}
    page.same("the same loop", physical.xreplace(grown), physical)
    page.say(
        "Double the mass, spring and damper of the device, and the stiffness and damping of the "
        "wall. The polynomial $p(z)$ of the loop does not change. So the roots, every motion, "
        "and the ratio $K/m$ stay the same."
    )


# The largest passive stiffness at a higher rate and the same delay in seconds.
#
# By (11) this stiffness is 2 b/T tan(pi/(4 (d+1))), and tan(x)/x rises with x.

u, v, w = symbols("u v w")


@cache
def above_the_sine() -> Theorem:
    """sin v cos v < v for 0 < v < pi/2."""
    rest = w - sin(w) * cos(w)
    here = Given(w > 0, w < v, v < pi / 2)
    sine = here.show(sin(w) > 0)
    return show(
        v - sin(v) * cos(v) > 0,
        grows(rest, w, S.Zero, v, here.closed(positive(derivative(rest, w) > 0, [2, sine, sine]))),
    )


@cache
def tangent_over_angle() -> Theorem:
    """w tan w' > w' tan w for the angles 0 < w < w' < pi/2; w' is written u."""
    quotient = sin(v) / (v * cos(v))
    here = Given(w > 0, w < u, u < pi / 2)
    between = Given(w > 0, w < v, v < u, u < pi / 2)
    slope_ = over(derivative(quotient, v) > 0, above_the_sine(), v**2 * cos(v) ** 2 > 0)
    inside = between.closed(slope_), *between.defined(quotient)
    rise = here.closed(grows(quotient, v, w, u, *inside))
    return here.show(w * sin(u) / cos(u) - u * sin(w) / cos(w) > 0, rise, degree=3)


LATER = FASTER * d
"""The delay in periods of the higher rate."""


def claim() -> Proposition:
    """At q times the rate, a passive wall is at most 1 + 1/d times as stiff as some passive one.

    The delay in seconds is the same, d periods of the lower rate; d and q are integers, 1 <= d.
    """
    best, others = PASSIVE.at({K: x, B: y}), PASSIVE.at({T: T / FASTER, d: LATER})
    rest = ForAll((K, B), implied([others], (1 + 1 / d) * x >= K))
    given = [T > 0, b >= 0, whole(d), d >= 1, whole(FASTER), FASTER >= 1]
    return ForAll((b, T, d, FASTER), implied(given, Exists((x, y), both([best, rest]))))


@cache
def weakly() -> Theorem:
    """0 <= w tan u - u tan w for 0 < w <= u < pi/2."""
    goal = w * sin(u) / cos(u) - u * sin(w) / cos(w)
    equal = both_ways(assume(w <= u), assume(u <= w))
    place = Symbol("t")
    same = number(Relation(S.Zero, "<=", S.Zero))
    turned = subst(goal.xreplace({w: place}) >= 0, place, same, show(Eq(u, w), equal))
    found = disj_cases(ordered(w, u), show(goal >= 0, tangent_over_angle()), turned)
    return Given(w > 0, w <= u, u < pi / 2).closed(found)


@cache
def gains_little() -> Theorem:
    """:func:`claim`, by (11) for both rates."""
    some = taken_apart(claim())[2]
    best = passive_wall()
    stiffness, damping = best.conclusion.of[:2]
    later = {T: T / FASTER, d: LATER}
    small, large = TURN.xreplace({d: LATER}), TURN
    here = waves(T > 0, d >= 1, FASTER >= 1, whole(d), whole(FASTER), b >= 0)
    here.have(FASTER > 0)
    here.have(LATER + 1 > 0)
    ratio = here.closed(
        inst(weakly(), {w: small, u: large}), here.show(large - small >= 0), degree=3
    )
    softer = inst(bound(), later)
    period, share, factor_, tangent = map(
        here.show,
        (
            1 / T > 0,
            (d + 1) / (d * (LATER + 1)) > 0,
            4 * (d + 1) * FASTER / pi > 0,
            sin(large) / cos(large) > 0,
        ),
    )
    room = positive(
        (1 + 1 / d) * stiffness >= K,
        [2, assume(b >= 0), period, share, tangent],
        [2, assume(b >= 0), period, factor_, ratio],
        [softer],
    )
    others = some.body.of[1]
    values = {x: stiffness, y: damping}
    bare = for_all([K, B], [others.at(values).body.of[0]], here.closed(room))
    return as_claimed(claim(), here.closed(exists(conj(best, bare), some, values)))
