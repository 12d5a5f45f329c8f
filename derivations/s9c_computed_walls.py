r"""Are the computed walls that are just passive the derived ones?

The envelope of the passive walls, the stiffest of them and the linear condition are quotients whose
denominators vanish with the angle. They are computed as quotients of functions that do not.
"""

from symhaptic.book.lemmas.computed import settle, upright
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stable_walls import LATE_STIFFEST, LINEAR, STIFFEST, TOUCHED, WORST
from symhaptic.forms.entire import Chord, Sinc, SinNext, Spread

UNITS = {K: alpha, B: beta, T: S.One, b: delta}
UNDEFINED = "wherever nothing in either is divided by zero"


def derive(page):
    stiffness, damping = (side.xreplace(UNITS) for side in passivity.envelope())
    page.say(
        "The wall that is just passive is a point of the envelope, where the lines of two angles "
        "meet. Its denominator and its numerators vanish with the third power of the angle; "
        "divided by it they are Spread, Chord and a product:"
    )
    push = (d + 1) * Sinc(theta / 2) ** 2 * SinNext(d, theta) / theta
    quotients = 2 * delta * push / Spread(d, theta), delta * Chord(d, theta) / Spread(d, theta)
    for of in Sinc(psi), SinNext(d, theta), Spread(d, theta), Chord(d, theta):
        title = f"The function {type(of).__name__} has the closed form"
        page.define(title, upright(of), of.definition(*of.args))
    page.step(
        "Its stiffness is a quotient without a pole at 0",
        stiffness,
        upright(quotients[0]),
        name=alpha,
    )
    page.step(
        "Its damping is a quotient without a pole at 0",
        damping,
        upright(quotients[1]) - alpha / 2,
        name=beta,
    )
    settle(
        page,
        "passivity_boundary",
        (TOUCHED,),
        "behind whole delays the computed wall that is just passive is the point of the envelope, "
        f"{UNDEFINED}; behind a fraction of a period it is searched for by the need and its slope",
    )
    page.say(
        "The stiffest of these walls has $\\theta=\\pi/(2(d+1))$, where $\\cos(d+1)\\theta$ "
        "vanishes. Its stiffness is a tangent, and its damping is a difference that stays large:"
    )
    page.step(
        "The damping of the stiffest passive wall has one function",
        damping.subs(theta, WORST),
        delta / ((d + 1) * sin(WORST)) - delta * tan(WORST / 2),
        name=r"\beta|_{\theta=\pi/(2(d+1))}",
    )
    page.say(
        "Behind a fraction of a period it is the wall of \\chapter{s6f_stiffest_passive_wall} with "
        "the least stiffness that an angle allows. Next to whole delays $1-S$, $C$ and "
        "$\\varepsilon(1-\\varepsilon)$ vanish together there, so that the wall is made of what "
        "does not: where the slope of the bound vanishes,"
    )
    settle(
        page,
        "max_passive_stiffness",
        (STIFFEST, LATE_STIFFEST),
        "behind whole delays the computed stiffest passive wall is the derived one, (11), with its "
        "damping; behind a fraction of a period the stiffest wall that an angle allows needs the "
        "whole damping there, no damping of its own lets it need less, and where the slope of its "
        "stiffness vanishes, which is searched for, the computed wall is this one",
    )
    need = passivity.margin().xreplace(UNITS)
    page.limit(
        "For slow motions the margin is linear in the wall",
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
        "the computed stiffness of the linear condition is the derived one, (25): with it the "
        "margin tends to 0 with the angle",
    )
