r"""How does the device respond to a force with a fractional delay?

With a delay of $\ell+\varepsilon$ periods, $0\le\varepsilon<1$, the held force changes inside a
period: for the time $\varepsilon T$ the previous force still acts. The transfer function
from the force to the sampled position is exact. It differs from the paper's $z^{-d}$.
"""

from symhaptic.book.lemmas.late_device import exact_late_plant, exact_plant
from symhaptic.book.lemmas.late_loop import numbers_of_a_late_device
from symhaptic.book.lemmas.prelude import *


def derive(page):
    device = plant.normalised(FULL)
    late, whole = fractional.late(device, split=c), plant.sampled(device, split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    page.say(
        r"In units of mass and period let $\Phi(t)$ be the motion of the free device and "
        r"$\Gamma(t)$ its response from rest to a unit force. Over one period a force that changes "
        r"at $\varepsilon$ acts in two parts. The free motion satisfies "
        r"$\Phi(1)=\Phi(1-\varepsilon)\Phi(\varepsilon)$. The response to a constant force "
        r"satisfies $\Gamma(1)=\Gamma(1-\varepsilon)+\Phi(1-\varepsilon)\Gamma(\varepsilon)$."
    )
    rest = 1 - epsilon
    parts = [device.transition(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    pushed = [device.held(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    page.same("the free motion", parts[0], parts[1] * parts[2])
    page.same("the held force", pushed[0], pushed[1] + parts[1] * pushed[2])
    page.say(
        r"The previous force acts first. Then the force of the sample $\ell$ periods ago acts, so "
        "that "
        r"$x_{k+1}=\Phi(1)x_k+\Phi(1-\varepsilon)\Gamma(\varepsilon)F_{k-\ell-1}"
        r"+\Gamma(1-\varepsilon)F_{k-\ell}$. "
        "Solved for the position, the sampled device has one more coefficient and one more state, "
        "the previous force:"
    )
    turning = z * eye(2) - parts[0]
    force = pushed[1] + parts[1] * pushed[2] / z
    place = (turning.adjugate() * force / turning.det())[0] * z ** (-l)
    page.same("the delayed force", place, late.transfer.xreplace(given))
    found = page.lemma(
        "The sampled transfer function is exact for every device and continuous in the delay",
        exact_late_plant(),
        boxed=True,
        because=r"if $g(t)$ is the motion from rest under a unit force, $m_2=g(1-\varepsilon)$ "
        r"and $m_1=g(2-\varepsilon)-(1+a)m_2$. These equations hold for a device with a spring, "
        "for critical damping, for a damper alone, and for a free mass",
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
        r"The coefficients follow from those of the undelayed device, $n_1(\gamma,\delta)$ and "
        r"$n_0(\gamma,\delta)$, with the remaining or the elapsed part of the period in place of "
        r"the period. For a period that is $x$ times as long, $\gamma$ becomes $\gamma x^2$ and "
        r"$\delta$ becomes $\delta x$. The remaining part gives "
        r"$m_2=(1-\varepsilon)^2\,n_1\bigl(\gamma(1-\varepsilon)^2,\delta(1-\varepsilon)\bigr)$. "
        "The elapsed part gives $m_0$, with a factor for the decay in the remaining part: "
        r"$m_0=\varepsilon^2e^{-\delta(1-\varepsilon)}\,"
        r"n_0\bigl(\gamma\varepsilon^2,\delta\varepsilon\bigr)$. "
        "One function is sufficient for $m_2$ and $m_0$, because "
        r"$n_0(\gamma,\delta)=e^{-\delta}\,n_1(\gamma,-\delta)$. This identity follows by "
        "reversing the time, which changes the sign of the damping."
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
        r"The delay does not affect a constant force, and for $\varepsilon=0$ and $\varepsilon=1$ "
        "the coefficients are those of an integer delay",
        conj(*numbers_of_a_late_device()),
        because=r"therefore $P(1)=1/\gamma$, and $\varepsilon=1$ gives one more factor $z^{-1}$",
    )
    free = fractional.late(plant.normalised(Parts(stiffness=False, damping=False)))
    page.say(r"For a free mass, $\gamma=\delta=0$, the coefficients are quadratic in the fraction:")
    numbers = [(m_2, rest**2 / 2), (m_1, (1 + 2 * epsilon - 2 * epsilon**2) / 2)]
    numbers.append((m_0, epsilon**2 / 2))
    for (name, value), derived in zip(numbers, (free.m2, free.m1, free.m0), strict=True):
        page.step(
            f"For the free mass ${name}$ is quadratic in the fraction",
            expand(derived),
            value,
            name=name,
        )
