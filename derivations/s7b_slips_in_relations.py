r"""Which number lies in the interval of Sec. V-C?

The text bounds $\gamma$ by an interval of numbers. By (30) the bound is
$\pi^2+\frac14\delta^2$, and it is this number that lies in the interval.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.slips import neither_end
from symhaptic.paper.propositions.slips import END, ENDS, within


def derive(page):
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
    found = conj(
        both,
        combined(low, [share, square(delta)]),
        positive(high, [share, delta <= END, delta >= 0], [share * END, delta <= END]),
    )
    beyond = {gamma: ENDS[1], delta: S.Zero}
    page.settle(
        "s5c-interval",
        for_all(symbols, given, add_assum(found, *given)),
        instead=meant,
        corrected=(r"\gamma\le\pi^2+\tfrac14\delta^2\in[\pi^2,\pi^2+0.0001]",),
        example=example(beyond, given),
        unless=[Case(beyond, neither_end())],
        shows=r"$\delta=0$, $\gamma=\pi^2+0.0001$ is beyond (30)",
    )
