r"""Does a larger delay always make the stable region smaller?

A delay costs stiffness: a wall without damping bears less and less of it. But where a spring holds
the device, the boundary begins lower with every period of delay, so that there are walls which only
a delay makes stable.
"""

from sympy import Rational, S, diff

from symhaptic.model import loop
from symhaptic.notation import a, alpha, beta, d, delta, e, gamma, n_0, n_1, z


def derive(page):
    p = loop.named()
    page.say(
        "The explicit boundary begins on the line $\\alpha=-\\gamma$, with a double root at 1. "
        "There $p_1(1)=0$, and the derivative vanishes too; with $1-a+e=\\gamma(n_1+n_0)$:"
    )
    corner = page.define(
        "Where the boundary begins",
        r"\beta_0",
        -(1 - e) / (n_1 + n_0) - gamma * (d + 1 - n_1 / (n_1 + n_0)),
    )
    slope = diff(p, z).subs(z, 1).subs({alpha: -gamma, beta: corner})
    trace = 1 + e - gamma * (n_1 + n_0)
    page.step(
        "A double root there",
        slope.subs(a, trace),
        S.Zero,
        name=r"\frac{dp_1}{dz}(1)\Big|_{\alpha=-\gamma,\ \beta=\beta_0}",
    )
    page.step(
        "One more period of delay",
        corner.subs(d, d + 1) - corner,
        -gamma,
        name=r"\beta_0\big|_{d+1}-\beta_0\big|_d",
        because="downwards by the spring's stiffness, for every plant",
    )
    wall = {
        alpha: Rational(-9, 10000),
        beta: Rational(-11, 1000),
        gamma: Rational(1, 1000),
        delta: Rational(1, 100),
    }
    page.say(
        "Where the region reaches this point, it is its lower left corner, and a wall just above "
        "that of $d=1$ is below that of $d=0$. Inside the "
        "paper's ranges (23), $\\gamma=0.001$, $\\delta=0.01$, $\\alpha=-0.0009$, $\\beta=-0.011$:"
    )
    page.inside("One period of delay", p, {**wall, d: S.One}, loop.numbers())
    undelayed = {**wall, d: S.Zero}
    witness = page.outside("No delay", p, undelayed, loop.numbers())
    page.say(
        "Stiffnesses above zero are met too, once the delay is long enough to turn the spring's "
        "own oscillation: at $\\gamma=0.001$, $\\delta=0.02$ the wall $\\alpha=0.0001$, "
        "$\\beta=-0.022$."
    )
    stiff = {**wall, alpha: Rational(1, 10000), beta: Rational(-11, 500), delta: Rational(1, 50)}
    page.inside("Forty periods of delay", p, {**stiff, d: S(40)}, loop.numbers())
    page.outside("No delay, the same wall", p, {**stiff, d: S.Zero}, loop.numbers())
    page.settle(
        "s4d-delay-shrinks",
        page.same("the corner", corner.subs(d, d + 1) - corner, -gamma),
        corrected=(r"\text{the explicit boundary begins}\ \gamma\ \text{lower with every period}",),
        misprint=False,
        unless=undelayed,
        truth=witness,
        shows="a wall inside (23) that is stable at $d=1$ and unstable at $d=0$",
    )
