"""The package's own kernels: what the exporter writes for arrays and in C, committed.

``kernels/ufuncs.cpp`` makes ufuncs of NumPy of the C; what it does so for is written here.
"""

from __future__ import annotations

from difflib import unified_diff
from hashlib import sha256
from pathlib import Path

from symhaptic.export import request
from symhaptic.export.language import Target, describe
from symhaptic.export.precision import DOUBLE, SINGLE
from symhaptic.export.routine import Library, Routine, code_name
from symhaptic.export.statements import wrapped
from symhaptic.export.targets import TARGETS
from symhaptic.forms import stable
from symhaptic.forms.stable import Form

FOLDER = Path(__file__).parents[1] / "kernels"

_HEADER = "# Written by `symhaptic kernels` from the stable forms; do not edit.\n"

_REMARK = "/* Written by `symhaptic kernels` from the stable forms; do not edit. */\n"

_WRITTEN = ("*.py", "*.pyi", "*.c", "*.h")

_UFUNCS = FOLDER / "ufuncs.cpp"

_INSIDE = ("LateDevice",)
"""Routines of the library that are ufuncs, too, for who has asked for its arguments' ranges."""

_ABOUT = '''"""How large is it, bare?  The stable forms as functions of arrays of any library.

Nothing symbolic; written by `symhaptic kernels`.  Imports nothing; used by ``numeric``.
"""

STAMP = "%s"
"""Of the sources in C, as the module that is compiled of them has it."""
'''

_TABLE = """#ifndef TABLE_H
#define TABLE_H

#include <math.h>

#include "haptic.h"
#include "haptic_single.h"

#define STAMP "%(stamp)s"

extern "C" {
%(inside)s
}

/* What is true of each argument inside its range alone. */
%(ranges)s

/* Each kernel with what it says and its arguments. */
#define KERNELS(KERNEL) \\
%(kernels)s

#define INSIDE(KERNEL) \\
%(others)s

#endif
"""


def forms() -> list[Form]:
    """All forms of a whole scene but those of one delay."""
    return [stable.form(name) for name in stable.FORMS if name not in stable.FOR_ONE_DELAY]


def files() -> dict[str, str]:
    """The files of the folder, by name: for arrays of all libraries, and in C for NumPy's."""
    every = forms()
    _, made = request.built(TARGETS["numpy"], every, vectors=False)
    double, in_c = request.built(TARGETS["c"], every, vectors=False)
    single, more = request.built(TARGETS["c"].at(SINGLE), every, "haptic_single", vectors=False)
    in_c |= more
    heads: list[str] = []
    for library, language in ((double, TARGETS["c"]), (single, TARGETS["c"].at(SINGLE))):
        for helper in _inside(library):
            head, *body = _shown(library, language, helper)
            heads.append(f"{head};")
            in_c[f"{library.name}.c"] += "\n".join(wrapped(["", f"{head} {{", *body, "}", ""]))
    ufuncs = _UFUNCS.read_text(encoding="utf-8")
    stamp = sha256("".join([*in_c.values(), ufuncs, _table(double, heads, "")]).encode())
    stamp_ = stamp.hexdigest()[:16]
    in_c |= {"table.h": _table(double, heads, stamp_), "_compiled.pyi": _typed(double)}
    made |= {"__init__.py": _ABOUT % stamp_} | in_c
    return {
        name: (_REMARK if name.endswith((".c", ".h")) else _HEADER) + text
        for name, text in made.items()
    }


def _inside(library: Library) -> list[Routine]:
    return [helper for helper in library.helpers if helper.name in _INSIDE]


def _shown(library: Library, language: Target, routine: Routine) -> list[str]:
    """The head and the body of a function that gives what one inside of its file gives."""
    real, name = language.real, language.call(routine.name)
    given = [language.rename(s.name) for s in routine.arguments]
    outs = [own for own, _ in routine.results]
    arguments = [f"{real} {own}" for own in given] + [f"{real} *{own}_out" for own in outs]
    return [
        f"void {library.name}_{name}({', '.join(arguments)})",
        f"    const {routine.record} found = {name}({', '.join(given)});",
        *(f"    *{own}_out = found.{own};" for own in outs),
    ]


def _table(library: Library, heads: list[str], stamp: str) -> str:
    within = {
        symbol: form.within[i] for form in library.forms for i, symbol in enumerate(form.arguments)
    }
    ranges = []
    for symbol, condition in within.items():
        ranges.append(f"struct in_{symbol.name} {{")
        for precision in (DOUBLE, SINGLE):
            language = TARGETS["c"].at(precision)
            name = language.rename(symbol.name)
            shown = language.printing().doprint(precision.at(condition))
            ranges.append(f"    static bool inside({language.real} {name}) {{ return {shown}; }}")
        ranges.append("};")
    kernels = [
        _kernel(routine, describe(form))
        for form, routine in zip(library.forms, library.public, strict=True)
    ]
    others = [_kernel(routine, [f"{routine.about}."], "") for routine in _inside(library)]
    return _TABLE % {
        "stamp": stamp,
        "inside": "\n".join(wrapped(heads)),
        "ranges": "\n".join(ranges),
        "kernels": " \\\n".join(kernels),
        "others": " \\\n".join(others),
    }


def _kernel(routine: Routine, about: list[str], ranges: str = ", in_") -> str:
    """A line of the table: a kernel's name, what it says, and its arguments."""
    names = [symbol.name for symbol in routine.arguments]
    results = ", ".join(name for name, _ in routine.results)
    lines = (f"{results} of ({', '.join(names)})", "", *about)
    said = " \\\n    ".join(
        '"{}\\n"'.format(line.replace("\\", "\\\\").replace('"', '\\"')) for line in lines
    )
    given = "".join(f"{ranges}{name}" for name in names) if ranges else ""
    return f"KERNEL({code_name(routine.name)}, \\\n    {said}{given})"


def _typed(library: Library) -> str:
    public = [routine.name for routine in library.public]
    lines = [
        "from typing import Any\n\nfrom numpy import ufunc\n",
        *(f"{code_name(n)}: ufunc" for n in (*public, *(r.name for r in _inside(library)))),
        "\nSTAMP: str\n\ndef outside() -> bool: ...",
        *(f"def one_{name}(*numbers: Any) -> Any: ..." for name in public),
    ]
    return "\n".join([*lines, ""])


def _there(folder: Path) -> list[Path]:
    """Those of a folder that are written here."""
    return [path for pattern in _WRITTEN for path in folder.glob(pattern)]


def differences(folder: Path = FOLDER) -> str:
    """A diff from what is there to what would be written; empty if nothing is stale."""
    lines: list[str] = []
    new = files()
    there = {path.name for path in _there(folder)}
    for name in sorted(there | set(new)):
        old = (folder / name).read_text(encoding="utf-8") if name in there else ""
        lines += unified_diff(
            old.splitlines(True), new.get(name, "").splitlines(True), f"a/{name}", f"b/{name}"
        )
    return "".join(lines)


def write(folder: Path = FOLDER) -> None:
    """All files, each whole or not at all, and no others."""
    folder.mkdir(exist_ok=True)
    new = files()
    for name, text in new.items():
        draft = folder / f".{name}-draft"
        draft.write_text(text, encoding="utf-8")
        draft.replace(folder / name)
    for path in _there(folder):
        if path.name not in new:
            path.unlink()
