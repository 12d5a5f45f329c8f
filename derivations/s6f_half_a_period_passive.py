r"""How stiff can a passive wall be with a delay of half a period?

For $d=\tfrac12$ the exact condition is a quadratic in $\cos^2\frac\theta2$, so the boundary of
the passive walls has a formula. We work in units of $b$ and $T$.
"""

from sympy import discriminant

from symhaptic.book.figures.fractional import largest_stiffness
from symhaptic.book.lemmas.half_late_passive import (
    a_delay_helps,
    delay_helps,
    stiffest,
    stiffest_half_late,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.enclosed import root

HALF = {epsilon: Rational(1, 2), l: 0, b: 1, T: 1}


def derive(page):
    value = 1 - K * y + B * (4 * y**2 - 3 * y) - K**2 / 16 - B * (K + B) * (1 - y) / 4
    page.define(r"The angle enters through $y=\cos^2\frac\theta2$", y, cos(theta / 2) ** 2)
    page.step(
        "The exact condition is quadratic in $y$",
        fractional.margin().subs(HALF),
        value,
        name="f(y)",
        because=r"the quadratic is the condition of \chapter{s6d_fractional_passivity} with "
        r"$b=T=1$. The wall is passive if and only if $K\ge0$ and $f$ is not negative for all "
        "$y$ between 0 and 1. Let $f_2$, $f_1$, $f_0$ be the coefficients of $f$",
    )
    page.step(
        "The condition at low frequencies gives the lower part of the boundary",
        value.subs({y: 1, K: 4 * sqrt(5 + B) - 8}),
        S.Zero,
        name=r"f(1)\big|_{K=4\sqrt{5+B}-8}",
        because="at low frequencies, $f$ is zero on the lower part of the boundary; the paper "
        "gives $K=1+B$ instead",
    )
    bend, fall, rest = (expand(value).coeff(y, n) for n in (2, 1, 0))
    double = page.step(
        "The discriminant of the quadratic gives the upper part of the boundary",
        16 * (fall**2 - 4 * bend * rest),
        (K * (B + 4) + B * (B + 12)) ** 2 - 16 * B * (16 - B**2),
        name=r"16\,(f_1^2-4f_0f_2)",
        because="the discriminant is zero on the upper part of the boundary. This part is the "
        r"explicit curve $K=4\sqrt{B(4-B)/(4+B)}-B(B+12)/(B+4)$",
    )
    end = page.step(
        "The upper part of the boundary ends at a zero of a cubic",
        double.subs(K, 0) / B,
        B**3 + 40 * B**2 + 144 * B - 256,
        name=r"\tfrac{16}{B}\,(f_1^2-4f_0f_2)\big|_{K=0}",
    )
    tip = page.step(
        "The maximum stiffness is a zero of a polynomial of degree six",
        -discriminant(expand(double), B) / 2**22,
        K**6 + 24 * K**5 - 16 * K**4 - 2816 * K**3 + 73472 * K**2 + 694272 * K - 913408,
        name=r"-2^{-22}\,\mathrm{disc}_B\,\bigl(16\,(f_1^2-4f_0f_2)\bigr)",
        because="the polynomial is the discriminant in $B$ of the previous discriminant; it "
        "vanishes if two values of $B$ coincide",
    )
    one, two = S.One, Rational(2)
    zeros = ((B, root(end, one, two)), (K, root(tip, one, two)))
    page.enclosed(
        "Intervals contain the end of the upper part and the maximum stiffness",
        zeros,
        places=12,
        because="the next step proves that the second zero bounds the stiffness",
    )
    found = page.lemma(
        "No passive wall is stiffer than $1.175870\\,b/T$",
        stiffest_half_late(),
        because="a wall with slightly less stiffness has $f_2=4B>0$ and, by the formula of the "
        "discriminant, $f_1^2-4f_0f_2<0$, so $f$ is a sum of squares. For a wall with "
        r"$K\ge1.17587$, $f$ is negative at $y=0.781799$, that is, $\tan\frac\theta2=0.5283$. For "
        "the best $B$ its value at this $y$ is "
        r"$1-Ky-\frac1{16}K^2+(4y^2-3y-\frac14K(1-y))^2/(1-y)$, which falls with $K$ and is "
        r"$-8.8\cdot10^{-7}$ at $K=1.17587$",
        boxed=True,
    )
    page.say(
        r"The formula (11) gives $2\tan\frac\pi6=1.154700\ldots$; the exact maximum is 1.8\,\% "
        "larger. But the exact maximum belongs to a different damping, and the wall of (11) itself "
        "is not passive."
    )
    page.state(
        "fractional-largest-stiffness",
        "with a delay of half a period the largest passive stiffness lies between "
        r"$1.175869\,b/T$ and $1.175870\,b/T$, 1.8\,\% above (11), and the wall of (11) is not "
        "passive",
        claim=stiffest(),
    )
    units = {b: S.One, T: S.One}
    page.settle("fractional-largest-stiffness", found, example=units)
    helped = page.lemma(
        "A longer delay can make a wall passive: some wall is passive with a delay of half a "
        "period and not without delay",
        delay_helps(),
    )
    page.state(
        "fractional-longer-delay",
        r"$K=0$, $B=\frac65b$ is passive with a delay of half a period, and neither without "
        "delay nor with one period of delay",
        claim=a_delay_helps(),
    )
    page.settle("fractional-longer-delay", helped, example=units)
    page.figure(
        "stiffness-fractional",
        "Largest passive stiffness over the delay: the exact value, the value of (11), and the "
        "value of (11) for the next integer delay. The last one is always safe "
        r"(\chapter{s6g_next_whole_delay}).",
        largest_stiffness,
    )
