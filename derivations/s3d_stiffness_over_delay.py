"""How does the largest passive stiffness fall with the delay?

Fig. 5 of the paper plots the stiffness of (11) against the delay. For which delays is this the
largest passive stiffness?
"""

from symhaptic.book.figures.passivity import largest_stiffness
from symhaptic.book.lemmas.half_late_passive import passive_with
from symhaptic.book.lemmas.motions import half_late, not_passive
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import stiffest_wall, waves

HALF = {d: S.Half, T: S.One, b: S.One}
TIP = HALF | {line.lhs: line.rhs.subs(HALF) for line in STATEMENTS["eq11"].printed}


def derive(page):
    angle = pi / (2 * (d + 1))
    page.step(
        "The tip of the envelope has the stiffness of (11)",
        passivity.envelope()[0].subs(theta, angle) * T / b,
        2 * tan(angle / 2),
        name=r"\frac{K_{\max}T}{b}",
        because="the tip is the point of the envelope at which the damping drops out of the "
        "condition",
    )
    page.lemma(
        r"With a delay of half a period the wall $K=1.17\,b/T$, $B=0.32\,b$ is passive",
        passive_with(Rational("1.17"), Rational("0.32")),
        because="the largest passive stiffness therefore exceeds the value of Fig. 5 at this "
        r"delay, $2\tan\frac\pi6=1.1547$",
    )
    page.figure(
        "fig5", "Fig. 5 of the paper: the largest stiffness that satisfies (5).", largest_stiffness
    )
    _tips(page)


def _tips(page):
    """The curve shows the stiffness of (11), the largest passive one for integer delays."""
    _, given, then = taken_apart(page.claim("fig5"))
    stiffness, damping = map(assume, given[-2:])
    height = combined(then.of[0], [stiffness, T])
    found = conj(waves().closed(height), stiffest_wall(stiffness, damping))
    page.settle(
        "fig5",
        found,
        example={d: S.Zero, T: S.One, b: S.One, K: S(2), B: S.Zero},
        unless={whole(d): (TIP, not_passive(then, TIP, half_late(Rational(17, 10))))},
        shows="with a delay of half a period the wall of (11) delivers energy, and a wall with "
        "$KT/b=1.17$ can be passive, although the curve has 1.1547 there",
        note="if the delay is rounded up, the curve is always safe",
    )
