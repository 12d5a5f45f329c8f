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
from sympy import And, Basic, Max, atan2, pi, sqrt

from symhaptic.export.once import rewritten
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.root_count import (
    alpha,
    apart,
    at_minus_one,
    beta,
    d,
    faint,
    loss,
    n0,
    n1,
    together,
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
        given = (s for i, s in enumerate(roots.args) if i != 5)  # at z = 1 the device has no force
        return sp.Function("FreeStable")(*given)

    return replace(
        form,
        results=tuple((name, rewritten(expr, told)) for name, expr in form.results),
    )


def free_stable(precision: Precision = DOUBLE) -> Routine:
    """Of small angles, and beyond y = 2 of what is left to half turns, so that nothing cancels."""
    do = Steps()
    slope, far = do("slope", alpha + beta), do("wall_far", alpha + 2 * beta)
    force, cross = do("force", slope * beta), do("cross", n1 * n0)
    push, pull = do("push", together * alpha), do("pull", apart * far)
    c, a = do("near0", push * push), do("square", 1 - loss + cross * force)
    b = do("near1", loss * loss + cross * alpha**2 - together**2 * force)
    size = do("size", sp.Abs(b) + sqrt(Max(b * b + 4 * a * c, 0)))
    y = do("y", choose(b < 0, size / (2 * do.divisor(a)), 2 * c / do.divisor(size)))
    s, r = do("sine", sqrt(y)), do("cosine", sqrt(Max(4 - y, 0)))
    late, across = y > 2, do("across", 2 * s * r)
    side = do("side", choose(late, -1, 1))
    moved = do("moved", atan2(n1 * across, side * (together * r * r - apart * y)))
    pushed = do("turned", atan2(slope * across, side * (alpha * r * r - far * y)))
    lost = do("lost", atan2(loss * r, (2 - loss) * s))
    half = do("half", atan2(choose(late, r, s), choose(late, s, r)))
    delayed = do("delayed", 2 * (d + 2) * half)
    turns = do("turns", d + choose(slope < 0, 2, 0))
    early = do("early", moved + pushed + choose(late, pi * turns - lost, lost) - delayed)
    early = do("early", choose(early * side > 0, 1, 0))
    weak = And(alpha > 0, sp.Abs(pull) < at_minus_one, sp.Not(faint(do, precision)))
    return do.routine("FreeStable", "1 where a loop without a spring is stable, else 0",
                      ARGUMENTS, choose(weak, early, 0))  # fmt: skip


ROUTINES: tuple[Callable[[], Routine], ...] = ()
PRECISE = (free_stable,)
