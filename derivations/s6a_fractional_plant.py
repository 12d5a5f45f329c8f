r"""What does the device do with a force that arrives in the middle of a period?

A delay of $\ell+\varepsilon$ periods, $0\le\varepsilon<1$, lets the held force change inside a
period: for the time $\varepsilon T$ the device still feels the force before. The samples of that
motion are again a transfer function, exactly; the paper's $z^{-d}$ is not.
"""

from sympy import S, exp, expand, eye

from symhaptic.book.lemmas.late_device import exact_late_plant, exact_plant
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.model.plant import Plant
from symhaptic.notation import c, delta, epsilon, gamma, l, m_0, m_1, m_2, z


def derive(page):
    device = plant.normalised(FULL)
    late, whole = fractional.late(device, split=c), plant.sampled(device, split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    page.say(
        "In units of mass and period let $\\Phi(t)$ be the motion of the free device and "
        "$\\Gamma(t)$ its response from rest to a unit force. Over one period a force that "
        "changes at $\\varepsilon$ acts in two parts:"
    )
    rest = 1 - epsilon
    parts = [device.transition(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    pushed = [device.held(t, c).xreplace(given) for t in (S.One, rest, epsilon)]
    page.show(
        "A period's motion is that of its two parts",
        r"\Phi(1)",
        r"\Phi(1-\varepsilon)\,\Phi(\varepsilon)",
        page.same("the free motion", parts[0], parts[1] * parts[2]),
    )
    page.show(
        "A force that stays the same is the held force",
        r"\Gamma(1)",
        r"\Gamma(1-\varepsilon)+\Phi(1-\varepsilon)\,\Gamma(\varepsilon)",
        page.same("the held force", pushed[0], pushed[1] + parts[1] * pushed[2]),
    )
    page.say(
        "The force of the sample $\\ell$ periods ago pushes last, the one before it first, so that "
        "$x_{k+1}=\\Phi(1)x_k+\\Phi(1-\\varepsilon)\\Gamma(\\varepsilon)F_{k-\\ell-1}"
        "+\\Gamma(1-\\varepsilon)F_{k-\\ell}$. Solved for the position:"
    )
    turning = z * eye(2) - parts[0]
    force = pushed[1] + parts[1] * pushed[2] / z
    place = (turning.adjugate() * force / turning.det())[0] * z ** (-l)
    exact = page.same("the late force", place, late.transfer.xreplace(given))
    page.show(
        "The sampled device has one more coefficient, and one more state",
        "P(z)",
        r"\frac{m_2z^2+m_1z+m_0}{z\,(z^2-az+e)}\;z^{-\ell}",
        exact,
        because="the state is the force before; $a$ and $e$ are those of the undelayed device",
        boxed=True,
    )
    page.say(
        "The numbers are those of the undelayed device, $n_1(\\gamma,\\delta)$ and "
        "$n_0(\\gamma,\\delta)$, at the part of the period that is left or gone: a period $x$ "
        "times as long has $\\gamma x^2$ and $\\delta x$."
    )

    def shortened(time):
        return plant.sampled(Plant(S.One, delta * time, gamma * time**2), split=c * time)

    first = rest**2 * shortened(rest).n1
    page.show(
        "The first sample after a late force is that of a shorter period",
        m_2,
        r"(1-\varepsilon)^2\,n_1\bigl(\gamma(1-\varepsilon)^2,\delta(1-\varepsilon)\bigr)",
        page.same("first", late.m2.xreplace(given), first.xreplace(given)),
    )
    last = epsilon**2 * exp(-delta * rest) * shortened(epsilon).n0
    page.show(
        "What is left of the force before is that of a shorter period, decayed",
        m_0,
        r"\varepsilon^2 e^{-\delta(1-\varepsilon)}\,n_0\bigl(\gamma\varepsilon^2,"
        r"\delta\varepsilon\bigr)",
        page.same("last", late.m0.xreplace(given), last.xreplace(given)),
    )
    total = late.m2 + late.m1 + late.m0
    page.show(
        "A constant force does not feel the delay",
        m_2 + m_1 + m_0,
        r"n_1+n_0",
        page.same("sum", total.xreplace(given), (whole.n1 + whole.n0).xreplace(given)),
        because="so that $P(1)=1/\\gamma$ stays",
    )
    backward = plant.sampled(Plant(S.One, -delta, gamma), split=c).n1
    page.show(
        "One function is enough for both numbers",
        "n_0(\\gamma,\\delta)",
        r"e^{-\delta}\,n_1(\gamma,-\delta)",
        page.same("backward", whole.n0.xreplace(given), (exp(-delta) * backward).xreplace(given)),
        because="time runs backward: what is left of a force at the end of a period is what "
        "the mirrored motion, with negative damping, has at its beginning",
    )
    numbers = [late.m2, late.m1, late.m0]
    ends = [
        page.same(
            "at the ends",
            [n.subs(epsilon, end).xreplace(given) for n in numbers],
            [n.xreplace(given) for n in expected],
        )
        for end, expected in (
            (0, [whole.n1, whole.n0, S.Zero]),
            (1, [S.Zero, whole.n1, whole.n0]),
        )
    ]
    page.show(
        "Without a fraction it is the undelayed device",
        r"(m_2,m_1,m_0)\big|_{\varepsilon=0}",
        r"(n_1,\;n_0,\;0)",
        ends[0],
        because="the $z$ of the denominator cancels",
    )
    page.show(
        "A full period makes it the undelayed device, one sample later",
        r"(m_2,m_1,m_0)\big|_{\varepsilon=1}",
        r"(0,\;n_1,\;n_0)",
        ends[1],
        because="the same numbers, with one more $z^{-1}$",
    )
    found = page.lemma(
        "The sampled device is exact for every device, and nothing jumps",
        exact_late_plant(),
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
