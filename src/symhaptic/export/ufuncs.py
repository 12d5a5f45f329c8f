"""The exported C as ufuncs of NumPy: a module of C, and its types, from the same description."""

from __future__ import annotations

import sympy as sp

from symhaptic.export.code_names import code_name
from symhaptic.export.described import describe
from symhaptic.export.module import Library
from symhaptic.export.routine import Routine
from symhaptic.export.target import Target
from symhaptic.export.ufunc_templates import CALL, LOOP, LOOPS, MODULE_TEXT
from symhaptic.export.wrapping import wrapped

MODULE = "_compiled"

INSIDE = ("LateDevice",)
"""Routines of the library that are ufuncs, too, for who has asked for its arguments' ranges."""

UNSTAMPED = "of no sources"
"""In the module's source, for what tells the sources that it is compiled of."""


def ufuncs(
    double: Library, single: Library, in_double: Target, in_single: Target
) -> dict[str, str]:
    """MODULE.c, two files of loops that call a library each, which is inside, and MODULE.pyi."""
    entries = [
        _entry(routine, describe(form))
        for form, routine in zip(double.forms, double.public, strict=True)
    ]
    inside = _inside(double)
    entries += [_entry(routine, [f"{routine.about}."]) for routine in inside]
    both = (double, in_double), (single, in_single)
    calls = ["\n".join(wrapped(_call(double, in_double, r).split("\n"))) for r in double.public]
    declared = [
        f"Loop {_name(library, r)};" for library, _ in both for r in (*library.public, *inside)
    ]
    numbers = {
        "module": MODULE,
        "stamp": UNSTAMPED,
        "double": double.name,
        "single": single.name,
        "loops": "\n".join(declared),
        "entries": "\n".join(entries),
        "calls": "\n".join(calls),
        "methods": "\n".join(f"    ONE({routine.name})," for routine in double.public),
    }
    made = {f"{MODULE}.c": MODULE_TEXT % numbers}
    for library, language in both:
        every = (*library.public, *_inside(library))
        loops = [_loop(library, language, routine) for routine in every]
        text = LOOPS % {"name": library.name, "loops": "\n".join(loops)}
        made[f"{library.name}_loops.c"] = "\n".join(wrapped(text.split("\n")))
    typed = [
        "from typing import Any\n\nfrom numpy import ufunc\n",
        *(f"{code_name(routine.name)}: ufunc" for routine in (*double.public, *inside)),
        "\nSTAMP: str\n\ndef outside() -> bool: ...",
        *(f"def one_{routine.name}(*numbers: Any) -> Any: ..." for routine in double.public),
    ]
    return made | {f"{MODULE}.pyi": "\n".join([*typed, ""])}


def _inside(library: Library) -> list[Routine]:
    return [helper for helper in library.helpers if helper.name in INSIDE]


def _name(library: Library, routine: Routine) -> str:
    return f"{library.name}_{code_name(routine.name)}_loop"


def _loop(library: Library, language: Target, routine: Routine) -> str:
    """One ufunc's inner loop in one precision: a call an element, and whether all is in range."""
    kind, given, count = language.real, len(routine.arguments), len(routine.results)
    names = [language.rename(symbol.name) for symbol in routine.arguments]
    x, y = [f"x{i}" for i in range(given)], [f"y{i}" for i in range(count)]
    work = [f"const {kind} {n} = *({kind} const *){at};" for n, at in zip(names, x, strict=True)]
    call = f"{library.name}_{routine.name}({', '.join(names)}"
    if routine.record:
        call = f"{language.call(routine.name)}({', '.join(names)})"
        work += [f"const {routine.record} found = {call};"]
        fields = zip(y, routine.results, strict=True)
        work += [" ".join(f"*({kind} *){at} = found.{name};" for at, (name, _) in fields)]
    elif count > 1:
        work += [f"{call}, {', '.join(f'({kind} *){at}' for at in y)});"]
    else:
        work += [f"*({'npy_bool' if routine.truth else kind} *){y[0]} = {call});"]
    within = language.printing().doprint(sp.And(*routine.within))
    if routine.truth or routine.outside is not sp.nan:
        work += [f"within &= {within};"]
    elif routine.within:  # NaN tells that it may be outside
        first = f"*({kind} *){y[0]}"
        work += [f"if ({first} != {first} && !({within})) within = 0;"]
    places = [*x, *y]
    return LOOP % {
        "name": _name(library, routine),
        "places": ", ".join(f"*{at} = at[{i}]" for i, at in enumerate(places)),
        "steps": ", ".join(f"s{i} = steps[{i}]" for i in range(len(places))),
        "work": "\n".join(f"        {line}" for line in work),
        "on": " ".join(f"{at} += s{i};" for i, at in enumerate(places)),
    }


def _call(library: Library, language: Target, routine: Routine) -> str:
    """A call with numbers of Python's: what the ufunc gives, or None."""
    given, count = len(routine.arguments), len(routine.results)
    names = [language.rename(symbol.name) for symbol in routine.arguments]
    call = f"{library.name}_{routine.name}({', '.join(names)}"
    if count > 1:
        work = f"double y[{count}];\n    {call}, {', '.join(f'&y[{i}]' for i in range(count))});"
    else:
        work = f"{'const int' if routine.truth else 'const double'} y = {call});"
    if routine.truth:
        end = "return truth(y);"
    else:
        end = f"return numbers({'y' if count > 1 else '&y'}, {count});"
    known = ", ".join(f"{n} = x[{i}]" for i, n in enumerate(names))
    return CALL % {
        "name": routine.name,
        "given": given,
        "known": known,
        "within": language.printing().doprint(sp.And(*routine.within)),
        "work": work,
        "end": end,
    }


def _entry(routine: Routine, about: list[str]) -> str:
    """One ufunc's entry of the table: its name, what it takes and gives, what it says."""
    given, count = len(routine.arguments), len(routine.results)
    names = ", ".join(symbol.name for symbol in routine.arguments)
    results = ", ".join(name for name, _ in routine.results)
    said = "\n    ".join(
        f'"{_quoted(line)}\\n"' for line in (f"{results} of ({names})", "", *about)
    )
    truth = str(int(routine.truth))
    return f"    ENTRY({code_name(routine.name)}, {given}, {count}, {truth},\n    {said}),"


def _quoted(line: str) -> str:
    return line.replace("\\", "\\\\").replace('"', '\\"')
