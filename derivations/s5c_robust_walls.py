"""How stiff can a robustly stable wall be?

Sec. V-C relates passivity to robust stability: a robustly stable wall is stable with every spring
up to the Nyquist frequency. We ask how much stiffer it can be than a passive wall, and how this
depends on delay and damping.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.robust import (
    STIFFEST,
    WALLS,
    conservative,
    grows,
    is_robust,
    none_stiffer,
    shrinks,
    softest,
    tip_is_robust,
)
from symhaptic.paper.propositions.robust import AT_MOST, CONSERVATIVE


def derive(page):
    page.say(
        "The wall (11) is passive, and therefore robustly stable. Its stiffness is a lower bound "
        "of the largest robustly stable stiffness:"
    )
    page.lemma(
        "The passive wall of maximum stiffness is stable with every spring of (30), with every "
        "integer delay",
        tip_is_robust()[0],
    )
    page.say(
        r"For $\delta=0.02$ a slightly stiffer wall is robustly stable, too. Jury's inequalities "
        "are polynomials in the coefficients of the device, and balls contain these for all "
        rf"springs up to $\gamma={float(STIFFEST)}$, which is beyond (30). An example has one "
        "period of delay:"
    )
    stiffness, damping = WALLS[1]
    page.lemma(
        f"The wall $\\alpha={float(stiffness)}$, $\\beta={float(damping)}$ is robustly stable for "
        "$d=1$",
        is_robust(1),
    )
    page.say(
        "One spring is sufficient for an upper bound, since a robustly stable wall is stable "
        r"with this spring. We choose a spring with $\Omega$ close to $\frac\pi{2(d+1)}$. "
        r"Without delay, two springs are necessary: $\gamma=0$ and the spring of the Nyquist "
        "frequency."
    )
    limit, bound = none_stiffer(1, DAMPED)
    page.lemma(
        rf"With $\gamma={float(softest(1, DAMPED))}$ and $d=1$ every stable wall has "
        rf"$\alpha<{float(limit)}$",
        bound,
        because="the bound follows from the inequality at one point of the circle "
        r"(\chapter{s5b_stiffest_wall})",
    )
    rows = [[n, *ends] for n, ends in CONSERVATIVE.items()]
    rows += [[n, "1", end] for n, end in AT_MOST.items()]
    page.table(
        "Bounds of the ratio of the largest robustly stable to the largest passive stiffness for "
        r"$\delta=0.02$.",
        ["$d$", "more than", "less than"],
        rows,
    )
    page.settle(
        "s6-why-conservative",
        conservative(),
        enclosed=True,
        note="with the springs of (23), a stable wall can be 17.8 times as stiff as a passive "
        "one at $d=0$. A wall that is stable with all springs of (30) is less than 1.118 times "
        "as stiff at $d=0$, and less than 1.0532 times at $d=1$. So stiff springs explain "
        "nearly all of the difference",
    )
    changes(page)
    left_open(page)


def changes(page):
    """The largest robustly stable stiffness as a function of delay and damping."""
    page.settle(
        "s5c-robust-shrinks",
        shrinks(),
        note=r"the statement is proved for the largest stiffness, $\delta=0.02$ and the integer "
        "delays 0 to 8; for the regions as sets of walls it is undecided "
        r"(\texttt{s5c-robust-shrinks-sets})",
    )
    dampers = ", ".join(f"{float(v):g}" for v in (Rational(1, 200), Rational(1, 100), DAMPED))
    page.settle(
        "s5c-robust-grows",
        grows(),
        note=rf"the statement is proved for the largest stiffness, for $\delta$ of {dampers} and "
        "the integer delays of Fig. 11; for the regions as sets of walls it is undecided "
        r"(\texttt{s5c-robust-grows-sets})",
    )


def left_open(page):
    """The statements that no theorem decides."""
    page.say(
        r"Three statements remain open. For $\delta=0.02$ and the delays 0, 1, 2, 4 and 8 each "
        "computed outline of the robustly stable region lies inside the previous one. For the "
        r"delays 0, 1, 2 and 4 the outline for $\delta=0.01$ lies inside that for 0.02. Computed "
        "outlines are not a proof. It is also open whether a robustly stable wall that is not "
        "passive is stable with springs beyond the Nyquist frequency."
    )
    page.leave_open(
        "s5c-robust-shrinks-sets",
        r"no counterexample was found for $\delta=0.02$ and $d=0,1,2,4,8$",
    )
    page.leave_open(
        "s5c-robust-grows-sets",
        r"no counterexample was found for $\delta$ of 0.01 and 0.02 and $d=0,1,2,4$",
    )
    page.leave_open(
        "s5c-every-spring",
        r"known for passive walls with $\alpha>0$ (\texttt{s5c-robust-subset}), and for "
        r"$\delta=0$, where no wall is robustly stable (\texttt{s5c-robust-vanishes})",
    )
