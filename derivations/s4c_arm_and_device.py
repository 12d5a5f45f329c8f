r"""How much stiffness and damping does an arm add to the loop?

An arm adds mass as well as stiffness and damping, and $\gamma$ and $\delta$ depend on the total
mass. We derive bounds on $\gamma$ and $\delta$ from separate bounds on the arm and on the device.
"""

from symhaptic.book.lemmas.arm import PLAIN, WHOLE, bounds, limits, numbers, p, weighted
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.arm import ARM, GIVEN, y_D, y_H


def derive(page):
    together = Plant(m_D, b_D, None).characteristic + Plant(m_H, b_H, k_H).characteristic
    mass, damping, stiffness = Poly(together, s).all_coeffs()
    spring = page.step(
        r"In units of mass and period the stiffness is $\gamma$",
        stiffness * T**2 / mass,
        T**2 * k_H / (m_D + m_H),
        name=gamma,
        because="the forces of arm and device add up for the same motion, as in (2)",
        paper="19",
    )
    damper = page.step(
        r"In units of mass and period the damping is $\delta$",
        damping * T / mass,
        T * (b_D + b_H) / (m_D + m_H),
        name=delta,
        paper="19",
    )
    _numbers(page, Eq(gamma, spring), Eq(delta, damper))
    page.say(
        "If the mass of the device or of the arm is neglected, each ratio of stiffness or "
        "damping to mass is larger:"
    )
    page.step(
        r"Without the device's mass, the stiffness $\gamma$ is larger",
        T**2 * k_H / m_H - spring,
        T**2 * k_H * m_D / (m_H * (m_D + m_H)),
        name=r"T^2\frac{k_H}{m_H}-\gamma",
    )
    page.step(
        r"The sum of the separate damping ratios is larger than $\delta$",
        T * (b_D / m_D + b_H / m_H) - damper,
        T * (b_D * m_H**2 + b_H * m_D**2) / (m_D * m_H * (m_D + m_H)),
        name=r"T\Bigl(\frac{b_D}{m_D}+\frac{b_H}{m_H}\Bigr)-\delta",
        because="the difference is zero only without dampers; the difference for the stiffness is "
        "zero only without a spring",
    )
    _bounds(page)
    page.say(
        "The sum of the two damping ratios is an upper bound that is not sharp. The ratio of the "
        "total damping to the total mass is a mean of the two damping ratios, weighted by the "
        "masses:"
    )
    _mean(page)
    _limits(page)


def _numbers(page, *forms):
    """(19) follows from (2) and Table I."""
    page.settle("eq19", numbers(page.claim("eq19")), *forms, example=PLAIN | WHOLE)


def _bounds(page):
    """With positive masses and dampers, (20) also requires a spring."""
    claim = page.claim("eq20")
    then = taken_apart(claim)[2]
    springy = k_H > 0
    theorem = conj(*bounds(claim))
    limp = PLAIN | {k_H: S.Zero, gamma: S.Zero}
    there = then.at(limp)
    page.settle(
        "eq20",
        theorem,
        *STATEMENTS["eq20"].printed,
        example=PLAIN,
        unless={springy: (limp, not_all(there, fact(negated(there.of[0]))))},
        shows="for an arm without a spring, $k_H=0$, (20) says $0<0$",
        note=r"the published formula assumes positive masses and dampers, and a spring; with $\le$ "
        "the formula holds for every arm, and (22) admits $k_H=0$",
    )


MEAN = (
    r"\frac{\delta}{T} = \frac{m_D}{m_D + m_H} \cdot \frac{b_D}{m_D} "
    r"+ \frac{m_H}{m_D + m_H} \cdot \frac{b_H}{m_H}"
)


def _mean(page):
    """With the device's share p of the mass, delta = T (p x + (1 - p) y), a mean of x and y."""
    parts = {p: m_D / (m_D + m_H), x: b_D / m_D, y: b_H / m_H}
    known = map(proposition, STATEMENTS["eq19"].printed)
    given = [*GIVEN, *known, *(Relation(name, "=", of) for name, of in parts.items())]
    wanted = both([*read(MEAN), Eq(delta, T * (p * x + (1 - p) * y)), p > 0, p < 1])
    claim = every((*ARM, gamma, delta, *parts), given, wanted)
    page.state(
        "arm-mean-ratio",
        r"$\delta/T$ is the mean of $b_D/m_D$ and $b_H/m_H$, weighted by the masses",
        MEAN,
        claim=claim,
    )
    ones = dict.fromkeys((x, y), S.One) | {p: S.Half}
    page.settle(
        "arm-mean-ratio",
        for_all((*ARM, gamma, delta, *parts), given, add_assum(weighted(claim), *given)),
        example=PLAIN | ones,
        note=r"therefore $\delta/T$ is at most the larger of the two ratios",
    )


def _limits(page):
    """Limits of stiffness and damping per mass for arm and device are limits for both together."""
    found = page.lemma(
        "Separate limits for the arm and for the device are sufficient",
        conj(*limits(page.claim("s4c-independent-limits"))),
    )
    page.settle(
        "s4c-independent-limits", found, example=PLAIN | dict.fromkeys((x, y, y_D, y_H), S.One)
    )
