r"""Is the late device that is computed the late device that is derived?

Behind a fraction of a period a device has three numbers in place of two. They are computed from
what the device does in the rest of the period and in its beginning; and so is what a verdict on
stability is given.
"""

from symhaptic.book.lemmas.computed import settle
from symhaptic.book.lemmas.stable_device import ALL, LATE, SPRING, in_parts
from symhaptic.forms import fractional_delay
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import c, gamma

GIVEN = {gamma: SPRING}
UNDEFINED = "wherever nothing in either is divided by zero"


def derive(page):
    page.say(
        "Behind a fraction $\\varepsilon$ of a period the device is pushed by the force before, "
        "for $\\varepsilon$, and by the new one for the rest. Each part of the period is a period "
        "as long, with $\\gamma$ and $\\delta$ in its units, so that the same functions serve: "
        "$m_2$ is $(1-\\varepsilon)^2$ times PlantN1 of $\\gamma(1-\\varepsilon)^2$ and "
        "$\\delta(1-\\varepsilon)$, and $m_0$ is $\\varepsilon^2e^{-\\delta(1-\\varepsilon)}$ "
        "times PlantN0 of $\\gamma\\varepsilon^2$ and $\\delta\\varepsilon$: the force before "
        "leaves a way that is damped in the rest of the period. The third number is "
        "$m_1=n_1+n_0-m_2-m_0$."
    )
    late = fractional.late(plant.normalised(FULL), split=c)
    first, last = (in_parts(x).xreplace(GIVEN) for x in fractional_delay.ends(FULL))
    page.same("m_2", first, late.m2.xreplace(GIVEN))
    page.same("m_0", last, late.m0.xreplace(GIVEN))
    page.say(
        "At $z=-1$ the numerator $M$ is $m_2-m_1+m_0$, and of three large numbers little may be "
        "left. It is computed from what each part of the period does, with $x$, $y$, $g$ and $k$ "
        "for the way under a force, the way that is left, their difference and the way by an "
        "impulse, with 1 of the rest of the period and with 2 of its beginning, and with the "
        "loss $L_1=1-e^{-\\delta(1-\\varepsilon)}$ of speed in the rest: it is "
        "$g_1-g_2+y_1(\\delta k_2+\\gamma x_2)-L_1y_2+\\gamma x_1x_2-2k_1k_2$. Where $M$ nearly "
        "vanishes at $-1$, each of these terms is small."
    )
    gap, across = (LATE.block.written_out()[place] for place in (3, 5))
    page.same("gap", gap.left, gap.right)
    page.say(
        "A lightly damped device that turns nearly an odd number of half turns in a period is the "
        "exception: there these terms are much larger than their sum. Let $c$ be the difference "
        "of the poles, $h=\\delta/2$ and $u=\\frac12-\\varepsilon$. Then every term of another sum "
        "vanishes with the damping or with $\\cosh(c/4)$, which is the cosine of half the angle "
        "that an undamped device turns in a period:"
    )
    turned = LATE.block.written_out()[6]
    page.same("gap near half turns", turned.left, turned.right)
    page.say(
        "The boundary asks for the difference of $m_2$ and $m_0$, too. Where the device swings "
        "nearly whole turns in a period both are alike, and what little is left decides about slow "
        "motions. With $k$ for the way by an impulse in the whole period, and $L=1-e$, "
        "$2(m_2-m_0)$ is computed as $k(2k_1+\\delta x_1)+(1-a+e+L)x_1-2n_0$. All its terms are "
        "small there: without damping $k$, $1-a+e$, $n_0$ and $L$ are zero."
    )
    page.same("across", across.left, across.right)
    settle(
        page,
        "discretize_fractional",
        (ALL, LATE),
        "the computed numbers of the device, its values at $z=1$ and $z=-1$ and, behind a fraction "
        "of a period, $m_2$, $m_1$, $m_0$, $m_2-m_1+m_0$ and $2(m_2-m_0)$ are the derived ones, "
        f"{UNDEFINED}",
    )
    page.say(
        "For any delay, roots are counted from the angles at which device and wall are equally "
        "strong; these ignore the delay, as \\chapter{s4d_roots_counted} says. What the count is "
        "given is proved here. The count itself is a procedure and no formula: it is compared "
        "with roots that are enclosed."
    )
    settle(
        page,
        "unstable_roots",
        (ALL, LATE),
        "all numbers that the count of roots is given, of the device and of what is late, are the "
        f"derived ones, {UNDEFINED}",
    )
    settle(
        page,
        "is_stable",
        (ALL, LATE),
        "all numbers that the verdict on stability is given are the derived ones, "
        f"{UNDEFINED}: it asks for the same count, for $\\alpha>-\\gamma$, and for a device that "
        "is not left swinging",
    )
