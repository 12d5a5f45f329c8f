r"""Do the damper and the spring of an arm hardly matter?

The conclusion of the paper says so of both, inside the range (23). We compare the largest stable
stiffness with and without them.
"""

from sympy import Rational, S

from symhaptic.book.lemmas.marginal import AT_ONCE, LONG, NEAR, hardly, none_pushes
from symhaptic.book.lemmas.near_tip import none_above, wall_below
from symhaptic.book.lemmas.outweighed import stable_behind_every_delay
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.book.lemmas.stiffest_stable import no_stiffer, numbers_known, stable_wall
from symhaptic.book.lemmas.undamped_robust import excluded
from symhaptic.bounds.walls import most, over
from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF
from symhaptic.proof.roots import decimals
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import conjoined, placed, weakened
from symhaptic.proof.theorems.tactics import counterexample, example, for_all, not_all

UNDAMPED = {**RANGES, delta: (S.Zero, S.Zero)}
BRAKED = {**RANGES, delta: (DAMPED, DAMPED)}


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
    page.lemma(
        "Inside (23) and without delay all stable walls have $\\alpha<0.7135$",
        no_stiffer(0, (Rational(7135, 10**4), NEAR), RANGES),
    )
    page.lemma(
        "Without delay and damping the wall $\\alpha=0.6848$, $\\beta=0.8282$ is stable, for "
        "$\\gamma\\le0.001$",
        of_arm(stable_wall(0, (Rational(6848, 10**4), NEAR), UNDAMPED), {delta: S.Zero}),
        because="so a damper adds less than 4.2 \\%",
    )
    page.say("At $d=40$ it makes the wall eleven times as stiff:")
    page.lemma(
        "For $\\gamma=\\delta=0.001$ all stable walls are softer than this at $d=40$",
        none_above((STIFF, STIFF), 40)[1],
    )
    page.lemma(
        "For $\\gamma=0.001$, $\\delta=0.02$ this wall is stable at $d=40$",
        wall_below((STIFF, DAMPED), 40)[1],
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
    page.lemma(
        "Without delay, $\\delta=0.02$, the wall $\\alpha=0.71$, $\\beta=0.8243$ is stable for "
        "$\\gamma\\le0.001$",
        of_arm(stable_wall(0, (Rational(71, 100), NEAR), BRAKED), {delta: DAMPED}),
    )
    page.lemma(
        "Without delay, $\\delta=0.02$, $\\gamma\\le0.001$, all stable walls have $\\alpha<0.7133$",
        of_arm(no_stiffer(0, (Rational(7133, 10**4), NEAR), BRAKED), {delta: DAMPED}),
    )
    page.say(
        "But in a long delay it is everything: with it one wall is stable for every delay, and "
        "without it none is. At $d=1000$ the spring makes it sixteen times as stiff:"
    )
    page.lemma(
        "For $\\gamma=0.001$, $\\delta=0.02$ the wall $\\alpha=0.00059$, $\\beta=0$ is stable for "
        "every whole delay",
        stable_behind_every_delay(),
    )
    page.lemma(
        "For $\\gamma=0$, $\\delta=0.02$ all stable walls are softer than this at $d=1000$",
        none_above((S.Zero, DAMPED), 1000, Rational(1, 10**4))[1],
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


def of_arm(theorem, values):
    """A theorem of a box of arms, for the one damper that the box has."""
    return numbers_known(placed(theorem, values))
