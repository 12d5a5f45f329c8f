"""C++17."""

from __future__ import annotations

from symhaptic.export import package, reserved
from symhaptic.export.branches import guarded
from symhaptic.export.c import Family
from symhaptic.export.language import called, describe
from symhaptic.export.package import FLAGS, STRICT
from symhaptic.export.routine import Library, Routine
from symhaptic.export.statements import braces, wrapped


class Cpp(Family):
    """One source file and its header; several results are a std::array."""

    name, title = "cpp", "C++17"
    modules = reserved.CPP
    operations = single = called(
        "std::",
        Abs="std::fabs({0})",
        Infinity="std::numeric_limits<{real}>::infinity()",
        NaN="std::numeric_limits<{real}>::quiet_NaN()",
        Max="std::fmax({0}, {1})",
        Min="std::fmin({0}, {1})",
        TwoProdError="std::fma({0}, {1}, -({0}*{1}))",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.cpp and NAME.hpp."""
        heads = []
        for form, routine in zip(library.forms, library.public, strict=True):
            heads += [f"/// {line}" for line in describe(form, self.precision)]
            heads += [f"[[nodiscard]] {self._head(routine)};", ""]
        header = ["#pragma once", "", "#include <array>", "", f"namespace {library.name} {{", "",
                  *heads, "}", ""]  # fmt: skip
        lines = [f'#include "{library.name}.hpp"', "", "#include <cfloat>", "#include <cmath>",
                 "#include <limits>", "",
                 *STRICT.split("\n"), "namespace {", ""]  # fmt: skip
        if table := self.table(library):
            lines += ["// 1/n!", f"constexpr {self.real} inverse_factorial[] = {{{table}}};", ""]
        for helper in library.helpers:
            first, *others = self._written(helper)
            lines += [f"// {helper.about}", f"inline {first}", *others]
        lines += ["}", "", f"namespace {library.name} {{", ""]
        for routine in library.public:
            lines += self._written(routine)
        files = {f"{library.name}.hpp": header, f"{library.name}.cpp": [*lines, "}", ""]}
        return {name: "\n".join(wrapped(text)) for name, text in files.items()}

    def _written(self, routine: Routine) -> list[str]:
        count = len(routine.results)
        values = ", ".join(f"{{{i}}}" for i in range(count))
        end = f"return {{{{{values}}}}};" if count > 1 else "return {0};"
        body = braces(self, guarded(routine), [end], f"const {self.real}")
        return [f"{self._head(routine)} {{", *body, "}", ""]

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From an array."""
        return f"const auto [{', '.join(names)}] = {function}({args});"

    def _head(self, routine: Routine) -> str:
        args = ", ".join(f"{self.real} {self.rename(s.name)}" for s in routine.arguments)
        count = len(routine.results)
        kind = "bool" if routine.truth else self.real
        kind = kind if count == 1 else f"std::array<{self.real}, {count}>"
        return f"{kind} {self.call(routine.name)}({args}) noexcept"

    def notes(self, library: Library) -> list[str]:
        """What it refuses to be compiled with, and how it is found."""
        return package.notes(library.name, f"{library.name}.hpp")[:-1]

    def package(self, library: Library) -> dict[str, str]:
        """For CMake and pkg-config."""
        name, programs = library.name, ["selftest.cpp"]
        source, header = f"{name}.cpp", f"{name}.hpp"
        return package.package(name, library.title, "cxx_std_17", source, [header], programs)

    def usage(self, library: Library) -> str:
        """The declaration of the first function."""
        line = f"namespace {library.name} {{ {self._head(library.public[0])}; }}"
        return "\n".join([f'#include "{library.name}.hpp"', "", *wrapped([line])])

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.cpp."""
        cases = []
        for r in library.public:
            args = ", ".join(f"x[{i}]" for i in range(len(r.arguments)))
            call = f"{library.name}::{r.name}({args})"
            keep = f"const auto y = {call}; got.assign(y.begin(), y.end())"
            got = f"got.assign(1, {call})"
            step = wrapped([f"            {keep if len(r.results) > 1 else got};"])
            cases.append(
                f'        if (name == "{r.name}") {{\n'
                f"            const auto x = read_all(file, {len(r.arguments)});\n"
                + "".join(f"{part}\n" for part in step)
                + "        }\n"
            )
        unused = any(not r.arguments for r in library.public)
        text = (_SELFTEST % (library.name, "".join(cases))).replace("REAL", self.real)
        return {"selftest.cpp": text.replace("const auto x =", "[[maybe_unused]] const auto x =")
                if unused else text}  # fmt: skip

    def commands(self, name: str) -> list[list[str]]:
        """Compile with warnings as errors, then run."""
        return [
            ["g++", "-std=c++17", *FLAGS, "-o", "selftest", "selftest.cpp", f"{name}.cpp"],
            ["./selftest"],
        ]


_SELFTEST = """#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "%s.hpp"

static std::vector<REAL> read_all(std::istream &file, int count) {
    std::vector<REAL> found;
    std::string word;
    while (count-- > 0 && file >> word) {
        found.push_back(static_cast<REAL>(std::strtod(word.c_str(), nullptr)));
    }
    return found;
}

int main() {
    std::ifstream file("vectors.txt");
    std::string name;
    int tried = 0, missed = 0;
    while (file >> name) {
        std::vector<REAL> got;
%s        if (got.empty()) return 2;
        const auto expected = read_all(file, static_cast<int>(2*got.size()));
        if (expected.size() < 2*got.size()) return 2;
        for (std::size_t i = 0; i < got.size(); ++i) {
            ++tried;
            const auto found = static_cast<double>(got[i]);
            const auto right = static_cast<double>(expected[2*i]);
            const auto off = static_cast<double>(expected[2*i + 1]);
            if (!(std::fabs(found - right) <= off) && !(std::isnan(found) && std::isnan(right))) {
                ++missed;
                std::printf("%%s, result %%d: %%.17g instead of %%.17g\\n", name.c_str(),
                            static_cast<int>(i), found, right);
            }
        }
    }
    std::printf("%%d values, %%d missed\\n", tried, missed);
    return tried == 0 || missed > 0;
}
"""

TARGET = Cpp()
