"""Axioms at terms: what is known of a sine, of a whole number, of a device, as it is used.

Nothing here has to be believed.  Each function takes terms, or theorems that meet the hypotheses.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy import Expr, S, Symbol

from symhaptic.notation.proposition import Exists, Iff, Implies, Predicate, Relation, proposition
from symhaptic.notation.terms import term
from symhaptic.proof.theorems.axioms import AXIOMS, known
from symhaptic.proof.theorems.kernel import (
    NotShown,
    Theorem,
    conj,
    conjunct,
    disch,
    prove_hyp,
    spec,
    undisch,
)
from symhaptic.proof.theorems.leaves import combined


def axiom(name: str, *terms: Any) -> Theorem:
    """An axiom at terms, in the order of its symbols; what it asks for are hypotheses."""
    over = AXIOMS[name].says.over  # type: ignore[attr-defined]
    found = spec(known(name), dict(zip(over, map(term, terms), strict=True)))
    return undisch(found) if isinstance(found.conclusion, Implies) else found


def _met(found: Theorem, *theorems: Theorem) -> Theorem:
    missing = [t for t in theorems if t.conclusion not in found.hypotheses]
    if missing:
        raise NotShown(f"{missing[0].conclusion} is not what is asked for")
    return prove_hyp(found, *theorems)


def _sides(theorem: Theorem, *signs: str) -> tuple[Expr, Expr]:
    claim = theorem.conclusion
    if not (isinstance(claim, Relation) and claim.sign in signs):
        raise NotShown(f"{claim} is no relation with {' or '.join(signs)}")
    return claim.left, claim.right


def square(of: Any) -> Theorem:
    """0 <= x^2 for a real x."""
    return axiom("square", of)


def ordered(left: Any, right: Any) -> Theorem:
    """a < b or b <= a."""
    return axiom("order", left, right)


def decided(left: Any, right: Any) -> Theorem:
    """a = b or a != b."""
    return axiom("equality", left, right)


def divided(claim: Any, numerator: Theorem, denominator: Theorem) -> Theorem:
    """0 < p/q from 0 < p and 0 < q, and 0 <= p/q from 0 <= p and 0 < q."""
    claim = proposition(claim)
    (a, b), (c, d) = _sides(numerator, "<", "<="), _sides(denominator, "<")
    strict = isinstance(numerator.conclusion, Relation) and numerator.conclusion.sign == "<"
    top = combined(Relation(S.Zero, "<" if strict else "<=", b - a), [numerator])
    bottom = combined(Relation(S.Zero, "<", d - c), [denominator])
    name = "quotient" if strict else "weak quotient"
    return combined(claim, [_met(axiom(name, b - a, d - c), top, bottom)])


def strictly(weak: Theorem, apart: Theorem) -> Theorem:
    """a <= b and a != b give a < b."""
    left, right = _sides(weak, "<=")
    if _sides(apart, "!=") == (right, left):
        apart = combined(Relation(left, "!=", right), [apart])
    return _met(axiom("strictly", left, right), weak, apart)


def both_ways(one: Theorem, other: Theorem) -> Theorem:
    """a <= b and b <= a give a = b."""
    return _met(axiom("both ways", *_sides(one, "<=")), one, other)


def sign_of(function: Any, of: Any) -> Theorem:
    """0 < sin x on (0, pi), 0 < cos x on (-pi/2, pi/2), 0 < exp x, 1 <= cosh x, 0 <= |x|."""
    name = "sqrt" if function is sp.sqrt else function.__name__
    if name not in ("sin", "cos", "exp", "cosh", "sqrt", "Abs"):
        raise NotShown(f"nothing is known of {function}")
    return axiom(name, of)


def rising(function: Any, smaller: Any, larger: Any) -> Theorem:
    """x < y gives f(x) < f(y): exp, sinh, atan, sin on [-pi/2, pi/2] and -cos on [0, pi]."""
    name = f"{function.__name__} {'falls' if function is sp.cos else 'rises'}"
    if name not in AXIOMS:
        raise NotShown(f"{function} is not known to rise")
    return axiom(name, smaller, larger)


def bounded(function: Any, of: Any) -> Theorem:
    """f(x)^2 <= 1 for the sine and the cosine of a real x."""
    if function not in (sp.sin, sp.cos):
        raise NotShown(f"{function} is not known to be bounded")
    return axiom(f"{function.__name__} bounded", of)


def magnitude(of: Any, negative: bool = False) -> Theorem:
    """|x| = x where 0 <= x, and |x| = -x where x <= 0."""
    return axiom("opposite size" if negative else "size", of)


def not_negative(of: Theorem) -> Theorem:
    """A whole number is not negative."""
    return _met(axiom("not negative", _said(of, "whole")[0]), of)


def full_turns(angle: Any, turns: Theorem) -> Theorem:
    """sin (x + 2 pi k) = sin x and cos (x + 2 pi k) = cos x for a whole k."""
    return _met(axiom("full turns", angle, _said(turns, "whole")[0]), turns)


def with_rest(of: Any, divisor: Any, turns: Symbol) -> Theorem:
    """For 0 <= a and 0 < p there is a whole k with k p <= a < (k + 1) p."""
    return _renamed(axiom("rest", of, divisor), turns)


def polar(along: Any, across: Any, size: Symbol, angle: Symbol) -> Theorem:
    """For 0 < x there are r and k with x = r cos k, y = r sin k, 0 < r and -pi/2 < k < pi/2."""
    return _renamed(axiom("polar", along, across), size, angle)


def _renamed(existence: Theorem, *names: Symbol) -> Theorem:
    """There is an x, by other names."""
    claim = existence.conclusion
    assert isinstance(claim, Exists)
    if len(set(names)) != len(claim.over) or claim.free & set(names):
        raise NotShown(f"{', '.join(map(str, names))} are no new names")
    named = claim.body.at(dict(zip(claim.over, names, strict=True)))
    return conjunct(existence, Exists(names, named))


def _said(theorem: Theorem, name: str) -> tuple[Expr, ...]:
    claim = theorem.conclusion
    if not (isinstance(claim, Predicate) and claim.name == name):
        raise NotShown(f"{claim} is about no {name}")
    return claim.of


# -- walls, loops and devices ----------------------------------------------------------


def linear(variable: Symbol, below: Theorem, above: Theorem) -> Theorem:
    """The zero of z - v lies inside for -1 < v < 1."""
    return _met(axiom("linear", _sides(below, "<")[1]), below, above)


def held_by_a_pole(pole: Theorem, outside: Theorem) -> Theorem:
    """A real pole z with 1 <= z^2 is not inside: as the paper has it, the loop is not stable."""
    return _met(axiom("held by a pole", *_said(pole, "pole")), pole, outside)


def whole_delay(wall: Sequence[Any]) -> Theorem:
    """Behind whole delays d the wall's force is (K + B (z-1)/(Tz)) z^-d x, held."""
    return axiom("passive wall", *wall)


