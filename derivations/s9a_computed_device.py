r"""Is the device that is computed the device that is derived?

The numbers of the sampled device are quotients that are 0/0 without a spring and at critical
damping, and that lose digits near by. What is computed is made of entire functions, which have
power series everywhere. Both are held against each other, the number that is computed beside the
number that was derived.
"""

from sympy import S, exp, symbols

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.stable_device import (
    COMPUTED,
    DERIVED,
    LATE,
    SPRING,
    in_parts,
    in_poles,
)
from symhaptic.forms import fractional_delay
from symhaptic.forms.entire import Creep, Decay
from symhaptic.forms.entire_device import (
    DenominatorAtMinusOne,
    NumeratorAtOne,
    NumeratorGap,
    PlantN0,
    PlantN1,
    PlantTrace,
)
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import a, c, delta, e, epsilon, gamma, m_0, m_2, n_0, n_1

OWN = (
    (PlantN1, "A function is the way under a force that is held for a period"),
    (PlantN0, "A function is the way that this force leaves for the period after it"),
    (PlantTrace, "A function is the sum of the poles of the sampled device"),
    (NumeratorAtOne, "A function is what both ways are together"),
    (DenominatorAtMinusOne, "A function is the denominator at $z=-1$"),
    (NumeratorGap, "A function is what both ways are apart, over the damping"),
)
NUMBERS = (
    (n_1, "PlantN1", "The way under the force is computed by the first of them"),
    (n_0, "PlantN0", "The way that is left is computed by the second"),
    (a, "PlantTrace", "The sum of the poles is computed by the third"),
    (r"1-a+e", r"\gamma\,NumeratorAtOne", "The denominator at $z=1$ has the spring as a factor"),
    (r"1+a+e", "DenominatorAtMinusOne", "The denominator at $z=-1$ is a product"),
    (r"n_1+n_0", "NumeratorAtOne", "The numerator at $z=1$ is a product over the spring"),
    (r"n_1-n_0", r"\delta\,NumeratorGap", "The numerator at $z=-1$ has the damper as a factor"),
)


def derive(page):
    page.say(
        "Let $c=\\sqrt{\\delta^2-4\\gamma}$ be the difference of the poles of the device, so that "
        "$\\gamma=(\\delta^2-c^2)/4$. Six functions of $\\gamma$ and $\\delta$ are computed. Each "
        "is even in $c$, so that it does not matter which root is meant, and no pole is left in "
        "any of them: where the formula divides by zero, the function has its limit."
    )
    for function, title in OWN:
        page.define(title, name(function.__name__), in_poles(function(gamma, delta)))
    exact = plant.sampled(plant.normalised(FULL), split=c)
    device = {n_1: exact.n1, n_0: exact.n0, a: exact.a, e: exact.e}
    page.say(
        "The derived numbers are $n_1$, $n_0$, $a$ and $e$ of the transition matrix, which the "
        "chapter on the sampled device finds for (14):"
    )
    places = (0, 1, 2, 4, 5, 7, 8)
    for (left, right, title), i in zip(NUMBERS, places, strict=True):
        ours = COMPUTED[i].xreplace({gamma: SPRING})
        same = page.same(title, ours, DERIVED.numbers[i].xreplace(device).xreplace(GIVEN))
        page.show(title, left, name(right), same)
    page.say(
        "Digits are kept by the functions, and not by these formulas. Where $\\gamma$ and "
        "$\\delta$ are near $10^{-6}$, the numerator of PlantN1 is a difference of numbers next "
        "to 1 that is itself next to $\\gamma/2$, and of sixteen digits nine or ten are left; its "
        "power series begins with $\\frac12$ and loses none. In the same way $1-a+e$ is no sum of "
        "numbers near 1, $-2$ and 1, $n_1-n_0$ is no difference of two numbers near $\\frac12$, "
        "and $1-e$ is computed as $\\delta$ times the function that follows."
    )
    page.define("A function is the loss of speed over the damping", name("Decay", delta), decay())
    page.limit("Without a damper it is 1", decay(), delta, S.Zero, S.One, name=name("Decay", delta))
    free = Creep.definition(delta)
    page.limit(
        "Without a spring the way under a force is that of a mass with a damper",
        COMPUTED[0].xreplace({gamma: SPRING}),
        c,
        delta,
        free,
        name=name("PlantN1"),
        because="so that $\\gamma$ tends to 0",
    )
    page.limit("Of a free mass this way is one half", free, delta, S.Zero, S.Half)
    critical = plant.sampled(plant.Plant(S.One, delta, delta**2 / 4)).n1
    page.limit(
        "At critical damping it is what the device with a double pole has",
        COMPUTED[0].xreplace({gamma: SPRING}),
        c,
        S.Zero,
        critical,
        name=name("PlantN1"),
    )
    settle(
        page,
        "discretize",
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
        "the computed coefficients are those of the characteristic polynomial of the derived "
        "device, here for $d=2$",
    )
    _late(page)


def _late(page):
    page.say(
        "Behind a fraction $\\varepsilon$ of a period the device is pushed by the force before, "
        "for $\\varepsilon$, and by the new one for the rest. Each part of the period is a period "
        "as long, with $\\gamma$ and $\\delta$ in its units, so that the same functions serve:"
    )
    late = fractional.late(plant.normalised(FULL), split=c)
    first, last = (in_parts(x).xreplace(GIVEN) for x in fractional_delay.ends(FULL))
    rest = r"\bigl(\gamma(1-\varepsilon)^2,\delta(1-\varepsilon)\bigr)"
    page.show(
        "The new force moves the device as in a period of that length",
        m_2,
        rf"(1-\varepsilon)^2\,\mathrm{{PlantN1}}{rest}",
        page.same("m_2", first, late.m2.xreplace(GIVEN)),
    )
    page.show(
        "The force before leaves a way that is damped in the rest of the period",
        m_0,
        r"\varepsilon^2e^{-\delta(1-\varepsilon)}\,"
        r"\mathrm{PlantN0}(\gamma\varepsilon^2,\delta\varepsilon)",
        page.same("m_0", last, late.m0.xreplace(GIVEN)),
        because="and $m_1=n_1+n_0-m_2-m_0$",
    )
    page.say(
        "At $z=-1$ the numerator $M$ is $m_2-m_1+m_0$, where little may be left of three numbers "
        "that are large. In the theorem it stands with $x$, $y$, $g$ and $k$ for the way under a "
        "force, the way that is left, their difference and the way by an impulse, with 1 of the "
        "rest of the period and with 2 of its beginning: no term there is as large as $n_1$ is."
    )
    settle(
        page,
        "discretize_fractional",
        "the computed numbers of the device, its values at $z=1$ and $z=-1$ and, behind a fraction "
        "of a period, $m_2$, $m_1$, $m_0$ and $m_2-m_1+m_0$ are the derived ones, wherever nothing "
        "in either is divided by zero",
    )


GIVEN = {gamma: SPRING}


def decay():
    """(1 - e^-delta)/delta."""
    return Decay.definition(delta)


def name(function, of=None):
    """A function upright, with its arguments."""
    *factor, word = function.split(r"\,")
    inner = r"(\gamma,\delta)" if of is None else r"(\delta)"
    lead = "".join(rf"{f}\," for f in factor)
    known = {x.__name__ for x, _ in OWN} | {"Decay"}
    return lead + (rf"\mathrm{{{word}}}{inner}" if word in known else word)
