r"""What do faster sampling and more mass gain?

The conclusion of the paper: much faster sampling does not gain much where the delay outweighs it,
and more mass gains nothing. Here the delay $t_d=dT$ is kept while $T$ shrinks.
"""

from symhaptic.book.lemmas.faster import SLOW, SOON, farthest, gained, much, not_slow, slow
from symhaptic.book.lemmas.faster_passive import claim, gains_little
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import plant, wall
from symhaptic.paper.propositions.conclusion import FASTER


def derive(page):
    passive(page)
    settled(page)
    heavier(page)


def passive(page):
    """The passive stiffness for a given delay in seconds."""
    stiffness = 2 * b / T * tan(pi / (4 * (d + 1)))
    scaled = page.step(
        "With $T=t_d/d$ the stiffness (11) is a number over the delay",
        (stiffness * t_d / b).subs(T, t_d / d),
        2 * d * tan(pi / (4 * (d + 1))),
        name=r"K_{\max}t_d/b",
    )
    page.say("With $h=1/(d+1)$:")
    page.limit(
        "With endlessly fast sampling $K_{\\max}t_d/b$ tends to $\\pi/2$",
        scaled.subs(d, 1 / h - 1),
        h,
        S.Zero,
        pi / 2,
        name=r"K_{\max}t_d/b",
        because="",
    )
    page.state(
        "faster-sampling",
        "at $q$ times the rate and the same delay of $d\\ge1$ old periods, every passive wall has "
        "at most $1+\\frac1d$ times the stiffness of some wall that is passive at the old rate",
        claim=claim(),
    )
    symbols, given, _ = taken_apart(claim())
    ones = dict.fromkeys(symbols, S.One)
    page.settle(
        "faster-sampling",
        gains_little(),
        example=example(ones, given, fact(whole(S.One))),
        note="for every device, whole delay and whole rate, by (11) and since the tangent over "
        "its angle rises",
    )


def settled(page):
    """At one period of delay, and at ten."""
    page.say(
        "For stable walls no such bound is shown for all delays. What the paper calls significant "
        "is read as a quarter. At ten periods of delay each rate up to ten times is asked, by a "
        "wall next to the tip now and a bound next to the tip then, for a free mass and for the "
        "arm of Figs. 11 and 12:"
    )
    page.lemma(
        "A hundred periods late the stable walls of a free mass have $\\alpha<0.000053896$",
        farthest(),
    )
    stated = CLAIMED["s6-faster-sampling"](())
    symbols, ranges, then = taken_apart(stated)
    point = {gamma: S.Zero, delta: S.Zero, d: S(10), FASTER: S.One}
    page.settle(
        "s6-faster-sampling",
        for_all(symbols, [*ranges, SLOW], add_assum(gained(), *ranges)),
        example=example(point, [*ranges, SLOW], slow(point)),
        unless=[counterexample(stated, SOON, much(then.at(SOON)), not_slow(), but=SLOW)],
        shows=r"at $d=1$, where the delay is twice the half period of the hold, sampling a hundred "
        r"times as fast gives a free mass more than 3.7 times the stable stiffness",
        note=r"of whole delays and rates, in the reading that a quarter is significant; the "
        r"passive stiffness gains at most $1+1/d$, for every device (\texttt{faster-sampling}); "
        r"other delays are not settled for stable walls",
    )


def heavier(page):
    """More mass and equally more stiffness."""
    device = plant.sampled(plant.Plant(), T)
    physical = device.denominator + device.numerator * wall.delayed()
    grown = {m: 2 * m, K: 2 * K, B: 2 * B, b: 2 * b, k: 2 * k}
    page.same("the same loop", physical.xreplace(grown), physical)
    page.say(
        "With twice the mass, twice the spring and damper of the device and a wall twice as stiff "
        "and twice as damped, the polynomial $p(z)$ of the loop is the same. The roots, and with "
        "them every motion, stay as they are; so does $K/m$."
    )
