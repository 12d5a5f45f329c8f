"""Python, for arrays of any library of the Array API standard."""

from __future__ import annotations

from types import MappingProxyType

from sympy import Expr
from sympy.printing.pycode import PythonCodePrinter

from symhaptic.export.library import Library, known
from symhaptic.export.precision import SINGLE
from symhaptic.export.routine import Repeat, Routine
from symhaptic.export.target import Printing, Target, called, describe, vocabulary


class _Printer(Printing, PythonCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations; each routine gets the namespace of its arrays."""

    def _print_Function(self, expr: Expr) -> str:
        args = ", ".join(self._print(a) for a in expr.args)
        return f"{self.target.call(expr.func.__name__)}(xp, {args})"


class ArrayApi(Target):
    """One module; every branch is computed and the right one taken, element by element."""

    name, title, printer = "numpy", "Python (NumPy, or any library of the Array API)", _Printer
    shares = False
    choice = "xp.where({0}, {1}, {2})"
    words = MappingProxyType({"&&": "&", "||": "|", "!": "~"})
    keywords = vocabulary(
        "False None True and as assert async await break class continue def del elif else except "
        "finally for from global if import in is lambda nonlocal not or pass raise return try "
        "while with yield match case xp np numpy selftest"
    )
    operations = single = called(
        "xp.",
        Infinity="xp.inf",
        NaN="xp.nan",
        Max="xp.where({0} > {1}, {0}, {1})",
        Min="xp.where({0} < {1}, {0}, {1})",
        ProductError="product_error(xp, {0}, {1})",
    )

    def number(self, value: float) -> str:
        """A literal, which takes the precision of the array beside it."""
        return repr(float(value))

    def source(self, library: Library) -> dict[str, str]:
        """NAME.py."""
        lines = [f'"""{library.title}."""', "", *_PRELUDE.splitlines(), "", ""]
        for helper in library.helpers:
            if helper.name == "ProductError":
                lines += [*_PRODUCT_ERROR.splitlines(), "", ""]
                continue
            args = ["xp", *self._arguments(helper)]
            lines += self._written(helper, args, [helper.about], known(SINGLE).get(helper.name))
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += self._written(routine, self._arguments(routine), describe(form))
        return {f"{library.name}.py": "\n".join(lines[:-2]) + "\n"}

    def _arguments(self, routine: Routine) -> list[str]:
        return [self.rename(s.name) for s in routine.arguments]

    def _written(
        self, routine: Routine, args: list[str], about: list[str], single: Routine | None = None
    ) -> list[str]:
        """A function; where its single precision has other steps, these come first."""
        name = self.call(routine.name)
        lines = [f"def {name}({', '.join(args)}):", f'    """{about[0]}']
        lines += ["", *(f"    {line}" for line in about[1:]), '    """'] if about[1:] else []
        if not about[1:]:
            lines[-1] += '"""'
        if not args:
            lines.append('    xp = import_module("numpy")')
        elif args[0] != "xp":
            one = "," if len(args) == 1 else ""
            lines.append(f"    xp, ({', '.join(args)}{one}) = _arrays({', '.join(args)})")
        if single is not None and single != routine:
            lines.append(f"    if {args[1]}.dtype == xp.float32:")
            lines += [f"    {line}" for line in self._steps(single)]
        return [*lines, *self._steps(routine), "", ""]

    def _steps(self, routine: Routine) -> list[str]:
        printer = self.printing()
        lines = []
        for step in routine.steps:
            if isinstance(step, Repeat):
                lines += [f"    {line}" for line in self._repeated(step)]
            else:
                value = printer.doprint(step[1])
                if step[1].is_number and routine.arguments:
                    value = f"xp.full_like({self._arguments(routine)[-1]}, {value})"
                lines.append(f"    {self.rename(step[0].name)} = {value}")
        values = ", ".join(printer.doprint(value) for _, value in routine.results)
        return [*lines, f"    return {values}"]

    def _repeated(self, loop: Repeat) -> list[str]:
        """Its condition and its steps as two functions, which a helper calls."""
        printer = self.printing()
        states = ", ".join(self.rename(s.name) for s in loop.states)
        over, step = (f"{word}_{loop.states[0].name}" for word in ("over", "step"))
        lines = [f"def {over}({states}):", f"    return {printer.doprint(loop.done)}", ""]
        lines.append(f"def {step}({states}):")
        lines += [f"    {self.rename(n.name)} = {printer.doprint(e)}" for n, e in loop.steps]
        lines += [f"    return {', '.join(self.rename(n.name) for n in loop.next)}", ""]
        start = ", ".join(printer.doprint(first) for first in loop.start)
        return [*lines, f"{states} = _repeat(xp, {loop.most}, {over}, {step}, {start})"]

    def usage(self, library: Library) -> str:
        """An import of the first function."""
        return f"from {library.name} import {library.public[0].name}"

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.py."""
        counts = {r.name: len(r.arguments) for r in library.public}
        text = _SELFTEST.replace("NAME", library.name).replace("COUNTS", repr(counts))
        text = text.replace("KIND", self.precision.kind.__name__)
        return {"selftest.py": text}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a warning is an error."""
        return [["python", "-W", "error", "selftest.py"]]


_PRELUDE = """from importlib import import_module


def _arrays(*values):
    \"\"\"The namespace of the arrays, and all values as floats in it.\"\"\"
    xp = None
    for value in values:
        home = type(value).__module__.partition(".")[0]
        if home in ("torch", "cupy"):
            xp = import_module(home)
        elif hasattr(value, "__array_namespace__"):
            xp = value.__array_namespace__()
        if xp is not None:
            break
    if xp is None:
        xp = import_module("numpy")
    floats = [v.dtype for v in values if getattr(v, "dtype", None) in (xp.float32, xp.float64)]
    wide = xp.float64 if xp.float64 in floats or not floats else xp.float32
    return xp, [xp.asarray(v, dtype=wide) for v in values]


def _repeat(xp, most, over, step, *states):
    \"\"\"The states after so many steps; what is over keeps its own.\"\"\"
    for _ in range(most):
        done = over(*states)
        if xp.all(done):
            break
        states = [xp.where(done, *pair) for pair in zip(states, step(*states))]
    return states
"""

_PRODUCT_ERROR = """def product_error(xp, y, z):
    \"\"\"y z minus the float nearest to it, by Dekker's product.\"\"\"
    product = y*z
    split = 134217729.0 if product.dtype == xp.float64 else 4097.0
    if isinstance(z, float):
        z = xp.full_like(product, z)
    big = split*y
    high = big - (big - y)
    low = y - high
    other = split*z
    most = other - (other - z)
    least = z - most
    return ((high*most - product) + high*least + low*most) + low*least
"""

_SELFTEST = """from pathlib import Path

import numpy as np

import NAME

COUNT = COUNTS
tried = missed = 0
for line in Path("vectors.txt").read_text(encoding="ascii").splitlines():
    name, *words = line.split()
    numbers = [float.fromhex(word) for word in words]
    count = COUNT[name]
    got = np.ravel(getattr(NAME, name)(*map(np.KIND, numbers[:count])))
    for i, value in enumerate(got):
        expected, allowed = numbers[count + 2*i : count + 2*i + 2]
        tried += 1
        if not abs(value - expected) <= allowed:
            missed += 1
            print(f"{name}, result {i}: {value!r} instead of {expected!r}")
print(f"{tried} values, {missed} missed")
raise SystemExit(tried == 0 or missed > 0)
"""

TARGET = ArrayApi()
