"""Python, for arrays of any library of the Array API standard.

What a routine chooses between becomes functions of their own, which `select` calls with the
elements that count.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType

import sympy as sp
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.export import standard
from symhaptic.export.array_precision import of_both
from symhaptic.export.array_prelude import PRELUDE, SELFTEST
from symhaptic.export.array_printing import ArrayPrinter
from symhaptic.export.array_scope import Scope
from symhaptic.export.array_steps import CROSSING, HALVES, PRODUCT_ERROR, SERIES, STEPS
from symhaptic.export.blocks import Block, functional
from symhaptic.export.branches import lazy, told
from symhaptic.export.described import describe
from symhaptic.export.hoist_plant import hoisted
from symhaptic.export.module import Library, known, named, precise
from symhaptic.export.precision import SINGLE
from symhaptic.export.printing import called, vocabulary
from symhaptic.export.routine import Routine, Step, fresh
from symhaptic.export.steps import Steps
from symhaptic.export.target import Target
from symhaptic.export.wrapping import in_brackets, wrapped
from symhaptic.forms.domain import BELOW_PI, LARGEST, LONGEST, STIFFEST
from symhaptic.forms.form import Form

_MOST = {
    LARGEST: Symbol("most.size"),
    STIFFEST: Symbol("most.stiffness"),
    LONGEST: Symbol("most.periods"),
    BELOW_PI: Symbol("most.angle"),
}


class ArrayApi(Target):
    """One module of functions of arrays."""

    name, title, printer = "numpy", "Python (NumPy, or any library of the Array API)", ArrayPrinter
    words = MappingProxyType({"&&": "&", "||": "|", "!": "~"})
    keywords = vocabulary(
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield match case xp np numpy selftest math operator sys array_namespace device "
        "is_array_api_obj is_lazy_array is_numpy_array is_torch_array arrays deferred elementwise "
        "functools select repeat over step is_jax_array by_value halves square_root two_prod_error "
        "plant work inside limits guarded settled most yes no add series value crossing"
    )
    modules = standard.PYTHON
    writes_both = True
    leaves_zeros_out = False  # its helpers are those of both precisions
    operations = single = called(
        "xp.",
        Infinity="xp.inf",
        NaN="xp.nan",
        Max="xp.where({0} > {1}, {0}, {1})",
        Min="xp.where({0} < {1}, {0}, {1})",
        TwoProdError="two_prod_error({0}, {1})",
        sqrt="square_root(xp, {0})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        taken: set[str] = set()
        lines = [f'"""{library.title}."""', "", *PRELUDE.splitlines(), "", ""]
        lines += [*STEPS.splitlines(), "", ""]
        if library.factorials:
            lines += [*SERIES.splitlines(), "", ""]
        for helper in map(_without_numbers, library.helpers):
            if helper.name == "TwoProdError":
                lines += [*HALVES.splitlines(), "", "", *PRODUCT_ERROR.splitlines(), "", ""]
                continue
            brief = None
            if precise(helper.name):
                brief = _without_numbers(named(helper.name, known(SINGLE)))
            lines += [*self._helper(helper, brief), "", ""]
            if helper.name == "NextGuess":
                lines += [*CROSSING.splitlines(), "", ""]
        conditions: dict[Boolean, str] = {}
        for form in library.forms:
            for symbol, condition in zip(form.arguments, form.within, strict=True):
                if condition not in conditions:
                    conditions[condition] = fresh(symbol.name, taken).name
        if conditions:
            lines += [*self._conditions(conditions), "", ""]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += [*self._public(form, routine, conditions, library), "", ""]
        return {f"{library.name}.py": "\n".join(lines[:-2]) + "\n"}

    def _named(self, symbols: Iterable[Symbol]) -> list[str]:
        return [self.rename(s.name) for s in symbols]

    def _helper(self, routine: Routine, brief: Routine | None) -> list[str]:
        """A function; before it the one for single precision, where that has other steps.

        Where only numbers are others, these get names.
        """
        name, given = self.call(routine.name), self._named(routine.arguments)
        arguments = ", ".join(["xp", *given])
        head = [*wrapped([f"def {name}({arguments}):"]), *_documented([routine.about])]
        body = _without_gap(self._body(routine, 1))
        if brief is None:
            return [*head, *_narrow(body)]
        other = _without_gap(self._body(brief, 1))
        if (both := of_both(body, other, given)) is not None:
            found, numbers = both
            if numbers:
                names, double, single = (", ".join(column) for column in zip(*numbers, strict=True))
                pair = (double, single) if len(numbers) == 1 else (f"({double})", f"({single})")
                asked = f"if {given[0]}.dtype == xp.float32 else"
                head += _narrow([f"    {names} = {pair[1]} {asked} {pair[0]}"])
            return [*head, *_narrow(found)]
        head += [f"    if {given[0]}.dtype == xp.float32:",
                 *wrapped([f"        return {name}_single({arguments})"])]  # fmt: skip
        apart = wrapped([f"def {name}_single({arguments}):"])
        apart += _documented(["The same in single precision."])
        return [*apart, *_narrow(other), "", "", *head, *_narrow(body)]

    def _public(
        self, form: Form, routine: Routine, conditions: Mapping[Boolean, str], library: Library
    ) -> list[str]:
        about = describe(form, self.precision)
        names = self._named(routine.arguments)
        head = f"def {self.call(routine.name)}({', '.join(names)}):"
        lines = ["@by_value", *wrapped([head]), *_documented(about)]
        if not names:
            return [*lines, "    (xp,) = arrays()", *self._body(routine, 1)]
        lines.append(f"    {', '.join(['xp', *names])} = arrays({', '.join(names)})")
        plant, work = hoisted(routine)
        for other in library.forms:
            if (made := _in_terms_of(form, other)) is not None:
                plant, work = None, made
                counted = f"{self.call(other.name)}({', '.join(names)})"
                lines.append(f"    {self.rename(made.arguments[0].name)} = {counted}")
        for name, part in (("plant", plant), ("work", work)):
            if part is None:
                continue
            given = ", ".join(self._named(part.arguments))
            block = lazy(part)
            if part is work and form.truth:
                block = told(block)
            lines += ["", f"    def {name}({given}):", *self._written(block, 2)]
            lines.append("")
            if part.arguments[0] not in form.arguments:
                lines.append(f"    return settled(xp, {name}, {given})")
                continue
            inside = " ".join(self._asked(form, part, conditions))
            outside = form.outside if part is work else sp.nan
            shown = {sp.nan: "math.nan", sp.false: "False"}.get(outside, str(outside))
            many = len(part.results)
            call = f'guarded(xp, {name}, "{inside}", {many}, {shown}, {given})'
            results = ", ".join(self._named(Symbol(n) for n, _ in part.results))
            lines.append(f"    return {call}" if part is work else f"    {results} = {call}")
        return [line for long in lines for line in in_brackets(long)]

    def _asked(self, form: Form, part: Routine, conditions: Mapping[Boolean, str]) -> Iterable[str]:
        """What its arguments are asked for, by the names of the conditions."""
        known = zip(form.arguments, form.within, strict=True)
        return (conditions[c] for s, c in known if s in part.arguments)

    def _conditions(self, names: Mapping[Boolean, str]) -> list[str]:
        """A table of all conditions by name."""
        lines = ["INSIDE = {"]
        for condition, name in names.items():
            (symbol,) = condition.free_symbols - set(_MOST)
            shown = Scope(self, ()).printer.doprint(condition.xreplace(_MOST))
            lines.append(f'    "{name}": lambda xp, most, {self.rename(symbol.name)}: {shown},')
        return [*lines, "}", '"""What is true of each argument inside its domain alone."""']

    def _body(self, routine: Routine, depth: int) -> list[str]:
        return self._written(lazy(routine), depth)

    def _written(self, block: Block, depth: int) -> list[str]:
        return Scope(self, functional(block)).written(depth)

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From a tuple."""
        return f"{', '.join(names)} = {function}(xp, {args})"

    def notes(self, library: Library) -> list[str]:
        """What must not be done to it."""
        return ["Never compile it with fastmath=True (Numba) or its like: NaN would be lost."]

    def usage(self, library: Library) -> str:
        """What it needs, and an import of the first function."""
        first = library.public[0].name
        return f"# needs NumPy and array-api-compat\nfrom {library.name} import {first}"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.py."""
        counts = {r.name: len(r.arguments) for r in library.public}
        text = SELFTEST.replace("NAME", library.name).replace("COUNTS", repr(counts))
        text = text.replace("KIND", self.precision.kind.__name__)
        return {"selftest.py": text}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a warning is an error."""
        return [["python", "-W", "error", "selftest.py"]]


