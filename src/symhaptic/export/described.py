"""A function in lines of plain text: what it gives, its arguments, and where it gives it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.notation import SYMBOLS

if TYPE_CHECKING:
    from symhaptic.forms.stable import Form


def describe(form: Form, precision: Precision = DOUBLE) -> list[str]:
    """A function in lines of plain text: what it gives, its arguments, results and domain."""
    lines = [f"{form.title}."]
    for symbol in form.arguments:
        known = SYMBOLS[symbol.name]
        lines.append(f"{symbol.name}: {known.meaning} [{known.unit}]")
    if len(form.results) > 1:
        lines.append(f"Results: {'; '.join(_result(name) for name, _ in form.results)}.")
    if form.domain:
        lines.append(f"Domain: {', '.join(form.domain)}.")
    if form.arguments:
        lines.append(f"{beyond(form)}, and where an argument is NaN or {sizes(form, precision)}.")
    return lines


def _result(name: str) -> str:
    """A result and, if it is a quantity of the loop, what that is."""
    known = SYMBOLS.get(name)
    return name if known is None else f"{name}, {known.meaning} [{known.unit}]"


def beyond(form: Form) -> str:
    """What a function gives outside its domain.

    >>> from symhaptic.forms.stable import form
    >>> beyond(form("is_stable")), beyond(form("discretize"))
    ('False outside', 'NaN outside')
    """
    return f"{'NaN' if form.outside is sp.nan else str(form.outside)} outside"


def sizes(form: Form, precision: Precision) -> str:
    """How large an argument has to be to be outside."""
    names = {symbol.name for symbol in form.arguments}
    some = [f"larger than {_short(precision.largest)}"] * bool(names - {"d", "epsilon", "theta"})
    ends: dict[float, list[str]] = {precision.largest: []}
    for name, end in (("gamma", precision.stiffest), ("d", precision.longest)):
        ends.setdefault(end, []).extend({name} & names)
    del ends[precision.largest]
    some += [f"{' or '.join(of)} larger than {_short(end)}" for end, of in ends.items() if of]
    return " or ".join(some or ["infinite"])


def _short(number: float) -> str:
    """A power of ten in few letters."""
    return f"{number:g}".replace("e+0", "e").replace("e+", "e")
