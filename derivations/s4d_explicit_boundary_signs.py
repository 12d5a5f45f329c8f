r"""Which signs have the numbers of an arm?

At the start of the boundary an arm enters by $\nu$, $s_1$, $s_2$ and by the gap
$g=s_1-\delta-\frac12\gamma$ between that start and the line of (25). We ask for
their signs, for every arm that swings by less than half a turn in a period,
$\gamma-\frac14\delta^2<\pi^2$: the limit (30) of the paper.
"""

from sympy import S, cosh, diff, exp, sinh, sqrt

from symhaptic.book.lemmas.arm_numbers import ARM, pushed, signs
from symhaptic.model import linear, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import a, c, delta, e, gamma, n_0, n_1, s_1, s_2, t, x, z
from symhaptic.proof.theorems.kernel import weakened
from symhaptic.proof.theorems.tactics import every, example, for_all


def derive(page):
    given = {gamma: (delta**2 - c**2) / 4}
    device = plant.sampled(plant.normalised(FULL), split=c)
    total, fall = device.n1 + device.n0, exp(-delta / 2)
    page.say(
        "Write $C(x)=\\cosh\\sqrt x$ and $S(x)=\\sinh(\\sqrt x)/\\sqrt x$, entire functions, and "
        "take them between $q=\\frac14\\delta^2-\\gamma=\\frac14c^2$ and $p=\\frac14\\delta^2$, "
        "that is $-\\pi^2<q\\le p$."
    )
    roots(page)
    high, low = delta / 2, c / 2
    slope_ = sinh(high) / high - sinh(low) / low
    page.show(
        "The sum is a rise of $C$",
        r"\gamma(n_1+n_0)",
        r"2e^{-\delta/2}\,(C(p)-C(q))",
        page.same("sum", (total * gamma).xreplace(given), 2 * fall * (cosh(high) - cosh(low))),
        because="positive for $\\gamma>0$, as $C$ rises with the slope $\\frac12S$",
    )
    page.show(
        "The difference is a rise of $S$",
        r"\gamma(n_1-n_0)",
        r"\delta e^{-\delta/2}\,(S(p)-S(q))",
        page.same(
            "difference", ((device.n1 - device.n0) * gamma).xreplace(given), delta * fall * slope_
        ),
        because="positive for $\\gamma\\delta>0$: $\\nu=n_0/(n_1+n_0)$ is less than $\\frac12$",
    )
    swing = exp(-delta * t / 2) * sinh(c * t / 2) / (c / 2)
    pushed = plant.normalised(FULL).held(t, c)[0]
    page.show(
        "The first sample is a mean of the force",
        r"n_1",
        r"\int_0^1e^{-\delta t/2}\,t\,S(qt^2)\,dt",
        page.same("first", diff(pushed, t), swing),
        because="positive, as $S$ is",
    )
    second = page.same("second", device.n0, exp(-delta) * device.n1.subs(delta, -delta))
    page.show(
        "The second one is that of the time reversed",
        "n_0",
        r"e^{-\delta}\,n_1\big|_{-\delta}",
        second,
        because="positive for the same reason: $0<\\nu\\le\\frac12$",
    )
    mass(page)
    waves = (linear.numbers(device)[s_1] - delta - gamma / 2) * total
    trapezium = gamma / 2 * (sinh(high) / high + sinh(low) / low) - 2 * (cosh(high) - cosh(low))
    rule = page.same(
        "gap", waves.xreplace(given), (delta * fall / gamma * trapezium).xreplace(given)
    )
    page.show(
        "The gap compares a mean of $S$ with a rise of $C$",
        r"(n_1+n_0)\Bigl(s_1-\delta-\frac\gamma2\Bigr)",
        r"\frac{\delta e^{-\delta/2}}{\gamma}\Bigl(\gamma\,\frac{S(p)+S(q)}2-2(C(p)-C(q))\Bigr)",
        rule,
    )
    page.say(
        "As $2(C(p)-C(q))=\\int_q^pS$ and $p-q=\\gamma$, the bracket is the error of the trapezium "
        "rule for $S$, $\\frac1{12}\\gamma^3S''$ at a point between: positive, as $S$ is convex. "
        "So $g\\ge0$, and $g>0$ for $\\gamma\\delta>0$. Without a spring $\\nu$, $s_1=\\delta$ and "
        "$s_2=1$ are the limits, with $g=0$."
    )
    _settled(page)


def _settled(page):
    page.lemma(
        "A device that swings by less than half a turn goes forwards under a force held",
        pushed()[1],
        because="a blow moves it forwards for all of the period",
    )
    numbers, (device, *arms) = (n_1, n_0, a, e), ARM
    found = for_all(numbers, [device], signs())
    page.state(
        "arm-numbers",
        "for $\\gamma-\\frac14\\delta^2<\\pi^2$: $0<\\nu\\le\\frac12$, $s_2>0$ and "
        "$s_1\\ge\\delta+\\frac12\\gamma$, which is $>$ for $\\gamma\\delta>0$",
        claim=every((gamma, delta), arms, found.conclusion),
    )
    page.settle(
        "arm-numbers",
        for_all((gamma, delta), arms, weakened(found, *arms)),
        example=example({gamma: S.One, delta: S.One}, arms),
        note="the start of the boundary is below the line by $\\gamma^2$ times a positive mean",
    )


def roots(page):
    """S and its derivatives."""
    page.step(
        "$C$ has the slope",
        diff(cosh(sqrt(x)), x),
        sinh(sqrt(x)) / sqrt(x) / 2,
        name="C'(x)",
        because="half of $S(x)$",
    )
    page.show(
        "$S$ is a mean of $C$",
        "S(x)",
        r"\int_0^1C(xt^2)\,dt",
        page.same("mean", diff(sinh(sqrt(x) * t) / sqrt(x), t), cosh(sqrt(x) * t)),
        because="therefore $S'(x)=\\frac12\\int_0^1t^2S(xt^2)\\,dt$ and "
        "$S''(x)=\\frac12\\int_0^1t^4S'(xt^2)\\,dt$",
    )
    page.say(
        "$S(x)>0$ for $x>-\\pi^2$, where it is $\\sin\\sqrt{-x}/\\sqrt{-x}$ or more than 1, so "
        "$S'$ and $S''$ are positive there too: $S$ is positive, rising and convex."
    )


def mass(page):
    """s_2 by the denominator at the zero of the numerator."""
    arm = plant.Sampled(n_1, n_0, 1 + e - gamma * (n_1 + n_0), e)
    value = arm.denominator.subs(z, -n_0 / n_1)
    found = linear.numbers(arm)
    page.show(
        "The number $s_2$ is positive",
        s_2,
        r"\frac{n_1^2\,A(-n_0/n_1)}{(n_1+n_0)^3}",
        page.same("s_2", found[s_2], n_1**2 * value / (n_1 + n_0) ** 3),
        because="positive: the roots of $A$ are not real, or positive",
    )
    page.step(
        "The number $s_1$ is a sum over a positive number",
        found[s_1],
        (1 - e + gamma * n_0) / (n_1 + n_0),
        name=s_1,
    )
