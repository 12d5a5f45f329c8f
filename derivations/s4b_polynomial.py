"""Which polynomial decides whether the loop is stable?

The sampled device and the delayed wall form a closed loop. Its poles are the roots of one
polynomial. We write it in a form that is regular for every device.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import loop_claim
from symhaptic.book.lemmas.sampled_points import CRITICAL, SWINGING, UNHELD, fails, shown_at
from symhaptic.model import loop, wall
from symhaptic.model.parts import ALL
from symhaptic.notation import function
from symhaptic.paper.propositions.device import WALL


def derive(page):
    device = plant.sampled(plant.normalised(FULL), split=c_1)
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    short = (z**2 - a * z + e) * z ** (d + 1) + (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    plain = (n_1 * z + n_0) / (z**2 - a * z + e)
    push = ((alpha + beta) * z - beta) / z ** (d + 1)
    page.say("The loop has the sampled device $P$ and the delayed wall, in units of $m$ and $T$:")
    page.step(
        "In units of $m/T^2$ the delayed wall is dimensionless",
        wall.normalised(FULL)[0] / wall.normalised(FULL)[1],
        (alpha + beta * (1 - 1 / z)) * z ** (-d),
        name=r"\tfrac{T^2}{m}H_d(z)",
    )
    page.step(
        "The closed loop is a quotient with one denominator",
        plain / (1 + plain * push),
        (n_1 * z + n_0) * z ** (d + 1) / short,
        name=r"\tfrac{m}{T^2}G_x",
        because="numerator and denominator of $P/(1+PHz^{-d})$ are multiplied by the denominators "
        "of $P$ and $Hz^{-d}$",
        paper="16",
    )
    page.say("The denominator is monic for every device:")
    page.step(
        "The characteristic polynomial has the leading coefficient 1",
        loop.closing(plant.Sampled(n_1, n_0, a, e)),
        short,
        name="p_1(z)",
        boxed=True,
    )
    n, p, closed = function("n")(z), function("p")(z), function("G_x")(z)
    scale = -2 * c_1 * gamma
    top, bottom = scale * device.numerator, scale * loop.characteristic(split=c_1)
    page.say("The paper uses the abbreviations (15):")
    for title, name, meaning in (
        ("The difference of the poles", c_1, sqrt(delta**2 - 4 * gamma)),
        ("The image of the faster pole", c_2, exp(-(delta + c_1) / 2)),
        ("The image of the slower pole", c_3, exp(-(delta - c_1) / 2)),
    ):
        page.define(title, name, meaning)
    [seventeen], [eighteen] = STATEMENTS["eq17"].printed, STATEMENTS["eq18"].printed
    page.define("The numerator (17) of the paper", n, seventeen.rhs)
    page.define("The denominator (18) of the paper", p, eighteen.rhs)
    page.same("(18) is p_1 times a factor", eighteen.rhs, bottom)
    page.say(
        r"For the device's $n_1$, $n_0$, $a$ and $e$ we find $p(z)=-2c_1\gamma\,p_1(z)$. The "
        r"factor $-2c_1\gamma$ vanishes for a device without an arm and at critical damping, so "
        "that $n(z)$ and $p(z)$ vanish identically."
    )
    _settle(page, "eq17", Eq(n, top), r"$n(z)\equiv0$ for a device without an arm", late=False)
    _settle(
        page,
        "eq18",
        Eq(p, bottom),
        r"$p(z)\equiv0$ for a device without an arm: every $z$ would be a pole",
    )
    _settle(page, "eq16", Eq(closed, loop.closed(split=c_1)), "(16) is $0/0$ without an arm")
    _scenes(page)


def _settle(page, id, form, shows, late=True):
    """The form is right for integer delays if it is not 0/0 for the device."""
    claim = page.claim(id)
    bottom = STATEMENTS["eq18"].printed[0].rhs
    split, spring, steps = Ne(c_1, 0), Ne(gamma, 0), whole(d)
    conditions = (split, spring, *([steps] if late else []))
    example, *cases = _points(claim, conditions)
    page.settle(
        id,
        loop_claim(claim, conditions, bottom if late else bottom.subs(d, 0), WALL, late),
        form,
        example=example,
        unless=cases,
        shows=shows,
    )


@cache
def _points(claim, conditions):
    """A point at which all conditions hold, and points at which exactly one condition fails."""
    split, spring, *steps = conditions
    cases = [(UNHELD, spring), (CRITICAL, split), *((SWINGING | {d: S.Half}, s) for s in steps)]
    return [
        shown_at(claim, SWINGING, *conditions),
        *(
            fails(claim, point, holds=[c for c in conditions if c is not but], but=but)
            for point, but in cases
        ),
    ]


def _scenes(page):
    page.say(
        "A loop without spring, damper, virtual damping or delay has a smaller polynomial. We "
        "derive it and show that it is the limit of the larger polynomial."
    )
    page.say(
        "Under a unit force a free mass moves by half a unit in the first period. With a damper "
        "the speed of the mass decays. With a spring the mass oscillates with the frequency "
        r"$\Omega=\sqrt\gamma$."
    )
    free, damped = (
        plant.sampled(plant.normalised(parts))
        for parts in (Parts(False, False), Parts(False, True))
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)), split=2 * I * Omega)
    swings = swinging.transfer.subs(gamma, Omega**2)
    still = page.step(
        "The four coefficients of a free mass are rational numbers",
        free.transfer,
        (z + 1) / (2 * (z - 1) ** 2),
        name=r"P(z)\big|_{\gamma=\delta=0}",
    )
    fade = exp(-delta)
    fading = page.step(
        "The coefficients of a damped mass contain one exponential",
        damped.transfer,
        ((delta - 1 + fade) * z + 1 - (1 + delta) * fade) / (delta**2 * (z - 1) * (z - fade)),
        name=r"P(z)\big|_{\gamma=0}",
    )
    swinging = page.step(
        "The coefficients of a mass on a spring contain one cosine",
        swings,
        (1 - cos(Omega)) * (z + 1) / (Omega**2 * (z**2 - 2 * cos(Omega) * z + 1)),
        name=r"P(z)\big|_{\delta=0}",
    )
    page.say("Each transfer function is the limit of that of a device with one more part:")
    general = plant.sampled(plant.normalised(Parts()), split=c).transfer.subs(
        gamma, (delta**2 - c**2) / 4
    )
    page.limit(
        "With the spring removed the device is the damped mass",
        general,
        c,
        delta,
        fading,
        name="P",
        because=r"the limit $c\to\delta$ means $\gamma\to0$, since $c^2=\delta^2-4\gamma$",
    )
    page.limit(
        "With the damper removed the device is the mass on a spring",
        general.subs(c, 2 * I * Omega),
        delta,
        S.Zero,
        swinging,
        name="P",
        because=r"the limit is taken along $\gamma=\Omega^2+\delta^2/4$, that is, $c=2j\Omega$",
    )
    page.limit(
        "Without its damper the damped mass is free",
        damped.transfer,
        delta,
        S.Zero,
        still,
        name="P",
    )
    page.limit(
        "Without its spring the other mass is free, too", swings, Omega, S.Zero, still, name="P"
    )

    page.say("The loop of wall and sampled device has one of four characteristic polynomials:")
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    for title, kept, shape in (
        (
            "With damping and delay the degree is $d+3$",
            Parts(),
            bottom * z ** (d + 1) + top * ((alpha + beta) * z - beta),
        ),
        (
            "With damping and without delay the polynomial is cubic",
            Parts(delay=False),
            bottom * z + top * ((alpha + beta) * z - beta),
        ),
        (
            "With delay and without virtual damping the degree is $d+2$",
            Parts(virtual_damping=False),
            bottom * z**d + alpha * top,
        ),
        (
            "With neither damping nor delay the polynomial is quadratic",
            Parts(virtual_damping=False, delay=False),
            bottom + alpha * top,
        ),
    ):
        made = loop.closing(plant.Sampled(n_1, n_0, a, e), kept)
        page.step(title, made, shape, name="p_1(z)")

    count = 0
    for parts in ALL:
        larger = _polynomial(parts)
        for name in parts.present():
            smaller = _polynomial(parts.without(name))
            _limit(page, parts, name, larger, smaller)
            count += 1
    page.say(
        f"The characteristic polynomials of all {len(ALL)} scenes follow from these four and "
        f"from the wall. We check that each of the {count} ways to leave out one part is a "
        "limit. Without virtual damping, the polynomial loses a root at 0, which has no effect "
        "on stability. Without delay, it loses the power of $z$."
    )
    least = _polynomial(Parts(False, False, False, False))
    page.step(
        "The smallest scene has a quadratic polynomial",
        least,
        (z - 1) ** 2 + alpha * (z + 1) / 2,
        name="p_1(z)",
    )


def _polynomial(parts):
    """The polynomial of a scene, in terms of the difference of its poles, c or 2j Omega."""
    if not parts.stiffness:
        return loop.characteristic(parts)
    split = c if parts.damping else 2 * I * Omega
    stiffness = (delta**2 - c**2) / 4 if parts.damping else Omega**2
    return loop.characteristic(parts, split).subs(gamma, stiffness)


def _limit(page, parts, name, larger, smaller):
    """``larger`` tends to ``smaller``; without beta, up to the root at 0."""
    if name == "virtual_damping":
        page.same(f"{parts.name} without {name}", larger.subs(beta, 0), z * smaller)
    elif name == "delay":
        page.limits(larger, d, S.Zero, smaller)
    elif name == "stiffness" and parts.damping:
        page.limits(larger, c, delta, smaller)
    elif name == "stiffness":
        page.limits(larger, Omega, S.Zero, smaller)
    elif parts.stiffness:
        page.limits(larger, delta, S.Zero, smaller.subs(Omega, c / (2 * I)))
    else:
        page.limits(larger, delta, S.Zero, smaller)
