r"""Is the largest stable stiffness ever equal to the largest passive one?

Fig. 12 of the paper draws the two stiffnesses, and the ratio $\eta$ of the passive to the stable
one, against the delay. The stable stiffness is larger, but at one delay the ratio comes close to
1. We study this delay and longer ones.
"""

import itertools

from symhaptic.book.figures.stability import largest_stiffnesses
from symhaptic.book.lemmas.figure9 import each_value
from symhaptic.book.lemmas.near_tip import Arm, none_above, rounded, tip, wall_below
from symhaptic.book.lemmas.outpaced import at_point
from symhaptic.book.lemmas.outweighed import stable_behind_every_delay
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.ratio_peak import at_arm, at_peak, least, of_delay
from symhaptic.paper.propositions.ratio import (
    FALLEN,
    FINE,
    NEAR,
    OTHER,
    PEAKS,
    RATE,
    SHOWN,
    WALL,
    below,
    grows,
)
from symhaptic.paper.propositions.stability import SQUARE, damping, stiffness


def derive(page):
    quarter = {d: pi / (2 * theta) - 1}
    page.say(
        r"At the angle $\theta=\pi/(2(d+1))$ the passivity condition does not contain the damping "
        "of the wall, so it bounds the stiffness alone:"
    )
    page.step(
        r"At $(d+1)\theta=\frac\pi2$ the required damping does not contain $\beta$",
        passivity.dirichlet_form().subs({K: alpha, T: S.One}).subs(quarter),
        alpha / (2 * tan(theta / 2)),
        name=r"\frac{\alpha\sin(d+\frac12)\theta}{2\sin\frac\theta2}-\beta\cos(d+1)\theta",
        because=r"therefore $\alpha\le2\delta\tan\frac\theta2$, and the wall (11) attains this "
        "bound",
    )
    bottom, top = z**2 - a * z + e, n_1 * z + n_0
    stiffness, _ = boundary.solved(on_circle(-(z**d) * bottom / top))
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
    need = (1 + a - e) * n_1 + (1 - a - e) * n_0 + 2 * (n_0 - e * n_1) * cos(theta)
    tip = page.step(
        r"At $(d+1)\theta=\frac\pi2$ the stability boundary has this stiffness",
        stiffness.subs(quarter),
        tan(theta / 2) * need / size,
        name=alpha,
        because=r"the stiffness is the passive bound with $\Re\{A/((z-1)N)\}$ in place of $\delta$",
    )
    bare = plant.numbers(S.Zero, delta)
    page.limit(
        "Without a spring the bound exceeds that of passivity by a term of second order",
        (tip.subs(bare) / (2 * delta * tan(theta / 2)) - 1) / theta**2,
        theta,
        S.Zero,
        (delta * (exp(delta) + 1) - 2 * (exp(delta) - 1)) / (2 * delta**2 * (exp(delta) - 1)),
        name=r"\frac1{\theta^2}\Bigl(\frac{\alpha}{2\delta\tan\frac\theta2}-1\Bigr)",
        because=r"the limit is about $\tfrac1{12}$; if the tip of the stable region has exactly "
        r"this angle, the ratio $\eta$ is about $1-\theta^2/12$",
    )
    page.say(
        "So the two largest stiffnesses are never equal. The passive wall of maximum stiffness "
        r"is stable, and so is a slightly stiffer one: $\eta<1$ for every integer delay. For "
        r"$\delta=0.02$ the tip has the angle $\pi/(2(d+1))$ near $d=122$ without a spring, and "
        r"near $d=40$ with $\gamma=0.001$. At these delays, $\eta$ exceeds $0.9999$ and $0.9998$, "
        "respectively, and looks like 1 in a figure. For longer delays the tip has "
        r"$(d+1)\theta>\frac\pi2$:"
    )
    far = symbols("u")
    page.limit(
        "Without a spring the stable stiffness falls like the inverse of a long delay",
        stiffness.subs(bare).subs({theta: phi * far}).subs(d, 1 / far - 1) / far,
        far,
        S.Zero,
        delta * phi * sin(phi),
        name=r"\frac{1}{u}\alpha\big|_{\theta=\varphi u}",
        because=r"here $u=1/(d+1)$ and $\theta=\varphi u$; the limit does not contain the mass",
    )
    page.limit(
        "The passive wall of maximum stiffness falls like the inverse of the delay",
        2 * delta * tan(pi * far / 4) / far,
        far,
        S.Zero,
        pi * delta / 2,
        name=r"\frac{2\delta\tan\frac{\pi u}{4}}{u}",
    )
    page.say(
        r"The passive limit equals the stable limit at $\varphi=\tfrac\pi2$, but "
        r"$\varphi\sin\varphi$ increases to $1.8197$ at $\varphi=2.029$. So without a spring "
        r"$\eta$ falls towards $\tfrac\pi2/1.8197=0.863$. With a spring, $\eta$ falls to 0, "
        "since some walls are stable for every delay:"
    )
    page.lemma(
        r"The wall $\alpha=0.00059$, $\beta=0$ is stable for every integer delay if "
        r"$\gamma=0.001$, $\delta=0.02$",
        stable_behind_every_delay(),
        because="everywhere on the circle the device's part of the polynomial is larger than "
        r"the wall's, $|A|>\alpha|N|$. So the number of roots inside is the same as without the "
        "wall, and all roots lie inside",
    )
    page.figure(
        "fig12",
        "Fig. 12 of the paper, for $\\delta=0.02$: (a) largest passive and stable stiffness; (b) "
        "and (c) their ratio $\\eta$ for $\\gamma=0$ (solid) and $\\gamma=0.001$ (dashed).",
        largest_stiffnesses,
        panels=(1, 3),
        height=0.44,
    )
    page.say(
        "Each of the drawn values has a lower and an upper bound. A stable wall next to the tip "
        "gives the lower bound, and one point $z$ of the circle gives the upper bound: a "
        r"polynomial $p$ of degree $n$ with all zeros inside satisfies $n|p|^2<2\Re\bar p\,zp'$ at "
        "$z$. At the tip's angle this inequality is false for all stiffer walls:"
    )
    for spring, delays in PEAKS.items():
        page.lemma(
            f"One stiffness exceeds that of all stable walls for $d={delays[-1]}$, "
            rf"$\gamma={float(spring):g}$",
            none_above((spring, DAMPED), delays[-1])[1],
        )
    page.settle(
        "fig12",
        drawn(),
        note="the statement is proved for integer delays: (a) for the five delays of Fig. 11; "
        "(b) and (c) from each delay of a list to the next, up to 122 and 40, and for 1000. The "
        r"ratio comes close to 1, stays below 1 and falls again. The same $\delta$ is used for "
        r"passivity and stability: for a device with an arm $\eta\le b_D/(b_D+b_H)$ "
        r"(\texttt{one-delta})",
    )


