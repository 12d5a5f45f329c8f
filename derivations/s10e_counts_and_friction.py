r"""How stiff may a spring be if the position is measured in counts?

An encoder reports the position in counts of size $\Delta_x$. The force of the spring then has an
error of up to half a count, and a user can extract energy from it. A damper dissipates little
energy in a slow motion, but Coulomb friction $f_c$ does. We ask how much friction a given stiffness
requires.
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
        "In a period the device moves from $x$ by $p_k$, against the held force $Ky$ of the count "
        "$y$. The damper dissipates at least $bp_k^2/T$ and friction at least $f_c|p_k|$, for "
        "every motion within the period. We compute the remaining energy without that of the "
        "spring:"
    )
    page.step(
        r"Sampling adds the energy $\frac12Kp_k^2$ in a period, and counting adds up to "
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
        "Within both bounds no motion gains energy from a spring with a counted position",
        spring_passive(),
    )
    page.lemma(
        "Within both bounds no motion gains energy from a wall that only pushes",
        wall_passive(),
        because=r"$\max(x+p_k,0)^2\le(\max(x,0)+p_k)^2$, and $\max$ does not increase a distance",
    )
    page.say(
        "Both bounds are sharp. Let the position oscillate by $2h$ across the edge of a count. The "
        "user then works against the lower force on the way up, and the higher force pushes on the "
        "way down:"
    )
    page.step(
        "A small oscillation across the edge of a count can leave a negative energy",
        -K * Delta_x * 2 * h + 2 * b * (2 * h) ** 2 / T + 2 * f_c * 2 * h,
        -2 * h * (K * Delta_x - 2 * f_c - 4 * b * h / T),
        because=r"this energy is negative for $K\Delta_x>2f_c$ and a small $h$; if the motion is "
        "repeated, the user extracts any amount of energy",
    )
    page.lemma(
        "Some motion gains energy beyond $2f_c/\\Delta_x$, with any damper",
        across_a_count(FORCES[1]),
    )
    page.lemma(
        "Some motion gains energy beyond $2b/T$, with any friction",
        across_many(FORCES[1]),
        because="an oscillation over many counts gains an energy that grows with the square of the "
        "amplitude",
    )
    found = page.lemma(
        "A spring or a wall with a counted position is passive if and only if it satisfies both "
        "bounds",
        conj(*map(decides, FORCES)),
        boxed=True,
    )
    point = {K: S.One, b: S.One, f_c: S.One, T: S.One, Delta_x: S.One}
    page.settle(
        RULE,
        found,
        example=point,
        note="the bounds are exact without delay and virtual damping, and the springs on both "
        "borders are passive. Virtual damping from differences of counts, or a delay, requires "
        "more friction or damping",
    )
    swing = {K: S.One, Delta_x: S.One, T: S.One, b: S.One, f_c: Rational(1, 4), h: Rational(1, 16)}
    page.step(
        "With half of the friction that $K=1$ requires an oscillation of an eighth of a count "
        "gains energy",
        (-2 * h * (K * Delta_x - 2 * f_c - 4 * b * h / T)).subs(swing),
        -Rational(1, 32),
        name="E",
        because=r"the parameters are $K=\Delta_x=T=b=1$, $f_c=\tfrac14$ and $h=\tfrac1{16}$",
    )
