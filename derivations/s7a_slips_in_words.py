r"""Where does the text name one thing and mean another?

Some slips of the print change no formula: a wrong section, a wrong panel, a wrong name. What is
meant follows from the paper's own lists: its sections, its tables and the panels of Fig. 12.
"""

from sympy import Eq, Integer, Rational, S

from symhaptic.notation import SYMBOLS, TABLE_I, T, m
from symhaptic.paper.outline import FIGURE_12, SECTIONS
from symhaptic.paper.tables import TABLE_II
from symhaptic.proof.units import dimension_of


def derive(page):
    page.say(
        "The conclusion is the last of the six sections, and of the three plots of Fig. 12 the "
        "second and the third show the ratio. Their captions agree in all that they name; the "
        "delays for which they are drawn, which tell them apart, are not named."
    )
    last = Integer(SECTIONS.index("Conclusion") + 1)
    slip(page, "s1-conclusion", [6], [last], Eq(4, last), r"\text{Section VI}", "IV is Stability")
    shown = [Integer(i) for i, panel in enumerate(FIGURE_12, 1) if panel.quantity == "ratio"]
    both = r"\text{Fig. 12(b) and (c)}"
    slip(
        page, "s5b-ratio-panels", [2, 3], shown, Eq(1, shown[0]), both, "(a) shows the stiffnesses"
    )
    _, second, third = FIGURE_12
    alike = [Integer(getattr(second, part) == getattr(third, part)) for part in CAPTION]
    each = r"\text{each with the delays for which it is drawn}"
    slip(
        page, "s5b-captions-alike", [1, 1, 1], alike, Eq(sum(alike), 2), each, "two plots, one text"
    )
    page.say(
        "By Table I, $B$ is the virtual damping, and a bound that is linear in $m$ and $1/T$ has "
        "its unit. Three articles of Table II have two authors, as [27] has, which the "
        "table gives by both."
    )
    unit, stiffness = dimension_of(m / T), SYMBOLS["K"].dimension
    (name,) = (row.parameter for row in TABLE_I if row.variable == "B")
    slip(
        page,
        "s4d-bound-of-b",
        powers(unit),
        powers(SYMBOLS["B"].dimension),
        Eq(*(powers(u)[2] for u in (stiffness, unit))),
        rf"\text{{{name}}}\ B",
        "Table I, and the unit of the bound",
    )
    pairs = [row.reference for row in TABLE_II if row.writers == 2 and "et al." in row.authors]
    names = r"\text{two names for each of}\ " + ",".join(f"[{number}]" for number in pairs)
    slip(page, "s4c-et-al", [21, 28, 30], [S(n) for n in pairs], Eq(len(pairs), 0), names, TITLES)


TITLES = "the reference list, and [27] in the same table"

CAPTION = ("quantity", "springs", "delays_named")
"""What the caption of a panel of Fig. 12 names."""


def powers(unit):
    """Exponents of a unit as numbers to compare."""
    return [Rational(power) for power in unit]


def slip(page, id, right, found, printed, corrected, shows):
    """What is ``right`` equals what was ``found`` in the paper, and the ``printed`` is false."""
    proof = page.same(id, [S(n) for n in right], found)
    page.settle(id, proof, corrected=(corrected,), unless={}, truth=printed, shows=shows)
