r"""What does each part cost that is left out of the model?

A loop is easier to understand with fewer parts. How far is the largest stable stiffness off, on all
of the range (23), if the arm's spring, its damper or both are not modelled? And how far is the
linear condition, where the damping of the wall is given?
"""

from fractions import Fraction
from math import ceil

from flint import arb
from sympy import Rational, Symbol

from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.report.cost_figures import costs as draw
from symhaptic.simplest.at_damping import at_damping, line
from symhaptic.simplest.cost import Model, cost
from symhaptic.simplest.plants import Interval
from symhaptic.simplest.stiffest import stiffest

COST = Symbol("c")
NONE = Fraction(0)
RANGES = Interval(NONE, Fraction(1, 1000)), Interval(NONE, Fraction(1, 50))
"""The paper's (23), of gamma and delta."""

DELAYS = (0, 1, 2)
CLOSE = 1e-9
"""No cost is that small: its two bounds are then within a per cent of it."""

PARTS = (
    ("The spring costs", (0,), (8, 34, 78)),
    ("The damper costs", (1,), (380, 680, 980)),
    ("Spring and damper cost", (0, 1), (380, 680, 970)),
)
"""What is left out, and bounds of the cost in 1/10000 for the three delays."""


def derive(page):
    page.say(
        "Let $\\alpha_{\\max}(\\gamma,\\delta)$ be the largest stable stiffness, as found in the "
        "chapters before: a closed form for $d=0$, else the largest value of the boundary up to "
        "$\\theta=\\pi/(d+\\frac12)$. Without a spring it is $\\alpha_{\\max}(0,\\delta)$, without "
        "a damper $\\alpha_{\\max}(\\gamma,0)$. What a part costs is the largest "
        "$|\\alpha_{\\max}'/\\alpha_{\\max}-1|$ on the range, with $\\alpha_{\\max}'$ for the "
        "smaller model."
    )
    page.say(
        "Both lie in balls for a whole box of plants. At the best angle the boundary has no slope, "
        "so that $\\alpha_{\\max}$ changes with the plant as the boundary does at a fixed angle; "
        "with these slopes and the error in the middle of a box the error on the box is known, and "
        "the box is halved until the bounds are within one per cent of each other."
    )
    facts = [fact for part in PARTS for fact in bounded(page, *part)]
    page.say(
        "So the spring may be left out where an error below one per cent is allowed, up to $d=2$; "
        "the damper only where ten are. Both together cost less than the damper alone, as the two "
        "errors have opposite signs: a damper allows stiffer walls, a spring softer ones."
    )
    linear(page)
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
    page.settle("model-costs", *facts, note="whole delays")


def bounded(page, title, parts, limits):
    """What the parts cost for each delay, and that it is below the limits."""
    rows, facts = [], []
    for delay, limit in zip(DELAYS, limits, strict=True):
        whole = stiffest(delay)
        found = cost(whole, Model(whole, parts), RANGES, CLOSE)
        rows.append((delay, down(found.least), up(found.most)))
        known = Known({COST: arb(found.most)})
        facts.append(box.positive(Rational(limit, 10000) - COST, {}, known))
    head = ("$d$", "at least", "at most")
    page.table(f"{title} so much on (23), in per cent, between two bounds.", head, rows)
    return [
        page.positive(f"{title} less", fact, f"d={delay}", name=rf"{limit / 100:g}\,\%-c")
        for delay, limit, fact in zip(DELAYS, limits, facts, strict=True)
    ]


def linear(page):
    """The linear condition, for walls of some damping."""
    damper, damping = Interval(Fraction(1, 100), RANGES[1].high), Interval(NONE, Fraction(1, 50))
    page.say(
        "The linear condition (25) has no largest stiffness. Where $\\beta$ is given, its "
        "$\\alpha_{\\text{lin}}=(\\beta+\\delta)/(d+\\frac12)$ stands beside the largest stiffness "
        "that is stable at this $\\beta$. Its crossings with the boundary are zeros of a "
        "polynomial, each in a ball; between two of them one wall tells whether walls are stable."
    )
    rows = []
    for delay in DELAYS:
        found = cost(at_damping(delay), line(delay), (RANGES[0], damper, damping), CLOSE)
        rows.append((delay, down(found.least), up(found.most)))
    page.table(
        "What (25) costs for $\\gamma\\le0.001$, $0.01\\le\\delta\\le0.02$, $0\\le\\beta\\le0.02$, "
        "in per cent, between two bounds.",
        ("$d$", "at least", "at most"),
        rows,
    )


def up(number):
    """Per cent, rounded up."""
    return f"{ceil(number * 1e6) / 1e4:.4f}"


def down(number):
    """Per cent, rounded down."""
    return f"{int(number * 1e6) / 1e4:.4f}"
