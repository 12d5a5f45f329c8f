r"""Do the mass, the spring and the damper of an arm all stabilise the wall?

The paper concludes that each of these parts is stabilising. A single wall that is stable without
one of these parts and unstable with it is a counterexample. The areas of the regions are compared
in \chapter{s4d_areas_of_the_arm}. For each wall we show its polynomial,
$z^{d+1}(z^2-az+e)+(n_1z+n_0)((\alpha+\beta)z-\beta)$ with the coefficients of the device, and a
zero with a certified enclosure. Without delay a calculation by hand is sufficient: Jury's
inequality $1-a_0^2>|a_1-a_0a_2|$ decides the stability of $z^3+a_2z^2+a_1z+a_0$.
"""

from symhaptic.book.lemmas.passive_is_stable import EVERY_MARGIN, LOOP, MARGIN, passive_is_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.book.lemmas.walls import divisors
from symhaptic.paper.propositions.stability import MORE


def derive(page):
    page.say(
        "\\emph{The spring.} Take no delay, no damping, $\\alpha=\\tfrac{269}{400}$ and "
        "$\\beta=\\tfrac{97}{100}$. With a free mass the wall is stable:"
    )
    wall = {
        alpha: Rational(269, 400),
        beta: Rational(97, 100),
        gamma: S.Zero,
        delta: S.Zero,
        d: S.Zero,
    }
    free = page.lemma(
        r"Without a spring the wall $\alpha=\frac{269}{400}$, $\beta=\frac{97}{100}$ is stable",
        stable_at(wall),
    )
    page.say(
        r"The stiffest spring of (23), $\gamma=0.001$, makes this wall unstable. It moves the "
        r"right end of the region to the left by about $\gamma/2$, and the left bound by $\gamma$."
    )
    sprung = {**wall, gamma: Rational(1, 1000)}
    witness = page.lemma(
        "With the spring $\\gamma=0.001$ the same wall is not stable", unstable_at(sprung)
    )
    page.say(
        "\\emph{The mass.} With everything else unchanged, $\\alpha$, $\\beta$ and $\\delta$ are "
        "inversely proportional to $m$. Take one period of delay, $\\delta=0.02$, "
        "$\\alpha=\\tfrac9{800}$, $\\beta=-\\tfrac{13}{4000}$ and no spring:"
    )
    light = {
        alpha: Rational(9, 800),
        beta: Rational(-13, 4000),
        gamma: S.Zero,
        delta: Rational(1, 50),
        d: S.One,
    }
    heavy = {symbol: value if symbol == d else value / 2 for symbol, value in light.items()}
    steady = page.lemma(
        "With the mass $m$ the wall $\\frac9{800}$, $-\\frac{13}{4000}$ is stable", stable_at(light)
    )
    falls = page.lemma("With twice the mass the same wall is not stable", unstable_at(heavy))
    page.say(
        "With more mass a wall comes closer to the line of the linear condition (25). Near this "
        "wall the line lies inside the exact region. For the damper see "
        r"\chapter{s4d_parts_damping}."
    )
    passive = [EVERY_MARGIN, gamma >= 0, delta > 0, alpha > 0, whole(d)]
    stiff = positive(alpha + gamma > 0, alpha > 0, gamma >= 0)
    robust = closed(conjunct(passive_is_stable(), STABLE), stiff)
    page.settle(
        "s4d-all-stabilising",
        for_all(LOOP, passive, robust),
        instead=every(LOOP, passive, STABLE),
        corrected=[r"\text{no spring destabilises a passive wall}"],
        example=_passive_wall(passive),
        misprint=False,
        unless=[
            (_arms(wall, 1, sprung[gamma]), free, witness),
            (_arms(light, 2, S.Zero), steady, falls),
        ],
        shows="some wall is stable with a free mass and unstable with a spring of (23)",
        note="the correction concerns single walls. Twice the mass destabilises a wall at $d=1$, "
        "and outside (23) more damping can destabilise a wall. Without delay, none of the three "
        r"parts reduces the area (\texttt{s4d-all-stabilising-area})",
    )


def _arms(wall, mass, spring):
    """The parameters of a loop with m = T = 1, and the mass and the spring of another arm."""
    before = {K: wall[alpha], B: wall[beta], T: S.One, m: S.One, b: wall[delta], k: wall[gamma]}
    return before | {d: wall[d]} | dict(zip(MORE, (S(mass), wall[delta], spring), strict=True))


def _passive_wall(given):
    """With alpha = 1, delta = 2 and one period of delay the margin is 3/2 - cos(theta)."""
    wall = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S(2), d: S.One}
    turn = square(1 - cos(theta)), bounded(cos, theta)
    left = combined(MARGIN.xreplace(wall) >= 0, *([S.Half, known] for known in turn), [S.Half])
    angles = for_all([theta], INSIDE, closed(left, *divisors(theta)))
    return example(wall, given, angles)
