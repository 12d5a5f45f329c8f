"""Is the linear condition exact for a free mass?

For a free mass the boundary starts at the origin, and the line of (25) is its tangent there. We ask
on which side of the line the stable walls lie, for every delay.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.linear import of_a_free_mass as claimed
from symhaptic.proof.theorems.definitions import loop_substituted

LATE = (d + 1) * theta


def derive(page):
    stiffness, damping = boundary.wall(plant.sampled(plant.normalised(Parts(False, False))))
    surplus = sin((d + HALF) * theta) - (2 * d + 1) * sin(theta / 2) * cos(LATE)
    page.step(
        "The boundary of a free mass lies above the line",
        (damping - (d + HALF) * stiffness) * cos(theta / 2) ** 2,
        2 * sin(theta / 2) * surplus,
        name=r"\cos^2\tfrac\theta2\;(\beta-(d+\tfrac12)\alpha)",
    )
    page.say(
        "With $z=(1+s)/(1-s)$ the inside of the unit circle becomes the left half plane, and $z=1$ "
        "becomes $s=0$. The lowest coefficients of the polynomial in $s$ give necessary conditions "
        "for stability near $z=1$, for every delay:"
    )
    page.lemma(
        "A stable wall of a free mass satisfies three inequalities of Hurwitz",
        conj(*minors()),
        because="the inequalities are the first of Hurwitz' conditions, beginning with the "
        "lowest power of $s$",
    )
    slack = 2 * beta - d * alpha
    page.step(
        "The third inequality bounds a positive term by the distance from the line",
        minors()[-1].conclusion.right * 3,
        24 * (beta - alpha * (d + HALF))
        - 3 * (d + 1) * (slack**2 + (d + 1) * alpha * slack + d * (d + 2) * alpha**2 / 3),
        name=r"3\,(c_1c_2-c_0c_3)",
        because=r"the first and the second inequality give $\alpha>0$ and $2\beta>d\alpha$",
    )
    page.lemma("Every stable wall of a free mass satisfies (25)", above_the_line(), boxed=True)
    page.say(
        "The condition is necessary, and no wall with equality is stable. With damping some "
        r"walls with equality are stable (\chapter{s4e_line_passive})."
    )
    page.state(
        "linear-free-mass",
        r"for $\gamma=\delta=0$ and integer $d$ every stable wall satisfies (25), and no wall "
        "with equality in (25) is stable",
        claim=claimed(),
    )
    page.settle(
        "linear-free-mass",
        of_a_free_mass(),
        example={alpha: S.One, beta: S.One, d: S.Zero},
        note="the proof uses necessary conditions near $z=1$, for every integer $d$ at once",
    )


# The stable walls of a free mass lie above the line of the linear condition.


@cache
def minors() -> tuple[Theorem, ...]:
    """A stable wall has 0 < alpha, 0 < 2 beta - d alpha and 0 < c_1 c_2 - c_0 c_3."""
    loop = loop_substituted((alpha, beta, S.Zero, S.Zero, d), z, 1, stiffness=False, damping=False)
    stable, _ = loop.conclusion.parts
    found = first_minors(mp(loop, assume(stable)), 2)
    found = closed(found, *LATER_WHOLE)
    return tuple(conjunct(found, claim) for claim in found.conclusion.parts)


@cache
def above_the_line() -> Theorem:
    """A stable wall of a free mass has alpha (1/2 + d) < beta, for an integer d."""
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
    """Every stable wall satisfies (25), and no wall with equality in (25) is stable."""
    above = above_the_line()
    stable = next(p for p in above.hypotheses if p != whole(d))
    border = Eq(beta, alpha * (HALF + d))
    none = not_intro(above, assume(border), stable)
    found = conj(disch(above, stable), disch(none, border))
    return for_all((alpha, beta, d), [whole(d)], found)
