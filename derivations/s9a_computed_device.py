r"""Is the device that is computed the device that is derived?

The numbers of the sampled device are quotients that are 0/0 without a spring and at critical
damping, and that lose digits near by. What is computed is made of entire functions, which have
power series everywhere. Both are held against each other, the number that is computed beside the
number that was derived.
"""

from symhaptic.book.lemmas.computed import settle, upright
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_device import (
    CONDITIONS,
    DERIVED,
    DISCRETE,
    POLYNOMIAL,
    SPRING,
    computed,
    in_poles,
)
from symhaptic.forms.entire import (
    Creep,
    Decay,
    DenominatorAtMinusOne,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
)

OWN = (
    (PlantN1, "A function is the way under a force that is held for a period"),
    (PlantN0, "A function is the way that this force leaves for the period after it"),
    (PlantTrace, "A function is the sum of the poles of the sampled device"),
    (NumeratorAtOne, "A function is what both ways are together"),
    (DenominatorAtMinusOne, "A function is the denominator at $z=-1$"),
    (NumeratorGap, "A function is what both ways are apart, over the damping"),
)
NUMBERS = (
    (0, n_1, S.One, PlantN1, "The way under the force is computed by the first of them"),
    (1, n_0, S.One, PlantN0, "The way that is left is computed by the second"),
    (2, a, S.One, PlantTrace, "The sum of the poles is computed by the third"),
    (4, "1-a+e", gamma, NumeratorAtOne, "At $z=1$ the denominator has the spring in it"),
    (5, "1+a+e", S.One, DenominatorAtMinusOne, "At $z=-1$ the denominator is a product"),
    (7, "n_1+n_0", S.One, NumeratorAtOne, "At $z=1$ the numerator is a product over the spring"),
    (8, "n_1-n_0", delta, NumeratorGap, "At $z=-1$ the numerator has the damper in it"),
)
"""Their places among the numbers of a device, and how they are computed."""
GIVEN = {gamma: SPRING}


def derive(page):
    page.say(
        "Let $c=\\sqrt{\\delta^2-4\\gamma}$ be the difference of the poles of the device, so that "
        "$\\gamma=(\\delta^2-c^2)/4$. Six functions of $\\gamma$ and $\\delta$ are computed. Each "
        "is even in $c$, so that it does not matter which root is meant, and no pole is left in "
        "any of them: where the formula divides by zero, the function has its limit."
    )
    page.define("The spring by the difference of the poles", gamma, SPRING)
    for own, title in OWN:
        page.define(title, upright(own(gamma, delta)), in_poles(own(gamma, delta)))
    exact = plant.sampled(plant.normalised(FULL), split=c)
    device = {n_1: exact.n1, n_0: exact.n0, a: exact.a, e: exact.e}
    page.say(
        "The derived numbers are $n_1$, $n_0$, $a$ and $e$ of the transition matrix, which "
        "\\chapter{s4b_normalisation} finds for (14):"
    )
    for place, left, factor, own, title in NUMBERS:
        derived = DERIVED.numbers[place].xreplace(device)
        page.same(title, computed()[place].xreplace(GIVEN), derived.xreplace(GIVEN))
        page.step(title, derived, factor * upright(own(gamma, delta)), name=left)
    page.say(
        "Digits are kept by the functions, and not by these formulas. Where $\\gamma$ and "
        "$\\delta$ are near $10^{-6}$, the numerator of PlantN1 is a difference of numbers next "
        "to 1 that is itself next to $\\gamma/2$, and of sixteen digits nine or ten are left; its "
        "power series begins with $\\frac12$ and loses none. In the same way $1-a+e$ is no sum of "
        "numbers near 1, $-2$ and 1, $n_1-n_0$ is no difference of two numbers near $\\frac12$, "
        "and $1-e$ is computed as $\\delta$ times the function that follows."
    )
    loss, free = Decay.definition(delta), Creep.definition(delta)
    page.define("A function is the loss of speed over the damping", upright(Decay(delta)), loss)
    page.limit("Without a damper it is 1", loss, delta, S.Zero, S.One, name=upright(Decay(delta)))
    page.limit(
        "Without a spring the way under a force is that of a mass with a damper",
        computed()[0].xreplace(GIVEN),
        c,
        delta,
        free,
        name=upright(PlantN1(gamma, delta)),
        because="so that $\\gamma$ tends to 0",
    )
    page.limit("Of a free mass this way is one half", free, delta, S.Zero, S.Half)
    critical = plant.sampled(plant.Plant(S.One, delta, delta**2 / 4)).n1
    page.limit(
        "At critical damping $n_1$ is that of the device with a double pole",
        computed()[0].xreplace(GIVEN),
        c,
        S.Zero,
        critical,
        name=upright(PlantN1(gamma, delta)),
    )
    settle(
        page,
        "discretize",
        (DISCRETE,),
        "the computed numbers $n_1$, $n_0$, $a$ and $e$ of the device are those of its transition "
        "matrix, wherever nothing in either is divided by zero",
    )
    page.say(
        "The coefficients of the characteristic polynomial are made of these four numbers, as in "
        "(18). They are computed for one whole delay at a time; the theorem has $d=2$."
    )
    settle(
        page,
        "characteristic_polynomial",
        (POLYNOMIAL,),
        "the computed coefficients are those of the characteristic polynomial of the derived "
        "device, here for $d=2$",
    )
    _conditions(page)


def _conditions(page):
    q, loss = symbols("q L")
    page.say(
        "Verdicts are computed from the same numbers. The inequalities of Jury are those of a "
        "polynomial whose coefficients are made of $L=1-e$ and of $q=1-a+e$:"
    )
    page.step(
        "The denominator is made of the loss and of its value at 1",
        z**2 - (2 - loss - q) * z + 1 - loss,
        (z - 1) ** 2 + (loss + q) * (z - 1) + q,
        because="of a slow device both numbers are small, and $a$ and $e$, near 2 and 1, would "
        "keep few of their digits",
    )
    settle(
        page,
        "stability_conditions",
        (CONDITIONS,),
        "the computed inequalities are those of the derived device: $n_1$, $n_0$, $1-a+e$ and "
        "$1-e$ are the derived ones",
    )
