r"""Where is a relation in words not the one that is meant?

A delay that is called positive and may be zero, a number that is compared with an interval, a
stiffness that is called a frequency: each is held against the formula that it stands for.
"""

from sympy import Eq, Ne, Rational, S, pi, sqrt

from symhaptic.book.lemmas.slips import neither_end
from symhaptic.notation import T, delta, gamma, omega, omega_N, t_d
from symhaptic.notation.proposition import Relation
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.slips import (
    END,
    ENDS,
    NOT_NEGATIVE,
    spring_of_nyquist,
    within,
)
from symhaptic.proof.theorems.familiar import square
from symhaptic.proof.theorems.judge import Case, taken_apart
from symhaptic.proof.theorems.kernel import (
    assume,
    conjoined,
    substituted,
    weakened,
)
from symhaptic.proof.theorems.leaves import combined, identity
from symhaptic.proof.theorems.tactics import (
    closed,
    counterexample,
    either_way,
    example,
    fact,
    for_all,
    over,
    positive,
)


def derive(page):
    page.say("No delay is a case that the paper treats: a delay is not negative, not positive.")
    symbols, given, _ = taken_apart(NOT_NEGATIVE)
    none = {t_d: S.Zero, T: S.One}
    period = positive(Ne(T, 0), T > 0)
    page.settle(
        "s2c-positive-delay",
        for_all(symbols, given, closed(over(t_d / T >= 0, t_d >= 0, T > 0), period)),
        instead=NOT_NEGATIVE,
        example=example(none, given),
        unless=[denied(CLAIMED["s2c-positive-delay"](()), none)],
        shows=r"$t_d=0$, and so $d=0$, as in Fig. 7",
    )
    interval(page)
    frequency(page)


def denied(claim, values):
    """A point at which a relation is false that a claim concludes."""
    then = taken_apart(claim)[2].at(values)
    sign = {"<": "<=", "=": "!="}[then.sign]
    sides = (then.right, then.left) if then.sign == "<" else (then.left, then.right)
    return counterexample(claim, values, fact(Relation(sides[0], sign, sides[1])))


def interval(page):
    page.say(
        "A number is not below an interval. (30) is $\\gamma\\le\\pi^2+\\frac14\\delta^2$, and it "
        "is the right side that lies in the interval. Neither end of it will do for every "
        "$\\delta$."
    )
    page.step(
        "At the end of the range",
        (delta**2 / 4).subs(delta, END),
        Rational("0.0001"),
        name=r"\tfrac14\delta^2\big|_{\delta=0.02}",
    )
    meant = within()
    symbols, given, then = taken_apart(meant)
    same, low, high = then.of
    thirty, limit = same.of
    share = Rational(1, 4)
    both = either_way(positive(limit, [thirty]), positive(thirty, [limit]), thirty, limit)
    found = conjoined(
        both,
        combined(low, [share, square(delta)]),
        positive(high, [share, delta <= END, delta >= 0], [share * END, delta <= END]),
    )
    beyond = {gamma: ENDS[1], delta: S.Zero}
    page.settle(
        "s5c-interval",
        for_all(symbols, given, weakened(found, *given)),
        instead=meant,
        corrected=(r"\gamma\le\pi^2+\tfrac14\delta^2\in[\pi^2,\pi^2+0.0001]",),
        example=example(beyond, given),
        unless=[Case(beyond, neither_end())],
        shows=r"$\delta=0$, $\gamma=\pi^2+0.0001$ is beyond (30)",
    )


def frequency(page):
    page.say(
        "The Nyquist frequency is $\\omega T=\\pi$. By (29) one stiffness reaches it, the last of "
        "the 41 in Fig. 13, and without damping this is $\\gamma=\\pi^2$: a stiffness, not the "
        "frequency."
    )
    turn = sqrt(gamma - delta**2 / 4)
    page.step(
        "This spring makes the device swing with the Nyquist frequency",
        turn.subs(gamma, pi**2 + delta**2 / 4),
        pi,
        name=r"\omega T\big|_{\gamma=\pi^2+\delta^2/4}",
    )
    meant = spring_of_nyquist()
    symbols, given, then = taken_apart(meant)
    reached, spring = then.of
    law, period = assume(given[-1]), positive(Ne(T, 0), T > 0)
    root = combined(Eq(sqrt(gamma), pi), [assume(reached), 1], [law, -T])
    stiff = combined(spring, [root, sqrt(gamma) + pi])
    place = Relation(sqrt(delta), "=", pi)
    swings = substituted(
        place, delta, identity(sqrt(pi**2), pi), combined(Eq(pi**2, gamma), [assume(spring), -1])
    )
    fast = combined(reached, [swings, 1], [law, T])
    page.settle(
        "s5c-nyquist-spring",
        for_all(
            symbols,
            given,
            weakened(closed(either_way(stiff, fast, reached, spring), period), *given),
        ),
        instead=meant,
        example=example({T: S.One, omega: S.One, gamma: S.One}, given),
        unless=[denied(CLAIMED["s5c-nyquist-spring"](()), {T: S.One, omega_N: pi})],
        shows=r"there $\omega T=\pi$, and $\gamma=\pi^2$",
    )
