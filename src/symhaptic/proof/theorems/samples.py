"""What a device does at the sampling instants when a force is held from one to the next.

The rules are applied and not proved: with those of ``analysis``, ``energy`` and ``roots`` they are
the list of what has to be believed beside logic and the deciders.  All are about the predicate
``answers``: a force z^k in period k moves the position, at sample k, to X z^k.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy import Expr, Symbol
from sympy import ImmutableMatrix as Matrix

from symhaptic.notation.proposition import And, Iff, Proposition, Relation, whole
from symhaptic.notation.terms import term
from symhaptic.proof.normal import is_zero
from symhaptic.proof.theorems.axioms import answers, transfer
from symhaptic.proof.theorems.definedness import beyond, conditions, real, smooth
from symhaptic.proof.theorems.kernel import (
    Judgement,
    NotShown,
    Theorem,
    predicate,
    relation,
    rule,
    without,
)

SOURCES = {
    "held_answer": "a linear differential equation has one solution for each initial state; "
    "Coddington and Levinson, Theory of Ordinary Differential Equations, 1.8 and 3.1",
    "turns": "the definition of a response",
    "one_answer": "the definition of a response",
    "after_a_blow": "variation of constants, and integration by parts; Rudin, Principles of "
    "Mathematical Analysis, 6.22 and 6.12(b)",
}
"""Each rule of this module with its source."""

_ZERO, _ONE = sp.S.Zero, sp.S.One


@rule
def held_answer(
    device: Sequence[Any],
    delay: Sequence[Any],
    variable: Symbol,
    at: Any,
    answer: Any,
    motion: Sequence[Any],
    time: Symbol,
) -> Judgement:
    r"""The response of m x'' + b x' + k x = F to z^k, held for a period 1, delayed by l + epsilon.

    Phi and Gamma (``motion``), functions of time, are checked against the differential equation:
    Phi is the response to an initial state, and Gamma that to a unit force from rest.  X is the
    unique response if and only if z != 0, det(z - Phi) != 0 and X det(z - Phi) = (1, 0)
    adj(z - Phi) (Gamma(1 - epsilon) z^-l + Phi(1 - epsilon) Gamma(epsilon) z^(-l-1)), where Phi
    without an argument is Phi(1).  That l is whole and 0 <= epsilon <= 1 are hypotheses.
    """
    own, z, found = tuple(map(term, device)), term(at), term(answer)
    periods, rest = (term(v) for v in delay)
    if any(variable in v.free_symbols for v in (*own, z, periods, rest)):
        raise NotShown(f"{variable} is bound")
    phi, held = Matrix(2, 2, [term(v) for v in motion[:4]]), Matrix([term(v) for v in motion[4:]])
    hypotheses = _moves(own, phi, held, time) | {whole(periods)}
    if rest != 0:
        if not real(rest):
            raise NotShown(f"{rest} is not real by its form")
        hypotheses |= {Relation(_ZERO, "<=", rest), Relation(rest, "<=", _ONE), *conditions(rest)}
    one = phi.xreplace({time: _ONE})
    push = held.xreplace({time: 1 - rest}) * z**-periods
    if rest != 0:
        before = phi.xreplace({time: 1 - rest}) * held.xreplace({time: rest})
        push += before * z ** (-periods - 1)
    determinant = (z - one[0, 0]) * (z - one[1, 1]) - one[0, 1] * one[1, 0]
    numerator = (z - one[1, 1]) * push[0] + one[0, 1] * push[1]
    response = transfer(own, periods + rest, variable)
    product, apart = found * determinant, [Relation(t, "!=", _ZERO) for t in (z, determinant)]
    wanted = (*apart, Relation(product, "=", numerator))
    hypotheses |= beyond([found], [product]).difference(wanted)  # what SymPy cancels
    return hypotheses, Iff((answers(response, variable, z, found, _ONE), And(wanted)))


@lru_cache(maxsize=1 << 8)
def _moves(
    device: tuple[Expr, ...], phi: Matrix, held: Matrix, time: Symbol
) -> frozenset[Proposition]:
    """Conditions under which Phi and Gamma obey the differential equation, from their starts."""
    mass, damping, stiffness = device
    forms = [*phi, *held]
    if any(time in v.free_symbols for v in (mass, damping, stiffness)):
        raise NotShown(f"the device changes with {time}")
    if not all(smooth(f, time) for f in forms):
        raise NotShown("a motion is not differentiable by its form")
    columns = (phi[:, 0], (1, 0), 0), (phi[:, 1], (0, 1), 0), (held, (0, 0), 1)
    for (place, speed), (x, v), force in columns:
        wrong = [
            sp.diff(place, time) - speed,
            sp.diff(speed, time) - (force - damping * speed - stiffness * place) / mass,
            place.xreplace({time: _ZERO}) - x,
            speed.xreplace({time: _ZERO}) - v,
        ]
        if not all(is_zero(expr) for expr in wrong):
            raise NotShown("the motion is another than that of the device")
    found = set(conditions(1 / mass, damping, stiffness, *forms))
    without([time], found)
    return frozenset(found)


@rule
def turns(answered: Theorem) -> Judgement:
    """A force z^k has a response only if z != 0, since k may be negative."""
    return answered.hypotheses, Relation(predicate(answered, "answers").of[1], "!=", _ZERO)


@rule
def one_answer(one: Theorem, other: Theorem) -> Judgement:
    """Two responses of the same device to the same force are equal."""
    claim, again = predicate(one, "answers"), predicate(other, "answers")
    response, at, answer, period = claim.of
    if again != answers(response, claim.over[0], at, again.of[2], period):
        raise NotShown(f"{again} is about another device or another force")
    return one.hypotheses | other.hypotheses, Relation(answer, "=", again.of[2])


@rule
def after_a_blow(
    device: Theorem, first: Any, second: Any, ago: Symbol, test: Any, kernel: Theorem
) -> Judgement:
    """0 < p n1 + q n0 - f(1) from 0 < p + q exp(-delta u) - f'' - delta f' - gamma f on 0 < u < 1.

    The same holds with <=.  f and f' are zero at u = 0.  The impulse response h has h(0) = 0 and
    h'(0) = 1; it is positive on (0, 1] for gamma - delta^2/4 < pi^2.  The numbers of the device are
    n1 = int h(1 - u) du and n0 = int exp(-delta u) h(1 - u) du.  Integration by parts gives
    f(1) = int (f'' + delta f' + gamma f) h(1 - u) du; Rudin, 6.22 and 6.12.
    """
    gamma_, delta_, n1, n0, _, _ = found = predicate(device, "device").of
    p, q, f = term(first), term(second), term(test)
    if any(ago in t.free_symbols for t in (*found, p, q)) or not all(map(real, (*found, p, q, f))):
        raise NotShown(f"real terms without {ago} are wanted")
    divisors = conditions(p, q, f)
    if f.has(sp.Abs, sp.re, sp.im, sp.conjugate) or any(ago in c.free for c in divisors):
        raise NotShown(f"{f} is not smooth by its form")
    slope = sp.diff(f, ago)
    if not all(is_zero(t.xreplace({ago: _ZERO})) for t in (f, slope)):
        raise NotShown(f"{f} or its slope is not zero at the start")
    claim = relation(kernel, "<", "<=")
    wanted = p + q * sp.exp(-delta_ * ago)
    wanted -= sp.diff(slope, ago) + delta_ * slope + gamma_ * f
    if claim.left != 0 or not is_zero(claim.right - wanted):
        raise NotShown(f"{claim} is not the sign of {wanted}")
    hypotheses = kernel.hypotheses - {Relation(_ZERO, "<", ago), Relation(ago, "<", _ONE)}
    without([ago], hypotheses)
    hypotheses |= {Relation(gamma_ - delta_**2 / 4, "<", sp.pi**2), *divisors}
    end = f.xreplace({ago: _ONE})
    return device.hypotheses | hypotheses, Relation(_ZERO, claim.sign, p * n1 + q * n0 - end)
