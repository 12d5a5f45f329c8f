r"""Is a passive wall stable, whatever the delay?

Passivity looks at energy, stability at roots. Both conditions have the delay in them, but at a
root on the unit circle it drops out of the comparison, and the device alone decides.
"""

from sympy import Ne, Rational, S, cos, pi

from symhaptic.book.lemmas.passive_is_stable import (
    DEVICE,
    MARGIN,
    no_crossing,
    passive_is_stable,
)
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.notation import F, alpha, beta, d, delta, gamma, omega, p_k, theta, v, x, z
from symhaptic.notation.proposition import Relation
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE, passive
from symhaptic.proof.theorems.definitions import loop_substituted
from symhaptic.proof.theorems.energy import held_steady_state
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import assume, cut, part, weakened, whole
from symhaptic.proof.theorems.leaves import (
    bounded,
    combined,
    identity,
    number,
    root_outside,
    square,
)
from symhaptic.proof.theorems.roots import zero_beyond, zero_on_circle
from symhaptic.proof.theorems.tactics import (
    at,
    closed,
    counterexample,
    denied_by,
    example,
    fact,
    for_all,
    positive,
    sine_of_half,
)

HALF = S.Half


def derive(page):
    page.say(
        "In units of mass and period let $P=N/A$ be the sampled device and $W(z)$ the wall with "
        "its delay. A root of the loop has $1+PW=0$, so there the wall is $W=-1/P$, and the margin "
        "of passivity, $\\delta+\\Re\\{W/(z-1)\\}$, becomes $\\delta-\\Re\\{1/((z-1)P)\\}$: delay, "
        "$\\alpha$ and $\\beta$ have dropped out. Let a held force $F$ drive the device in a "
        "steady state that turns by $z=e^{j\\theta}$ per period."
    )
    page.step(
        "Work is stored or burnt",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because="Newton's law is $\\dot v=F-\\delta v-\\gamma x$, and $\\dot x=v$",
    )
    page.step(
        "A given way costs the damper least at constant speed",
        v**2,
        (v - p_k) ** 2 + 2 * v * p_k - p_k**2,
        because="over one period the last two terms integrate to $p_k^2$",
    )
    page.lemma(
        "A held force that turns by $z$ does more work than the way alone would burn",
        held_steady_state(assume(DEVICE), theta),
        because="the stored energy is the same after each period, and the speed is not constant "
        "where $z\\ne1$",
    )
    page.say(
        "Now take a wall that meets (5) and turn it up from nothing to $yW$, $0<y\\le1$. A root "
        "of the loop at $e^{j\\theta}$ would make the sum of the surplus above and of the margin, "
        "both not negative and one of them positive, equal to zero."
    )
    page.lemma("No root crosses the circle while the wall is turned up", no_crossing())
    page.lemma(
        "A wall with a margin at every angle is stable with every spring and damper",
        passive_is_stable(),
        because="zeros are continuous in the coefficients. Without a wall those of a damped and "
        "held device lie inside; without a spring one lies at 1, and the first stiffness moves it "
        "inwards",
        boxed=True,
    )
    _subset(page)
    _robust(page)
    _scaled(page)


def _margins(below):
    """The margin at every angle, from (5) at every frequency."""
    met = at(assume(below), {omega: theta}, *map(assume, INSIDE))
    found = closed(positive(MARGIN >= 0, [met]), *_divisors(theta))
    return for_all([theta], INSIDE, found)


def _divisors(angle):
    half = sine_of_half(angle)
    apart = positive(Ne(2 - 2 * cos(angle), 0), [4, half, half])
    return apart, closed(positive(half.conclusion, [half])) and _not_zero(half)


def _not_zero(theorem):
    return positive(Ne(theorem.conclusion.right, 0), [theorem])


def _met(point, *products):
    """(5) at every frequency for the wall of a point."""
    frequencies = passive().at(point)
    given, relation = frequencies.body.of
    found = closed(combined(relation, *products), *_divisors(omega))
    return for_all([omega], given.of, found)


def _subset(page):
    claim = CLAIMED["s5a-subset"](())
    symbols, given, _ = taken_apart(claim)
    extra = [delta > 0, alpha + gamma > 0, whole(d)]
    found = cut(part(passive_is_stable(), STABLE), _margins(given[-1]))
    theorem = for_all(symbols, [*given, *extra], weakened(found, *given))

    def loop(point, share, **parts):
        values = [point[s] for s in (alpha, beta, gamma, delta, d)]
        found = loop_substituted(values, z, share, **parts)
        return closed(found, fact(whole(share * point[d]))), found.conclusion.of[1].of[0]

    easy = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S.One, d: S.Zero}
    little = Rational(1, 100)
    late = easy | {beta: little, delta: 1 + 3 * little, d: HALF}
    equal, zeros = loop(late, 2, stiffness=False)
    slow, fast = cos(omega / 2), cos(3 * omega / 2)
    sums = [HALF, square(1 - slow)], [HALF, bounded(cos, omega / 2)]
    sums += [little / 2, square(1 + fast)], [little / 2, bounded(cos, 3 * omega / 2)]
    broken = denied_by(equal, root_outside(zeros, z))
    pulled = easy | {alpha: -HALF}
    equal, zeros = loop(pulled, 1, stiffness=False)
    falls = denied_by(equal, zero_beyond(zeros, z, number(Relation(zeros.subs(z, 1), "<", S.Zero))))
    swing = easy | {alpha: -HALF, gamma: 4 * pi**2, delta: S.Zero}
    equal, zeros = loop(swing, 1, damping=False)
    swings = denied_by(equal, zero_on_circle(zeros, z, S.Zero, identity(zeros.subs(z, 1), 0)))
    page.say(
        "Each condition is needed. A delay of half a period turns (18) into a polynomial in "
        "$\\sqrt z$ by the paper's substitution, with roots on its second sheet; a wall that "
        "pulls more than the spring holds runs away; and without a damper a spring with "
        "$\\gamma=4\\pi^2$ swings once per period, unseen."
    )
    page.settle(
        "s5a-subset",
        theorem,
        example=example(easy, [*given, *extra], _met(easy, [HALF])),
        unless=[
            counterexample(
                claim,
                pulled,
                *(_met(pulled, [Rational(5, 4)]), falls),
                holds=[delta > 0, whole(d)],
                but=alpha + gamma > 0,
            ),
            counterexample(
                claim,
                swing,
                *(_met(swing, [Rational(1, 4)]), swings),
                holds=[alpha + gamma > 0, whole(d)],
                but=delta > 0,
            ),
            counterexample(
                claim,
                late,
                *(_met(late, *sums, [2 * little]), broken),
                holds=[delta > 0, alpha + gamma > 0],
                but=whole(d),
            ),
        ],
        shows=r"a pulling wall without a spring satisfies (5), but $p_1(1)<0$",
        note="by the energy of the steady state, for all $\\gamma\\ge0$ together; a pulling wall "
        "is included as long as the spring holds it",
    )


def _robust(page):
    pass


def _scaled(page):
    pass
