r"""How large may a virtual mass be?

A virtual mass is a force $m_v(x_k-2x_{k-1}+x_{k-2})/T^2$, proportional to the acceleration that is
computed from three samples. Which virtual masses are passive, alone or together with a spring and a
damper, and which are stable?
"""

from sympy import Eq, I, Rational, S, cos, exp

from symhaptic.book.lemmas.decided import in_z
from symhaptic.book.lemmas.virtual_mass import (
    BOUND,
    MARGIN,
    alone,
    by_angle,
    decides,
    free,
    gives_energy,
    swings_up,
)
from symhaptic.loops.velocity import DIFFERENCE
from symhaptic.model import plant
from symhaptic.model.parts import Parts
from symhaptic.notation import B, K, T, b, d, m, m_v, theta, z

ALONE, BESIDE, FREE = "rules:virtual-mass", "rules:virtual-wall", "rules:virtual-mass-stable"
STILL = {K: S.Zero, B: S.Zero, m_v: S.One / 4, b: S.Half, T: S.One}


def derive(page):
    difference = in_z(DIFFERENCE)
    wall = page.define(
        "Spring, damper and virtual mass",
        r"H(z)",
        K + B / T * difference + m_v / T**2 * difference**2,
    )
    lag = (wall / (z - 1)).subs(z, exp(I * theta))
    page.step(
        "A wall with a virtual mass requires this damping of the device at each angle",
        -T * (lag + lag.subs(I, -I)) / 2,
        b - MARGIN.right,
        name=r"b_{\min}(\theta)",
        because=r"by the balance of energy the required damping is $-T\,\Re\{H/(z-1)\}$ at "
        r"$z=e^{j\theta}$",
    )
    page.lemma(
        "A wall with a virtual mass is passive if and only if its stiffness is not negative and "
        "the device dissipates enough at each angle",
        by_angle(),
    )
    page.step(
        "The margin is smallest at the Nyquist frequency",
        MARGIN.right - (b - BOUND.left),
        (1 + cos(theta)) * (B + m_v / T * (3 - 2 * cos(theta))),
        because=r"the right side is not negative for $B\ge0$ and $m_v\ge0$, and tends to 0 for "
        r"$\theta\to\pi$",
    )
    found = page.lemma(
        "A wall with a virtual mass is passive if and only if the damping of the device is at "
        "least the sum that spring, damper and virtual mass require",
        decides(),
        boxed=True,
    )
    page.settle(
        BESIDE,
        found,
        example=STILL,
        note="the bound is exact without delay, including walls on the bound",
    )
    _alone(page)
    _free(page)


def _alone(page):
    """Settle the limit of a virtual mass without spring and damper."""
    found = page.lemma(
        "A virtual mass without spring and damper is passive if and only if $m_v\\le bT/2$", alone()
    )
    none = [Eq(K, 0), Eq(B, 0)]
    stiff, damped = STILL | {K: S.One}, STILL | {B: S.One}
    page.settle(
        ALONE,
        found,
        example=STILL,
        unless={none[0]: (stiff, gives_energy(stiff)), none[1]: (damped, gives_energy(damped))},
        shows=r"for $b=\tfrac12$, $T=1$ the virtual mass $m_v=\tfrac14$ requires all of the "
        "damping, so none remains for a spring",
        note="the bound is exact for a virtual mass alone; a spring and a damper require "
        "additional damping",
    )


def _free(page):
    """Settle the stability of a free mass with a virtual mass."""
    mass = plant.sampled(plant.normalised(Parts(False, False)))
    mu = m_v / m
    response = mass.numerator / mass.denominator * mu * (1 - 1 / z) ** 2
    page.step(
        "The denominator $(z-1)^2$ of a free mass cancels against the virtual mass",
        z ** (d + 2) * (1 + response * z**-d),
        z ** (d + 2) + mu / 2 * (z + 1),
        name="p_M(z)",
        because="the polynomial $p_M(z)$ is the loop's polynomial divided by $(z-1)^2$. This "
        "factor belongs to a motion at constant speed, which a virtual mass does not change",
    )
    found = page.lemma(
        "Without delay a virtual mass is stable if and only if it is smaller than $2m$", free()
    )
    slow = {m_v: Rational(3, 2), m: S.One, d: S.One}
    page.settle(
        FREE,
        found,
        example=slow | {d: S.Zero},
        unless={Eq(d, 0): (slow, swings_up(slow))},
        shows=r"the virtual mass $m_v=\tfrac32m$ is unstable with a delay of one period",
        note="the limit is exact for a free mass without delay",
    )
