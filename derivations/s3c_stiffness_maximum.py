r"""What is the largest stiffness that can be passive?

It is the rightmost point of the boundary. There a change of the damping must not help, so its
coefficient in the condition vanishes; that fixes the frequency, and everything else follows.
"""

from sympy import Eq, Rational, S, cos, diff, pi, sin, solve, sqrt, tan

from symhaptic.model import passivity
from symhaptic.notation import B, K, T, b, d, omega, theta


def derive(page):
    need = passivity.dirichlet_form()
    page.step(
        "The coefficient of the damping",
        diff(need, B),
        -cos((d + 1) * theta),
        name=r"\partial\,\text{need}/\partial B",
    )
    angle = pi / (2 * (d + 1))
    page.step(
        "It vanishes first at",
        cos((d + 1) * angle),
        S.Zero,
        name=r"\cos(d+1)\theta\,|_{\theta=\pi/(2(d+1))}",
        because="later zeros lie beyond $\\pi/(d+1)$ and cut off nothing",
    )
    page.settle(
        "s3c-kmax-frequency",
        Eq(omega, angle / T),
        note="for $d=0$ every frequency gives this point, which is then a corner; the slash has "
        "to be read as dividing by the whole product",
    )
    largest = solve(b - need.subs(theta, angle), K)[0]
    stiffness = page.step(
        "The largest stiffness",
        largest,
        2 * b / T * tan(pi / (4 * (d + 1))),
        name=K,
        because="the damping has dropped out of the condition",
        boxed=True,
        paper="11",
    )
    on_curve = [e.subs(theta, angle) for e in passivity.envelope()]
    page.step(
        "It lies on the envelope", on_curve[0] - stiffness, S.Zero, name=r"K\big|_{\text{(7)}}-K"
    )
    damping = page.step(
        "Its damping",
        on_curve[1],
        b * (cos(angle) - d / (d + 1)) / sin(angle),
        name=B,
        paper="11",
        because="and by the chapter before, the stiffness of the envelope rises up to this "
        "frequency and falls after it, for every real $d>0$",
    )
    late = passivity.half_late_energy(Rational(17, 10), S.One, 30)
    at_half = {d: S.Half, T: S.One, b: S.One}
    page.settle(
        "eq11",
        Eq(K, stiffness),
        Eq(B, damping),
        provided=r"d\in\mathbb{N}_0",
        unless=at_half | {K: stiffness.subs(at_half), B: damping.subs(at_half)},
        truth=late >= 0,
        shows=r"half a period late, this wall gives energy away in 60 periods",
        note="the largest stiffness that satisfies (5), for every real $d$",
    )
    page.say("Relative to the undelayed wall, whose largest stiffness is $2b/T$:")
    ratio = stiffness / stiffness.subs(d, 0)
    one = page.step(
        "One period of delay", ratio.subs(d, 1), sqrt(2) - 1, name=r"K_{\max}(1)/K_{\max}(0)"
    )
    two = page.step(
        "Two periods of delay", ratio.subs(d, 2), 2 - sqrt(3), name=r"K_{\max}(2)/K_{\max}(0)"
    )
    page.settle("s3c-kmax-41", value=one)
    page.settle("s3c-kmax-27", value=two)
