"""Are the computed walls on the passivity boundary equal to the derived ones?

The formulas for the envelope of the passive walls, for the passive wall of maximum stiffness and
for the linear condition are quotients whose denominators vanish with the angle. The program uses
quotients of functions that do not vanish at the angle 0.
"""

from symhaptic.book.lemmas.computed import settle, upright
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_walls import LATE_STIFFEST, LINEAR, STIFFEST, TOUCHED, WORST
from symhaptic.forms.entire import Chord, Sinc, SinNext, Spread

UNITS = {K: alpha, B: beta, T: S.One, b: delta}
UNDEFINED = "if neither form divides by zero"


def derive(page):
    stiffness, damping = (side.xreplace(UNITS) for side in passivity.envelope())
    page.say(
        "A wall on the passivity boundary is a point of the envelope. The denominator and the "
        "numerators of the point vanish with the third power of the angle. Divided by this power "
        "they are Spread, Chord and a product:"
    )
    push = (d + 1) * Sinc(theta / 2) ** 2 * SinNext(d, theta) / theta
    quotients = 2 * delta * push / Spread(d, theta), delta * Chord(d, theta) / Spread(d, theta)
    for of in Sinc(psi), SinNext(d, theta), Spread(d, theta), Chord(d, theta):
        title = f"The function {type(of).__name__} has the closed form"
        page.define(title, upright(of), of.definition(*of.args))
    page.step(
        "The stiffness of the wall is a quotient without a pole at 0",
        stiffness,
        upright(quotients[0]),
        name=alpha,
    )
    page.step(
        "The damping of the wall is a quotient without a pole at 0",
        damping,
        upright(quotients[1]) - alpha / 2,
        name=beta,
    )
    settle(
        page,
        "passivity_boundary",
        (TOUCHED,),
        "with integer delays the computed wall on the passivity boundary is the point of the "
        f"envelope, {UNDEFINED}; with a fractional delay a search finds the wall with the required "
        "damping and its slope",
    )
    page.say(
        r"The stiffest wall on the boundary has the angle $\theta=\pi/(2(d+1))$, at which "
        r"$\cos(d+1)\theta$ vanishes. The stiffness of this wall is a multiple of a tangent "
        "function. Its damping is a difference without cancellation:"
    )
    page.step(
        "The passive wall of maximum stiffness has a damping without a pole",
        damping.subs(theta, WORST),
        delta / ((d + 1) * sin(WORST)) - delta * tan(WORST / 2),
        name=r"\beta|_{\theta=\pi/(2(d+1))}",
    )
    page.say(
        "With a fractional delay each angle bounds the stiffness "
        r"(\chapter{s6f_stiffest_passive_wall}), and the wall with the smallest of these bounds "
        r"is computed. Near integer delays $1-S$, $C$ and $\varepsilon(1-\varepsilon)$ vanish "
        "together at this wall. The program therefore uses quantities that do not vanish. A "
        "search finds the angle with the smallest bound, at which the slope of the bound "
        "vanishes."
    )
    settle(
        page,
        "max_passive_stiffness",
        (STIFFEST, LATE_STIFFEST),
        "with integer delays the computed passive wall of maximum stiffness is (11), with its "
        "damping; with a fractional delay the computed wall of an angle requires exactly the "
        "damping of the device at this angle, for every virtual damping. A search finds the angle "
        "at which the slope of the stiffness vanishes, and the computed wall at this angle is the "
        "stiffest wall of the angle",
    )
    need = passivity.margin().xreplace(UNITS)
    page.limit(
        r"For $\theta\to0$ the margin is linear in the wall",
        need,
        theta,
        S.Zero,
        delta + beta - alpha * (d + Rational(1, 2)),
        name=r"\bigl(\delta-\delta_\mathrm{min}\bigr)",
    )
    settle(
        page,
        "linear_limit",
        (LINEAR,),
        "the computed stiffness of the linear condition is the derived one, (25): with this "
        "stiffness the margin tends to 0 with the angle",
    )
