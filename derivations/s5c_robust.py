r"""Without damping, is any wall stable with every spring?

A wall is robustly stable if it is stable with every spring up to the Nyquist frequency. The paper
sees the region of these walls shrink to the origin as $\delta\to0$. We show that none is left, and
that two springs are enough to exclude them all.
"""

from sympy import I, S, cos, exp, sin, tan

from symhaptic.model import fractional, loop, plant
from symhaptic.model.parts import Parts
from symhaptic.model.passivity import on_circle
from symhaptic.notation import Omega, alpha, beta, d, gamma, l, phi, theta, z


def derive(page):
    undamped, swing, apart = Parts(damping=False), {gamma: Omega**2}, 2 * I * Omega
    n, turned = (1 - cos(Omega)) / Omega**2, exp(-I * (d + 1) * theta)
    flat = 2 * (cos(theta) - cos(Omega))
    turned *= alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2)
    page.say(
        "Without damping the device swings for ever, by $\\Omega=\\sqrt\\gamma$ per period, and "
        "$n_1=n_0=(1-\\cos\\Omega)/\\Omega^2$. On the circle the polynomial is a real number and a "
        "positive multiple of $V=e^{-j(d+1)\\theta}\\bigl(\\alpha\\cos\\frac\\theta2"
        "+j(\\alpha+2\\beta)\\sin\\frac\\theta2\\bigr)$:"
    )
    whole = on_circle(loop.characteristic(undamped, split=apart) * z ** (-d - 2)).subs(swing)
    at_whole = page.same("whole delays", whole, flat + 2 * n * cos(theta / 2) * turned)
    page.show(
        "A whole delay",
        r"z^{-(d+2)}p_1",
        r"2(\cos\theta-\cos\Omega)+2n_1\cos\tfrac\theta2\;V",
        at_whole,
    )
    half = fractional.late(plant.normalised(undamped), S.Half, split=apart)
    late = z ** (l + 2) * half.device.denominator + half.numerator * ((alpha + beta) * z - beta)
    even = (flat + 2 * (1 - cos(theta)) * cos(Omega / 2)) / Omega**2
    at_half = page.same(
        "half a period more",
        on_circle(late * z ** (-l - 3)).subs(swing),
        flat + even * turned.subs(d, l + S.Half),
    )
    page.show(
        "A delay of $d=\\ell+\\tfrac12$",
        r"z^{-(\ell+3)}p_1",
        r"2(\cos\theta-\cos\Omega)+\frac{2}{\Omega^2}\Bigl(\cos\theta-\cos\Omega"
        r"+(1-\cos\theta)\cos\tfrac\Omega2\Bigr)V",
        at_half,
        because="the bracket is linear in $\\cos\\theta$, positive at both ends for "
        "$0<\\Omega<\\pi$",
    )
    page.say(
        "All roots are inside if and only if this turns by $+\\pi$ from $\\theta=0$, where it is "
        "positive for $\\alpha>-\\gamma$, to $\\theta=\\pi$, where it is real. Take the spring "
        "with $(d+1)\\Omega=\\tfrac\\pi2$ and any wall with $\\alpha>0$. With "
        "$r=(\\alpha+2\\beta)/\\alpha$, "
        "$\\arg V=-(d+1)\\theta+\\arctan(r\\tan\\frac\\theta2)$."
    )
    slope = -(d + 1) + tan(phi) / tan(theta / 2) / 2 * (1 + tan(theta / 2) ** 2) / (
        1 + tan(phi) ** 2
    )
    falls = page.step(
        "Where $V$ is real, with $\\varphi=(d+1)\\theta$",
        slope,
        -(2 * (d + 1) * sin(theta) - sin(2 * phi)) / (2 * sin(theta)),
        name=r"\frac{d\arg V}{d\theta}\Big|_{r\tan\frac\theta2=\tan\varphi}",
        because="negative, as $|\\sin N\\theta|<N\\sin\\theta$ for whole $N=2(d+1)$, by induction",
    )
    page.say(
        "Up to $\\theta=\\Omega$ the real number is positive and $-\\pi<\\arg V<\\tfrac\\pi2$: the "
        "sum avoids the negative numbers. At $\\Omega$ only $V$ is left, with an argument "
        "between $-\\pi$ and 0. Beyond, the real number is negative. So the sum can meet the "
        "positive numbers only where $V$ is positive, and there both go down. Its argument stays "
        "below 0 and cannot end at $+\\pi$: a root is on or outside the circle, for all "
        "$\\alpha>0$. For $\\alpha<0$ a root is outside without a spring:"
    )
    free = loop.characteristic(Parts(False, False))
    at_one = page.step("At $\\gamma=0$", free.subs(z, 1), alpha, name="p_1(1)")
    page.say(
        "So two springs, none and $\\gamma=(\\pi/(2(d+1)))^2$, leave no wall stable but those with "
        "$\\alpha=0$, which without a spring have a root at 1. Of these, $\\arg V=-\\varphi\\pm"
        "\\tfrac\\pi2$, and the same argument with a slightly stiffer ($\\beta>0$) or softer "
        "($\\beta<0$) spring gives roots strictly outside. The origin is left, where the device "
        "swings alone: it is stable in the limit only."
    )
    page.settle(
        "s5c-robust-vanishes",
        at_whole,
        at_half,
        page.same("slope", falls, slope),
        page.same("at one", at_one, alpha),
        note="two springs are enough; shown for $2d\\in\\mathbb N_0$, all delays of Fig. 13",
    )
