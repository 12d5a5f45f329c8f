"""Up to which stiffness is the error of the linear condition small?

Fig. 10 marks errors of 2 and 5 per cent. We look for a range of stiffnesses in which the error on
the boundary is at most 5 per cent, for every arm of (23).
"""

from symhaptic.book.lemmas.line_crossing import slow
from symhaptic.book.lemmas.linear_boundary import HIGH, LOW, on_it
from symhaptic.book.lemmas.linear_far import quotient
from symhaptic.book.lemmas.linear_gap import narrow
from symhaptic.book.lemmas.linear_rays import (
    A,
    at_start,
    b_1,
    coordinates,
    minor_at,
    share,
    slope,
    start_by_gap,
    zero,
    zero_of,
)
from symhaptic.book.lemmas.linear_two_percent import at_most
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_stable import on_box
from symhaptic.paper.propositions.linear import LATE
from symhaptic.paper.propositions.linear_error import HALF_WAY, RANGE, error, on_boundary_at, size


def derive(page):
    page.say(
        r"In the coordinates of \chapter{s4e_line_error_rises} the walls with an error of "
        r"$\varepsilon$ lie on the ray $b=(d+\frac12)(1+\varepsilon)A$. Jury's minor rises with "
        r"$b$ and is zero on the boundary. On the ray of 5\,\% the minor is positive:"
    )
    page.lemma(
        r"Without delay the boundary has $b\le1.05\cdot\frac12A$ up to $\alpha=0.09$", below(0)
    )
    page.lemma(
        r"With one period of delay the boundary has $b\le1.05\cdot\frac32A$ up to "
        r"$\alpha=0.026$",
        below(1),
    )
    page.say(
        r"On the ray of $-5\,\%$ the minor is negative for $A\ge\gamma$, since the gap at the "
        r"start is narrow (\chapter{s4e_line_two_percent}):"
    )
    page.lemma(
        r"Without delay the boundary has $0.95\cdot\frac12A\le b$ for $A\ge\gamma$", above(0)
    )
    page.lemma(
        r"With one period of delay the boundary has $0.95\cdot\frac32A\le b$ for "
        r"$A\ge\gamma$",
        above(1),
    )
    page.settle(
        "s6-linear-small-error",
        small_errors(),
        example=dict.fromkeys((alpha, beta, gamma, delta), S.Zero),
        enclosed=True,
        note=r"the statement is proved for $d=0$ and $d=1$, and for $\beta\le0.1$. Next to "
        r"$\alpha=-\gamma$ the error is larger (\texttt{linear-error-corner}). The paper's "
        r"devices have stiffnesses up to $\alpha=0.03$; for $d=1$ the proved range ends at a "
        "smaller stiffness",
    )


# Up to which stiffness the error of the linear condition is at most 5 per cent, d = 0 and d = 1.
#
# Jury's minor is zero on the boundary and rises with the damping.  It is positive on the ray with
# 5 per cent more damping.  For alpha >= 0 it is negative on the ray with 5 per cent less.

MOST_B = HIGH + DAMPED + 2 * STIFF


def box(delay: int) -> dict[Symbol, tuple[Any, Any]]:
    """The ranges of the arm and of A."""
    return {**RANGES, A: (0, RANGE[delay] + STIFF)}


def _lift(delay: int, low: Expr, high: Expr) -> Theorem:
    """0 < (f(high) - f(low))/(high - low) for the minor f."""
    wide = {**box(delay), b: (LOW, MOST_B), b_1: (LOW, MOST_B)}
    return inst(on_box(slope(delay, b, b_1), wide), {b: low, b_1: high})


def _rate(delay: int, steep: Expr) -> Expr:
    """The increase of the minor along a ray from its start, divided by A."""
    on_ray = minor_at(delay).xreplace({b: steep * A})
    return expanded((on_ray - on_ray.xreplace({A: S.Zero})) / A)


def _inside(delay: int) -> Given:
    """The range of A."""
    return Given(A > 0, box(delay)[A][1] >= A)


@cache
def below(delay: int) -> Theorem:
    """A wall at which the minor is zero has b <= 1.05 (d + 1/2) A."""
    steep = (1 + HALF_WAY) * share(delay)
    rate = _rate(delay, steep)
    gain = positive(
        minor_at(delay) > 0,
        [steep * A < b, _lift(delay, steep * A, b)],
        [at_start(delay)],
        [A > 0, on_box(rate, box(delay))],
    )
    return by_contradiction(b <= steep * A, _inside(delay).closed(gain), zero_of(minor_at(delay)))


@cache
def above(delay: int) -> Theorem:
    """A wall with gamma <= A at which the minor is zero has 0.95 (d + 1/2) A <= b."""
    steep = (1 - HALF_WAY) * share(delay)
    rate = _rate(delay, steep)
    part_ = start_by_gap(delay)
    falls = on_box(expanded(-rate - part_ * gamma * delta / 32), box(delay))
    heavy = on_box(part_, RANGES)
    loss = positive(
        minor_at(delay) < 0,
        [b < steep * A, _lift(delay, b, steep * A)],
        [A > 0, falls],
        [heavy, narrow()],
        [Rational(1, 32), heavy, gamma <= A, gamma >= 0, delta >= 0],
    )
    return by_contradiction(steep * A <= b, _inside(delay).closed(loss), zero_of(minor_at(delay)))


@cache
def small_error(delay: int) -> Theorem:
    """The claim for one delay, under the hypotheses of the statement."""
    place = coordinates(delay)
    inside = on_it(delay)
    _, low = (conjunct(inside, claim) for claim in conjuncts(inside.conclusion))
    left = conjunct(assume(on_boundary_at(delay)), -gamma < alpha)
    weight, width = share(delay), show(place[A] > 0, left)
    arm = gamma >= 0, gamma <= STIFF, delta >= 0, delta <= DAMPED
    here = Given(alpha >= 0, alpha <= RANGE[delay], beta <= HIGH, *arm)
    here = here.and_(left, low, zero(delay))
    more, less = (here.closed(inst(t, place)) for t in (below(delay), above(delay)))
    value = error(delay)
    off = place[b] / weight - place[A]
    gaps = [
        positive(HALF_WAY * place[A] - sign * off >= 0, [1 / weight, t])
        for sign, t in ((1, more), (-1, less))
    ]
    most = combined(value <= HALF_WAY, [quotient(gaps[0], width)])
    least = combined(value >= -HALF_WAY, [quotient(gaps[1], width)])
    found = closed(at_most(size(delay), HALF_WAY, most, least), not_zero(width))
    found = closed(of_every_plant(found), slow())
    return disch(found, on_boundary_at(delay), alpha >= 0, alpha <= RANGE[delay])


@cache
def small_errors() -> Theorem:
    """The claim for all arms of (23) and both delays."""
    return as_claimed(CLAIMED["s6-linear-small-error"](()), conj(*map(small_error, LATE)))
