"""Walls in the units of Table I that meet (5) at every frequency, and loops that are not stable."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.passive_is_stable import MARGIN
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.comparison import passive
from symhaptic.proof.theorems.definitions import loop_substituted

HALF = S.Half
PI = number(Relation(S.Zero, "<", pi))


def margins(below: Proposition) -> Theorem:
    """The margin at every angle, from (5) at every frequency."""
    met = at(assume(below), {omega: theta}, *map(assume, INSIDE))
    found = closed(positive(MARGIN >= 0, [met]), *divisors(theta))
    return for_all([theta], INSIDE, found)


def divisors(angle: Expr) -> tuple[Theorem, ...]:
    """What (5) and the margin divide by is not zero at an angle between 0 and pi."""
    half = sine_of_half(angle)
    return positive(Ne(2 - 2 * cos(angle), 0), [4, half, half]), not_zero(half)


def met(point: Mapping[Expr, Expr], *products: Any) -> Theorem:
    """(5) at every frequency for the wall of a point."""
    frequencies = passive().at(point)
    given, relation = frequencies.body.of  # type: ignore[attr-defined]
    found = closed(combined(relation, *products), *divisors(omega))
    return for_all([omega], given.of, found)


def unstable(point: Mapping[Expr, Expr]) -> Theorem:
    """That a loop is not stable: by a root outside, at 1 or beyond."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    share = point[d].q
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    loop = closed(loop_substituted(values, z, share, **parts), fact(whole(share * point[d])))
    zeros = loop.conclusion.of[1].of[0]  # type: ignore[attr-defined]
    at_one = zeros.subs(z, 1)
    if share > 1:
        return denied_by(loop, root_outside(zeros, z))
    if at_one == 0:
        return denied_by(loop, zero_on_circle(zeros, z, S.Zero, identity(at_one, S.Zero)))
    return denied_by(loop, zero_beyond(zeros, z, number(Relation(at_one, "<", S.Zero))))


def damped(below: Proposition) -> Theorem:
    """0 < delta, from (5) at theta = pi/(2(d+1)), where the virtual damping does nothing.

    For 0 <= alpha.
    """
    angle = pi / (2 * (d + 1))
    more = positive(d + 1 > 0, d >= 0, [S.One])
    share = over(angle > 0, number(Relation(S.Zero, "<", pi / 2)), more)
    rest = over(pi - angle > 0, positive(pi * (2 * d + 1) / 2 > 0, [PI, d >= 0], [HALF, PI]), more)
    inside = share, positive(angle < pi, [rest])
    met = at(assume(below), {omega: angle}, *inside)
    turn = (d + HALF) * angle
    low = over(
        turn > 0, positive((d + HALF) * pi / 2 > 0, [HALF, PI, d >= 0], [HALF / 2, PI]), more
    )
    high = over(
        pi - turn > 0,
        positive(pi * (d + Rational(3, 2)) / 2 > 0, [HALF, PI, d >= 0], [3 * HALF / 2, PI]),
        more,
    )
    lifts = closed(sign_of(sin, turn), low, positive(turn < pi, [high]))
    half = closed(sine_of_half(angle), *inside)
    need = over(
        alpha * sin(turn) / (2 * sin(angle / 2)) >= 0,
        positive(alpha * sin(turn) >= 0, [alpha >= 0, lifts]),
        positive(2 * sin(angle / 2) > 0, [2, half]),
    )
    turned = closed(divisors(angle)[0], *inside)
    apart = positive(Ne(d + 1, 0), [more]), positive(Ne(2 * d + 2, 0), [2, more]), not_zero(half)
    return closed(positive(delta > 0, [met], [need]), turned, *apart)
