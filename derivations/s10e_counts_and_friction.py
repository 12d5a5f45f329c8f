r"""How stiff may a spring be if an encoder reads the position?

An encoder reports the position in counts of size $\Delta_x$. The force of the spring then has an
error of up to half a count, and a user can extract energy from it. In a slow motion a damper
dissipates little energy, and Coulomb friction $f_c$ dissipates more. How much friction does a given
stiffness require?
"""

from sympy import Abs, Rational, S

from symhaptic.book.lemmas.counts import (
    FORCES,
    across_a_count,
    across_many,
    decides,
    spring_passive,
    wall_passive,
)
from symhaptic.notation import Delta_x, K, T, b, f_c, h, p_k, x, y
from symhaptic.proof.theorems.kernel import conj

RULE = "rules:counts-and-friction"


def derive(page):
    page.say(
        "In a period the device moves from $x$ by $p_k$, against the held force $Ky$, where $y$ is "
        "the position that the encoder reports. The damper dissipates at least $bp_k^2/T$ and "
        "friction at least $f_c|p_k|$, whatever the motion within the period. The remaining "
        "energy, without the energy of the spring, is:"
    )
    page.step(
        r"In a period sampling adds $\frac12Kp_k^2$, and rounding adds up to "
        r"$\frac12K\Delta_x|p_k|$",
        K * y * p_k + b * p_k**2 / T + f_c * Abs(p_k) - K * (x + p_k) ** 2 / 2 + K * x**2 / 2,
        (b / T - K / 2) * p_k**2
        + (f_c - K * Delta_x / 2) * Abs(p_k)
        + K * (Delta_x / 2 * Abs(p_k) + (y - x) * p_k),
        because="the last term is not negative, since $|y-x|\\le\\frac12\\Delta_x$",
        boxed=True,
    )
    page.say(
        "The sum over all periods contains the final energy of the spring, which is not negative. "
        "The damper has to dissipate the energy that sampling adds, and friction the energy that "
        "rounding adds. The same holds for a wall that only pushes, with its own energy "
        "$\\frac12K\\max(x,0)^2$."
    )
    page.lemma(
        r"For $K\le2b/T$ and $K\le2f_c/\Delta_x$ no motion gains energy from a spring with an "
        "encoder",
        spring_passive(),
    )
    page.lemma(
        r"For $K\le2b/T$ and $K\le2f_c/\Delta_x$ no motion gains energy from a wall that has an "
        "encoder and only pushes",
        wall_passive(),
        because=r"the first term satisfies $\max(x+p_k,0)^2\le(\max(x,0)+p_k)^2$, and replacing "
        "two numbers by their maximum with 0 does not increase their distance",
    )
    page.say(
        r"The bounds $2b/T$ and $2f_c/\Delta_x$ are sharp. Let the position oscillate by $2h$ "
        "across the edge of a count. The user then works against the lower force on the way up, "
        "and the higher force pushes on the way down:"
    )
    page.step(
        "In a small oscillation across the edge of a count the loop receives this energy",
        -K * Delta_x * 2 * h + 2 * b * (2 * h) ** 2 / T + 2 * f_c * 2 * h,
        -2 * h * (K * Delta_x - 2 * f_c - 4 * b * h / T),
        because=r"this energy is negative for $K\Delta_x>2f_c$ and a small $h$; if the motion is "
        "repeated, the extracted energy grows without bound",
    )
    page.lemma(
        r"If $K$ exceeds $2f_c/\Delta_x$, some motion gains energy with any damper",
        across_a_count(FORCES[1]),
    )
    page.lemma(
        "If $K$ exceeds $2b/T$, some motion gains energy with any friction",
        across_many(FORCES[1]),
        because="in an oscillation over many counts, the energy that sampling adds grows with "
        "the square of the amplitude, but the work of friction only in proportion to the "
        "amplitude",
    )
    found = page.lemma(
        r"A spring or a wall with an encoder is passive if and only if $K\le2b/T$ and "
        r"$K\le2f_c/\Delta_x$",
        conj(*map(decides, FORCES)),
        boxed=True,
    )
    point = {K: S.One, b: S.One, f_c: S.One, T: S.One, Delta_x: S.One}
    page.settle(
        RULE,
        found,
        example=point,
        note="the bounds are exact without delay and virtual damping, including walls on the "
        "bounds. Virtual damping from differences of counts, or a delay, makes the bounds "
        "stricter",
    )
    swing = {K: S.One, Delta_x: S.One, T: S.One, b: S.One, f_c: Rational(1, 4), h: Rational(1, 16)}
    page.step(
        "With half of the friction that $K=1$ requires, an oscillation of an eighth of a count "
        "gains energy",
        (-2 * h * (K * Delta_x - 2 * f_c - 4 * b * h / T)).subs(swing),
        -Rational(1, 32),
        name="E",
        because=r"the parameters are $K=\Delta_x=T=b=1$, $f_c=\tfrac14$ and $h=\tfrac1{16}$",
    )
