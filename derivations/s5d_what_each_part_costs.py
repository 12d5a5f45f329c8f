r"""What does each part cost that is left out of the model?

A loop is easier to understand with fewer parts. How far is the largest stable stiffness off, on all
of the range (23), if the arm's spring, its damper or both are not modelled? And how far is the
linear condition, where the damping of the wall is given?
"""

from fractions import Fraction
from math import ceil

from flint import arb
from sympy import Rational, Symbol

from symhaptic.book.figures.cost import costs as draw
from symhaptic.bounds.simplest.at_damping import error_of_line
from symhaptic.bounds.simplest.cost import Model, cost, error
from symhaptic.bounds.simplest.max_stiffness import stiffest
from symhaptic.bounds.simplest.plants import Interval
from symhaptic.proof import box
from symhaptic.proof.certificate import Known

COST = Symbol("c")
NONE = Fraction(0)
RANGES = Interval(NONE, Fraction(1, 1000)), Interval(NONE, Fraction(1, 50))
"""The paper's (23), of gamma and delta."""

DELAYS = (0, 1, 2)
LINEAR = (RANGES[0], Interval(Fraction(1, 100), RANGES[1].high), Interval(NONE, Fraction(1, 50)))
"""Where the linear condition is looked at: gamma, delta and beta."""

CLOSE = 1e-9
"""No cost is that small: its two bounds are then within a per cent of it."""

PARTS = (
    ("Without the spring", (0,), (8, 34, 78)),
    ("Without the damper", (1,), (380, 680, 980)),
    ("Without both", (0, 1), (380, 680, 970)),
)
"""What is left out, and limits of the cost in 1/10000 for the three delays."""


def derive(page):
    page.say(
        "Let $\\alpha_{\\max}(\\gamma,\\delta)$ be the largest stable stiffness, as found in "
        "\\chapter{s5b_stiffest_undelayed} and \\chapter{s5b_stiffest_wall_bound}: a closed form "
        "for $d=0$, else the largest value of the boundary up to $\\theta=\\pi/(d+\\frac12)$. "
        "Without a spring it is $\\alpha_{\\max}(0,\\delta)$, without a damper "
        "$\\alpha_{\\max}(\\gamma,0)$. What a part costs is the largest "
        "$|\\alpha_{\\max}'/\\alpha_{\\max}-1|$ on the range, with $\\alpha_{\\max}'$ for the "
        "smaller model."
    )
    page.say(
        "Both lie in balls for a whole box of plants. At the best angle the boundary has no slope, "
        "so that $\\alpha_{\\max}$ changes with the plant as the boundary does at a fixed angle; "
        "with these slopes and the error in the middle of a box the error on the box is known, and "
        "the box is halved until the bounds are within one per cent of each other."
    )
    found = {title: [left_out(d, parts) for d in DELAYS] for title, parts, _ in PARTS}
    page.say(
        "The linear condition (25) has no largest stiffness. Where $\\beta$ is given, its "
        "$\\alpha_{\\text{lin}}=(\\beta+\\delta)/(d+\\frac12)$ stands beside the largest stiffness "
        "that is stable at this $\\beta$. The points of the boundary with this $\\beta$ are zeros "
        "of a polynomial, each in a ball; between two of them one wall tells if all are stable."
    )
    lines = [cost(error_of_line(d), LINEAR, CLOSE) for d in DELAYS]
    page.table(
        "Bounds of the cost in per cent, one in a hundred too large at most. The first three rows "
        "are for all of (23), the last for $\\gamma\\le0.001$, $0.01\\le\\delta\\le0.02$ and "
        "$0\\le\\beta\\le0.02$, at a given $\\beta$.",
        ("", *(f"$d={d}$" for d in DELAYS)),
        [
            (title, *(up(c.most) for c in costs))
            for title, costs in [*found.items(), ("The linear condition (25)", lines)]
        ],
    )
    facts = [fact for title, _, limits in PARTS for fact in below(found[title], limits)]
    page.say(
        "So the spring may be left out where an error below one per cent is allowed, up to $d=2$; "
        "the damper only where ten are. Both together cost less than the damper alone, as the two "
        "errors have opposite signs: a damper allows stiffer walls, a spring softer ones."
    )
    page.figure(
        "costs",
        "Error of the largest stable stiffness without damper, for $\\gamma=0.001$ (left), and "
        "without spring, for $\\delta=0.02$ (right).",
        draw,
        panels=(1, 2),
        height=0.42,
    )
    page.state(
        "model-costs",
        "on all of (23) the largest stable stiffness is known to 0.08, 0.34, 0.78 per cent without "
        "the spring and to 3.8, 6.8, 9.8 per cent without the damper, for $d=0,1,2$",
    )


def left_out(delay, parts):
    """What parts cost on (23)."""
    whole = stiffest(delay)
    return cost(error(whole, Model(whole, parts)), RANGES, CLOSE)


def below(costs, limits):
    """Every cost is below its limit."""
    for found, limit in zip(costs, limits, strict=True):
        yield box.positive(Rational(limit, 10000) - COST, {}, Known({COST: arb(found.most)}))


def up(number):
    """Per cent, rounded up."""
    return f"{ceil(number * 1e5) / 1000:.3f}"
