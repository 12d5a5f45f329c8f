r"""Where does the text name one thing and mean another?

Some slips of the print change no formula: a wrong section, a wrong panel, a wrong name. What is
meant follows from the paper's own lists: its sections, its tables and the panels of Fig. 12.
"""

from symhaptic.notation.proposition import And, conjuncts, negated
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.words import (
    conclusion_is,
    damping_has_the_unit,
    ratio_in,
    told_apart,
    two_names,
)
from symhaptic.proof.theorems.judge import Case
from symhaptic.proof.theorems.kernel import NotShown, conjoined
from symhaptic.proof.theorems.tactics import fact, not_all


def derive(page):
    page.say(
        "What is printed in one place is held against what is printed in another, as a relation "
        "of numbers: of sections, panels, rows and authors. That they are printed so has to be "
        "believed, as for a table."
    )
    page.say(
        "The conclusion is the last of the six sections, and of the three plots of Fig. 12 the "
        "second and the third show the ratio. Their captions agree in all that they name; the "
        "delays for which they are drawn, which tell them apart, are not named."
    )
    slip(page, "s1-conclusion", conclusion_is(6), r"\text{Section VI}", "IV is Stability")
    both = r"\text{Fig. 12(b) and (c)}"
    slip(page, "s5b-ratio-panels", ratio_in(("b", "c")), both, "(a) shows the stiffnesses")
    each = r"\text{each with the delays for which it is drawn}"
    slip(page, "s5b-captions-alike", told_apart(("scale",)), each, "two plots, one text")
    page.say(
        "By Table I, $B$ is the virtual damping, and a bound that is linear in $m$ and $1/T$ has "
        "its unit. Three articles of Table II have two authors, as [27] has, which the "
        "table gives by both."
    )
    damping = r"\text{virtual damping}\ B"
    unit = "Table I, and the unit of the bound"
    slip(page, "s4d-bound-of-b", damping_has_the_unit(), damping, unit)
    names = r"\text{two names for each of}\ [21],[28],[30]"
    slip(page, "s4c-et-al", two_names((21, 28, 30)), names, TITLES)


TITLES = "the reference list, and [27] in the same table"


def slip(page, id, meant, corrected, shows):
    """The print is false by the paper's own lists, and what is ``meant`` is true."""
    found = [fact(relation) for relation in conjuncts(meant)]
    page.settle(
        id,
        conjoined(*found) if isinstance(meant, And) else found[0],
        instead=meant,
        corrected=(corrected,),
        unless=[Case({}, denied(CLAIMED[id](())))],
        shows=shows,
    )


def denied(claim):
    """Not all relations of a claim between numbers are true."""
    for relation in conjuncts(claim):
        try:
            denial = fact(negated(relation))
        except NotShown:
            continue
        return not_all(claim, denial) if isinstance(claim, And) else denial
    raise NotShown("what is printed is true")
