r"""Where is the ratio of passive to stable stiffness largest?

Here is at which delay $\eta$ is largest, by how much it stays below one, and what it tends to, for
$\delta=0.02$ and a device without a spring.
"""

from sympy import Rational, S, cos, pi, sin, symbols, tan

from symhaptic.bounds.walls import STIFFNESS, most, numbers, over, passive
from symhaptic.notation import a, delta, e, h, kappa, n_0, n_1, phi, t
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.enclosed import given, value
from symhaptic.proof.roots import zero

ETA = {n: symbols(f"eta_{n}") for n in (*range(119, 126), 1000)}
WITH = symbols("eta_40")


def derive(page):
    known = {ETA[n]: eta(S.Zero, n) for n in ETA} | {WITH: eta(STIFF, 40)}
    page.enclosed(
        "The ratios beside both peaks are enclosed",
        [
            *((rf"\eta({n})|_{{\gamma=0}}", known[ETA[n]]) for n in (121, 122, 123)),
            (r"\eta(40)|_{\gamma=0.001}", known[WITH]),
        ],
        because="by the maximum of the explicit function, as before",
    )
    page.say("No other whole delay comes as close to one; 119 to 125 are enclosed like these.")
    for n in ETA:
        if n != 122:
            box.positive(ETA[122] - ETA[n], {}, Known(given(known)))
    without_spring(page, known)
    limit(page)


def eta(stiffness, delay):
    """Largest passive over largest stable stiffness."""
    return over(passive(DAMPED, delay), most(stiffness, DAMPED, delay))


def without_spring(page, known):
    """gamma = 0: angles that are nearly the best, given by the angle itself."""
    peak = ETA[122]
    page.say(
        "In slow motion the curve is $\\alpha=\\theta^2\\cos\\varphi"
        "+\\delta\\theta\\sin\\varphi$ with $\\varphi=(d+1)\\theta$: a mass and a damper. For a "
        "given $\\varphi$ it is stiffest, to first order, at the delay $d+1=1/u$ with"
    )
    slow = (h * phi) ** 2 * cos(phi) + delta * h * phi * sin(phi)
    far = delta * (sin(phi) + phi * cos(phi)) / (phi**2 * sin(phi) - 2 * phi * cos(phi))
    page.step(
        "At the delay $1/u-1$ the wall is stiffest",
        slow.diff(phi).subs(h, far),
        S.Zero,
        name=r"\frac{\partial\alpha}{\partial\varphi}",
    )
    page.define("The delay $d=1/u-1$ belongs to the angle $\\varphi$", "u", far)
    far, balls = far.subs(delta, DAMPED), Known(given(known) | numbers(S.Zero, DAMPED))
    above = STIFFNESS.subs(t, tan(far * phi / 2)) * peak - 2 * DAMPED * tan(pi * far / 4)
    ends = [Rational(v, 10**4) for v in (10925, 15622, 15778, 19400)]
    name = r"\alpha\,\eta(122)-2\delta\tan\tfrac{\pi u}4"
    for text, low, high in (("1 to 118", *ends[:2]), ("126 to 1000", *ends[2:])):
        fact = box.positive(above, {phi: (low, high)}, balls)
        on = rf"{low.n(5)}\le\varphi\le{high.n(5)}"
        page.positive(
            f"For delays of {text} periods $\\eta$ is less than $\\eta(122)$", fact, on, name=name
        )
    delays = [value(1 / far - 1, {phi: end}) for end in ends]
    names = [rf"d\big|_{{\varphi={end.n(5)}}}" for end in ends]
    page.enclosed(
        "These stretches of $\\varphi$ cover the delays between their ends",
        list(zip(names, delays, strict=True)),
        places=4,
    )
    page.say(
        "For longer delays take $\\varphi=2$, so that $\\tan\\frac\\theta2=u\\kappa$ with "
        "$1\\le\\kappa\\le1.000001$, as $\\tan(x)/x$ rises. Without a spring $\\alpha$ "
        "has the factor $u$:"
    )
    free = STIFFNESS.subs(a, 1 + e).subs({t: h * kappa, phi: 2})
    along, across = (
        (n_1 + n_0) * one + (n_1 - n_0) * h * kappa * other
        for one, other in ((cos(S(2)), sin(S(2))), (sin(S(2)), -cos(S(2))))
    )
    tail = 2 * kappa * ((1 + e) * h * kappa * along + (1 - e) * across)
    tail /= (n_1 + n_0) ** 2 + ((n_1 - n_0) * h * kappa) ** 2
    page.same("over u", free / h, tail)
    region = {h: (S.Zero, Rational(1, 1001)), kappa: (S.One, 1 + Rational(1, 10**6))}
    page.positive(
        "For all longer delays it is less, too, by the wall at $\\varphi=2$",
        box.positive(tail * peak - DAMPED * pi * kappa / 2, region, balls),
        r"0\le u\le\tfrac1{1001}",
        name=r"\bigl(\alpha\,\eta(122)-2\delta\tan\tfrac{\pi u}4\bigr)/u",
    )


def limit(page):
    """Without a spring the ratio tends to 0.863."""
    angle = zero(sin(phi) + phi * cos(phi), phi, S(2), Rational(21, 10))
    high = value(phi * sin(phi), {phi: angle})
    page.enclosed(
        "What it tends to without a spring",
        [
            (r"\varphi_\infty", angle),
            (r"\varphi_\infty\sin\varphi_\infty", high),
            (r"\eta(\infty)", over(pi / 2, high)),
        ],
        because="the largest of $\\varphi\\sin\\varphi$, by the limit of the curve in the first "
        "chapter; with a spring $\\eta$ falls like $1/d$, as the passive stiffness does",
    )
