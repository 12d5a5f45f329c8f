r"""Is a passive wall stable with every spring, and what does damping do to the passive walls?

The spring did not enter the comparison: a wall that meets the passivity condition is stable in
every hand, whatever its stiffness.
"""

from sympy import Ne, S, cos

from symhaptic.book.lemmas.passive_is_stable import passive_is_stable
from symhaptic.book.lemmas.walls import (
    HALF,
    LATE,
    damped,
    divisors,
    fractional_sums,
    margins,
    met,
    unstable,
)
from symhaptic.model import passivity
from symhaptic.notation import B, K, alpha, beta, d, delta, gamma, omega, y
from symhaptic.notation.proposition import Relation, whole
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.proof.theorems.familiar import bounded, square
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import absurd, assume, cut, part, weakened
from symhaptic.proof.theorems.tactics import (
    at,
    closed,
    counterexample,
    either_way,
    example,
    fact,
    for_all,
    one,
    over,
    positive,
)


def derive(page):
    _robust(page)
    _scaled(page)


def _robust(page):
    """A stiff passive wall needs a damper, so that nothing has to be said of it."""
    claim = CLAIMED["s5c-robust-subset"](())
    symbols, given, robust = taken_apart(claim)
    extra = [alpha > 0, whole(d)]
    stiff = positive(alpha + gamma > 0, alpha > 0, gamma >= 0)
    found = cut(part(passive_is_stable(), STABLE), margins(given[-1]), stiff)
    damper = page.lemma(
        "A wall that does not pull meets (5) beside a damper only",
        damped(given[-1]),
        because="at $\\theta=\\pi/(2(d+1))$ its virtual damping does nothing",
    )
    found = closed(cut(found, damper), positive(alpha >= 0, alpha > 0))
    every = for_all([gamma], [gamma >= 0], found)
    theorem = for_all(symbols, [*given, *extra], weakened(every, *given))
    stiff_wall = {alpha: S.One, beta: S.Zero, delta: S.One, d: S.Zero}
    nothing = stiff_wall | {alpha: S.Zero, beta: HALF}

    turns = square(1 + cos(omega)), bounded(cos, omega)
    eased = [[HALF / 2, known] for known in turns]

    def shaken(point):
        """Not for every spring: not without one."""
        falls = unstable({**point, gamma: S.Zero})
        there = robust.at(point)
        calm = at(assume(there), {gamma: S.Zero}, fact(Relation(S.Zero, "<=", S.Zero)))
        return absurd(calm, falls, there)

    page.settle(
        "s5c-robust-subset",
        theorem,
        example=example(stiff_wall, [*given, *extra], met(stiff_wall, [HALF])),
        unless=[
            counterexample(
                claim,
                nothing,
                *(met(nothing, *eased, [HALF]), shaken(nothing)),
                holds=[whole(d)],
                but=alpha > 0,
            ),
            counterexample(
                claim,
                LATE,
                met(LATE, *fractional_sums()),
                shaken(LATE),
                holds=[alpha > 0],
                but=whole(d),
            ),
        ],
        shows="without stiffness and spring the device drifts",
        note=r"holds for every $\gamma\ge0$, beyond the Nyquist frequency too; a stiff wall meets "
        r"(5) for $\delta>0$ only",
    )


def _scaled(page):
    """(5) is linear in the wall and the damper."""
    need = passivity.dirichlet_form()
    page.step(
        "The damping that is needed is proportional to the wall",
        need.subs({K: y * K, B: y * B}, simultaneous=True),
        y * need,
        name=r"\text{need}(yK,yB)",
        because="the condition is linear in the wall: with $y$ times the damping, $y$ times the "
        "wall is passive",
    )
    claim = CLAIMED["s5a-proportional"](())
    symbols, given, scaled = taken_apart(claim)
    small, large = scaled.of
    inside = [assume(p) for p in small.body.of[0].of]
    up = positive(large.body.of[1], [at(assume(small), {omega: omega}, *inside), y > 0])
    share = over(1 / y > 0, one(), y > 0)
    down = positive(small.body.of[1], [at(assume(large), {omega: omega}, *inside), share])
    both = (
        for_all(
            [omega], small.body.of[0].of, closed(way, positive(Ne(y, 0), y > 0), *divisors(omega))
        )
        for way in (up, down)
    )
    same = weakened(either_way(*both, small, large), *given)
    point = {alpha: S.One, beta: S.Zero, delta: S.One, d: S.Zero, y: S.One}
    page.settle("s5a-proportional", for_all(symbols, given, same), example=example(point, given))
