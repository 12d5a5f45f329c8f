"""Walls of (27) are those of (7), in the units of Table I."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sympy import Symbol, pi

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.linear_part import shares
from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.notation import T, d, delta, m, omega, omega_hat
from symhaptic.notation.proposition import Proposition, Relation
from symhaptic.paper.propositions.passivity import printed_of
from symhaptic.proof.theorems.kernel import Theorem, assume, placed, substituted
from symhaptic.proof.theorems.leaves import combined
from symhaptic.proof.theorems.tactics import closed, over


def in_units(given: Sequence[Proposition]) -> Theorem:
    """A wall of (27) is on the boundary, for what the claim supposes and omega_hat <= pi/(d+1)."""
    stiff, damped, lossy, _, _, spring, damper = map(assume, given[4:])
    known = placed(on_boundary(*map(assume, printed_of("eq7"))), {omega: omega_hat / T})
    stiffness, damping = (line.subs(omega, omega_hat / T) for line in printed_of("eq7"))
    wall = [
        combined(stiffness, [stiff, -m / T**2], [_damped(spring, lossy), m / T**2]),
        combined(damping, [damped, -m / T], [_damped(damper, lossy), m / T]),
    ]
    period, more = assume(T > 0), shares()[0]
    angle = [
        over(omega_hat / T > 0, omega_hat > 0, period),
        over(omega_hat / T < pi / T, omega_hat < pi, period),
        over(omega_hat / T <= pi / (T * (d + 1)), assume(omega_hat <= pi / (d + 1)), period),
    ]
    return closed(known, *wall, *angle, *map(not_zero, (period, assume(m > 0), more)))


def _damped(line: Theorem, lossy: Theorem) -> Theorem:
    """One line of (27), with b T/m for delta."""
    said: Any = line.conclusion
    place = Symbol("q")
    pattern = Relation(said.left, "=", said.right.xreplace({delta: place}))
    return substituted(pattern, place, line, lossy)
