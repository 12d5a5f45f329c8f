"""Theorems on energy: a sum over all motions as a condition at each angle.

They are applied and not proved: with those of ``analysis`` and ``roots`` they are the list of what
has to be believed beside logic and the deciders.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Symbol

from symhaptic.notation.proposition import And, ForAll, Iff, Implies, Predicate, Relation, whole
from symhaptic.notation.terms import term
from symhaptic.proof.theorems.definedness import conditions, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, relation, rule, without
from symhaptic.proof.theorems.roots import summands

SOURCES = {
    "toeplitz": "a Toeplitz form is non-negative where its symbol is, and only there; "
    "Grenander and Szego, Toeplitz Forms and Their Applications, 5.2",
    "stored": "what is stored at rest is nothing, and a device comes to rest at as little cost "
    "as one likes; Colgate and Schenkel, J. Robot. Syst. 14(1), 1997, Sec. 3",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def toeplitz(response: Any, variable: Symbol, damping: Any, angle: Symbol) -> Judgement:
    """No motion gains energy if and only if H(1) >= 0 and 0 <= c + Re H/(z - 1) on the circle.

    H is a polynomial in 1/z with real coefficients; that its exponents are whole is a hypothesis.
    Of z^-e/(z - 1) the real part is (cos (e+1) theta - cos e theta)/(2 - 2 cos theta).
    With x = p/(z - 1) the energy is the integral of |p|^2 (c + Re H/(z - 1)) over the circle, and
    H(1)/2 times the square of the whole way.
    """
    response, damping = term(response), term(damping)
    if {variable, angle} & damping.free_symbols or angle in response.free_symbols:
        raise NotShown("the angle and the variable are bound")
    if not real(damping):
        raise NotShown(f"{damping} is not real by its form")
    hypotheses = set(conditions(damping, response, but=variable))
    static, margin = _ZERO, damping
    for exponent, coefficient in summands(response, variable):
        hypotheses |= {whole(-exponent), *conditions(coefficient)}
        static += coefficient
        turn = sp.cos((1 - exponent) * angle) - sp.cos(exponent * angle)
        margin += coefficient * turn / (2 - 2 * sp.cos(angle))
    inside = And((Relation(_ZERO, "<", angle), Relation(angle, "<", sp.pi)))
    always = ForAll((angle,), Implies((inside, Relation(_ZERO, "<=", margin))))
    energy = Predicate("passive", (variable,), (response, damping))
    return hypotheses, Iff((energy, And((Relation(_ZERO, "<=", static), always))))


@rule
def stored(wall: Sequence[Any], speed: Symbol, some: Theorem, none: Theorem) -> Judgement:
    """A store E(v) does not matter to passivity, for 0 <= E(v) and E(0) = 0.

    The hand's work is E(v) at the end and what damper and wall take.  With 0 <= E it is not less
    than without a store; and a motion that gains energy without one gains it as well if it begins
    and ends at rest, which changes the damper's share as little as one likes: E is a polynomial.
    """
    parts = tuple(term(t) for t in wall)
    claim, zero = relation(some, "<="), relation(none, "=")
    store = claim.right
    if len(parts) != 5 or any(speed in t.free_symbols for t in parts):
        raise NotShown(f"a wall K, B, b, T, d without {speed} is wanted")
    if claim.left != 0 or not (store.is_polynomial(speed) and real(store)):
        raise NotShown(f"{claim} does not say that a polynomial in {speed} is not negative")
    if zero != Relation(store.xreplace({speed: _ZERO}), "=", _ZERO):
        raise NotShown(f"{zero} does not say that nothing is stored at rest")
    hypotheses = some.hypotheses | none.hypotheses
    without([speed], hypotheses)
    given = {Relation(_ZERO, "<", parts[3]), Relation(_ZERO, "<=", parts[4])}
    device = Predicate("passive_device", (speed,), (store, *parts))
    return hypotheses | given, Iff((device, Predicate("passive_wall", (), parts)))
