"""How many parameters does the characteristic polynomial have, and what is its degree?

We derive the polynomial of the loop again in physical units, count its parameters and determine its
degree in $z$.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled_points import answered, completed
from symhaptic.book.lemmas.units import same_loop
from symhaptic.model import loop, wall
from symhaptic.model.plant import sampled
from symhaptic.notation import X_d
from symhaptic.paper.propositions.device import SECOND
from symhaptic.proof.theorems.roots import degree, not_of_degree


def derive(page):
    page.say(
        "In physical units the sampled device has the state matrix $e^{AT}$, and the wall is "
        "$H(z)z^{-d}$. We insert the rules of Table I afterwards, and the mass and the period "
        "cancel. The result is the monic polynomial $p_1$ of (18). Its coefficients $a$, $e$, "
        r"$n_1$ and $n_0$ depend on $\gamma$ and $\delta$ only."
    )
    device = sampled(Plant(), T, split=c_1 / T)
    polynomial = device.denominator * z ** (d + 1)
    polynomial += device.numerator * (wall.delayed() * z ** (d + 1))
    rules = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T}
    stiffness = {k: m * (delta**2 - c_1**2) / (4 * T**2)}
    given = {gamma: (delta**2 - c_1**2) / 4}
    physical = polynomial.xreplace(rules | stiffness).xreplace(rules)
    dimensionless = loop.characteristic(split=c_1)
    page.same("both derivations", physical, dimensionless.xreplace(given))
    _five(page)
    unit = plant.sampled(plant.normalised(FULL), split=c_1)
    one, two = plant.normalised(FULL).poles(c_1)
    given |= {c_2: exp(two), c_3: exp(one)}
    scale = -2 * c_1 * gamma
    page.same(
        "what is left is quadratic",
        (scale * (dimensionless - unit.denominator * z ** (d + 1))).xreplace(given),
        (scale * unit.numerator * ((alpha + beta) * z - beta)).xreplace(given),
    )
    page.say(
        "With $A(z)=z^2-az+e$, the term $A(z)z^{d+1}$ has degree $d+3$, and the other terms have "
        r"degree 2 at most. In the paper's scaling the leading coefficient is $-2c_1\gamma$. So "
        "the degree is $d+3$ if this coefficient is not zero and $d$ is an integer. The monic form "
        "has the degree $d+3$ for every device."
    )
    _degree(page)


def _five(page):
    """Two loops with the same five numbers are equal in their own units."""
    found = page.lemma(
        "Two loops with the same five numbers have the same product of device, delay and wall",
        same_loop(SECOND),
        because="each loop has the response of the loop with mass and period 1, and this response "
        "is unique",
    )
    numbers = {alpha: 1, beta: 0, gamma: pi**2, delta: 0, d: 0, z: 4}
    light = {m: 1, b: 0, k: pi**2, T: 1, K: 1, B: 0, t_d: 0}
    heavy = light | {m: 2, k: 2 * pi**2, K: 2}
    (one, first), (two, second) = (answered({**v, z: 4}) for v in (light, heavy))
    other = {SECOND[v]: value for v, value in heavy.items()}
    values = {v: S(value) for v, value in (light | other | numbers).items()} | {X: one, X_d: two}
    page.settle("s4b-five-parameters", found, example=(values, first, second))


def _degree(page):
    claim = page.claim("s4d-degree")
    found = taken_apart(claim)[2]
    split, spring, steps = Ne(c_1, 0), Ne(gamma, 0), whole(d)
    lead = positive(Ne(-2 * c_1 * gamma, 0), [2, split, spring])
    highest = degree(found.of[0], z, d + 3)
    more = [is_whole(d + n, assume(steps)) for n in (1, 2, 3)]

    def fails_at(point):
        values, _ = completed(claim, {alpha: 1, beta: 0, d: 0} | point)
        there = found.at(values)
        return values, not_of_degree(there.of[0], z, there.of[1])

    swing = {gamma: pi**2, delta: 0}
    values, _ = completed(claim, {alpha: 1, beta: 0, d: 0} | swing)
    page.settle(
        "s4d-degree",
        as_claimed(claim, closed(highest, lead, *more), split, spring, steps),
        example=values,
        unless={
            spring: fails_at({gamma: 0, delta: 1}),
            split: fails_at({gamma: 1, delta: 2}),
            steps: fails_at(swing | {d: S.Half}),
        },
        shows="the leading coefficient vanishes for a device without an arm",
    )
