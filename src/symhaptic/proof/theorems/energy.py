"""Theorems on energy: a sum over all motions as a condition at each angle.

They are applied and not proved: with those of ``analysis`` and ``roots`` they are the list of what
has to be believed beside logic and the deciders.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Symbol

from symhaptic.notation.proposition import (
    And,
    ForAll,
    Iff,
    Implies,
    Not,
    Predicate,
    Relation,
    whole,
)
from symhaptic.notation.terms import term
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.definedness import conditions, mirrors, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, Theorem, relation, rule, without
from symhaptic.proof.theorems.roots import coefficients, divisors, summands

SOURCES = {
    "toeplitz": "a Toeplitz form is non-negative if and only if its symbol is; "
    "Grenander and Szego, Toeplitz Forms and Their Applications, 5.2",
    "filtered": "the same, for a response that converges on the circle",
    "dissipates": "storage functions; Willems, Arch. Rational Mech. Anal. 45, 1972. For a given "
    "displacement, damper and friction dissipate least at constant speed",
    "swing_gains": "definition of passivity: a motion that gains energy can be repeated",
    "stored": "nothing is stored at rest, and a device can be brought to rest with arbitrarily "
    "little dissipation; Colgate and Schenkel, J. Robot. Syst. 14(1), 1997, Sec. 3",
}
"""Each rule of this module with its source."""

_ZERO = sp.S.Zero


@rule
def toeplitz(response: Any, variable: Symbol, damping: Any, angle: Symbol) -> Judgement:
    """No motion gains energy if and only if H(1) >= 0 and 0 <= c + Re H/(z - 1) on the circle.

    H is a polynomial in 1/z with real coefficients.  That its exponents are whole is a hypothesis.
    The real part of z^-e/(z - 1) is (cos (e+1) theta - cos e theta)/(2 - 2 cos theta).
    With x = p/(z - 1) the energy is the integral of |p|^2 (c + Re H/(z - 1)) over the circle, plus
    H(1)/2 times the square of the total displacement.
    """
    response, damping = term(response), term(damping)
    if {variable, angle} & damping.free_symbols or angle in response.free_symbols:
        raise NotShown("the angle and the variable are bound")
    if not real(damping):
        raise NotShown(f"{damping} is not real by its form")
    hypotheses = set(divisors(variable, damping, response))
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
def filtered(
    response: Any, denominator: Any, variable: Symbol, damping: Any, angle: Symbol
) -> Judgement:
    """The same condition for H = N/D, whose impulse response decays.

    N and D (``denominator``) are real polynomials in z of known degrees.  D is monic, and N is not
    of higher degree.  That all zeros of D lie inside the unit circle is a hypothesis.  H divides
    by factors of D only.
    """
    response, damping, below = term(response), term(damping), term(denominator)
    if {variable, angle} & damping.free_symbols:
        raise NotShown("the angle and the variable are bound")
    if angle in response.free_symbols | below.free_symbols:
        raise NotShown("the angle is bound")
    if not real(damping):
        raise NotShown(f"{damping} is not real by its form")
    above = sp.cancel(response * below)
    falling = [coefficients(of, variable) for of in (above, below)]
    if falling[1][0] != 1 or len(falling[0]) > len(falling[1]):
        raise NotShown(f"{below} is not monic, or of a lower degree than {above}")
    if not all(real(c) and mirrors(c) for of in falling for c in of):
        raise NotShown(f"{response} is not real by its form")
    if not is_zero(response * below - above):
        raise NotShown(f"{response} is not {above} by {below}")
    turn = sp.exp(sp.I * angle)
    at = [[sp.Add(*(c * w**n for n, c in enumerate(f[::-1]))) for f in falling] for w in (turn, 1)]
    lag, static = (over / under for over, under in at)
    lag /= turn - 1
    margin = damping + (lag + lag.xreplace({sp.I: -sp.I})) / 2
    inside = And((Relation(_ZERO, "<", angle), Relation(angle, "<", sp.pi)))
    always = ForAll((angle,), Implies((inside, Relation(_ZERO, "<=", margin))))
    energy = Predicate("passive", (variable,), (response, damping))
    fades = Predicate("stable", (variable,), (below,))
    powers = [f.as_base_exp() for f in sp.Mul.make_args(below)]
    factors = [base for base, exponent in powers if exponent.is_Integer and exponent > 0]
    hypotheses = {fades, *divisors(variable, damping, response, below, apart=factors)}
    hypotheses |= conditions(*falling[0], *falling[1])
    return hypotheses, Iff((energy, And((Relation(_ZERO, "<=", static), always))))


@rule
def stored(wall: Sequence[Any], speed: Symbol, some: Theorem, none: Theorem) -> Judgement:
    """Stored energy E(v) does not affect passivity, if 0 <= E(v) and E(0) = 0.

    The user's work is E(v) at the end plus the energy that damper and wall absorb.  With 0 <= E it
    is at least what a device without E absorbs; conversely, a motion that gains energy without E
    also gains it with E, if it begins and ends at rest.  Since E is a polynomial, this condition
    changes the dissipated energy by an arbitrarily small amount.
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


