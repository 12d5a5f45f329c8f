"""The device behind a fraction of a period as one routine, which several functions call.

Both parts of the period are devices of their own, with a period so many times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp
from sympy import Basic, Expr

from symhaptic.export.fused import LateApart, LateFirst, LateKick, LateLast, merged
from symhaptic.export.once import parts, rewritten
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine
from symhaptic.export.shared import routine
from symhaptic.forms import fractional_delay
from symhaptic.forms.entire_device import PlantN0, PlantN1
from symhaptic.forms.form import Form
from symhaptic.forms.response import HalfTurned
from symhaptic.forms.slopes import Kick
from symhaptic.model.parts import FULL
from symhaptic.notation import delta, epsilon, gamma

_PART = sp.Symbol("part")
"""The fraction; products are done in the order of names."""


def _numbers(part: Expr) -> tuple[Expr, ...]:
    """m2 - m1 + m0, m2, what an impulse moves in the rest of the period, and m0."""
    rest, begun = (fractional_delay.brief(FULL, time) for time in (1 - epsilon, epsilon))
    first, last = fractional_delay.ends(FULL)
    found = fractional_delay.at_minus_one(FULL, rest, begun), first, rest.kick, last
    return tuple(number.xreplace({epsilon: part}) for number in found)


def late_device() -> Routine:
    """In the order of their names in ``fused``."""
    names = "apart", "m2", "kicked", "m0"
    results = tuple(zip(names, _numbers(_PART), strict=True))
    about = (
        "m2 - m1 + m0, m2, an impulse's way in the rest of the period, m0, behind a fraction of it"
    )
    found = merged(routine(Form("late_device", about, (gamma, delta), results, tuple, ())))
    arguments = gamma, delta, _PART
    return replace(found, name="LateDevice", arguments=arguments, within=(), record="Delayed")


def with_late_device(form: Form) -> Form:
    """The form with one call for these numbers, where it asks the parts of a period for no more."""
    gaps = {p for p in parts(form.expressions) if isinstance(p, HalfTurned)}
    fractions = {gap.args[-1] for gap in gaps}
    if len(fractions) != 1:
        return form
    (part,) = fractions
    apart, first, kick, last = _numbers(part)
    if apart not in gaps:
        return form
    ends = {
        frozenset(first.args): LateFirst(gamma, delta, part),
        frozenset(kick.args): LateKick(gamma, delta, part),
        frozenset(last.args): LateLast(gamma, delta, part),
    }

    def told(product: Basic) -> Basic:
        if not product.is_Mul:
            return product
        for factors, number in ends.items():
            if factors <= set(product.args):
                return sp.Mul(*set(product.args) - factors, number)
        return product

    called = {apart: LateApart(gamma, delta, part)}
    found = [rewritten(e.xreplace(called), told) for e in form.expressions]
    left = (call for call in parts(found) if isinstance(call, Kick | PlantN0 | PlantN1))
    if any(call.args != (gamma, delta) for call in left):
        return form
    names = (name for name, _ in form.results)
    return replace(form, results=tuple(zip(names, found, strict=True)))


ROUTINES = (late_device,)
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
