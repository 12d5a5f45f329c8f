"""`verify --rocq`: theorems are written for Rocq, and its answer is compared with the record."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Container
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from symhaptic.cli.shared import progress, write

if TYPE_CHECKING:
    from symhaptic.book.ledger import Entry
    from symhaptic.rocq.compiled import Taken
    from symhaptic.rocq.outcome import Outcome


_FEW = 5
"""Statements that a line names."""


def judged(
    paths: list[Path],
    wanted: list[str],
    folder: Path,
    workers: int | None,
    output: Path | None,
    as_json: bool,
    leaves: Container[Path],
    as_recorded: bool = False,
) -> int:
    """Write the chapters for Rocq, compile them where it is there, and tell what was checked.

    Of some chapters the leaves alone are; ``as_recorded``, what the record says that Rocq does not
    accept of the same text is left open.

    The exit status: 0, 1 where a statement is not checked as the record says, 2 where a chapter
    cannot be run.
    """
    from symhaptic.book.chapters import BadChapter, expected_rocq
    from symhaptic.book.foreign import recorded
    from symhaptic.book.listing import replace
    from symhaptic.book.parallel import each
    from symhaptic.rocq import compiled, record, together
    from symhaptic.rocq.outcome import Outcome, longest_first

    known = recorded(expected_rocq())
    compiled.prepared(folder)
    work: Callable[[Path], Outcome | Taken] = partial(
        compiled.judged,
        folder=folder,
        leaves=leaves,
        recorded=known["chapters"] if as_recorded else None,
    )
    version = None
    try:
        compiled.prelude_compiled(folder)
        version = compiled.version()
    except compiled.NoRocq as missing:
        typer.echo(f"symhaptic: {missing}; the files are written, and nothing is checked", err=True)
        work = partial(compiled.written, folder=folder)
    done: dict[Path, Outcome | Taken] = {}
    ordered = longest_first(paths, folder)  # so that all workers end together
    status = 0
    with progress(len(paths)) as told:
        for i, one in each(work, ordered, workers or 2, told):
            if isinstance(one, BadChapter):
                typer.echo(f"symhaptic: error: {one}", err=True)
                status = 2
            else:
                done[ordered[i]] = one
    begun = [done[path] for path in paths if path in done]
    taken = [one for one in begun if isinstance(one, compiled.Taken)]
    with progress(len(taken)) as told:
        rests = together.asked(taken, folder, known, workers or 2, told)
    outcomes = [one if isinstance(one, Outcome) else rests[one.outcome.chapter]
                for one in begun]  # fmt: skip
    found = record.record(outcomes, version)
    write(replace, folder / "rocq.json", record.text(found))
    text = record.text(found) if as_json else told_of(outcomes, wanted)
    if output is None:
        typer.echo(text, nl=False)
    else:
        write(replace, output, text)
    if version is not None and status == 0:
        ours = {part: {name: one for name, one in found[part].items() if name in known[part]}
                for part in ("statements", "chapters")}  # fmt: skip
        for line in record.differences(ours, known):
            typer.echo(f"DIFFERS  {line}", err=as_json or output is not None)
            status = 1
    return status


def whole() -> list[str]:
    """The statements of which the record says that Rocq has checked them whole."""
    from symhaptic.book.chapters import expected_rocq
    from symhaptic.book.foreign import WHOLE, recorded

    known = recorded(expected_rocq())["statements"]
    return [id for id, one in known.items() if one["checked"] == WHOLE]


def told_of(outcomes: list[Outcome], wanted: list[str]) -> str:
    """A line for each statement, the slowest chapter, and how many steps were checked."""
    from symhaptic.rocq.record import leaves, why

    lines = []
    counts: Counter[str] = Counter()
    for one in outcomes:
        for id, said in one.statements.items():
            if not wanted or id in wanted:
                lines.append(f"{id}: {why(said) or 'whole'}")
                counts[re.sub(r"^\d+ steps?", "with steps", said.split(":")[0])] += 1
    steps = [one.steps for one in outcomes]
    checked = sum(n for rules in steps for n, _ in rules.values())
    total = sum(n for rules in steps for _, n in rules.values())
    lines.append(f"{', '.join(f'{n} {kind}' for kind, n in sorted(counts.items()))}")
    lines.append(f"{checked} of {total} steps are checked")
    lines += [f"  {kind}: {n} of {m}" for kind, (n, m) in leaves(outcomes).items() if m]
    new = [one for one in outcomes if not one.kept and one.seconds]
    if new:
        slow = max(new, key=lambda one: one.seconds)
        lines.append(f"the slowest chapter, {slow.chapter}, took {slow.seconds:.0f} s")
    return "\n".join(lines) + "\n"


def stale(entries: list[Entry]) -> None:
    """Say of which statements Rocq was asked something else than they now say."""
    old = [entry.statement.id for entry in entries if entry.rocq.stale]
    if old:
        named = ", ".join(old[:_FEW]) + (f" and {len(old) - _FEW} more" if old[_FEW:] else "")
        typer.echo(
            f"symhaptic: what Rocq has checked of {named} is not what is said now; "
            "`symhaptic verify --rocq DIR` asks again",
            err=True,
        )
