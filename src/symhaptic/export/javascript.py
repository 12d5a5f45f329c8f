"""JavaScript, as a module."""

from __future__ import annotations

from types import MappingProxyType

from symhaptic.export import reserved
from symhaptic.export.branches import guarded
from symhaptic.export.language import Target, called, describe
from symhaptic.export.reserved import vocabulary
from symhaptic.export.routine import Library, Routine
from symhaptic.export.statements import braces, wrapped
from symhaptic.version import __version__


class Javascript(Target):
    """One module, and the same as a script; several results are an array."""

    name, title = "javascript", "JavaScript"
    changing = "let"
    each = (
        "for (let n = {first}; n >= {last}; n -= {step}) {{",
        "    const {name} = inverse_factorial[n];",
    )
    times = "for (let {0} = 0; {0} < {1}; ++{0}) {{"
    words = MappingProxyType({"==": "===", "!=": "!=="})
    keywords = vocabulary(
        "arguments await break case catch class const continue debugger default delete do else "
        "enum eval export extends false finally for function if implements import in instanceof "
        "interface let new null package private protected public return static super switch this "
        "throw true try typeof var void while with yield NaN Infinity undefined Math"
    )
    shares = True
    modules = reserved.JAVASCRIPT
    operations = called(
        "Math.",
        Infinity="Infinity",
        NaN="NaN",
        TwoProdError="two_prod_error({0}, {1})",
    )

    def source(self, library: Library) -> dict[str, str]:
        """NAME.mjs, a module, and the same as a script."""
        lines: list[str] = []
        if table := self.table(library):
            lines += ["// 1/n!", f"const inverse_factorial = [{table}];", ""]
        for helper in library.helpers:
            lines += [f"// {helper.about}", *self._written(helper, "function")]
        for form, routine in zip(library.forms, library.public, strict=True):
            lines += ["/**", *(f" * {line}" for line in describe(form, self.precision)), " */"]
            lines += self._written(routine, _EXPORT)
        name, lines = library.name, wrapped(lines)
        plain = [line.replace(_EXPORT, "function", line.startswith(_EXPORT)) for line in lines]
        names = wrapped(
            [f"const found = {{ {', '.join(self.call(r.name) for r in library.public)} }};"]
        )
        script = [
            f'// For <script src="{name}.script.js">, after which {name} has all functions,',
            "// and for require(), which gives them.",
            "(() => {",
            '"use strict";',
            "",
            *plain,
            *names,
            'if (typeof module === "object") module.exports = found;',
            f"else globalThis.{name} = found;",
            "})();",
            "",
        ]
        return {
            f"{name}.mjs": "\n".join(lines),
            f"{name}.script.js": "\n".join(script),
        }

    def package(self, library: Library) -> dict[str, str]:
        """For npm, with types for TypeScript of the module and of what require() gives."""
        lines = []
        for form, routine in zip(library.forms, library.public, strict=True):
            args = ", ".join(f"{self.rename(s.name)}: number" for s in routine.arguments)
            kind = "boolean" if routine.truth else "number"
            if len(routine.results) > 1:
                kind = f"[{', '.join(f'{name}: number' for name, _ in routine.results)}]"
            lines += ["/**", *(f" * {line}" for line in describe(form, self.precision)), " */"]
            lines += [f"{_EXPORT} {self.call(routine.name)}({args}): {kind};", ""]
        name, types = library.name, "\n".join(wrapped(lines))
        words = {"name": name, "title": library.title, "release": __version__}
        return {
            "package.json": _PACKAGE % words,
            f"{name}.d.mts": types,
            f"{name}.script.d.ts": types,
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

    def unpacked(self, names: list[str], function: str, args: str) -> str:
        """From an array."""
        return f"const [{', '.join(names)}] = {function}({args});"

    def notes(self, library: Library) -> list[str]:
        """How a page loads it."""
        name = library.name
        return [
            "The folder is a package: after `npm install ./FOLDER`, `import` and `require` find",
            f"{name}, and TypeScript finds its types. `npm test` in the folder runs the self-test.",
            f"Node can also load {name}.mjs directly. Browsers load a module only from a server.",
            f"For pages opened as files, {name}.script.js contains the same functions as a script:",
            f"{name}.{library.public[0].name} and so on.",
            "An argument that is not a number (text, null, or missing) is outside every domain.",
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
  "name": "%(name)s",
  "version": "%(release)s",
  "description": "%(title)s",
  "private": true,
  "sideEffects": false,
  "main": "./%(name)s.script.js",
  "types": "./%(name)s.script.d.ts",
  "exports": {
    "import": { "types": "./%(name)s.d.mts", "default": "./%(name)s.mjs" },
    "require": { "types": "./%(name)s.script.d.ts", "default": "./%(name)s.script.js" }
  },
  "scripts": { "test": "node selftest.mjs" }
}
"""

_SELFTEST = """import { readFileSync } from "node:fs";
import * as library from "./NAME.mjs";
import same from "./NAME.script.js";

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
    const script = [same[name](...numbers.slice(0, call.length))].flat();
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
