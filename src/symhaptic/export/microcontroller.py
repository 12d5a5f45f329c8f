"""C99 for a microcontroller: floats of 32 bits, no memory taken, no errno, and what it costs."""

from __future__ import annotations

from types import MappingProxyType
from typing import Self

from symhaptic.export.c import C
from symhaptic.export.cmake import FLAGS
from symhaptic.export.module import Library
from symhaptic.export.operations import KINDS, most
from symhaptic.export.precision import SINGLE, Precision
from symhaptic.export.printing import Refused, operations
from symhaptic.export.routine import Routine

SIZES = {
    "discretize": 3820,
    "discretize_fractional": 4796,
    "characteristic_polynomial": 3916,
    "is_stable": 10604,
    "unstable_roots": 10304,
    "stability_conditions": 4952,
    "stability_boundary": 6972,
    "max_stable_stiffness": 15044,
    "passivity_margin_at": 656,
    "passivity_margin": 2460,
    "passivity_boundary": 3192,
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

    def _written(self, routine: Routine, head: str, ends: list[str] | None = None) -> list[str]:
        lines = super()._written(routine, head, ends)
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
            "All is in single precision; nothing asks for memory, and nothing touches errno: exp",
            "is made of expm1f and scalbnf, whose errors the self-test allows for. Where the",
            "processor has no fused multiplication, none is asked for. A function runs no longer",
            "than the operations of this table take; differences are additions, minima and maxima",
            "are comparisons, and functions are those of the mathematical library, each exp one.",
            "",
            f"| function | {' | '.join(KINDS)} | bytes |",
            f"|---|{'---|' * (len(KINDS) + 1)}",
        ]
        for own, count in most(library).items():
            figures = " | ".join(str(count[kind]) for kind in KINDS)
            lines.append(f"| {own} | {figures} | {SIZES.get(own, '')} |")
        return [
            *lines,
            "",
            "Bytes: the code of one function alone, of a loop with all its parts, with all that it",
            f"calls but the mathematical library ({MEASURED_WITH}).",
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
