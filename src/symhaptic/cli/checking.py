"""Check: somebody's own code beside exact values."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.cli.shared import app, only_listed, refuse, writable, write

if TYPE_CHECKING:
    from symhaptic.check.callers import Caller
    from symhaptic.check.checked import Checked


_MOST = 10**7
"""Points that fit into memory, with what is found at them."""


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
        str | None, typer.Option("--formula", metavar="ID", help="--list names all.")
    ] = None,
    python: Annotated[
        str | None, typer.Option("--python", metavar="MODULE:NAME", help="A Python function.")
    ] = None,
    library: Annotated[
        str | None,
        typer.Option(
            "--library",
            metavar="FILE:NAME",
            help="A C function: doubles by value, several results by pointers behind them.",
        ),
    ] = None,
    command: Annotated[
        str | None,
        typer.Option(
            "--command", metavar="CMD", help="Reads a line of numbers, writes one of results."
        ),
    ] = None,
    ulp: Annotated[float, typer.Option("--ulp", metavar="N", help="Largest error allowed.")] = 8,
    points: Annotated[
        int, typer.Option("--points", metavar="N", min=1, max=_MOST, help="How many.")
    ] = 10000,
    arguments: Annotated[
        str | None,
        typer.Option("--arguments", metavar="X,...", help="The order that your function has."),
    ] = None,
    format: Annotated[
        CheckFormat,
        typer.Option(
            "--format",
            help="text, github (annotation), junit, json or table (CSV; without a function: of "
            "points and exact values).",
        ),
    ] = CheckFormat.text,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write there instead of printing.")
    ] = None,
    listing: Annotated[bool, typer.Option("--list", help="Print what can be checked.")] = False,
) -> None:
    """Check a function of your own against exact values: 0 agrees, 1 differs, 2 bad usage."""
    from symhaptic.check import callers, told
    from symhaptic.check.compare import compared
    from symhaptic.check.formulas import CHECKED
    from symhaptic.notation.suggest import suggested

    writable(output)
    if listing:
        only_listed(output=output, formula=formula, python=python, library=library, command=command)
        for name, one in CHECKED.items():
            typer.echo(f"{name}({', '.join(one.ranges)}) -> {', '.join(one.results)}{_says(one)}")
        return
    if formula is None:
        refuse("--formula: is needed; `symhaptic check --list` lists all")
    if formula not in CHECKED:
        every = "`symhaptic check --list` lists all"
        refuse(f"--formula: {formula!r} is not known; {suggested(formula, CHECKED, every)}")
    checked = CHECKED[formula]
    given = [way for way in (python, library, command) if way is not None]
    if format is CheckFormat.table and not given:
        made = told.exact_table(checked, points)
        _tell(made, output)
        return
    if len(given) != 1:
        refuse("--python, --library, --command: exactly one of them is needed")
    if not 0 <= ulp < float("inf"):
        refuse(f"--ulp: {ulp} is not allowed; finite numbers >= 0 are")
    begin = perf_counter()
    try:
        call = _caller(checked, python, library, command, arguments)
        if output is not None and output.resolve() in callers.files(python, library, command):
            refuse(f"-o {output}: is what is read here; another file is allowed")
        found = compared(checked, call, ulp, points)
    except ValueError as wrong:
        refuse(str(wrong))
    place = callers.place(python) if python is not None else None
    made = told.FORMATS[format](told.Report(found, given[0], perf_counter() - begin, place))
    _tell(made, output)
    if not found.agrees:
        raise typer.Exit(1)


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


def _caller(
    checked: Checked,
    python: str | None,
    library: str | None,
    command: str | None,
    arguments: str | None,
) -> Caller:
    """Somebody's function, with its arguments in its own order."""
    from symhaptic.check import callers

    names = list(checked.ranges)
    order = [name.strip() for name in (arguments or ",".join(names)).split(",")]
    if sorted(order) != sorted(names):
        known = ", ".join(names)
        raise ValueError(f"--arguments: {arguments!r} is not allowed; an order of {known} is")
    if python is not None:
        call = callers.python(python, len(checked.results))
    elif library is not None:
        call = callers.library(library, len(order), len(checked.results))
    else:
        call = callers.command(str(command))
    places = [names.index(name) for name in order]
    return lambda some: call([tuple(p[i] for i in places) for p in some])
