"""Check: somebody's own code beside exact values."""

from __future__ import annotations

import math
from enum import StrEnum
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.cli.shared import app, only_listed, refuse, writable, write

if TYPE_CHECKING:
    from symhaptic.check.checked import Checked


_MOST = 10**6
"""Points that fit into memory, with their results and exact values."""

_LARGEST = 1e6
"""Seconds and GiB at most: far more than there are, and few enough for the system's clocks."""


class CheckFormat(StrEnum):
    """How `check` prints."""

    text = "text"
    github = "github"
    junit = "junit"
    json = "json"
    table = "table"


@app.command()
def check(
    formula: Annotated[
        str | None, typer.Option("--formula", metavar="ID", help="One of the names in --list.")
    ] = None,
    python: Annotated[
        str | None,
        typer.Option("--python", metavar="MODULE:NAME", help="A Python function; it is run."),
    ] = None,
    library: Annotated[
        str | None,
        typer.Option(
            "--library",
            metavar="FILE:NAME",
            help="A C function: doubles by value, then pointers for several results.",
        ),
    ] = None,
    command: Annotated[
        str | None,
        typer.Option(
            "--command",
            metavar="CMD",
            help="A program that reads lines of numbers and prints lines of results.",
        ),
    ] = None,
    ulp: Annotated[
        float, typer.Option("--ulp", metavar="N", help="Largest error, in units in the last place.")
    ] = 8,
    points: Annotated[
        int | None,
        typer.Option(
            "--points",
            metavar="N",
            min=1,
            max=_MOST,
            help="Number of points. Default: 10000, or as many as the function computes in 5 s.",
        ),
    ] = None,
    over: Annotated[
        list[str] | None,
        typer.Option("--over", metavar="X=LOW:HIGH", help="Range of an argument; repeatable."),
    ] = None,
    timeout: Annotated[
        float, typer.Option("--timeout", metavar="S", help="Time limit of your function in s.")
    ] = 60,
    memory: Annotated[
        float, typer.Option("--memory", metavar="GIB", help="Memory limit of your function in GiB.")
    ] = 4,
    arguments: Annotated[
        str | None,
        typer.Option("--arguments", metavar="X,...", help="Arguments in your function's order."),
    ] = None,
    format: Annotated[
        CheckFormat,
        typer.Option(
            "--format",
            help="text, github (annotation), junit, json or table (CSV; without a function, only "
            "points and exact values).",
        ),
    ] = CheckFormat.text,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write to FILE, not to the screen.")
    ] = None,
    listing: Annotated[bool, typer.Option("--list", help="Print what can be checked.")] = False,
) -> None:
    """Compare your function with exact values.

    Exit status: 0 if it agrees, 1 if it differs, 2 for bad usage.
    """
    from symhaptic.check import report
    from symhaptic.check.callers import Theirs, python_name
    from symhaptic.check.compare import POINTS, compared
    from symhaptic.check.formulas import CHECKED
    from symhaptic.notation.suggest import suggested

    writable(output)
    if listing:
        only_listed(output=output, formula=formula, python=python, library=library, command=command)
        for name, one in CHECKED.items():
            typer.echo(
                f"{name}({', '.join(one.arguments)}) -> {', '.join(one.results)}{_says(one)}"
            )
        return
    if formula is None:
        refuse("--formula: is needed; `symhaptic check --list` lists all")
    if formula not in CHECKED:
        every = "`symhaptic check --list` lists all"
        refuse(f"--formula: {formula!r} is not known; {suggested(formula, CHECKED, every)}")
    checked = CHECKED[formula]
    ways = {"python": python, "library": library, "command": command}
    given = {kind: name for kind, name in ways.items() if name is not None}
    if not 0 <= ulp < math.inf:
        refuse(f"--ulp: {ulp} is not a finite number >= 0; give one")
    for option, value in (("--timeout", timeout), ("--memory", memory)):
        if not 0 < value <= _LARGEST:
            refuse(f"{option}: {value} is not a number > 0 and <= {_LARGEST:g}; give one")
    order = _order(checked, arguments)
    narrower = _narrower(checked, over or [])
    if format is CheckFormat.table and not given:
        if arguments is not None:
            refuse(f"--arguments: {arguments!r} is for a function; leave it out of an exact table")
        _tell(_exact_table(checked, points or POINTS, narrower), output)
        return
    if len(given) != 1:
        refuse("--python, --library, --command: give exactly one of them")
    ((kind, name),) = given.items()
    begin = perf_counter()
    try:
        if kind == "python":
            python_name(name)
        numbers = len(order), len(checked.results), timeout, memory
        theirs = Theirs(kind, name, *numbers)
        _not_read(output, theirs.files())
        with theirs:
            _not_read(output, theirs.files())
            found = compared(
                checked,
                lambda some: theirs([tuple(p[i] for i in order) for p in some]),
                ulp,
                points,
                narrower,
            )
            if found.agrees:
                theirs.finish()
    except ValueError as wrong:
        said = str(wrong).replace("the function ", f"--{kind} {name}: ", 1)
        refuse(said if said.startswith("-") else f"--over: {said}")
    result = report.Report(found, name, perf_counter() - begin, theirs.place())
    _tell(report.FORMATS[format](result), output)
    if not found.agrees:
        raise typer.Exit(1)


def _not_read(output: Path | None, files: set[Path]) -> None:
    if output is not None and output.resolve() in files:
        refuse(f"-o {output}: this file is read here; give another one")


def _order(checked: Checked, arguments: str | None) -> list[int]:
    """Where each argument of somebody's function is among those of the formula."""
    names = list(checked.arguments)
    given = ",".join(names) if arguments is None else arguments
    order = [name.strip() for name in given.split(",")]
    if sorted(order) != sorted(names):
        refuse(f"--arguments: {arguments!r} does not name each argument; order {', '.join(names)}")
    return [names.index(name) for name in order]


def _narrower(checked: Checked, over: list[str]) -> dict[str, tuple[float, float]]:
    """Ranges such as ``d=0:12`` by the names of their arguments."""
    from symhaptic.check.points import not_in

    found: dict[str, tuple[float, float]] = {}
    for word in over:
        name, _, ends = word.partition("=")
        try:
            low, high = map(float, ends.split(":"))
        except ValueError:
            low, high = 1.0, 0.0
        if name not in checked.arguments or not -math.inf < low <= high < math.inf:
            known = ", ".join(checked.arguments)
            refuse(f"--over: {word!r} is no range; give NAME=LOW:HIGH with one of {known}")
        if name in found:
            refuse(f"--over: {word!r} is a second range of {name}; give one")
        if why := not_in(checked.arguments[name], low, high):
            refuse(f"--over: {word!r} {why}")
        found[name] = low, high
    return found


def _exact_table(checked: Checked, points: int, narrower: dict[str, tuple[float, float]]) -> str:
    """Points and exact values."""
    from symhaptic.check import report

    try:
        return report.exact_table(checked, points, narrower)
    except ValueError as wrong:
        refuse(f"--over: {wrong}")


def _says(checked: Checked) -> str:
    """What the paper's equation is."""
    from symhaptic.paper import STATEMENTS

    return f": {STATEMENTS[checked.printed].says}" if checked.printed else ""


def _tell(made: str, output: Path | None) -> None:
    if output is None:
        typer.echo(made, nl=False)
        return
    from symhaptic.book.listing import replace

    write(replace, output, made)
