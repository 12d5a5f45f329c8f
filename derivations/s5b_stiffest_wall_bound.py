r"""Is the stiffest wall on the first arc of the boundary?

With the angles of \chapter{s5b_stiffest_wall} we show, for every whole delay $d\ge1$, that no
stable wall is stiffer than the first arc of the explicit boundary: the largest stable stiffness is
a maximum of one explicit function. Springs are as soft as an arm's, $\gamma\le0.001$, and
$0<\delta\le0.1$.
"""

from sympy import Rational, cos, diff, pi

from symhaptic.bounds.walls import DEVICE
from symhaptic.model import circle
from symhaptic.notation import a, alpha, beta, delta, e, gamma, n_0, n_1, y, z
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, NUMBERS, named
from symhaptic.proof.theorems.leaves import on_plants

PLANT, FORCE = DEVICE.denominator, DEVICE.numerator
WALL = (alpha + beta) * z - beta
RISE, STATIC = n_1 + n_0, 1 - a + e
RANGES = {gamma: (0, Rational(1, 1000)), delta: (0, Rational(1, 10))}


def derive(page):
    page.say(
        "As before $F=z^{d+1/2}A/N$ has the angle $\\chi$, the wall $V=z^{-1/2}W$ the angle "
        "$\\kappa$, and the curve is $\\alpha(\\theta)=-R\\cos\\chi$. Where a wall is as large as "
        "the plant, $\\alpha=R\\cos\\kappa$. First we compare sizes, with "
        "$y=4\\sin^2\\frac\\theta2$."
    )
    sizes(page)
    conclusion(page)


def sizes(page):
    """Where plant and wall are equally large."""
    square = circle.in_chord(circle.square(PLANT), y)
    page.step(
        "$|A|$ rises from $\\theta_r$ on",
        diff(square, y).subs(y, 2 * STATIC / (1 + e)),
        (1 - e) ** 2 * a / (1 + e),
        name=r"\frac{d|A|^2}{dy}\Big|_{\theta_r}",
        because="where $y=2(1-a+e)/(1+e)$; $|A|^2$ is "
        "convex in $y$, and $|N|$ and $\\cos\\frac\\theta2$ fall, so $R$ rises",
    )
    surplus = square - circle.in_chord(circle.square(FORCE * WALL), y)
    page.step(
        "At $z=-1$ plant and wall differ by two squares",
        surplus.subs(y, 4),
        (1 + a + e) ** 2 - (n_1 - n_0) ** 2 * (alpha + 2 * beta) ** 2,
        name=r"|A|^2-|NW|^2",
    )
    push = FORCE * WALL
    first, second = push.subs(z, 0), diff(push, z).subs(z, 0)
    page.step(
        "The two lowest coefficients leave this difference",
        second - first * -a,
        n_0 * alpha - (n_1 - n_0 + a * n_0) * beta,
        name=r"a_1-a_0a_{d+2}",
        because="smaller than $1-a_0^2$, and $|a_0|<1$ for $a_0=-n_0\\beta$: one step of Schur's "
        "reduction, which keeps roots inside. So $n_0^2\\alpha<n_1+an_0$",
    )
    size = n_1 + (a + 2) * n_0
    inequalities = (
        n_0**2 * (1 + a + e) - (n_1 - n_0) * size,
        RISE * (1 + a + e) - 4 * (1 + e) * (n_1 - n_0),
        2 * n_0 - n_1,
        (1 + e) * (1 - cos(pi / 98)) - STATIC,
    )
    texts = (
        r"n_0^2(1+a+e)-(n_1-n_0)\bigl(n_1+(a+2)n_0\bigr)",
        r"(n_1+n_0)(1+a+e)-4(1+e)(n_1-n_0)",
        "2n_0-n_1",
        r"a-(1+e)\cos\tfrac\pi{98}",
    )
    for text, expr in zip(texts, inequalities, strict=True):
        certificate = box.positive(expr.subs(BALLS), RANGES, named({s: s for s in NUMBERS}))
        page.lemma(f"Beside soft springs ${text}$ is positive", on_plants(certificate))
    page.say(
        "By the first, the plant outweighs every stable wall at $z=-1$. By the second it outweighs "
        "those on the arc: $|\\alpha+2\\beta|\\le4(1+e)/(n_1+n_0)$ for $\\theta\\ge\\theta_r$, as "
        "$|A|^2\\le(1+e)^2y$ there. The last is $(d+1)\\theta_r\\le\\frac\\pi2$ for $d\\le48$."
    )


def conclusion(page):
    """The argument, with the count of roots."""
    page.say(
        "\\emph{No stable wall is stiffer.} Let a wall with $\\alpha>0$, $\\alpha\\ne\\gamma$, be "
        "stable. If the plant is as large as the wall at $\\theta_r$, then "
        "$\\alpha\\le R(\\theta_r)\\le R(\\theta_h)=\\alpha(\\theta_h)$, where "
        "$\\chi(\\theta_h)=\\pi$. Otherwise the wall leads there. The surplus $|A|^2-|NW|^2$ is "
        "quadratic in $y$ and positive at $z=-1$, so the wall stops to lead at one angle "
        "$\\theta_b>\\theta_r$, and starts at one $\\theta_a<\\theta_r$ if not at 0. By the count "
        "of roots the whole number next to $(\\kappa-\\chi)/2\\pi$ is the same at both, and 0 if "
        "the lead starts at 0. As $\\kappa-\\chi<\\frac\\pi2$ it is 0 or negative."
    )
    page.say(
        "If it is 0, $\\kappa>\\chi-\\pi$ at $\\theta_b$, so that "
        "$\\chi<\\frac{3\\pi}2$. For $\\chi\\ge\\pi$ this means $\\alpha=R\\cos\\kappa<-R\\cos\\chi"
        "=\\alpha(\\theta_b)$; for $\\chi<\\pi$, $\\alpha\\le R(\\theta_b)<R(\\theta_h)$. If it is "
        "negative, $\\kappa<\\chi-\\pi$ at $\\theta_a$, where $\\frac\\pi2<\\chi\\le\\pi$, and "
        "$\\alpha=R\\cos\\kappa<\\alpha(\\theta_a)$. In each case $\\alpha$ is below a value of "
        "the curve, up to $\\theta=\\pi/(d+\\frac12)$."
    )
    page.say(
        "\\emph{The curve is reached.} Its largest stiffness is at least $\\alpha(\\theta_h)="
        "R(\\theta_h)$, where it still rises, so it lies at a $\\theta_*>\\theta_h$ with $\\chi>"
        "\\pi$. Take the wall there, which has $\\alpha+2\\beta>0$, $\\kappa>0$, and turn $V$ a "
        "little on. This wall leads at $\\theta_h$ and up to $\\theta_*$, where the whole number "
        "is now 0. Its lead starts at 0 or at an angle below $\\theta_h$, where $\\chi<\\pi$ and "
        "the whole number is 0 too: all roots are inside. So for $d\\ge1$, $\\delta>0$ and "
        "$(d+1)\\theta_r\\le\\frac\\pi2$ the largest stable stiffness is the maximum of "
        "$\\alpha(\\theta)$ over $0<\\theta\\le\\pi/(d+\\frac12)$: a supremum, as the wall itself "
        "has roots on the circle."
    )
    page.state(
        "stiffest-wall",
        r"for $d\in\mathbb N$, $\gamma\le0.001$, $0<\delta\le0.1$, $(d+1)\theta_r\le\frac\pi2$ the "
        r"largest stable stiffness is that of the boundary up to $\theta=\pi/(d+\frac12)$",
    )
