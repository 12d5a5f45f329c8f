r"""How many numbers does the characteristic polynomial need, and what is its degree?

The polynomial of the loop was derived in units of the mass and the period. We derive it once more
in physical units, and count its powers of $z$.
"""

from sympy import Ne, S, exp, symbols

from symhaptic.model import loop, plant, wall
from symhaptic.model.plant import Plant, sampled
from symhaptic.notation import B, K, T, alpha, b, beta, c_1, c_2, c_3, d, delta, gamma, k, m, z
from symhaptic.scene import FULL


def derive(page):
    page.say(
        "In physical units the sampled device has the state $e^{AT}$ and the wall is $H(z)z^{-d}$. "
        "The rules of Table I are put in afterwards, and both mass and period drop out:"
    )
    device = sampled(Plant(), T, split=c_1 / T)
    polynomial = device.denominator * z ** (d + 1)
    polynomial += device.numerator * (wall.delayed() * z ** (d + 1))
    rules = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T}
    stiffness = {k: m * (delta**2 - c_1**2) / (4 * T**2)}
    given = {gamma: (delta**2 - c_1**2) / 4}
    physical = polynomial.xreplace(rules | stiffness).xreplace(rules)
    dimensionless = loop.characteristic(split=c_1)
    a, e, n_1, n_0 = symbols("a e n_1 n_0")
    page.show(
        "Two derivations, one polynomial",
        "p_1(z)",
        (z**2 - a * z + e) * z ** (d + 1) + (n_1 * z + n_0) * ((alpha + beta) * z - beta),
        page.same("both derivations", physical, dimensionless.xreplace(given)),
        because="$a$, $e$, $n_1$ and $n_0$ depend on $\\gamma$ and $\\delta$ only",
    )
    page.settle(
        "s4b-five-parameters",
        page.free_of("the polynomial", physical, m, T),
        page.same("both derivations", physical, dimensionless.xreplace(given)),
    )
    unit = plant.sampled(plant.normalised(FULL), split=c_1)
    one, two = plant.normalised(FULL).poles(c_1)
    given |= {c_2: exp(two), c_3: exp(one)}
    scale = -2 * c_1 * gamma
    rest = page.same(
        "what is left is quadratic",
        (scale * (dimensionless - unit.denominator * z ** (d + 1))).xreplace(given),
        (scale * unit.numerator * ((alpha + beta) * z - beta)).xreplace(given),
    )
    page.say(
        "With $A(z)=z^2-az+e$, the part $A(z)z^{d+1}$ has degree $d+3$ and all that is left has "
        "degree 2. In the paper's scaling the leading coefficient is $-2c_1\\gamma$: the degree is "
        "$d+3$ if that is not zero and $d$ is a whole number. The monic form always has it."
    )
    page.settle(
        "s4d-degree",
        rest,
        provided=r"c_1\gamma\ne0\ \text{and}\ d\in\mathbb{N}_0",
        unless={gamma: S.Zero, delta: S.One, c_1: S.One},
        truth=Ne(scale, 0, evaluate=False),
        shows="the leading coefficient vanishes for an ungrabbed device",
    )
