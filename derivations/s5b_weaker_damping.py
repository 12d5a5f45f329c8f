r"""Is the difference between passive and stable walls larger for smaller damping?

The passive region shrinks in proportion to $\delta$, the stable one hardly, says the paper. In
terms of the largest stiffness that asks whether $\alpha_{\max}/\delta$ falls as $\delta$ grows.
"""

from sympy import Rational, S, diff, latex, symbols, tan

from symhaptic.bounds.walls import DEVICE, STIFFNESS, most, over, passive
from symhaptic.model import boundary
from symhaptic.notation import d, delta, gamma, phi, t
from symhaptic.paper.ranges import IN_23, RANGES
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.enclosed import given
from symhaptic.proof.plants import BALLS, NUMBERS, SLOPES, named

GIVEN = named({s: s for s in (*NUMBERS, *SLOPES)})
LOW, HIGH, NEAR = Rational(1, 2), Rational(3, 2), Rational(11, 10)


def derive(page):
    page.say(
        "The largest passive stiffness is proportional to $\\delta$. Without delay the largest "
        "stable one is known in closed form; with a dash for the derivative to $\\delta$:"
    )
    undelayed = boundary.largest_undelayed(DEVICE).subs(BALLS)
    facts = [
        page.positive(
            "No delay",
            box.positive(undelayed - delta * dash(undelayed), RANGES, GIVEN),
            IN_23,
            name=r"\alpha_{\max}-\delta\,\alpha_{\max}'",
            because="so $\\alpha_{\\max}/\\delta$ falls as $\\delta$ grows",
        )
    ]
    page.say(
        "With a delay it is the maximum of the explicit function (chapters before), over "
        "$\\varphi=(d+1)\\theta$ up to $\\frac{4\\pi}3$. For the whole delays of Fig. 11 the "
        "maximum lies between $\\varphi=\\frac12$ and $\\frac32$, as outside the curve is below "
        "its value at $1.1$; and between, $\\alpha/\\delta$ falls at each angle:"
    )
    for delay in (1, 2, 4, 8):
        curve = STIFFNESS.subs(t, tan(phi / (2 * (delay + 1)))).subs(BALLS)
        below = curve.subs(phi, NEAR) - curve
        for side in ((S.Zero, LOW), (HIGH, Rational(42, 10))):
            fact = box.positive(below, {**RANGES, phi: side}, GIVEN)
            on = rf"{latex(side[0])}\le\varphi\le{latex(side[1])},\ " + IN_23
            name = r"\alpha|_{\varphi=1.1}-\alpha"
            facts.append(page.positive(f"$d={delay}$, lower there", fact, on, name=name))
        falls = box.positive(curve - delta * dash(curve), {**RANGES, phi: (LOW, HIGH)}, GIVEN)
        page.positive(
            f"$d={delay}$",
            falls,
            r"\tfrac12\le\varphi\le\tfrac32,\ " + IN_23,
            name=r"\alpha-\delta\,\alpha'",
        )
        facts.append(falls)
    page.say("For long delays it is the other way around. At $d=200$ without a spring:")
    one, two = symbols("eta_1 eta_2")
    known = {
        name: over(passive(damping, 200), most(S.Zero, damping, 200))
        for name, damping in ((one, Rational(1, 100)), (two, Rational(1, 50)))
    }
    page.enclosed(
        "Passive over stable stiffness",
        [(r"\eta|_{\delta=0.01}", known[one]), (r"\eta|_{\delta=0.02}", known[two])],
    )
    closer = box.positive(one - two, {}, Known(given(known)))
    page.settle(
        "s5a-smaller-delta",
        *facts,
        provided=r"d\in\{0,1,2,4,8\}\ \text{and (23), in terms of the stiffness}",
        unless={d: S(200), gamma: S.Zero, delta: Rational(1, 100)},
        truth=(two - one > 0, closer),
        shows=r"at $d=200$ the two stiffnesses differ by 0.4\% for $\delta=0.01$ and by 1.4\% for "
        r"$0.02$",
    )


def dash(expr):
    """The derivative with respect to delta."""
    return sum(diff(expr, s) * slope for s, slope in zip(NUMBERS, SLOPES, strict=True))
