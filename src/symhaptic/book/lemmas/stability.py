"""Loops that are stable, and loops that are not: at a point, and by Jury's inequalities."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.definitions import loop_substituted


def polynomial_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """stable <=> all zeros inside, of the loop of a point; a part that is zero is not there."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    share = sp.Rational(point[d]).q
    return closed(loop_substituted(values, z, share, **parts), fact(whole(share * point[d])))


def stable_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """That a loop is stable, by balls around its zeros."""
    loop = polynomial_at(point)
    zeros: Any = loop.conclusion.of[1]  # type: ignore[attr-defined]
    return mp(loop, roots_inside(zeros.of[0], z, {}))


def unstable_at(point: Mapping[Symbol, Expr]) -> Theorem:
    """That it is not, by a ball around a zero outside."""
    loop = polynomial_at(point)
    zeros: Any = loop.conclusion.of[1]  # type: ignore[attr-defined]
    return denied_by(loop, root_outside(zeros.of[0], z))


@cache
def by_inequalities(delay: int) -> Theorem:
    """stable <=> Jury's inequalities, in the four numbers of the device, for an integer delay."""
    late = sp.Integer(delay)
    loop = by_zeros(alpha, beta, gamma, delta, late)
    zeros: Any = loop.conclusion.parts[1]
    return closed(chained(loop, jury(zeros.of[0], z)), fact(whole(late)))


@cache
def free_by_inequalities(delay: int) -> Theorem:
    """stable <=> Jury's inequalities, of a free mass with an integer delay."""
    late = sp.Integer(delay)
    loop = loop_substituted(
        (alpha, beta, sp.S.Zero, sp.S.Zero, late), z, 1, stiffness=False, damping=False
    )
    zeros: Any = loop.conclusion.parts[1]
    return closed(chained(loop, jury(zeros.of[0], z)), fact(whole(late)))


def collected(equivalence: Theorem, *inequalities: Any) -> Theorem:
    """p <=> q with the inequalities of q in another form, without those between numbers.

    Each form is a positive multiple of the inequality in its place.
    """
    claim: Any = equivalence.conclusion
    raw, wanted = claim.of[1], both(inequalities)
    left = [p for p in raw.parts if p.free]
    pairs = list(zip(left, wanted.parts, strict=True))
    there = conj(*(_scaled(other, p, raw) for p, other in pairs))
    back = {p: _scaled(p, other, wanted) for p, other in pairs}
    whole_again = conj(*(back[p] if p.free else fact(p) for p in raw.parts))
    return chained(equivalence, either_way(there, whole_again, raw, wanted))


def _scaled(wanted: Any, part_: Any, of: Proposition) -> Theorem:
    """A positive multiple of an inequality that is a part of a conjunction."""
    share = sp.cancel((wanted.right - wanted.left) / (part_.right - part_.left))
    return combined(wanted, [share, conjunct(assume(of), part_)])
