"""What Fig. 4 draws: the curve (7), the line (8) and the tip (11) of a whole delay, and no more."""

from symhaptic.book.lemmas.linear_part import on_line
from symhaptic.book.lemmas.lower_boundary import nothing_else
from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import stiffest_wall
from symhaptic.book.lemmas.undelayed_boundary import its_damping, on_it
from symhaptic.book.lemmas.upper_boundary import loss, upper_boundary
from symhaptic.paper.propositions.passivity import BORDER


def drawn(claim: Any) -> Theorem:
    """Arc, line, the upper part without delay, that there is nothing else, and the tip."""
    *parts, others, tip = claim.of
    made = on_boundary, on_line, lambda *_: on_it()
    found = [_implied(of, how) for of, how in zip(parts, made, strict=True)]
    return conj(*found, _no_others(others), _implied(tip, stiffest_wall))


def _implied(implication: Any, made: Callable[..., Theorem]) -> Theorem:
    """One implication, of which the print comes last."""
    known = conjuncts(implication.of[0])
    return disch(add_assum(made(*map(assume, known[-2:])), *known), implication.of[0])


def _no_others(implication: Any) -> Theorem:
    """A wall of the boundary is on the arc, on the line or, without delay, on the upper part."""
    border, cover = implication.of
    arc, line, _ = cover.of
    late = strictly(assume(d >= 0), show(Ne(S.Zero, d), Ne(d, 0)))
    above = disj(closed(upper_boundary(arc), late), cover)
    damped = show(B >= 0, d * b / (2 * d + 3) < B, loss())
    at_once = disj(closed(its_damping(), damped), cover)
    high = disj_cases(decided(d, 0), at_once, above)
    low = disj(nothing_else(line.body.of[2:]), cover)
    found = disj_cases(ordered(d * b / (2 * d + 3), B), high, low)
    found = closed(Given(d >= 0).closed(found), conjunct(assume(border), BORDER))
    return disch(found, border)
