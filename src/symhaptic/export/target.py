"""What every target language has in common: operations, names, the order of work.

A target states how it writes each of the shared operations; one that it does not have is refused
by name before anything is written.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from copy import copy
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy import Expr, Symbol
from sympy.printing.codeprinter import CodePrinter

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine
from symhaptic.notation import SYMBOLS

if TYPE_CHECKING:
    from symhaptic.export.library import Library
    from symhaptic.model.stable import Form

OPERATIONS = (
    "Abs", "Infinity", "Max", "Min", "NaN", "ProductError", "atan2", "cos", "exp", "expm1", "floor",
    "sin", "sqrt", "tan",
)  # fmt: skip
"""Beside sums, products, quotients, comparisons and choices, what formulas are written with."""

_PAIRS = ("Max", "Min", "ProductError", "atan2")
"""Those of two arguments; the others have one."""

_LONGEST = 60
"""Letters of a name: Fortran takes 63."""

_CODE_NAMES = {"C": "cosh_root", "S": "sinhc_root"}


def vocabulary(text: str) -> frozenset[str]:
    """The words of a text."""
    return frozenset(text.split())


def called(prefix: str, suffix: str = "", **special: str) -> Mapping[str, str]:
    """The shared operations as calls, with a prefix or a suffix; some written in their own way."""
    plain = {"Abs": "abs", "Max": "max", "Min": "min"}
    table = {
        name: f"{prefix}{plain.get(name, name)}{suffix}({'{0}, {1}' if name in _PAIRS else '{0}'})"
        for name in OPERATIONS
    }
    return MappingProxyType(table | special)


class Refused(ValueError):
    """A request that cannot be met; the message is one line."""


def code_name(name: str) -> str:
    """The name of a routine in source code.

    >>> code_name("FallSeries"), code_name("C")
    ('fall_series', 'cosh_root')
    """
    return _CODE_NAMES.get(name, re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower())


def routine_name(name: str) -> str:
    """The name of a routine, from that in source code.

    >>> routine_name("fall_series"), routine_name("cosh_root")
    ('FallSeries', 'C')
    """
    special = {code: own for own, code in _CODE_NAMES.items()}
    return special.get(name) or "".join(part.capitalize() for part in name.split("_"))


@cache
def _taken() -> frozenset[str]:
    """The names of all routines."""
    from symhaptic.export.library import known

    return frozenset(map(code_name, known()))


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

    _print_Add, _print_Mul = CodePrinter._print_Add, CodePrinter._print_Mul  # noqa: N815

    def _operation(self, expr: Expr) -> str:
        return self._written(type(expr).__name__, expr.args)

    def _written(self, name: str, args: Iterable[Expr]) -> str:
        template = self.target.operations.get(name)
        if template is None:
            raise Refused(f"{self.target.name}: has no operation {name!r}")
        return template.format(*(self._print(a) for a in args), real=self.target.real)

    _print_Abs = _print_ProductError = _print_atan2 = _print_cos = _print_exp = _operation  # noqa: N815
    _print_expm1 = _print_floor = _print_sin = _print_tan = _operation

    def _print_NaN(self, expr: Expr) -> str:
        return self._written("NaN", ())

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
        args = ", ".join(self._print(a) for a in expr.args)
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
        left, right = (self._print(side) for side in expr.args)
        return f"{left} {self.target.comparison(expr.rel_op)} {right}"

    def _print_And(self, expr: Expr) -> str:
        return self._joined(expr, "&&")

    def _print_Or(self, expr: Expr) -> str:
        return self._joined(expr, "||")

    def _print_Not(self, expr: Expr) -> str:
        return f"{self.target.words.get('!', '!')}({self._print(expr.args[0])})"

    def _joined(self, expr: Expr, word: str) -> str:
        parts = sorted((self._print(a) for a in expr.args), key=str)
        return f" {self.target.words.get(word, word)} ".join(f"({p})" for p in parts)

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


class Target:
    """A language: how it writes numbers, operations, functions, and whole files."""

    name: str
    title: str
    operations: Mapping[str, str]
    """How each of the shared operations is written, its arguments numbered."""
    keywords: frozenset[str]
    printer: type[Printing]
    choice = "({0} ? {1} : {2})"
    words: Mapping[str, str] = MappingProxyType({})
    """Comparisons and connectives that are written in another way."""
    ignores_case = False
    precision = DOUBLE
    single: Mapping[str, str] | None = None
    """The shared operations in single precision, where the language has it."""

    def at(self, precision: Precision) -> Target:
        """The same language in another precision."""
        if precision is self.precision:
            return self
        if self.single is None:
            raise Refused(f"--precision {precision.name}: {self.title} is exported in double only")
        other = copy(self)
        other.precision, other.operations = precision, self.single
        return other

    @property
    def real(self) -> str:
        """What a float is called in languages with the types of C."""
        return "double" if self.precision is DOUBLE else "float"

    @property
    def late(self) -> str:
        """What declares a variable that gets its value later."""
        return "let"

    changing = ""
    """What declares a variable that changes, in a language with braces, if not its type."""
    times = "for (int {0} = 0; {0} < {1}; ++{0}) {{"
    """The head of what is repeated, in such a language."""

    # -- expressions -------------------------------------------------------------------

    def number(self, value: float) -> str:
        """A float that reads back as the same number."""
        return self.precision.written(value)

    def comparison(self, operator: str) -> str:
        """A comparison."""
        return self.words.get(operator, operator)

    def call(self, name: str) -> str:
        """The name of a routine in source code, which is no keyword and not too long for it."""
        plain = code_name(name)
        if len(plain) > _LONGEST:
            plain = "_".join(word[:3] for word in plain.split("_"))
        return f"{plain}_" if self.reserves(plain) else plain

    def rename(self, name: str) -> str:
        """The name of a variable: neither a keyword nor that of a routine."""
        return f"{name}_" if self.reserves(name) or name in _taken() else name

    def reserves(self, name: str) -> bool:
        """Whether a name is a keyword."""
        return (name.lower() if self.ignores_case else name) in self.keywords

    def printing(self) -> Printing:
        """A printer of this target."""
        printer = self.printer()
        printer.target = self
        return printer

    def unpacked(self, names: list[str], function: str, args: str) -> list[str]:
        """Statements that give names to all results of a routine."""
        raise NotImplementedError

    # -- files -------------------------------------------------------------------------

    def source(self, library: Library) -> dict[str, str]:
        """The files that somebody else's program uses, by name."""
        raise NotImplementedError

    def selftest(self, library: Library) -> dict[str, str]:
        """A program that reads vectors.txt and exits with 1 where a value is missed."""
        raise NotImplementedError

    def commands(self, name: str) -> list[list[str]]:
        """What compiles and runs the self-test, in the folder that was written."""
        raise NotImplementedError

    def usage(self, library: Library) -> str:
        """A line or two of source that call the first function."""
        raise NotImplementedError


def describe(form: Form) -> list[str]:
    """A function in lines of plain text: what it gives, its arguments and its domain."""
    lines = [f"{form.title}."]
    for symbol in form.arguments:
        known = SYMBOLS[symbol.name]
        lines.append(f"{symbol.name}: {known.meaning} [{known.unit}]")
    if form.domain:
        lines.append(f"Domain: {', '.join(form.domain)}.")
    return lines


@cache
def calls(routine: Routine) -> frozenset[str]:
    """Names of the routines that a routine calls."""
    found = {f.func.__name__ for e in routine.expressions for f in e.atoms(sp.Function)}
    return frozenset(found - {*OPERATIONS, "Piecewise"})


@cache
def operations(routine: Routine) -> frozenset[str]:
    """The shared operations that a routine needs."""
    atoms = {a for e in routine.expressions for a in sp.preorder_traversal(e)}
    names = {type(a).__name__ for a in atoms}
    roots = any(a.is_Pow and abs(a.args[1]) == sp.S.Half for a in atoms if isinstance(a, Expr))
    return frozenset(names & set(OPERATIONS)) | ({"sqrt"} if roots else set())
