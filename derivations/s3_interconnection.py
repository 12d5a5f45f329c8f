"""Is a connection of passive systems passive and stable?

Designers use passivity because an interconnection of passive systems is passive. We ask for which
connections this is true, and which kind of stability follows.
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
        "A system with the speed $v$ and the force $F$ is passive if it never delivers more energy "
        "than it has received: it stores at most the integral of $Fv$. Couple two passive systems, "
        "so that the second one acts on the first with the force $F_2$:"
    )
    pushed = symbols("F_2")
    face = page.step(
        "Two coupled systems receive energy only from outside",
        (F - pushed) * v + pushed * v,
        F * v,
        because="the force $F_2$ cancels in the sum, so the two systems together store at "
        "most the integral of $Fv$: the connection is passive",
    )
    page.same("parallel and feedback", face, (F - pushed) * v + pushed * v)
    page.say(
        "The two systems must share one quantity, here the speed, and exchange the other, here the "
        "force. A chain, in which the output of one system is the input of the next, is different. "
        "Take a lag $1/(s+1)$, in units of its time constant:"
    )
    lag = 1 / (1 + I * omega)
    page.step(
        "One lag is passive",
        real_part(lag),
        1 / (1 + omega**2),
        name=r"\Re\frac{1}{1+j\omega}",
        because="the real part is positive, so the lag is passive",
    )
    page.step(
        "Two lags in a chain are not passive",
        real_part(lag**2),
        (1 - omega**2) / (1 + omega**2) ** 2,
        name=r"\Re\frac{1}{(1+j\omega)^2}",
        because=r"the real part is negative for $\omega>1$, so the chain is not passive",
    )
    page.step(
        "A loop of three lags with a gain of 27 is unstable",
        (s + 1) ** 3 + 27,
        (s + 4) * ((s - S.Half) ** 2 + S(27) / 4),
        because=r"the closed loop has poles at $\frac12\pm\frac{3\sqrt3}2j$ and grows like "
        r"$e^{t/2}$, "
        "although the gain and each lag are passive",
    )
    page.say("A passive system need not come to rest:")
    page.step(
        "A free mass drifts after a push",
        Plant(m, None, None).transition(t)[0, 1],
        t,
        name=r"x/v_0",
        because="the mass receives energy only from the initial push, and then drifts forever",
    )
    page.say(
        "Let $Z_1=R_1+jX_1$ and $Z_2=R_2+jX_2$ be the frequency responses of two linear systems. "
        "Each of them is passive if its real part $R_1$ or $R_2$ is not negative at any frequency."
    )
    page.lemma(
        "Passive systems in parallel and in feedback are passive",
        for_all([*FREQUENCY, KIND], [R_1 >= 0, R_2 >= 0], conj(parallel(), fed_back())),
        because=r"for the feedback, $\Re\frac{Z_1}{1+Z_1Z_2}=(R_1+|Z_1|^2R_2)/|1+Z_1Z_2|^2$",
        boxed=True,
    )
    _settle(page)


def _settle(page):
    then = taken_apart(page.claim("s3-interconnection"))[2]
    stable = page.lemma(
        "With every delay a passive wall stabilises every damped device, if the wall has "
        "stiffness or the device has a spring",
        passive_wall_is_stable(),
        because="a delay consists of an integer number of periods and a fraction of a period, as "
        r"in \chapter{s6e_fractional_passive_is_stable}",
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
        shows="two lags in a chain are not passive; a free mass drifts at a passive wall without "
        "stiffness; a mass on a spring without a damper oscillates forever",
        note="the claim is true for parallel and feedback connections of linear systems, at each "
        "frequency; stability holds for the paper's loop with a damper, if the wall has "
        "stiffness or the device has a spring",
    )


def passive(point):
    """The wall of this point is passive without delay."""
    return passive_in_numbers({K: point[alpha], B: point[beta], b: point[delta], T: S.One})
