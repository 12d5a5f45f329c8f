"""Trace, bench, export and kernels: what gives numbers, or functions of them."""

from __future__ import annotations

from enum import StrEnum
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer

from symhaptic.cli.shared import (
    app,
    can_draw,
    folder_allowed,
    no_folder,
    only_listed,
    progress,
    refuse,
    write,
)


class TraceFormat(StrEnum):
    """What `trace` writes."""

    csv = "csv"
    json = "json"
    png = "png"
    svg = "svg"
    pdf = "pdf"


@app.command()
def bench(
    quick: Annotated[bool, typer.Option("--quick", help="Fewer points and delays.")] = False,
    output: Annotated[Path, typer.Option("-o", metavar="DIR", help="Folder of the record.")] = Path(
        "reports/bench"
    ),
) -> None:
    """Measure speed against error.

    Write bench.json, tables and, if Matplotlib is installed, plots.
    """
    import os

    folder_allowed(output)
    for library in ("OPENBLAS", "MKL", "OMP"):  # one thread, whatever the library
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    from symhaptic.bench import measuring
    from symhaptic.book.measured.record import FIELDS
    from symhaptic.book.processes import temporary

    with temporary(), progress(len(FIELDS)) as told:
        found = measuring.measured(
            measuring.QUICK if quick else measuring.FULL, lambda done, name: told(done, Path(name))
        )
    try:
        drawn = measuring.write(found, output)
    except OSError as wrong:
        no_folder(output, wrong.strerror)
    what = ", tables and plots" if drawn else " and tables"
    typer.echo(f"wrote {output / 'bench.json'}{what} in {found['seconds']} s")
    if not drawn:
        typer.echo("no plots: they need matplotlib; pip install 'symhaptic[report]'", err=True)


@app.command()
def trace(
    gamma: Annotated[str, typer.Option("--gamma", metavar="G", help="Stiffness k T^2/m.")],
    delta: Annotated[str, typer.Option("--delta", metavar="D", help="Damping b T/m.")],
    delay: Annotated[
        str, typer.Option("--delay", metavar="d", help="Delay in periods, may be fractional.")
    ],
    format: Annotated[
        TraceFormat | None, typer.Option("--format", help="Default: the ending of FILE, or csv.")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write to FILE, not to the screen.")
    ] = None,
) -> None:
    """Trace the stable region of the (alpha, beta) plane."""
    from symhaptic.book import listing
    from symhaptic.numeric.tracing import output as written
    from symhaptic.numeric.tracing.region import stable_region

    format = format_of(output, format)
    drawn = format in (TraceFormat.png, TraceFormat.svg, TraceFormat.pdf)
    if drawn and output is None:
        refuse(f"--format {format}: needs -o FILE; csv and json can be printed")
    if drawn:
        can_draw(f"--format {format}")
    plant = number("gamma", gamma), number("delta", delta)
    periods = number("delay", delay)
    content: str | bytes
    try:
        region = stable_region(*plant, periods)
        if drawn:
            from symhaptic.book.figures.region import picture

            content = picture(region, format)
        else:  # what is asked of the region here may not be there, either
            text = written.json_text if format is TraceFormat.json else written.csv_text
            content = text(region)
    except ValueError as wrong:
        refuse(f"--{wrong}")
    if output is None:
        typer.echo(content, nl=False)
    else:
        write(listing.replace, output, content)


class JuryFormat(StrEnum):
    """How `jury` prints."""

    text = "text"
    json = "json"


@app.command()
def jury(
    delay: Annotated[
        str, typer.Argument(metavar="DELAY", help="Integer number of sampling periods.")
    ],
    gamma: Annotated[
        str | None, typer.Option("--gamma", metavar="G", help="Stiffness k T^2/m of the device.")
    ] = None,
    delta: Annotated[
        str | None, typer.Option("--delta", metavar="D", help="Damping b T/m of the device.")
    ] = None,
    format: Annotated[JuryFormat, typer.Option("--format", help="Form of the output.")] = (
        JuryFormat.text
    ),
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write to FILE, not to the screen.")
    ] = None,
) -> None:
    """Print Jury's inequalities.

    The loop is stable if and only if all of them hold.  They contain alpha = K T^2/m,
    beta = B T/m and the numbers n_1, n_0, a and e of the sampled device.  With --gamma and --delta
    they contain only alpha and beta, with coefficients rounded to 15 digits.
    """
    import json

    from symhaptic.book import listing
    from symhaptic.model import jury as criterion

    if (gamma is None) != (delta is None):
        refuse(f"--{'delta' if delta is None else 'gamma'}: is missing; give both or none")
    device = {
        name: number(name, given)
        for name, given in (("gamma", gamma), ("delta", delta))
        if given is not None
    }
    if not delay.isdecimal():
        refuse(f"DELAY: {delay!r} is not an integer number of periods; give 0, 1, 2, ...")
    if len(delay) > len(str(criterion.LONGEST)) or int(delay) > criterion.LONGEST:
        refuse(f"DELAY: {delay} is not allowed; give at most {criterion.LONGEST} periods")
    try:
        found = criterion.jury(int(delay), **device)
    except ValueError as wrong:
        refuse(f"--{wrong}")
    lines = [str(inequality) for inequality in found]
    if format is JuryFormat.json:
        text = json.dumps({"delay": int(delay), "inequalities": lines}, indent=1) + "\n"
    else:
        text = "\n".join(lines) + "\n"
    if output is None:
        typer.echo(text, nl=False)
    else:
        write(listing.replace, output, text)


