r"""Signs of the coefficients of the sampled device

The start of the boundary depends on the numbers $\nu$, $s_1$ and $s_2$ of the device, and on the
gap $g=s_1-\delta-\frac12\gamma$ between this start and the line of (25). We ask for their signs if
the damped frequency $\omega_d$ of the device is below the Nyquist frequency. This assumption is
the limit (30) of the paper: $\omega_dT<\pi$, that is $\gamma-\frac14\delta^2<\pi^2$.
"""

from symhaptic.book.lemmas.arm_numbers import ARM, gap, mass, pushed, share, signs
from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "The impulse response of such a device is positive during the whole period. The "
        "coefficients of the sampled device are integrals of this response, each with a weight. "
        "The coefficient $n_1$ is the displacement after a unit force has been held for one "
        "period, and $n_0$ belongs to the next period. The signs of the coefficients follow "
        "from those of the weights."
    )
    page.lemma(
        r"A device with $\omega_dT<\pi$ has $n_1>0$ and $n_0>0$",
        conj(*pushed()),
        because="the weights are 1, $e^{-\\delta u}$ and their difference",
    )
    page.lemma(
        r"A device with $\omega_dT<\pi$ has $0<\nu\le\frac12$",
        conj(*share()),
        because=r"the bound follows from $0<n_0\le n_1$ with $\nu=n_0/(n_1+n_0)$",
    )
    page.lemma(
        r"A device with $\omega_dT<\pi$ has $s_2>0$",
        mass(),
        because="the mass is $s_2=n_1^2A(-n_0/n_1)/(n_1+n_0)^3$, and the roots of $A$ are "
        "positive or not real",
    )
    page.lemma(
        r"A device with $\omega_dT<\pi$ has $s_1\ge\delta+\frac12\gamma$",
        gap(),
        because=r"the difference of $s_1=(1-e+\gamma n_0)/(n_1+n_0)$ and the right side is the "
        "error of the trapezoidal rule for a convex function",
    )
    numbers, (device, *arms) = (n_1, n_0, a, e), ARM
    found = for_all(numbers, [device], signs())
    page.state(
        "arm-numbers",
        r"for $\gamma-\frac14\delta^2<\pi^2$: $0<\nu\le\frac12$, $s_2>0$ and "
        r"$s_1\ge\delta+\frac12\gamma$, with $>$ for $\gamma\delta>0$",
        claim=every((gamma, delta), arms, found.conclusion),
    )
    page.settle(
        "arm-numbers",
        for_all((gamma, delta), arms, add_assum(found, *arms)),
        example={gamma: S.One, delta: S.One},
        note=r"the boundary starts below the line, at a distance of $\gamma^2$ times the mean of "
        "a positive function",
    )
