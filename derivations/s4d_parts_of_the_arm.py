r"""Do the mass, the spring and the damper of an arm all stabilise the wall?

The paper concludes that each of them enlarges the stable region. A single wall that is stable
without the part and unstable with it is enough to deny this. Roots are isolated by certified
balls, the coefficients being exact expressions.
"""

from sympy import Rational, S

from symhaptic.model import loop
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.scene import Parts


def derive(page):
    p, full = loop.named(), loop.numbers()
    mass_only, damped = loop.numbers(Parts(False, False)), loop.numbers(Parts(stiffness=False))
    page.say(
        "\\emph{The spring.} No delay, no damping, $\\alpha=\\tfrac{269}{400}$ and "
        "$\\beta=\\tfrac{97}{100}$. With a free mass the wall is stable:"
    )
    wall = {alpha: Rational(269, 400), beta: Rational(97, 100), d: S.Zero}
    page.inside("Without a spring", p, wall, mass_only)
    page.say(
        "The stiffest spring that (23) gives to an arm, $\\gamma=0.001$, makes it unstable. The "
        "right end of the region moves to the left by about half of $\\gamma$, while the left "
        "bound moves by $\\gamma$."
    )
    sprung = {**wall, gamma: Rational(1, 1000), delta: S.Zero}
    witness = page.outside("With the spring", p, sprung, full)
    page.say(
        "\\emph{The mass.} With everything else unchanged, $\\alpha$, $\\beta$ and $\\delta$ are "
        "inversely proportional to $m$. One period of delay, $\\delta=0.02$, "
        "$\\alpha=\\tfrac9{800}$, $\\beta=-\\tfrac{13}{4000}$ and no spring:"
    )
    light = {
        alpha: Rational(9, 800),
        beta: Rational(-13, 4000),
        delta: Rational(1, 50),
        d: S.One,
    }
    page.inside("With the mass $m$", p, light, damped)
    heavy = {symbol: value if symbol == d else value / 2 for symbol, value in light.items()}
    page.outside("With twice the mass", p, heavy, damped)
    page.say(
        "With more mass a wall comes closer to the line of the linear condition (25), which lies "
        "inside the exact region at this place. For the damper see the chapter on "
        "damping."
    )
    page.settle(
        "s4d-all-stabilising",
        page.same("the mass scales", light[alpha] / 2, heavy[alpha]),
        corrected=(r"\text{no spring destabilises a passive wall (chapter s5a)}",),
        misprint=False,
        unless=sprung,
        truth=witness,
        shows="a wall that is stable with a free mass and unstable with a spring inside (23)",
        note="doubling the mass destabilises a wall at $d=1$; more damping can do so outside (23)",
    )
