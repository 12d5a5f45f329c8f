r"""Where is a relation in words not the one that is meant?

A delay that is called positive and may be zero, a number that is compared with an interval, a
stiffness that is called a frequency: each is held against the formula that it stands for.
"""

from sympy import Eq, Rational, S, pi, sqrt

from symhaptic.notation import T, delta, gamma, t_d
from symhaptic.proof.sign import assume, combined

END = Rational(1, 50)
"""Largest delta of (23)."""


def derive(page):
    page.say("No delay is a case that the paper treats: a delay is not negative, not positive.")
    none = {t_d: S.Zero}
    page.settle(
        "s2c-positive-delay",
        page.same("no delay", (t_d / T).subs(none), S.Zero),
        corrected=(r"t_d\ge0\ \text{is not negative}",),
        unless=none,
        truth=t_d > 0,
        shows=r"$t_d=0$, and so $d=0$, as in Fig. 7",
    )
    interval(page)
    frequency(page)


def interval(page):
    page.say(
        "A number is not below an interval. (30) is $\\gamma\\le\\pi^2+\\frac14\\delta^2$, and it "
        "is the right side that lies in the interval. Neither end of it will do for every "
        "$\\delta$."
    )
    rise, low, high = delta**2 / 4, assume(delta, False), assume(END - delta, False)
    end = page.step(
        "At the end of the range",
        rise.subs(delta, END),
        Rational("0.0001"),
        name=r"\tfrac14\delta^2\big|_{\delta=0.02}",
    )
    page.positive(
        "Within the range",
        combined(end - rise, [Rational(1, 4), high, low], [END / 4, high]),
        on=r"0\le\delta\le0.02",
        name=r"0.0001-\tfrac14\delta^2",
    )
    page.settle(
        "s5c-interval",
        page.same("the end", rise.subs(delta, END), end),
        corrected=(r"\gamma\le\pi^2+\tfrac14\delta^2\in[\pi^2,\,\pi^2+0.0001]",),
        unless={delta: S.Zero, gamma: pi**2 + end},
        truth=gamma - rise <= pi**2,
        shows=r"$\delta=0$, $\gamma=\pi^2+0.0001$ is beyond (30)",
    )


def frequency(page):
    page.say(
        "The Nyquist frequency is $\\omega T=\\pi$. By (29) one stiffness reaches it, the last of "
        "the 41 in Fig. 13, and without damping this is $\\gamma=\\pi^2$: a stiffness, not the "
        "frequency."
    )
    turn = sqrt(gamma - delta**2 / 4)
    last = {gamma: pi**2 + delta**2 / 4}
    page.step(
        "The Nyquist frequency",
        turn.subs(last),
        pi,
        name=r"\omega T\big|_{\gamma=\pi^2+\delta^2/4}",
    )
    undamped = {gamma: pi**2, delta: S.Zero}
    page.settle(
        "s5c-nyquist-spring",
        page.same("without damping", turn.subs(undamped), pi),
        corrected=(r"\gamma=\pi^2,\ \text{where}\ \omega T=\pi",),
        unless=undamped,
        truth=Eq(turn, gamma),
        shows=r"there $\omega T=\pi$, and $\gamma=\pi^2$",
    )
