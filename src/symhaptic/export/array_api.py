"""Python, for arrays of any library of the Array API standard.

What a routine chooses between becomes functions of their own, which `select` calls with the
elements that count.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType

import sympy as sp
from sympy import Expr, Piecewise, Symbol
from sympy.printing.pycode import PythonCodePrinter

from symhaptic.export.array_prelude import HALVES, PRELUDE, PRODUCT_ERROR, SELFTEST
from symhaptic.export.library import Library
from symhaptic.export.routine import Assign, Block, Choice, ProductError, Return, Routine, lazy
from symhaptic.export.stages import Begun, begun, staged
from symhaptic.export.target import (
    Printing,
    Target,
    called,
    calls,
    describe,
    vocabulary,
)


class _Printer(Printing, PythonCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations; each routine sees the namespace of its arrays."""

    scope: _Scope

    def _as_ordered_terms(self, expr: Expr, order: str | None = None) -> list[Expr]:
        """SymPy's order, but first a term without a minus, which would be a step of its own."""
        terms = super()._as_ordered_terms(expr, order)
        first = next((t for t in terms if not t.could_extract_minus_sign()), terms[0])
        return [first, *(t for t in terms if t is not first)]

    def _print_Function(self, expr: Expr) -> str:
        return self.scope.call(expr)

    def _print_ProductError(self, expr: Expr) -> str:
        return self.scope.product_error(*expr.args)

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


