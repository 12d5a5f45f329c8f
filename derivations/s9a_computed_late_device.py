"""Are the computed coefficients with a fractional delay equal to the derived ones?

With a fractional delay the device has three coefficients instead of two. The program computes these
coefficients, and the inputs of the stability test, from the response in both parts of the period.
"""

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.stable_device import ALL, LATE, SPRING, in_parts
from symhaptic.forms import fractional_delay
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import c, gamma

GIVEN = {gamma: SPRING}
UNDEFINED = "if neither form divides by zero"


def derive(page):
    page.say(
        r"With a fractional delay $\varepsilon$ of a period the previous force acts for the time "
        r"$\varepsilon$, and the new one for the rest. Each part is a shorter period, with "
        r"$\gamma$ and $\delta$ in its units, so the same functions apply. The coefficient "
        r"$m_2$ is $(1-\varepsilon)^2$ times PlantN1 of $\gamma(1-\varepsilon)^2$ and "
        r"$\delta(1-\varepsilon)$. The coefficient $m_0$ is "
        r"$\varepsilon^2e^{-\delta(1-\varepsilon)}$ times PlantN0 of $\gamma\varepsilon^2$ and "
        r"$\delta\varepsilon$, since the effect of the previous force decays in the rest of the "
        "period. The third coefficient is $m_1=n_1+n_0-m_2-m_0$."
    )
    late = fractional.late(plant.normalised(FULL), split=c)
    first, last = (in_parts(x).xreplace(GIVEN) for x in fractional_delay.ends(FULL))
    page.same("m_2", first, late.m2.xreplace(GIVEN))
    page.same("m_0", last, late.m0.xreplace(GIVEN))
    page.say(
        "At $z=-1$ the numerator $M$ is $m_2-m_1+m_0$, a sum in which large terms can cancel. "
        "The program computes this value from both parts of the period. Let $x$ be the "
        "displacement under a force, $y$ the further displacement, $g$ their difference, and "
        "$k$ the impulse response. The index 1 stands for the rest of the period and 2 for its "
        r"beginning. Let $L_1=1-e^{-\delta(1-\varepsilon)}$ be the loss of speed in the rest of "
        r"the period. The value at $-1$ is $g_1-g_2+y_1(\delta k_2+\gamma x_2)-L_1y_2+\gamma "
        "x_1x_2-2k_1k_2$. If $M$ nearly vanishes at $-1$, each of these terms is small."
    )
    gap, across = (LATE.block.written_out()[place] for place in (3, 5))
    page.same("gap", gap.left, gap.right)
    page.say(
        r"A lightly damped device with $\omega_dT$ near an odd multiple of $\pi$ is an exception: "
        "for this device these terms are much larger than their sum. Let $c$ be the difference of "
        r"the poles, $h=\delta/2$ and $u=\frac12-\varepsilon$. Then every term of another sum "
        r"vanishes with the damping or with $\cosh(c/4)$, which is $\cos(\omega_dT/2)$:"
    )
    turned = LATE.block.written_out()[6]
    page.same("the gap near odd multiples of pi", turned.left, turned.right)
    page.say(
        r"The boundary also contains the difference of $m_2$ and $m_0$. If $\omega_dT$ is near a "
        r"multiple of $2\pi$, $m_2$ and $m_0$ are nearly equal, and their small difference "
        "matters at low frequencies. Let $k$ be the impulse response of the whole period, and "
        r"$L=1-e$. The program computes $2(m_2-m_0)$ as $k(2k_1+\delta x_1)+(1-a+e+L)x_1-2n_0$. "
        r"All terms of this sum are small near the multiples of $2\pi$: without damping $k$, "
        "$1-a+e$, $n_0$ and $L$ are zero at the multiples."
    )
    page.same("across", across.left, across.right)
    settle(
        page,
        "discretize_fractional",
        (ALL, LATE),
        "the computed coefficients of the device, its values at $z=1$ and $z=-1$ and, with a "
        "fractional delay, $m_2$, $m_1$, $m_0$, $m_2-m_1+m_0$ and $2(m_2-m_0)$ are the derived "
        f"ones, {UNDEFINED}",
    )
    page.say(
        "For any delay, the program counts the roots by means of the angles at which device and "
        "wall have the same size. These angles do not depend on the delay "
        r"(\chapter{s4d_roots_counted}). This chapter proves that the inputs of the count are "
        "correct. Tests compare the result of the count with enclosed roots."
    )
    settle(
        page,
        "unstable_roots",
        (ALL, LATE),
        "all inputs of the count of roots, those of the device and those of the delayed force, are "
        f"the derived ones, {UNDEFINED}",
    )
    settle(
        page,
        "is_stable",
        (ALL, LATE),
        f"all inputs of the stability test are the derived ones, {UNDEFINED}; the test uses the "
        r"same count, requires $\alpha>-\gamma$, and excludes a device that keeps oscillating",
    )
