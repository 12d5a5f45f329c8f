"""An integer delay is one of the first few, or longer."""

from symhaptic.book.lemmas.marginal import behind
from symhaptic.book.lemmas.prelude import *


@cache
def counted(longest: int) -> Theorem:
    """d is 0, 1, ... or at least ``longest``; d is whole."""
    cases = [proposition(Eq(d, n)) for n in range(longest)]
    claim = Or((*cases, proposition(d >= longest)))
    start = claim.at({d: S.Zero})
    begin = disj(number(Relation(S.Zero, "=", S.Zero)), start)
    after = claim.at({d: d + 1})
    *equal, beyond = after.parts[1:]
    steps = [combined(then, [assume(case), 1]) for case, then in zip(cases, equal, strict=False)]
    steps.append(combined(beyond, [assume(cases[-1]), -1]))
    steps.append(combined(beyond, [assume(claim.of[-1])], [1]))
    step = disj_cases(assume(claim), *(disj(shown, after) for shown in steps))
    given = And((whole(d), claim))
    return induction(claim, d, begin, disch(add_assum(step, whole(d)), given))


def each_delay(
    claim: Proposition, longest: int, build: Callable[[int], Theorem], late: Theorem
) -> Theorem:
    """A claim for every integer delay: of each of the first ones, and of all that are longer."""
    shown = [behind(n, claim, build(n)) for n in range(longest)]
    return disj_cases(counted(longest), *shown, late)
