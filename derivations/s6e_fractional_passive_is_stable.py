r"""Is a passive wall stable when its delay is no whole number of periods?

For whole delays it is, because the motion at a root on the unit circle would extract energy. The
same motion is looked at again, with a force that changes inside the period.
"""

from sympy import S, eye

from symhaptic.model import fractional, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import F, c, delta, epsilon, gamma, p_k, q_k, v, x, y, z


def derive(page):
    page.say(
        "Let a root lie at $z=e^{j\\theta}$, and follow the motion that belongs to it, in units of "
        "mass and period. The force $F$ of a sample has pushed from $\\varepsilon$ on, and $F/z$ "
        "before."
    )
    device = plant.normalised(Parts())
    given = {gamma: (delta**2 - c**2) / 4}
    phi = device.transition(S.One, c)
    push = device.held(1 - epsilon, c)
    push += device.transition(1 - epsilon, c) * device.held(epsilon, c) / z
    turning = z * eye(2) - phi
    start = (turning.adjugate() * push / turning.det()).xreplace(given)
    again = (phi * start + push).xreplace(given)
    steady = page.same("the state turns by z", again, (z * start).xreplace(given))
    late = fractional.late(device, split=c)
    place = late.numerator / (z * late.device.denominator)
    page.show(
        "The steady state",
        r"\frac{x_0}{F}",
        r"\frac{M(z)}{zA(z)}",
        page.same("the sampled device", start[0], place.xreplace(given)),
        because="a state that turns by $z$ in every period, and the sampled device again",
    )
    page.step(
        "Power",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because="the stored energy is the same at all samples, so all work is burnt",
    )
    page.step(
        "The least the damper burns",
        ((1 - epsilon) * p_k + q_k) ** 2 / (1 - epsilon) + (epsilon * p_k - q_k) ** 2 / epsilon,
        p_k**2 + q_k**2 / (epsilon * (1 - epsilon)),
        because="in the time in which one force is held, as in the chapter before; and more, "
        "unless the speed is constant in both parts",
    )
    page.say(
        "So the energy left to damper and wall, the form in $p$ and $q$ of the chapter before, is "
        "negative for this motion: equality would need a constant speed at all times, and that is "
        "$z=1$. (If neither $p$ nor $q$ is there, the device rests.) A wall for which the form is "
        "nowhere negative has no root at $0<\\theta\\le\\pi$, and none of the weaker walls $yW$ on "
        "its ray has:"
    )
    whole, part = x, y
    scaled = page.step(
        "Between no wall and the wall",
        delta + part * whole,
        (1 - part) * delta + part * (delta + whole),
        name=r"\delta+yx",
        because="here $\\delta$ stands for the damper's share of the form and $x$ for the wall's",
    )
    proof = page.same("scaling", scaled, delta + part * whole)
    page.say(
        "At $z=1$ no root crosses either, as $p_1(1)=(n_1+n_0)(y\\alpha+\\gamma)>0$. Turned up "
        "from nothing, all roots stay inside."
    )
    page.state(
        "fractional-passive-is-stable",
        "for $\\delta>0$, $\\alpha\\ge0$ and $\\alpha+\\gamma>0$, a wall that is passive for the "
        "delay $(\\ell+\\varepsilon)T$ keeps every device stable",
    )
    page.settle("fractional-passive-is-stable", steady, proof)
