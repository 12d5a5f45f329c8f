"""The frequency of the stiffest wall: there damping does nothing, and at no lower one."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stiffest_passive import TURN, waves


def first_without_damping(equation: Any, claim: Any) -> Theorem:
    """The claim at omega = pi/(2 T (d+1))."""
    at = equation.rhs
    low, high, none, first, touched = claim.at({omega: at}).of
    here = waves()
    above, below = here.show(low), here.show(high)
    nothing = identity(none.left, none.right)
    before = here.and_(x > 0, x < at)
    before.have((d + 1) * T * x < pi / 2, degree=3)
    wave = before.show(cos((d + 1) * T * x) > 0, degree=3)
    before.have(T * x < pi, degree=3)
    goal = show(first.body.of[1], wave)
    first = for_all([x], first.body.of[0].of, before.closed(goal, sine_of_half(T * x)))
    stiffness, need = touched.body.of[0].of[-1], touched.body.of[1]
    met = show(need, stiffness)
    met = for_all(touched.over, touched.body.of[0].of, add_assum(met, b >= 0))
    everything = conj(above, below, nothing, first, met)
    found = subst(claim, omega, everything, show(Eq(at, omega), equation))
    level = here.show(2 - 2 * cos(2 * TURN) > 0)
    return here.closed(found, level)
