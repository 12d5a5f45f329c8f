"""Complex terms as Rocq writes them, over Coquelicot's ``C``.

The operations are those of ``C`` and a real symbol is taken into it by itself, so that most of a
term looks as a real one does; a power with a symbol in its exponent is ``Craised``.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy import Expr

from symhaptic.rocq.terms import Names, NotPrinted, Real, complex_, printed_by, real_text


class Complex(Real):
    """Prints complex terms."""

    def _print_Function(self, expr: Any) -> str:
        if not self.complex_(expr):
            return real_text(expr, self.names)
        if isinstance(expr, sp.exp):
            return f"Cexp({self._print(expr.args[0])})"
        if isinstance(expr, sp.conjugate):
            return f"Cconj({self._print(expr.args[0])})"
        if isinstance(expr, (sp.re, sp.im)):
            return f"{expr.func.__name__.capitalize()}({self._print(expr.args[0])})"
        raise NotPrinted(f"{expr.func.__name__} of a complex term")

    _print_exp = _print_log = _print_Abs = _print_Function  # noqa: N815
    _print_re = _print_im = _print_conjugate = _print_Function

    def complex_(self, expr: Expr) -> bool:
        """Whether a part is complex, a bound symbol of a polynomial included."""
        return complex_(expr) or bool(self.names.as_complex & expr.free_symbols)

    def _raised(self, base: Expr, power: Expr) -> str:
        if power == 1 or (power.is_Integer and power > 0):
            return super()._raised(base, power)
        if not self.complex_(base) and not self.complex_(power) and power.is_Rational:
            return super()._raised(base, power)
        return f"Craised ({self._print(base)}) ({self._print(power)})"

    def inside(self, base: Expr) -> str:
        """A base, in brackets unless it is a name or an application."""
        plain = base.is_Function and not self.complex_(base)
        return super().inside(base) if plain or base.is_Symbol else f"({self._print(base)})"


def complex_text(expr: Expr, names: Names) -> str:
    """A complex term."""
    return printed_by(Complex, expr, names)
