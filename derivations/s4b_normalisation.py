r"""Which numbers does the loop really depend on?

Seven physical parameters describe the loop. Measured in units of the moving mass and of the
sampling period, two of them disappear.
"""

from sympy import Eq, Poly, S, exp

from symhaptic.model import plant, wall
from symhaptic.model.plant import Plant, sampled
from symhaptic.notation import (
    B,
    K,
    T,
    alpha,
    b,
    beta,
    c_1,
    c_2,
    c_3,
    d,
    delta,
    gamma,
    k,
    m,
    s,
    t_d,
    z,
)
from symhaptic.scene import FULL, Parts


def derive(page):
    page.say(
        "Let time run in periods, so that $s$ becomes $s/T$, and measure forces per length in "
        "units of $m/T^2$. Newton's law and the wall become"
    )
    motion = page.step(
        "The device",
        Plant().characteristic.subs(s, s / T) * T**2 / m,
        s**2 + b * T / m * s + k * T**2 / m,
        name=r"\tfrac{T^2}{m}\bigl(m\tfrac{s^2}{T^2}+b\tfrac sT+k\bigr)",
    )
    force = page.step(
        "The wall",
        wall.transfer() * T**2 / m,
        K * T**2 / m + B * T / m * (1 - 1 / z),
        name=r"\tfrac{T^2}{m}H(z)",
    )
    _, damping, stiffness = Poly(motion, s).all_coeffs()
    virtual_stiffness = force.subs(z, 1)
    virtual_damping = -(force - virtual_stiffness).subs(z, S.Half)
    page.settle(
        "tab1",
        Eq(d, t_d / T),
        Eq(alpha, virtual_stiffness),
        Eq(beta, virtual_damping),
        Eq(gamma, stiffness),
        Eq(delta, damping),
        definition=True,
    )
    page.say("In these numbers the plant is $1/(s^2+\\delta s+\\gamma)$, with a period of 1.")
    unit = plant.normalised(FULL)
    one, two = unit.poles(c_1)
    page.settle("eq15", Eq(c_1, unit.split), Eq(c_2, exp(two)), Eq(c_3, exp(one)))
    images = {c_2: exp(two), c_3: exp(one)}
    given = images | {gamma: (delta**2 - c_1**2) / 4}
    device = sampled(unit, split=c_1)
    first = ((2 - c_2 - c_3) * c_1 + (c_2 - c_3) * delta) / (2 * c_1 * gamma)
    second = ((2 * exp(-delta) - c_2 - c_3) * c_1 + (c_3 - c_2) * delta) / (2 * c_1 * gamma)
    page.show(
        "First sample of the step response",
        "n_1",
        first,
        page.same("n1", device.n1.xreplace(given), first.xreplace(given)),
    )
    page.show(
        "Second coefficient",
        "n_0",
        second,
        page.same("n0", device.n0.xreplace(given), second.xreplace(given)),
    )
    page.show(
        "Sum of the images",
        "a",
        c_2 + c_3,
        page.same("a", device.a.xreplace(given), (c_2 + c_3).xreplace(images)),
    )
    page.step("Their product", exp(one) * exp(two), exp(-delta), name="e")
    page.say(
        "so that the device is $P(z)=\\frac{T^2}{m}(n_1z+n_0)/(z^2-az+e)$. The forms of $n_1$ and "
        "$n_0$ are $0/0$ for $\\gamma=0$, a device that nobody holds, and for $c_1=0$. The values "
        "there are finite:"
    )
    alone = sampled(plant.normalised(Parts(stiffness=False)))
    fade, half = exp(-delta), exp(-delta / 2)
    for name, general, small, critical, free in (
        ("n_1", device.n1, alone.n1, 4 - 2 * (delta + 2) * half, delta - 1 + fade),
        ("n_0", device.n0, alone.n0, 4 * fade - (4 - 2 * delta) * half, 1 - (1 + delta) * fade),
    ):
        chain = general.xreplace(given)
        page.limit("Critical damping", chain, c_1, S.Zero, critical / delta**2, name=name)
        page.limit(
            "No spring",
            chain,
            c_1,
            delta,
            free / delta**2,
            name=name,
            because="$c_1\\to\\delta$ is $\\gamma\\to0$; the same as derived without a spring",
        )
        page.same("without a spring", small, free / delta**2)
    at = {
        gamma: S.Zero,
        delta: S.One,
        c_1: S.One,
        c_2: exp(-S.One),
        c_3: S.One,
        z: S(2),
        T: S.One,
        m: S.One,
        b: S.One,
        k: S.Zero,
        s: S.One,
    }
    page.settle(
        "eq14",
        Eq(1 / (m * s**2 + b * s + k), T**2 / m * device.transfer),
        given=given,
        provided=r"c_1\gamma\ne0",
        unless=at,
        truth=(T**2 / m * alone.transfer),
        shows=r"$0/0$ for an ungrabbed device, which (22) and (23) admit",
    )
