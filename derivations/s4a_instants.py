r"""Does the sampled loop move exactly like the real one at the sampling instants?

The paper replaces the device by its samples and the delay by $z^{-d}$, and says that the behaviour
at the sampling instants stays exactly the same. For which forces and which delays?
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
        r"Over a period the state moves as $x_{k+1}=\Phi x_k+\Gamma F_k$ if the force $F_k$ is "
        "held all the time. This recursion contains the samples only. Two consecutive periods "
        r"are one period of twice the length, $\Phi(2)=\Phi(1)\Phi(1)$, and a force that is held "
        "for both has the same effect as two equal forces, "
        r"$\Gamma(2)=\Phi(1)\Gamma(1)+\Gamma(1)$."
    )
    one = [part(S.One, c).xreplace(given) for part in (device.transition, device.held)]
    two = [part(S(2), c).xreplace(given) for part in (device.transition, device.held)]
    page.same("motion", two[0], one[0] * one[0])
    page.same("push", two[1], one[0] * one[1] + one[1])
    page.say(
        "An integer delay of $d$ periods puts $F_{k-d}$ in place of $F_k$; the force is still "
        "held from one sampling instant to the next. So for integer delays, and as long as the "
        "external force is held too, the samples are exact. We now drop one of the two assumptions "
        "at a time, for a free mass in units of mass and period."
    )
    free = normalised(Parts(stiffness=False, damping=False))
    page.step(
        "A force that grows in time, $F_E=t$, moves the mass by a sixth",
        integrate(free.transition(1 - t)[0, 1] * t, (t, 0, 1)),
        Rational(1, 6),
        name="x_1",
        because="according to the samples, $F_0=0$, the mass would not move",
    )
    page.step(
        "A held force with a fractional delay is not the shifted one",
        free.held(1 - d)[0],
        (1 - d) ** 2 / 2,
        name="x_1",
        because="a period after the sample, for $d\\le1$; $z^{-d}P(z)$ begins with $z^{-d-1}$ and "
        "says 0 for every $d>0$",
    )
    _settle(page)


def _settle(page):
    """The loop with an integer delay is that with z^-d: both answers are the same."""
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
        note="and for an external force that is held, as the paper says",
    )
