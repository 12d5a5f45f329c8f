r"""By how much does a delay reduce the area of the stable region?

The paper says that the region becomes smaller. The regions of two delays are not nested
(\chapter{s4d_parts_delay}). This chapter compares the areas of these regions.
"""

from symhaptic.book.lemmas.areas import around, delay_takes_area, inside
from symhaptic.paper.propositions import areas

DELAY = 2


def derive(page):
    page.say(
        "A polygon of stable walls bounds the area of a region from below, and a polygon that "
        "holds all stable walls bounds it from above. All walls of a convex polygon are stable "
        "if one of them is stable and no wall of the polygon puts a zero of the characteristic "
        "polynomial on the unit circle. We check the second condition at each angle: one side "
        "of the polygon separates the polygon from the wall that has a zero at this angle. For "
        f"the arm of Figs. 11 and 12 and $d={DELAY}$, two polygons give the bounds:"
    )
    page.lemma(f"The walls of a polygon are stable for $d={DELAY}$", inside(DELAY))
    page.say(
        "The sides of the second polygon are tangents to the boundary "
        r"(\chapter{s5b_stiffest_wall}), except the left and the lower side. The lower side "
        "follows from Hurwitz' criterion."
    )
    page.lemma(f"A second polygon contains all stable walls for $d={DELAY}$", around(DELAY))
    rows = [
        [
            delay,
            _shown(areas.area(areas.inner(delay))),
            "" if not delay else _shown(areas.area(areas.corners(areas.outer(delay)))),
        ]
        for delay in range(areas.LONGEST + 1)
    ]
    page.table(
        r"Areas of the two polygons of each delay, $\gamma=0.001$, $\delta=0.02$",
        ["$d$", "inside", "around"],
        rows,
    )
    page.settle(
        "s4d-delay-shrinks-area",
        delay_takes_area(),
        note="the area falls with each period of delay, up to $d=8$, for one arm; the regions "
        r"themselves are not nested (\texttt{s4d-delay-shrinks})",
    )


def _shown(area):
    return f"{float(area):.4g}"
