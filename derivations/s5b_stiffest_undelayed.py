"""How large is the stable stiffness without delay, compared with the passive one?

Without delay the characteristic polynomial is a cubic, with and without the spring of an arm. The
largest stable stiffness has a closed form. This form proves the paper's first ratio, 17.8 for
$d=0$, on the whole range (23).
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, of_ratio
from symhaptic.book.lemmas.undelayed_tip import (
    LARGEST,
    all_softer,
    claim,
    closed_form,
    none_stiffer,
)
from symhaptic.bounds.walls import over, passive, undelayed
from symhaptic.model import jury

RISE = n_1 + n_0


def derive(page):
    minor = jury.criterion(jury.coefficients(0)).expressions[-1]
    arm = {a: 1 + e - gamma * RISE}
    page.say(
        r"Jury's inequalities for $d=0$ are $p_1(1)>0$, $c_1>0$, $c_3=-p_1(-1)>0$ and $\Delta_2>0$ "
        r"(\chapter{s4d_jury_counted}). We use $1-a+e=\gamma(n_1+n_0)$ and the low-frequency "
        r"damping $s_1=(1-e+\gamma n_0)/(n_1+n_0)$ of the arm:"
    )
    loss = RISE * s_1 - gamma * n_0
    split = RISE * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * (alpha + gamma)
    page.step(
        "The minor is a difference of two products",
        minor.subs(arm).subs(e, 1 - loss),
        split,
        name=r"\Delta_2",
    )
    largest(page, minor, arm)
    ratio(page)


def largest(page, minor, arm):
    """The closed form of the largest stiffness, and stable walls that approach it."""
    device = plant.Sampled(n_1, n_0, arm[a], e)
    top = boundary.largest_undelayed(device)
    root = sqrt(n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1))
    page.define(
        "The number $w$ is the square root of an expression in the device's coefficients", w, root
    )
    page.step(
        r"The minor is a positive multiple of $\alpha_{\max}(0)-\alpha$, minus a square",
        minor.subs(arm),
        n_0 * (1 + n_1 * beta) * (LARGEST - alpha)
        - RISE * (n_0 * (1 + n_1 * beta) - w) ** 2 / (n_0 * n_1**2),
        name=r"\Delta_2",
        because="a stable wall has $1+n_1\\beta>0$",
    )
    page.step(
        "The largest stable stiffness without delay has a closed form",
        top,
        LARGEST,
        name=r"\alpha_{\max}(0)",
        boxed=True,
    )
    page.lemma(
        "No stable wall has $\\alpha_{\\max}(0)$ or more, for $\\gamma\\le0.01$ and "
        "$\\delta\\le0.1$",
        none_stiffer(),
        because=r"for a stable wall, $\Delta_2$ and $1+n_1\beta$ are positive, and a square is "
        "not negative",
    )
    page.lemma(
        "With the damping $\\beta=(w/n_0-1)/n_1$ every wall with "
        "$-\\gamma<\\alpha<\\alpha_{\\max}(0)$ is stable",
        all_softer(),
        because="the square vanishes at this damping; ball arithmetic with the coefficients of "
        "the device shows that Jury's other inequalities hold",
    )
    page.state(
        "stiffest-wall-undelayed",
        "without delay, for $\\gamma\\le0.01$ and $\\delta\\le0.1$, the stable stiffnesses are "
        "those below the closed form $\\alpha_{\\max}(0)$",
        claim=claim(),
    )
    page.settle("stiffest-wall-undelayed", closed_form(), example={gamma: S.Zero, delta: S.Zero})


def ratio(page):
    """The ratio 17.8 of the paper."""
    page.say("The largest passive stiffness without delay is $\\alpha=2\\delta$, by (11).")
    end = Rational(1, 50)
    plants = [(Rational(1, 1000), end), (S.Zero, end), (S.Zero, Rational(201, 10000))]
    ratios = [over(undelayed(*arm), passive(arm[1], 0)) for arm in plants]
    names = [
        rf"\frac{{\alpha_{{\max}}(0)}}{{2\delta}}\Big|_{{\gamma={g},\ \delta={v}}}"
        for g, v in (("0.001", 0.02), (0, 0.02), (0, 0.0201))
    ]
    page.enclosed(
        "The ratio of the largest stiffnesses is slightly more than 17.8",
        list(zip(names, ratios, strict=True)),
        because="the closed form gives the first two numbers. The paper's 17.8 is the truncated "
        "value of both numbers, and its 0.0562 is the reciprocal of the first, rounded "
        "up. Just outside (23) the ratio is less than 17.8",
    )
    page.settle(
        "s5b-eta-d0",
        of_ratio(page.claim("s5b-eta-d0"), 0, UNDELAYED),
        example={gamma: S.Zero, delta: end},
        enclosed=True,
        value=(ratios[0], over(S.One, ratios[0])),
        note="the two statements hold on all of (23); the numbers are those of its corner "
        r"$\gamma=0.001$, $\delta=0.02$. They assume the same $\delta$ for passivity and "
        r"stability; for a device with an arm, see \texttt{one-delta}",
    )
