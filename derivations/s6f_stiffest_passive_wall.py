"""How stiff can a passive wall be with any delay?

With a delay of half a period the largest passive stiffness is a root of a polynomial of degree
six. With any delay, the walls that require exactly the damping of the device at one angle lie on a
circle. A passive wall cannot be stiffer than the stiffest wall on this circle.
"""

from symhaptic.book.lemmas.late_passivity import EVERY_MARGIN, GIVEN, LATE, WALL, passive_late
from symhaptic.book.lemmas.passivity import at_every_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.forms import stiffest_passive
from symhaptic.forms.entire import written_out

HALF = theta / 2


def derive(page):
    page.say(
        r"Let $\psi=\theta/2$ and $\kappa=\varepsilon(1-\varepsilon)$. The condition of "
        r"\chapter{s6d_fractional_passivity} contains two means over the delays $\ell$ and "
        r"$\ell+1$: $S=(1-\varepsilon)\sin(\ell+1)\theta+\varepsilon\sin(\ell+2)\theta$, and $C$ "
        "with cosines in place of sines. The means $S$ and $C$ are the imaginary and "
        "real parts of a complex number of known modulus:"
    )
    page.step(
        r"The squares of the two means add up to $1-4\kappa\sin^2\psi$",
        1 - UP**2 - ALONG**2,
        4 * SHARE * sin(HALF) ** 2,
        name="1-S^2-C^2",
    )
    sine, cosine = symbols("S C")
    page.define(r"The fraction enters through the product $\kappa$", kappa, SHARE)
    page.define("The number $S$ is a mean of two sines", sine, UP)
    page.define("The number $C$ is a mean of two cosines", cosine, ALONG)
    across = kappa * K * T * sin(HALF) * cos(HALF) + b * sine
    along = kappa * (K * T + 2 * B) * sin(HALF) ** 2 - b * cosine
    page.step(
        "The walls that require exactly the damping $b$ at an angle lie on a circle",
        4 * SHARE * sin(HALF) ** 2 * fractional.margin(),
        b**2 - across**2 - along**2,
        name=r"4\kappa\sin^2\psi\,\Bigl(b(b-n)-\tfrac\kappa4T^2|H|^2\Bigr)",
        because=r"in the coordinates $KT\cos\psi$ and $(KT+2B)\sin\psi$ the radius is "
        r"$b/(\kappa\sin\psi)$. A passive wall lies inside the circles of all angles",
    )
    found = page.lemma(
        "No passive wall is stiffer than the stiffest wall on a circle",
        bounded_at_every_angle(),
        because="the first of the squares is at most $b^2$, so its root is at most $b$",
        boxed=True,
    )
    page.state(
        "fractional-stiffness-bound",
        r"with a delay of $(\ell+\varepsilon)T$ every passive wall has, for all $0<\theta<\pi$,",
        r"\varepsilon(1-\varepsilon) KT \sin\theta \leq 2b (1 - (1-\varepsilon) "
        r"\sin((\ell+1)\theta) - \varepsilon \sin((\ell+2)\theta))",
        claim=below_the_bound(),
        condition=True,
    )
    point = {K: S.Zero, B: S.Zero, b: S.One, T: S.One, l: S.Zero, epsilon: Rational(1, 2)}
    allowed = SHARE * K * T * sin(theta) <= 2 * b * (1 - UP)
    page.settle("fractional-stiffness-bound", allowed, found, example=point)
    page.say(
        "The smallest bound is at the angle at which the derivative of the bound vanishes. At "
        "this angle one wall on the circle has the stiffness of the bound. A numerical test, but "
        "no proof, shows that this wall satisfies the condition at all other angles."
    )
    page.step(
        "The slope of the bound has the sign of a sum",
        sin(theta) ** 2 * ((1 - UP) / sin(theta)).diff(theta),
        -written_out(stiffest_passive.falling(UP, ALONG)),
        name=r"\sin^2\theta\,\frac{d}{d\theta}\frac{1-S}{\sin\theta}",
    )


# A bound of the stiffness of a passive wall with a fractional delay, at each angle.

SHARE = epsilon * (1 - epsilon)
UP = (1 - epsilon) * sin((l + 1) * theta) + epsilon * sin((l + 2) * theta)
ALONG = (1 - epsilon) * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)
BOUND = proposition(SHARE * K * T * sin(theta) <= 2 * b * (1 - UP))
"""The bound of the stiffness at one angle."""


def below_the_bound() -> Proposition:
    """Every passive wall meets the bound at every angle."""
    return every(WALL, GIVEN, implied([LATE], at_every_angle(BOUND)))


@cache
def bounded_at_every_angle() -> Theorem:
    """The bound follows from the margin, which is a difference of squares."""
    always = conjunct(mp(passive_late(), assume(LATE)), EVERY_MARGIN)
    margin = at(always, {theta: theta}, *(assume(p) for p in INSIDE))
    half = sine_of_half(theta)
    left = b * (1 - UP) - SHARE * K * T * sin(theta / 2) * cos(theta / 2)
    across = SHARE * (K * T + 2 * B) * sin(theta / 2) ** 2 - b * ALONG
    share = epsilon >= 0, positive(1 - epsilon >= 0, epsilon <= 1)
    squares = [square(left)], [square(across)], [4, *share, half, half, margin]
    found = positive(2 * b * left >= 0, *squares)
    found = positive(BOUND, [found, over(1 / b > 0, one(), b > 0)])
    apart = positive(Ne(sin(theta / 2), 0), [half]), positive(Ne(b, 0), b > 0)
    always = for_all([theta], INSIDE, closed(found, *apart))
    return for_all(WALL, GIVEN, add_assum(disch(always, LATE), *GIVEN))
