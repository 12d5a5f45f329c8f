r"""What remains when a part of the loop is not there?

A loop without spring, damper, virtual damping or delay has a smaller polynomial of its own. It
is derived without the missing part, and shown to be what the larger one tends to.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop
from symhaptic.model.parts import ALL


def derive(page):
    page.say(
        "The free mass moves by half a unit per unit force and period; with a damper its speed "
        "decays; with a spring it swings, $\\Omega=\\sqrt\\gamma$."
    )
    free, damped = (
        plant.sampled(plant.normalised(parts))
        for parts in (Parts(False, False), Parts(False, True))
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)), split=2 * I * Omega)
    swings = swinging.transfer.subs(gamma, Omega**2)
    still = page.step(
        "A free mass has four plain numbers",
        free.transfer,
        (z + 1) / (2 * (z - 1) ** 2),
        name=r"P(z)\big|_{\gamma=\delta=0}",
    )
    fade = exp(-delta)
    fading = page.step(
        "A damped mass has one exponential",
        damped.transfer,
        ((delta - 1 + fade) * z + 1 - (1 + delta) * fade) / (delta**2 * (z - 1) * (z - fade)),
        name=r"P(z)\big|_{\gamma=0}",
    )
    swinging = page.step(
        "A mass on a spring has one cosine",
        swings,
        (1 - cos(Omega)) * (z + 1) / (Omega**2 * (z**2 - 2 * cos(Omega) * z + 1)),
        name=r"P(z)\big|_{\delta=0}",
    )
    page.say("Each is the limit of a larger one, by exact series:")
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
        because="$c\\to\\delta$ is $\\gamma\\to0$, since $c^2=\\delta^2-4\\gamma$",
    )
    page.limit(
        "With the damper removed it is the mass on a spring",
        general.subs(c, 2 * I * Omega),
        delta,
        S.Zero,
        swinging,
        name="P",
        because="along $\\gamma=\\Omega^2+\\delta^2/4$, that is $c=2j\\Omega$",
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

    page.say("With the wall the sampled device closes to one of four polynomials:")
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
        f"The characteristic polynomials of all {len(ALL)} scenes follow from these and from the "
        f"wall; each of the {count} ways to leave out one part is checked to be a limit. Without "
        "virtual damping the polynomial loses a root at 0 that means nothing; without delay it "
        "loses the power of $z$."
    )
    least = _polynomial(Parts(False, False, False, False))
    page.step(
        "The smallest scene leaves a cubic",
        least,
        (z - 1) ** 2 + alpha * (z + 1) / 2,
        name="p_1(z)",
    )


def _polynomial(parts):
    """The scene's own polynomial; c and 2j Omega name the difference of its poles."""
    if not parts.stiffness:
        return loop.characteristic(parts)
    split = c if parts.damping else 2 * I * Omega
    stiffness = (delta**2 - c**2) / 4 if parts.damping else Omega**2
    return loop.characteristic(parts, split).subs(gamma, stiffness)


def _limit(page, parts, name, larger, smaller):
    """``smaller`` is what ``larger`` tends to; without beta, up to the root at 0."""
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
