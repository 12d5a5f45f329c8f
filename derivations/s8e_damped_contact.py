"""Is a wall stable if its stiffness is below $2B/T-B^2T/(2m)$?

Simulation code uses this rule for the spring and the damper of a contact, without delay. For a free
mass we derive the exact limit and compare the rule with it.
"""

from symhaptic.book.lemmas.circulation import damped_contact, free_mass, outside
from symhaptic.book.lemmas.prelude import *

RULE = "rules:damped-contact"
RIGHT = r"K < \frac{2B(2m-BT)}{T(2m+BT)}"
WALL = {K: S.One, B: S.One, T: S.One, m: S.One, b: S.Zero, k: S.Zero, d: S.Zero}


def derive(page):
    [right] = read(RIGHT)
    page.lemma(
        "Without delay a wall of a free mass is stable if four inequalities hold", free_mass()
    )
    found = page.lemma(
        "A free mass is stable below a stiffness that depends on the virtual damping",
        damped_contact(right),
        because="the last inequality is this limit, and the other inequalities follow from it",
        boxed=True,
    )
    page.say(
        "As published, the rule subtracts a damping, $B^2T/(2m)$, from a stiffness, so the "
        "result depends on the unit of time. Even with $B^2/(2m)$, which has the unit of a "
        "stiffness, the rule allows unstable walls:"
    )
    page.step(
        "With consistent units the rule allows too much",
        2 * B / T - B**2 / (2 * m) - right.rhs,
        B**2 * (6 * m - B * T) / (2 * m * (2 * m + B * T)),
        because="the difference is positive for $BT<4m$; for larger $B$ the rule allows no "
        "stiffness",
    )
    driven = {alpha: S.One, beta: S.One, gamma: S.Zero, delta: S.Zero, d: S.Zero}
    page.lemma(
        "For $m=T=1$ the loop with the wall $K=B=1$ has a root outside the circle", outside(driven)
    )
    page.settle(
        RULE,
        found,
        corrected=[RIGHT],
        misprint=False,
        example=WALL | {K: S.Half},
        unless=[(WALL, outside(driven))],
        shows=r"for $m=T=B=1$, the rule allows $K=1$, but the limit is $\tfrac23$",
    )
