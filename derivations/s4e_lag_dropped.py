"""Is the linear condition conservative?

Routh's condition for the loop with a lag has one term more than the paper's (24). We derive the
sign of this term, in SI units and in the parameters of Table I, and its dependence on the arm's
stiffness.
"""

from sympy import sympify

from symhaptic.book.lemmas.linear import (
    forbidden,
    more_with_a_spring,
    of_the_walls_in_units,
    safe,
    spring_is_free,
    undamped_in_units,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.model import lag
from symhaptic.notation import t_e
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.linear import lagging

ONES = {m: S.One, T: S.One, t_d: HALF}


def derive(page):
    whole, kept = lag.margin(Plant()), b + B - K * t_e
    page.step(
        "The dropped term has the factor $bt_e/m$",
        whole - kept,
        b * t_e / m * ((b + B - K * t_e) + (K + k) * t_e),
        name=r"\tfrac1m(a_2a_1-a_3a_0)-(b+B-Kt_e)",
    )
    never(page)
    stiffness(page, whole)
    plane(page, kept, whole)


def never(page):
    """For the loop with the lag, (24) is conservative."""
    page.lemma(
        "The loop with the lag is stable if (24) and $K>-k$ hold",
        safe(),
        because="for the loop with the lag, (24) is conservative for all $b$ and $k$: the "
        "dropped term is not negative, and the other conditions also hold",
    )
    claim = lagging()
    page.state(
        "linear-lag",
        "every wall that satisfies (24) and $K>-k$ is stable in the loop with the lag",
        claim=claim,
    )
    page.settle(
        "linear-lag",
        safe(),
        example={**ONES, b: S.One, k: S.Zero, B: S.Zero, K: HALF},
        note="the statement is about the lag and not the sampled loop",
    )


def stiffness(page, whole):
    """The effect of the arm's spring in Routh's condition."""
    page.step(
        "Routh's condition allows more stiffness than (24)",
        K + whole / t_e,
        (b + B) / t_e + b / m * (b + B + k * t_e),
        name=r"K_{\text{Routh}}",
        because="the arm's stiffness $k$ raises this limit unless $b=0$",
    )
    same = taken_apart(page.claim("s4e-stiffness-free"))[2]
    easy = {**ONES, b: S.Zero, k: S.One, x: S(2), B: S.One, K: HALF}
    sprung = {**ONES, b: S.One, k: S.One, x: S.Zero, B: S.Zero, K: S(5) / 2}
    page.settle(
        "s4e-stiffness-free",
        spring_is_free(),
        example=easy,
        unless={Eq(b, 0): (sprung, more_with_a_spring(same, sprung))},
        shows="for $m=b=t_e=k=1$ and $B=0$, Routh's condition allows $K<3$, and $K<2$ without "
        "the spring",
        note="the statement holds for Routh's condition for the lag. Condition (24) does not "
        "contain $k$, because it drops the term with $k$. The lower limit $K>-k$ is exact for "
        r"the lag ($a_0=k+K$) and necessary for the sampled loop (\texttt{s4d-left-bound})",
    )


def plane(page, kept, whole):
    """(25) and Routh's condition in the parameters of Table I."""
    scaled = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T, k: gamma * m / T**2}
    scaled |= {t_d: d * T}
    small, large = ((f.subs(t_e, lag.DELAY) * T / m).subs(scaled) for f in (kept, whole))
    line = page.step(
        "In the parameters of Table I, (24) is linear",
        small,
        beta + delta - alpha * (HALF + d),
        name=r"\tfrac Tm(b+B-Kt_e)\big|_{\text{Table I}}",
        paper="25",
    )
    page.step(
        "In the parameters of Table I, Routh's condition has one more term",
        large,
        line + delta * (d + HALF) * (beta + delta + gamma * (d + HALF)),
        name=r"\tfrac T{m^2}(a_2a_1-a_3a_0)",
        because=r"on the line $\beta+\delta=\alpha(\tfrac12+d)$ the ratio of the last term to the "
        r"others is $\delta(d+\tfrac12)(1+\gamma/\alpha)$. Without a spring and with $\delta=0.02$ "
        r"this is 1\,\% for $d=0$ and 17\,\% for $d=8$",
    )
    same = taken_apart(page.claim("eq25"))[2]
    table = normalised(d, alpha, beta, gamma, delta)
    found = closed(of_the_walls_in_units(same.of[0], table), undamped_in_units())
    easy = in_units({**ONES, b: S.Zero, k: S.Zero, B: S.One, K: HALF})
    damped = in_units({**ONES, b: S.One, k: S.Zero, B: S.Zero, K: 3 * HALF})
    page.settle(
        "eq25",
        found,
        line > 0,
        example=easy,
        unless={Eq(delta, 0): (damped, forbidden(same, damped))},
        shows=r"for $\delta=1$, $d=\tfrac12$ and $\beta=\gamma=0$, Routh's condition allows "
        r"$\alpha<2$, and (25) only $\alpha<1$",
        note="condition (25) is Routh's condition for the lag without one term. By Table I it "
        "is equivalent to (24)",
    )


def in_units(point):
    """Add the parameters of Table I to a point."""
    rules = normalised(d, alpha, beta, gamma, delta)
    return point | {rule.lhs: sympify(rule.rhs).subs(point) for rule in rules}
