"""Walls in the units of Table I that meet (5) at every frequency, and loops that are not stable."""

from symhaptic.book.lemmas.passive_is_stable import MARGIN
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import polynomial_at
from symhaptic.paper.propositions.comparison import passive


def margins(below: Proposition) -> Theorem:
    """The margin at every angle, from (5) at every frequency."""
    met = at(assume(below), {omega: theta}, *map(assume, INSIDE))
    found = Given(*INSIDE).closed(show(MARGIN >= 0, met), sine_of_half(theta))
    return for_all([theta], INSIDE, found)


def divisors(angle: Expr) -> tuple[Theorem, ...]:
    """What (5) and the margin divide by is not zero at an angle between 0 and pi."""
    half = sine_of_half(angle)
    return show(Ne(2 - 2 * cos(angle), 0), half), show(Ne(sin(angle / 2), 0), half)


def met(point: Mapping[Expr, Expr], *products: Any) -> Theorem:
    """(5) at every frequency for the wall of a point."""
    frequencies = passive().at(point)
    given, relation = frequencies.body.of  # type: ignore[attr-defined]
    return for_all([omega], given.of, closed(combined(relation, *products), *divisors(omega)))


def unstable(point: Mapping[Expr, Expr]) -> Theorem:
    """That a loop is not stable: by a root outside, at 1 or beyond."""
    loop = polynomial_at(point)
    zeros = loop.conclusion.of[1].of[0]  # type: ignore[attr-defined]
    at_one = zeros.subs(z, 1)
    if point[d].q > 1:
        return denied_by(loop, root_outside(zeros, z))
    if at_one == 0:
        return denied_by(loop, zero_on_circle(zeros, z, S.Zero, identity(at_one, S.Zero)))
    return denied_by(loop, zero_beyond(zeros, z, number(Relation(at_one, "<", S.Zero))))


def damped(below: Proposition) -> Theorem:
    """0 < delta, from (5) at theta = pi/(2(d+1)), where the virtual damping does nothing.

    For 0 <= alpha.
    """
    angle = pi / (2 * (d + 1))
    here = Given(d >= 0, alpha >= 0)
    inside = here.have(angle > 0), here.have(pi > angle)
    met = at(assume(below), {omega: angle}, inside[0], here.show(angle < pi))
    turn, half = (d + HALF) * angle, here.closed(sine_of_half(angle))
    need = here.show(alpha * sin(turn) / (2 * sin(angle / 2)) >= 0, half, here.show(sin(turn) > 0))
    return here.closed(show(delta > 0, met, need), half)
