"""The README of an export: formulas, units, domain, accuracy, and how to test it."""

from __future__ import annotations

import re
import shlex
import textwrap
from collections.abc import Sequence
from functools import cache
from itertools import islice

import sympy as sp
from sympy import Expr

from symhaptic.export.accuracy import DERIVATIVES, MEASURED
from symhaptic.export.language import Target, beyond, sizes
from symhaptic.export.precision import Precision
from symhaptic.export.rounding import Goal, goals, told
from symhaptic.export.routine import Library, parts, rewritten
from symhaptic.export.vectors import allowed
from symhaptic.forms.device_forms import ANY
from symhaptic.forms.entire import ALL, written_out
from symhaptic.forms.implicit import FractionalPart, ImplicitFunction, Rated, SomePart, WholePart
from symhaptic.forms.response import closed
from symhaptic.forms.root_count import FractionalRoots, WholeRoots
from symhaptic.forms.stable import Form
from symhaptic.model import loop
from symhaptic.model.parts import Parts
from symhaptic.notation import SYMBOLS, beta, d, delta, epsilon, gamma, l

MARK = "Written by `symhaptic export`; do not edit."


def readme(library: Library, target: Target, count: int) -> str:
    """The text, in Markdown."""
    commands = [shlex.join(command) for command in target.commands(library.name)]
    lines = [
        f"# {library.title}",
        "",
        MARK,
        "",
        f"{target.title}, {target.precision.name} precision. All quantities are dimensionless, in",
        "units of the moving mass m and the sampling period T: alpha = K T^2/m, beta = B T/m,",
        "gamma = k T^2/m, delta = b T/m, d = t_d/T, theta = omega T.",
        "",
        "```",
        target.usage(library),
        "```",
        "",
        *_contract(library),
        *target.notes(library),
        "",
        f"The self-test reads {count} lines of vectors.txt, with exact hexadecimal numbers, and",
        "ends with status 1 if an error is larger than allowed:",
        "",
        "```",
        *commands,
        "```",
        "",
    ]
    for form, routine in zip(library.forms, library.public, strict=True):
        lines += _function(form, target.precision, goals(routine, target))
    meanings = _meanings(library)
    if meanings:
        lines += ["## The functions in these formulas", ""]
        lines += [
            "Where a closed form is 0/0 or loses digits, another form or a series is used.",
            "",
        ]
        lines += [f"- {name}: {meaning}" for name, meaning in sorted(meanings.items())]
        lines.append("")
    return "\n".join(lines)


def _contract(library: Library) -> list[str]:
    """What holds outside of a domain, and what is no number."""
    lines = [
        "Every function first checks its arguments. Outside its domain, and for NaN and infinite",
        "arguments, a result is NaN.",
    ]
    names = {form.name for form in library.forms}
    if "is_stable" in names:
        lines += [
            "is_stable is a truth value: true if the loop is stable, and false if it is not, or if",
            "rounding errors do not allow a decision.",
        ]
    if "verdict" in names:
        lines += [
            "verdict is 1 if and only if is_stable is true. It is 0 if the loop is certainly not",
            "stable, and -1 if it is undecided: a root is so close to the unit circle that the",
            "bounds on the rounding errors exclude neither side, or an argument is outside the",
            "domain. Compare it with 1: as a truth value, -1 counts as true.",
        ]
    if "unstable_roots" in names:
        lines += [
            "unstable_roots is an integer, returned as a float because a delay may be long. It is",
            "-1, never 0, outside the domain, and if a root is so close to the unit circle that",
            "rounding errors do not allow a decision on which side it lies.",
        ]
    return [*textwrap.wrap(" ".join(lines), 88), ""]


def _meanings(library: Library) -> dict[str, str]:
    """What the formulas are made of, and what that is made of."""
    every = parts(e for form in library.forms for e in form.expressions)
    found = {type(f).__name__: f.meaning for f in every if hasattr(f, "meaning")}
    for name in ("Kick", "Echo", "PlantN0", "PlantN1", "Spread", "Chord", "C", "S"):
        if any(re.search(rf"\b{name}\b", text) for text in found.values()):
            found[name] = ALL[name].meaning
    return found


_LONG = 60
"""Operations from which on a derivative is named, and not written out."""


def _derivatives(form: Form, results: tuple[tuple[str, Expr], ...]) -> list[str]:
    by = form.title.rpartition("with respect to ")[2]
    lines = [
        "",
        f"Derivatives with respect to {by}. They consist of functions without singularities, too:",
    ]
    lines += [""]
    for name, expr in results:
        result, _, argument = name.rpartition("_by_")
        lines.append(
            f"    {name} = {expr}" if _short(expr) else f"    {name} = d {result}/d {argument}"
        )
    return lines


