"""The command `mutants`: every statement with one change, which must be refused."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from symhaptic.cli.given import Derivations, SourceFolder, chapters_in, own_chapters, told_bad
from symhaptic.cli.shared import app, refuse, writable, write


@app.command()
def mutants(
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            metavar="FILE",
            help="Write the record to FILE. Default for the paper: reports/mutants.json.",
        ),
    ] = None,
    workers: Annotated[int, typer.Option("--workers", min=1, help="Number of processes.")] = 2,
    derivation: Derivations = None,
    source: SourceFolder = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail if the file is stale.")
    ] = False,
) -> None:
    """Change every statement and table in one place; fail if a wrong change is accepted.

    With --derivation or --source, change the statements of your own chapters or source instead.
    """
    from symhaptic.book import chapters, listing
    from symhaptic.book.mutation import trials

    if source is not None and derivation:
        refuse(f"--source {source}: does not go with --derivation; leave one of them out")
    own = own_chapters(derivation) if source is None else chapters_in(source)
    output = output or (None if own else Path("reports/mutants.json"))
    if check and output is None:
        refuse("--check: the record is needed; -o FILE names it")
    if check and output is not None and not output.is_file():
        refuse(
            f"--check: there is no record {output}; write one with `symhaptic mutants -o {output}`"
        )
    writable(output)
    if output is not None and not trials.ours(output):
        refuse(f"-o {output}: is there and not written by `symhaptic mutants`; give another name")
    found = []
    try:
        for trial in trials.trials(own or chapters.shipped(), workers):
            found.append(trial)
            typer.echo(f"{trial.chapter}: {trial.refused} refused", err=True)
    except chapters.BadChapter as wrong:
        told_bad(wrong, own)
        raise typer.Exit(2) from None
    accepted = [survivor for trial in found for survivor in trial.accepted]
    for survivor in accepted:
        typer.echo(f"ACCEPTED  {survivor.of}: {survivor.change}")
    stale = False
    if output is not None and check:
        stale = trials.stale(output, found)
    elif output is not None:
        write(listing.replace, output, trials.committed(found))
    survivors = sum(len(trial.survivors) for trial in found) - len(accepted)
    typer.echo(
        f"{'' if output is None or check else f'wrote {output}: '}"
        f"{sum(trial.refused for trial in found)} changes refused, "
        f"{survivors} survive with a reason, {len(accepted)} accepted though wrong"
    )
    if stale:
        typer.echo(f"symhaptic: {output} is stale; `symhaptic mutants` writes it", err=True)
    none = not any(trial.refused or trial.survivors for trial in found)
    if none:
        typer.echo("symhaptic: there is nothing to change, which is not a pass", err=True)
    if accepted or stale or none:
        raise typer.Exit(1)
