"""C99 for a microcontroller: floats of 32 bits, no memory taken, no errno, and what it costs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from types import MappingProxyType
from typing import Self

import sympy as sp
from sympy import Expr

from symhaptic.export.branches import Block, Choice, Join, expressions, guarded
from symhaptic.export.c import C
from symhaptic.export.language import Refused
from symhaptic.export.package import FLAGS
from symhaptic.export.precision import SINGLE, Precision
from symhaptic.export.routine import Library, Repeat, Routine, operations

SIZES = {
    "discretize": 3828,
    "discretize_fractional": 4804,
    "characteristic_polynomial": 3924,
    "is_stable": 17048,
    "unstable_roots": 16548,
    "delay_margin": 24104,
    "stability_conditions": 4960,
    "stability_boundary": 7664,
    "max_stable_stiffness": 21452,
    "passivity_margin_at": 1292,
    "passivity_margin": 2460,
    "passivity_boundary": 3172,
    "max_passive_stiffness": 1632,
    "linear_limit": 100,
}
"""Bytes of code of each function with all that it calls but the mathematical library, measured."""

COMPILER = "arm-none-eabi-gcc"
CORTEX_M4 = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]
LEAN = ["-Os", "-fno-math-errno", "-ffp-contract=off"]
MEASURED_WITH = f"{COMPILER} 12.2 {' '.join([*CORTEX_M4, *LEAN])}"


class Microcontroller(C):
    """C in single precision, without what brings in double precision or errno."""

    name, title = "microcontroller", "C99 for microcontrollers"
    precision = SINGLE
    helper = "static"
    operations = single = MappingProxyType(
        {**C.single, "exp": "exponential({0})", "TwoProdError": "two_prod_error({0}, {1})"}
    )

    def at(self, precision: Precision) -> Self:
        """Itself: it has single precision only."""
        if precision is not SINGLE:
            raise Refused(f"--precision {precision.name}: {self.title} is exported in single only")
        return self

    def prelude(self, library: Library) -> list[str]:
        """An exponential that does not touch errno, as that of most libraries does."""
        asked = any("exp" in operations(r) for r in (*library.helpers, *library.public))
        return _EXPONENTIAL.split("\n") if asked else []

    def _helper(self, routine: Routine) -> list[str]:
        lines = super()._helper(routine)
        if routine.name != "TwoProdError":
            return lines
        x, y = (self.rename(s.name) for s in routine.arguments)
        quick = f"    return fmaf({x}, {y}, -({x}*{y}));"
        asked = "#if defined(FP_FAST_FMAF) || defined(__FP_FAST_FMAF)"
        return [lines[0], asked, quick, "#else", *lines[1:-2], "#endif", *lines[-2:]]

    def notes(self, library: Library) -> list[str]:
        """What it leaves out, and what it costs."""
        name = library.name
        lines = [
            "The code computes in single precision, allocates no memory and does not set errno.",
            "exp is computed from expm1f and scalbnf; the self-test allows for their errors. Fused",
            "multiplication is used only if the processor has it. The table gives the largest",
            "number of operations of a call. Differences count as additions, minima and maxima as",
            "comparisons, and each exp as one function of the mathematical library.",
            "",
            f"| function | {' | '.join(KINDS)} | bytes |",
            f"|---|{'---|' * (len(KINDS) + 1)}",
        ]
        for own, count in most(library).items():
            figures = " | ".join(str(count[kind]) for kind in KINDS)
            size = SIZES.get("is_stable" if own == "verdict" else own, "")
            lines.append(f"| {own} | {figures} | {size} |")
        return [
            *lines,
            "",
            "Bytes: the code size of one function, for a loop with all its parts, including all",
            f"functions that it calls except the mathematical library ({MEASURED_WITH}).",
            "",
            f"    {COMPILER} -std=c99 {' '.join([*CORTEX_M4, *LEAN])} -c {name}.c",
            "",
            *super().notes(library),
        ]

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run, on the machine that one writes on."""
        flags = ["-std=c99", *FLAGS, "-ffp-contract=off", "-fno-math-errno"]
        return [
            ["gcc", *flags, "-o", "selftest", "selftest.c", f"{name}.c", "-lm"],
            ["./selftest"],
        ]


