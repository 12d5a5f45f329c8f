r"""Is the damping that is computed for a wall the damping that is derived?

What a wall needs at an angle is a quotient of sines that is 0/0 for slow motions, and its slope is
a difference of such quotients. Both are computed with functions that have no pole there, and whose
products with the delay are not rounded.
"""

from symhaptic.book.lemmas.computed import settle, upright
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_need import MARGIN, NEEDS, straight
from symhaptic.forms import required_damping
from symhaptic.forms.entire import Chord, CosNext, Sinc, SinNext, Spread

UNITS = {K: alpha, B: beta, T: S.One, b: delta}
TURNED = (
    (CosNext, "A function is the cosine of the angle that the delay and a period turn"),
    (SinNext, "A function is the sine of this angle"),
    (Spread, "A function is how far two sines are spread"),
    (Chord, "A function is how far a sine is from its chord"),
)
FIRST = {
    Spread: (d + 1) * (2 * d + 1) * (2 * d + 3) / 3,
    Chord: (d + 1) * (2 * d**2 + 4 * d + 3) / 3,
}
"""What the last two are at the angle 0."""


def derive(page):
    page.say("Five functions are computed, one of an angle, and four of a delay and an angle:")
    page.define("A function is a sine over its angle", upright(Sinc(psi)), Sinc.definition(psi))
    for of, title in TURNED:
        page.define(title, upright(of(d, theta)), of.definition(d, theta))
    page.say(
        "Where they are divided by the angle they are not divided by zero: at the angle 0 each has "
        "its limit. The numerators of the last two are differences of sines that agree up to the "
        "third power of the angle; at $\\theta=10^{-5}$ not one of sixteen digits would be left."
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
        "For a whole delay (5) gives the margin at one angle. The sine in it, of "
        "$(d+\\frac12)\\theta$, is computed as that of $2d+1$ half angles, whose product is not "
        "rounded:"
    )
    margin = passivity.margin().xreplace(UNITS)
    page.step(
        "The margin at an angle has two functions",
        margin,
        delta
        - alpha * upright(SinNext(2 * d, theta / 2)) / (2 * sin(theta / 2))
        + beta * upright(CosNext(d, theta)),
        name=r"\delta-\delta_\mathrm{min}",
    )
    page.say(
        "For a delay of $\\ell+\\varepsilon$ periods the need $n$ of a straight motion is the mean "
        "over the whole delays $\\ell$ and $\\ell+1$. One sine and one cosine of "
        "$(\\ell+1)\\theta$ are enough for it:"
    )
    page.step(
        "The need of a straight motion has one sine and one cosine",
        fractional.required_straight().xreplace(UNITS),
        upright(required_damping.straight_at()),
        name="n",
    )
    page.say(
        "All motions need the positive solution $b$ of "
        "$b^2-bn-\\tfrac14\\varepsilon(1-\\varepsilon)s=0$, where $s$ is the square of the wall's "
        "size. The margin is $\\delta-b$."
    )
    settle(
        page,
        "passivity_margin_at",
        (MARGIN,),
        "the computed margin at an angle is the derived one: (5) for whole delays, and the margin "
        "of the worst motion for delays with a fraction",
    )


def _at_the_worst(page):
    page.say(
        "The worst angle is searched for, up to the angle 0, with $\\psi=\\theta/2$. There the "
        "need of a straight motion is a quotient of two Sinc, and its derivative by $\\psi$ is "
        "$\\psi$ times a number that does not vanish with the angle, so that its sign is known "
        "next to 0, too:"
    )
    whole = straight(l)
    page.step(
        "The need of a straight motion has no pole at the angle 0",
        whole,
        upright(required_damping.straight(l)),
        name="n",
    )
    page.step(
        "Its slope has the angle as a factor",
        whole.diff(psi),
        upright(psi * required_damping.steepness(l)),
        name=r"\frac{dn}{d\psi}",
    )
    page.say(
        "Behind $\\ell+\\varepsilon$ periods $n$ is the mean over the two whole delays beside, and "
        "all motions need the positive root of $b^2-bn-\\varepsilon(1-\\varepsilon)s/4$, with the "
        "square $s=\\alpha^2+4\\beta(\\alpha+\\beta)\\sin^2\\psi$ of the wall's size. The squares "
        "of $s$ are computed so that each of them is positive:"
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
        "the computed need at an angle, its change with the angle and with the wall's damping are "
        "the derived ones, for whole delays and for those with a fraction; the worst angle is "
        "searched for by these",
    )
