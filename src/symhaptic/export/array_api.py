"""Python, for arrays of any library of the Array API standard.

What a routine chooses between becomes functions of their own, which `select` calls with the
elements that count.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType

from sympy import Expr, Symbol

from symhaptic.export.array_prelude import HALVES, PRELUDE, PRODUCT_ERROR, SELFTEST
from symhaptic.export.array_scope import ArrayPrinter, Scope
from symhaptic.export.blocks import functional
from symhaptic.export.branches import lazy
from symhaptic.export.library import Library, known, named, precise
from symhaptic.export.precision import SINGLE
from symhaptic.export.routine import Routine, Step
from symhaptic.export.stages import staged
from symhaptic.export.target import Target, called, describe, vocabulary


class ArrayApi(Target):
    """One module of functions of arrays."""

    name, title, printer = "numpy", "Python (NumPy, or any library of the Array API)", ArrayPrinter
    words = MappingProxyType({"&&": "&", "||": "|", "!": "~"})
    keywords = vocabulary(
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield match case xp np numpy selftest math sys array_namespace device "
        "is_array_api_obj is_lazy_array is_numpy_array is_torch_array arrays deferred elementwise "
        "functools select repeat over step is_jax_array by_value halves square_root product_error "
        "plant work yes no"
    )
    operations = single = called(
        "xp.",
        Infinity="xp.inf",
        NaN="xp.nan",
        Max="xp.where({0} > {1}, {0}, {1})",
        Min="xp.where({0} < {1}, {0}, {1})",
        ProductError="product_error({0}, {1})",
        sqrt="square_root(xp, {0})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        lines = [f'"""{library.title}."""', "", *PRELUDE.splitlines(), "", ""]
        for helper in map(_without_numbers, library.helpers):
            if helper.name == "ProductError":
                lines += [*HALVES.splitlines(), "", "", *PRODUCT_ERROR.splitlines(), "", ""]
                continue
            brief = None
            if precise(helper.name):
                brief = _without_numbers(named(helper.name, known(SINGLE)))
            lines += [*self._helper(helper, brief), "", ""]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += [*self._public(routine, describe(form)), "", ""]
        return {f"{library.name}.py": "\n".join(lines[:-2]) + "\n"}

    def _named(self, symbols: Iterable[Symbol]) -> list[str]:
        return [self.rename(s.name) for s in symbols]

    def _helper(self, routine: Routine, brief: Routine | None) -> list[str]:
        """A function; before it the one for single precision, where that has other steps."""
        name, given = self.call(routine.name), self._named(routine.arguments)
        arguments = ", ".join(["xp", *given])
        head = [f"def {name}({arguments}):", f'    """{routine.about}"""']
        short = ", ".join(["xp", *self._named((brief or routine).arguments)])
        if brief is not None:
            head += [f"    if {given[0]}.dtype == xp.float32:",
                     f"        return {name}_single({short})"]  # fmt: skip
        lines = [*head, *self._body(routine, 1)]
        if brief is None:
            return lines
        single = [f"def {name}_single({short}):", '    """The same in single precision."""']
        single += self._body(brief, 1)
        return [*single, "", "", *lines]

    def _public(self, routine: Routine, about: list[str]) -> list[str]:
        names = self._named(routine.arguments)
        head = f"def {self.call(routine.name)}({', '.join(names)}):"
        lines = ["@by_value", head, f'    """{about[0]}']
        lines += ["", *(f"    {line}" for line in about[1:]), '    """'] if about[1:] else []
        if not about[1:]:
            lines[-1] += '"""'
        if not names:
            return [*lines, "    (xp,) = arrays()", *self._body(routine, 1)]
        lines.append(f"    {', '.join(['xp', *names])} = arrays({', '.join(names)})")
        plant, work = staged(routine)
        for name, part in (("plant", plant), ("work", work)):
            if part is None:
                continue
            given = ", ".join(self._named(part.arguments))
            found = self._body(part, 2)
            lines += ["", f"    def {name}({given}):", *found, ""]
            call = f"elementwise(xp, {name}, {given})"
            results = self._named(Symbol(n) for n, _ in part.results)
            lines.append(
                f"    return {call}" if name == "work" else f"    {', '.join(results)} = {call}"
            )
        return lines

    def _body(self, routine: Routine, depth: int) -> list[str]:
        return Scope(self, functional(lazy(routine))).written(depth)

    def unpacked(self, names: list[str], function: str, args: str) -> list[str]:
        """From a tuple."""
        return [f"{', '.join(names)} = {function}(xp, {args})"]

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
