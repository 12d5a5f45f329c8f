"""How much virtual damping can be passive, and where does the boundary end?

The passive walls of largest and smallest damping have no stiffness. We ask which frequency limits
them, and whether the boundary ends at $K=0$.
"""

from symhaptic.book.lemmas.largest_damping import between, divisors, limit_points, upper_frequency
from symhaptic.book.lemmas.prelude import *


def derive(page):
    need = passivity.dirichlet_form()
    page.say(
        r"By \chapter{s3a_passivity_condition} a wall is passive if "
        r"$b>\frac{KT\sin(d+\frac12)\theta}{2\sin\frac\theta2}-B\cos(d+1)\theta$ at every angle "
        r"$\theta=\omega T$. The right side is the required damping $b_{\min}$."
    )
    top = page.step(
        r"At $\theta=\pi/(d+1)$ the condition depends on the virtual damping only",
        need.subs(theta, pi / (d + 1)),
        K * T / 2 + B,
        name=r"\left.b_{\min}\right|_{\theta=\pi/(d+1)}",
        because=r"at this angle the coefficient of $KT$ is $\tfrac12$ and the cosine is $-1$, for "
        "every real $d$",
    )
    stiffness, damping = (e.subs(theta, pi / (d + 1)) for e in passivity.envelope())
    page.step(
        r"The envelope ends at $\theta=\pi/(d+1)$ without stiffness",
        stiffness,
        S.Zero,
        name=r"K|_{\theta=\pi/(d+1)}",
    )
    page.step(
        "At the end of the envelope, the virtual damping equals the damping of the device",
        damping,
        b,
        name=r"B|_{\theta=\pi/(d+1)}",
    )
    bottom = page.limit(
        "At low frequencies the boundary is this line",
        passivity.margin(),
        theta,
        S.Zero,
        b - K * T * (d + Rational(1, 2)) + B,
        name="F",
    )
    page.step(
        "The line of low frequencies meets $K=0$ at $B=-b$",
        bottom.subs({K: 0, B: -b}),
        S.Zero,
        name=r"F|_{K=0,\,B=-b}",
    )
    page.say(
        r"For $K\ge0$ the condition at $\theta=\pi/(d+1)$ gives $B\le b-KT/2\le b$, so the damping "
        r"is largest at $(0,b)$. The low frequencies give $B\ge KT(d+\tfrac12)-b\ge-b$. But (5) "
        "also admits walls of negative stiffness, which are not passive. For $K<0$ the boundary of "
        "(5) continues beyond these points, and larger damping satisfies (5)."
    )
    _ends(page, Eq(K, stiffness), Eq(B, damping), Eq(K, S.Zero, evaluate=False), Eq(B, -b))
    page.say(
        r"The frequency $\omega=\pi/(T(d+1))$ lies inside the open interval for $d>0$ only. "
        "Without delay it is the Nyquist frequency itself, at which (5) holds only as a limit. (In "
        r"$\pi/T(d+1)$ the denominator is the whole product.)"
    )
    page.step(
        r"The angle $\theta=\pi/(d+1)$ is the first one at which the cosine is $-1$",
        cos((d + 1) * (pi / (d + 1))),
        -S.One,
        name=r"\cos(d+1)\theta",
    )
    _frequency(page, Eq(omega, pi / (d + 1) / T), b > top)


def _ends(page, *derived):
    """The damping of a wall with K >= 0 that meets (5) lies between -b and b."""
    _, given, then = taken_apart(page.claim("s3c-limit-points"))
    above, below = between(given[-1])
    page.lemma("No wall that meets (5) has more damping than $b$", above)
    page.lemma("No wall that meets (5) has less damping than $-b$", below)
    beyond = {K: -S.One, T: S.One, b: S.One, B: Rational(5, 4), d: S.Zero, x: S.Zero, y: S.One}
    soft = beyond | {K: S.Zero, B: S.Half}
    quarter = Rational(1, 4)
    level = square(1 + cos(omega)), bounded(cos, omega)
    met = [
        _met(given[-1].at(beyond), [quarter], *([Rational(5, 8), e] for e in level)),
        _met(given[-1].at(soft), [S.Half], *([quarter, e] for e in level)),
    ]
    there = then.at(beyond)
    upper = there.of[0]
    point = conj(*(number(e) for e in upper.of[0].of))
    order = upper.of[1].of[1]
    held = conjunct(mp(conjunct(assume(there), upper), point), order)
    page.settle(
        "s3c-limit-points",
        limit_points(then, given[-1]),
        *derived,
        example=(soft, met[1]),
        unless={K >= 0: (beyond, *(met[0], not_intro(held, number(negated(order)), there)))},
        shows=r"for $d=0$, the wall $K=-1$, $B=\tfrac54b$ satisfies (5) at every frequency",
        note="the points limit the walls that meet (5), for every real $d$; with integer delays "
        "these are the passive walls",
    )


def _met(frequencies, *products):
    """(5) at every frequency for the wall of this point."""
    known, relation = frequencies.body.of
    return for_all([omega], known.of, closed(combined(relation, *products), *divisors(omega)))


def _frequency(page, *derived):
    """With a delay, (5) at this frequency is a linear condition."""
    printed = STATEMENTS["s3c-bmax-frequency"].printed
    then = taken_apart(page.claim("s3c-bmax-frequency"))[2]
    none = {d: S.Zero, T: S.One, omega: pi, b: S(2), K: S.One, B: S.One}
    there = then.at(none)
    last = there.of[1]
    outside = not_intro(conjunct(assume(there), last), number(negated(last)), there)
    page.settle(
        "s3c-bmax-frequency",
        upper_frequency(printed[0], then),
        *derived,
        example=none | {d: S.One, omega: pi / 2},
        unless={d > 0: (none, outside)},
        shows=r"for $d=0$ the frequency is $\omega_N$, outside $0<\omega<\omega_N$",
    )