def loop_of_device(numbers: Sequence[Any], values: Sequence[Any]) -> Theorem:
    """With the numbers of its device a loop is stable where z^(d+1) A + N W is."""
    return axiom("loop of a device", *values, *numbers)


def loop_late(numbers: Sequence[Any], values: Sequence[Any], names: Sequence[Symbol]) -> Theorem:
    """A loop that is stable as the paper reads it has a delay d = p/(q+1)."""
    found = axiom("loop as the paper reads it", *values, *numbers)
    reading = Predicate("stable_substituted", (), tuple(map(term, values)))
    return disch(_renamed(found, *names), reading)


def device_exists(spring: Any, damper: Any, names: Sequence[Symbol]) -> Theorem:
    """A device x'' + delta x' + gamma x = F has its four numbers."""
    return _renamed(axiom("device", spring, damper), *names)


def of_device(name: str, device: Theorem) -> Theorem:
    """What an axiom says of a device."""
    return _met(axiom(name, *_said(device, "device")), device)


def device_static(device: Theorem) -> Theorem:
    """1 - a + e = gamma (n1 + n0)."""
    return of_device("device at rest", device)


def device_at_rest(device: Theorem) -> Theorem:
    """1 - a + e = gamma (n1 + n0); 0 < n1 + n0 for 0 <= gamma, 0 < delta; e = exp(-delta)."""
    return conj(
        *(of_device(f"device{name}", device) for name in (" at rest", " pushed", "'s loss"))
    )


def device_comes_to_rest(device: Theorem) -> Theorem:
    """A device with damper and spring forgets its state: all zeros of A lie inside."""
    return of_device("device forgets", device)


def held_steady_state(device: Theorem, angle: Any) -> Theorem:
    """delta |(z-1) N|^2 < Re (z-1) N conj(A) at z = exp(j theta), 0 < theta <= pi."""
    return _met(axiom("held steady state", *_said(device, "device"), angle), device)


def swinging(device: Sequence[Any], rate: Symbol) -> Theorem:
    """x = exp(sigma t) sin(omega t) obeys Newton's law where both its parts vanish."""
    found = axiom("swings", *device)
    swings, some = found.conclusion.parts
    named = Exists((rate,), some.body.at({some.over[0]: rate}))  # type: ignore[attr-defined]
    return conjunct(found, Iff((swings, named)))


# -- what a held force does at the samples ---------------------------------------------


def in_units(
    device: Sequence[Any], late: Any, at: Any, answer: Any, period: Any, units: Sequence[Any]
) -> Theorem:
    """The same answer in other units: of time, and of force per length."""
    return axiom("units", *device, late, at, answer, period, *units)


def shifted(
    device: Sequence[Any], late: Any, at: Any, answer: Any, period: Any, periods: Any
) -> Theorem:
    """A force that comes whole periods l later is z^-l times the same force."""
    return axiom("later", *device, late, at, answer, period, periods)


def amplified(
    device: Sequence[Any], late: Any, at: Any, answer: Any, period: Any, gain: Any
) -> Theorem:
    """A gain that is not zero multiplies the answer."""
    return axiom("amplified", *device, late, at, answer, period, gain)