def _in_terms_of(form: Form, other: Form) -> Routine | None:
    """The verdict of a form, made of what another one of the same arguments counts, if it is.

    That is its first argument.  Outside of its domain that one counts -1, of which, as of all but
    0, the verdict is no.
    """
    if not form.truth or other.outside != -1 or form.arguments != other.arguments:
        return None
    ((_, own),), ((name, count),) = form.results, other.results
    counts = [value for value, _ in count.args] if isinstance(count, sp.Piecewise) else [count]
    made = own.xreplace(dict.fromkeys(counts, Symbol(name)))
    verdicts = {v for v, _ in made.args} if isinstance(made, sp.Piecewise) else {made}
    if len(verdicts) > 1:
        return None
    (verdict,) = verdicts
    given = (Symbol(name), *(s for s in form.arguments if verdict.has(s)))
    return Steps().routine(form.name, form.title, given, verdict)


def _without_gap(body: list[str]) -> list[str]:
    """A body whose first line is not blank."""
    return body[1:] if body[0] == "" else body


def _narrow(lines: Iterable[str]) -> list[str]:
    return [line for long in lines for line in in_brackets(long)]


def _documented(about: list[str]) -> list[str]:
    """A docstring: its first line, and the others below."""
    head, *text = (
        [f"    {part}" for part in textwrap.wrap(line, 92)]
        for line in (f'"""{about[0]}', *about[1:])
    )
    if not text:
        return [*head, '    """'] if head[1:] else [f'{head[0]}"""']
    return [*head, "", *(line for lines in text for line in lines), '    """']


def _without_numbers(routine: Routine) -> Routine:
    """The routine with the names of mere numbers replaced by these."""
    numbers: dict[Symbol, Expr] = {}
    steps: list[Step] = []
    for step in routine.steps:
        if not isinstance(step, tuple):
            steps.append(step.xreplace(numbers))
            continue
        name, value = step[0], step[1].xreplace(numbers)
        if value.is_number:
            numbers[name] = value
        else:
            steps.append((name, value))
    results = tuple((name, expr.xreplace(numbers)) for name, expr in routine.results)
    return replace(routine, steps=tuple(steps), results=results)


TARGET = ArrayApi()
