"""On which parameters does the loop depend?

Seven physical parameters describe the loop. In units of the moving mass and of the sampling period,
five remain.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.renaming import definitions, renamed
from symhaptic.book.lemmas.sampled import device_claim
from symhaptic.book.lemmas.sampled_points import CRITICAL, SWINGING, UNHELD, fails, shown_at
from symhaptic.model import wall
from symhaptic.model.plant import sampled


def derive(page):
    page.say(
        "We measure time in periods, so $s$ becomes $s/T$, and force per length in units of "
        "$m/T^2$. Newton's law and the wall then become:"
    )
    motion = page.step(
        r"Two numbers, $\gamma$ and $\delta$, describe the device",
        Plant().characteristic.subs(s, s / T) * T**2 / m,
        s**2 + b * T / m * s + k * T**2 / m,
        name=r"\tfrac{T^2}{m}\bigl(m\tfrac{s^2}{T^2}+b\tfrac sT+k\bigr)",
    )
    page.define("The wall has the transfer function (1)", Function("H")(z), wall.transfer())
    force = page.step(
        r"Two numbers, $\alpha$ and $\beta$, describe the wall",
        wall.transfer() * T**2 / m,
        K * T**2 / m + B * T / m * (1 - 1 / z),
        name=r"\tfrac{T^2}{m}H",
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
    page.say(r"In these parameters the plant is $1/(s^2+\delta s+\gamma)$, with a period of 1.")
    unit = plant.normalised(FULL)
    one, two = unit.poles(c_1)
    _abbreviations(page, Eq(c_1, unit.split), Eq(c_2, exp(two)), Eq(c_3, exp(one)))
    given = {gamma: (delta**2 - c_1**2) / 4}
    for name, meaning in ((c_1, unit.split), (c_2, exp(two)), (c_3, exp(one))):
        page.define("One of the abbreviations (15)", name, meaning)
    device = sampled(unit, split=c_1)
    first = ((2 - c_2 - c_3) * c_1 + (c_2 - c_3) * delta) / (2 * c_1 * gamma)
    second = ((2 * exp(-delta) - c_2 - c_3) * c_1 + (c_3 - c_2) * delta) / (2 * c_1 * gamma)
    for title, name, theirs, form in (
        ("The first sample of the step response is $n_1$", n_1, device.n1, first),
        ("The second coefficient is $n_0$", n_0, device.n0, second),
        ("The images of the poles add up to $a$", a, device.a, c_2 + c_3),
        ("The two poles have the product $e$", e, exp(one) * exp(two), exp(-delta)),
    ):
        page.step(title, theirs, form, name=name)
    page.say(
        r"So the device is $P(z)=\frac{T^2}{m}(n_1z+n_0)/(z^2-az+e)$. The formulas for $n_1$ and "
        r"$n_0$ are $0/0$ for a device without an arm ($\gamma=0$) and at critical damping "
        "($c_1=0$). Their limits are finite:"
    )
    alone = sampled(plant.normalised(Parts(stiffness=False)))
    fade, half = exp(-delta), exp(-delta / 2)
    for name, general, small, critical, free in (
        ("n_1", device.n1, alone.n1, 4 - 2 * (delta + 2) * half, delta - 1 + fade),
        ("n_0", device.n0, alone.n0, 4 * fade - (4 - 2 * delta) * half, 1 - (1 + delta) * fade),
    ):
        chain = general.xreplace(given)
        page.limit(
            f"At critical damping ${name}$ has this limit",
            chain,
            c_1,
            S.Zero,
            critical / delta**2,
            name=name,
        )
        page.limit(
            f"Without a spring ${name}$ has this limit",
            chain,
            c_1,
            delta,
            free / delta**2,
            name=name,
            because=r"the limit $c_1\to\delta$ means $\gamma\to0$; a derivation without a spring "
            "gives the same value",
        )
        page.same("without a spring", small, free / delta**2)
    form = Eq(1 / (m * s**2 + b * s + k), T**2 / m * device.transfer)
    _equivalent(page, form)


def _equivalent(page, form):
    """(14) is right for every device for which it is not 0/0."""
    claim = page.claim("eq14")
    apart = [Ne(c_1, 0), Ne(gamma, 0)]
    page.settle(
        "eq14",
        device_claim(claim, apart),
        form,
        example=shown_at(claim, SWINGING, *apart),
        unless=[
            fails(claim, UNHELD, holds=apart[:1], but=apart[1]),
            fails(claim, CRITICAL, holds=apart[1:], but=apart[0]),
        ],
        shows="the coefficients (14) are $0/0$ for a device without an arm, which (22) and (23) "
        "admit",
    )


def _abbreviations(page, *forms):
    """(15) is (13) in the parameters of Table I."""
    claim = page.claim("eq15")
    _, given, then = taken_apart(claim)
    names = definitions(given)
    spring, damper = names[:2]
    parts = [
        renamed(known, part, spring, damper) for part, known in zip(then.of, names[2:], strict=True)
    ]
    theorem = closed(conj(*parts), positive(Ne(m, 0), m > 0))
    page.settle("eq15", theorem, *forms, example=shown_at(claim, SWINGING))
