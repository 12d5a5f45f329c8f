"""The package's own kernels: what the exporter writes for arrays and in C, committed.

``kernels/ufuncs.cpp`` makes NumPy's ufuncs from the C; this module writes the table that it needs.
``kernels/filter.cpp`` is what they ask before the C, ``kernels/delay.cpp`` finds delay margins.
"""

from __future__ import annotations

import re
from copy import copy
from difflib import unified_diff
from hashlib import sha256
from itertools import chain
from pathlib import Path

from symhaptic.export import plain, request
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

_WRITTEN = ("*.py", "*.pyi", "*.c", "table.h")

_BY_HAND = [
    FOLDER / name
    for name in ("ufuncs.cpp", "filter.cpp", "filter.h", "delay.cpp", "ordinary.cpp", "ordinary.h")
]

_INSIDE = ("LateDevice",)
"""Routines of the library that are ufuncs, too, for callers that have checked the ranges."""

_OF_NUMBERS = (
    "discretize",
    "is_stable",
    "unstable_roots",
    "stability_boundary",
    "passivity_margin",
)
"""Functions that are called one by one in loops; plain Python is then faster than arrays of one."""

_ABOUT = '''"""How does a call compute?  The stable forms as generated code, which imports nothing.

* `haptic.c`, `haptic_single.c`, `table.h`: the functions in C, in two precisions, and their list
* ``haptic``, ``scalar``: the same functions for arrays of any library, and some for floats
* `ufuncs.cpp`: their loops over arrays; `filtered_loop` is that of `is_stable`
* `filter.cpp`: judges most walls of that loop, in blocks
* `ordinary.cpp`: computes other functions of ordinary arguments in blocks
* `delay.cpp`: finds most delay margins

`symhaptic kernels` writes the first five from the routines of `export/routines`; the others and
their headers are written by hand.  Imports nothing; used by ``numeric``.
"""

STAMP = "%s"
"""Of the sources in C, as the module that is compiled of them has it."""

OF_NUMBERS = %s
"""The functions that `scalar` has, too."""
'''

_BOTH = """#include <math.h>
#include <stdbool.h>

/* Compiled once in each precision: what is a number, an operation or a name in it. */
#ifdef SINGLE
#define REAL float
#define NAME(name) haptic_single_##name
#define M(operation) operation##f
#define R(number) number##f
#define PICK(in_double, in_single) in_single
#else
#define REAL double
#define NAME(name) haptic_##name
#define M(operation) operation
#define R(number) number
#define PICK(in_double, in_single) in_double
#endif

"""

_KEPT = """#ifdef _MSC_VER
#define EACH_THREAD __declspec(thread)
#else
#define EACH_THREAD __thread
#endif

/* What is made of the device alone: that of the call before is kept, as most arrays have one
 * device. -0.0 is 0.0 here, as it is for the comparison. */
#define KEEP(Kind, name) \\
    static inline Kind name(REAL gamma, REAL delta) { \\
        static EACH_THREAD REAL last[2] = {NAN, NAN}; \\
        static EACH_THREAD Kind kept; \\
        if (last[0] == gamma && last[1] == delta) return kept; \\
        last[0] = gamma + R(0.0); last[1] = delta + R(0.0); \\
        return kept = name##_anew(last[0], last[1]); \\
    }
#define KEEP_PART(Kind, name) \\
    static inline Kind name(REAL gamma, REAL delta, REAL part) { \\
        static EACH_THREAD REAL last[3] = {NAN, NAN, NAN}; \\
        static EACH_THREAD Kind kept; \\
        if (last[0] == gamma && last[1] == delta && last[2] == part) return kept; \\
        last[0] = gamma + R(0.0); last[1] = delta + R(0.0); last[2] = part + R(0.0); \\
        return kept = name##_anew(last[0], last[1], last[2]); \\
    }

"""

_DEVICE = re.compile(
    r"^static inline (Device\d*|Delayed) (\w+)"
    r"(\(REAL gamma,\s+REAL delta(, REAL part)?\) \{\n.*?^\}\n)",
    re.M | re.S,
)
"""A function of the device alone."""


def keeping(source: str) -> str:
    """Sources in C whose functions of the device alone keep the last one."""

    def kept(found: re.Match[str]) -> str:
        kind, name, rest, part = found.groups()
        again = f"KEEP{'_PART' if part else ''}({kind}, {name})"
        return f"static inline {kind} {name}_anew{rest}{again}\n"

    return _DEVICE.sub(kept, source)


