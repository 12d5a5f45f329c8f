"""The command line: parses, calls, prints."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

if TYPE_CHECKING:
    from symhaptic.ledger import Entry
    from symhaptic.library import Chapter

app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


class ListFormat(StrEnum):
    """How `verify` prints."""

    text = "text"
    json = "json"
    junit = "junit"


class ReportFormat(StrEnum):
    """What `report` writes."""

    tex = "tex"
    pdf = "pdf"


class TraceFormat(StrEnum):
    """What `trace` writes."""

    csv = "csv"
    json = "json"
    png = "png"
    svg = "svg"


Derivations = Annotated[
    list[Path] | None,
    typer.Option("--derivation", metavar="FILE", help="A chapter of your own; may be repeated."),
]


class Unusable(ValueError):
    """A bad input, with the line that names the argument, its value and what is allowed."""


# Typer carries Click inside or beside itself, depending on its age; this is the base of the
# errors that its parser raises, in either case.
ParserError: type[Exception] = next(
    c for c in typer.BadParameter.__mro__ if c.__name__ in ("TyperException", "ClickException")
)


def _usage(message: str) -> NoReturn:
    raise Unusable(message)


@app.callback(invoke_without_command=True)
def _root(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Derive, verify and typeset the passivity and stability formulas of haptic walls."""
    if version:
        from symhaptic import __version__

        typer.echo(f"symhaptic {__version__}")
    elif context.invoked_subcommand is None:
        typer.echo(context.get_help())


def _chapters(paths: list[Path]) -> list[Chapter]:
    """Run derivations one after the other, whole with their pages."""
    from symhaptic.library import BadChapter, run

    done: list[Chapter] = []
    try:
        with _progress(len(paths)) as told:
            for path in paths:
                told(len(done), path)
                done.append(run(path))
    except BadChapter as wrong:
        _usage(f"--derivation {wrong}")
    return done


def _settled(paths: list[Path], workers: int) -> list[Entry]:
    """The statements that derivations settle."""
    from symhaptic import parallel
    from symhaptic.library import BadChapter

    try:
        with _progress(len(paths)) as told:
            return parallel.settled(paths, workers, told)
    except BadChapter as wrong:
        _usage(f"--derivation {wrong}")


@contextmanager
def _progress(total: int) -> Iterator[Callable[[int, Path], None]]:
    """A progress bar that shows the statement under way, where somebody watches."""
    if not sys.stderr.isatty():
        yield lambda done, path: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from symhaptic.listing import under_way

    columns = (TextColumn("{task.description:32}"), BarColumn(), MofNCompleteColumn())
    console = Console(stderr=True)
    with Progress(*columns, TimeElapsedColumn(), console=console, transient=True) as bar:
        task = bar.add_task("", total=total)
        yield lambda done, path: bar.update(task, completed=done, description=under_way(path))


@app.command()
def verify(
    ids: Annotated[
        list[str] | None,
        typer.Argument(metavar="[ID]...", help="Statements, such as eq11; all if none is given."),
    ] = None,
    format: Annotated[ListFormat, typer.Option("--format", help="How to print.")] = (
        ListFormat.text
    ),
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write there instead of printing.")
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Fail on undecided too.")] = False,
    workers: Annotated[
        int | None,
        typer.Option(min=1, metavar="N", help="Processes side by side; up to 4 if not given."),
    ] = None,
    derivation: Derivations = None,
) -> None:
    """Decide the paper's statements; fail where a verdict is not the committed one."""
    from symhaptic import ledger, library, listing, parallel

    _writable(output)
    own = _own(derivation)
    wanted = ids or []
    known = ledger.expected(library.expected_ledger())
    for id in wanted if not own else []:
        if id not in known:
            _usage(f"ID: {id!r} is not a statement; allowed are {_close(id, known)}")
    paths = listing.needed(wanted, library.shipped()) + own
    entries = ledger.ledger(_settled(paths, workers or parallel.workers()))
    if wanted:
        names = {e.statement.id: e for e in entries}
        for id in wanted:
            if id not in names:
                _usage(f"ID: {id!r} is not a statement; allowed are {_close(id, names)}")
        entries = [names[id] for id in dict.fromkeys(wanted)]
    surprises = ledger.surprises(entries, known, whole=not wanted)
    undecided = [e for e in entries if e.verdict.kind == "undecided"]
    text = {
        ListFormat.text: listing.text,
        ListFormat.json: listing.json_text,
        ListFormat.junit: listing.junit,
    }[format](entries, surprises, strict)
    if output is None:
        typer.echo(text, nl=False)
    else:
        _replace(listing.replace, output, text)
    if surprises or (strict and undecided):
        raise typer.Exit(1)


