"""When is a wall with an integer delay passive? The condition at each angle, as an equivalence."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model.passivity import margin
from symhaptic.proof.theorems.energy import toeplitz
from symhaptic.proof.theorems.familiar import whole_delay

WALL = (K, B, b, T, d)
PASSIVE = Predicate("passive_wall", (), WALL)


def at_every_angle(claim: object) -> Proposition:
    """A claim for all angles 0 < theta < pi."""
    return ForAll((theta,), Implies((both(INSIDE), proposition(claim))))


def every_margin(delay: Expr = d) -> Proposition:
    """0 <= b - K T sin((d+1/2) theta)/(2 sin(theta/2)) + B cos((d+1) theta), 0 < theta < pi."""
    return at_every_angle(margin().subs(d, delay) >= 0)


@cache
def passive_by_angle(delay: Expr = d) -> Theorem:
    """passive <=> K >= 0 and the margin at every angle, under the hypotheses T > 0 and d whole."""
    energy = whole_delay((*WALL[:-1], delay))
    wanted = every_margin(delay)
    sampled = energy.conclusion.of[1]  # type: ignore[attr-defined]
    form = toeplitz(*(sampled.of[0], z), sampled.of[1], theta)
    static, always = form.conclusion.of[1].of  # type: ignore[attr-defined]
    raw = always.body.of[1]
    here = Given(T > 0, *INSIDE).and_(sine_of_half(theta))
    here.have(1 / T > 0)
    inside = [assume(p) for p in INSIDE]
    there = here.show(wanted.body.of[1], at(assume(always), {theta: theta}, *inside))  # type: ignore[attr-defined]
    back = here.show(raw, at(assume(wanted), {theta: theta}, *inside))
    condition = And((static, wanted))
    known = And((static, always))
    same = either_way(
        conj(conjunct(assume(known), static), _under(there, always, known)),
        conj(conjunct(assume(condition), static), _under(back, wanted, condition)),
        known,
        condition,
    )
    found = chained(energy, chained(form, same))
    return Given(T > 0, *([] if delay.is_Integer else [whole(delay)])).closed(found)


def _under(theorem: Theorem, claim: Proposition, whole_claim: Proposition) -> Theorem:
    """A claim for every angle that follows from one part of a conjunction."""
    return closed(for_all([theta], INSIDE, theorem), conjunct(assume(whole_claim), claim))
