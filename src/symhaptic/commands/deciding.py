"""Verify and mutants: what asks whether the chapters are right."""

from __future__ import annotations

import time
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.commands.shared import (
    app,
    progress,
    refuse,
    writable,
    write,
)
from symhaptic.suggest import suggested

if TYPE_CHECKING:
    from symhaptic.ledger import Entry


class ListFormat(StrEnum):
    """How `verify` prints."""

    text = "text"
    json = "json"
    junit = "junit"


LISTED = "`symhaptic verify --list` lists all"

Derivations = Annotated[
    list[Path] | None,
    typer.Option("--derivation", metavar="FILE", help="A chapter of your own; may be repeated."),
]


def settled(paths: list[Path], workers: int) -> tuple[list[Entry], list[str]]:
    """The statements that derivations settle, and what went wrong."""
    from symhaptic import parallel

    with progress(len(paths)) as told:
        outcomes = parallel.settled(paths, workers, told)
    errors = [outcome.error for outcome in outcomes if outcome.error is not None]
    return [entry for outcome in outcomes for entry in outcome.entries], errors


def own_chapters(paths: list[Path] | None) -> list[Path]:
    """A user's chapters, which are looked at before any is run."""
    from symhaptic.library import BadChapter, looked_at

    try:
        return [looked_at(path) for path in paths or []]
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
    names_only: Annotated[bool, typer.Option("--list", help="Print the statements' ids.")] = False,
    derivation: Derivations = None,
) -> None:
    """Decide the paper's statements; fail where a verdict is not the committed one."""
    from symhaptic import ledger, library, listing, parallel

    writable(output)
    own = own_chapters(derivation)
    wanted = ids or []
    known = ledger.expected(library.expected_ledger())
    if names_only:
        typer.echo("\n".join(known))
        return
    for id in wanted if not own else []:
        if id not in known:
            refuse(f"ID: {id!r} is not a statement; {suggested(id, known, LISTED)}")
    begin = time.perf_counter()
    paths = own + listing.needed(wanted, library.shipped())
    raw, errors = settled(paths, workers or parallel.workers())
    raw.sort(key=lambda entry: (entry.derivation or "").startswith("derivations/"), reverse=True)
    entries = ledger.ledger(raw)
    if wanted:
        if errors and set(wanted) - {e.statement.id for e in entries}:
            refuse(f"--derivation {errors[0]}")
        names = {e.statement.id: e for e in entries}
        for id in wanted:
            if id not in names:
                refuse(f"ID: {id!r} is not a statement; {suggested(id, names, LISTED)}")
        entries = [names[id] for id in dict.fromkeys(wanted)]
    surprises = ledger.twice(raw)
    surprises += filter(None, map(ledger.judged_again, raw))
    surprises += ledger.surprises([*entries, *ledger.covered(raw, entries)], known, not wanted)
    undecided = [e for e in entries if e.verdict.kind == "undecided"]
    text = {
        ListFormat.text: listing.text,
        ListFormat.json: listing.json_text,
        ListFormat.junit: listing.junit,
    }[format](entries, surprises, strict, errors, time.perf_counter() - begin)
    # a machine that reads the outcome is told of an error in it, a person on one line
    if output is not None and not (errors and format is ListFormat.text):
        write(listing.replace, output, text)
    elif output is None and not errors:
        typer.echo(text, nl=False)
    if errors:
        more = f"; and {len(errors) - 1} more" if errors[1:] else ""
        refuse(f"--derivation {errors[0]}{more}")
    if surprises or (strict and undecided):
        raise typer.Exit(1)


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
