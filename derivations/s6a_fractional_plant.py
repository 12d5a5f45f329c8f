r"""What does the device do with a force that arrives in the middle of a period?

A delay of $\ell+\varepsilon$ periods, $0\le\varepsilon<1$, lets the held force change inside a
period: for the time $\varepsilon T$ the device still feels the force before. The samples of that
motion are again a transfer function, exactly; the paper's $z^{-d}$ is not.
"""

from symhaptic.book.lemmas.late_device import exact_late_plant, exact_plant
from symhaptic.book.lemmas.late_loop import numbers_of_a_late_device
from symhaptic.book.lemmas.prelude import *


def derive(page):
    device = plant.normalised(FULL)
    late, whole = fractional.late(device, split=c), plant.sampled(device, split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    page.say(
        "In units of mass and period let $\\Phi(t)$ be the motion of the free device and "
        "$\\Gamma(t)$ its response from rest to a unit force. Over one period a force that "
        "changes at $\\varepsilon$ acts in two parts: $\\Phi(1)=\\Phi(1-\\varepsilon)"
        "\\Phi(\\varepsilon)$, and a force that stays the same has $\\Gamma(1)="
        "\\Gamma(1-\\varepsilon)+\\Phi(1-\\varepsilon)\\Gamma(\\varepsilon)$."
    )
    rest = 1 - epsilon
    parts = [device.transition(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    pushed = [device.held(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    page.same("the free motion", parts[0], parts[1] * parts[2])
    page.same("the held force", pushed[0], pushed[1] + parts[1] * pushed[2])
    page.say(
        "The force of the sample $\\ell$ periods ago pushes last, the one before it first, so that "
        "$x_{k+1}=\\Phi(1)x_k+\\Phi(1-\\varepsilon)\\Gamma(\\varepsilon)F_{k-\\ell-1}"
        "+\\Gamma(1-\\varepsilon)F_{k-\\ell}$. Solved for the position, the sampled device has one "
        "more coefficient and one more state, the force before:"
    )
    turning = z * eye(2) - parts[0]
    force = pushed[1] + parts[1] * pushed[2] / z
    place = (turning.adjugate() * force / turning.det())[0] * z ** (-l)
    page.same("the late force", place, late.transfer.xreplace(given))
    found = page.lemma(
        "The sampled device is exact for every device, and nothing jumps",
        exact_late_plant(),
        boxed=True,
        because="with the motion $g(t)$ under a unit force from rest, $m_2=g(1-\\varepsilon)$ and "
        "$m_1=g(2-\\varepsilon)-(1+a)m_2$: with a spring, critically damped, with a damper alone, "
        "and for the free mass",
    )
    page.state(
        "fractional-plant",
        "behind a delay of $(\\ell+\\varepsilon)T$ the sampled device is "
        "$M(z)z^{-\\ell}/(zA(z))$ with $M=m_2z^2+m_1z+m_0$, exactly, and between the whole "
        "delays $\\ell$ and $\\ell+1$ nothing jumps",
        claim=exact_plant(),
    )
    page.settle("fractional-plant", found)
    page.say(
        "The numbers are those of the undelayed device, $n_1(\\gamma,\\delta)$ and "
        "$n_0(\\gamma,\\delta)$, at the part of the period that is left or gone: a period $x$ "
        "times as long has $\\gamma x^2$ and $\\delta x$. So $m_2=(1-\\varepsilon)^2\\,n_1\\bigl("
        "\\gamma(1-\\varepsilon)^2,\\delta(1-\\varepsilon)\\bigr)$, and what is left of the force "
        "before is decayed, $m_0=\\varepsilon^2e^{-\\delta(1-\\varepsilon)}\\,n_0\\bigl(\\gamma"
        "\\varepsilon^2,\\delta\\varepsilon\\bigr)$. One function is enough for both, "
        "$n_0(\\gamma,\\delta)=e^{-\\delta}\\,n_1(\\gamma,-\\delta)$: what is left of a force at "
        "the end of a period is what the mirrored motion, with negative damping, has at its "
        "beginning."
    )

    def shortened(time):
        return plant.sampled(Plant(S.One, delta * time, gamma * time**2), split=c * time)

    backward = plant.sampled(Plant(S.One, -delta, gamma), split=c).n1
    for ours, theirs in (
        (late.m2, rest**2 * shortened(rest).n1),
        (late.m0, epsilon**2 * exp(-delta * rest) * shortened(epsilon).n0),
        (whole.n0, exp(-delta) * backward),
    ):
        page.same("numbers", ours.xreplace(given), theirs.xreplace(given))
    page.lemma(
        "A constant force does not feel the delay, and at both ends of the fraction the device is "
        "the undelayed one",
        conj(*numbers_of_a_late_device()),
        because="so that $P(1)=1/\\gamma$ stays, and a full period is one more $z^{-1}$",
    )
    free = fractional.late(plant.normalised(Parts(stiffness=False, damping=False)))
    page.say("For a free mass, $\\gamma=\\delta=0$:")
    numbers = [(m_2, rest**2 / 2), (m_1, (1 + 2 * epsilon - 2 * epsilon**2) / 2)]
    numbers.append((m_0, epsilon**2 / 2))
    for (name, value), derived in zip(numbers, (free.m2, free.m1, free.m0), strict=True):
        page.step(
            f"For the free mass ${name}$ is quadratic in the fraction",
            expand(derived),
            value,
            name=name,
        )