@app.command()
def report(
    format: Annotated[
        ReportFormat | None,
        typer.Option("--format", help="tex, or pdf where a TeX is installed (the default)."),
    ] = None,
    output: Annotated[Path, typer.Option("-o", metavar="DIR", help="Folder of the report.")] = Path(
        "reports"
    ),
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail where the text there is stale.")
    ] = False,
    derivation: Derivations = None,
) -> None:
    """Write the derivations as LaTeX chapters and a book, with figures and the ledger."""
    from symhaptic import library
    from symhaptic.report import build

    tex = build.has_tex()
    if format is ReportFormat.pdf and not tex and not check:
        _usage(f"--format pdf: {build.NO_TEX}")
    paths = library.shipped() + _own(derivation)
    try:
        build.check(paths, output)
        chapters = _chapters(paths)
        if check:
            diff = build.differences(chapters, output)
            typer.echo(diff, nl=False)
            if diff:
                typer.echo(f"symhaptic: {output} is stale; `symhaptic report` writes it", err=True)
                raise typer.Exit(1)
            return
        pdf = tex and format is not ReportFormat.tex
        build.write(chapters, output, pdf, lambda line: typer.echo(line, err=True))
    except build.ReportError as wrong:
        _usage(str(wrong))
    typer.echo(f"wrote {output / ('book.pdf' if pdf else 'book.tex')}")
    if not pdf and format is None:
        typer.echo(f"no PDF: {build.NO_TEX}", err=True)


@app.command()
def mutants(
    output: Annotated[Path, typer.Option("-o", metavar="FILE", help="Where to write.")] = Path(
        "reports/mutants.json"
    ),
    workers: Annotated[int, typer.Option("--workers", min=1, help="Processes at a time.")] = 2,
) -> None:
    """Change every statement and step in one place; fail where a wrong one is not refused."""
    from symhaptic import library, listing, mutation

    _writable(output)
    found = []
    for trial in mutation.trials(library.shipped(), workers):
        found.append(trial)
        typer.echo(f"{trial.chapter}: {trial.refused} refused", err=True)
    wrong = [survivor for trial in found for survivor in trial.accepted]
    for survivor in wrong:
        typer.echo(f"ACCEPTED  {survivor.of}: {survivor.change}")
    _replace(listing.replace, output, mutation.committed(found))
    survivors = sum(len(trial.survivors) for trial in found) - len(wrong)
    typer.echo(
        f"wrote {output}: {sum(trial.refused for trial in found)} changes refused, "
        f"{survivors} survive with a reason, {len(wrong)} accepted though wrong"
    )
    if wrong:
        raise typer.Exit(1)


@app.command()
def bench(
    quick: Annotated[
        bool, typer.Option("--quick", help="Fewer points and delays; under a minute.")
    ] = False,
    output: Annotated[Path, typer.Option("-o", metavar="DIR", help="Folder of the record.")] = Path(
        "reports/bench"
    ),
) -> None:
    """Measure speed against error; write bench.json, tables and plots."""
    import os

    if output.exists() and not output.is_dir():
        _usage(f"-o {output}: is a file; a folder is allowed")
    for library in ("OPENBLAS", "MKL", "OMP"):  # one thread, whatever the library
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    from symhaptic.bench import output as written
    from symhaptic.bench import record

    try:
        output.mkdir(parents=True, exist_ok=True)
        if not os.access(output, os.W_OK):
            _usage(f"-o {output}: cannot write there; a folder that can be written is allowed")
    except OSError as wrong:
        _usage(f"-o {output}: cannot write there ({wrong.strerror}); another folder is allowed")
    with _progress(len(record.FIELDS)) as told:
        found = record.measured(
            record.QUICK if quick else record.FULL, lambda done, name: told(done, Path(name))
        )
    try:
        written.write(found, output)
    except OSError as wrong:
        _usage(f"-o {output}: cannot write there ({wrong.strerror}); another folder is allowed")
    typer.echo(f"wrote {output / 'bench.json'}, tables and plots in {found['seconds']} s")


@app.command()
def trace(
    gamma: Annotated[str, typer.Option("--gamma", metavar="G", help="Stiffness k T^2/m.")],
    delta: Annotated[str, typer.Option("--delta", metavar="D", help="Damping b T/m.")],
    delay: Annotated[
        str, typer.Option("--delay", metavar="d", help="Delay in periods, fractions exact.")
    ],
    format: Annotated[TraceFormat, typer.Option("--format", help="What to write.")] = (
        TraceFormat.csv
    ),
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write there instead of printing.")
    ] = None,
) -> None:
    """Trace the stable region of the (alpha, beta) plane."""
    from symhaptic import listing
    from symhaptic.tracer import output as written
    from symhaptic.tracer.region import stable_region

    drawn = format in (TraceFormat.png, TraceFormat.svg)
    if drawn and output is None:
        _usage(f"--format {format}: needs -o FILE; csv and json can be printed")
    plant = _number("gamma", gamma), _number("delta", delta)
    periods = _number("delay", delay)
    try:
        region = stable_region(*plant, periods)
    except ValueError as wrong:
        _usage(f"--{wrong}")
    content: str | bytes
    if drawn:
        try:
            from symhaptic.report.region import picture

            content = picture(region, format)
        except ModuleNotFoundError as missing:
            _usage(f"--format {format}: needs {missing.name}; pip install 'symhaptic[report]'")
    else:
        content = (written.json_text if format is TraceFormat.json else written.csv_text)(region)
    if output is None:
        typer.echo(content, nl=False)
    else:
        _replace(listing.replace, output, content)