_SINGLE = """#define SINGLE
#include "haptic.c"
"""

_TABLE = """#ifndef TABLE_H
#define TABLE_H

#include <math.h>

#define STAMP "%(stamp)s"

extern "C" {
%(heads)s
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
    """The files of the folder, by name: for arrays of all libraries, for numbers, and in C."""
    every = forms()
    _, made = request.built(TARGETS["numpy"], every, vectors=False)
    some = [form for form in every if form.name in _OF_NUMBERS]
    made |= request.built(plain.TARGET, some, "scalar", vectors=False)[1]
    sources, heads = [], []
    for precision, name in ((DOUBLE, "haptic"), (SINGLE, "haptic_single")):
        language = copy(TARGETS["c"].at(precision))
        language.samples = False
        library, files = request.built(language, every, name, vectors=False)
        whole = [_shown(library, language, helper) for helper in _inside(library)]
        sources.append("\n".join([files[f"{name}.c"], *map("\n".join, whole)]))
        heads += re.findall(r"^\w+ \w+\([^)]*\);$", files[f"{name}.h"], re.M)
        heads += [f"{head.removesuffix(' {')};" for head, *_ in whole]
    in_c = {"haptic.c": _BOTH + _KEPT + keeping(both(*sources)), "haptic_single.c": _SINGLE}
    by_hand = [path.read_text(encoding="utf-8") for path in _BY_HAND]
    parts = [*in_c.values(), *by_hand, _table(library, heads, "")]
    stamp = sha256("".join(parts).encode()).hexdigest()[:16]
    in_c |= {"table.h": _table(library, heads, stamp), "_compiled.pyi": _typed(library)}
    names = ", ".join(f'"{name}"' for name in _OF_NUMBERS)
    made |= {"__init__.py": _ABOUT % (stamp, f"({names})")} | in_c
    return {
        name: (_REMARK if name.endswith((".c", ".h")) else _HEADER) + text
        for name, text in made.items()
    }


_TOKEN = re.compile(r"\d[\w.]*(?:(?<=e)[-+]\d+f?)?|\w+|\S")


def both(double: str, single: str) -> str:
    """One source of two that say the same in either precision.

    >>> both("double y = exp(x) + 0.5;", "float y = expf(x) + 0.5f;")
    'REAL y = M(exp)(x) + R(0.5);'
    """
    found: list[str] = []
    parts = [source.split("\n\n") for source in (double, single)]
    parts = [[part for part in own if not part.startswith("#include")] for own in parts]
    for one, other in zip(*parts, strict=True):
        tokens = _TOKEN.findall(one), _TOKEN.findall(other)
        merged = list(map(_in_both, *tokens)) if len({*map(len, tokens)}) == 1 else [""]
        if all(merged):
            gaps = _TOKEN.split(one)
            text = "".join(chain(*zip(gaps, [*merged, ""], strict=True)))
            found.append("\n".join(wrapped(text.split("\n"))))
        else:
            found.append(f"#ifndef SINGLE\n{one}\n#else\n{other}\n#endif")
    return "\n\n".join(found)


def _in_both(double: str, single: str) -> str:
    """A token that stands for both, if there is one."""
    number = double[0].isdigit()
    if single == double or (double, single) == ("double", "float"):
        return double if single == double else "REAL"
    if single == f"{double}f":
        return f"{'R' if number else 'M'}({double})"
    if number and single[0].isdigit():
        return f"PICK({double}, {single})"
    name = double.removeprefix("haptic_")
    return f"NAME({name})" if single == f"haptic_single_{name}" else ""


def _inside(library: Library) -> list[Routine]:
    return [helper for helper in library.helpers if helper.name in _INSIDE]


def _shown(library: Library, language: Target, routine: Routine) -> list[str]:
    """A function that gives what one inside of its file gives."""
    real, name = language.real, language.call(routine.name)
    given = [language.rename(s.name) for s in routine.arguments]
    outs = [own for own, _ in routine.results]
    arguments = [f"{real} {own}" for own in given] + [f"{real} *{own}_out" for own in outs]
    return [
        f"void {library.name}_{name}({', '.join(arguments)}) {{",
        f"    const {routine.record} found = {name}({', '.join(given)});",
        *(f"    *{own}_out = found.{own};" for own in outs),
        "}",
        "",
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
        "heads": "\n".join(wrapped(" ".join(head.split()) for head in heads)),
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
        "certain_roots: ufunc",
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
