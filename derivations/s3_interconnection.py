r"""Is everything that is made of passive parts passive and stable?

Passivity is used because it survives when systems are connected. We ask which connections these
are, and what stability it is that follows.
"""

from symhaptic.book.lemmas.connections import (
    DAMPED_DEVICE,
    HELD,
    NO_CHAIN,
    connected_is_passive,
    fed_back,
    negative,
    parallel,
    passive_wall_is_stable,
    stays_on_circle,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import passive_in_numbers
from symhaptic.paper.propositions.systems import FREQUENCY, KIND, R_1, R_2, X_1, X_2


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
    page.same("parallel and feedback", face, (F - pushed) * v + pushed * v)
    page.say(
        "This needs that the two share one quantity and exchange the other. A chain, in which the "
        "output of one system is the input of the next, does not. Take a lag, $1/(s+1)$, in units "
        "of its time:"
    )
    lag = 1 / (1 + I * omega)
    page.step(
        "One lag is passive",
        real_part(lag),
        1 / (1 + omega**2),
        name=r"\Re\frac{1}{1+j\omega}",
        because="positive: the lag is passive",
    )
    page.step(
        "Two lags in a chain are not passive",
        real_part(lag**2),
        (1 - omega**2) / (1 + omega**2) ** 2,
        name=r"\Re\frac{1}{(1+j\omega)^2}",
        because="negative for $\\omega>1$: the chain is not passive",
    )
    page.step(
        "Three lags and a gain of 27 in a loop grow without end",
        (s + 1) ** 3 + 27,
        (s + 4) * ((s - S.Half) ** 2 + S(27) / 4),
        because="the closed loop has poles at $\\frac12\\pm\\frac{3\\sqrt3}2j$ and grows like "
        "$e^{t/2}$, though gain and lags are passive, each on its own",
    )
    page.say("Nor is a passive system stable in the sense that it comes to rest:")
    page.step(
        "A free mass drifts after a push",
        Plant(m, None, None).transition(t)[0, 1],
        t,
        name=r"x/v_0",
        because="it takes in energy only when pushed, and drifts for ever",
    )
    page.say(
        "Of two linear systems let $Z_1=R_1+jX_1$ and $Z_2=R_2+jX_2$ be the answers to a sine. "
        "They are passive if $0\\le R$ at every frequency."
    )
    page.lemma(
        "Side by side and fed back to each other passive systems are passive",
        for_all([*FREQUENCY, KIND], [R_1 >= 0, R_2 >= 0], conj(parallel(), fed_back())),
        because="$\\Re\\frac{Z_1}{1+Z_1Z_2}=(R_1+|Z_1|^2R_2)/|1+Z_1Z_2|^2$",
        boxed=True,
    )
    _settle(page)


def _settle(page):
    then = taken_apart(page.claim("s3-interconnection"))[2]
    stable = page.lemma(
        "A passive wall brings every damped device to rest, behind every delay, if it or a spring "
        "holds the mass",
        passive_wall_is_stable(),
        because="a delay is some whole periods and a fraction of one, as in "
        "\\chapter{s6e_fractional_passive_is_stable}",
    )
    wall = dict.fromkeys((beta, gamma, d), S.Zero) | {alpha: S.One, delta: S.One}
    lags = dict.fromkeys((R_1, R_2), Rational(1, 5)) | dict.fromkeys((X_1, X_2), -Rational(2, 5))
    beside = {**lags, **wall, KIND: S.One}
    chain = beside | {KIND: S(3)}
    drift = beside | {alpha: S.Zero, beta: S.Half}
    swing = beside | {alpha: S.Zero, gamma: pi**2 / 4, delta: S.Zero}

    def fails(point, denial):
        return point, passive(point), not_all(then.at(point), denial)

    page.settle(
        "s3-interconnection",
        conj(*connected_is_passive(), stable),
        example=(beside, passive(beside)),
        unless={
            NO_CHAIN: fails(chain, negative(chain)),
            HELD: fails(drift, stays_on_circle(drift, S.Zero)),
            DAMPED_DEVICE: fails(swing, stays_on_circle(swing, pi / 2)),
        },
        shows=r"two lags in a chain are not passive, a passive wall without stiffness lets a "
        "free mass drift, and without a damper a spring swings for ever",
        note="right in parallel and in feedback, of linear systems at each frequency; stable is "
        "said of the paper's loop, with a damper, and held by a spring or the wall",
    )


def passive(point):
    """The wall of a point is passive, without delay."""
    return passive_in_numbers({K: point[alpha], B: point[beta], b: point[delta], T: S.One})
