r"""How much of an arm's spring shows in the region without delay?

Figs. 7 and 8 of the paper draw the stable walls for $d=0$ at the limits of the arm's spring and
damping, $\gamma\le0.001$ and $\delta\le0.02$. The spring moves the left bound; we ask how far it
moves the rest.
"""

from sympy import Rational, S, cos, cosh, exp, expand, sinh, symbols

from symhaptic.book.figures.stability import origin, undelayed
from symhaptic.model import loop, plant
from symhaptic.model.parts import FULL
from symhaptic.model.passivity import on_circle
from symhaptic.notation import alpha, beta, c, delta, gamma, theta, z
from symhaptic.proof.box import positive


def derive(page):
    a, e, n_1, n_0, x = symbols("a e n_1 n_0 x")
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * x
    top = (2 * x - 1) * (a * n_0 - n_1) + a * n_1 - e * (n_1 + n_0) - n_0 * (4 * x**2 - 2 * x - 1)
    side = a * n_0 - (1 - e) * n_1 - 2 * n_0 * x
    polynomial = (z**2 - a * z + e) * z + (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    on_it = {alpha: top / size, beta: side / size}
    root = page.same(
        "a root at exp(j theta)", on_circle(polynomial.subs(on_it)).subs(x, cos(theta)), S.Zero
    )
    page.say(
        "For $d=0$ the explicit boundary is a pair of rational functions of $x=\\cos\\theta$. The "
        "inequalities below hold for all $0\\le\\gamma\\le0.001$, $0\\le\\delta\\le0.02$."
    )
    page.show("Stiffness", alpha, on_it[alpha], root)
    page.show("Damping", beta, on_it[beta], root)
    sigma, r, q, h = symbols("sigma_0 r q h")
    numbers(page)

    def curve(gam, fall, turn):
        total, part = sigma * (1 - fall * gam), S.Half + q * delta + turn * gam
        plant_ = {n_1: total * part, n_0: total * (1 - part), e: 1 - delta * sigma}
        plant_[a] = 1 + plant_[e] - gam * total
        return [expand(form.subs(plant_)) for form in (top, side, size)]

    box = {
        gamma: (S.Zero, Rational(1, 1000)),
        delta: (S.Zero, Rational(1, 50)),
        sigma: (Rational(99, 100), S.One),
        r: (Rational(8, 100), Rational(9, 100)),
        q: (Rational(8, 100), Rational(9, 100)),
        h: (-Rational(1, 1000), Rational(1, 1000)),
    }
    there, before = curve(gamma, r, h), curve(S.Zero, S.Zero, S.Zero)
    arc, left = {**box, x: (-Rational(1, 50), S.One)}, {**box, x: (-Rational(1, 50),) * 2}
    facts = [
        page.positive(
            "The upper end",
            positive(-gamma * there[2] - there[0], left),
            "x=-0.02",
            because="there the curve has left the region, for all $\\gamma$ and $\\delta$ of (23)",
            name=r"-\gamma-\alpha",
        )
    ]
    for i, name in ((0, r"\alpha"), (1, r"\beta")):
        shift = expand((there[i] * before[2] - before[i] * there[2]) / gamma)
        shift /= there[2] * before[2]
        facts.append(
            page.positive(
                f"The move of ${name}$ at a fixed angle",
                positive(Rational(121, 100) - shift**2, arc),
                r"-0.02\le x\le1",
                name=rf"1.1\,\gamma-\bigl|{name}-{name}_{{\gamma=0}}\bigr|",
            )
        )
    page.say(
        "No point of the drawn arc moves by more than $0.0011$ in either direction; the region is "
        "$0.69$ wide and $2$ high: less than a fifth of a per cent of the width, half of the "
        "line's thickness in print."
    )
    page.figure(
        "fig7",
        "Fig. 7 of the paper: stable walls for $d=0$ at the limits of the parameter range. The "
        "curves for $\\gamma=0$ and $\\gamma=0.001$ lie on each other.",
        undelayed,
    )
    page.settle("fig7", *facts, note="the spring moves the curve by less than 0.0011")
    page.settle("s4d-gamma-invisible", *facts, note="less than $1.1\\gamma$ in each coordinate")
    low = symbols("y")
    line = expand((there[1] - there[0] / 2 + delta * there[2]).subs(x, 1 - low))
    whole = there[2].subs(x, 1 - low)
    close = {**box, low: (S.Zero, Rational(3, 1000))}
    page.say(
        "Around the origin take the distance from the line $\\beta=\\alpha/2-\\delta$, the linear "
        "condition (25), on the arc up to $x=0.997$:"
    )
    near = page.positive(
        "The bottom boundary is a line",
        positive(whole**2 / 10**8 - line**2, close),
        r"0.997\le x\le1",
        name=r"0.0001-|\beta-\alpha/2+\delta|",
    )
    page.say(
        "All bottom boundaries of one $\\delta$ are parts of one line, to within a third of a per "
        "cent of the height of Fig. 8. The spring makes that line longer: the corner at its left "
        "end moves along it to $\\alpha=-\\gamma$, and so about $\\gamma/2$ down."
    )
    page.figure(
        "fig8",
        "Fig. 8 of the paper: close-up of Fig. 7 with five stiffnesses. Left bounds at "
        "$\\alpha=-\\gamma$, one bottom line for each $\\delta$.",
        origin,
    )
    bound = page.same(
        "a root at 1",
        loop.characteristic(FULL, split=c)
        .subs({z: 1, alpha: -gamma})
        .subs(gamma, (delta**2 - c**2) / 4),
        S.Zero,
    )
    page.settle("fig8", bound, near, note="the corner moves along the line")


def numbers(page):
    """The plant's numbers over the range, from the mean value theorem."""
    given = {gamma: (delta**2 - c**2) / 4}
    device = plant.sampled(plant.normalised(FULL), split=c)
    total, rest = device.n1 + device.n0, device.n1 - device.n0
    page.step(
        "Sum of the plant's numerator",
        (total * gamma).xreplace(given),
        2 * exp(-delta / 2) * (cosh(delta / 2) - cosh(c / 2)),
        name=r"\gamma(n_1+n_0)",
    )
    page.step(
        "Difference",
        (rest * gamma).xreplace(given),
        2 * exp(-delta / 2) * (sinh(delta / 2) - delta * sinh(c / 2) / c),
        name=r"\gamma(n_1-n_0)",
        because="and $1-a+e=\\gamma(n_1+n_0)$",
    )
    page.say(
        "With $C(v)=\\cosh\\sqrt v$ and $S(v)=\\sinh(\\sqrt v)/\\sqrt v$ these are "
        "$2e^{-\\delta/2}$ times the rise of $C$, and $\\delta e^{-\\delta/2}$ times that of $S$, "
        "from $v=\\delta^2/4-\\gamma$ to $\\delta^2/4$. Both ends lie between $-0.001$ and "
        "$0.0001$, where by their power series $C'=\\tfrac12+\\tfrac v{12}+\\ldots$, "
        "$C''=\\tfrac1{12}+\\tfrac v{120}+\\ldots$ and "
        "$S'/C'=\\tfrac13-\\tfrac v{45}+\\ldots$ The mean value theorem gives "
        "$n_1+n_0=\\sigma_0(1-r\\gamma)$ with $0.08<r<0.09$ and, for the ratio of the two rises, "
        "$n_1/(n_1+n_0)=\\tfrac12+q\\delta+h\\gamma$ with $0.08<q<0.09$ and $|h|<0.001$. Without a "
        "spring, $\\sigma_0=(1-e)/\\delta$ is between $0.99$ and $1$."
    )
