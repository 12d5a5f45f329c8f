r"""Can too much virtual damping make a wall unstable?

A physical damper only takes energy. The virtual one acts on the mean speed of the last period
and is held for the next. We look for a bound that no stable wall can exceed.
"""

from sympy import Rational, S

from symhaptic.model import loop
from symhaptic.notation import alpha, beta, d, delta, gamma, n_0, z


def derive(page):
    polynomial = loop.named()
    last = polynomial - (z ** (d + 1)) * polynomial.coeff(z ** (d + 1))
    product = page.step(
        "The constant coefficient",
        last.subs(z, 0),
        -beta * n_0,
        name="p_1(0)",
        because="the rest of the polynomial has the factor $z^{d+1}$, for every whole $d$",
    )
    page.say(
        "The polynomial is monic, so that, up to the sign, this is the product of its roots. If "
        "all lie inside the unit circle, $|n_0\\beta|<1$, whatever $\\alpha$, $\\gamma$, $\\delta$ "
        "and the delay are. A free mass has $n_0=\\tfrac12$ and $|\\beta|<2$, that is "
        "$|B|<2m/T$."
    )
    bound = page.same("product of roots", product, -n_0 * beta)
    page.say(
        "For the largest spring and damper of (23), $\\gamma=0.001$ and $\\delta=0.02$, and the "
        "stiffness $\\alpha=0.05$:"
    )
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50), alpha: Rational(1, 20)}
    numbers, found = loop.numbers(), []
    for delay, low, high in ((0, "1.9", "2.1"), (1, "0.7", "0.9")):
        for text, side in ((low, page.inside), (high, page.outside)):
            wall = {**arm, d: S(delay), beta: Rational(text)}
            title = f"$d={delay}$, $\\beta={text}$"
            found.append(side(title, polynomial, wall, numbers))
    page.say(
        "With a delay less damping is too much. By the first line no virtual stiffness can make up "
        "for it."
    )
    page.settle("s4d-too-much-damping", bound, *found, note="$|n_0\\beta|<1$ for every delay")
