"""The stable walls of a mass alone lie above the line of the linear condition."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.definitions import loop_substituted


@cache
def minors() -> tuple[Theorem, ...]:
    """0 < alpha, 0 < 2 beta - d alpha and 0 < c_1 c_2 - c_0 c_3 of a stable wall; d is whole."""
    loop = loop_substituted((alpha, beta, S.Zero, S.Zero, d), z, 1, stiffness=False, damping=False)
    stable, _ = loop.conclusion.parts
    found = first_minors(mp(loop, assume(stable)), 2)
    found = closed(found, *(is_whole(d + n, assume(whole(d))) for n in (1, 2, 3)))
    return tuple(conjunct(found, claim) for claim in found.conclusion.parts)


@cache
def above_the_line() -> Theorem:
    """alpha (1/2 + d) < beta for a stable wall of a mass alone; d is whole."""
    stiff, first, second = minors()
    late = not_negative(assume(whole(d)))
    more = positive(d + 1 > 0, [late], [1])
    slack = positive(2 * beta - d * alpha > 0, [first])
    eighth = Rational(1, 8)
    return combined(
        beta > alpha * (HALF + d),
        [eighth, second],
        [eighth, more, slack, slack],
        [eighth, more, more, slack, stiff],
        [eighth / 3, more, late, late, stiff, stiff],
        [eighth / 3, 2, more, late, stiff, stiff],
    )


@cache
def of_a_free_mass() -> Theorem:
    """That, and that no wall with alpha (1/2 + d) = beta is stable."""
    above = above_the_line()
    stable = next(p for p in above.hypotheses if p != whole(d))
    border = Eq(beta, alpha * (HALF + d))
    none = not_intro(above, assume(border), stable)
    found = conj(disch(above, stable), disch(none, border))
    return for_all((alpha, beta, d), [whole(d)], found)
