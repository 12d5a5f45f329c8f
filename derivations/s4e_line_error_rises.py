r"""Does the error of the linear condition rise along the boundary?

It starts with a negative value, or without bound, and is zero where the boundary crosses the line.
We show that it rises as long as the virtual damping is negative, and is below 2 per cent there.
"""

from sympy import Rational, cancel, diff, expand

from symhaptic.bounds.linear_points import SHAPE
from symhaptic.model import linear
from symhaptic.paper.ranges import RANGES
from symhaptic.proof.box import positive

HALF, LEVEL = Rational(1, 2), Rational(2, 100)
INSIDE = r"\text{inside (23)}"
Y = linear.CHORD


def derive(page):
    page.say(
        "Write $|M|^2\\Delta=yF-g|M|^2$ and $|M|^2(\\alpha+\\gamma)=yR$ with polynomials $F$, $R$ "
        "in $y$, which the chapter on the error has for $d=0$ and $d=1$."
    )
    rising = [fact for delay, end in ((0, 203), (1, 61)) for fact in rises(page, delay, end)]
    page.state(
        "linear-error-rises",
        "inside (23), for $d=0$ and $d=1$, the error $\\varepsilon$ rises along the arc as long as "
        "$\\beta\\le0$, and is less than 2\\,\\% there",
    )
    page.settle("linear-error-rises", *rising)


def rises(page, delay, end):
    """The error rises along the arc while beta < 0, and is below 2 per cent there."""
    arc = linear.arc(delay)
    above, right = (expand(cancel(p / Y)) for p in (arc.above + linear.GAP * arc.size, arc.right))
    slope = diff(above, Y) * right - above * diff(right, Y)
    shift = right + Y * diff(right, Y) * arc.size
    page.show(
        f"The slope of the error, $d={delay}$",
        r"(d+\tfrac12)\,R^2\,\frac{d\varepsilon}{dy}",
        r"F'R-FR'+\frac g{y^2}\bigl(R+|M|^2yR'\bigr)",
        page.same(
            "slope",
            diff(arc.above, Y) * arc.right - arc.above * diff(arc.right, Y),
            Y**2 * slope + linear.GAP * shift,
        ),
    )
    box, on = {**RANGES, Y: (0, Rational(1, 10))}, rf"0\le y\le0.1,\ {INSIDE}"
    factor = r"1.7\," if delay else ""
    last, weight = Rational(end, 100), 1 + Rational(7, 10) * delay
    less = weight * arc.up - above + LEVEL * (delay + HALF) * right
    rows = [
        ("It rises", r"F'R-FR'", positive(slope, box, SHAPE), on, ""),
        ("Also by the gap", r"R+|M|^2yR'", positive(shift, box, SHAPE), on, ""),
        (
            "Beyond",
            r"|M|^2\beta",
            positive(arc.up, {**RANGES, Y: (Rational(1, 10), last)}, SHAPE),
            rf"0.1\le y\le{float(last):g},\ {INSIDE}",
            "up to the end of the arc",
        ),
        (
            "Where $\\beta\\le0$",
            factor + r"|M|^2\beta+0.02\,(d+\tfrac12)R-F",
            positive(less, box, SHAPE),
            on,
            "so that $\\varepsilon<2\\,\\%$ there",
        ),
    ]
    return [
        page.positive(title, fact, on, because, name) for title, name, fact, on, because in rows
    ]
