"""What every target language has in common: operations, names, the order of work.

A target states how it writes each of the shared operations; one that it does not have is refused
by name before anything is written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING

import sympy as sp
from sympy import Expr

from symhaptic.export.code_names import brief, code_name
from symhaptic.export.once import parts
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Repeat, Routine, Several

if TYPE_CHECKING:
    from symhaptic.export.module import Library
    from symhaptic.export.printing import Printing
    from symhaptic.export.rounding import Goal

OPERATIONS = (
    "Abs", "Infinity", "Max", "Min", "NaN", "TwoProdError", "atan2", "cos", "exp", "expm1", "floor",
    "sin", "sqrt", "tan",
)  # fmt: skip
"""Beside sums, products, quotients, comparisons and choices, what formulas are written with."""

_PAIRS = ("Max", "Min", "TwoProdError", "atan2")
"""Those of two arguments; the others have one."""

_LONGEST = 60
"""Letters of a name: Fortran takes 63."""


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


class Target:
    """A language: how it writes numbers, operations, functions, and whole files."""

    name: str
    title: str
    operations: Mapping[str, str]
    """How each of the shared operations is written, its arguments numbered."""
    keywords: frozenset[str]
    modules: frozenset[str] = frozenset()
    """Standard headers, modules and the like, whose names no export may have."""
    printer: type[Printing]
    choice = "({0} ? {1} : {2})"
    words: Mapping[str, str] = MappingProxyType({})
    """Comparisons, connectives and words of blocks that are written in another way."""
    ignores_case = False
    taken: Callable[[], frozenset[str]] = frozenset
    """The names of all routines, which no variable may have; handed in with the list of targets."""
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

    def rename(self, name: str) -> str:
        """The name of a variable: neither a keyword nor that of a routine."""
        name = brief(name)
        return f"{name}_" if self.reserves(name) or name in self.taken() else name

    def reserves(self, name: str) -> bool:
        """Whether a name is a keyword."""
        return (name.lower() if self.ignores_case else name) in self.keywords

    def printing(self) -> Printing:
        """A printer of this target."""
        printer = self.printer()
        printer.target = self
        return printer

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

    def table(self, library: Library) -> str:
        """1/n! from n = 0 on, as far as a library needs them; nothing if it needs none."""
        printer = self.printing()
        return ", ".join(printer.doprint(1 / sp.factorial(n)) for n in range(library.factorials))

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

    # -- files -------------------------------------------------------------------------

    def source(self, library: Library) -> dict[str, str]:
        """The files that somebody else's program uses, by name."""
        raise NotImplementedError

    def proved(self, routine: Routine) -> list[Goal]:
        """What is proved of the rounding errors of a public routine."""
        return []

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
def calls(routine: Routine) -> frozenset[str]:
    """Names of the routines that a routine calls."""
    functions = (f for f in parts(routine.expressions) if isinstance(f, sp.Function))
    found = {f.func.__name__ for f in functions}
    return frozenset(found - {*OPERATIONS, "Piecewise", "Divisor"})


@cache
def operations(routine: Routine) -> frozenset[str]:
    """The shared operations that a routine needs."""
    atoms = parts(routine.expressions)
    names = {type(a).__name__ for a in atoms}
    roots = any(a.is_Pow and abs(a.args[1]) == sp.S.Half for a in atoms if isinstance(a, Expr))
    return frozenset(names & set(OPERATIONS)) | ({"sqrt"} if roots else set())
