"""Loops of other parts than the paper's: which inequalities decide about their zeros."""

from __future__ import annotations

from symhaptic.book.lemmas.prelude import *

SI = Given(m > 0, T > 0)
for scale in T**2 / m > 0, T / m > 0, 1 / m > 0, m / T**2 > 0, m / T > 0, 1 / T > 0:
    SI.have(scale)


@cache
def decided_by(stable: Predicate, *bounds: Any, given: tuple[Any, ...] = ()) -> Theorem:
    """The bounds <=> all zeros inside, by Jury's inequalities, for m > 0 and T > 0."""
    here = SI.and_(*given)
    criterion = here.closed(jury(stable.of[0], z))
    wanted: Any = criterion.conclusion.of[1]  # type: ignore[attr-defined]
    inside = mp(criterion, assume(stable))
    known = here.and_(*(conjunct(inside, p) for p in wanted.parts))
    there = [known.show(bound) for bound in bounds]
    back = mp(criterion, here.and_(*bounds).show(wanted))
    return either_way(back, there[0] if len(there) == 1 else conj(*there), both(bounds), stable)


def escapes(stable: Proposition, point: Mapping[Any, Any]) -> Theorem:
    """That a loop in numbers is not stable, by a ball around a zero outside."""
    return root_outside(stable.at(point).terms[0], z)


def in_z(ratio: tuple[Sequence[Any], Sequence[Any], int]) -> Expr:
    """A ratio of the parts of a loop, polynomials in z - 1 over z^late, as a function of z."""
    *sides, late = ratio
    above, below = (Add(*(c * (z - 1) ** n for n, c in enumerate(side))) for side in sides)
    return above / (below * z**late)
