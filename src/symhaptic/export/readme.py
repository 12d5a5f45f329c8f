"""The README of an export: formulas, units, domain, accuracy, and how to test it."""

from __future__ import annotations

import shlex

import sympy as sp

from symhaptic.export.accuracy import MEASURED
from symhaptic.export.library import Library
from symhaptic.export.target import Target
from symhaptic.export.vectors import allowed
from symhaptic.model.entire import Entire
from symhaptic.model.stable import Form
from symhaptic.notation import SYMBOLS

MARK = "Written by `symhaptic export`; do not edit."


def readme(library: Library, target: Target, count: int) -> str:
    """The text, in Markdown."""
    commands = [shlex.join(command) for command in target.commands(library.name)]
    lines = [
        f"# {library.title}",
        "",
        MARK,
        "",
        f"{target.title}, double precision. All quantities are dimensionless, in units of the",
        "moving mass m and the sampling period T: alpha = K T^2/m, beta = B T/m, gamma = k T^2/m,",
        "delta = b T/m, d = t_d/T, theta = omega T.",
        "",
        "```",
        target.usage(library),
        "```",
        "",
        f"The self-test reads {count} lines of vectors.txt, with numbers to the last digit, and",
        "ends with status 1 where a value is farther off than allowed:",
        "",
        "```",
        *commands,
        "```",
        "",
    ]
    for form in library.forms:
        lines += _function(form)
    used = {f.func for form in library.forms for e in form.expressions for f in e.atoms(Entire)}
    if used:
        lines += ["## Functions without singularities", ""]
        lines += ["They are computed by a series where the closed form would lose digits.", ""]
        lines += [f"- {f.__name__}: {f.meaning}" for f in sorted(used, key=lambda f: f.__name__)]
        lines.append("")
    return "\n".join(lines)


def _function(form: Form) -> list[str]:
    lines = [f"## {form.name}", "", f"{form.title[0].upper()}{form.title[1:]}.", ""]
    if form.arguments:
        lines += ["| argument | unit | range | meaning |", "|---|---|---|---|"]
        for symbol in form.arguments:
            row = SYMBOLS[symbol.name]
            lines.append(f"| {row.name} | {row.unit} | {row.domain} | {row.meaning} |")
        lines.append("")
    if form.domain:
        lines += [f"Domain: {', '.join(form.domain)}.", ""]
    for name, expr in form.results:
        lines += [f"    {name} = {expr}", ""]
    lines += [f"$${sp.latex(sp.Symbol(name))} = {sp.latex(expr)}$$" for name, expr in form.results]
    measured = MEASURED.get(form.name)
    if measured is not None:
        lines += [
            "",
            f"Largest error measured: {measured:g} units in the last place of the largest",
        ]
        lines += ["term, in C, for the loop with all its parts (gcc, glibc, x86-64)."]
    most = allowed(form)
    lines += ["", f"The self-test allows {most} units in the last place of the largest term.", ""]
    return lines
