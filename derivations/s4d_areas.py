r"""How much area does a delay take from the stable region?

The paper says that the region becomes smaller. The regions of two delays are not nested
(\chapter{s4d_parts_delay}). This chapter compares their areas.
"""

from symhaptic.book.lemmas.areas import around, delay_takes_area, inside
from symhaptic.paper.propositions import areas

DELAY = 2


def derive(page):
    page.say(
        "A polygon of stable walls bounds the area of a region from below, and a polygon that "
        "holds all stable walls bounds it from above. All walls of a convex polygon are stable if "
        "one is, and if no wall of it puts a zero of the characteristic polynomial on the unit "
        "circle: at each angle some side of the polygon separates it from the wall with such a "
        "zero. "
        f"For the arm of Figs. 11 and 12 and $d={DELAY}$:"
    )
    page.lemma(f"The walls of a polygon are stable for $d={DELAY}$", inside(DELAY))
    page.say(
        "Each side of the other polygon is a tangent to the boundary "
        r"(\chapter{s5b_stiffest_wall}), except the left one and the lower one, which follows "
        "from Hurwitz' criterion."
    )
    page.lemma(f"All stable walls of $d={DELAY}$ lie in another polygon", around(DELAY))
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
        note="from each delay to the next, $d=0$ to 8, for one arm; as sets of walls the regions "
        "are not nested (s4d-delay-shrinks)",
    )


def _shown(area):
    return f"{float(area):.4g}"
