r"""Which number lies in the interval of Sec. V-C?

The text bounds $\gamma$ by an interval. By (30) the bound is the number $\pi^2+\frac14\delta^2$,
and this number lies in the interval.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation.proposition import TRUE
from symhaptic.paper.propositions.slips import END, ENDS, below, within


def derive(page):
    page.say(
        r"The right side of (30), $\gamma\le\pi^2+\frac14\delta^2$, lies in the interval. Neither "
        r"end point of the interval is the correct bound for every $\delta$."
    )
    page.step(
        r"At $\delta=0.02$ the limit exceeds $\pi^2$ by $0.0001$",
        (delta**2 / 4).subs(delta, END),
        Rational("0.0001"),
        name=r"\tfrac14\delta^2\big|_{\delta=0.02}",
    )
    meant = within()
    then = taken_apart(meant)[2]
    same, low, high = then.of
    thirty, limit = same.of
    share = Rational(1, 4)
    both = either_way(positive(limit, [thirty]), positive(thirty, [limit]), thirty, limit)
    found = conj(
        both,
        combined(low, [share, square(delta)]),
        positive(high, [share, delta <= END, delta >= 0], [share * END, delta <= END]),
    )
    beyond = {gamma: ENDS[1], delta: S.Zero}
    page.settle(
        "s5c-interval",
        found,
        instead=meant,
        corrected=(r"\gamma\le\pi^2+\tfrac14\delta^2\in[\pi^2,\pi^2+0.0001]",),
        example=beyond,
        unless=[Case(beyond, neither_end())],
        shows=r"the arm $\delta=0$, $\gamma=\pi^2+0.0001$ violates (30)",
    )


# Neither end of the interval of Sec. V-C is the correct bound.


def neither_end() -> Theorem:
    """The lower end is wrong for delta = 0.02, and the upper end for delta = 0."""
    low, high = (below(end) for end in ENDS)
    damped, undamped = ({gamma: ENDS[1], delta: value} for value in (END, S.Zero))
    false = [clash(low, damped, 0), clash(high, undamped, 1)]
    claim = CLAIMED["s5c-interval"](())
    never = disj_cases(assume(claim), *false)
    return not_intro(contr(never, TRUE), contr(never, Not((TRUE,))), claim)


def clash(claim: Proposition, values: Terms, holds: int) -> Theorem:
    """A contradiction from an equivalence of which only one side, ``holds``, is true."""
    _, given, same = taken_apart(claim)
    inside = [fact(p.at(values)) for p in given]
    there = at(assume(claim), values, *inside)
    sides = same.at(values).parts
    other = mp(there, fact(sides[holds]))
    wrong = sides[1 - holds]
    assert isinstance(wrong, Relation)
    return not_intro(other, fact(Relation(wrong.right, "<", wrong.left)))
