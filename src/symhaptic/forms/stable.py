r"""Forms for computing: the same formulas, made so that no digits are lost.

A form is stated for one scene, with the arguments that the scene has, and with the expression
that it equals, derived from first principles for the same scene; ``written_out`` and the normal
form prove that both are the same.  Nothing is divided that can be 0/0, at no stiffness, at no
damping, at critical damping, or at a vanishing angle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache

import sympy as sp
from sympy import Expr

from symhaptic.forms.device_forms import (
    characteristic_polynomial,
    discretize,
    discretize_fractional,
)
from symhaptic.forms.form import Form, NoForm
from symhaptic.forms.implicit import (
    DelayMargin,
    FractionalPart,
    LargestRequiredDamping,
    LargestWholeRequiredDamping,
    MaxStiffnessAngle,
    WholePart,
    of_whole,
)
from symhaptic.forms.passivity_forms import (
    linear_limit,
    max_passive_stiffness,
    passivity_boundary,
    passivity_margin,
    passivity_margin_at,
)
from symhaptic.forms.stability_forms import (
    is_stable,
    max_stable_stiffness,
    stability_boundary,
    stability_conditions,
    unstable_roots,
)
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import d, epsilon

FORMS: dict[str, Callable[..., Form]] = {
    f.__name__: f
    for f in (
        discretize,
        discretize_fractional,
        characteristic_polynomial,
        is_stable,
        unstable_roots,
        stability_conditions,
        stability_boundary,
        max_stable_stiffness,
        passivity_margin_at,
        passivity_margin,
        passivity_boundary,
        max_passive_stiffness,
        linear_limit,
    )
}

STATEMENTS = {
    "discretize": ("eq14", "eq12"),
    "characteristic_polynomial": ("eq18",),
    "passivity_margin_at": ("eq5",),
    "passivity_boundary": ("eq27", "eq7"),
    "max_passive_stiffness": ("eq11",),
    "linear_limit": ("eq25", "eq24", "eq9"),
}
"""Formulas of the paper that the forms compute, in the dimensionless parameters of Table I.

(7), (12), (24) and (9) are (27), (14) and (25) in SI units: K = alpha m/T^2, B = beta m/T.
"""

AS_DERIVED = ("eq31",)
"""Formulas in which nothing cancels: their derived form, in SI units, keeps its digits."""

INSTEAD = {
    "eq4": "it is a condition on any H(z); 'eq5' is the one for a delayed wall",
    "eq31": "lambdify('eq31') gives it in Python, of T in s, b in Ns/m and m in kg",
}
"""What to ask for in place of a formula that has no stable form."""


def without_form(id: str) -> str:
    """What to do about a numbered formula of the paper that has no stable form."""
    derived = f"lambdify({id!r}, form='derived') gives it in Python, of its own arguments"
    return f"{id!r} has no stable form; {INSTEAD.get(id, derived)}"


FOR_ONE_DELAY = ("characteristic_polynomial", "stability_conditions")
"""Forms that are made for one whole delay."""


@cache
def form(name: str, parts: Parts = FULL, delay: int | None = None) -> Form:
    """The form of one function, for one scene and, where it needs one, for one whole delay.

    Raises :class:`NoForm` where the scene has not what it is about.
    """
    return FORMS[name](parts, delay) if name in FOR_ONE_DELAY else FORMS[name](parts)


def forms(parts: Parts = FULL, delay: int | None = None) -> Iterator[Form]:
    """All forms of a scene, those left out that it has not."""
    for name in FORMS:
        try:
            yield form(name, parts, delay)
        except NoForm:
            continue


__all__ = [
    "FORMS",
    "FOR_ONE_DELAY",
    "STATEMENTS",
    "Form",
    "NoForm",
    "form",
    "forms",
    "without_form",
]


# -- Forms for whole delays alone: what serves fractions of a period is left out ------------------


def of_whole_delays(form: Form) -> Form:
    """The form for whole delays, outside which a fractional one is then.

    A form without a delay stays as it is.  Raises :class:`NoForm` for one that is about a fraction
    of a period.
    """
    margin = any(isinstance(expr, DelayMargin) for _, expr in form.results)
    if epsilon in form.arguments or margin:
        raise NoForm(f"{form.name}: needs fractional delays; leave --whole-delays out")
    if d not in form.arguments:
        return form
    return replace(
        form,
        results=tuple((name, _whole(expr)) for name, expr in form.results),
        smooth=tuple(map(_whole, form.smooth)),
        domain=(*form.domain, "d an integer"),
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
