"""How expressions of arrays are written; each body asks its own scope for names."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean
from sympy.printing.pycode import PythonCodePrinter

from symhaptic.export.printing import Printing

if TYPE_CHECKING:
    from symhaptic.export.array_scope import Scope


class ArrayPrinter(Printing, PythonCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations; each routine sees the namespace of its arrays."""

    scope: Scope

    def _as_ordered_terms(self, expr: Expr, order: str | None = None) -> list[Expr]:
        """SymPy's order, but first a term without a minus, which would be a step of its own."""
        terms = super()._as_ordered_terms(expr, order)
        first = next((t for t in terms if not t.could_extract_minus_sign()), terms[0])
        return [first, *(t for t in terms if t is not first)]

    def _print_Symbol(self, expr: Symbol) -> str:
        return self.scope.name(expr)

    def _print_Function(self, expr: Expr) -> str:
        return self.scope.call(expr)

    def _print_TwoProdError(self, expr: Expr) -> str:
        return self.scope.two_prod_error(*expr.args)

    def _part(self, condition: Boolean) -> str:
        """In brackets: of arrays `&` and `|` are done first."""
        return f"({self._print(condition)})"

    def _print_Piecewise(self, expr: Expr) -> str:
        *choices, (last, always) = expr.args
        if always != sp.true:
            raise ValueError(f"{expr}: has no value where no condition holds")
        text, number = str(self._print(last)), last.is_number
        for value, condition in reversed(choices):
            shown = str(self._print(value))
            if value.is_number and number:
                shown = f"xp.full_like({self.scope.like(condition)}, {shown})"
            text = f"xp.where({self.scope.condition(condition)}, {shown}, {text})"
            number = False
        return text
