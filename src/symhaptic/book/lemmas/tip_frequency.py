"""The frequency of the stiffest wall: there damping does nothing, and at no lower one."""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.linear_part import shares
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import TURN, divisors, waves
from symhaptic.notation import b


def first_without_damping(equation: Any, claim: Any) -> Theorem:
    """The claim at omega = pi/(2 T (d+1))."""
    at = equation.rhs
    low, high, none, first, touched = claim.at({omega: at}).of
    more, period = shares()[0], assume(T > 0)
    size = positive(2 * T * (d + 1) > 0, [2, period, more])
    above = over(low, number(Relation(S.Zero, "<", pi)), size)
    room = positive(pi * (2 * d + 1) > 0, [PI, shares()[1]])
    below = over(high, room, size)
    nothing = identity(none.left, none.right)
    wave = _cosine()
    goal = first.body.of[1]
    turn = T * x
    half = closed(sine_of_half(turn), positive(turn > 0, [period, x > 0]), _below_pi())
    apart = not_zero(half), not_zero(positive(2 - 2 * cos(turn) > 0, [4, half, half]))
    first = for_all([x], first.body.of[0].of, closed(positive(goal, [wave]), *apart, _earlier(at)))
    stiffness = assume(touched.body.of[0].of[-1])
    need = touched.body.of[1]
    met = combined(need, [stiffness, -derivative(need.right, K)])
    met = for_all(touched.over, touched.body.of[0].of, add_assum(met, b >= 0))
    everything = conj(above, below, nothing, first, met)
    turned = combined(Eq(at, omega), [assume(equation), -S.One])
    found = subst(claim, omega, everything, turned)
    sine = waves()["sine"]
    level = not_zero(positive(2 - 2 * cos(2 * TURN) > 0, [4, sine, sine]))
    level = positive(Ne((2 - 2 * cos(T * omega)).xreplace({omega: at}), 0), [level])
    return closed(found, level, *divisors(), not_zero(size))


def _cosine() -> Theorem:
    """0 < cos((d+1) T x) for 0 < (d+1) T x < pi/2."""
    angle = (d + 1) * T * x
    more, period = shares()[0], assume(T > 0)
    low = positive(angle > -pi / 2, [more, period, x > 0], [HALF, PI])
    return closed(sign_of(cos, angle), low)


def _earlier(at: Expr) -> Theorem:
    """(d+1) T x < pi/2 for x < omega."""
    more, period = shares()[0], assume(T > 0)
    found = positive((d + 1) * T * x < pi / 2, [more, period, assume(x < at)])
    return closed(found, not_zero(positive(2 * T * (d + 1) > 0, [2, period, more])))


def _below_pi() -> Theorem:
    """T x < pi, since (d+1) T x < pi/2."""
    known = assume((d + 1) * T * x < pi / 2)
    return positive(T * x < pi, [known], [d >= 0, T > 0, x > 0], [HALF, PI])
