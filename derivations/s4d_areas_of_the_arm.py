r"""How much area do the spring, the damper and the mass of an arm give to the stable region?

A single wall can be lost with each of them (\chapter{s4d_parts_of_the_arm}). This chapter compares
the areas of the regions without delay.
"""

from symhaptic.book.lemmas.areas import damper_adds, mass_adds
from symhaptic.book.lemmas.spring_adds import spring_adds
from symhaptic.proof.theorems.kernel import conj


def derive(page):
    page.say(
        "Without delay a spring moves the region to the left and takes nothing from it: each of "
        "Jury's inequalities gains by the move."
    )
    spring = page.lemma(
        "A wall that is stable without a spring, less 0.001 of $\\alpha$, is stable with "
        "$\\gamma=0.001$",
        spring_adds(),
    )
    damper = page.lemma(
        "A stable wall stays stable with more damping, inside (23)",
        damper_adds(),
        because="so that the region holds the one of less damping",
    )
    page.say(
        "With twice the mass $\\alpha$ and $\\beta$ of the same wall are half as large. An area of "
        "walls $(K,B)$ is therefore four times as large as the same area of $\\alpha$ and $\\beta$."
    )
    mass = page.lemma(
        "Four times the area inside is more than that around, with half the mass", mass_adds()
    )
    page.settle(
        "s4d-all-stabilising-area",
        conj(spring, damper, mass),
        note="without delay: the spring between the ends of (23), at both ends of the damping; the "
        "damper inside (23); the mass doubled, for the arm of Figs. 11 and 12. A single wall can "
        "be lost (s4d-all-stabilising)",
    )
