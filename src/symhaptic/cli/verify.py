"""The command `verify`: the verdicts on all statements, and the exit status if one has changed."""

from __future__ import annotations

import gc
import os
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.cli.given import Derivations, SourceFolder, chapters_in, own_chapters, read, told_bad
from symhaptic.cli.shared import app, folder_allowed, only_listed, progress, refuse, writable, write
from symhaptic.notation.suggest import suggested

if TYPE_CHECKING:
    from symhaptic.book.chapters import BadChapter
    from symhaptic.book.ledger import Entry


class ListFormat(StrEnum):
    """How `verify` prints."""

    text = "text"
    json = "json"
    junit = "junit"


LISTED = "`symhaptic verify --list` lists all"


def settled(paths: list[Path], workers: int, own: list[Path], bad: list[BadChapter]) -> list[Entry]:
    """The statements that derivations settle; those that cannot be run are told at once."""
    from symhaptic.book import parallel

    def failed(wrong: BadChapter) -> None:
        bad.append(wrong)
        told_bad(wrong, own)

    with progress(len(paths)) as told:
        return parallel.settled(paths, workers, told, failed)


@app.command()
def verify(
    ids: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[ID]...",
            help="Statements, such as eq11. Default: all, or those of --derivation.",
        ),
    ] = None,
    format: Annotated[ListFormat, typer.Option("--format", help="Form of the output.")] = (
        ListFormat.text
    ),
    output: Annotated[
        Path | None, typer.Option("-o", metavar="FILE", help="Write to FILE, not to the screen.")
    ] = None,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            help="Also fail if a statement has no verdict, or is undecided or external and the "
            "ledger does not say so, or if its formula, proposition, definitions, condition, "
            "correction or counterexample differs from the ledger (the file of committed "
            "verdicts).",
        ),
    ] = False,
    workers: Annotated[
        int | None, typer.Option(min=1, metavar="N", help="Number of processes. Default: up to 4.")
    ] = None,
    derivation: Derivations = None,
    source: SourceFolder = None,
    listed: Annotated[
        bool, typer.Option("--list", help="List the statements with their places and contents.")
    ] = False,
    rocq: Annotated[
        Path | None,
        typer.Option(
            "--rocq", metavar="DIR", help="Write the theorems for Rocq to DIR and check them."
        ),
    ] = None,
    as_recorded: Annotated[
        bool,
        typer.Option(
            "--as-recorded",
            help="With --rocq: check completely only ID and the chapters that the record has "
            "whole. Check only the basic steps (leaves) of the others, without those that Rocq "
            "refused before.",
        ),
    ] = False,
) -> None:
    """Prove or refute the paper's statements; fail if a verdict differs from the committed one.

    For each ID, print the paper's own words, our reading and the proposition before the verdict.

    With --derivation, verify the statements of your own chapters, or ID.  With --source, verify
    those of your own source; its committed verdicts are in DIR/ledger.json.
    """
    # SymPy, which reads this when it is imported, then forgets nothing while a chapter is run
    os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
    from time import perf_counter

    from symhaptic.book import SELDOM

    gc.set_threshold(SELDOM)
    from symhaptic.book import chapters, committed, ledger, listing, parallel
    from symhaptic.cli.rocq import judged, stale, whole

    writable(output)
    if source is not None and (derivation or listed):
        refuse(f"--source {source}: does not go with --derivation or --list; leave these out")
    if as_recorded and (rocq is None or source is not None):
        refuse("--as-recorded: is for the paper's statements and --rocq DIR; give that alone")
    if listed:
        only_listed(strict=strict, rocq=rocq, workers=workers)
        name_statements(ids or [], format, output, derivation)
        return
    wanted = ids or []
    if source is not None:
        own, shipped = chapters_in(source), list[Path]()
        known: dict[str, str] | None = committed_beside(source)
    else:
        own = own_chapters(derivation)
        known = committed.expected(chapters.expected_ledger())
    for id in wanted if not own else []:
        if known is not None and id not in known:
            refuse(f"ID: {id!r} is not a statement; {suggested(id, known, LISTED)}")
    others = list[Path]()
    if source is None:
        given = {path.resolve() for path in own}
        others = [p for p in chapters.shipped() if p.resolve() not in given]
        asked = wanted + whole() if as_recorded else wanted
        shipped = listing.needed(asked, others) if asked or not own else []
    if output is not None and output.resolve() in {path.resolve() for path in read(own, source)}:
        refuse(f"-o {output}: is the input file; give another one")
    if rocq is not None:
        if format is ListFormat.junit:
            refuse("--format junit: does not go with --rocq; give text or json")
        folder_allowed(rocq, "--rocq")
        as_json = format is ListFormat.json
        paths = own + (others if as_recorded else shipped)
        leaves = frozenset(others) - frozenset(shipped)
        raise typer.Exit(judged(paths, wanted, rocq, workers, output, as_json, leaves, as_recorded))
    bad: list[BadChapter] = []
    begin = perf_counter()
    found = settled(own + shipped, workers or parallel.workers(), own, bad)
    found, several = ledger.once(found, committed.places(chapters.expected_ledger()))
    for id, files in several.items():
        path = next(p for p in (*reversed(own), *shipped) if chapters.source(p) in files)
        bad.append(chapters.BadChapter(path, ledger.twice(id, files)))
        told_bad(bad[-1], own)
    entries = ledger.ledger(found, None if source is None else chapters.source_beside(own[0]))
    everything = not wanted and (source is not None or not own)
    if not everything and not wanted:
        ours = {entry.statement.id for entry in found}
        entries = [entry for entry in entries if entry.statement.id in ours]
    if wanted:
        names = {e.statement.id: e for e in entries}
        for id in wanted:
            if id not in names and not bad:
                refuse(f"ID: {id!r} is not a statement; {suggested(id, names, LISTED)}")
        entries = [names[id] for id in dict.fromkeys(wanted) if id in names]
    surprises = [] if known is None else committed.surprises(entries, known, whole=everything)
    if strict:
        surprises += committed.unproved(entries, known)
        if source is not None and known is not None:
            surprises += committed.reworded(entries, source / "ledger.json")
        elif source is None and not own:
            surprises += committed.reworded(entries, chapters.expected_ledger())
    undecided = [e for e in entries if e.verdict.kind == "undecided" and e.derivation is None]
    stale(entries)
    for path in own if source is None and surprises else []:
        if (path.parent / chapters.SOURCE_FILE).is_file():
            typer.echo(
                f"symhaptic: {path} is a chapter of a source; --derivation only requires that its "
                f"statements hold. `symhaptic verify --source {path.parent}` compares "
                "with its ledger",
                err=True,
            )
    text = {
        ListFormat.text: listing.text,
        ListFormat.json: listing.json_text,
        ListFormat.junit: listing.junit,
    }[format](entries, surprises, strict, bad, perf_counter() - begin, bool(wanted))
    if output is None:
        typer.echo(text, nl=False)
    elif not (bad and format is ListFormat.text):
        write(listing.replace, output, text)
    if bad:
        raise typer.Exit(2)
    if strict and not entries:
        typer.echo("symhaptic: there is no statement, which is not a pass", err=True)
        raise typer.Exit(1)
    if surprises or (strict and undecided):
        raise typer.Exit(1)


def committed_beside(source: Path) -> dict[str, str] | None:
    """The verdicts that a user has committed; None where there is nothing of that name."""
    from symhaptic.book import committed

    path = source / "ledger.json"
    if not (path.exists() or path.is_symlink()):
        return None
    try:
        return committed.expected(path)
    except committed.NoLedger as wrong:
        refuse(str(wrong))


def name_statements(
    ids: list[str], format: ListFormat, output: Path | None, derivation: list[Path] | None
) -> None:
    """Print what there is to verify."""
    from symhaptic.book import listing

    if format is ListFormat.junit:
        refuse("--format junit: does not go with --list, which runs nothing; give text or json")
    if derivation:
        refuse(f"--derivation {derivation[0]}: --list runs no chapter; leave one of them out")
    records = {record["id"]: record for record in listing.statements()}
    for id in ids:
        if id not in records:
            refuse(f"ID: {id!r} is not a statement; {suggested(id, records, LISTED)}")
    chosen = [records[id] for id in dict.fromkeys(ids or records)]
    text = listing.names(chosen, format is ListFormat.json)
    if output is None:
        typer.echo(text, nl=False)
    else:
        write(listing.replace, output, text)
