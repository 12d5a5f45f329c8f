"""Are the computed coefficients of the device equal to the derived ones?

The coefficients of the sampled device are quotients. Without a spring and at critical damping they
are 0/0, and near these cases they lose digits. The computed form consists of entire functions,
which have power series everywhere. We prove that the two forms are equal.
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
    (PlantN1, "The displacement under a force that is held for a period"),
    (PlantN0, "The further displacement in the next period"),
    (PlantTrace, "The sum of the poles of the sampled device"),
    (NumeratorAtOne, "The sum of both displacements"),
    (DenominatorAtMinusOne, "The denominator at $z=-1$"),
    (NumeratorGap, "The difference of both displacements over the damping"),
)
NUMBERS = (
    (0, n_1, S.One, PlantN1, "$n_1$ is computed by the first function"),
    (1, n_0, S.One, PlantN0, "$n_0$ is computed by the second function"),
    (2, a, S.One, PlantTrace, "$a$ is computed by the third function"),
    (4, "1-a+e", gamma, NumeratorAtOne, r"At $z=1$ the denominator contains the factor $\gamma$"),
    (5, "1+a+e", S.One, DenominatorAtMinusOne, "At $z=-1$ the denominator is a product"),
    (7, "n_1+n_0", S.One, NumeratorAtOne, "At $z=1$ the numerator is a product over the spring"),
    (8, "n_1-n_0", delta, NumeratorGap, r"At $z=-1$ the numerator contains the factor $\delta$"),
)
"""The index of each number of a device, and how the program computes it."""
GIVEN = {gamma: SPRING}


def derive(page):
    page.say(
        r"Let $c=\sqrt{\delta^2-4\gamma}$ be the difference of the poles of the device, so "
        r"$\gamma=(\delta^2-c^2)/4$. The program computes six functions of $\gamma$ and "
        r"$\delta$. Each function is even in $c$, so the sign of the root does not matter. "
        "None of them has a pole: if the formula divides by zero, the value of the function is "
        "the limit."
    )
    page.define("The difference $c$ of the poles gives the spring", gamma, SPRING)
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
        r"These functions are accurate, but the formulas above are not. For $\gamma$ and $\delta$ "
        r"near $10^{-6}$ the numerator of PlantN1 is of the size $\gamma/2$, but it is a "
        "difference of numbers near 1. So only nine or ten of sixteen digits remain. The power "
        r"series begins with $\frac12$ and loses no digits. For the same reason, separate "
        "functions compute $1-a+e$ and $n_1-n_0$. Computed directly, the first would be a sum of "
        r"numbers near 1, $-2$ and 1, and the second a difference of two numbers near $\frac12$. "
        r"The program computes $1-e$ as $\delta$ times the following function."
    )
    loss, free = Decay.definition(delta), Creep.definition(delta)
    page.define(
        "The function Decay is the loss of speed divided by the damping",
        upright(Decay(delta)),
        loss,
    )
    page.limit(
        "Without a damper the function Decay is 1",
        loss,
        delta,
        S.Zero,
        S.One,
        name=upright(Decay(delta)),
    )
    page.limit(
        "Without a spring $n_1$ is that of a mass with a damper",
        computed()[0].xreplace(GIVEN),
        c,
        delta,
        free,
        name=upright(PlantN1(gamma, delta)),
        because=r"here $c$ tends to $\delta$, so $\gamma$ tends to 0",
    )
    page.limit(r"For a free mass $n_1=\frac12$", free, delta, S.Zero, S.Half)
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
        "matrix if neither form divides by zero",
    )
    page.say(
        "The coefficients of the characteristic polynomial are polynomials in these four numbers, "
        "as in (18). The program computes them for one integer delay at a time; the theorem is for "
        "$d=2$."
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
        "The stability test uses the same numbers. It computes Jury's inequalities from $L=1-e$ "
        "and $q=1-a+e$:"
    )
    page.step(
        "The denominator is a function of the loss $L$ and of the value $q$ of the denominator "
        "at 1",
        z**2 - (2 - loss - q) * z + 1 - loss,
        (z - 1) ** 2 + (loss + q) * (z - 1) + q,
        because="for low frequencies, $L$ and $q$ are small; computed as differences of $a$ and "
        "$e$, which are near 2 and 1, they would lose most of their digits",
    )
    settle(
        page,
        "stability_conditions",
        (CONDITIONS,),
        "the computed inequalities are those of the derived device: $n_1$, $n_0$, $1-a+e$ and "
        "$1-e$ are the derived ones",
    )
