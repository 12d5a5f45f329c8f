"""Verify, report and mutants: what runs the chapters."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.commands.shared import (
    app,
    close_to,
    folder_allowed,
    progress,
    refuse,
    writable,
    write,
)

if TYPE_CHECKING:
    from symhaptic.ledger import Entry
    from symhaptic.library import BadChapter, Chapter


class ListFormat(StrEnum):
    """How `verify` prints."""

    text = "text"
    json = "json"
    junit = "junit"


class ReportFormat(StrEnum):
    """What `report` writes."""

    tex = "tex"
    pdf = "pdf"


Derivations = Annotated[
    list[Path] | None,
    typer.Option("--derivation", metavar="FILE", help="A chapter of your own; may be repeated."),
]


def chapters_of(paths: list[Path]) -> list[Chapter]:
    """Run derivations one after the other, whole with their pages."""
    from symhaptic.library import BadChapter, run

    done: list[Chapter] = []
    try:
        with progress(len(paths)) as told:
            for path in paths:
                told(len(done), path)
                done.append(run(path))
    except BadChapter as wrong:
        refuse(f"--derivation {wrong}")
    return done


def settled(paths: list[Path], workers: int, own: list[Path], bad: list[BadChapter]) -> list[Entry]:
    """The statements that derivations settle; those that cannot be run are told at once."""
    from symhaptic import parallel

    def failed(wrong: BadChapter) -> None:
        bad.append(wrong)
        told_bad(wrong, own)

    with progress(len(paths)) as told:
        return parallel.settled(paths, workers, told, failed)


def told_bad(wrong: BadChapter, own: list[Path]) -> None:
    """One line on what is wrong with a chapter."""
    given = "--derivation " if wrong.path in own else ""
    typer.echo(f"symhaptic: error: {given}{wrong}", err=True)


def own_chapters(paths: list[Path] | None) -> list[Path]:
    """A user's chapters, which are looked at before anything is run."""
    from symhaptic.library import BadChapter, readable

    try:
        return list({path.resolve(): readable(path) for path in paths or []}.values())
    except BadChapter as wrong:
        refuse(f"--derivation {wrong}")


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
    listed: Annotated[
        bool,
        typer.Option("--list", help="Name the statements, where each stands and what it says."),
    ] = False,
) -> None:
    """Decide the paper's statements; fail where a verdict is not the committed one."""
    from time import perf_counter

    from symhaptic import ledger, library, listing, parallel

    writable(output)
    if listed:
        name_statements(ids or [], format, output, derivation)
        return
    own = own_chapters(derivation)
    wanted = ids or []
    known = ledger.expected(library.expected_ledger())
    for id in wanted if not own else []:
        if id not in known:
            refuse(f"ID: {id!r} is not a statement; allowed are {close_to(id, known)}")
    given = {path.resolve() for path in own}
    shipped = [p for p in listing.needed(wanted, library.shipped()) if p.resolve() not in given]
    bad: list[BadChapter] = []
    begin = perf_counter()
    found = settled(own + shipped, workers or parallel.workers(), own, bad)
    found, several = ledger.once(found, ledger.places(library.expected_ledger()))
    for id, files in several.items():
        path = next(p for p in (*reversed(own), *shipped) if library.source(p) in files)
        bad.append(library.BadChapter(path, ledger.twice(id, files)))
        told_bad(bad[-1], own)
    entries = ledger.ledger(found)
    if wanted:
        names = {e.statement.id: e for e in entries}
        for id in wanted:
            if id not in names and not bad:
                refuse(f"ID: {id!r} is not a statement; allowed are {close_to(id, names)}")
        entries = [names[id] for id in dict.fromkeys(wanted) if id in names]
    surprises = ledger.surprises(entries, known, whole=not wanted)
    undecided = [e for e in entries if e.verdict.kind == "undecided"]
    text = {
        ListFormat.text: listing.text,
        ListFormat.json: listing.json_text,
        ListFormat.junit: listing.junit,
    }[format](entries, surprises, strict, bad, perf_counter() - begin)
    if output is None:
        typer.echo(text, nl=False)
    elif not (bad and format is ListFormat.text):
        write(listing.replace, output, text)
    if bad:
        raise typer.Exit(2)
    if surprises or (strict and undecided):
        raise typer.Exit(1)


def name_statements(
    ids: list[str], format: ListFormat, output: Path | None, derivation: list[Path] | None
) -> None:
    """Print what there is to verify."""
    from symhaptic import listing

    if format is ListFormat.junit:
        refuse("--format junit: nothing is run with --list; allowed are text and json")
    if derivation:
        refuse(f"--derivation {derivation[0]}: a chapter is not run with --list; leave one out")
    records = {record["id"]: record for record in listing.statements()}
    for id in ids:
        if id not in records:
            refuse(f"ID: {id!r} is not a statement; allowed are {close_to(id, records)}")
    chosen = [records[id] for id in dict.fromkeys(ids or records)]
    text = listing.names(chosen, format is ListFormat.json)
    if output is None:
        typer.echo(text, nl=False)
    else:
        write(listing.replace, output, text)


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
    from symhaptic.ledger import Twice
    from symhaptic.report import build

    tex = build.has_tex()
    if format is ReportFormat.pdf and not tex and not check:
        refuse(f"--format pdf: {build.NO_TEX}")
    paths = library.shipped() + own_chapters(derivation)
    try:
        build.check(paths)
        if not check:
            folder_allowed(output)
        elif not output.is_dir():
            refuse(f"-o {output}: is no folder; with --check the folder of a report is allowed")
        chapters = chapters_of(paths)
        if check:
            diff = build.differences(chapters, output)
            typer.echo(diff, nl=False)
            if diff:
                typer.echo(f"symhaptic: {output} is stale; `symhaptic report` writes it", err=True)
                raise typer.Exit(1)
            return
        pdf = tex and format is not ReportFormat.tex
        build.write(chapters, output, pdf, lambda line: typer.echo(line, err=True))
    except (build.ReportError, Twice) as wrong:
        refuse(str(wrong))
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

    writable(output)
    found = []
    for trial in mutation.trials(library.shipped(), workers):
        found.append(trial)
        typer.echo(f"{trial.chapter}: {trial.refused} refused", err=True)
    wrong = [survivor for trial in found for survivor in trial.accepted]
    for survivor in wrong:
        typer.echo(f"ACCEPTED  {survivor.of}: {survivor.change}")
    write(listing.replace, output, mutation.committed(found))
    survivors = sum(len(trial.survivors) for trial in found) - len(wrong)
    typer.echo(
        f"wrote {output}: {sum(trial.refused for trial in found)} changes refused, "
        f"{survivors} survive with a reason, {len(wrong)} accepted though wrong"
    )
    if wrong:
        raise typer.Exit(1)
