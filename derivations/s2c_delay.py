r"""What does a delay do to the loop, and must it be a whole number of periods?

Delays arise when the position is read, when the force is computed and when the motor answers.
We ask whether only their sum matters, and whether a delay that is no multiple of the sampling
period can be treated like one that is.
"""

from sympy import Eq, Rational, S

from symhaptic.model.plant import normalised, sampled
from symhaptic.notation import d, d_1, d_2, function, z
from symhaptic.scene import Parts


def derive(page):
    P, H = function("P")(z), function("H")(z)
    page.say(
        "Let $P(z)$ be the sampled device. The wall sees the position $d_1$ periods late and its "
        "force reaches the device another $d_2$ periods late."
    )
    loop = P / (1 + P * z ** (-d_2) * H * z ** (-d_1))
    page.step(
        "Two delays, one loop",
        loop,
        P / (1 + P * H * z ** (-(d_1 + d_2))),
        because="powers of $z$ commute with everything in a linear loop and add their exponents",
    )
    page.say(
        "Delays between hold and sampler commute with the device itself, so this holds for every "
        "real delay there. The denominator, and with it the characteristic polynomial, knows the "
        "sum only. A delay "
        "on the way of the external force would enter the numerator alone."
    )
    page.settle(
        "s2c-delays-lump",
        page.same(
            "denominators", 1 + P * z ** (-d_2) * H * z ** (-d_1), 1 + P * H * z ** (-(d_1 + d_2))
        ),
    )
    page.say(
        "Now the free mass, $\\gamma=\\delta=0$, in units of $m$ and $T$. A unit force is held for "
        "one period but arrives $d<1$ periods late; where is the mass when it is sampled next?"
    )
    free = normalised(Parts(stiffness=False, damping=False))
    late = page.step(
        "The first sample after a late force",
        free.held(1 - d)[0],
        (1 - d) ** 2 / 2,
        name="x_1",
        because="the force has acted for the time $1-d$ only",
    )
    undelayed = sampled(free)
    page.step(
        "Without delay",
        late.subs(d, 0),
        undelayed.n1,
        name="x_1|_{d=0}",
        because="a delay of whole periods shifts the samples and changes none of them",
    )
    page.say(
        "Writing $z^{-d}$ in front of $P(z)$, and replacing $z$ by a power of a finer variable, "
        "places the whole response between the samples: at the next sample it predicts no motion "
        "at all. For $d=\\tfrac12$ the mass has in truth moved by $\\tfrac18$. The substitution is "
        "therefore exact for whole delays. For the others $P(\\zeta^q)$ is not even the device "
        "sampled $q$ times as often: it is $q$ copies of the slow device, coupled by the delay."
    )
    general = normalised(Parts())
    page.settle(
        "s2c-rational-delay",
        page.same("whole delays are exact", sampled(general).n1, general.held(S.One)[0]),
        provided=r"d\in\mathbb{N}_0",
        unless={d: Rational(1, 2)},
        truth=Eq(late, 0),
        shows=r"$x_1=\tfrac18$ with the delayed force, 0 by the substitution",
        note="the paper calls the substitution an approximation; the exact form for fractional "
        "delays is the modified z-transform",
    )