@app.command()
def export(
    formulas: Annotated[
        list[str] | None,
        typer.Argument(metavar="[FORMULA]...", help="Functions, or eq11 and such; all if none."),
    ] = None,
    target: Annotated[
        str | None,
        typer.Option("--target", help="numpy, c, cpp, fortran, rust, javascript or octave."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="DIR", help="Folder to write; haptic-TARGET if none."),
    ] = None,
    scene: Annotated[
        str,
        typer.Option(
            "--scene",
            help="What the loop lacks: no-stiffness,no-damping,no-virtual-damping,no-delay.",
        ),
    ] = "",
    delay: Annotated[
        int | None,
        typer.Option(
            "--delay", metavar="D", help="Whole periods, where one delay has to be chosen."
        ),
    ] = None,
    precision: Annotated[
        str, typer.Option("--precision", help="double, or single where the language has it.")
    ] = "double",
    derivative: Annotated[
        str,
        typer.Option("--derivative", metavar="X,...", help="Arguments to differentiate by, too."),
    ] = "",
    name: Annotated[str, typer.Option("--name", help="Name of the module.")] = "haptic",
    listing: Annotated[bool, typer.Option("--list", help="Print what can be exported.")] = False,
) -> None:
    """Write stable forms as source code that stands alone, with test vectors and a self-test."""
    from symhaptic.export import request
    from symhaptic.export.target import Refused

    try:
        by = [word.strip() for word in derivative.split(",") if word.strip()]
        forms = request.chosen(formulas or [], request.scene(scene), delay, by)
        if listing:
            for form in forms:
                args = ", ".join(symbol.name for symbol in form.arguments)
                typer.echo(f"{form.name}({args})\n    {form.title}")
            return
        if target is None:
            _usage(
                "--target: is needed; allowed are numpy, c, cpp, fortran, rust, javascript, octave"
            )
        language = request.target(target, precision)
        folder = output or Path(f"{name}-{target}")
        _, files = request.built(language, forms, name)
        request.write(files, folder)
    except Refused as wrong:
        _usage(str(wrong))
    typer.echo(f"wrote {folder}")


@app.command()
def kernels(
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail where a kernel is stale.")
    ] = False,
) -> None:
    """Write the package's own numeric functions from the stable forms."""
    from symhaptic.export import kernels as own

    if not check:
        try:
            own.write()
        except OSError as wrong:
            _unwritable(own.FOLDER, wrong.strerror)
        typer.echo(f"wrote {own.FOLDER}")
        return
    diff = own.differences()
    typer.echo(diff, nl=False)
    if diff:
        typer.echo("symhaptic: a kernel is stale; `symhaptic kernels` writes them", err=True)
        raise typer.Exit(1)


def _number(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        pass
    _usage(f"--{name}: {text!r} is not allowed; a number is")


def _own(paths: list[Path] | None) -> list[Path]:
    """A user's chapters, which must be there before the others are run."""
    from symhaptic.library import BadChapter, found

    try:
        return [found(path) for path in paths or []]
    except BadChapter as wrong:
        _usage(f"--derivation {wrong}")


def _writable(output: Path | None) -> None:
    """Say before the work is done that its result has no place."""
    if output is not None and (output.is_dir() or not output.parent.is_dir()):
        reason = "Is a directory" if output.is_dir() else "No such file or directory"
        _unwritable(output, reason)


def _unwritable(output: Path, reason: str | None) -> NoReturn:
    _usage(f"-o {output}: cannot write there ({reason}); a file in a folder that exists is allowed")


def _replace(
    replace: Callable[[Path, str | bytes], None], output: Path, content: str | bytes
) -> None:
    try:
        replace(output, content)
    except OSError as wrong:
        _unwritable(output, wrong.strerror)


def _close(id: str, known: Iterable[str]) -> str:
    """Ids that look alike, or some to start from."""
    from difflib import get_close_matches

    names = list(known)
    return ", ".join(get_close_matches(id, names, 4, 0.5) or [*names[:3], "...", names[-1]])


def main() -> None:
    """Entry point: one line for a bad input, exit status 2, no traceback."""
    command = typer.main.get_command(app)
    try:
        status = command.main(standalone_mode=False)
    except (ParserError, Unusable) as wrong:
        said = getattr(wrong, "format_message", wrong.__str__)()
        said = said.replace("Value error, ", "")
        if said.startswith("No such"):
            said = f"{said.rstrip('.')}; allowed is what --help lists"
        typer.echo(f"symhaptic: error: {' '.join(said.split())}", err=True)
        raise SystemExit(2) from None
    except (typer.Abort, KeyboardInterrupt):
        typer.echo("symhaptic: interrupted", err=True)
        raise SystemExit(130) from None
    raise SystemExit(status if isinstance(status, int) else 0)
