"""The inequalities that ``symhaptic.jury`` returns are those of the criterion, and decide."""

from symhaptic.book.lemmas.passive_is_stable import DEVICE, NUMBERS
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.model.jury import jury as conditions_on
from symhaptic.paper.propositions.comparison import STABLE

DELAYS = (0, 1, 2)
WALLS = (alpha, beta, gamma, delta, *NUMBERS)


def decided_by_jury() -> Proposition:
    """A wall is stable just where all inequalities of jury(d) hold, for d = 0, 1 and 2."""
    return both(every(WALLS, [DEVICE], Iff(_sides(n))) for n in DELAYS)


def _sides(delay: int) -> tuple[Proposition, Proposition]:
    return STABLE.at({d: sp.S(delay)}), both(conditions_on(delay))


@cache
def jury_decides() -> Theorem:
    """The claim."""
    return conj(*(for_all(WALLS, [DEVICE], add_assum(_same(n), DEVICE)) for n in DELAYS))


def _same(delay: int) -> Theorem:
    """Each polynomial is one of the criterion's times a positive number."""
    criterion = by_inequalities(delay)
    stable, wanted = _sides(delay)
    theirs: Any = criterion.conclusion.parts[1]
    inside = mp(criterion, assume(stable))
    there = conj(*(_scaled(p, [conjunct(inside, q) for q in theirs.parts]) for p in wanted.parts))
    known = [conjunct(assume(wanted), p) for p in wanted.parts]
    here = mp(criterion, conj(*(_scaled(q, known) for q in theirs.parts)))
    return either_way(there, here, stable, wanted)


def _scaled(claim: Any, known: list[Theorem]) -> Theorem:
    """One relation from the one of several that is a multiple of it."""
    positive = proposition(claim)
    assert isinstance(positive, Relation)
    for theorem in known:
        share = sp.cancel(positive.right / theorem.conclusion.right)  # type: ignore[attr-defined]
        if share.is_Rational and share > 0:
            return combined(positive, [theorem, share])
    raise NotShown(f"{positive} is no multiple of what is known")