class ArrayApi(Target):
    """One module of functions of arrays."""

    name, title, printer = "numpy", "Python (NumPy, or any library of the Array API)", _Printer
    words = MappingProxyType({"&&": "&", "||": "|", "!": "~"})
    keywords = vocabulary(
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield match case xp np numpy selftest math sys array_namespace device "
        "is_array_api_obj is_lazy_array is_numpy_array is_torch_array arrays deferred elementwise "
        "select halves square_root product_error plant work yes no"
    )
    operations = called(
        "xp.",
        Max="xp.where({0} > {1}, {0}, {1})",
        Min="xp.where({0} < {1}, {0}, {1})",
        ProductError="product_error({0}, {1})",
        sqrt="square_root(xp, {0})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        lines = [f'"""{library.title}."""', "", *PRELUDE.splitlines(), "", ""]
        written = [_without_numbers(r) for r in library.helpers]
        starts = begun(written)
        for helper in written:
            if helper.name == "ProductError":
                lines += [*HALVES.splitlines(), "", "", *PRODUCT_ERROR.splitlines(), "", ""]
                continue
            start = starts.get(helper.name)
            if start and start.first == helper.name:
                lines += [*self._helper(start.routine, {}), "", ""]
            own = start.rest(helper) if start else helper
            lines += [*self._helper(own, starts), "", ""]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += [*self._public(routine, describe(form), starts), "", ""]
        return {f"{library.name}.py": "\n".join(lines[:-2]) + "\n"}

    def _named(self, symbols: Iterable[Symbol]) -> list[str]:
        return [self.rename(s.name) for s in symbols]

    def _helper(self, routine: Routine, starts: Mapping[str, Begun]) -> list[str]:
        arguments = ", ".join(["xp", *self._named(routine.arguments)])
        head = f"def {self.call(routine.name)}({arguments}):"
        block = lazy(routine)
        return [head, f'    """{routine.about}"""', *_Scope(self, block, starts).written(1)]

    def _public(self, routine: Routine, about: list[str], starts: Mapping[str, Begun]) -> list[str]:
        names = self._named(routine.arguments)
        lines = [f"def {self.call(routine.name)}({', '.join(names)}):", f'    """{about[0]}']
        lines += ["", *(f"    {line}" for line in about[1:]), '    """'] if about[1:] else []
        if not about[1:]:
            lines[-1] += '"""'
        if not names:
            return [*lines, "    (xp,) = arrays()", *_Scope(self, lazy(routine), starts).written(1)]
        lines.append(f"    {', '.join(['xp', *names])} = arrays({', '.join(names)})")
        plant, work = staged(routine)
        for name, part in (("plant", plant), ("work", work)):
            if part is None:
                continue
            given = ", ".join(self._named(part.arguments))
            found = _Scope(self, lazy(part), starts).written(2)
            lines += ["", f"    def {name}({given}):", *found, ""]
            call = f"elementwise(xp, {name}, {given})"
            results = self._named(Symbol(n) for n, _ in part.results)
            lines.append(
                f"    return {call}" if name == "work" else f"    {', '.join(results)} = {call}"
            )
        return lines

    def usage(self, library: Library) -> str:
        """An import of the first function."""
        return f"from {library.name} import {library.public[0].name}"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.py."""
        counts = {r.name: len(r.arguments) for r in library.public}
        text = SELFTEST.replace("NAME", library.name).replace("COUNTS", repr(counts))
        return {"selftest.py": text}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a warning is an error."""
        return [["python", "-W", "error", "selftest.py"]]


def _without_numbers(routine: Routine) -> Routine:
    """The routine with the names of mere numbers replaced by these."""
    numbers: dict[Symbol, Expr] = {}
    steps = []
    for name, expr in routine.steps:
        value = expr.xreplace(numbers)
        if value.is_number:
            numbers[name] = value
        else:
            steps.append((name, value))
    before = routine.shared
    if before is not None and numbers:
        count = sum(name not in numbers for name, _ in routine.steps[: before.count])
        before = replace(before, count=count)
    results = tuple((name, expr.xreplace(numbers)) for name, expr in routine.results)
    return replace(routine, steps=tuple(steps), results=results, shared=before)


class _Scope:
    """The body of one function."""

    def __init__(self, target: ArrayApi, block: Block, starts: Mapping[str, Begun]) -> None:
        self.target, self.block, self.starts = target, block, starts
        self.printer = target.printing()
        self.printer.scope = self
        self.split: set[str] = set()
        """Names whose halves are there."""
        self.begun: dict[tuple[str, tuple[Expr, ...]], str] = {}
        """What is shared and done: the suffix of its names."""
        self.products = {
            frozenset(s.expr.args) if s.expr.is_Mul else s.expr: s.name.name
            for s in block
            if isinstance(s, Assign) and (s.expr.is_Mul or s.expr.is_Pow)
        }
        self.cases: dict[Expr, str] = {}
        """Conditions that have a name."""

    # -- lines -----------------------------------------------------------------------------

    def written(self, depth: int) -> list[str]:
        """The statements."""
        pad, lines = "    " * depth, []
        often = self._often()
        for statement in self.block:
            shown = _expressions(statement)
            for expr in shown:
                lines += [pad + line for line in self._before(expr, often)]
            if isinstance(statement, Assign):
                name = self.target.rename(statement.name.name)
                lines.append(f"{pad}{name} = {self.printer.doprint(statement.expr)}")
            elif isinstance(statement, Choice):
                lines += self._choice(statement, depth)
            else:
                lines.append(f"{pad}return {', '.join(self.printer.doprint(r) for r in shown)}")
        return lines

    def _choice(self, choice: Choice, depth: int) -> list[str]:
        pad, lines, given = "    " * depth, [], []
        condition = self.condition(choice.condition)
        yes, no = _plain(choice.yes), _plain(choice.no)
        if yes is not None and no is not None:
            whole = Piecewise((yes, choice.condition), (no, True))
            return [f"{pad}return {self.printer.doprint(whole)}"]
        for name, block in (("yes", choice.yes), ("no", choice.no)):
            wanted = self.target._named(_free(block))
            body = _Scope(self.target, block, self.starts).written(depth + 1)
            lines += ["", f"{pad}def {name}({', '.join(wanted)}):", *body]
            given.append(f"({', '.join(wanted)}{',' * (len(wanted) == 1)})")
        end = f"{pad}return select(xp, {condition}, yes, {given[0]}, no, {given[1]})"
        return [*lines, "", end]

    # -- what has to be there before an expression --------------------------------------------

    def _often(self) -> set[Expr]:
        """Conditions that occur more than once."""
        count: dict[Expr, int] = {}
        for statement in self.block:
            for expr in _expressions(statement):
                for part in sp.preorder_traversal(expr):
                    if isinstance(part, Piecewise):
                        for _, condition in part.args[:-1]:
                            count[condition] = count.get(condition, 0) + 1
        return {condition for condition, times in count.items() if times > 1}

    def _before(self, expr: Expr, often: set[Expr]) -> list[str]:
        lines = []
        for part in sp.postorder_traversal(expr):
            if isinstance(part, ProductError):
                for factor in part.args:
                    name = self.target.rename(factor.name)
                    if name not in self.split:
                        self.split.add(name)
                        lines.append(f"{name}_halves = halves(xp, {name})")
            elif isinstance(part, Piecewise):
                for _, condition in part.args[:-1]:
                    if condition in often and condition not in self.cases:
                        name = f"case{len(self.cases) + 1}"
                        lines.append(f"{name} = {self.printer.doprint(condition)}")
                        self.cases[condition] = name
            elif type(part).__name__ in self.starts:
                lines += self._begin(self.starts[type(part).__name__], part.args)
        return lines

    def _begin(self, start: Begun, args: tuple[Expr, ...]) -> list[str]:
        if (start.routine.name, args) in self.begun:
            return []
        suffix = f"_{len(self.begun) + 1}" if self.begun else ""
        self.begun[start.routine.name, args] = suffix
        names = [f"{name}{suffix}" for name in self.target._named(start.kept)]
        given = ", ".join(["xp", *(self.printer.doprint(a) for a in args)])
        return [f"{', '.join(names)} = {self.target.call(start.routine.name)}({given})"]

    # -- expressions -----------------------------------------------------------------------

    def call(self, expr: Expr) -> str:
        """A call of a routine, with what is shared and done already."""
        name = expr.func.__name__
        like = min(self._symbols(expr), key=str, default=None)
        args = [
            f"xp.full_like({like}, {self.printer.doprint(a)})"
            if a.is_number
            else self.printer.doprint(a)
            for a in expr.args
        ]
        if name in self.starts:
            start = self.starts[name]
            suffix = self.begun[start.routine.name, expr.args]
            args += [f"{n}{suffix}" for n in self.target._named(start.used[name])]
        return f"{self.target.call(name)}({', '.join(['xp', *args])})"

    def product_error(self, one: Symbol, two: Symbol) -> str:
        """What a product misses; the product itself may have a name."""
        names = self.target._named((one, two))
        product = self.products.get(one**2 if one == two else frozenset((one, two)))
        shown = self.target.rename(product) if product else "*".join(names)
        return f"product_error({shown}, {names[0]}_halves, {names[1]}_halves)"

    def condition(self, condition: Expr) -> str:
        """A condition, by its name if it has one."""
        return self.cases.get(condition) or str(self.printer.doprint(condition))

    def like(self, condition: Expr) -> str:
        """An array of the kind that a condition looks at."""
        return min(self._symbols(condition))

    def _symbols(self, expr: Expr) -> list[str]:
        return self.target._named(expr.free_symbols)


def _expressions(statement: Assign | Choice | Return) -> tuple[Expr, ...]:
    """What a statement computes itself, the conditions of a choice included."""
    if isinstance(statement, Assign):
        return (statement.expr,)
    return (statement.condition,) if isinstance(statement, Choice) else statement.results


def _plain(block: Block) -> Expr | None:
    """The one expression of a block that is nothing else and calls nothing."""
    first = block[0]
    if not isinstance(first, Return) or calls(Routine("", "", (), (), (("", first.results[0]),))):
        return None
    return first.results[0]


def _free(block: Block) -> list[Symbol]:
    """What a block needs to be given, by name."""
    needed: set[Symbol] = set()
    done: set[Symbol] = set()
    for statement in block:
        for expr in _expressions(statement):
            needed |= expr.free_symbols - done
        if isinstance(statement, Assign):
            done.add(statement.name)
        elif isinstance(statement, Choice):
            needed |= {s for b in (statement.yes, statement.no) for s in _free(b)} - done
    return sorted(needed, key=str)


TARGET = ArrayApi()
