r"""Is the line of the linear condition the tangent of the exact boundary?

For small $\alpha$ the paper linearises the stability boundary around the origin and finds the line
$\beta+\delta=\alpha(d+\frac12)$ of (25). We compare the line with the start and the initial slope
of the exact boundary.
"""

from symhaptic.book.lemmas.linear_tangent import free_mass_only, tangent
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import linear

G, MU = symbols("g mu")


def derive(page):
    stiffness, damping = boundary.solved(on_circle(-(z**d) * linear.near()))
    lies = linear.surplus(stiffness, damping)
    page.say(
        r"On the line, the surplus $\Delta=\beta+\delta-(d+\frac12)\alpha$ vanishes. The boundary "
        r"starts on $\alpha=-\gamma$ for every real $d$, with $z^d=e^{jd\theta}$:"
    )
    page.limit(
        r"At the start of the boundary, the surplus $\Delta$ is minus the gap",
        lies,
        theta,
        S.Zero,
        -(s_1 - delta - gamma / 2),
        name=r"\Delta",
        because="for every arm with a spring and damping the boundary starts below the line, at "
        r"the distance of the gap $g=s_1-\delta-\frac12\gamma$",
    )
    short = 6 * (1 - 2 * nu) * s_2 + 6 * (d + 1) ** 2 * s_1 + gamma * d * (d + 1) * (4 * d + 5)
    on = (lies + s_1 - delta - gamma / 2) / theta**2
    page.limit(
        "The initial slope of the boundary is smaller than that of the line",
        on,
        theta,
        S.Zero,
        -short / 12,
        name=r"\frac{\Delta+g}{\theta^2}",
        because=r"the difference is negative, as $\nu\le\frac12$, $s_2>0$ and "
        r"$s_1\ge\delta+\frac12\gamma$. It is zero only for $\gamma=\delta=0$; the "
        "boundary of every other arm that satisfies (30) has a smaller slope than the "
        "line",
    )
    page.say(
        "So (25) is tangent to the boundary only for a free mass. But for short periods all "
        r"boundaries tend to this line. Let $T$ and $\delta$ be of order $h^2$, $\gamma$ of order "
        "$h^4$, and the angle of order $h$:"
    )
    scaled = periods(page)
    across = page.limit(
        "The stiffness on the boundary is of order $h^2$",
        stiffness.subs(scaled, simultaneous=True) / h**2,
        h,
        S.Zero,
        theta**2 * s_2,
        name=r"\alpha(h)/h^2",
        because=r"for short periods $s_2\to1$, so $\alpha\approx\theta^2$",
    ).subs(s_2, 1)
    flat, rise = 6 * (d + 1) ** 2 + 1, (d + 1) * (2 * d + 1) * (2 * d + 3)
    apart = theta**2 * (rise * theta**2 - flat * delta) / 12
    above = (lies.subs(scaled, simultaneous=True) / h**4).subs({s_2: 1, MU: delta / 12})
    page.limit(
        r"The distance $\Delta$ from the line is of order $h^4$",
        above,
        h,
        S.Zero,
        apart,
        name=r"\Delta/h^4",
    )
    crossing = flat * delta / rise
    page.step(
        "For short periods the boundary crosses the line at one stiffness",
        crossing,
        flat / (d + 1) * delta / (2 * d + 1) / (2 * d + 3),
        name=r"\alpha_\times",
        boxed=True,
        because="above this stiffness the boundary lies left of the line",
    )
    straight = 6 * (d + 1) * delta / ((2 * d + 1) * (2 * d + 3))
    page.step(
        "The crossing lies just beyond the end (8) of the straight part of the passive walls",
        crossing / straight,
        1 + 1 / (6 * (d + 1) ** 2),
        name=r"\alpha_\times\Big/\frac{6(d+1)\delta}{(2d+1)(2d+3)}",
        because=r"at the crossing, the stiffness is 17\,\% larger than at the end of (8) for "
        r"$d=0$, and 4\,\% larger for $d=1$",
    )
    law = (d + 1) * (2 * d + 3) / 6 * (theta**2 - crossing)
    page.step(
        "For short periods the error (26) is proportional to the distance from the crossing",
        apart / ((d + HALF) * across),
        law,
        name=r"\lim_{h\to0}\frac{1}{h^2}\,\frac{\alpha_{\text{lin}}-\alpha}{\alpha}",
        because=r"Here $\theta^2$ stands for $\alpha/h^2$. The error is 2\,\% at a distance of "
        r"$\frac{0.12}{(d+1)(2d+3)}$ from the crossing on either side; both points have "
        r"$\alpha\ge0$ if $\delta\ge\frac{0.12(2d+1)}{6(d+1)^2+1}$",
        boxed=True,
    )
    _tangent(page)


def periods(page):
    """Limits of the arm's coefficients; the symbols of the boundary with powers of h."""
    device = plant.sampled(plant.normalised(FULL), split=c)
    spring = (delta**2 - c**2) / 4
    brief = {delta: h * delta, c: h * c}
    up, side = cosh(delta / 2) - cosh(c / 2), sinh(delta / 2) - delta * sinh(c / 2) / c
    both = [(device.n1 + device.n0) * gamma, (device.n1 - device.n0) * gamma]
    page.same(
        "numerator",
        [n.subs(gamma, spring) for n in both],
        [2 * exp(-delta / 2) * n for n in (up, side)],
    )
    page.limit(
        r"The fraction $\nu$ of the numerator tends to one half",
        (side / (2 * delta * up)).subs(brief, simultaneous=True),
        h,
        S.Zero,
        Rational(1, 12),
        name=r"\frac{1/2-\nu(h)}{h\delta}",
    )
    page.limit(
        "For short periods $n_1+n_0$ tends to 1",
        (2 * exp(-delta / 2) * up / spring).subs(brief, simultaneous=True),
        h,
        S.Zero,
        S.One,
        name="n_1(h)+n_0(h)",
        because=r"since also $s_1\to0$, it follows that $s_2\to1$. The gap is "
        r"$\frac1{720}\delta\gamma^2$ to lowest order (\chapter{s4d_explicit_boundary_ends})",
    )
    return {
        theta: h * theta,
        gamma: h**4 * gamma,
        delta: h**2 * delta,
        s_1: h**2 * delta + h**4 * gamma / 2 + h**10 * G,
        nu: HALF - h**2 * MU,
    }


def _tangent(page):
    page.say(
        r"The boundary starts at $\theta\to0$ with $\alpha=-\gamma$. Does this point lie on the "
        "line of (25), and is the line a tangent at this point?"
    )
    page.say(
        r"The surplus $\Delta$ over the line tends to $-g$. If the gap is zero, $\Delta/\theta^2$ "
        "tends to a number that is negative for every spring and damper."
    )
    page.lemma(
        "The line is tangent to the boundary at its start for a free mass only", free_mass_only()
    )
    page.state(
        "linear-tangent",
        r"for $\gamma-\frac14\delta^2<\pi^2$ the boundary is tangent to the line (25) at its start "
        r"only if $\gamma=\delta=0$",
        claim=tangent(),
    )
    page.settle("linear-tangent", free_mass_only(), example={gamma: S.One, delta: S.One, d: S.Zero})
