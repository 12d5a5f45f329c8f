"""What the named predicates mean: the physics that a proposition about a wall stands for."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate
from math import floor
from typing import Any

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.model.loop import characteristic
from symhaptic.model.parts import Parts
from symhaptic.notation import alpha, beta, d, delta, gamma, z
from symhaptic.notation.proposition import Iff, Not, Predicate, Proposition, Relation, whole
from symhaptic.notation.terms import term, tree
from symhaptic.proof.ball import sign
from symhaptic.proof.theorems.definedness import conditions, differs, real
from symhaptic.proof.theorems.kernel import Judgement, NotShown, rule


@rule
def loop(
    values: Sequence[Any], variable: Symbol, stiffness: bool = True, damping: bool = True
) -> Judgement:
    """For integer delays a loop is stable if and only if its characteristic polynomial is.

    The loop has the parameters alpha, beta, gamma, delta and d (``values``).  A device without
    spring or damper has gamma = 0 or delta = 0, and a polynomial that is derived from its own
    motion.  That its poles differ is a hypothesis if the polynomial divides by their difference.
    """
    divisors, zeros = loop_polynomial(values, variable, 1, stiffness, damping)
    found = tuple(term(v) for v in values)
    return divisors | {whole(found[4])}, Iff((Predicate("stable_loop", (), found), zeros))


def loop_polynomial(
    values: Sequence[Any], variable: Symbol, share: Any, stiffness: bool, damping: bool
) -> tuple[set[Proposition], Predicate]:
    """A loop's polynomial in w, with z = w^share, has its zeros inside; and its divisors."""
    found = [term(v) for v in values]
    if any({variable, z} & t.free_symbols for t in found):
        raise NotShown(f"{variable} or {z} is bound")
    if (not stiffness and found[2] != 0) or (not damping and found[3] != 0):
        raise NotShown("a part that is not modelled is zero")
    if term(share).is_number and not (term(share).is_Integer and share >= 1):
        raise NotShown(f"{share} is no share of a period")
    polynomial = characteristic(Parts(stiffness=stiffness, damping=damping))
    names = dict(zip((alpha, beta, gamma, delta, d), found, strict=True))
    placed = polynomial.xreplace({s: v for s, v in names.items() if s != v})
    powers = _raised(placed, variable, share)
    # of the variable there are powers only; what SymPy cancels is asked for as well
    there = tree(polynomial).inst({s: tree(v) for s, v in names.items()})
    written = (c.evaluated() for c in conditions(there))
    lost = {c for c in written if not (isinstance(c, Relation) and differs(c.left))}
    divisors = {c for c in (*conditions(powers), *lost) if c.free.isdisjoint((variable, z))}
    return divisors, Predicate("stable", (variable,), (powers,))


def _raised(expr: Expr, variable: Symbol, share: Any) -> Expr:
    """With variable^share for z."""
    if expr == z or (expr.is_Pow and expr.args[0] == z):
        return variable ** (share * expr.as_base_exp()[1])
    return expr.func(*(_raised(a, variable, share) for a in expr.args)) if expr.args else expr


@rule
def loop_substituted(
    values: Sequence[Any],
    variable: Symbol,
    share: int,
    stiffness: bool = True,
    damping: bool = True,
) -> Judgement:
    """The paper's reading of a delay of d = p/q periods: the polynomial in w, with z = w^q.

    That q d is whole is a hypothesis (``share``).
    """
    share, late = int(share), term(values[4])
    judged = loop_polynomial(values, variable, share, stiffness, damping)
    return judged[0] | {whole(share * late)}, Iff(
        (Predicate("stable_substituted", (), tuple(map(term, values))), judged[1])
    )


@rule
def gains(wall: Sequence[Any], motion: Sequence[tuple[Any, Any]]) -> Judgement:
    """A motion at constant speeds, (time in periods, displacement) piece by piece, gains energy.

    Times and displacements are rational; K, B and b are real numbers.  In each piece the damper
    dissipates b p^2/(duration T), and the wall absorbs F p with the held force
    F = K x + B (x - x')/T of the sample d periods before.
    """
    K, B, b, T, late = (term(t) for t in wall)
    pieces = [(Fraction(duration), Fraction(way)) for duration, way in motion]
    if not (T.is_Rational and late.is_Rational) or T <= 0 or late < 0:
        raise NotShown("a rational period T > 0 and delay d >= 0 are wanted")
    if any(v.free_symbols or not real(v) for v in (K, B, b)) or sign(b) not in (0, 1):
        raise NotShown("a wall in real numbers is wanted, with b >= 0")
    if any(duration <= 0 for duration, _ in pieces):
        raise NotShown("a piece takes no time")
    ends = list(accumulate((duration for duration, _ in pieces), initial=Fraction(0)))
    places = list(accumulate((way for _, way in pieces), initial=Fraction(0)))

    def position(time: Fraction) -> Fraction:
        i = bisect_left(ends, time)
        if i in (0, len(ends)):
            return places[min(i, len(pieces))]
        share = (time - ends[i - 1]) / pieces[i - 1][0]
        return places[i - 1] + share * pieces[i - 1][1]

    burnt = against_K = against_B = Fraction(0)
    behind = Fraction(late)
    for i, (duration, way) in enumerate(pieces):
        begin, end = ends[i], ends[i + 1]
        burnt += way**2 / duration
        k = floor(begin - behind)
        while k + behind < end:
            here, before = position(Fraction(k)), position(Fraction(k - 1))
            moved = position(min(end, k + 1 + behind)) - position(max(begin, k + behind))
            against_K += here * moved
            against_B += (here - before) * moved
            k += 1
    energy = b * sp.Rational(burnt) / T + K * sp.Rational(against_K)
    energy += B * sp.Rational(against_B) / T
    if sign(energy) != -1:
        raise NotShown(f"the motion leaves the energy {energy}")
    return (), Not((Predicate("passive_wall", (), (K, B, b, T, late)),))
