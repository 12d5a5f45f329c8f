"""How expressions are written in every language."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import accumulate
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.precedence import PRECEDENCE, precedence

from symhaptic.export.target import Refused

if TYPE_CHECKING:
    from symhaptic.export.target import Target


_CALL = re.compile(r"[\w:.]+\(\{0\}(, \{1\})?\)")
"""A template that sets each argument apart."""


def bare(text: str) -> str:
    """An expression without the brackets around all of it.

    >>> bare("(a ? b : c)"), bare("(a + b)*(c + d)")
    ('a ? b : c', '(a + b)*(c + d)')
    """
    *inside, after = accumulate(((c == "(") - (c == ")") for c in text), initial=0)
    return text[1:-1] if text[:1] == "(" and after == 0 and all(inside[1:]) else text


class Printing(CodePrinter):  # type: ignore[misc]
    """What all printers share; a target's own printer derives from this and from SymPy's."""

    target: Target

    def doprint(self, expr: Expr, assign_to: Any = None) -> str:
        """An expression as source code, on one line."""
        return str(self._print(expr))

    def parenthesize(self, item: Expr, level: int, strict: bool = False) -> str:
        """As SymPy does, but without brackets round a number."""
        if item.is_Rational and item >= 0:
            return str(self._print(item))
        return str(super().parenthesize(item, level, strict))

    def whole(self, expr: Expr) -> str:
        """An expression as source code, where nothing stands beside it."""
        return bare(self.doprint(expr))

    _print_Mul = CodePrinter._print_Mul  # noqa: N815

    def _as_ordered_terms(self, expr: Expr, order: str | None = None) -> list[Expr]:
        """SymPy's order, but x - y for -y + x, which is the same float."""
        first, second, *others = super()._as_ordered_terms(expr, order)
        if _negative(first) and not _negative(second):
            return [second, first, *others]
        return [first, second, *others]

    def _print_Add(self, expr: Expr, order: str | None = None) -> str:
        text = ""
        for term in self._as_ordered_terms(expr, order):
            shown = str(self._print(term))
            if term.is_Pow:
                shown = bare(shown)
            elif term.is_Add or precedence(term) < PRECEDENCE["Add"]:
                shown = f"({shown})"
            text += f" - {shown[1:]}" if shown.startswith("-") else f" + {shown}"
        return f"-{text[3:]}" if text.startswith(" -") else text[3:]

    def _operation(self, expr: Expr) -> str:
        return self._written(type(expr).__name__, expr.args)

    def _written(self, name: str, args: Iterable[Expr]) -> str:
        template = self.target.operations.get(name)
        if template is None:
            raise Refused(f"{self.target.name}: has no operation {name!r}")
        shown = [str(self._print(a)) for a in args]
        if _CALL.fullmatch(template):
            shown = [bare(text) for text in shown]
        return template.format(*shown, real=self.target.real)

    _print_Abs = _print_TwoProdError = _print_atan2 = _print_cos = _print_exp = _operation  # noqa: N815
    _print_expm1 = _print_floor = _print_sin = _print_tan = _operation

    def _print_NaN(self, expr: Expr) -> str:
        return self._written("NaN", ())

    def _print_BooleanFalse(self, expr: Boolean) -> str:
        return self.target.words.get("false", "false")

    def _print_Infinity(self, expr: Expr) -> str:
        return self._written("Infinity", ())

    def _folded(self, expr: Expr) -> str:
        """Max and Min of two or more, by pairs."""
        name, (first, *others) = type(expr).__name__, expr.args
        text = str(self._print(first))
        template = self.target.operations.get(name)
        if template is None:
            raise Refused(f"{self.target.name}: has no operation {name!r}")
        for other in others:
            text = template.format(text, self._print(other))
        return text

    _print_Max = _print_Min = _folded  # noqa: N815

    def _print_Function(self, expr: Expr) -> str:
        args = ", ".join(self.whole(a) for a in expr.args)
        return f"{self.target.call(expr.func.__name__)}({args})"

    def _number(self, expr: Expr) -> str:
        return self.target.number(float(expr))

    _print_Integer = _print_Rational = _print_Half = _print_Pi = _print_Float = _number  # noqa: N815
    _print_One = _print_Zero = _print_NegativeOne = _number  # noqa: N815

    def _print_Pow(self, expr: Expr, rational: bool = False) -> str:
        base, power = expr.args
        if abs(power) == sp.S.Half:
            root = self._written("sqrt", [base])
            return root if power > 0 else f"{self.target.number(1.0)}/{root}"
        times = int(power)
        factor = self.parenthesize(base, 60)
        product = "*".join([factor] * abs(times))
        if times > 0:
            return f"({product})" if times > 1 else factor
        return f"{self.target.number(1.0)}/{f'({product})' if times < -1 else factor}"

    def _print_Relational(self, expr: Expr) -> str:
        left, right = (bare(self._print(s)) if s.is_Pow else self._print(s) for s in expr.args)
        return f"{left} {self.target.comparison(expr.rel_op)} {right}"

    def _print_And(self, expr: Expr) -> str:
        return self._joined(expr, "&&")

    def _print_Or(self, expr: Expr) -> str:
        return self._joined(expr, "||")

    def _print_Not(self, expr: Expr) -> str:
        return f"{self.target.words.get('!', '!')}({self._print(expr.args[0])})"

    def _joined(self, expr: Expr, word: str) -> str:
        parts = sorted(map(self._part, expr.args), key=lambda text: text.translate(_LOW_FIRST))
        return f" {self.target.words.get(word, word)} ".join(parts)

    def _part(self, condition: Boolean) -> str:
        """A condition beside others; a comparison is done before it is joined."""
        text = str(self._print(condition))
        return f"({text})" if isinstance(condition, sp.And | sp.Or) else text

    def _print_Piecewise(self, expr: Expr) -> str:
        *choices, (last, always) = expr.args
        if always != sp.true:
            raise ValueError(f"{expr}: has no value where no condition holds")
        text = str(self._print(last))
        for value, condition in reversed(choices):
            text = self.target.choice.format(self._print(condition), self._print(value), text)
        return text

    def _print_Symbol(self, expr: Symbol) -> str:
        return self.target.rename(expr.name)


_LOW_FIRST = str.maketrans("<>", "><")
"""Of two bounds of a number the lower one stands first."""


def _negative(term: Expr) -> bool:
    return bool(term.as_coeff_Mul()[0].is_negative)
