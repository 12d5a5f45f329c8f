r"""How stiff can the wall of a damped mass be without delay?

Without spring and delay, $\gamma=0$ and $d=0$, the loop is a cubic and its stability explicit. We
take the largest stiffness from it in closed form, and a bound of the damping.
"""

from sympy import Rational, S, exp, sqrt, symbols

from symhaptic.model import boundary, plant
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, delta, s, x, z
from symhaptic.proof import sign

E, N_1, N_0 = symbols("e n_1 n_0")
TOTAL, APART = N_1 + N_0, N_1 - N_0
ARM = plant.Sampled(N_1, N_0, 1 + E, E)
"""Any arm without a spring: a = 1 + e."""

B_0, B_1 = TOTAL * alpha, 2 * (1 - E) + APART * alpha + 2 * TOTAL * beta
B_2, B_3 = 4 - TOTAL * alpha - 4 * N_0 * beta, 2 * (1 + E) - APART * (alpha + 2 * beta)


def derive(page):
    polynomial = ARM.denominator * z + ARM.numerator * ((alpha + beta) * z - beta)
    page.step(
        "The unit disc turns into a half plane",
        (1 - s) ** 3 * polynomial.subs(z, (1 + s) / (1 - s)),
        B_3 * s**3 + B_2 * s**2 + B_1 * s + B_0,
        name=r"(1-s)^3p_1\bigl(\tfrac{1+s}{1-s}\bigr)",
        because="all roots are inside if and only if $b_0,b_1,b_2,b_3>0$, the coefficients of "
        "$1,s,s^2,s^3$, and $b_1b_2>b_0b_3$, by Routh's criterion",
    )
    arm(page)
    stiffness(page)
    damping(page, polynomial)


def arm(page):
    """n_1 > n_0 > 0 for a damped mass."""
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    up, fades = sign.Interval(delta, S.Zero), sign.exponential(-delta)
    rise = sign.combined(delta * exp(-delta), [up.above, fades])
    over = sign.integrated(1 - (1 + delta) * exp(-delta), up, rise)
    more = sign.integrated(delta - 2 + (2 + delta) * exp(-delta), up, over)
    square = sign.combined(delta**2, [up.above, up.above])
    page.positive(
        "For a damped mass $n_0$ is positive",
        sign.quotient(device.n0, over, square),
        r"\delta>0",
        name="n_0",
    )
    apart = sign.quotient(device.n1 - device.n0, more, square)
    page.positive("For a damped mass $n_1$ is the larger", apart, r"\delta>0", name="n_1-n_0")


def stiffness(page):
    """The largest stable alpha."""
    late = sign.assume(-beta - 1 / N_1, strict=False)
    n1, n0, e, stiff, wide, b2 = (sign.assume(f) for f in (N_1, N_0, E, alpha, APART, B_2))
    total = sign.combined(TOTAL, [n1], [n0])
    stuck = sign.combined(
        N_1 * (B_0 * B_3 - B_1 * B_2) / 2,
        [stiff, wide, wide, late, n1],
        [stiff, total, n1, e],
        [stiff, total, n0],
        [b2, total, late, n1],
        [b2, n0],
        [b2, e, n1],
    )
    page.positive(
        "No wall with $1+n_1\\beta\\le0$ is stable",
        stuck,
        r"1+n_1\beta\le0,\ \alpha>0,\ b_2>0",
        name=r"\tfrac12n_1(b_0b_3-b_1b_2)",
    )
    best = sqrt(N_0 * (N_0 + E * N_1))
    largest = boundary.largest_undelayed(ARM)
    page.show(
        "For the others, with $x=1+n_1\\beta>0$, the minor is a margin less a square",
        r"\tfrac18(b_1b_2-b_0b_3)",
        N_0 * x * (largest - alpha) - TOTAL * (N_0 * x - best) ** 2 / (N_0 * N_1**2),
        page.same(
            "margin",
            (B_1 * B_2 - B_0 * B_3) / 8,
            (N_0 * x * (largest - alpha) - TOTAL * (N_0 * x - best) ** 2 / (N_0 * N_1**2)).subs(
                x, 1 + N_1 * beta
            ),
        ),
        because="positive for no larger $\\alpha$ than",
    )
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    page.step(
        "The largest stiffness has a closed form",
        largest,
        (TOTAL - best) ** 2 / (N_0 * N_1**2),
        name=r"\alpha_{\max}",
        boxed=True,
        because="approached at $n_0x=\\sqrt{n_0(n_0+en_1)}$ as long as $b_1,b_2,b_3>0$ there",
    )
    page.step(
        "Without damping the largest stiffness is that of a free mass",
        boundary.largest_undelayed(free),
        12 - 8 * sqrt(2),
        name=r"\alpha_{\max}|_{\delta\to0}",
    )


def damping(page, polynomial):
    """A bound of beta."""
    page.step(
        "The product of the three roots is $n_0\\beta$",
        polynomial.subs(z, 0),
        -N_0 * beta,
        name="p_1(0)",
        because="so $|\\beta|<1/n_0$ for every stable wall",
    )
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    page.limit(
        "For small damping $1/n_0$ exceeds 2 by a share of",
        (1 / device.n0 - 2) / delta,
        delta,
        S.Zero,
        Rational(4, 3),
        name=r"\tfrac1\delta\bigl(\tfrac1{n_0}-2\bigr)",
        because="so in units $B<2m/T+\\frac43b+\\ldots$",
    )
