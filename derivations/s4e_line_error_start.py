r"""What is the error of the linear condition at the start of the boundary?

The boundary starts on $\alpha=-\gamma$, where the denominator of the error (26) vanishes. Sec. IV-E
marks only errors of 0, 2 and 5 per cent. We compute the limit of the error at the start, with and
without spring and damping.
"""

from sympy import tanh

from symhaptic.book.lemmas.linear_corner import in_the_corner
from symhaptic.book.lemmas.linear_start import no_bound, unbounded
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import linear
from symhaptic.paper.propositions.linear_error import corner

GAP = linear.GAP


def derive(page):
    stiffness, damping = boundary.solved(on_circle(-(z**d) * linear.near()))
    page.limits(stiffness + gamma, theta, S.Zero, S.Zero)
    page.limit(
        "At the start of the boundary the distance from the line is the gap $g$",
        linear.surplus(stiffness, damping) / (d + HALF),
        theta,
        S.Zero,
        -GAP / (d + HALF),
        name=r"(\alpha_{\text{lin}}-\alpha)",
        because=r"the gap is $g=s_1-\delta-\frac12\gamma$, and $\alpha+\gamma\to0$. For $g>0$, "
        "that is, for every arm with a spring and damping that satisfies (30), "
        r"$\varepsilon\to-\infty$. As $g\approx\frac1{720}\delta\gamma^2$, the error is "
        "large only on an interval of that size",
    )
    short = 6 * (1 - 2 * nu) * s_2 + 6 * (d + 1) ** 2 * s_1 + gamma * d * (d + 1) * (4 * d + 5)
    wide = s_2 + (d + 1) * s_1 + d * (d + 1) * gamma / 2
    begins = -short / (6 * (2 * d + 1) * wide)
    page.limit(
        r"Without a gap the distance $\Delta$ is of second order",
        (linear.surplus(stiffness, damping) + GAP) / theta**2,
        theta,
        S.Zero,
        -short / 12,
        name=r"\frac{\Delta+g}{\theta^2}",
    )
    page.limit(
        "The denominator of the error is also of second order",
        (stiffness + gamma) / theta**2,
        theta,
        S.Zero,
        wide,
        name=r"\frac{\alpha(\theta)+\gamma}{\theta^2}",
    )
    page.step(
        "Without a gap the initial error is finite",
        -short / 12 / ((d + HALF) * wide),
        begins,
        name=r"\lim_{\theta\to0}\varepsilon\big|_{g=0}",
    )
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    page.define(
        r"Without a spring $\nu$ is the fraction $n_0$ of the numerator's sum",
        nu,
        linear.numbers(device)[nu],
    )
    page.step(
        r"Without a spring, $\nu$ is a cotangent, $s_1=\delta$ and $s_2=1$",
        1 - 2 * nu,
        1 / tanh(delta / 2) - 2 / delta,
    )
    page.step(
        r"Without a spring the initial error is a quotient in $\delta$",
        begins.subs({gamma: 0, s_1: delta, s_2: 1}),
        -((d + 1) ** 2 * delta + 1 - 2 * nu) / ((2 * d + 1) * (1 + (d + 1) * delta)),
        name=r"\lim_{\theta\to0}\varepsilon|_{\gamma=0}",
        because=r"for small $\delta$ the error is close to $-\frac{6(d+1)^2+1}{6(2d+1)}\,\delta$",
    )
    swing = plant.sampled(plant.normalised(Parts(damping=False)), split=2 * I * Omega)
    shape = linear.numbers(swing)
    page.step(
        "Without damping the numerator is symmetric", shape[nu], HALF, name=r"\nu\big|_{\delta=0}"
    )
    page.define(r"The arm's stiffness is the square of the angle $\Omega$", gamma, Omega**2)
    page.step(r"Without damping $s_1=\gamma/2$", shape[s_1], gamma / 2, name=r"s_1\big|_{\delta=0}")
    page.step(
        "Without damping the initial error is negative",
        begins.subs({delta: 0, s_1: gamma / 2, nu: HALF}),
        -(d + 1) * (2 * d + 3) * gamma / (6 * s_2 + 3 * (d + 1) ** 2 * gamma),
        name=r"\lim_{\theta\to0}\varepsilon|_{\delta=0}",
    )
    swings = on_circle(swing.denominator).subs(theta, Omega)
    page.step(
        "The boundary meets the line at the origin",
        swings,
        S.Zero,
        name=r"A(e^{j\Omega})",
        because=r"at $\theta=\Omega=\sqrt\gamma$ the device oscillates without a wall, so "
        r"$Q=0$ and $\alpha=\beta=0$",
    )
    unbounded_there(page)
    beyond_two_percent(page)


def unbounded_there(page):
    """With spring and damper the reciprocal of the error tends to zero."""
    no_error = page.lemma(
        "With spring and damper the reciprocal of the error tends to zero",
        no_bound(),
        because=r"the denominator $\alpha+\gamma$ is of order $\theta^2$ with a positive factor, "
        r"and the numerator $\alpha_{\text{lin}}-\alpha$ tends to a multiple of the gap. "
        "This limit is not zero",
    )
    page.state(
        "linear-error-start",
        "for $\\gamma\\delta>0$ and $\\gamma-\\frac14\\delta^2<\\pi^2$ the reciprocal of the error "
        "(26) tends to zero at the start of the boundary, for every $d$",
        claim=unbounded(),
    )
    page.settle(
        "linear-error-start",
        no_error,
        example={gamma: S.One, delta: S.One, d: S.Zero},
        note=r"the error is unbounded, except for $\gamma=0$ or $\delta=0$",
    )


def beyond_two_percent(page):
    """The error exceeds 2 % for every arm of (23) with a spring and a damper."""
    page.say(
        "So the error is large near the start. For an arm in the range (23), take the wall whose "
        r"distance from the start is 25 times the gap. For this wall the gap exceeds $2\,\%$ of "
        r"$\alpha+\gamma$, and $\alpha$ is so small that $\beta<0$."
    )
    page.state(
        "linear-error-corner",
        r"inside (23), for $\gamma\delta>0$, the error exceeds 2\,\% for a wall on the boundary "
        r"with $\beta<0$, for $d=0$ and $d=1$",
        claim=corner(),
    )
    page.settle(
        "linear-error-corner",
        in_the_corner(),
        example={gamma: STIFF, delta: STIFF},
        note=r"the wall lies next to the corner at $\alpha=-\gamma$",
    )
