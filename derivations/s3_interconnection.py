r"""Is everything that is made of passive parts passive and stable?

Passivity is used because it survives when systems are connected. We ask which connections these
are, and what stability it is that follows.
"""

from sympy import I, S, symbols

from symhaptic.model.passivity import real_part
from symhaptic.model.plant import Plant
from symhaptic.notation import F, m, omega, s, t, v


def derive(page):
    page.say(
        "Let a system with the speed $v$ and the force $F$ never give back more than it took in: "
        "it stores at most the integral of $Fv$. Two systems are held against each other, so that "
        "the second one pushes back with $F_2$ on the first:"
    )
    pushed = symbols("F_2")
    face = page.step(
        "Two bodies face to face take in what comes from outside",
        (F - pushed) * v + pushed * v,
        F * v,
        because="what both take in is what comes from outside; with both stores added, the whole "
        "is passive",
    )
    kept = page.same("parallel and feedback", face, (F - pushed) * v + pushed * v)
    page.say(
        "This needs that the two share one quantity and exchange the other. A chain, in which the "
        "output of one system is the input of the next, does not. Take a lag, $1/(s+1)$, in units "
        "of its time:"
    )
    lag = 1 / (1 + I * omega)
    page.step(
        "One lag",
        real_part(lag),
        1 / (1 + omega**2),
        name=r"\Re\frac{1}{1+j\omega}",
        because="positive: the lag is passive",
    )
    chain = page.step(
        "Two lags in a chain",
        real_part(lag**2),
        (1 - omega**2) / (1 + omega**2) ** 2,
        name=r"\Re\frac{1}{(1+j\omega)^2}",
        because="negative for $\\omega>1$: the chain is not passive",
    )
    page.step(
        "Three lags and a gain of 27 in a loop",
        (s + 1) ** 3 + 27,
        (s + 4) * ((s - S.Half) ** 2 + S(27) / 4),
        because="the closed loop has poles at $\\frac12\\pm\\frac{3\\sqrt3}2j$ and grows like "
        "$e^{t/2}$, though gain and lags are passive, each on its own",
    )
    page.say("Nor is a passive system stable in the sense that it comes to rest:")
    page.step(
        "A free mass after a push",
        Plant(m, None, None).transition(t)[0, 1],
        t,
        name=r"x/v_0",
        because="it takes in energy only when pushed, and drifts for ever",
    )
    page.settle(
        "s3-interconnection",
        kept,
        provided=r"\text{parallel or feedback,}\ \text{and}\ \text{stability as bounded energy}",
        unless={omega: S(2)},
        truth=chain >= 0,
        shows=r"two lags in a chain are not passive",
        note="a passive mass may drift for ever",
    )
