"""The computed required damping equals the derived one

The required damping at an angle is a quotient of sines that is 0/0 at the angle 0, and its slope
is a difference of such quotients. The program computes the damping and its slope with functions
that have no pole at the angle 0. It does not round the product of angle and delay.
"""

from symhaptic.book.lemmas.computed import settle, upright
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_need import MARGIN, NEEDS, straight
from symhaptic.forms import required_damping
from symhaptic.forms.entire import Chord, CosNext, Sinc, SinNext, Spread

UNITS = {K: alpha, B: beta, T: S.One, b: delta}
TURNED = (
    (CosNext, r"The cosine of $(d+1)\theta$"),
    (SinNext, r"The sine of $(d+1)\theta$"),
    (Spread, "The function Spread, a difference of two sines"),
    (Chord, "The function Chord, the distance of a sine from its chord"),
)
FIRST = {
    Spread: (d + 1) * (2 * d + 1) * (2 * d + 3) / 3,
    Chord: (d + 1) * (2 * d**2 + 4 * d + 3) / 3,
}
"""The values of the last two functions at the angle 0."""


def derive(page):
    page.say(
        "The program computes five functions: one function of an angle, and four functions of "
        "a delay and an angle:"
    )
    page.define(
        "The function Sinc, a sine over its angle", upright(Sinc(psi)), Sinc.definition(psi)
    )
    for of, title in TURNED:
        page.define(title, upright(of(d, theta)), of.definition(d, theta))
    page.say(
        "At the angle 0, the value of each function is its limit. The numerators of the last two "
        "functions are differences of sines that cancel up to the third power of the angle. At "
        r"$\theta=10^{-5}$ such a difference would keep none of sixteen digits."
    )
    for of, first in FIRST.items():
        page.limit(
            f"At the angle 0 the function {of.__name__} has a value",
            of.definition(d, theta),
            theta,
            S.Zero,
            first,
            name=upright(of(d, theta)),
        )
    _at_an_angle(page)
    _at_the_worst(page)


def _at_an_angle(page):
    page.say(
        "For an integer delay, (5) gives the margin at each angle. The margin contains the sine "
        r"of $(d+\frac12)\theta$. The program computes this sine from $2d+1$ and half the angle "
        "and does not round their product:"
    )
    margin = passivity.margin().xreplace(UNITS)
    page.step(
        "In the margin at an angle, stiffness and damping are each multiplied by one function",
        margin,
        delta
        - alpha * upright(SinNext(2 * d, theta / 2)) / (2 * sin(theta / 2))
        + beta * upright(CosNext(d, theta)),
        name=r"\delta-\delta_\mathrm{min}",
    )
    page.say(
        r"For a delay of $\ell+\varepsilon$ periods a motion with $q=0$ requires a damping $n$, "
        r"which is the mean of the required dampings for the integer delays $\ell$ and $\ell+1$. "
        r"One sine and one cosine of $(\ell+1)\theta$ are sufficient:"
    )
    page.step(
        "The required damping for $q=0$ contains one sine and one cosine",
        fractional.required_straight().xreplace(UNITS),
        upright(required_damping.straight_at()),
        name="n",
    )
    page.say(
        "The required damping for all motions is the positive solution $b$ of "
        r"$b^2-bn-\tfrac14\varepsilon(1-\varepsilon)s=0$, where $s$ is the square of the wall's "
        r"size. The margin is $\delta-b$."
    )
    settle(
        page,
        "passivity_margin_at",
        (MARGIN,),
        "the computed margin at an angle is the derived one: (5) for integer delays, and the "
        "margin of the worst motion for delays with a fraction",
    )


def _at_the_worst(page):
    page.say(
        r"A search finds the worst angle, which may be 0. Let $\psi=\theta/2$. The required "
        "damping for $q=0$ contains a quotient of two values of Sinc. Its derivative with "
        r"respect to $\psi$ is $\psi$ times a number that does not vanish with the angle. So the "
        "program computes the sign of the derivative accurately, even near 0:"
    )
    whole = straight(l)
    page.step(
        "The required damping for $q=0$ has no pole at the angle 0",
        whole,
        upright(required_damping.straight(l)),
        name="n",
    )
    page.step(
        r"The slope of the required damping contains the factor $\psi$",
        whole.diff(psi),
        upright(psi * required_damping.steepness(l)),
        name=r"\frac{dn}{d\psi}",
    )
    page.say(
        r"With a delay of $\ell+\varepsilon$ periods the required damping is the positive root of "
        r"$b^2-bn-\varepsilon(1-\varepsilon)s/4$. Here $s=\alpha^2+4\beta(\alpha+\beta)\sin^2\psi$ "
        "is the square of the wall's size. The program computes $s$ as a sum of terms that are not "
        "negative:"
    )
    size = fractional.stiffness_squared(2 * psi).xreplace(UNITS)
    page.step(
        "The square of the wall's size is a sum of squares",
        size,
        alpha**2 * cos(psi) ** 2 + (alpha + 2 * beta) ** 2 * sin(psi) ** 2,
        name="s",
    )
    settle(
        page,
        "passivity_margin",
        (NEEDS,),
        "the computed required damping at an angle and its derivatives are the derived ones, for "
        "integer and fractional delays; the search for the worst angle uses these",
    )
