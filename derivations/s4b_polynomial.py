r"""Which polynomial decides whether the loop is stable?

The sampled device and the delayed wall are closed to a loop. Its poles are the roots of one
polynomial, and its form should not break down for the devices that one meets.
"""

from sympy import Eq, S, exp, symbols

from symhaptic.model import loop, plant, wall
from symhaptic.notation import (
    T,
    alpha,
    beta,
    c_1,
    c_2,
    c_3,
    d,
    delta,
    function,
    gamma,
    m,
    z,
)
from symhaptic.paper import STATEMENTS
from symhaptic.scene import FULL, Parts


def derive(page):
    device = plant.sampled(plant.normalised(FULL), split=c_1)
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    short = (z**2 - a * z + e) * z ** (d + 1) + (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    plain = (n_1 * z + n_0) / (z**2 - a * z + e)
    push = ((alpha + beta) * z - beta) / z ** (d + 1)
    page.say("With the sampled device $P$ and the delayed wall, in units of $m$ and $T$:")
    page.step(
        "The wall",
        wall.normalised(FULL)[0] / wall.normalised(FULL)[1],
        (alpha + beta * (1 - 1 / z)) * z ** (-d),
        name=r"\tfrac{T^2}{m}H(z)z^{-d}",
    )
    page.step(
        "The closed loop",
        plain / (1 + plain * push),
        (n_1 * z + n_0) * z ** (d + 1) / short,
        name=r"\tfrac{m}{T^2}G_x(z)",
        because="$P/(1+PHz^{-d})$, both sides multiplied by the two denominators",
        paper="16",
    )
    page.say("The denominator is monic and never degenerates:")
    page.show(
        "Characteristic polynomial",
        "p_1(z)",
        short,
        page.same(
            "the model",
            loop.characteristic(split=c_1),
            short.xreplace({a: device.a, e: device.e, n_1: device.n1, n_0: device.n0}),
        ),
        boxed=True,
        paper="18",
    )
    page.say(
        "The paper multiplies numerator and denominator by $-2c_1\\gamma$. That factor vanishes "
        "for a device that nobody holds and at critical damping, and with it all of $n(z)$ and "
        "$p(z)$."
    )
    n, p = function("n")(z), function("p")(z)
    one, two = plant.normalised(FULL).poles(c_1)
    given = {c_2: exp(two), c_3: exp(one), gamma: (delta**2 - c_1**2) / 4}
    page.say("With the abbreviations (15) of the chapter before,")
    page.define("Difference of the poles", c_1, plant.normalised(FULL).split)
    page.define("Faster pole", c_2, exp(two))
    page.define("Slower pole", c_3, exp(one))
    scale = -2 * c_1 * gamma
    top, bottom = scale * device.numerator, scale * loop.characteristic(split=c_1)
    free = {
        gamma: S.Zero,
        delta: S.One,
        c_1: S.One,
        c_2: exp(-S.One),
        c_3: S.One,
        d: S.Zero,
        alpha: S.One,
        beta: S.One,
        z: S(2),
        T: S.One,
        m: S.One,
    }
    alone = Parts(stiffness=False)
    condition = r"c_1\gamma\ne0"
    whole = r",\ d\in\mathbb{N}_0"
    page.settle(
        "eq17",
        Eq(n, top),
        given=given,
        provided=condition,
        unless=free,
        truth=plant.sampled(plant.normalised(alone)).numerator,
        shows=r"$n(z)\equiv0$ for an ungrabbed device",
    )
    page.settle(
        "eq18",
        Eq(p, bottom),
        given=given,
        provided=condition + whole,
        unless=free,
        truth=loop.characteristic(alone),
        shows=r"$p(z)\equiv0$ for an ungrabbed device: every $z$ would be a pole",
    )
    numerator, denominator = (STATEMENTS[i].printed[0].rhs for i in ("eq17", "eq18"))
    page.settle(
        "eq16",
        Eq(function("G_x")(z), loop.closed(split=c_1)),
        given=given | {n: top.xreplace(given), p: bottom.xreplace(given)},
        provided=condition + whole,
        unless=free,
        truth=loop.closed(alone),
        specialise=lambda form: form.xreplace({n: numerator, p: denominator}),
        shows=r"$0/0$ for an ungrabbed device",
    )
