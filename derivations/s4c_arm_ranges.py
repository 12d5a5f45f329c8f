"""How much wider are the ranges (23) than those of the arms in the literature?

According to the paper the ranges are wider by roughly 30 %, and according to the caption of Fig. 6
by 30 %. The paper also assumes a period of at most 1 ms. We check both numbers, and ask for which
periods the ranges contain all arms.
"""

from sympy import ceiling

from symhaptic.book.figures.arm import arms
from symhaptic.book.lemmas.arm import in_numbers
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.arm import LONGEST, extended
from symhaptic.paper.tables import DEVICE_RATIO, EXCLUDED, TABLE_II

STIFFNESS, DAMPING = Rational(710), Rational("15.225")
"""Limits (22) over T^2 and T, in 1/s^2 and 1/s."""


def derive(page):
    before = (STIFFNESS * LONGEST**2, DAMPING * LONGEST)
    page.say(
        "At $T=1$ ms the limits (22) are 0.00071 and 0.015225. We extend these limits by 30 %:"
    )
    wide = []
    for name, value, plain, text in (
        (gamma, before[0], "0.00071", "0.000923"),
        (delta, before[1], "0.015225", "0.0197925"),
    ):
        more = page.step(
            f"An extension by 30 % gives this limit of ${NAMES[name]}$",
            value * 13 / 10,
            Rational(text),
            name=rf"1.3\cdot{plain}",
            because=f"the product is {text}",
        )
        wide.append(ceiling(more / LONGEST) * LONGEST)
    page.say("Rounded up to thousandths, these limits are those of (23): 0.001 and 0.020.")
    page.settle(
        "eq23",
        gamma >= 0,
        gamma <= wide[0],
        delta >= 0,
        delta <= wide[1],
        definition=True,
        note=r"the ranges are a choice; they contain (22) for $T\le1.186$ ms",
    )
    factors = [more / value for more, value in zip(wide, before, strict=True)]
    page.enclosed(
        "Rounding makes the ranges wider",
        [
            (rf"\frac{{{text}}}{{{NAMES[name]}}}\Big|_{{(22)}}", factor)
            for name, text, factor in zip(NAMES, ("0.001", "0.020"), factors, strict=True)
        ],
        because=r"the factors are $\tfrac{100}{71}$ and $\tfrac{800}{609}$: the stiffness range "
        "is extended by 41 % and the damping range by 31 %",
        places=6,
    )
    _extension(page)
    periods(page)
    page.figure(
        "fig6",
        "Fig. 6 of the paper: the arms of Table II, with the bounds (21) and the range (23).",
        arms,
    )
    page.settle(
        "fig6",
        conj(*map(fact, page.claim("fig6").of)),
        note="the statement holds at $T=1$ ms; the excluded row has $k_H/m_H=6667$ 1/s$^2$ and "
        r"$b_H/m_H=50$ 1/s, but (23) allows 1000 1/s$^2$ and 20 1/s. For the 30\,\% of the "
        r"caption see \texttt{s4c-extension-30}",
    )


def _extension(page):
    """To the nearest ten per cent, 30 % is right only for the damping."""
    claim = page.claim("s4c-extension-30")
    right = extended(("1.405", "1.415"), ("1.305", "1.315"))
    at = {T: LONGEST}
    symbols, given, then = taken_apart(right)
    theorem = for_all(symbols, given, in_numbers(then, at))
    too_much = taken_apart(claim)[2].of[1].at(at)
    denial = not_all(taken_apart(claim)[2].at(at), fact(negated(too_much)))
    page.settle(
        "s4c-extension-30",
        theorem,
        instead=right,
        corrected=(r"\gamma\ \text{by}\ 41\,\%,\ \delta\ \text{by}\ 31\,\%",),
        misprint=False,
        example=at,
        unless=[(at, denial)],
        shows=r"at $T=1$ ms, the range of $\gamma$ grows by a factor of $1.408$",
        note=r"the ranges are extended by 41\,\% and 31\,\%, which is safe in both cases; the "
        r"statement is true for $\delta$. For shorter periods the ranges have an even larger "
        "margin",
    )


NAMES = {gamma: r"\gamma", delta: r"\delta"}


def periods(page):
    """The sampling periods for which (23) contains (22)."""
    short, period = T <= LONGEST, T > 0
    spare = LONGEST - STIFFNESS * LONGEST**2
    inside = positive(
        STIFFNESS * T**2 < LONGEST, [spare], [STIFFNESS, short, period], [STIFFNESS, LONGEST, short]
    )
    page.lemma("The range (23) covers the stiffness of (22)", inside)
    spare = 20 * LONGEST - DAMPING * LONGEST
    page.lemma(
        "The range (23) covers the damping of (22)",
        positive(DAMPING * T < 20 * LONGEST, [spare], [DAMPING, short]),
    )
    page.enclosed(
        "The ranges cover periods up to these, in milliseconds",
        [("T_{\\gamma}", sqrt(LONGEST / STIFFNESS) * 1000), ("T_{\\delta}", 20 / DAMPING)],
        because="with longer periods (23) excludes arms of Table II, beginning with the stiffest",
        places=6,
    )
    others = {row.authors: Rational(row.damping) / Rational(row.mass) for row in TABLE_II}
    for name in (EXCLUDED, "Tsuji et al."):
        del others[name]
    limit = max(others.values()) + Rational(DEVICE_RATIO)
    page.step(
        "Without the row of Tsuji et al. the limit of the damping is smaller",
        limit,
        Rational("13.225"),
        name="12.6+0.625",
        because=r"without this row, the limit of $\delta/T$ in (22) would be 13.225 instead of "
        "15.225",
    )
    page.settle_external(
        "s4c-wider-delta",
        "on the range in [10]",
        "without these values $\\delta$ is limited by $13.225\\,T$, with them by $15.225\\,T$",
    )