# Fig. 12: the largest stable stiffness for five delays, and the ratio as a function of the delay.


def rightmost(claim: Any, arm: Arm, delay: int) -> Theorem:
    """A wall of the boundary is as stiff as all stable ones; one stable wall is nearly as stiff."""
    then = taken_apart(claim)[2]
    tip_: Any = then
    angle, (limit, bounded), (wall, stable) = (
        tip(arm, delay)[2],
        none_above(arm, delay),
        wall_below(arm, delay),
    )
    here = dict(zip((gamma, delta), arm, strict=True))
    ranges = {s: (v, v) for s, v in here.items()}

    def on_curve(expr: Expr) -> Theorem:
        return numbers_known(inst(at_point(expr, ranges), here))

    size, half = SQUARE.xreplace({theta: angle}), cos(angle / 2)
    height = stiffness(S(delay)).xreplace({theta: angle})
    curve = {
        theta: angle,
        tip_.over[1]: height / (half * size),
        tip_.over[2]: damping(S(delay)).xreplace({theta: angle}) / (sin(angle) * size),
    }
    apart = [not_zero(on_curve(size))]
    there = tip_.body.at(curve)
    parts: list[Theorem] = []
    for part_ in there.of[:2]:
        parts.append(fact(part_))
    parts.append(conj(*(identity(p.left, p.right) for p in there.of[2].of)))
    most, near = there.of[3:]
    bottom = on_curve(half * size)
    more = over(
        Relation(S.Zero, "<", (1 + FINE) * curve[tip_.over[1]] - limit),
        on_curve((1 + FINE) * height - limit * half * size),
        bottom,
    )
    parts.append(for_all(WALL, [most.body.of[0]], positive(most.body.of[1], [bounded], [more])))
    less = over(
        Relation(S.Zero, "<", wall[0] - (1 - FINE) * curve[tip_.over[1]]),
        on_curve(wall[0] * half * size - (1 - FINE) * height),
        bottom,
    )
    values = dict(zip(OTHER, wall, strict=True))
    close = near.body.at(values).of[1]
    parts.append(exists(conj(stable, positive(close, [less])), near, values))
    found = exists(conj(*parts), tip_, curve)
    found = closed(found, *apart, not_zero(bottom), *apart)
    return as_claimed(claim, found)


def rises(arm: Arm, delay: int, later: int) -> Theorem:
    """eta(d) < rho < eta(d'), where a number rho separates two bounds."""
    low = least(delay, arm[1]).conclusion.right / wall_below(arm, delay)[0][0]
    high = least(later, arm[1]).conclusion.right / none_above(arm, later)[0]
    share = rounded(float(low + high) / 2)
    some: Any = at_arm(grows(delay, later), arm)
    under = some.body.at({RATE: share}).of[0]
    found = conj(of_delay(under, delay, arm), at_peak(later, share, arm))
    return exists(found, some, {RATE: share})


@cache
def drawn() -> Theorem:
    """The claim of Fig. 12."""
    tips = CLAIMED["fig12"](()).of[0]
    symbols, given, then = taken_apart(tips)

    def build(known: dict[Any, Expr]) -> Theorem:
        arm: Arm = (known[gamma], DAMPED)
        return rightmost(then.at(known), arm, int(known[symbols[1]]))

    shown = [as_claimed(tips, each_value(then, dict(zip(symbols, given, strict=True)), build))]
    for spring, later in PEAKS.items():
        arm: Arm = (spring, DAMPED)
        delays = (*SHOWN, *later)
        shown += [rises(arm, *pair) for pair in itertools.pairwise(delays)]
        shown.append(at_peak(later[-1], NEAR, arm))
        shown.append(of_delay(at_arm(below(FALLEN[spring], 1000), arm), 1000, arm))
    return conj(*shown)