def counted(force: Any, place: Symbol, wall: Sequence[Any]) -> Predicate:
    """No motion gains energy from the force F(y), beside b, f_c, T and Delta (``wall``)."""
    return Predicate("passive_counted", (place,), (force, *wall))


@rule
def dissipates(
    store: Any,
    force: Any,
    wall: Sequence[Any],
    over: Sequence[Symbol],
    growth: Theorem,
    some: Theorem,
    none: Theorem,
) -> Judgement:
    """A force F(y) is passive together with b and f_c if it has a storage function S(x).

    Let x be the position, y its count and p the displacement in a period (``over``).  The premises
    show 0 <= F(y) p + b p^2/T + f_c |p| - S(x + p) + S(x) for y - Delta/2 <= x <= y + Delta/2, and
    0 <= S(x) and S(0) = 0.
    """
    store, force, parts = term(store), term(force), tuple(map(term, wall))
    (b, friction, period, step), (x, y, p) = parts, over
    if any({x, y, p} & part.free_symbols for part in parts) or len({x, y, p}) < 3:
        raise NotShown("place, count and way are bound")
    if {x, p} & force.free_symbols or {y, p} & store.free_symbols:
        raise NotShown("a force is of the count, and a store of the place")
    taken = force * p + b * p**2 / period + friction * sp.Abs(p)
    rest = taken - store.xreplace({x: x + p}) + store
    wanted = (rest, store), (growth, some)
    for left, theorem in zip(*wanted, strict=True):
        if theorem.conclusion != Relation(_ZERO, "<=", left):
            raise NotShown(f"{theorem.conclusion} does not say that {left} is not negative")
    if none.conclusion != Relation(store.xreplace({x: _ZERO}), "=", _ZERO):
        raise NotShown(f"{none.conclusion} does not say that nothing is stored at the start")
    near = {Relation(y - step / 2, "<=", x), Relation(x, "<=", y + step / 2)}
    hypotheses = (growth.hypotheses - near) | some.hypotheses | none.hypotheses
    hypotheses |= conditions(store, force, *parts)
    without([x, y, p], hypotheses)
    given = {Relation(_ZERO, "<", period), Relation(_ZERO, "<", step)}
    given |= {Relation(_ZERO, "<=", b), Relation(_ZERO, "<=", friction)}
    return hypotheses | given, counted(force, y, parts)


@rule
def swing_gains(
    force: Any, place: Symbol, wall: Sequence[Any], swing: Sequence[Any], gain: Theorem
) -> Judgement:
    """A force F(y) is not passive if a motion of two periods, forth and back, gains energy.

    The device moves at constant speed from x to x + p and back; l and n are the counts of x and of
    x + p (``swing``).  The premise (``gain``) is F(l Delta) p - F(n Delta) p + 2 b p^2/T +
    2 f_c |p| < 0.
    """
    force, parts, moved = term(force), tuple(map(term, wall)), tuple(map(term, swing))
    (b, friction, period, step), (x, p, *counts) = parts, moved
    for part in (*parts, *moved):
        if place in part.free_symbols or not real(part):
            raise NotShown(f"{part} is not real by its form, or {place} is bound")
    defined = conditions(force, *parts, *moved)
    without([place], defined)
    one, other = (force.xreplace({place: n * step}) for n in counts)
    energy = one * p - other * p + 2 * b * p**2 / period + 2 * friction * sp.Abs(p)
    if gain.conclusion != Relation(energy, "<", _ZERO):
        raise NotShown(f"{gain.conclusion} does not say that {energy} is negative")
    hypotheses = gain.hypotheses | defined
    for at, n in zip((x, x + p), counts, strict=True):
        hypotheses |= {whole(n), Relation(n * step - step / 2, "<", at)}
        hypotheses |= {Relation(at, "<", n * step + step / 2)}
    hypotheses |= {Relation(_ZERO, "<", period), Relation(_ZERO, "<", step)}
    return hypotheses, Not((counted(force, place, parts),))
