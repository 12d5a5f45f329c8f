r"""How much spring and damping does an arm bring into the loop?

A hand that holds the device adds its mass to it as well, so that neither its stiffness nor its
damping counts alone. We look for bounds of $\gamma$ and $\delta$ that ask for the arm and for the
device separately.
"""

from sympy import Eq, Poly, S, symbols

from symhaptic.model.plant import Plant
from symhaptic.notation import T, b_D, b_H, delta, gamma, k_H, m_D, m_H, s
from symhaptic.proof.sign import assume, combined, quotient


def derive(page):
    both = Plant(m_D, b_D, None).characteristic + Plant(m_H, b_H, k_H).characteristic
    mass, damping, stiffness = Poly(both, s).all_coeffs()
    spring = page.step(
        "The spring in units of mass and period",
        stiffness * T**2 / mass,
        T**2 * k_H / (m_D + m_H),
        name=gamma,
        because="the forces that arm and device need for the same motion add up, as in (2)",
        paper="19",
    )
    damper = page.step(
        "The damper", damping * T / mass, T * (b_D + b_H) / (m_D + m_H), name=delta, paper="19"
    )
    held = {gamma: spring, delta: damper}
    page.settle("eq19", Eq(gamma, spring), Eq(delta, damper))

    page.say("Leaving the other's mass out enlarges each part. By how much?")
    masses = [assume(m_D), assume(m_H)]
    dampers = [assume(b_D), assume(b_H)]
    period, pull = assume(T), assume(k_H)
    total = combined(m_D + m_H, *([part] for part in masses))
    softer = page.positive(
        "The spring alone",
        quotient(
            T**2 * k_H / m_H - spring,
            combined(T**2 * k_H * m_D, [period, period, pull, masses[0]]),
            combined(m_H * (m_D + m_H), [masses[1], total]),
        ),
        on=r"m_D,m_H,k_H,T>0",
        name=r"T^2\frac{k_H}{m_H}-\gamma",
        because="it is $T^2k_Hm_D/(m_H(m_D+m_H))$, and zero for $k_H=0$",
    )
    apart = T * (b_D / m_D + b_H / m_H) - damper
    more = combined(
        T * (b_D * m_H**2 + b_H * m_D**2),
        [period, dampers[0], masses[1], masses[1]],
        [period, dampers[1], masses[0], masses[0]],
    )
    braked = page.positive(
        "Both dampers",
        quotient(apart, more, combined(m_D * m_H * (m_D + m_H), [*masses, total])),
        on=r"m_D,m_H,b_D,b_H,T>0",
        name=r"T\Bigl(\frac{b_D}{m_D}+\frac{b_H}{m_H}\Bigr)-\delta",
        because="it is $T(b_Dm_H^2+b_Hm_D^2)/(m_Dm_H(m_D+m_H))$",
    )
    limp = {T: S.One, m_D: S.One, m_H: S.One, b_D: S.One, b_H: S.One, k_H: S.Zero}
    page.settle(
        "eq20",
        softer.relation,
        braked.relation,
        given=held,
        provided="k_H>0",
        unless=limp | {gamma: S.Zero, delta: S.One},
        truth=(Eq(gamma, spring), Eq(delta, damper)),
        shows=r"an arm that does not pull, $k_H=0$: (20) says $0<0$",
        note=r"with $\le$ it holds for every arm; (22) admits $k_H=0$",
    )
    page.say(
        "The sum of both ratios is more than needed. With the masses as weights, the damping of "
        "the whole is a mean of the two:"
    )
    mean = b_D / m_D * m_D / (m_D + m_H) + b_H / m_H * m_H / (m_D + m_H)
    page.show(
        "A mean of two ratios",
        r"\frac{\delta}{T}",
        r"\frac{m_D}{m_D+m_H}\cdot\frac{b_D}{m_D}+\frac{m_H}{m_D+m_H}\cdot\frac{b_H}{m_H}",
        page.same("the mean", damper / T, mean),
    )
    page.state(
        "arm-mean-ratio",
        r"$\delta/T$ is the mean of $b_D/m_D$ and $b_H/m_H$, weighted by the masses",
        r"\delta = T \cdot \left( \frac{m_D}{m_D + m_H} \cdot \frac{b_D}{m_D} "
        r"+ \frac{m_H}{m_D + m_H} \cdot \frac{b_H}{m_H} \right)",
    )
    page.settle("arm-mean-ratio", Eq(delta, T * mean), note="so it is at most the larger of them")
    q, x = symbols("q x")
    below = [assume(q * part - value, False) for part, value in ((m_D, b_D), (m_H, b_H))]
    calm = page.positive(
        "At most the larger one",
        quotient(
            q - damper / T,
            combined(q * (m_D + m_H) - b_D - b_H, *([part] for part in below)),
            total,
        ),
        on=r"b_D\le qm_D,\ b_H\le qm_H",
        name=r"q-\frac{\delta}{T}",
    )
    limit = assume(x * m_H - k_H, False)
    firm = page.positive(
        "And the spring",
        quotient(
            x - spring / T**2,
            combined(x * (m_D + m_H) - k_H, [limit], [assume(x), masses[0]]),
            total,
        ),
        on=r"k_H\le xm_H,\ x>0",
        name=r"x-\frac{\gamma}{T^2}",
        because="so limits for the arm and for the device, each on its own, are enough, and they "
        "hold for $k_H=0$ too",
    )
    page.settle("s4c-independent-limits", firm, calm)
