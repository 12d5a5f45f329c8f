"""Can the stiffness of a stable wall always be reduced?

For a soft contact the paper reduces the virtual stiffness down to zero and expects no loss of
stability. We keep the virtual damping constant and ask which walls stay stable.
"""

from symhaptic.book.lemmas.chords import PI
from symhaptic.book.lemmas.passive_is_stable import (
    EVERY_MARGIN,
    MARGIN,
    margin_to_the_end,
    passive_is_stable,
)
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.walls import damped, margins, met, unstable
from symhaptic.paper.propositions.comparison import passive
from symhaptic.proof.theorems.definitions import loop_substituted


def derive(page):
    margin = passivity.margin()
    page.say("Passive walls stay stable. The margin of (5) is linear in the stiffness:")
    softer = page.step(
        "With a share $y$ of the stiffness the margin is a weighted mean of two margins",
        margin.subs(K, y * K),
        y * margin + (1 - y) * (b + B * cos((d + 1) * theta)),
        name="F(yK,B)",
    )
    without = page.step(
        "Without stiffness the margin of a passive wall is not negative",
        b + B * cos((d + 1) * theta),
        (b + B) * (1 + cos((d + 1) * theta)) / 2 + (b - B) * (1 - cos((d + 1) * theta)) / 2,
        name="F(0,B)",
        because=r"a passive wall has $-b\le B\le b$",
    )
    page.same("softer", softer, margin.subs(K, y * K))
    page.same("ends", without, margin.subs(K, 0))
    page.say(
        r"So with $0\le y\le1$ the wall of stiffness $y\alpha$ is also passive. By "
        r"\chapter{s5a_passive_is_stable} it is stable for $\delta>0$ and integer delays as long "
        r"as $y\alpha+\gamma>0$. (Without any stiffness, $y\alpha=\gamma=0$, a root lies at 1.)"
    )
    page.lemma(
        "With less stiffness the margin stays non-negative at every angle",
        stays_passive(),
        because=r"for $\theta\to0$ and at $\theta=\pi/(d+1)$, the two conditions together are "
        r"$|\beta|\le\delta$",
    )
    page.say(
        "Other walls may become unstable, because the virtual damper alone may be unstable with "
        "the delay. For the arms of (23), this instability occurs with long delays, such as "
        r"$d=150$ with $\gamma=0.001$, $\delta=0.02$ and $\beta=0.0252$:"
    )
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50), beta: Rational("0.0252"), d: S(150)}
    soft = {**arm, alpha: Rational(1, 5000), y: S.Zero}
    page.lemma(r"With 150 periods of delay the wall with $\alpha=0.0002$ is stable", stands(soft))
    page.lemma(r"Without the stiffness $\alpha=0.0002$ the same wall is not stable", falls(soft))
    page.say("With stiff springs, as in Fig. 13, two periods of delay are sufficient:")
    spring = {gamma: S(3), delta: Rational(1, 50), beta: Rational("0.47"), d: S(2)}
    spring |= {alpha: Rational(3, 10), y: S.Zero}
    page.lemma(r"With a stiff spring the wall with $\alpha=0.3$ is stable", stands(spring))
    page.lemma(r"Without the stiffness $\alpha=0.3$ the same wall is not stable", falls(spring))
    held, below = proposition(y * alpha + gamma > 0), passive()
    stable = conjunct(passive_is_stable(), STABLE)
    softened = closed(inst(stable, {alpha: y * alpha}), stays_passive())
    bounds = damped(below), margins(below), not_negative(assume(whole(d)))
    found = closed(softened, *bounds)
    drifting = {alpha: S.One, beta: S.Zero, gamma: S.Zero, delta: S.One, d: S.Zero, y: S.Zero}
    easy = drifting | {y: S.One}
    page.settle(
        "s5b-soft-contacts",
        as_claimed(page.claim("s5b-soft-contacts"), found, held, below),
        example=(easy, *(met(easy, [S.Half]), stands(easy), fact(whole(S.Zero)))),
        unless={
            below: (soft, *(stands(soft), falls(soft), lacks(soft))),
            held: (drifting, *(stands(drifting), falls(drifting), met(drifting, [S.Half]))),
        },
        shows=r"with $\beta=0.0252$ and 150 periods of delay, the wall is stable with "
        r"$\alpha=0.0002$ and unstable with $\alpha=0$",
        note=r"the statement is true for a passive wall with $K\ge0$ if $\delta>0$. This is "
        "proved for integer delays; without delay the wall need not be passive. For the arms of "
        "(23), a search up to 75 periods of delay gives no counterexample",
    )


