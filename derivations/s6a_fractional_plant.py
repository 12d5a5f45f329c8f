r"""How does the device respond to a force with a fractional delay?

A delay of $\ell+\varepsilon$ periods, $0\le\varepsilon<1$, changes the held force inside a period:
for the time $\varepsilon T$ the previous force still acts. The samples of this motion have an exact
transfer function, which differs from the paper's $z^{-d}$.
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
        r"The previous force acts first and the force of the sample $\ell$ periods ago last, so "
        r"that $x_{k+1}=\Phi(1)x_k+\Phi(1-\varepsilon)\Gamma(\varepsilon)F_{k-\ell-1}"
        r"+\Gamma(1-\varepsilon)F_{k-\ell}$. "
        "Solved for the position, the sampled device has one more coefficient and one more "
        "state, the previous force:"
    )
    turning = z * eye(2) - parts[0]
    force = pushed[1] + parts[1] * pushed[2] / z
    place = (turning.adjugate() * force / turning.det())[0] * z ** (-l)
    page.same("the delayed force", place, late.transfer.xreplace(given))
    found = page.lemma(
        "The sampled device is exact for every device and continuous in the delay",
        exact_late_plant(),
        boxed=True,
        because="with the motion $g(t)$ under a unit force from rest, $m_2=g(1-\\varepsilon)$ and "
        "$m_1=g(2-\\varepsilon)-(1+a)m_2$: with a spring, critically damped, with a damper alone, "
        "and for the free mass",
    )
    page.state(
        "fractional-plant",
        r"with a delay of $(\ell+\varepsilon)T$ the sampled device is $M(z)z^{-\ell}/(zA(z))$ "
        "with $M=m_2z^2+m_1z+m_0$, exactly, and it is continuous between the integer delays "
        r"$\ell$ and $\ell+1$",
        claim=exact_plant(),
    )
    page.settle("fractional-plant", found)
    page.say(
        r"The numbers are those of the undelayed device, $n_1(\gamma,\delta)$ and "
        r"$n_0(\gamma,\delta)$, for the remaining or the elapsed part of the period: a period $x$ "
        r"times as long has $\gamma x^2$ and $\delta x$. So "
        r"$m_2=(1-\varepsilon)^2\,n_1\bigl(\gamma(1-\varepsilon)^2,\delta(1-\varepsilon)\bigr)$, "
        "and the effect of the previous force decays, "
        r"$m_0=\varepsilon^2e^{-\delta(1-\varepsilon)}\,"
        r"n_0\bigl(\gamma\varepsilon^2,\delta\varepsilon\bigr)$. "
        r"One function is enough for both, $n_0(\gamma,\delta)=e^{-\delta}\,n_1(\gamma,-\delta)$: "
        "this follows by reversing the time, which changes the sign of the damping."
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
        r"A constant force is not affected by the delay, and for $\varepsilon=0$ and "
        r"$\varepsilon=1$ the coefficients are those of an integer delay",
        conj(*numbers_of_a_late_device()),
        because=r"so that $P(1)=1/\gamma$, and $\varepsilon=1$ is one more factor $z^{-1}$",
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
