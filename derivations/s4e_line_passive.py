r"""Are the walls of the linear stability condition passive?

The paper identifies its (24) with the straight part (9) of the passivity boundary, and uses it
there to obtain passive walls. We compare the two, and ask what becomes of the arm's damping.
"""

from sympy import Rational, S, pi

from symhaptic.model import lag, linear, passivity
from symhaptic.notation import B, K, T, alpha, b, b_D, b_H, beta, d, delta, m, t_d, t_e, theta

HALF = Rational(1, 2)


def derive(page):
    kept = (b + B - K * t_e).subs(t_e, lag.DELAY)
    low = b + B - K * T * (d + HALF)
    lowest = page.limits(passivity.margin(), theta, S.Zero, low)
    page.show(
        "Passivity at low frequencies",
        r"\lim_{\theta\to0}F",
        low,
        lowest,
        because="positive in (9), zero on the straight part of the boundary",
    )
    same = page.same("one expression", kept.subs(t_d, d * T), low)
    page.show(
        "Stability by (24), with $t_d=dT$",
        "b+B-Kt_e",
        low,
        same,
        because="the same: a lag and low frequencies see the effective delay $t_e$ only",
    )
    page.settle(
        "s4e-same-as-passive",
        same,
        lowest,
        note="as formulas, for every real $d$. (9) bounds the passive walls for whole $d$ and in "
        "its range of $B$ only, and with $b=b_D$ by (3)",
    )
    page.say(
        "In (24) the damping is $b_D+b_H$ by (2), in (9) it is $b_D$ by (3): the arm may do what "
        "it likes, its damping does not count for passivity. A wall between the two bounds "
        "satisfies (24) and is not passive:"
    )
    page.step(
        "What (24) allows more",
        (b_D + b_H + B) / (T * (d + HALF)) - (b_D + B) / (T * (d + HALF)),
        b_H / (T * (d + HALF)),
        name="K_{(24)}-K_{(9)}",
    )
    point = {K: S.One, B: S.Zero, T: S.One, b_D: S.Zero, b_H: S.One, d: S.Zero}
    scaled = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T}
    plane = page.same("in Table I", (low * T / m).subs(scaled), linear.surplus())
    page.show(
        "The passive range in the parameters of Table I",
        r"\tfrac TmF|_{\theta\to0}",
        linear.surplus(),
        plane,
        because="with $\\delta=b_DT/m$; by the chapter on (9) the low frequencies are the "
        "strictest for whole $d$, $\\alpha\\ge0$ and $-\\delta\\le\\beta\\le\\frac d{2d+3}\\delta$",
    )
    page.settle(
        "s4e-passive-range",
        plane,
        lowest,
        provided=r"d\in\mathbb{N}_0,\ \alpha\ge0\ \text{and}\ \delta=b_DT/m",
        unless=point,
        truth=passivity.margin(pi / 2).subs(b, b_D) >= 0,
        shows=r"an undamped device in an arm with $b_H=1$: $K=T=1$, $B=d=0$ satisfies (24), and "
        r"gives energy away",
        note="passive walls are stable with every spring, so here (25) is safe for every "
        "$\\gamma\\ge0$; for fractional $d$ no wall of the border is passive",
    )
    page.settle_external(
        "s4e-alpha-003",
        "a table of the paper's [8]",
        "at $\\alpha=0.03$ and $\\delta=0$ the error (26) is about 1.5\\,\\% for $d=0$ and "
        "5.6\\,\\% for $d=1$",
    )
