r"""Is a passive wall stable, whatever the delay?

Passivity looks at energy, stability at roots. Both conditions have the delay in them, but at a
root on the unit circle it drops out of the comparison, and the device alone decides.
"""

from sympy import I, S, exp, eye, symbols

from symhaptic.model import loop, passivity, plant
from symhaptic.notation import (
    B,
    F,
    K,
    alpha,
    beta,
    c,
    d,
    delta,
    function,
    gamma,
    p_k,
    u,
    v,
    w,
    x,
    y,
    z,
)
from symhaptic.scene import Parts


def derive(page):
    P, W = function("P")(z), function("W")
    page.say(
        "In units of mass and period let $W(z)$ be the wall with its delay and $P(z)$ the sampled "
        "device. A root of the loop has $1+PW=0$, so there the wall is $W=-1/P$ and the margin of "
        "passivity, $\\delta+\\Re\\{W/(z-1)\\}$, becomes $\\delta-\\Re\\{1/((z-1)P)\\}$: delay, "
        "$\\alpha$ and $\\beta$ have dropped out. What is its sign? Let a held force $F$ drive the "
        "device in a steady state that turns by $z=e^{j\\theta}$ per period."
    )
    page.step("The wall at a root", (1 + P * W(z)).subs(W(z), -1 / P), S.Zero, name="1+PW")
    page.step(
        "Power",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because="Newton's law is $\\dot v=F-\\delta v-\\gamma x$, and $\\dot x=v$",
    )
    page.step(
        "The least the damper burns",
        v**2,
        (v - p_k) ** 2 + 2 * v * p_k - p_k**2,
        because="over one period the last two terms integrate to $p_k^2$",
    )
    device = plant.normalised(Parts())
    phi, push = device.transition(S.One, c), device.held(S.One, c)
    given = {gamma: (delta**2 - c**2) / 4}
    turning = z * eye(2) - phi
    start = turning.adjugate() * push / turning.det()
    again = (phi * start + push).xreplace(given)
    steady = page.same("the state turns by z", again, (z * start).xreplace(given))
    sampled = plant.sampled(device, split=c).transfer
    page.show(
        "The steady state",
        "x_0/F",
        P,
        page.same("the sampled device", start[0].xreplace(given), sampled.xreplace(given)),
        because="the state that a held unit force turns by $z$ in one period has this position",
    )
    page.say(
        "The held force works $Fp$ per period. The state turns by $z$, so its stored energy at the "
        "samples stays the same (complex amplitudes stand for two real motions, whose energies add "
        "up), and all the work is burnt: with $p=(z-1)PF$, "
        "$\\Re\\{(z-1)P\\}\\ge\\delta|(z-1)P|^2$."
    )
    page.step(
        "Real part of a reciprocal",
        passivity.real_part(1 / (u + I * w)),
        u / (u**2 + w**2),
        name=r"\Re\frac1{u+jw}",
        because="divided by the square, the inequality is $\\Re\\{1/((z-1)P)\\}\\ge\\delta$",
    )
    page.say(
        "Equality needs a constant speed within each period, hence at all times, and that is "
        "$z=1$. So for $0<\\theta\\le\\pi$ and $\\delta>0$ the margin is negative at every root on "
        "the circle, for every $\\gamma\\ge0$ and every delay. Now take a wall that satisfies (5), "
        "with $\\alpha\\ge0$ and $\\alpha+\\gamma>0$, and turn it up from nothing to $yW$, "
        "$0<y\\le1$."
    )
    part = symbols("r")
    page.step(
        "Between no wall and the wall",
        delta + y * part,
        (1 - y) * delta + y * (delta + part),
        name=r"\delta+yr",
        because="with $r=\\Re\\{W/(z-1)\\}$; both terms are positive if the whole wall is passive",
    )
    page.say(
        "No root can cross the circle at $0<\\theta\\le\\pi$, and at $z=1$ none does, since "
        "$p_1(1)=(n_1+n_0)(y\\alpha+\\gamma)>0$. Without a wall the poles of the damped device lie "
        "inside; for $\\gamma=0$ one of them lies at 1 and moves inside with the first stiffness. "
        "All roots stay inside, for every spring at once."
    )
    drop = page.same("delay and wall drop out", (1 + P * W(z)).subs(W(z), -1 / P), S.Zero)
    pull = loop.characteristic(Parts(stiffness=False, delay=False)).subs(z, 1)
    page.settle(
        "s5a-subset",
        steady,
        drop,
        provided=r"\delta>0,\ \alpha\ge0,\ \alpha+\gamma>0\ \text{and}\ d\in\mathbb{N}_0",
        unless={alpha: -S.Half, beta: S.Zero, delta: S.One, d: S.Zero, gamma: S.Zero},
        truth=pull > 0,
        shows=r"a pulling wall without a spring satisfies (5), but $p_1(1)<0$",
        note="by the energy of the steady state, for all $\\gamma\\ge0$ together",
    )
    page.settle(
        "s5c-robust-subset",
        steady,
        drop,
        provided=r"\delta>0,\ \alpha>0\ \text{and}\ d\in\mathbb{N}_0",
        unless={delta: S.Zero},
        truth=exp(-delta) < 1,
        shows="without damping the passive walls are the origin alone, where the poles of the "
        "device stay on the circle",
        note=r"holds for every $\gamma\ge0$, beyond the Nyquist frequency too",
    )
    need, in_wall = passivity.dirichlet_form(), {K: y * K, B: y * B}
    page.step(
        "Scaling",
        need.subs(in_wall, simultaneous=True),
        y * need,
        name=r"\text{need}(yK,yB)",
        because="the condition is linear in the wall: with $y$ times the damping, $y$ times the "
        "wall is passive",
    )
    page.settle(
        "s5a-proportional", page.same("scaling", need.subs(in_wall, simultaneous=True), y * need)
    )
