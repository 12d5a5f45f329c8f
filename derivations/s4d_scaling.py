r"""Does twice the sampling rate give four times the stiffness?

The paper reads from Table I how the stable walls change with the period $T$ and the mass $m$, for
a constant delay factor $d$. What happens to the operator's $b$ and $k$ meanwhile? If they change
as well, the loop stays the same. If they are kept it does not, and a damped mass without spring
and delay, $\gamma=0$ and $d=0$, shows by how much. The theorems are in \chapter{s4d_scaling_kept}.
"""

from sympy import Rational

from symhaptic.model import boundary, loop, plant, wall
from symhaptic.model.parts import Parts
from symhaptic.notation import B, K, T, alpha, b, beta, c, d, delta, function, k, m, z
from symhaptic.proof import sign
from symhaptic.proof.enclosed import value

DAMPED = Parts(stiffness=False)
ARM = plant.sampled(plant.normalised(DAMPED))
LARGEST = boundary.largest_undelayed(ARM)
BEFORE, AFTER = Rational(1, 50), Rational(1, 100)
"""delta within (23), and with half the period or twice the mass but the same damper."""

STIFF = {alpha: Rational(713, 1000), beta: Rational(33, 40)}
BRAKED = {alpha: Rational(1, 1000), beta: Rational(101, 50)}


def derive(page):
    all_scaled(page)
    undelayed = loop.characteristic(DAMPED).subs({d: 0, delta: BEFORE})
    page.say("Now keep $b$. For $\\delta=\\frac1{50}$, the end of the range (23), two walls:")
    page.inside("$\\alpha=0.713$, $\\beta=0.825$ is stable", undelayed.subs(STIFF))
    page.inside("$\\alpha=0.001$, $\\beta=2.02$ is stable", undelayed.subs(BRAKED))
    page.enclosed(
        "For $\\delta=\\frac1{100}$ the largest damping and stiffness are enclosed",
        [
            (r"\alpha_{\max}", value(LARGEST, {delta: AFTER})),
            (r"1/n_0\big|_{\delta=0.01}", value(1 / ARM.n0, {delta: AFTER})),
        ],
        because="that is the same damper with half the period: no $\\beta$ makes the first wall's "
        "$\\alpha$, four times its stiffness, stable, and no $\\alpha$ the second wall's $\\beta$, "
        "twice its damping",
    )
    left = Rational(393, 100) * STIFF[alpha] - 4 * LARGEST.subs(delta, AFTER)
    page.positive(
        "So less than 3.93 times the stiffness is left",
        sign.number(left),
        r"\delta=\tfrac1{100}",
        name=r"3.93\cdot0.713-4\alpha_{\max}",
        because="twice the mass with the same damper is $\\delta=\\frac1{100}$ too",
    )


def all_scaled(page):
    """T to T/2 or m to 2m, and all else with it: the same roots."""
    device = plant.sampled(plant.Plant(), T, split=c)
    physical = device.denominator + device.numerator * wall.delayed()
    faster = {T: T / 2, K: 4 * K, B: 2 * B, b: 2 * b, k: 4 * k, c: 2 * c}
    heavier = {m: 2 * m, K: 2 * K, B: 2 * B, b: 2 * b, k: 2 * k}
    proofs = [
        page.same("the same loop", physical.xreplace(scaled), physical)
        for scaled in (faster, heavier)
    ]
    loop_before = function("p")(z)
    page.show(
        "Half the period changes nothing if all else is scaled with it",
        r"p(z)\big|_{T/2,\,4K,\,2B,\,2b,\,4k}",
        loop_before,
        proofs[0],
        because="with damper and spring changed too, or without them, the roots are the same",
    )
    page.show(
        "Twice the mass changes nothing if all else is doubled",
        r"p(z)\big|_{2m,\,2K,\,2B,\,2b,\,2k}",
        loop_before,
        proofs[1],
    )
