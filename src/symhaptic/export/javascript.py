"""JavaScript, as a module."""

from __future__ import annotations

from types import MappingProxyType

from sympy.printing.jscode import JavascriptCodePrinter

from symhaptic.export.branches import lazy
from symhaptic.export.library import Library
from symhaptic.export.printing import Printing
from symhaptic.export.routine import Routine
from symhaptic.export.statements import braces
from symhaptic.export.target import Target, called, describe, vocabulary


class _Printer(Printing, JavascriptCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations."""


class Javascript(Target):
    """One module; several results are an array."""

    name, title, printer = "javascript", "JavaScript", _Printer
    changing = "let"
    times = "for (let {0} = 0; {0} < {1}; ++{0}) {{"
    words = MappingProxyType({"==": "===", "!=": "!=="})
    keywords = vocabulary(
        "arguments await break case catch class const continue debugger default delete do else "
        "enum eval export extends false finally for function if implements import in instanceof "
        "interface let new null package private protected public return static super switch this "
        "throw true try typeof var void while with yield NaN Infinity undefined Math"
    )
    operations = called(
        "Math.",
        Infinity="Infinity",
        NaN="NaN",
        ProductError="product_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.mjs."""
        lines = []
        for helper in library.helpers:
            lines += [f"// {helper.about}", *self._written(helper, "function")]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += ["/**", *(f" * {line}" for line in describe(form)), " */"]
            lines += self._written(routine, "export function")
        return {f"{library.name}.mjs": "\n".join(lines)}

    def _written(self, routine: Routine, word: str) -> list[str]:
        args = ", ".join(self.rename(s.name) for s in routine.arguments)
        count = len(routine.results)
        values = ", ".join(f"{{{i}}}" for i in range(count))
        end = f"return [{values}];" if count > 1 else "return {0};"
        head = f"{word} {self.call(routine.name)}({args}) {{"
        return [head, *braces(self, lazy(routine), [end], "const"), "}", ""]

    def unpacked(self, names: list[str], function: str, args: str) -> list[str]:
        """From an array."""
        return [f"const [{', '.join(names)}] = {function}({args});"]

    def usage(self, library: Library) -> str:
        """An import of the first function."""
        return f'import {{ {library.public[0].name} }} from "./{library.name}.mjs";'

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.mjs."""
        return {"selftest.mjs": _SELFTEST.replace("NAME", library.name)}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a module is strict."""
        return [["node", "--throw-deprecation", "selftest.mjs"]]


_SELFTEST = """import { readFileSync } from "node:fs";
import * as library from "./NAME.mjs";

// -0x1.8000000000000p+1, always with 13 digits
function parse(word) {
    const part = /^(-?)0x([01])\\.([0-9a-f]{13})p([+-]\\d+)$/.exec(word);
    const size = Number(BigInt("0x" + part[2] + part[3])) * 2 ** (Number(part[4]) - 52);
    return part[1] ? -size : size;
}

let tried = 0;
let missed = 0;
for (const line of readFileSync("vectors.txt", "utf8").trim().split("\\n")) {
    const [name, ...words] = line.split(" ");
    const numbers = words.map(parse);
    const call = library[name];
    const got = [call(...numbers.slice(0, call.length))].flat();
    got.forEach((value, i) => {
        const [expected, allowed] = numbers.slice(call.length + 2 * i);
        tried += 1;
        if (!(Math.abs(value - expected) <= allowed)) {
            missed += 1;
            console.log(`${name}, result ${i}: ${value} instead of ${expected}`);
        }
    });
}
console.log(`${tried} values, ${missed} missed`);
process.exit(tried === 0 || missed > 0 ? 1 : 0);
"""

TARGET = Javascript()
