"""Are the walls of the linear stability condition passive?

The paper identifies its (24) with the straight part (9) of the passivity boundary, and uses it to
obtain passive walls. We compare the two conditions, and ask for the role of the arm's damping.
"""

from sympy import sympify

from symhaptic.book.lemmas.linear_part import passive_below
from symhaptic.book.lemmas.motions import HALF_LATE, STEPS, TO_AND_FRO
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.region import DELAY
from symhaptic.model import lag, linear
from symhaptic.notation import t_e
from symhaptic.paper.propositions.device import normalised
from symhaptic.paper.propositions.linear import on_or_below_the_line


def derive(page):
    low = b + B - K * T * (d + HALF)
    page.limit(
        r"The limit of (5) for $\omega\to0$ is (9)",
        passivity.margin(),
        theta,
        S.Zero,
        low,
        name="F",
        because="(9) requires this limit to be positive; on the straight part of the boundary "
        "the limit is zero",
    )
    page.define("The delay is $d$ periods", t_d, d * T)
    page.define("The hold adds half a period to the delay", t_e, lag.DELAY)
    page.step(
        "With $t_d=dT$ the margin of (24) is that of (9) at low frequencies",
        b + B - K * t_e,
        low,
        because="the two margins depend on the effective delay $t_e$ only",
    )
    both = taken_apart(page.claim("s4e-same-as-passive"))[2]
    page.settle(
        "s4e-same-as-passive",
        same_condition(*both.of),
        example={K: S.One, B: S.One, b: S.One, T: S.One, d: S.One, t_d: S.One},
        note="the two formulas agree for every real $d$. By (3), $b$ is $b_D$ in (9). The "
        "passive walls are bounded by (9) only for integer $d$ and in its range of $B$",
    )
    page.say(
        "By (2), the damping in (24) is $b_D+b_H$. By (3), the damping in (9) is $b_D$: for "
        "passivity the arm is arbitrary, so its damping does not count. A wall between the "
        "two bounds satisfies (24) and is not passive:"
    )
    page.step(
        "With an arm, (24) admits more walls than (9)",
        (b_D + b_H + B) / (T * (d + HALF)) - (b_D + B) / (T * (d + HALF)),
        b_H / (T * (d + HALF)),
        name="K_{(24)}-K_{(9)}",
    )
    scaled = {K: alpha * m / T**2, B: beta * m / T, b: delta * m / T}
    page.step(
        "In the parameters of Table I, the margin at low frequencies is the surplus over the "
        "line of (25)",
        (low * T / m).subs(scaled),
        linear.surplus(),
        name=r"\tfrac TmF|_{\theta\to0}",
        because=r"here $\delta=b_DT/m$. By \chapter{s3c_linear_part_condition}, the condition is "
        r"strictest at low frequencies for integer $d$, $\alpha\ge0$ and "
        r"$-\delta\le\beta\le\frac d{2d+3}\delta$",
    )
    in_its_range(page)
    page.settle_external(
        "s4e-alpha-003",
        "a table of the paper's [8]",
        "at $\\alpha=0.03$ and $\\delta=0$ the error (26) is about 1.5\\,\\% for $d=0$ and "
        "5.6\\,\\% for $d=1$",
    )


def in_its_range(page):
    """The range of damping in which the walls of the line are passive."""
    page.lemma(
        r"The walls on the line or above it are passive for $\delta=b_DT/m$", passive_on_the_line()
    )
    claim = page.claim("s4e-passive-range")
    passive = taken_apart(claim)[2]
    extra = [whole(d), alpha >= 0, Eq(delta, b_D * T / m)]
    ones = {m: S.One, T: S.One, b_H: S.Zero, B: S.Zero}
    easy = in_units(ones | {K: S.One, b_D: S.One, t_d: S.Zero})
    cases = [
        (ones | {K: S.One, b_D: Rational(101, 100), t_d: HALF}, HALF_LATE),
        (ones | {K: -S(3), b_D: S.One, t_d: S.One}, STEPS),
        (ones | {K: S.One, b_D: S.Zero, b_H: S.One, t_d: S.Zero}, TO_AND_FRO),
    ]
    page.settle(
        "s4e-passive-range",
        as_claimed(claim, passive_on_the_line(), *extra),
        example=easy,
        unless=[
            counterexample(
                claim,
                in_units(point),
                gains(list(passive.at(point | {d: point[t_d]}).of), motion),
                holds=[e for e in extra if e is not but],
                but=but,
            )
            for (point, motion), but in zip(cases[::-1], extra[::-1], strict=True)
        ],
        shows="for an undamped device, coupled to an arm with $b_H=1$, the wall $K=T=1$, $B=d=0$ "
        "satisfies (24) and delivers energy",
        note="the statement also holds with equality in (25). Passive walls are stable with "
        r"every spring, so here (25) is safe for every $\gamma\ge0$. For fractional $d$ no wall "
        "with equality in (25) is passive",
    )


def in_units(point):
    """Add the parameters of Table I, for device and arm, to a point."""
    rules = [rule.xreplace({b: b_D + b_H}) for rule in normalised(alpha, beta, delta, d)]
    return point | {rule.lhs: sympify(rule.rhs).subs(point) for rule in rules}


# The linear condition is (9), and the walls that satisfy it are passive in a range of B.


def same_condition(linear: Any, passive: Any) -> Theorem:
    """(24) <=> (9), with t_d = d T."""
    here = DELAY.and_(Eq(t_d, d * T))
    here.have((d + HALF) * T > 0)
    here.have(lag.DELAY > 0)
    room = here.show(b + B - K * (d + HALF) * T > 0, linear)
    back = here.show(b + B - K * lag.DELAY > 0, passive)
    there, back = here.show(passive, room), here.show(linear, back)
    return either_way(there, back, linear, passive)


@cache
def passive_on_the_line() -> Theorem:
    """A wall with (25), or with equality in (25), is passive if beta <= delta d/(2d+3).

    This is for an integer d, alpha >= 0 and delta = b_D T/m.
    """
    here = Given(m > 0, T > 0, *normalised(alpha, beta, d), Eq(delta, b_D * T / m))
    spring, damper = here.have(m / T**2 > 0), here.have(m / T > 0)
    below = assume(b + B - K * T * (d + HALF) >= 0)
    found = inst(passive_below(below), {b: b_D})
    stiff, damped, _ = map(assume, normalised(alpha, beta, d))
    lossy = assume(Eq(delta, b_D * T / m))
    pushes = combined(K >= 0, [spring, assume(alpha >= 0)], [stiff, m / T**2])
    room = combined(
        b_D + B - K * T * (d + HALF) >= 0,
        [damper, assume(on_or_below_the_line())],
        [damped, m / T],
        [lossy, m / T],
        [stiff, -m / T * (HALF + d)],
    )
    share = d / (2 * d + 3)
    small = combined(
        d * b_D / (2 * d + 3) >= B,
        [damper, assume(d / (2 * d + 3) * delta >= beta)],
        [damped, -m / T],
        [lossy, m / T * share],
    )
    ahead = here.show(d >= 0, t_d >= 0)
    return here.closed(closed(found, room, pushes, small), ahead)
