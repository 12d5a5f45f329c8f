"""C99."""

from __future__ import annotations

from copy import copy

from sympy import Expr
from sympy.printing.c import C99CodePrinter

from symhaptic.export import c_si, cmake, rounding, standard
from symhaptic.export.branches import guarded
from symhaptic.export.cmake import FLAGS, STRICT
from symhaptic.export.described import describe
from symhaptic.export.module import Library
from symhaptic.export.precision import DOUBLE
from symhaptic.export.printing import Printing, called, vocabulary
from symhaptic.export.records import Places, Records
from symhaptic.export.routine import Routine, Several
from symhaptic.export.statements import braces
from symhaptic.export.target import Target
from symhaptic.export.wrapping import WIDTH, wrapped

KEYWORDS = vocabulary(
    "auto break case char const continue default do double else enum extern float for goto if "
    "inline int long register restrict return short signed sizeof static struct switch "
    "typedef union unsigned void volatile while _Bool _Complex _Imaginary main"
)

CPP_KEYWORDS = KEYWORDS | vocabulary(
    "alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t class compl "
    "constexpr const_cast decltype delete dynamic_cast explicit export false friend mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "reinterpret_cast static_assert static_cast template this thread_local throw true try "
    "typeid typename using virtual wchar_t xor xor_eq std"
)
"""Those of C++ too, since its programs read the header."""