_EXPONENTIAL = """\
// exp(x), without errno
static float exponential(float x) {
    if (x < -104.0f) {
        return 0.0f;
    }
    if (!(x < 89.0f)) {
        return x + INFINITY;
    }
    const float power = floorf(x*1.442695f + 0.5f);
    const float rest = (x - power*0.693145751953125f) - power*1.42860677e-6f;
    return scalbnf(1.0f + expm1f(rest), (int)power);
}
"""

TARGET = Microcontroller()


# -- How many operations a function takes at most, whatever its arguments ------------------------


KINDS = "additions", "products", "quotients", "roots", "comparisons", "functions"
"""Differences are additions; Max and Min are comparisons; functions are those of a library."""

_FREE = sp.Abs, sp.Symbol, sp.Number, sp.NumberSymbol, sp.logic.boolalg.BooleanAtom
"""A sign costs nothing."""


def most(library: Library) -> dict[str, Counter[str]]:
    """Of each public function: of each kind, as many as no branch exceeds.

    >>> from symhaptic.export import request
    >>> forms = request.chosen(["linear_limit"])
    >>> made, _ = request.built(request.target("c"), forms, vectors=False)
    >>> sorted(most(made)["linear_limit"].items())
    [('additions', 2), ('comparisons', 5), ('quotients', 1)]
    """
    known: dict[str, Counter[str]] = {}
    for helper in library.helpers:
        known[helper.name] = _block(guarded(helper), known)
    return {r.name: _block(guarded(r), known) for r in library.public}


def _block(block: Block, known: dict[str, Counter[str]]) -> Counter[str]:
    total: Counter[str] = Counter(dict.fromkeys(KINDS, 0))
    for statement in block:
        for expr in expressions(statement):
            total += _of(expr, known)
        if isinstance(statement, (Choice, Join)):
            total += _larger([_block(side, known) for side in (statement.yes, statement.no)])
        if isinstance(statement, Repeat):
            total += _of(statement.brief, known)
            inner = _of(statement.done, known)
            for _, expr in statement.steps:
                inner += _of(expr, known)
            total += Counter({kind: count * statement.most for kind, count in inner.items()})
    return total


def _larger(sides: Iterable[Counter[str]]) -> Counter[str]:
    total: Counter[str] = Counter()
    for side in sides:
        total |= side
    return total


def _of(expr: sp.Basic, known: dict[str, Counter[str]]) -> Counter[str]:
    """Of an expression as it is written: the base of a power stands there so many times, and a
    choice takes one of its sides.

    >>> x, y = sp.symbols("x y")
    >>> _of((x + y) ** 2, {})["additions"]
    2
    """
    if isinstance(expr, sp.Piecewise):
        asked = sum((_of(c, known) for _, c in expr.args), Counter())
        return asked + _larger(_of(value, known) for value, _ in expr.args)
    total: Counter[str] = sum((_of(arg, known) for arg in expr.args), Counter())
    if isinstance(expr, sp.Add):
        total["additions"] += len(expr.args) - 1
    elif isinstance(expr, sp.Mul):
        below = sum(map(_below, expr.args))
        above = sum(arg != -1 for arg in expr.args) - below
        again = max(below - 1, 0)  # divisors are multiplied first
        total["quotients"] -= again
        total["products"] += max(above - 1, 0) + again
    elif isinstance(expr, sp.Pow):
        power = sp.Rational(expr.args[1])
        root = abs(power) == sp.S.Half
        times = 1 if root else int(abs(power))
        total = Counter({kind: count * times for kind, count in total.items()})
        total["quotients"] += bool(power < 0)
        total["roots"] += bool(root)
        total["products"] += times - 1
    elif isinstance(expr, (sp.Max, sp.Min)):
        total["comparisons"] += len(expr.args) - 1
    elif isinstance(expr, sp.core.relational.Relational):
        total["comparisons"] += 1
    elif isinstance(expr, (sp.And, sp.Or, sp.Not, *_FREE)):
        pass
    elif (name := expr.func.__name__) in known:
        total += known[name]
    elif isinstance(expr, sp.Function):
        total["functions"] += 1
    return total


def _below(arg: Expr) -> bool:
    return bool(arg.is_Pow and arg.args[1] < 0)
