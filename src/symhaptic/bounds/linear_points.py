"""Where the error of the linear condition has a given value: all such points of the boundary."""

from __future__ import annotations

from typing import NamedTuple

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr

from symhaptic.model import linear, plant
from symhaptic.notation import a, delta, e, gamma, n_0, n_1, nu, s_1, s_2
from symhaptic.proof.ball import ball
from symhaptic.proof.normal import is_zero
from symhaptic.proof.roots import BITS, NoSuchRoot, real_roots

HALF = sp.Rational(1, 2)

UNDAMPED = {nu: HALF, s_1: gamma / 2, delta: sp.S.Zero}
UNSPRUNG = {s_1: delta, s_2: sp.S.One, gamma: sp.S.Zero}
"""What is known exactly without damping or spring; chapter s4e_line_error_start."""


class Arc:
    """The first arc of a boundary, alpha > -gamma, its numbers in balls."""

    def __init__(self, stiffness: Expr, damping: Expr, delay: int) -> None:
        self.delay, self.form = delay, linear.arc(delay)
        self.exact = {**(UNSPRUNG if stiffness == 0 else {}), **(UNDAMPED if damping == 0 else {})}
        point = {gamma: stiffness, delta: damping}
        known: dict[Expr, Expr | acb | arb] = {
            name: ball(value, None, BITS)
            for name, value in (plant.numbers(stiffness, damping) | point).items()
        }
        shape = linear.numbers(plant.Sampled(n_1, n_0, a, e))
        self.at = known | {name: ball(value, known, BITS) for name, value in shape.items()}
        back = [y for y in self.zeros(self.form.right) if not y < 0]
        if not back or not back[0] > 0:
            raise NoSuchRoot("the end of the arc is not enclosed")
        self.end = back[0]
        """The chord at which the arc is back at alpha = -gamma."""

    def zeros(self, polynomial: Expr) -> list[arb]:
        """All real zeros but 0 of a polynomial in the chord."""
        return real_roots(self.coefficients(polynomial))

    def coefficients(self, polynomial: Expr) -> list[arb]:
        """Its coefficients in balls, the lowest first, without those that are zero exactly."""
        exact = [self._exactly(c) for c in self.form.coefficients(polynomial)]
        while is_zero(exact[0]):
            exact.pop(0)
        return [ball(c, self.at, BITS).real for c in exact]

    def _exactly(self, part: Expr) -> Expr:
        """With what is known exactly, some of it by what else is."""
        return part.xreplace(self.exact).xreplace(self.exact)

    def chords(self, polynomial: Expr) -> list[arb]:
        """Its zeros on the arc, in order."""
        return [y for y in self.zeros(polynomial) if not (y < 0 or y > self.end)]

    def point(self, chord: arb) -> Point:
        """The point of the arc with this chord."""
        at = {**self.at, linear.CHORD: chord}
        right, up, size = (
            ball(self._exactly(part), at, BITS).real
            for part in (self.form.right, self.form.up, self.form.size)
        )
        with ctx.workprec(BITS):
            stiffness = right / size - ball(gamma, self.at, BITS).real
            return Point(2 * (chord.sqrt() / 2).asin(), stiffness, up / size)


class Point(NamedTuple):
    """A point of the boundary, in balls."""

    theta: arb
    alpha: arb
    beta: arb


def apart(arc: Arc, level: Expr) -> Expr:
    """A polynomial in the chord, zero where the error is ``level``."""
    return arc.form.above - level * (arc.delay + HALF) * arc.form.right


def points(arc: Arc, level: Expr) -> list[Point]:
    """All points of the arc where (alpha_lin - alpha)/(alpha + gamma) is ``level``.

    >>> from symhaptic.proof.roots import rounded
    >>> [rounded(p.alpha, 6) for p in points(Arc(sp.Rational(1, 1000), sp.Rational(1, 50), 0), 0)]
    ['0.0467456']
    """
    return [arc.point(y) for y in arc.chords(apart(arc, level))]


def error_without_stiffness(stiffness: Expr, damping: Expr, delay: int) -> arb:
    """(alpha_lin - alpha)/(alpha + gamma) where the boundary has alpha = 0, without a spring there.

    For gamma > 0 the point where the arc meets alpha = 0, for gamma = 0 the limit at its start.
    """
    arc = Arc(stiffness, damping, delay)
    form = arc.form
    if stiffness == 0:
        chord = arb(0)
        above, right = (
            (part / linear.CHORD).expand().subs(UNSPRUNG) for part in (form.above, form.right)
        )
    else:
        chord, *_ = arc.chords(form.right - gamma * form.size)
        above, right = form.above, form.right
    at = {**arc.at, linear.CHORD: chord}
    with ctx.workprec(BITS):
        return (ball(above, at, BITS) / ball((delay + HALF) * right, at, BITS)).real