def stands(point):
    """The wall of this point is stable."""
    loop = at_point(point)
    zeros = loop.conclusion.of[1].of[0]
    return mp(loop, roots_inside(zeros, z, {}))


def falls(point):
    """With the share y of its stiffness the wall is not stable."""
    softened = {**point, alpha: point[y] * point[alpha]}
    if softened[alpha] + point[gamma] == 0:
        return unstable(softened)
    loop = at_point(softened)
    return denied_by(loop, root_outside(loop.conclusion.of[1].of[0], z))


def at_point(point):
    """The loop of this point is stable if and only if all zeros of its polynomial lie inside."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    loop = loop_substituted(values, z, 1, stiffness=point[gamma] != 0)
    return closed(loop, fact(whole(point[d])))


def lacks(point):
    """The wall of this point violates (5) at theta = pi/(d+1)."""
    below = passive().at(point)
    frequency = pi / (point[d] + 1)
    inside = [fact(r.at({omega: frequency})) for r in below.body.of[0].of]
    there = at(assume(below), {omega: frequency}, *inside)
    return not_intro(there, number(negated(there.conclusion)), below)


# A passive wall stays passive if its stiffness is reduced at constant damping.


@cache
def within_the_damper() -> tuple[Theorem, Theorem]:
    """-delta <= beta <= delta, from the margin at every angle, for 0 <= alpha and 0 <= d."""
    start = delta + beta - alpha * (d + S.Half)
    below = at(assume(EVERY_MARGIN), {theta: theta}, *map(assume, INSIDE))
    slow = in_the_limit(below, theta, S.Zero, pi, tends(MARGIN, theta, S.Zero, start))
    late = positive(d + S.Half > 0, d >= 0, [S.Half])
    low = positive(beta + delta >= 0, [prove_hyp(slow, PI)], [alpha >= 0, late])
    angle = pi / (d + 1)
    more = positive(d + 1 > 0, d >= 0, [S.One])
    inside = over(angle > 0, PI, more)
    end = positive(angle <= pi, [over(pi - angle >= 0, positive(pi * d >= 0, [PI, d >= 0]), more)])
    there = inst(margin_to_the_end(), {theta: angle})
    # there the cosine is -1, and the quotient of the sines 1/2
    high = positive(beta <= delta, [there], [S.Half, alpha >= 0])
    return low, closed(high, inside, end, positive(Ne(d + 1, 0), [more]))


@cache
def stays_passive() -> Theorem:
    """The margin of y alpha at every angle, from that of alpha, for 0 <= y <= 1 and 0 <= alpha."""
    low, high = within_the_damper()
    turn = cos((d + 1) * theta)
    bound = bounded(cos, (d + 1) * theta)
    one, other = (
        positive(1 + s * turn >= 0, *([S.Half, x] for x in (square(1 + s * turn), bound)))
        for s in (1, -1)
    )
    eased = positive(delta + beta * turn >= 0, [S.Half, low, one], [S.Half, high, other])
    there = at(assume(EVERY_MARGIN), {theta: theta}, *map(assume, INSIDE))
    wanted = MARGIN.xreplace({alpha: y * alpha})
    share = positive(1 - y >= 0, y <= 1)
    found = positive(wanted >= 0, [y >= 0, there], [share, eased])
    apart = positive(Ne(sin(theta / 2), 0), [sine_of_half(theta)])
    return for_all([theta], INSIDE, closed(found, apart))
