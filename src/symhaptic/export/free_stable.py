r"""Whether a loop without a spring is stable behind a whole delay: one quadratic, and one angle.

Without a spring the surplus of :mod:`symhaptic.export.root_count` is not positive at y = 0, and a
wall that is as strong as the device at y = 4, too, is the stronger one everywhere: no loop is
stable then.  Any other wall is as strong as the device once, and what is left of the phase there
decides; chapter s4d_roots_counted_without_spring.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp
from sympy import And, Basic, Max, sqrt

from symhaptic.export.once import rewritten
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.root_count import (
    alpha,
    apart,
    at_minus_one,
    at_the_end,
    beta,
    d,
    faint,
    gamma,
    loss,
    n0,
    n1,
    together,
    turned_off,
    unit,
)
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.forms.form import Form
from symhaptic.forms.root_count import Stable, WholeRoots

ARGUMENTS = alpha, beta, d, n1, n0, at_minus_one, loss, together, apart


def with_free_verdict(form: Form) -> Form:
    """The form with one call for the verdict on a loop without a spring behind a whole delay."""

    def told(verdict: Basic) -> Basic:
        if not isinstance(verdict, Stable):
            return verdict
        roots, *_, spring, _ = verdict.args
        if spring != 0 or not isinstance(roots, WholeRoots):
            return verdict
        given = (s for i, s in enumerate(roots.args) if i != 5)  # there is no spring
        return sp.Function("FreeStable")(*given)

    return replace(
        form,
        results=tuple((name, rewritten(expr, told)) for name, expr in form.results),
    )


def free_stable(precision: Precision = DOUBLE) -> Routine:
    """The angle is that of the crossing, and no turn is left of its phase where none is outside."""
    do, last = Steps(), unit(precision)
    slope, far = do("slope", alpha + beta), do("wall_far", alpha + 2 * beta)
    force, cross = do("force", slope * beta), do("cross", n1 * n0)
    push = do("push", together * alpha)
    c, a = do("near0", push * push), do("square", 1 - loss + cross * force)
    b = do("near1", loss * loss + cross * alpha**2 - together**2 * force)
    size = do("size", sp.Abs(b) + sqrt(Max(b * b + 4 * a * c, 0)))
    y = do("y", choose(b < 0, size / (2 * do.divisor(a)), 2 * c / do.divisor(size)))
    rest = do("rest", Max(4 - y, 0))
    a_off = do("a_off", turned_off(precision, at_minus_one).xreplace({gamma: sp.S.Zero}))
    loop = alpha, slope, far, d, n1, loss, together, apart, 0, 0, a_off
    point = y, rest, y, last / do.nonzero(rest), sp.S.Zero  # the last rounding of 4 - y counts
    turns = do("turns", sp.Function("PhaseTurns")(*point, *loop))
    end, _ = at_the_end(do, far, last, a_off)
    pull = do("weaker", sp.Abs(apart * far) - at_minus_one)
    weak = And(alpha > 0, pull < 0, sp.Not(end), sp.Not(faint(do, precision, sp.S.Zero)))
    return do.routine("FreeStable", "1 where a loop without a spring is stable, else 0",
                      ARGUMENTS, choose(weak, choose(sp.Eq(turns, 0), 1, 0), 0))  # fmt: skip


ROUTINES: tuple[Callable[[], Routine], ...] = ()
PRECISE = (free_stable,)
