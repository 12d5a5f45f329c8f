r"""How much virtual damping can be passive, and where does the boundary end?

The highest and the lowest point of the passive walls are those without stiffness. We ask which
frequency decides there, and whether the boundary really ends at $K=0$.
"""

from sympy import Eq, Rational, S, cos, pi

from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, omega, theta
from symhaptic.proof.sign import assume, combined, cosine


def derive(page):
    need = passivity.dirichlet_form()
    top = page.step(
        "At $\\theta=\\pi/(d+1)$",
        need.subs(theta, pi / (d + 1)),
        K * T / 2 + B,
        name=r"\left.\text{need}\right|_{\theta=\pi/(d+1)}",
        because="the kernel is $\\tfrac12$ and the cosine $-1$ there, for every real $d$",
    )
    stiffness, damping = (e.subs(theta, pi / (d + 1)) for e in passivity.envelope())
    page.step("The envelope there, stiffness", stiffness, S.Zero, name=r"K|_{\theta=\pi/(d+1)}")
    page.step("The envelope there, damping", damping, b, name=r"B|_{\theta=\pi/(d+1)}")
    bottom = page.limit(
        "The line of low frequencies",
        passivity.margin(),
        theta,
        S.Zero,
        b - K * T * (d + Rational(1, 2)) + B,
        name="F",
    )
    page.step(
        "It meets $K=0$ at $B=-b$", bottom.subs({K: 0, B: -b}), S.Zero, name=r"F|_{K=0,\,B=-b}"
    )
    page.say(
        "For $K\\ge0$ the first line gives $B\\le b-KT/2\\le b$, so the damping is largest at "
        "$(0,b)$; the low frequencies give $B\\ge KT(d+\\tfrac12)-b\\ge-b$. But (5) goes on to "
        "negative stiffness, where its walls are not passive: there the printed boundaries do not "
        "end at these points, and larger damping satisfies (5)."
    )
    beyond = {K: -S.One, T: S.One, b: S.One, B: Rational(5, 4), d: S.Zero}
    half = cosine(assume(theta / 2), assume(pi / 2 - theta / 2))
    holds = combined(
        passivity.margin().subs(beyond), [Rational(1, 4)], [Rational(5, 2), half, half]
    )
    page.settle(
        "s3c-limit-points",
        Eq(K, stiffness),
        Eq(B, damping),
        Eq(K, S.Zero, evaluate=False),
        Eq(B, -b),
        provided=r"d\in\mathbb{N}_0,\ K\ge0",
        unless=beyond,
        truth=holds,
        shows=r"$d=0$, $K=-1$, $B=\tfrac54b$ satisfies (5) at every frequency",
    )
    page.say(
        "The frequency $\\omega=\\pi/(T(d+1))$ lies inside the open interval for $d>0$ only. "
        "Without delay it is the Nyquist frequency itself, and the value is a limit. (The slash "
        "in $\\pi/T(d+1)$ has to be read as dividing by the whole product.)"
    )
    page.step(
        "The first angle where the cosine is $-1$",
        cos((d + 1) * (pi / (d + 1))),
        -S.One,
        name=r"\cos(d+1)\theta",
    )
    page.settle(
        "s3c-bmax-frequency",
        Eq(omega, pi / (d + 1) / T),
        b > top,
        provided=r"d\in\mathbb{N},\ K\ge0",
        unless={d: S.Zero, T: S.One, omega: pi, b: S(2), K: S.One, B: S.One},
        truth=omega < pi / T,
        shows=r"for $d=0$ the frequency is $\omega_N$, outside $0<\omega<\omega_N$",
    )
