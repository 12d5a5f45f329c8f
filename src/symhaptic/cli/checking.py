"""Check: somebody's own code beside exact values."""

from __future__ import annotations

from typing import Annotated

import typer

from symhaptic.cli.shared import app, refuse


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
    points: Annotated[int, typer.Option("--points", metavar="N", min=1, help="How many.")] = 10000,
    arguments: Annotated[
        str | None,
        typer.Option("--arguments", metavar="X,...", help="The order that your function has."),
    ] = None,
    github: Annotated[
        bool, typer.Option("--github", help="Print a failure as an annotation of GitHub's.")
    ] = False,
    table: Annotated[
        bool, typer.Option("--table", help="Print points and exact values as CSV; call nothing.")
    ] = False,
    listing: Annotated[bool, typer.Option("--list", help="Print what can be checked.")] = False,
) -> None:
    """Check a function of your own against exact values: 0 agrees, 1 differs, 2 bad usage."""
    from symhaptic.check import callers
    from symhaptic.check.compare import compared
    from symhaptic.check.formulas import CHECKED
    from symhaptic.notation.suggest import suggested

    if listing:
        for name, one in CHECKED.items():
            typer.echo(f"{name}({', '.join(one.ranges)}) -> {', '.join(one.results)}")
        return
    if formula not in CHECKED:
        refuse(f"--formula: {formula!r} is not known; {suggested(str(formula), CHECKED)}")
    if table:
        from symhaptic.check.table import csv_text

        typer.echo(csv_text(CHECKED[formula], points), nl=False)
        return
    if sum(given is not None for given in (python, library, command)) != 1:
        refuse("--python, --library, --command: exactly one of them is needed")
    if not ulp >= 0:
        refuse(f"--ulp: {ulp} is not allowed; numbers >= 0 are")
    checked = CHECKED[formula]
    order = [name.strip() for name in (arguments or ",".join(checked.ranges)).split(",")]
    if sorted(order) != sorted(checked.ranges):
        known = ", ".join(checked.ranges)
        refuse(f"--arguments: {arguments!r} is not allowed; an order of {known} is")
    places = [list(checked.ranges).index(name) for name in order]
    try:
        if python is not None:
            call = callers.python(python, len(checked.results))
        elif library is not None:
            call = callers.library(library, len(order), len(checked.results))
        else:
            call = callers.command(str(command))
        found = compared(
            checked, lambda some: call([tuple(p[i] for i in places) for p in some]), ulp, points
        )
    except ValueError as wrong:
        refuse(str(wrong))
    at = ", ".join(f"{n} = {v.hex()}" for n, v in zip(checked.ranges, found.at, strict=True))
    said = f"{formula}: {found.points} points, worst error {found.worst:.3g} ulp of {found.result}"
    if found.worst <= ulp:
        typer.echo(f"{said}; agrees")
        return
    said += f" at {at}; NaN at {found.missing} points"
    said += "".join(f"; {name}" for name in found.names)
    typer.echo(f"::error title=symhaptic check::{said}" if github else f"{said}; differs")
    raise typer.Exit(1)
