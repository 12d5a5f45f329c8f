r"""Is the linear condition ever exact without arm and damping?

For a free mass the line of (25) is the tangent of the boundary at its start, the origin. We ask on
which side of it the stable walls lie, for every delay.
"""

from sympy import Rational, S, cos, diff, pi, sin

from symhaptic.model import boundary, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import d, theta
from symhaptic.proof import sign

HALF = Rational(1, 2)
LATE = (d + 1) * theta


def derive(page):
    stiffness, damping = boundary.wall(plant.sampled(plant.normalised(Parts(False, False))))
    surplus = sin((d + HALF) * theta) - (2 * d + 1) * sin(theta / 2) * cos(LATE)
    page.step(
        "The boundary beside the line",
        (damping - (d + HALF) * stiffness) * cos(theta / 2) ** 2,
        2 * sin(theta / 2) * surplus,
        name=r"\cos^2\tfrac\theta2\;(\beta-(d+\tfrac12)\alpha)",
    )
    first, steps = sign.assume(pi / 2 - LATE), sign.assume(d, strict=False)
    size = sign.combined(d + 1, [1], [steps])
    arc = sign.Interval(theta, S.Zero, (first, size))
    up = arc.above
    turned = sign.sine(
        sign.combined(LATE, [size, up]), sign.combined(pi - LATE, [first], [sign.number(pi / 2)])
    )
    less = sign.combined(pi / 2 - theta, [first], [steps, up])
    half = sign.sine(
        sign.combined(theta / 2, [HALF, up]),
        sign.combined(pi - theta / 2, [HALF, less], [sign.number(3 * pi / 4)]),
    )
    share = sign.combined(d + HALF, [steps], [HALF])
    grows = sign.combined(
        diff(surplus, theta), [share, half, turned], [2, share, size, half, turned]
    )
    fact = page.positive(
        "On the first arc",
        sign.integrated(surplus, arc, grows),
        r"0<(d+1)\theta<\tfrac\pi2,\ d\ge0",
    )
    page.say(
        "The stable walls of a free mass with a whole delay are those between the two ends of the "
        "first arc at their $\\alpha>0$. The lower end lies above the line, so no wall on the line "
        "is stable, and all stable walls satisfy (25): it is necessary, but no part of its border "
        "is safe. With damping part of it is (next chapters)."
    )
    page.state(
        "linear-free-mass",
        "for $\\gamma=\\delta=0$ and whole $d$ every stable wall satisfies (25), and no wall "
        "on its border is stable",
    )
    page.settle("linear-free-mass", fact)
