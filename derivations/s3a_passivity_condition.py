r"""When is a delayed virtual wall passive?

A wall of stiffness $K$ and damping $B$, rendered with period $T$ and a delay of $d$ periods, is
coupled to a device whose only loss is its damping $b$. We ask for which $(K,B)$ no motion of
the device can extract energy.
"""

from sympy import Abs, Rational, S, cos, pi, sin

from symhaptic.model import passivity, wall
from symhaptic.notation import B, K, T, b, d, m, omega, theta
from symhaptic.proof.sign import assume, combined, cosine


def derive(page):
    response = page.define("The wall, $d$ periods late", r"H(z)\,z^{-d}", wall.delayed())
    need = passivity.required_damping(response)
    brackets = (
        K * T * (cos(d * theta) - cos((d + 1) * theta))
        + B * (cos(d * theta) - 2 * cos((d + 1) * theta) + cos((d + 2) * theta))
    ) / (2 - 2 * cos(theta))
    page.step(
        "Real part",
        need,
        brackets,
        paper="5",
        name=r"\frac{T}{2}\,\frac{\Re\{(1-e^{-j\theta})H(e^{j\theta})e^{-jd\theta}\}}"
        r"{1-\cos\theta}",
        because="the wall put into the energy balance, with $z=e^{j\\theta}$, $\\theta=\\omega T$",
    )
    page.step(
        "Sums to products, the stiffness",
        cos(d * theta) - cos((d + 1) * theta),
        2 * sin(theta / 2) * sin((d + Rational(1, 2)) * theta),
    )
    page.step(
        "Sums to products, the damping",
        cos(d * theta) - 2 * cos((d + 1) * theta) + cos((d + 2) * theta),
        -(2 - 2 * cos(theta)) * cos((d + 1) * theta),
        because="both brackets contain the denominator once written through half angles",
    )
    page.result(
        r"As an identity, for every real $d$ and every $0<\theta<\pi$",
        b > passivity.dirichlet_form(),
        equal_to=b > need,
        because="the Dirichlet kernel of order $d$ against a single cosine; the mass has dropped "
        "out",
    )
    page.say(
        "A delay that is no whole number of periods does not act as $z^{-d}$ on the samples. With "
        "half a period of delay, let the device move by $\\tfrac32$ in the first half of each "
        "period, "
        "where the force is still the one before, and by 1 in the second; after 30 periods it goes "
        "back in the same way."
    )
    late = passivity.half_late_energy(Rational(3, 2), S.One, 30)
    page.step(
        "Energy left to damper and wall",
        late,
        390 * b / T + 345 * B / T - 1605 * K / 4,
        name="E",
        because="for $K=T=1$, $B=0$ and $b=\\tfrac{101}{100}$ it is $-\\tfrac{147}{20}$, although "
        "(5) reads $b>\\cos\\frac{\\theta}{2}$ there and holds",
    )
    page.settle(
        "eq5",
        b > brackets.subs(theta, omega * T),
        provided=r"d\in\mathbb{N}_0,\ K\ge0",
        unless={
            d: S.Half,
            K: S.One,
            T: S.One,
            B: S.Zero,
            b: Rational(101, 100),
            omega: S.One,
        },
        truth=late >= 0,
        shows=r"half a period late, (5) holds at every frequency, yet a motion extracts $147/20$",
        note="right as a rewriting of (4) with $z^{-d}$ for every real $d$; for a fractional delay "
        "of the held force it allows walls that are not passive, and forbids some that are",
    )
    page.say(
        "The mass is not in (5). That it takes nothing on the whole is seen where it still is: a "
        "motion at the frequency $\\omega$ gives $\\Re\\{(ms^2+bs)/s\\}$ per squared velocity "
        "to the device, with $s=j\\omega$, which is the same for any two masses."
    )
    balance = passivity.balance()
    page.settle(
        "s3a-mass-free",
        page.free_of("the energy balance", balance, m),
        page.same("the condition", balance, b - need),
    )

    page.say("Without delay the kernel is a constant, and one cosine is left.")
    undelayed = page.step(
        "No delay",
        passivity.dirichlet_form().subs(d, 0),
        K * T / 2 - B * cos(theta),
        name=r"\left.\text{need}\right|_{d=0}",
        because="the kernel of order 0 is $\\tfrac12$",
    )
    page.step(
        "Distance to the border, $B\\ge0$",
        K * T / 2 + B - undelayed,
        2 * B * cos(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}+B-\text{need}",
        because="tends to 0 for $\\theta\\to\\pi$ and is positive before",
    )
    page.step(
        "Distance to the border, $B\\le0$",
        K * T / 2 - B - undelayed,
        -2 * B * sin(theta / 2) ** 2,
        name=r"\tfrac{KT}{2}-B-\text{need}",
        because="tends to 0 for $\\theta\\to0$ and is positive after",
    )
    page.say(
        "So $KT/2+|B|$ is the least upper bound over the open interval, and for $B\\ne0$ it is "
        "not attained: a wall with $b$ exactly there still satisfies (5) at every frequency. The "
        "strict sign of (6) excludes it; with $\\ge$ in place of $>$ both would agree. And a "
        "negative $K$ satisfies either one without being passive."
    )
    border = {K: S.One, T: S.One, B: S.One, b: S(3) / 2}
    half = cosine(assume(theta / 2), assume(pi / 2 - theta / 2))
    holds = combined((b - undelayed).subs(border), [2, half, half])
    agreement = r"B=0\ \text{or}\ b\ne KT/2+|B|"
    page.settle(
        "s3a-undelayed",
        b > undelayed.subs(theta, omega * T),
        provided=agreement,
        unless=border | {omega: S.One},
        truth=b > K * T / 2 + Abs(B),
        shows=r"(5) holds at every frequency, (6) says $\tfrac32>\tfrac32$",
        note="the form for $d=0$ is right for all values; its summary (6) needs the condition",
    )
    page.settle(
        "eq6",
        b > K * T / 2 + Abs(B),
        provided=rf"K\ge0,\ {agreement}",
        unless=border,
        truth=holds,
        shows=r"(5) reads $1+\cos\theta>0$ and holds, (6) says $\tfrac32>\tfrac32$",
    )
