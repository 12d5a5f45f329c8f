r"""May the stiffness of a stable wall always be lowered?

For a soft contact the paper lowers the virtual stiffness down to zero and expects no loss of
stability. We keep the virtual damping and ask for which walls this is so.
"""

from sympy import Rational, S, cos

from symhaptic.model import loop, passivity
from symhaptic.notation import B, K, alpha, b, beta, d, delta, gamma, theta, y


def derive(page):
    margin = passivity.margin()
    page.say("For passive walls it is true. The margin of (5) is linear in the stiffness:")
    softer = page.step(
        "A share $y$ of the stiffness",
        margin.subs(K, y * K),
        y * margin + (1 - y) * (b + B * cos((d + 1) * theta)),
        name="F(yK,B)",
    )
    without = page.step(
        "Without stiffness",
        b + B * cos((d + 1) * theta),
        (b + B) * (1 + cos((d + 1) * theta)) / 2 + (b - B) * (1 - cos((d + 1) * theta)) / 2,
        name="F(0,B)",
        because="not negative, since a passive wall has $-b\\le B\\le b$",
    )
    kept = page.same("softer", softer, margin.subs(K, y * K))
    ends = page.same("ends", without, margin.subs(K, 0))
    page.say(
        "So with $0\\le y\\le1$ the softer wall is passive too, and by the chapter on passive "
        "walls stable, for $\\delta>0$ and whole delays as long as $\\alpha+\\gamma>0$. (Without "
        "any stiffness, $\\alpha=\\gamma=0$, a root lies at 1: nothing holds the mass.)"
    )
    polynomial, numbers = loop.named(), loop.numbers()
    page.say(
        "For other walls it is false. The virtual damping alone may be too much for the delay, "
        "and the stiffness was what kept it stable. Inside (23) that takes long delays. For "
        "$\\gamma=0.001$, $\\delta=0.02$, $\\beta=0.0252$ and $d=150$:"
    )
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50), beta: Rational("0.0252"), d: S(150)}
    page.inside("$\\alpha=0.0002$", polynomial, {**arm, alpha: Rational(1, 5000)}, numbers)
    soft = {**arm, alpha: S.Zero}
    witness = page.outside("No stiffness", polynomial, soft, numbers)
    page.say(
        "With stiff springs, as in Fig. 13, two periods are enough: $\\gamma=3$, $\\delta=0.02$, "
        "$\\beta=0.47$ and $d=2$."
    )
    spring = {gamma: S(3), delta: Rational(1, 50), beta: Rational("0.47"), d: S(2)}
    page.inside("$\\alpha=0.3$", polynomial, {**spring, alpha: Rational(3, 10)}, numbers)
    page.outside("No stiffness, stiff spring", polynomial, {**spring, alpha: S.Zero}, numbers)
    page.settle(
        "s5b-soft-contacts",
        kept,
        ends,
        provided=r"\delta>0,\ d\in\mathbb{N}_0,\ \alpha+\gamma>0\ \text{and a passive wall}",
        unless=soft,
        truth=witness,
        shows=r"$\beta=0.0252$ and 150 periods of delay: stable with $\alpha=0.0002$, not with 0",
        note="without delay it need not be passive (next chapter); inside (23) no such wall was "
        "found for delays up to 75 periods",
    )
