"""The second judge: theorems written for Rocq, and what it says of them."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from symhaptic.cli.shared import progress

if TYPE_CHECKING:
    from symhaptic.rocq.compiled import Outcome


def judged(paths: list[Path], wanted: list[str], folder: Path, workers: int | None) -> bool:
    """Write the chapters for Rocq, compile them where it is there, and tell what was checked.

    False where a chapter cannot be run.
    """
    from symhaptic.book.chapters import BadChapter
    from symhaptic.book.parallel import each
    from symhaptic.rocq import compiled

    compiled.prepared(folder)
    work: Callable[..., Outcome] = compiled.judged
    try:
        compiled.prelude_compiled(folder)
    except compiled.NoRocq as missing:
        typer.echo(f"symhaptic: {missing}; the files are written, and nothing is checked", err=True)
        work = compiled.written
    found: dict[int, Outcome] = {}
    good = True
    with progress(len(paths)) as told:
        for i, one in each(partial(work, folder=folder), paths, workers or 2, told):
            if isinstance(one, BadChapter):
                typer.echo(f"symhaptic: error: {one}", err=True)
                good = False
            else:
                found[i] = one
    outcomes = [found[i] for i in sorted(found)]
    typer.echo(told_of(outcomes, wanted), nl=False)
    (folder / "rocq.json").write_text(as_json(outcomes), encoding="utf-8")
    return good


def told_of(outcomes: list[Outcome], wanted: list[str]) -> str:
    """A line for each statement, the slowest chapter, and how many steps were checked."""
    lines = []
    counts: Counter[str] = Counter()
    for one in outcomes:
        for id, said in one.statements.items():
            if not wanted or id in wanted:
                lines.append(f"{id}: {said}")
                kind = "whole" if said == "whole" else said.split(":")[0].split(" ", 1)[-1]
                counts[kind] += 1
    steps = [one.steps for one in outcomes]
    checked = sum(n for rules in steps for n, _ in rules.values())
    total = sum(n for rules in steps for _, n in rules.values())
    lines.append(f"{', '.join(f'{n} {kind}' for kind, n in sorted(counts.items()))}")
    lines.append(f"{checked} of {total} steps are checked")
    new = [one for one in outcomes if not one.kept and one.seconds]
    if new:
        slow = max(new, key=lambda one: one.seconds)
        lines.append(f"the slowest chapter, {slow.chapter}, took {slow.seconds:.0f} s")
    return "\n".join(lines) + "\n"


def as_json(outcomes: list[Outcome]) -> str:
    """What was found, without times, so that it is the same from run to run."""
    steps: dict[str, list[int]] = {}
    for one in outcomes:
        for rule, (checked, total) in one.steps.items():
            count = steps.setdefault(rule, [0, 0])
            count[0] += checked
            count[1] += total
    statements = {
        id: {"checked": said, "rests": one.rests.get(id, [])}
        for one in outcomes
        for id, said in one.statements.items()
    }
    open_ = {one.chapter: one.open for one in outcomes if one.open}
    return (
        json.dumps(
            {"statements": statements, "steps": dict(sorted(steps.items())), "open": open_},
            indent=1,
        )
        + "\n"
    )
