r"""Can too much virtual damping make a wall unstable?

A physical damper only takes energy. The virtual one acts on the mean speed of the last period
and is held for the next. We look for a bound that no stable wall can exceed.
"""

from symhaptic.book.lemmas.damping_bound import bounded_damping
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.model import loop
from symhaptic.paper.propositions.stability import AFTER, lost_by_damping

ARM = {gamma: Rational(1, 1000), delta: Rational(1, 50), alpha: Rational(1, 20)}
"""The largest spring and damper of (23)."""


def derive(page):
    polynomial = loop.named()
    last = polynomial - (z ** (d + 1)) * polynomial.coeff(z ** (d + 1))
    page.step(
        "The constant coefficient is $-\\beta n_0$ for every delay",
        last.subs(z, 0),
        -beta * n_0,
        name="p_1(0)",
        because="the rest of the polynomial has the factor $z^{d+1}$, for every whole $d$",
    )
    page.say(
        "The polynomial is monic, so that, up to the sign, this is the product of its roots. If "
        "all lie inside the unit circle, $|n_0\\beta|<1$, whatever $\\alpha$, $\\gamma$, $\\delta$ "
        "and the delay are. A free mass has $n_0=\\tfrac12$ and $|\\beta|<2$, that is "
        "$|B|<2m/T$. With a delay of $p/q$ periods it is the same for the polynomial in "
        "$z^{1/q}$. Where $n_0=0$, with springs far stiffer than an arm, the next coefficient "
        "bounds $n_1\\beta$; and where $n_1=0$ too, no wall is stable."
    )
    bounded = page.lemma(
        "Beside each device and delay one bound of $\\beta$ holds for all stable walls",
        bounded_damping(),
        boxed=True,
    )
    page.say(
        "For the largest spring and damper of (23), $\\gamma=0.001$ and $\\delta=0.02$, and the "
        "stiffness $\\alpha=0.05$:"
    )
    for delay, low, high in ((0, "1.9", "2.1"), (1, "0.7", "0.9")):
        for text, shown, word in ((low, stable_at, "stable"), (high, unstable_at, "not stable")):
            wall = {**ARM, d: S(delay), beta: Rational(text)}
            where = f"For $d={delay}$, $\\gamma=0.001$, $\\delta=0.02$"
            page.lemma(f"{where} the wall $(0.05,{text})$ is {word}", shown(wall))
    page.say(
        "With a delay less damping is too much. By the first theorem no virtual stiffness can make "
        "up for it."
    )
    given = [gamma >= 0, delta >= 0, d >= 0]
    page.settle(
        "s4d-too-much-damping",
        conj(for_all((gamma, delta, d), given, add_assum(bounded, *given)), _lost()),
        note="$|n_0\\beta|<1$ for every delay",
    )


def _lost():
    """Without delay beta = 1.9 is stable beside alpha = 0.05, and 2.1 is not."""
    wanted = lost_by_damping()
    little, much = ({**ARM, d: S.Zero, beta: Rational(text)} for text in ("1.9", "2.1"))
    values = {**little, AFTER: much[beta]}
    known = {t.conclusion: t for t in (stable_at(little), unstable_at(much))}
    there = [part.at(values) for part in wanted.body.parts]
    return exists(conj(*(known.get(p) or fact(p) for p in there)), wanted, values)
