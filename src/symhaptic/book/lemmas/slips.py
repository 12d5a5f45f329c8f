"""Why neither end of the interval of Sec. V-C will do."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation.proposition import TRUE
from symhaptic.paper.propositions.slips import END, ENDS, below


def neither_end() -> Theorem:
    """Not for the lower end, where delta is 0.02, nor for the upper one, where it is 0."""
    low, high = (below(end) for end in ENDS)
    damped, undamped = ({gamma: ENDS[1], delta: value} for value in (END, S.Zero))
    false = [clash(low, damped, 0), clash(high, undamped, 1)]
    claim = CLAIMED["s5c-interval"](())
    never = disj_cases(assume(claim), *false)
    return not_intro(contr(never, TRUE), contr(never, Not((TRUE,))), claim)


def clash(claim: Proposition, values: Terms, holds: int) -> Theorem:
    """Falsehood from an equivalence of which just one side, the one that ``holds``, is true."""
    _, given, same = taken_apart(claim)
    inside = [fact(p.at(values)) for p in given]
    there = at(assume(claim), values, *inside)
    sides = same.at(values).parts
    other = mp(there, fact(sides[holds]))
    wrong = sides[1 - holds]
    assert isinstance(wrong, Relation)
    return not_intro(other, fact(Relation(wrong.right, "<", wrong.left)))