def _measured(form: Form, precision: Precision) -> list[str]:
    """The worst of all results, and what is to say of it."""
    plain = form.plain or form
    records = [MEASURED] if form.plain is None else [MEASURED, DERIVATIVES]
    found = [r[precision][plain.name] for r in records if plain.name in r[precision]]
    if len(found) < len(records):
        return []
    error = max(worst.error for worst in found)
    return [
        "",
        f"Largest measured error: {error:g} units in the last place of the largest",
        "term, in C, for the loop with all its parts (gcc, glibc, x86-64).",
        *(line for worst in found for line in textwrap.wrap(worst.remark, 80)),
    ]


@cache
def _formulas(form: Form) -> list[str]:
    """In plain text and as LaTeX; long ones in steps, each with a name."""
    if not any(expr.has(sp.Piecewise) for expr in form.expressions):
        return _written(form.results)
    whole = [(name, _side(expr, 0).xreplace({WholePart(d): d})) for name, expr in form.results]
    parted = {WholePart(d): l, SomePart(d): epsilon, FractionalPart(d): epsilon}
    late = [(name, _side(expr, 1).xreplace(parted)) for name, expr in form.results]
    return ["For integer delays:", "", *_written(whole), "",
            "For fractional delays, d = l + epsilon:", "", *_written(late)]  # fmt: skip


def _side(expr: Expr, which: int) -> Expr:
    """With one side of all that is chosen by whether the delay has a fraction."""
    return rewritten(expr, lambda e: e.args[which].expr if isinstance(e, sp.Piecewise) else e)


def _written(results: Sequence[tuple[str, sp.Expr]]) -> list[str]:
    if not all(_short(expr) for _, expr in results):
        steps, found = sp.cse([expr for _, expr in results], order="canonical")
        named = [*steps, *zip((name for name, _ in results), found, strict=True)]
        return [f"    {name} = {expr}" for name, expr in named]
    plain = [line for name, expr in results for line in (f"    {name} = {expr}", "")]
    return [*plain, *shown] if (shown := _as_in_the_book(results)) else plain[:-1]


def _as_in_the_book(results: Sequence[tuple[str, sp.Expr]]) -> list[str]:
    """In LaTeX, the entire functions written out; of counted roots the polynomial that has them.

    What is searched for has no formula of its own: the plain text names it.
    """
    if any(expr.has(WholeRoots, FractionalRoots) for _, expr in results):
        return _polynomial({s for _, expr in results for s in expr.free_symbols})
    found = []
    for name, expr in results:
        whole = written_out(closed(expr.replace(Rated, lambda _, value: value)))
        text = f"$${sp.latex(sp.Symbol(name))} = {sp.latex(whole)}$$"
        found += [text] * (len(text) < _WIDE and not whole.has(ImplicitFunction))
    return found


def _polynomial(symbols: set[sp.Basic]) -> list[str]:
    """What is asked of its roots; behind a fraction of a period the book has the device's."""
    if l in symbols:
        return []
    beta_, delay = beta in symbols, d in symbols
    parts = Parts(gamma in symbols, delta in symbols, beta_, delay)
    characteristic = sp.latex(loop.closing(ANY, parts))
    lines = ["The roots are those of the characteristic polynomial, with discretize's numbers,", ""]
    return [*lines, f"$$p(z) = {characteristic}$$"]


_WIDE = 900
"""Letters of a formula that is still read."""


def _short(expr: sp.Expr) -> bool:
    return len(list(islice(sp.preorder_traversal(expr), _LONG))) < _LONG


def _function(form: Form, precision: Precision, proved: list[Goal]) -> list[str]:
    lines = [f"## {form.name}", "", f"{form.title[0].upper()}{form.title[1:]}.", ""]
    if form.arguments:
        lines += ["| argument | unit | range | meaning |", "|---|---|---|---|"]
        for symbol in form.arguments:
            row = SYMBOLS[symbol.name]
            lines.append(f"| {row.name} | {row.unit} | {row.domain} | {row.meaning} |")
        lines.append("")
    if form.domain:
        lines += [f"Domain: {', '.join(form.domain)}.", ""]
    if form.arguments:
        none = f"{beyond(form)}, and if an argument is NaN or {sizes(form, precision)}."
        lines += [none, ""]
    plain = form.plain or form
    lines += _formulas(plain)
    if form.plain is not None:
        lines += _derivatives(form, form.results[len(plain.results) :])
    lines += _measured(form, precision)
    lines += told(proved, precision)
    most = allowed(form)
    lines += ["", f"The self-test allows {most} units in the last place of the largest term.", ""]
    return lines