@app.command()
def export(
    formulas: Annotated[
        list[str] | None,
        typer.Argument(metavar="[FORMULA]...", help="Functions or equations (eq11). Default: all."),
    ] = None,
    target: Annotated[
        str | None,
        typer.Option(
            "--target", help="numpy, c, cpp, fortran, rust, javascript, octave or microcontroller."
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="DIR", help="Folder of the export. Default: haptic-TARGET."),
    ] = None,
    scene: Annotated[
        list[str] | None,
        typer.Option(
            "--scene",
            metavar="NO-PART,...",
            help="Parts to leave out: no-stiffness,no-damping,no-virtual-damping,no-delay.",
        ),
    ] = None,
    delay: Annotated[
        int | None,
        typer.Option(
            "--delay", metavar="D", help="Periods (integer), for functions of one fixed delay."
        ),
    ] = None,
    whole_delays: Annotated[
        bool, typer.Option("--whole-delays", help="Export code for integer delays only.")
    ] = False,
    precision: Annotated[
        str | None, typer.Option("--precision", help="double, or single if the language has it.")
    ] = None,
    derivative: Annotated[
        list[str] | None,
        typer.Option("--derivative", metavar="X,...", help="Add derivatives by these arguments."),
    ] = None,
    name: Annotated[str, typer.Option("--name", help="Name of the module.")] = "haptic",
    listing: Annotated[bool, typer.Option("--list", help="Print what can be exported.")] = False,
) -> None:
    """Write formulas as source code that needs nothing else, with test vectors and a self-test."""
    from symhaptic.export import request
    from symhaptic.export.language import Refused
    from symhaptic.export.sampled import MARGIN
    from symhaptic.export.targets import TARGETS
    from symhaptic.forms.stable import FOR_ONE_DELAY

    try:
        by = [word.strip() for word in ",".join(derivative or []).split(",") if word.strip()]
        parts = request.scene(",".join(scene or []))
        forms = request.chosen(formulas or [], parts, delay, by, whole_delays)
        if listing:
            only_listed(output=output, target=target, precision=precision)
            if not formulas and parts.delay:
                forms += request.chosen([MARGIN], parts)
            for form in forms:
                args = ", ".join(symbol.name for symbol in form.arguments)
                typer.echo(f"{form.name}({args})\n    {form.title}")
            return
        if target is None:
            refuse(f"--target: is needed; give one of {', '.join(TARGETS)}")
        language = request.target(target, precision)
        folder = output or Path(f"{name}-{target}")
        _, files = request.built(language, forms, name)
        request.write(files, folder)
    except Refused as wrong:
        refuse(str(wrong))
    typer.echo(f"wrote {folder}")
    one = ", ".join(form.name for form in forms if form.name in FOR_ONE_DELAY)
    if one and delay is None and parts.delay:
        typer.echo(f"symhaptic: --delay: is not given, so for one period: {one}", err=True)


@app.command()
def kernels(
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail if a kernel is stale.")
    ] = False,
) -> None:
    """Write the package's own numeric functions (developers)."""
    from symhaptic.export import kernels as own

    if not check:
        try:
            own.write()
        except OSError as wrong:
            refuse(f"{own.FOLDER}: cannot write there ({wrong.strerror}); it has to be writable")
        typer.echo(f"wrote {own.FOLDER}")
        return
    diff = own.differences()
    typer.echo(diff, nl=False)
    if diff:
        typer.echo("symhaptic: a kernel is stale; `symhaptic kernels` writes them", err=True)
        raise typer.Exit(1)


def format_of(output: Path | None, given: TraceFormat | None) -> TraceFormat:
    """The format that is given or that a file's ending names, which have to agree."""
    ending = "" if output is None else output.suffix.lower().removeprefix(".")
    if not ending:
        return given or TraceFormat.csv
    if given is None and ending not in TraceFormat.__members__:
        every = ", ".join(f".{name}" for name in TraceFormat)
        refuse(f"-o {output}: its ending names no format; give one of {every}, or none")
    if given not in (None, ending):
        refuse(f"-o {output}: does not end as --format {given} does; give .{given}, or none")
    return TraceFormat(ending)


def number(name: str, text: str) -> float:
    """The number that an option gives, a fraction too."""
    try:
        return float(Fraction(text) if "/" in text else text)
    except (ValueError, ZeroDivisionError, OverflowError):
        refuse(f"--{name}: {text!r} is not allowed; give a number")
