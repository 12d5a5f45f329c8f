r"""Does twice the sampling rate give four times the stiffness?

The paper reads from Table I how the stable walls change with the period $T$ and the mass $m$, for
a constant delay factor $d$. What happens to the operator's $b$ and $k$ meanwhile? If they change
as well, the loop stays the same. If they are kept it does not, and a damped mass without spring
and delay, $\gamma=0$ and $d=0$, shows by how much. More theorems are in \chapter{s4d_scaling_kept}.
"""

from symhaptic.book.lemmas.near_tip import none_above
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.scaling import with_the_mass, with_the_rate
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import numbers_known
from symhaptic.paper.propositions.stability import HEAVY, STIFFER, STRONGER
from symhaptic.proof.enclosed import value

ARM = plant.sampled(plant.normalised(Parts(stiffness=False)))
BEFORE, AFTER = Rational(1, 50), Rational(1, 100)
"""delta within (23), and with half the period or twice the mass but the same damper."""

STIFF = {alpha: Rational(713, 1000), beta: Rational(33, 40)}
BRAKED = {alpha: Rational(1, 1000), beta: Rational(101, 50)}


def derive(page):
    all_scaled(page)
    bare = {gamma: S.Zero, delta: BEFORE, d: S.Zero}
    page.say("Now keep $b$. For $\\delta=\\frac1{50}$, the end of the range (23), two walls:")
    page.lemma(
        "For $\\gamma=0$, $\\delta=\\frac1{50}$ the wall $\\alpha=0.713$, $\\beta=0.825$ is stable",
        stable_at({**bare, **STIFF}),
    )
    page.lemma(
        "For $\\gamma=0$, $\\delta=\\frac1{50}$ the wall $\\alpha=0.001$, $\\beta=2.02$ is stable",
        stable_at({**bare, **BRAKED}),
    )
    page.enclosed(
        "For $\\delta=\\frac1{100}$ the largest damping and stiffness are enclosed",
        [
            (r"\alpha_{\max}", value(boundary.largest_undelayed(ARM), {delta: AFTER})),
            (r"1/n_0\big|_{\delta=0.01}", value(1 / ARM.n0, {delta: AFTER})),
        ],
        because="that is the same damper with half the period: no $\\beta$ makes the first wall's "
        "$\\alpha$, four times its stiffness, stable, and no $\\alpha$ the second wall's $\\beta$, "
        "twice its damping",
    )
    page.lemma(
        "For $\\gamma=0$, $\\delta=\\frac1{100}$ all stable walls are softer than this",
        none_above((S.Zero, AFTER), 0)[1],
        because="so less than 3.93 times the stiffness is left: four times this bound is less than "
        "$3.93\\cdot0.713$. Twice the mass with the same damper is $\\delta=\\frac1{100}$ too",
    )


def all_scaled(page):
    """The period or the mass changes, and all else with it: the loop stays stable or not."""
    page.lemma(
        "Half the period changes nothing if all else is scaled with it",
        numbers_known(inst(with_the_rate(STIFFER, STRONGER), {y: S(2)})),
        because="for every delay in periods",
    )
    heavier = inst(with_the_mass(STIFFER, STRONGER), {HEAVY: 2 * m})
    page.lemma(
        "Twice the mass changes nothing if all else is doubled",
        closed(heavier, positive(2 * m > 0, [2, m > 0]), positive(Ne(m, 0), m > 0)),
    )
