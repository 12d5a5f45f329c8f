"""Physical damping in place of virtual damping, where (25) decides and elsewhere."""

from symhaptic.book.lemmas.linear import turned
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.paper.propositions.linear import EXCHANGED, decides


@cache
def exchanged() -> Theorem:
    """stable <=> stable with x of the damping exchanged, where (25) decides for both."""
    before, after = decides(), decides().at(EXCHANGED)
    line, same = before.parts[0], after.parts[0]
    equal = either_way(combined(same, [assume(line)]), combined(line, [assume(same)]), line, same)
    return chained(chained(turned(assume(before)), equal), assume(after))


def at_point(same: Proposition, point: Terms) -> Theorem:
    """Whether two claims agree at a point: p <=> q, or that this is not so."""
    there = same.at(point)
    known = [_settled(part) for part in there.parts]
    (one, p), (other, q) = zip(known, there.parts, strict=True)
    if one.conclusion == p and other.conclusion == q:
        return either_way(add_assum(other, p), add_assum(one, q), p, q)
    if one.conclusion != p and other.conclusion != q:
        never = [not_intro(assume(c), t) for c, t in zip(there.parts, known, strict=True)]
        return either_way(contr(never[0], q), contr(never[1], p), p, q)
    held, denied = (one, other) if one.conclusion == p else (other, one)
    return not_intro(mp(assume(there), held), denied, there)


def _settled(claim: Proposition) -> Theorem:
    """A claim about numbers, or its denial."""
    if isinstance(claim, Relation):
        try:
            return number(claim)
        except NotShown:
            return number(negated(claim))
    wall = dict(zip((alpha, beta, gamma, delta, d), claim.terms, strict=True))
    try:
        return stable_at(wall)
    except NotShown:
        found = unstable_at(wall)
        assert found.conclusion == Not((claim,))
        return found
