"""What Rocq says of a chapter, made, kept and found again.

What was found is kept beside the chapter's file under a mark of the text, and is known again where
the text is the same.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from symhaptic.book.chapters import Chapter
from symhaptic.book.foreign import LIBRARY, mark
from symhaptic.rocq.assumptions import rule_of
from symhaptic.rocq.chapter import ALONE, File
from symhaptic.rocq.steps import is_open


@dataclass
class Outcome:
    """What Rocq says of a chapter."""

    chapter: str
    statements: dict[str, str] = field(default_factory=dict)
    """``whole``, or why it is not."""
    rests: dict[str, list[str]] = field(default_factory=dict)
    """What each printed statement rests on: of what ``Print Assumptions`` says of the chapter, all
    of the library, and the axioms that its lemmas name."""
    steps: dict[str, list[int]] = field(default_factory=dict)
    """Of each rule, how many steps were checked and how many there are."""
    pieces: list[int] = field(default_factory=lambda: [0, 0])
    """Of all boxes, how many pieces were checked and how many there are."""
    open: dict[str, str] = field(default_factory=dict)
    """The leaves that are not checked, and why."""
    leaves: bool = False
    """Whether only the basic steps were sent to Rocq, without the steps that join them."""
    seconds: float = 0.0
    """The time to run, print and compile it."""
    kept: bool = False
    """Whether it was known from before."""
    text: str = ""
    """A mark of the text that was compiled, and of the prelude."""
    by: str = ""
    """A mark of the compiler, and of the code that reads what it says."""
    says: dict[str, str] = field(default_factory=dict)
    """Of each statement by theorems, a mark of what these say."""

    def rules(self, id: str) -> list[str]:
        """What a statement rests on, by name: rules and axioms, Rocq's library."""
        named = {rule_of(name) for name in self.rests.get(id, ()) if not is_open(name)}
        return sorted(named, key=lambda name: (name in LIBRARY, name))


def of_file(file: File, chapter: Chapter, said: dict[str, str], leaves: bool = False) -> Outcome:
    """What is known from a file as it was printed, with what is said of its statements."""
    steps: dict[str, list[int]] = {}
    for step in file.steps:
        if not step.name.startswith(("rule_", "axiom_")):
            count = steps.setdefault(step.rule, [0, 0])
            count[0] += not is_open(step.name) and (step.rule in ALONE or not leaves)
            count[1] += 1
    boxes = [(0 if is_open(step.name) else step.pieces, step.pieces) for step in file.steps]
    pieces = [sum(counts) for counts in zip(*boxes, strict=True)] or [0, 0]
    statements = {}
    for id, one in chapter.page.settled.items():
        if one.settlement.judged is None:
            statements[id] = "not printed: it is settled without a theorem"
        elif id in file.missing:
            statements[id] = f"not printed: {file.missing[id]}"
        else:
            statements[id] = said[id]
    open_ = {s.name: s.why for s in file.steps if is_open(s.name)}
    steps = dict(sorted(steps.items()))
    return Outcome(file.name, statements, {}, steps, pieces, open_, leaves)


def unasked(file: File) -> dict[str, str]:
    """The report on statements of which only the basic steps were checked: what is left of each."""
    if not any(step.rule in ALONE for step in file.steps):
        why = "not asked: no step of its chapter can be checked by itself"
        return dict.fromkeys(file.statements, why)
    others = {step.name for step in file.steps if step.rule not in ALONE or is_open(step.name)}
    left = {id: len(file.named_by(id) & others) for id in file.statements}
    why = "only the basic steps of its chapter are checked"
    return {id: f"{n} steps open: {why}" for id, n in left.items()}


def marked(outcome: Outcome, chapter: Chapter, text: str) -> Outcome:
    """With what it is of."""
    says = {
        id: mark(one.settlement.judged)
        for id, one in chapter.page.settled.items()
        if one.settlement.judged is not None
    }
    return replace(outcome, text=text, says=says)


def keep(outcome: Outcome, folder: Path) -> Outcome:
    """What was found, for the next time; what took too long may be quicker then."""
    if not any("Timeout" in why or " within " in why for why in outcome.open.values()):
        found = {"text": outcome.text, "outcome": asdict(outcome)}
        name = f"{outcome.chapter}_leaves" if outcome.leaves else outcome.chapter
        (folder / f"{name}.json").write_text(json.dumps(found, indent=1), encoding="utf-8")
    return outcome


def longest_first(paths: Sequence[Path], folder: Path) -> list[Path]:
    """Derivations in the order of how long each took the last time, those that are new first."""

    def seconds(path: Path) -> float:
        found = kept(path.stem, folder) or kept(f"{path.stem}_leaves", folder)
        return float(found.get("outcome", {}).get("seconds", math.inf))

    return sorted(paths, key=seconds, reverse=True)


def kept(name: str, folder: Path) -> dict[str, Any]:
    """What was found of a chapter the last time; nothing where another file has its name."""
    path = folder / f"{name}.json"
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (FileNotFoundError, json.JSONDecodeError):
        return {}
    return found if isinstance(found, dict) and {"text", "outcome"} <= set(found) else {}
