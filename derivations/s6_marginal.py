r"""Do the damper and the spring of an arm hardly matter?

The conclusion of the paper says so of both, inside the range (23). We compare the largest stable
stiffness with and without them.
"""

from sympy import Rational, S, symbols

from symhaptic.book.lemmas.marginal import AT_ONCE, LONG, hardly, none_pushes
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.undamped_robust import excluded
from symhaptic.bounds.walls import DEVICE, most, over
from symhaptic.model import boundary
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, IN_23, RANGES, STIFF
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.enclosed import given
from symhaptic.proof.plants import BALLS, NUMBERS, named
from symhaptic.proof.roots import decimals
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import conjoined, weakened
from symhaptic.proof.theorems.tactics import counterexample, example, for_all, not_all

GIVEN = named({s: s for s in NUMBERS})
MOST = boundary.largest_undelayed(DEVICE).subs(BALLS)
FIRST, SECOND = symbols("alpha_1 alpha_2")


def derive(page):
    damping(page)
    spring(page)


def damping(page):
    """What the damper of (23) adds."""
    page.say(
        "\\emph{Damping.} How many times the largest stable stiffness of an arm without damping "
        "is that of one with $\\delta=0.02$? For $\\gamma=0.001$ we start from $\\delta=0.001$."
    )
    rows = []
    for periods in (0, 1, 2, 4, 8, 16, 40):
        free = over(most(S.Zero, DAMPED, periods), most(S.Zero, S.Zero, periods))
        held = over(most(STIFF, DAMPED, periods), most(STIFF, STIFF, periods))
        rows.append([periods, decimals(free.ball, 12), decimals(held.ball, 12)])
    head = ["$d$", r"$\gamma=0$, $\delta$ from 0", r"$\gamma=0.001$, $\delta$ from 0.001"]
    page.table(r"Growth of the stable stiffness up to $\delta=0.02$, decimals cut off.", head, rows)
    page.say(
        "Marginal it is for $d\\le1$. The paper explains it by $\\delta$ being small against the "
        "largest stable damping; but that falls with the delay, as $2\\tan\\frac\\pi{4(d+1)}$, and "
        "at $d=40$ it is only twice as large as $\\delta=0.02$."
    )
    page.positive(
        "Without delay a damper adds less than 4.2 %",
        box.positive(Rational(1042, 1000) * Rational(6848, 10**4) - MOST, RANGES, GIVEN),
        IN_23,
        name=r"1.042\cdot0.6848-\alpha_{\max}(0)",
    )
    page.positive(
        "Without damping the stiffest wall has at least 0.6848",
        box.positive(MOST - Rational(6848, 10**4), {**RANGES, delta: (0, 0)}, GIVEN),
        r"0\le\gamma\le0.001,\ \delta=0",
        name=r"\alpha_{\max}(0)-0.6848",
    )
    known = {FIRST: most(STIFF, STIFF, 40), SECOND: most(STIFF, DAMPED, 40)}
    page.positive(
        "At $d=40$ it makes the wall eleven times as stiff",
        box.positive(SECOND - 11 * FIRST, {}, Known(given(known))),
        r"\gamma=0.001,\ \delta_1=0.001,\ \delta_2=0.02",
        name=r"\alpha_{\max}(\delta_2)-11\,\alpha_{\max}(\delta_1)",
    )
    page.lemma(
        "Without a damper no wall that does not pull is stable beside the spring with "
        "$(d+1)\\sqrt\\gamma=\\frac\\pi2$",
        excluded(),
        because="as in \\chapter{s5c_robust}; $\\gamma=(\\frac\\pi{100})^2<0.001$ is this "
        "spring for $d=49$",
    )
    claim = CLAIMED["s6-damping-marginal"](())
    symbols, known_of, then = taken_apart(claim)
    theorem = hardly(then, {delta: S.Zero}, {})
    point = {**LONG, delta: DAMPED}
    wall = {alpha: Rational(1, 2000), beta: S.Zero}
    denial = none_pushes(then.at(point), tuple(wall.values()), stable_at(wall | point))
    page.settle(
        "s6-damping-marginal",
        for_all(symbols, [*known_of, AT_ONCE], weakened(theorem, *known_of)),
        example=example({gamma: S.Zero, delta: S.Zero, d: S.Zero}, [*known_of, AT_ONCE]),
        unless=[counterexample(claim, point, denial, but=AT_ONCE)],
        shows=r"at $d=49$, $\gamma=(\pi/100)^2$ no wall that does not pull is stable without "
        r"damping, and $\alpha=0.0005$ is with $\delta=0.02$",
        note=r"of whole delays; less than 4.2\% without; for $\gamma=0$ it is 7\% at $d=1$, 33\% "
        r"at $d=8$",
    )


def spring(page):
    """What the spring of (23) takes or adds."""
    page.say("\\emph{The spring} of (23) takes a little of the stiffness without delay:")
    shares = [over(most(STIFF, DAMPED, n), most(S.Zero, DAMPED, n)) for n in (0, 1, 40)]
    rows = [decimals(share.ball, 16) for share in shares]
    page.table(
        r"Stable stiffness with $\gamma=0.001$ over that without a spring, $\delta=0.02$.",
        ["$d=0$", "$d=1$", "$d=40$"],
        [rows],
    )
    free = MOST
    page.positive(
        "Without delay the stiffest wall stays between 0.71 and 0.7133",
        box.positive(
            (free - Rational(71, 100)) * (Rational(7133, 10**4) - free),
            {**RANGES, delta: (DAMPED, DAMPED)},
            GIVEN,
        ),
        r"0\le\gamma\le0.001,\ \delta=0.02",
        name=r"(\alpha_{\max}-0.71)(0.7133-\alpha_{\max})",
    )
    page.say(
        "But in a long delay it is everything: with it the wall $\\alpha=0.00059$ is stable for "
        "every delay, without it none is. At $d=1000$:"
    )
    known = {FIRST: most(S.Zero, DAMPED, 1000)}
    gap = box.positive(Rational(59, 10**5) - 16 * FIRST, {}, Known(given(known)))
    page.positive(
        "At $d=1000$ the spring makes it sixteen times as stiff",
        gap,
        r"\delta=0.02",
        name=r"0.00059-16\,\alpha_{\max}(1000)",
    )
    claim = CLAIMED["s6-stiffness-marginal"](())
    symbols, known_of, then = taken_apart(claim)
    free: dict = {gamma: S.Zero}
    theorem = conjoined(hardly(then.of[0], free, {}), hardly(then.of[1], {}, free))
    point = {**LONG, delta: S.Zero}
    wall = {alpha: Rational(1, 5000), beta: Rational(47, 2500)}
    denial = none_pushes(then.of[1].at(point), tuple(wall.values()), stable_at(wall | point | free))
    page.settle(
        "s6-stiffness-marginal",
        for_all(symbols, [*known_of, AT_ONCE], weakened(theorem, *known_of)),
        example=example({gamma: S.Zero, delta: S.Zero, d: S.Zero}, [*known_of, AT_ONCE]),
        unless=[counterexample(claim, point, not_all(then.at(point), denial), but=AT_ONCE)],
        shows=r"at $d=49$ without damping the spring $\gamma=(\pi/100)^2$ excludes every wall that "
        r"does not pull, and $\alpha=0.0002$ is stable for a free mass",
        note=r"of whole delays; for $d=0$, $\delta=0.02$ less than 0.5\%, and 0.3\% at $d=1$; at "
        r"$d=1000$, $\delta=0.02$ the spring makes sixteen times the stiffness stable",
    )
