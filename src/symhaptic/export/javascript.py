"""JavaScript, as a module."""

from __future__ import annotations

from types import MappingProxyType

from sympy.printing.jscode import JavascriptCodePrinter

from symhaptic.export import standard
from symhaptic.export.branches import guarded
from symhaptic.export.library import Library
from symhaptic.export.printing import Printing
from symhaptic.export.routine import Routine
from symhaptic.export.statements import braces
from symhaptic.export.target import Target, called, describe, vocabulary
from symhaptic.export.wrapping import wrapped


class _Printer(Printing, JavascriptCodePrinter):  # type: ignore[misc]
    """SymPy's, with the shared operations."""


class Javascript(Target):
    """One module; several results are an array."""

    name, title, printer = "javascript", "JavaScript", _Printer
    changing = "let"
    each = ("for (const {0} of [{1}]) {{",)
    times = "for (let {0} = 0; {0} < {1}; ++{0}) {{"
    words = MappingProxyType({"==": "===", "!=": "!=="})
    keywords = vocabulary(
        "arguments await break case catch class const continue debugger default delete do else "
        "enum eval export extends false finally for function if implements import in instanceof "
        "interface let new null package private protected public return static super switch this "
        "throw true try typeof var void while with yield NaN Infinity undefined Math"
    )
    modules = standard.JAVASCRIPT
    operations = called(
        "Math.",
        Infinity="Infinity",
        NaN="NaN",
        ProductError="product_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.mjs, a module, and the same as a script."""
        lines: list[str] = []
        for helper in library.helpers:
            lines += [f"// {helper.about}", *self._written(helper, "function")]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += ["/**", *(f" * {line}" for line in describe(form, self.precision)), " */"]
            lines += self._written(routine, _EXPORT)
        name, lines = library.name, wrapped(lines)
        plain = [line.replace(_EXPORT, "function", line.startswith(_EXPORT)) for line in lines]
        names = wrapped([f"return {{ {', '.join(self.call(r.name) for r in library.public)} }};"])
        script = [
            f'// For <script src="{name}.script.js">: all functions are in {name}.',
            f"globalThis.{name} = (() => {{",
            '"use strict";',
            "",
            *plain,
            *names,
            "})();",
            "",
        ]
        return {
            f"{name}.mjs": "\n".join(lines),
            f"{name}.script.js": "\n".join(script),
            "package.json": _PACKAGE.replace("NAME", name),
        }

    def _written(self, routine: Routine, word: str) -> list[str]:
        args = ", ".join(self.rename(s.name) for s in routine.arguments)
        count = len(routine.results)
        values = ", ".join(f"{{{i}}}" for i in range(count))
        end = f"return [{values}];" if count > 1 else "return {0};"
        head = f"{word} {self.call(routine.name)}({args}) {{"
        numbers = self._numbers(routine, end) if word == _EXPORT and routine.arguments else []
        body = braces(self, guarded(routine), [end], "const")
        return [head, *numbers, *body, "}", ""]

    def _numbers(self, routine: Routine, end: str) -> list[str]:
        """What text, null and a forgotten argument give: they are outside of every domain."""
        asked = (f'typeof {self.rename(s.name)} !== "number"' for s in routine.arguments)
        nothing = [self.printing().doprint(routine.outside)] * len(routine.results)
        return [f"    if ({' || '.join(asked)}) {{", f"        {end.format(*nothing)}", "    }"]

    def unpacked(self, names: list[str], function: str, args: str) -> list[str]:
        """From an array."""
        return [f"const [{', '.join(names)}] = {function}({args});"]

    def notes(self, library: Library) -> list[str]:
        """How a page loads it."""
        name = library.name
        return [
            f"Node loads {name}.mjs as it is, and the folder by its package.json. Browsers load a",
            f"module from a server alone; {name}.script.js is the same as a script, also for pages",
            f"that are files: its functions are {name}.{library.public[0].name} and so on.",
            "What is no number (text, null, an argument forgotten) is outside of every domain.",
        ]

    def usage(self, library: Library) -> str:
        """An import of the first function."""
        return f'import {{ {library.public[0].name} }} from "./{library.name}.mjs";'

    def selftest(self, library: Library) -> dict[str, str]:
        """selftest.mjs."""
        return {"selftest.mjs": _SELFTEST.replace("NAME", library.name)}

    def commands(self, name: str) -> list[list[str]]:
        """Run; a module is strict."""
        return [["node", "--throw-deprecation", "selftest.mjs"]]


_EXPORT = "export function"

_PACKAGE = """{
  "name": "NAME",
  "version": "0.0.0",
  "private": true,
  "type": "module",
  "exports": "./NAME.mjs"
}
"""

_SELFTEST = """import { readFileSync } from "node:fs";
import * as library from "./NAME.mjs";
import "./NAME.script.js";

// -0x1.8000000000000p+1, always with 13 digits
const special = { nan: NaN, inf: Infinity, "-inf": -Infinity };

function parse(word) {
    if (word in special) return special[word];
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
    const script = [globalThis.NAME[name](...numbers.slice(0, call.length))].flat();
    got.forEach((value, i) => {
        const [expected, allowed] = numbers.slice(call.length + 2 * i);
        tried += 1;
        const close = Math.abs(value - expected) <= allowed && Object.is(value, script[i]);
        if (!close && !(Number.isNaN(value) && Number.isNaN(expected))) {
            missed += 1;
            console.log(`${name}, result ${i}: ${value} instead of ${expected}`);
        }
    });
}
console.log(`${tried} values, ${missed} missed`);
process.exit(tried === 0 || missed > 0 ? 1 : 0);
"""

TARGET = Javascript()
