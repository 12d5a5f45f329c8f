r"""What do faster sampling and more mass gain?

The conclusion of the paper: much faster sampling does not gain much where the delay outweighs it,
and more mass gains nothing. Here the delay $t_d=dT$ is kept while $T$ shrinks.
"""

from sympy import Ne, Rational, S, cos, diff, pi, sin, tan

from symhaptic.book.lemmas.faster import SLOW, SOON, farthest, gained, much, not_slow, slow
from symhaptic.bounds import walls
from symhaptic.bounds.walls import most
from symhaptic.model import plant, wall
from symhaptic.notation import B, K, T, b, chi, d, delta, gamma, h, k, m, phi, psi, t_d
from symhaptic.notation.proposition import Relation
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.conclusion import FASTER
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.enclosed import given, value
from symhaptic.proof.roots import zero
from symhaptic.proof.theorems.analysis import grows
from symhaptic.proof.theorems.familiar import sign_of
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import weakened
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.theorems.tactics import (
    closed,
    counterexample,
    example,
    for_all,
    over,
    positive,
)

LONG = phi**2 * cos(phi)


def derive(page):
    passive(page)
    page.state(
        "faster-sampling",
        r"for a free mass and $d\ge10$ endlessly fast sampling gives at most $(1+1/d)^2$ times the "
        "stable stiffness",
    )
    stable(page)
    settled(page)
    heavier(page)


def settled(page):
    """At one period of delay, and at ten."""
    page.say(
        "What the paper calls significant is read as a quarter. Ten periods late, each rate up to "
        "ten times is asked, by a wall next to the tip now and a bound next to the tip then, for a "
        "free mass and for the arm of Figs. 11 and 12:"
    )
    page.lemma(
        "A hundred periods late the stable walls of a free mass have $\\alpha<0.000053896$",
        farthest(),
    )
    claim = CLAIMED["s6-faster-sampling"](())
    symbols, ranges, then = taken_apart(claim)
    point = {gamma: S.Zero, delta: S.Zero, d: S(10), FASTER: S.One}
    page.settle(
        "s6-faster-sampling",
        for_all(symbols, [*ranges, SLOW], weakened(gained(), *ranges)),
        example=example(point, [*ranges, SLOW], slow(point)),
        unless=[counterexample(claim, SOON, much(then.at(SOON)), not_slow(), but=SLOW)],
        shows=r"at $d=1$, where the delay is twice the half period of the hold, sampling a hundred "
        r"times as fast gives a free mass more than 3.7 times the stable stiffness",
        note=r"of whole delays and rates; longer delays are a statement of their own; at most "
        r"$1+1/d$ times the passive stiffness, of every device",
    )


def passive(page):
    """The passive stiffness for a given delay in seconds."""
    stiffness = 2 * b / T * tan(pi / (4 * (d + 1)))
    scaled = page.step(
        "With $T=t_d/d$ the stiffness (11) is a number over the delay",
        (stiffness * t_d / b).subs(T, t_d / d),
        2 * d * tan(pi / (4 * (d + 1))),
        name=r"K_{\max}t_d/b",
    )
    in_h = scaled.subs(d, 1 / h - 1)
    page.limit(
        "With endlessly fast sampling $K_{\\max}t_d/b$ tends to $\\pi/2$",
        in_h,
        h,
        S.Zero,
        pi / 2,
        name=r"K_{\max}t_d/b",
        because="",
    )
    page.say("with $h=1/(d+1)$. How much is missing at a finite rate?")
    page.lemma(
        "The tangent is above its angle for $0<\\psi<\\pi/2$",
        tangent(),
        because="so $Kt_d/b\\ge\\frac\\pi2\\frac d{d+1}$ with $\\psi=\\frac\\pi4h$: the gain is at "
        "most $1+\\frac1d$, for any device",
    )


def tangent():
    """Psi < tan(psi) for 0 < psi < pi/2."""
    up, chord = positive(psi > 0, psi > 0), sin(psi) - psi * cos(psi)
    quarter = number(Relation(S.Zero, "<", pi / 2))
    before = positive(chi < pi / 2, chi < psi, psi < pi / 2)
    sine = closed(sign_of(sin, chi), positive(chi < pi, [before], [quarter]))
    slope = positive(diff(chord, psi).subs(psi, chi) > 0, [chi > 0, sine])
    grown = grows(chord.subs(psi, chi), chi, S.Zero, psi, slope)
    cosine = closed(sign_of(cos, psi), positive(psi > -pi / 2, up, [quarter]))
    return closed(over(tan(psi) > psi, grown, cosine), positive(Ne(cos(psi), 0), [cosine]))


def stable(page):
    """The stable stiffness of a free mass, likewise."""
    page.say(
        "For a free mass $Kt_d^2/m=d^2\\alpha_{\\max}$. In \\chapter{s4d_free_mass_long_delay} "
        "$(d+1)^2\\alpha_{\\max}$ falls with the delay, to $\\varphi_*^2\\cos\\varphi_*$, which is "
        "what endlessly fast sampling gives. So the gain is at most $(1+\\frac1d)^2$: 21 % for "
        "$d=10$, and 10 % for the passive stiffness. With little delay it is more:"
    )
    angle = zero(2 * cos(phi) - phi * sin(phi), phi, S.One, Rational(11, 10))
    limit = value(LONG, {phi: angle})
    now = {n: most(S.Zero, S.Zero, n) for n in (1, 10)}
    then = {n: walls.over(n**2 * S.One, walls.over(S.One, found)) for n, found in now.items()}
    page.enclosed(
        "Endlessly fast sampling gains a free mass these factors",
        [
            (
                rf"d={n}:\quad\text{{gain}}",
                walls.over(limit, walls.over(n**2 * S.One, walls.over(S.One, now[n]))),
            )
            for n in then
        ],
    )
    box.positive(h - 2 * K, {}, Known(given({h: limit, K: now[1]})))
    box.positive(121 * K - h, {}, Known(given({h: limit, K: now[10]})))


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
