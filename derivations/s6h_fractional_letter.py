r"""Which polynomial do the paper's curves for $d=1/4$ and $d=1/2$ belong to?

With $d=r/q$ the paper turns $z^{-d}$ into a polynomial by substituting $z=\zeta^q$. Read to the
letter, all its roots have to lie inside the unit circle, and that no wall of the figures can do.
"""

from symhaptic.book.lemmas.letter import (
    GIVEN,
    drawn_otherwise,
    not_those_drawn,
    only_within_the_spring,
    p,
    q,
    within_the_spring,
)
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at


def derive(page):
    page.say(
        "In $\\zeta$ the polynomial is $\\zeta^{q+r}A(\\zeta^q)+N(\\zeta^q)"
        "((\\alpha+\\beta)\\zeta^q-\\beta)$, of degree $3q+r$. Each of the $q$ sheets sees the "
        "wall turned by another multiple of $2\\pi d$. Let $q$ be even, as in all fractions of the "
        "paper. Then $r$ is odd, and at $\\zeta=-1$ is $z=1$ while $z^d=-1$: a sheet with "
        "the wall reversed."
    )
    static, total = device_static(assume(DEVICE)), n_1 + n_0
    for power, wall, title, because in (
        (
            1,
            gamma + alpha,
            "At $\\zeta=1$ the polynomial has the wall added to the spring",
            "positive if all roots are inside",
        ),
        (
            -1,
            alpha - gamma,
            "At $\\zeta=-1$ the polynomial has the spring taken from the wall, for even $q$",
            "negative if so, since the degree $3q+r$ is odd",
        ),
    ):
        value = Eq(power * (1 - a + e) + total * alpha, total * wall)
        page.lemma(title, combined(value, [static, power]), because=because)
    settle_literal(page)
    settle_figures(page)


def settle_literal(page):
    found = page.lemma(
        "To the letter the spring of the device bounds a stable wall, if $q$ is even",
        within_the_spring(),
        because="all zeros of $p_1(-\\zeta)$ lie inside, too, so that both values above have the "
        "sign of the highest power",
    )
    page.state(
        "fractional-literal",
        "to the letter, for even $q$, a wall is stable only if $|\\alpha|<\\gamma$: never without "
        "a physical spring",
        claim=only_within_the_spring(),
    )
    idle = {alpha: HALF / 5, beta: HALF / 5, gamma: S.One, delta: S.One, p: S.Zero, q: S.Zero}
    there = idle | {d: HALF}
    page.settle("fractional-literal", found, example=example(idle, GIVEN, stable_at(there)))


def settle_figures(page):
    page.say(
        "In Fig. 11 $\\gamma=0.001$, $\\delta=0.02$, and the text says that the passive regions "
        "lie inside the stable ones. By (11) they reach to $\\alpha=0.023$ for $d=\\frac12$, 23 "
        "times as far as the stable walls of this reading could, and for $d=\\frac14$ farther "
        "still. Sec. V-C speaks of walls that are stable for all $\\gamma\\ge0$; to the letter "
        "there is none at $\\gamma=0$."
    )
    page.state(
        "fractional-figures",
        "the curves of Fig. 11 and Fig. 13 for fractional delays are not those of the polynomial "
        "read to the letter: in Fig. 11 a wall that meets (5) would not be stable, and in Fig. 13 "
        "no wall would be",
        claim=not_those_drawn(),
    )
    page.settle(
        "fractional-figures",
        drawn_otherwise(),
        note="Fig. 4 is (7), the principal sheet; whether the others are drawn from it or from "
        "the exact plant cannot be told from the text",
    )
