"""A language: how it writes numbers, operations, names and expressions, and its files.

One that lacks an operation is refused by name before anything is written.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from copy import copy
from functools import cache
from itertools import accumulate
from types import MappingProxyType
from typing import Any, Self

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.precedence import PRECEDENCE, precedence

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import OPERATIONS, Library, Repeat, Several, brief, code_name
from symhaptic.export.routines import ROUTINES
from symhaptic.forms.stable import Form
from symhaptic.notation import SYMBOLS

_CALL = re.compile(r"[\w:.]+\(\{0\}(, \{1\})?\)")
"""A template that sets each argument apart."""


def bare(text: str) -> str:
    """An expression without the brackets around all of it.

    >>> bare("(a ? b : c)"), bare("(a + b)*(c + d)")
    ('a ? b : c', '(a + b)*(c + d)')
    """
    *inside, after = accumulate(((c == "(") - (c == ")") for c in text), initial=0)
    return text[1:-1] if text[:1] == "(" and after == 0 and all(inside[1:]) else text


_PAIRS = ("Max", "Min", "TwoProdError", "atan2")
"""Those of two arguments; the others have one."""

_LONGEST = 60
"""Letters of a name: Fortran takes 63."""


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


class Target:
    """A language: how it writes numbers, operations, functions, statements and files."""

    name: str
    title: str
    operations: Mapping[str, str]
    """How each of the shared operations is written, its arguments numbered."""
    keywords: frozenset[str]
    modules: frozenset[str] = frozenset()
    """Standard headers, modules and the like, whose names no export may have."""
    choice = "({0} ? {1} : {2})"
    words: Mapping[str, str] = MappingProxyType({})
    """Comparisons, connectives and words of blocks that are written in another way."""
    ignores_case = False
    precision = DOUBLE
    single: Mapping[str, str] | None = None
    """The shared operations in single precision, where the language has it."""

    def at(self, precision: Precision) -> Self:
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

    @property
    def varying(self) -> str:
        """What declares a variable that has a value and changes, in a language with braces."""
        return self.changing or self.real

    writes_both = False
    """Whether one source holds what either precision needs."""
    leaves_zeros_out = True
    """Whether helpers have no arguments that are 0 in all calls."""
    shares = False
    """Whether one statement declares several names, in a language with braces."""
    changing = ""
    """What declares a variable that changes, in a language with braces, if not its type."""
    times = "for (int {0} = 0; {0} < {1}; ++{0}) {{"
    """The head of what is repeated, in such a language."""
    each: tuple[str, ...] = ()
    """The head of the sum of a series: ``{name}`` is 1/n! for n = ``{first}`` down to ``{last}``
    in steps of ``{step}``.  All of these are ``{numbers}``, ``{count}`` of them, whose first
    ``{left_out}`` are left out where they are too small; ``{real}`` is the type."""

    # -- expressions -------------------------------------------------------------------

    def number(self, value: float) -> str:
        """A float that reads back as the same number."""
        return self.precision.written(value)

    def comparison(self, operator: str) -> str:
        """A comparison."""
        return self.words.get(operator, operator)

    def call(self, name: str) -> str:
        """The name of a routine in source code, which is no keyword and not too long for it."""
        plain, parts = code_name(name), name.split("_")
        if len(parts) > 1 and name[0].isupper():
            short = [brief(code_name(part)) for part in parts]
            plain = "_".join(["device"] * (short[0] != "ahead") + short)
        for letters in (3, 2, 1):
            if len(plain) > _LONGEST:
                plain = "_".join(word[:letters] for word in code_name(name).split("_"))
        return f"{plain}_" if self.reserves(plain) else plain

    def called(self, call: Expr) -> str:
        """A call of a routine."""
        args = ", ".join(map(self.printing().whole, call.args))
        return f"{self.call(call.func.__name__)}({args})"

    def rename(self, name: str) -> str:
        """The name of a variable: neither a keyword nor that of a routine."""
        name = brief(name)
        return f"{name}_" if self.reserves(name) or name in _taken() else name

    def reserves(self, name: str) -> bool:
        """Whether a name is a keyword."""
        return (name.lower() if self.ignores_case else name) in self.keywords

    def printing(self) -> Printing:
        """A printer of this target."""
        return Printing(self)

    def series(self, loop: Repeat) -> dict[str, str]:
        """The words that the head of a sum is made of."""
        printer, given = self.printing(), loop.factorials
        first, left_out = str(given[0]), "0"
        if loop.brief != sp.false:
            brief, less = printer.doprint(loop.brief), str(given.index(loop.few))
            first = self.choice.format(brief, loop.few, first)
            left_out = self.choice.format(brief, less, "0")
        assert loop.number is not None
        return {
            "name": self.rename(loop.number.name), "first": first, "last": str(given[-1]),
            "step": str(-given.step), "left_out": left_out, "count": str(len(given)),
            "numbers": ", ".join(map(printer.doprint, loop.numbers)), "real": self.real,
        }  # fmt: skip

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """A statement that gives names to all results of a routine."""
        raise NotImplementedError

    def received(self, several: Several) -> tuple[str, str]:
        """The statement that does so, after what declares more than one, if anything does.

        Nothing where that is done in the expression that asks for them.
        """
        printer, call = self.printing(), several.call
        names = [self.rename(s.name) for s in several.names]
        args = ", ".join(map(printer.whole, call.args))
        return "", self.unpacked(names, self.call(call.func.__name__), args)

    def passed_on(self, several: Several) -> str:
        """The line that returns all results of a routine at once; nothing if there is none."""
        return ""

    def waiting(self) -> list[tuple[str, str]]:
        """Declarations that the statement needs which was written last, with what declares them."""
        return []

    def ended(self, ends: list[str], results: list[str]) -> list[str]:
        """The lines that return the results, which are given as they are written."""
        return [end.format(*results) for end in ends]

    samples = False
    """Whether the numbers of a device are a record that functions of walls take."""

    proves = False
    """Whether an export has goals for Gappa, of the rounding errors of its public routines."""

    # -- files ---------------------------------------------------------------------------

    def table(self, library: Library) -> str:
        """1/n! from n = 0 on, as far as a library needs them; nothing if it needs none."""
        printer = self.printing()
        return ", ".join(printer.doprint(1 / sp.factorial(n)) for n in range(library.factorials))

    def source(self, library: Library) -> dict[str, str]:
        """The files that somebody else's program uses, by name."""
        raise NotImplementedError

    def package(self, library: Library) -> dict[str, str]:
        """What those who use the language find a library with, and examples."""
        return {}

    def selftest(self, library: Library) -> dict[str, str]:
        """A program that reads vectors.txt and exits with 1 where a value is missed."""
        raise NotImplementedError

    def commands(self, name: str) -> list[list[str]]:
        """What compiles and runs the self-test, in the folder that was written."""
        raise NotImplementedError

    def usage(self, library: Library) -> str:
        """A line or two of source that call the first function."""
        raise NotImplementedError

    def notes(self, library: Library) -> list[str]:
        """Lines of the README on what is special in this language."""
        return []


