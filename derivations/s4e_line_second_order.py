r"""How close is the line of the linear condition to the boundary?

The paper linearises the boundary around the origin for small $\alpha$. For short periods all
boundaries tend to this line, for every delay. We ask for their distance from it.
"""

from symhaptic.book.lemmas.linear_boundary import TOTAL
from symhaptic.book.lemmas.linear_gap import narrow
from symhaptic.book.lemmas.linear_rays import A
from symhaptic.book.lemmas.linear_second_order import GAP, UNEVEN, linearised, nearly_even, on_line
from symhaptic.book.lemmas.linear_short_periods import all_tend
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.linear_error import short_periods


def derive(page):
    page.say(
        "A wall on the boundary is not stable, but all walls with less stiffness, down to "
        r"$\alpha=-\gamma$, are stable. So Jury's largest minor is zero on the boundary. We "
        r"compute this minor on the line. Let $A=\alpha+\gamma$, $w=n_1-n_0$, and let "
        r"$G=g\,(n_1+n_0)$ be a multiple of the gap:"
    )
    loss = 1 + gamma * n_0 - (delta + gamma / 2) * TOTAL - GAP
    small = delta + gamma / 2
    page.step(
        "Without delay the minor on the line is small of second order",
        on_line(0).subs(e, loss).subs(n_1, n_0 + UNEVEN),
        GAP * (1 + n_0 * (small - A / 2))
        + A * (UNEVEN / 2 + n_0 * small * (4 * n_0 + 3 * UNEVEN) / 2)
        - A**2 * n_0 * (4 * n_0 + 3 * UNEVEN) / 4,
        name=r"\Delta_2",
        because="each term is a product of two small numbers or contains $G$; with one period of "
        "delay the products contain other small numbers",
    )
    page.lemma(
        r"The coefficient $n_1$ exceeds $n_0$ by at most $\frac16\delta$",
        nearly_even(),
        because="this step bounds $w$",
    )
    page.lemma(
        "The gap $G$ is at most $\\frac1{32}\\gamma^2\\delta$",
        narrow(),
        because="this lemma bounds $G$ for all arms that satisfy (30)",
    )
    page.say(
        "Neither $w$ nor $G$ is negative. The minor rises with the surplus "
        r"$\Delta=\beta+\delta-(d+\frac12)\alpha$ over the line, at a rate close to 1. So the "
        "distance of the boundary from the line is also of second order. On all of (23), for "
        r"$d=0$, $d=1$, $\alpha\le0.03$ and $\beta\le0.1$, the surplus of a wall on the boundary "
        r"lies between $-3(\delta+\gamma)(\alpha+2\gamma)$ and $3(\alpha+\gamma)^2$."
    )
    second_order(page)
    order_of_period(page)


def second_order(page):
    """To first order the line is the boundary."""
    symbols = taken_apart(page.claim("s4e-linearised"))[0]
    page.settle(
        "s4e-linearised",
        linearised(),
        example=dict.fromkeys(symbols, S.Zero),
        note=r"the line is the first order in $\alpha$, $\gamma$ and $\delta$ together, for $d=0$ "
        r"and $d=1$. For a single arm the line is not the tangent (\texttt{linear-tangent}): "
        r"without a spring the boundary starts at $(0,-\delta)$ with a smaller slope",
    )


def order_of_period(page):
    """For a given device the distance is of order T."""
    claim = short_periods()
    symbols = taken_apart(claim)[0]
    page.state(
        "linear-short-periods",
        r"for $d=0$ and $d=1$ the boundary tends to the line of (24) as $T\to0$ with $KT\le y$: on "
        r"the boundary $b+B-K(t_d+\frac T2)$ is of order $T$",
        claim=claim,
    )
    easy = dict.fromkeys(symbols, S.Zero) | {m: S.One, T: S.One}
    page.settle(
        "linear-short-periods",
        all_tend(),
        example=easy,
        note="the two sides of (24) are of order 1 on the boundary, so the relative error "
        "is of order $T$",
    )
