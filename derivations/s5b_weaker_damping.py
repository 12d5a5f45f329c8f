r"""Is the difference between passive and stable walls larger for smaller damping?

The passive region shrinks in proportion to $\delta$, the stable one hardly, says the paper. In
terms of the largest stiffness that asks whether $\alpha_{\max}/\delta$ falls as $\delta$ grows.
"""

from sympy import Rational, S, diff, symbols, tan

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.weaker_damping import FAR, SHORT, further, nearer, not_short
from symhaptic.bounds.walls import DEVICE, STIFFNESS, most, over, passive
from symhaptic.model import boundary
from symhaptic.notation import d, delta, gamma, phi, t
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.stability import HEAVIER
from symhaptic.paper.ranges import RANGES
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, NUMBERS, SLOPES, named
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import conjoined, weakened, widened
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.tactics import counterexample, example, for_all

GIVEN = named({s: s for s in (*NUMBERS, *SLOPES)})
LOW, HIGH, NEAR = Rational(1, 2), Rational(3, 2), Rational(11, 10)


def derive(page):
    page.say(
        "The largest passive stiffness is proportional to $\\delta$. Without delay the largest "
        "stable one is known in closed form, and "
        "$\\alpha_{\\max}/\\delta$ falls as $\\delta$ grows."
    )
    undelayed = boundary.largest_undelayed(DEVICE).subs(BALLS)
    box.positive(undelayed - delta * dash(undelayed), RANGES, GIVEN)
    page.say(
        "With a delay it is the maximum of the explicit function "
        "(\\chapter{s5b_stiffest_wall_bound}), over $\\varphi=(d+1)\\theta$ up to "
        "$\\frac{4\\pi}3$. For the whole delays of Fig. 11 the maximum lies between "
        "$\\varphi=\\frac12$ and $\\frac32$, as outside the curve is below its value at $1.1$; "
        "and between, $\\alpha/\\delta$ falls at each angle."
    )
    by_plant = STIFFNESS.subs(BALLS)
    slope = dash(by_plant)
    for delay in (1, 2, 4, 8):
        turn = {t: tan(phi / (2 * (delay + 1)))}
        curve, rise = by_plant.xreplace(turn), slope.xreplace(turn)
        below = curve.subs(phi, NEAR) - curve
        for side in ((S.Zero, LOW), (HIGH, Rational(42, 10))):
            box.positive(below, {**RANGES, phi: side}, GIVEN)
        box.positive(curve - delta * rise, {**RANGES, phi: (LOW, HIGH)}, GIVEN)
    page.state(
        "weaker-damping",
        r"for $d\in\{0,1,2,4,8\}$ and (23) $\alpha_{\max}/\delta$ falls as $\delta$ grows",
    )
    page.say("For long delays it is the other way around. At $d=200$ without a spring:")
    one, two = symbols("eta_1 eta_2")
    known = {
        name: over(passive(damping, 200), most(S.Zero, damping, 200))
        for name, damping in ((one, Rational(1, 100)), (two, Rational(1, 50)))
    }
    page.enclosed(
        "The share of the passive in the stable stiffness is enclosed",
        [(r"\eta|_{\delta=0.01}", known[one]), (r"\eta|_{\delta=0.02}", known[two])],
    )
    page.lemma(
        "At $d=200$, $\\delta=0.01$ the stable walls have $\\alpha<0.00007843$",
        none_above((FAR[gamma], FAR[delta]), 200)[1],
        because="by one point of the circle, as before",
    )
    claim = CLAIMED["s5a-smaller-delta"](())
    every, ranges, then = taken_apart(claim)
    point = {gamma: S.Zero, delta: Rational(1, 100), HEAVIER: Rational(1, 50), d: S.Zero}
    short = SHORT.at(point)
    undelayed = widened(conjoined(*(number(p) for p in short.of[0].of)), short)
    page.settle(
        "s5a-smaller-delta",
        for_all(every, [*ranges, SHORT], weakened(further(), *ranges)),
        example=example(point, [*ranges, SHORT], undelayed),
        unless=[counterexample(claim, FAR, nearer(then.at(FAR)), not_short(), but=SHORT)],
        shows=r"at $d=200$ the two stiffnesses differ by 0.4\% for $\delta=0.01$ and by 1.4\% for "
        r"$0.02$",
        note=r"in terms of the stiffness, and of whole delays; nearer dampings, and "
        r"$d\in\{2,4,8\}$, are a statement of their own",
    )


def dash(expr):
    """The derivative with respect to delta."""
    return sum(diff(expr, s) * slope for s, slope in zip(NUMBERS, SLOPES, strict=True))
