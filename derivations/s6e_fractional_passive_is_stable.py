"""Is a passive wall with a fractional delay stable?

For integer delays a passive wall is stable, because the motion that belongs to a root on the unit
circle would extract energy. We consider the same motion with a force that changes within the
period.
"""

from symhaptic.book.lemmas.half_late_passive import DAMPER, passive_with
from symhaptic.book.lemmas.late_passive_is_stable import (
    late_passive_is_stable,
    late_passive_walls_are_stable,
    no_crossing,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import q_k


def derive(page):
    page.say(
        r"Let a root lie at $z=e^{j\theta}$, and follow the motion that belongs to it, in units "
        r"of mass and period. In each period the force $F$ acts after the fraction $\varepsilon$, "
        "and the previous force $F/z$ acts before it. The state is multiplied by $z$ in every "
        "period, and its samples are those of the device, $x_0/F=M(z)/(zA(z))$."
    )
    device = plant.normalised(Parts())
    given = {gamma: (delta**2 - c**2) / 4}
    phi = device.transition(S.One, c)
    push = device.held(1 - epsilon, c)
    push += device.transition(1 - epsilon, c) * device.held(epsilon, c) / z
    turning = z * eye(2) - phi
    start = (turning.adjugate() * push / turning.det()).xreplace(given)
    again = (phi * start + push).xreplace(given)
    page.same("the state is multiplied by z", again, (z * start).xreplace(given))
    late = fractional.late(device, split=c)
    place = late.numerator / (z * late.device.denominator)
    page.same("the sampled device", start[0], place.xreplace(given))
    page.step(
        "All work is dissipated",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because="the stored energy is the same at all samples",
    )
    page.step(
        "The damper dissipates at least this energy",
        ((1 - epsilon) * p_k + q_k) ** 2 / (1 - epsilon) + (epsilon * p_k - q_k) ** 2 / epsilon,
        p_k**2 + q_k**2 / (epsilon * (1 - epsilon)),
        because="the bound holds while one force is held, as in "
        r"\chapter{s6d_fractional_passivity}. Equality requires a constant speed in each of the "
        "two parts",
    )
    page.say(
        "The energy that damper and wall absorb is the form in $p$ and $q$ of "
        r"\chapter{s6d_fractional_passivity}. So this form is negative for this motion: equality "
        "would require a constant speed at all times, that is, $z=1$. (For $p=q=0$ the device "
        "is at rest.) But for a passive wall the form is not negative at any angle. The "
        "condition is concave in the scale $y$ of a wall $yW$:"
    )
    margin, whole, part = delta**2 - delta * x - w / 4, x, y
    page.step(
        "The margin of $yW$ is at least the linear interpolation between the margins of 0 and $W$",
        delta**2 - part * delta * whole - part**2 * w / 4,
        (1 - part) * delta**2 + part * margin + part * (1 - part) * w / 4,
        name=r"D\big|_{yW}",
        because=r"here $x$ stands for $n$, and $w$ for $\varepsilon(1-\varepsilon)|H|^2$, which "
        "is not negative",
    )
    page.lemma(
        "A passive wall, and every smaller multiple of it, has no root on the circle except at 1",
        no_crossing(),
        because=r"the number $2\Re\bar p\,p_1$ is the sum of the energy dissipated beyond "
        r"$\delta(|p|^2+|q|^2/(\varepsilon(1-\varepsilon)))$, of $|p|^2D$ and of a square",
    )
    found = page.lemma(
        "Passive walls are stable with every delay",
        late_passive_is_stable(),
        because=r"no root crosses at $z=1$ either, since $p_1(1)=(n_1+n_0)(y\alpha+\gamma)$. So "
        "all roots stay inside while the wall is scaled from zero",
        boxed=True,
    )
    page.state(
        "fractional-passive-is-stable",
        "for $\\delta>0$, $\\gamma\\ge0$ and $\\alpha+\\gamma>0$, a wall that is passive for the "
        "delay $(\\ell+\\varepsilon)T$ is stable",
        claim=late_passive_walls_are_stable(),
    )
    point = {alpha: S.Zero, beta: DAMPER, gamma: S.One, delta: S.One, l: S.Zero, epsilon: S.Half}
    damped = inst(passive_with(S.Zero, DAMPER), {b: S.One, T: S.One})
    page.settle("fractional-passive-is-stable", found, example=(point, closed(damped, one())))
