r"""Is the damping that is computed for a wall the damping that is derived?

What a wall needs at an angle is a quotient of sines that is 0/0 for slow motions, and its slope is
a difference of such quotients. Both are computed with functions that have no pole there, and whose
products with the delay are not rounded.
"""

from sympy import S, cos, sin

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.stable_need import MARGIN, NEEDS, straight
from symhaptic.forms import required_damping
from symhaptic.forms.entire import Chord, CosNext, Sinc, SinNext, Spread, written_out
from symhaptic.model import fractional, passivity
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, l, psi, theta

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
    page.define("A function is a sine over its angle", r"\mathrm{Sinc}(\psi)", Sinc.definition(psi))
    for function, title in TURNED:
        page.define(title, name(function), function.definition(d, theta))
    page.say(
        "Where they are divided by the angle they are not divided by zero: at the angle 0 each has "
        "its limit. The numerators of the last two are differences of sines that agree up to the "
        "third power of the angle; at $\\theta=10^{-5}$ not one of sixteen digits would be left."
    )
    for function, first in FIRST.items():
        page.limit(
            f"At the angle 0 the function {function.__name__} has a value",
            function.definition(d, theta),
            theta,
            S.Zero,
            first,
            name=name(function),
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
    sine = SinNext(2 * d, theta / 2) / (2 * sin(theta / 2))
    page.show(
        "The margin at an angle has two functions",
        r"\delta-\delta_\mathrm{min}",
        r"\delta-\frac{\alpha\,\mathrm{SinNext}(2d,\theta/2)}{2\sin(\theta/2)}"
        r"+\beta\,\mathrm{CosNext}(d,\theta)",
        page.same("margin", delta - alpha * written_out(sine) + beta * turned(), margin),
    )
    page.say(
        "For a delay of $\\ell+\\varepsilon$ periods the need $n$ of a straight motion is the mean "
        "over the whole delays $\\ell$ and $\\ell+1$. One sine and one cosine of "
        "$(\\ell+1)\\theta$ are enough for it:"
    )
    page.show(
        "The need of a straight motion has one sine and one cosine",
        "n",
        r"\frac\alpha2\left(\frac{2\cos^2(\theta/2)}{\sin\theta}\,\mathrm{SinNext}(\ell,\theta)"
        r"-(1-2\varepsilon)\,\mathrm{CosNext}(\ell,\theta)\right)"
        r"\br-\beta\left((1-\varepsilon)\,\mathrm{CosNext}(\ell,\theta)"
        r"+\varepsilon\,(\cos\theta\,\mathrm{CosNext}(\ell,\theta)"
        r"-\sin\theta\,\mathrm{SinNext}(\ell,\theta))\right)",
        page.same(
            "need at an angle",
            written_out(required_damping.straight_at()),
            fractional.required_straight().xreplace(UNITS),
        ),
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
    page.show(
        "The need of a straight motion has no pole at the angle 0",
        "n",
        r"\alpha\,(2\ell+1)\,\frac{\mathrm{Sinc}((2\ell+1)\psi)}{2\,\mathrm{Sinc}(\psi)}"
        r"-\beta\,\mathrm{CosNext}(\ell,2\psi)",
        page.same("need", written_out(required_damping.straight(l)), whole),
    )
    page.show(
        "Its slope has the angle as a factor",
        r"\frac{dn}{d\psi}",
        r"\psi\left(4(\ell+1)^2\bigl(\beta+\tfrac\alpha2\bigr)\mathrm{Sinc}(2(\ell+1)\psi)"
        r"-\frac{2\alpha\,\mathrm{Chord}(\ell,2\psi)}{\mathrm{Sinc}^2(\psi)}\right)",
        page.same("slope", written_out(psi * required_damping.steepness(l)), whole.diff(psi)),
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


def turned():
    """cos((d + 1) theta), as a function that is written out."""
    return written_out(CosNext(d, theta))


def name(function):
    """A function upright, of a delay and an angle."""
    return rf"\mathrm{{{function.__name__}}}(d,\theta)"
