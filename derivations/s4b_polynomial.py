r"""Which polynomial decides whether the loop is stable?

The sampled device and the delayed wall are closed to a loop. Its poles are the roots of one
polynomial, and its form should not break down for the devices that one meets.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import loop_claim
from symhaptic.book.lemmas.sampled_points import CRITICAL, SWINGING, UNHELD, fails, shown_at
from symhaptic.model import loop, wall
from symhaptic.notation import function
from symhaptic.paper.propositions.device import WALL


def derive(page):
    device = plant.sampled(plant.normalised(FULL), split=c_1)
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    short = (z**2 - a * z + e) * z ** (d + 1) + (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    plain = (n_1 * z + n_0) / (z**2 - a * z + e)
    push = ((alpha + beta) * z - beta) / z ** (d + 1)
    page.say("With the sampled device $P$ and the delayed wall, in units of $m$ and $T$:")
    page.step(
        "In these numbers the delayed wall has no unit",
        wall.normalised(FULL)[0] / wall.normalised(FULL)[1],
        (alpha + beta * (1 - 1 / z)) * z ** (-d),
        name=r"\tfrac{T^2}{m}H_d(z)",
    )
    page.step(
        "The closed loop is a quotient with one denominator",
        plain / (1 + plain * push),
        (n_1 * z + n_0) * z ** (d + 1) / short,
        name=r"\tfrac{m}{T^2}G_x",
        because="$P/(1+PHz^{-d})$, both sides multiplied by the two denominators",
        paper="16",
    )
    page.say("The denominator is monic and never degenerates:")
    page.step(
        "The characteristic polynomial, with the highest coefficient 1",
        loop.closing(plant.Sampled(n_1, n_0, a, e)),
        short,
        name="p_1(z)",
        boxed=True,
    )
    n, p, closed = function("n")(z), function("p")(z), function("G_x")(z)
    scale = -2 * c_1 * gamma
    top, bottom = scale * device.numerator, scale * loop.characteristic(split=c_1)
    page.say("The abbreviations (15) of the paper are")
    for title, name, meaning in (
        ("The difference of the poles", c_1, sqrt(delta**2 - 4 * gamma)),
        ("the image of the faster pole", c_2, exp(-(delta + c_1) / 2)),
        ("and that of the slower one", c_3, exp(-(delta - c_1) / 2)),
    ):
        page.define(title, name, meaning)
    [seventeen], [eighteen] = STATEMENTS["eq17"].printed, STATEMENTS["eq18"].printed
    page.define("With them the paper writes the numerator (17)", n, seventeen.rhs)
    page.define("and the denominator (18)", p, eighteen.rhs)
    page.same("(18) is p_1 times a factor", eighteen.rhs, bottom)
    page.say(
        "With the device's $n_1$, $n_0$, $a$ and $e$ this is $p(z)=-2c_1\\gamma\\,p_1(z)$. The "
        "factor vanishes for a device that nobody holds and at critical damping, and with it all "
        "of $n(z)$ and $p(z)$."
    )
    _settle(page, "eq17", Eq(n, top), r"$n(z)\equiv0$ for an ungrabbed device", late=False)
    _settle(
        page,
        "eq18",
        Eq(p, bottom),
        r"$p(z)\equiv0$ for an ungrabbed device: every $z$ would be a pole",
    )
    _settle(page, "eq16", Eq(closed, loop.closed(split=c_1)), r"$0/0$ for an ungrabbed device")


def _settle(page, id, form, shows, late=True):
    """Right for every loop whose device the print does not turn to 0/0, behind whole delays."""
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
    """A point at which all conditions hold, and for each one at which it alone does not."""
    split, spring, *steps = conditions
    cases = [(UNHELD, spring), (CRITICAL, split), *((SWINGING | {d: S.Half}, s) for s in steps)]
    return [
        shown_at(claim, SWINGING, *conditions),
        *(
            fails(claim, point, holds=[c for c in conditions if c is not but], but=but)
            for point, but in cases
        ),
    ]
