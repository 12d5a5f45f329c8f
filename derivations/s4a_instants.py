r"""Does the sampled loop move exactly like the real one at the sampling instants?

The paper replaces the device by its samples and the delay by $z^{-d}$, and says that the behaviour
at the sampling instants stays exactly the same. For which forces and which delays is this true?
"""

from sympy import integrate

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import PROMPT, late_answer
from symhaptic.book.lemmas.sampled_points import FREE, fails, shown_at
from symhaptic.model.plant import normalised
from symhaptic.notation import X_d
from symhaptic.paper.propositions.device import WALL
from symhaptic.proof.theorems.samples import turns


def derive(page):
    device, given = normalised(FULL), {gamma: (delta**2 - c**2) / 4}
    page.say(
        r"If the force $F_k$ is held during a period, the state changes to $x_{k+1}=\Phi "
        r"x_k+\Gamma F_k$. This recursion contains the samples only. Two consecutive periods act "
        r"as one period of twice the length, $\Phi(2)=\Phi(1)\Phi(1)$. A force that is held for "
        "both periods has the same effect as two equal forces, "
        r"$\Gamma(2)=\Phi(1)\Gamma(1)+\Gamma(1)$."
    )
    one = [part(S.One, c).xreplace(given) for part in (device.transition, device.held)]
    two = [part(S(2), c).xreplace(given) for part in (device.transition, device.held)]
    page.same("motion", two[0], one[0] * one[0])
    page.same("push", two[1], one[0] * one[1] + one[1])
    page.say(
        "An integer delay of $d$ periods replaces $F_k$ by $F_{k-d}$; this force is still held "
        "from one sampling instant to the next. So the samples are exact for integer delays if the "
        "external force is held, too. We now drop one of the two assumptions at a time, for a free "
        "mass in units of mass and period."
    )
    free = normalised(Parts(stiffness=False, damping=False))
    page.step(
        "A force that grows in time, $F_E=t$, moves the mass by a sixth",
        integrate(free.transition(1 - t)[0, 1] * t, (t, 0, 1)),
        Rational(1, 6),
        name="x_1",
        because="the sampled model uses the force $F_0=0$, so the mass would not move",
    )
    page.step(
        "With a fractional delay a held force already moves the mass within the first period",
        free.held(1 - d)[0],
        (1 - d) ** 2 / 2,
        name="x_1",
        because=r"for $d\le1$ a unit force has acted for the time $1-d$. The expansion of "
        "$z^{-d}P(z)$ in powers of $1/z$ begins with $z^{-d-1}$, so this model predicts "
        "no motion within the first period for $d>0$",
    )
    _settle(page)


def _settle(page):
    """With an integer delay the samples of the loop are exactly those of z^-d."""
    claim = page.claim("s4a-exact-instants")
    then = taken_apart(claim)[2]
    gains = (1 + X_d * WALL) * (1 + z**-d * X * WALL)
    equal = combined(then, [late_answer(), -X * WALL / gains])
    found = closed(equal, turns(assume(PROMPT)), positive(Ne(T, 0), T > 0))
    point = FREE | {d: S.One}
    page.settle(
        "s4a-exact-instants",
        as_claimed(claim, found, whole(d)),
        example=shown_at(claim, point, whole(d)),
        unless=[fails(claim, FREE | {d: S.Half, z: 4}, but=whole(d))],
        shows="with a delay of half a period, the response of a free mass at $z=4$ differs from "
        "that of $z^{-1/2}$",
        note="the external force has to be held as well, as the paper says",
    )
