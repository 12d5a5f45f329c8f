"""Forms for whole delays alone: what serves fractions of a period is left out."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy import Expr

from symhaptic.forms.form import Form, NoForm
from symhaptic.forms.implicit import (
    FractionalPart,
    LargestRequiredDamping,
    LargestWholeRequiredDamping,
    WholePart,
)
from symhaptic.forms.max_stiffness_angle import MaxStiffnessAngle, of_whole
from symhaptic.notation import d, epsilon


def of_whole_delays(form: Form) -> Form:
    """The form for whole delays, outside which a fractional one is then.

    A form without a delay stays as it is.  Raises :class:`NoForm` for one that is about a fraction
    of a period.
    """
    if epsilon in form.arguments:
        raise NoForm(f"{form.name}: is about a fraction of a period, which whole delays have not")
    if d not in form.arguments:
        return form
    return replace(
        form,
        results=tuple((name, _whole(expr)) for name, expr in form.results),
        smooth=tuple(map(_whole, form.smooth)),
        domain=(*form.domain, "d whole"),
        whole=True,
    )


def _whole(expr: Expr) -> Expr:
    """What holds where the fraction is 0."""
    expr = expr.replace(
        lambda e: isinstance(e, sp.Piecewise) and e.args[0][1] == sp.Eq(FractionalPart(d), 0),
        lambda e: e.args[0][0],
    )
    expr = expr.xreplace({FractionalPart(d): sp.S.Zero, WholePart(d): d})
    expr = expr.replace(LargestRequiredDamping, LargestWholeRequiredDamping)
    return expr.xreplace({angle: of_whole(angle) for angle in expr.atoms(MaxStiffnessAngle)})