class _Printer(Printing, C99CodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations, and without macros that the standard does not have."""

    target: C

    def __init__(self) -> None:
        super().__init__({"math_macros": {}})

    def _print_Function(self, expr: Expr) -> str:
        return str(self.target.called(expr))


class C(Target):
    """One source file and its header."""

    name, title, keywords, printer = "c", "C99", CPP_KEYWORDS, _Printer
    shares = True
    helper = "static inline"
    """What declares a function that others here call: inlined, they take a tenth less time."""
    modules = standard.C
    each = (
        "for (int n = {first}; n >= {last}; n -= {step}) {{",
        "    const {real} {name} = inverse_factorial[n];",
    )
    operations = called(
        "",
        Abs="fabs({0})",
        Infinity="INFINITY",
        NaN="NAN",
        Max="fmax({0}, {1})",
        Min="fmin({0}, {1})",
        TwoProdError="fma({0}, {1}, -({0}*{1}))",
    )
    single = called(
        "",
        "f",
        Abs="fabsf({0})",
        Infinity="INFINITY",
        NaN="NAN",
        Max="fmaxf({0}, {1})",
        Min="fminf({0}, {1})",
        TwoProdError="fmaf({0}, {1}, -({0}*{1}))",
    )

    records: Records | None = None
    """Those of the library that is written."""
    writes: Routine | None = None
    """The routine that is written."""
    places = Places()
    """Where its names are that are in a record."""

    @property
    def late(self) -> str:
        """The type."""
        return self.real

    def rename(self, name: str) -> str:
        """As in all languages; in a routine, of a number in a record that record and its field."""
        return self.places.written.get(name) or super().rename(name)

    def number(self, value: float) -> str:
        """A literal of the type."""
        return super().number(value) + ("" if self.precision is DOUBLE else "f")

    def source(self, library: Library) -> dict[str, str]:
        """NAME.c and NAME.h."""
        guard = f"{library.name.upper()}_H"
        heads = []
        for form, routine in zip(library.forms, library.public, strict=True):
            about = describe(form, self.precision)
            heads += ["/*", *(f" * {line}" for line in about), " */"]
            heads += [f"{self._head(f'{library.name}_{routine.name}', routine)};", ""]
        truth = ["#include <stdbool.h>", ""] * any(r.truth for r in library.public)
        header = [f"#ifndef {guard}", f"#define {guard}", "", *truth, *_LINKED, *heads,
                  "#ifdef __cplusplus", "}", "#endif", "", "#endif", ""]  # fmt: skip
        lines = [f'#include "{library.name}.h"', "", "#include <math.h>", "", *STRICT.split("\n")]
        lines += self.prelude(library)
        if table := self.table(library):
            lines += ["// 1/n!", f"static const {self.real} inverse_factorial[] = {{{table}}};", ""]
        own = copy(self)
        own.records = records = Records(self, library.helpers)
        if types := records.declared():
            lines += [*types, ""]
        for helper in library.helpers:
            if helper.name not in records.fields:
                lines += [f"// {helper.about}", *own._helper(helper)]
        for routine in library.public:
            head = self._head(f"{library.name}_{routine.name}", routine)
            lines += own._written(routine, head)
        files = {f"{library.name}.h": header, f"{library.name}.c": lines}
        return {name: "\n".join(wrapped(text)) for name, text in files.items()}

    def prelude(self, library: Library) -> list[str]:
        """What stands before all functions."""
        return []

    def _out(self, name: str) -> str:
        return f"{name}_out"

    def _helper(self, routine: Routine) -> list[str]:
        """One that others here call: of pairs, and with all results in a record."""
        assert self.records is not None
        args = ", ".join(self.records.arguments(routine)) or "void"
        kind = self.records.kind(routine)
        head = f"{self.helper} {kind} {self.call(routine.name)}({args})"
        return self._written(routine, head, [] if kind != self.real else ["return {0};"])

    def _written(self, routine: Routine, head: str, ends: list[str] | None = None) -> list[str]:
        if ends is None:
            ends = [f"*{self._out(n)} = {{{i}}};" for i, (n, _) in enumerate(routine.results)]
            ends = ["return {0};"] if len(ends) == 1 else [*ends, "return;"]
        own = copy(self)
        if self.records is not None:
            own.places = self.records.places(routine)
            own.writes = routine
        body = braces(own, guarded(routine), ends, f"const {self.real}")
        if body[-1].endswith("return;"):
            body[-1:] = [line] if (line := body[-1].removesuffix("return;").rstrip()) else []
        short = f"{head} {{ {body[0].lstrip()} }}"
        if len(body) == 1 and len(short) <= WIDTH:
            return [short, ""]
        return [f"{head} {{", *body, "}", ""]

    def called(self, call: Expr) -> str:
        """A call, with pairs where the routine takes them."""
        name, printer = call.func.__name__, self.printing()
        args = [printer.whole(a) for a in call.args]
        if self.records is not None:
            given = self.records.given(name, args)
            args = [self.places.variable(self._handed(a)) for a in given]
            if name in self.records.fields:
                name, field = self.records.fields[name]
                return f"{self.call(name)}({', '.join(args)}).{field}"
        return f"{self.call(name)}({', '.join(args)})"

    def received(self, several: Several) -> tuple[str, str]:
        """As a record."""
        assert self.records is not None
        kind = self.records.kind(self.records.routines[several.call.func.__name__])
        variable, _, _ = self.rename(several.names[0].name).partition(".")
        for pair in self.places.passed:
            if pair.partition(".")[0] == variable:
                self.places.calls[pair] = several.call
                return "", ""
        return f"const {kind} ", f"{variable} = {self.called(several.call)};"

    def passed_on(self, several: Several) -> str:
        """Where both are helpers and give the same record."""
        assert self.records is not None
        assert self.writes is not None
        called = self.records.routines[several.call.func.__name__]
        alike = self.records.kind(self.writes) == self.records.kind(called)
        if self.writes.name not in self.records.routines or not alike:
            return ""
        return f"return {self.called(several.call)};"

    def waiting(self) -> list[tuple[str, str]]:
        """Records that are made for what is written next."""
        found = list(self.places.waiting)
        self.places.waiting.clear()
        self.places.made.clear()
        return found

    def ended(self, ends: list[str], results: list[str]) -> list[str]:
        """Several results of a helper as a record."""
        if ends:
            return super().ended(ends, results)
        assert self.records is not None
        assert self.writes is not None
        made = self.records.made(self.writes, results, self.places, self._handed)
        return [f"return {made};"]

    def _handed(self, pair: str) -> str:
        """A pair, or the call that gives it."""
        call = self.places.calls.get(pair)
        _, dot, field = pair.partition(".")
        return pair if call is None else f"{self.called(call)}{dot}{field}"

    def _head(self, name: str, routine: Routine) -> str:
        args = [f"{self.real} {self.rename(s.name)}" for s in routine.arguments]
        kind = "bool" if routine.truth else self.real
        if len(routine.results) > 1:
            kind, args = "void", args + [f"{self.real} *{self._out(n)}" for n, _ in routine.results]
        return f"{kind} {name}({', '.join(args) or 'void'})"

    def notes(self, library: Library) -> list[str]:
        """What it refuses to be compiled with, how it is found, and what is in SI units."""
        name = library.name
        si = c_si.header(library, self.real, self.precision)
        lines = cmake.notes(name, f"{name}.h")
        if si:
            lines += [
                f"{name}_si.h has the same functions of a device in SI units (kg, s, N/m, Ns/m)."
            ]
        if "example.c" in si:
            lines += ["example.c is a controller of 1 kHz with a wall below its limit."]
        return [*lines, "C++ may include the headers, too."]

    def proved(self, routine: Routine) -> list[rounding.Goal]:
        """Of each result to which no branch leads."""
        return rounding.goals(routine, self)

    def package(self, library: Library) -> dict[str, str]:
        """For CMake and pkg-config; the same in SI units, and a controller."""
        name, si = library.name, c_si.header(library, self.real, self.precision)
        headers = [f"{name}.h", *(file for file in si if file.endswith(".h"))]
        programs = ["selftest.c", *(file for file in si if file.endswith(".c"))]
        made = cmake.package(name, library.title, "c_std_99", f"{name}.c", headers, programs)
        return made | si

    def usage(self, library: Library) -> str:
        """The declaration of the first function."""
        first = library.public[0]
        head = self._head(f"{library.name}_{first.name}", first)
        return "\n".join([f'#include "{library.name}.h"', "", *wrapped([f"{head};"])])

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.c."""
        cases = []
        for r in library.public:
            count = len(r.arguments)
            args = [f"x[{i}]" for i in range(count)]
            name = f"{library.name}_{r.name}"
            if len(r.results) > 1:
                args += [f"&got[{i}]" for i in range(len(r.results))]
                call = f"{name}({', '.join(args)})"
            else:
                call = f"got[0] = {name}({', '.join(args)})"
            cases.append(
                f'        if (strcmp(name, "{r.name}") == 0) {{\n'
                f"            arguments = {count}, results = {len(r.results)};\n"
                f"            read_all(file, x, arguments + 2*results);\n"
                + "".join(f"{part}\n" for part in wrapped([f"            {call};"]))
                + "        }\n"
            )
        words = library.name, self.real, self.real, self.real, "".join(cases)
        return {"selftest.c": _SELFTEST % words}

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run."""
        return [
            ["gcc", "-std=c99", *FLAGS, "-o", "selftest", "selftest.c", f"{name}.c", "-lm"],
            ["./selftest"],
        ]


_LINKED = ["#ifdef __cplusplus", 'extern "C" {', "#endif", ""]

_SELFTEST = """#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "%s.h"

static void read_all(FILE *file, %s *into, int count) {
    int i;
    char word[64];
    for (i = 0; i < count; ++i) {
        if (fscanf(file, "%%63s", word) != 1) exit(2);
        into[i] = (%s)strtod(word, NULL); /* exact */
    }
}

int main(void) {
    %s x[256], got[128];
    char name[64];
    int tried = 0, missed = 0;
    FILE *file = fopen("vectors.txt", "r");
    if (file == NULL) return 2;
    while (fscanf(file, "%%63s", name) == 1) {
        int arguments = 0, results = 0, i;
%s        if (results == 0) return 2;
        for (i = 0; i < results; ++i) {
            const double found = (double)got[i], expected = (double)x[arguments + 2*i];
            ++tried;
            if (!(fabs(found - expected) <= (double)x[arguments + 2*i + 1]) &&
                !(isnan(found) && isnan(expected))) {
                ++missed;
                printf("%%s, result %%d: %%.17g instead of %%.17g\\n", name, i, found, expected);
            }
        }
    }
    fclose(file);
    printf("%%d values, %%d missed\\n", tried, missed);
    return tried == 0 || missed > 0;
}
"""

TARGET = C()