@cache
def _taken() -> frozenset[str]:
    """The names of all routines, which no variable may have."""
    return frozenset(map(code_name, ROUTINES))


class Printing(CodePrinter):  # type: ignore[misc]
    """Expressions as source code, in the words of a language."""

    def __init__(self, target: Target) -> None:
        super().__init__()
        self.target = target

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
        return self.target.called(expr)

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


# -- A function in lines of plain text: what it gives, its arguments, and where it gives it ------


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
        lines.append(f"{beyond(form)}, and if an argument is NaN or {sizes(form, precision)}.")
    return lines


def _result(name: str) -> str:
    """A result and, if it is a quantity of the loop, what that is."""
    known = SYMBOLS.get(name)
    return name if known is None else f"{name}, {known.meaning} [{known.unit}]"


def beyond(form: Form) -> str:
    """What a function returns outside its domain, which the line before states.

    >>> from symhaptic.forms.stable import form
    >>> beyond(form("is_stable")), beyond(form("discretize"))
    ('False outside it', 'NaN outside it')
    """
    domain = "it" if form.domain else "the domain"
    return f"{'NaN' if form.outside is sp.nan else str(form.outside)} outside {domain}"


def sizes(form: Form, precision: Precision) -> str:
    """The sizes beyond which an argument is out of range."""
    names = {symbol.name for symbol in form.arguments}
    some = [f"larger than {_power_of_ten(precision.largest)}"] * bool(
        names - {"d", "epsilon", "theta"}
    )
    ends: dict[float, list[str]] = {precision.largest: []}
    for name, end in (("gamma", precision.stiffest), ("d", precision.longest)):
        ends.setdefault(end, []).extend({name} & names)
    del ends[precision.largest]
    some += [
        f"{' or '.join(of)} larger than {_power_of_ten(end)}" for end, of in ends.items() if of
    ]
    return " or ".join(some or ["infinite"])


def _power_of_ten(number: float) -> str:
    """A power of ten in few letters."""
    return f"{number:g}".replace("e+0", "e").replace("e+", "e")
