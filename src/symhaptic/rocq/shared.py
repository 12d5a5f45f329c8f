"""Lemmas that Rocq has seen before: a chapter takes them from the file in which it proved them.

Most lemmas of a chapter are others' too.  One whose statement and proof, and those of all that it
uses, are letter by letter what was compiled before is not proved again, but named where it stands;
the file that is written to be read has them all.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from uuid import uuid4

from symhaptic.rocq.chapter import File
from symhaptic.rocq.steps import Step, is_open

FOLDER = "seen"
"""Where what is compiled stands, beside what is written to be read."""


class Seen:
    """What of a chapter was compiled before, in which files, and what is left to compile."""

    def __init__(self, folder: Path, file: File) -> None:
        self.folder, self.marks = folder / FOLDER, _marks(file)
        self.name = f"{file.name}_{uuid4().hex[:12]}"
        self.own: dict[str, list[str]] = {}
        """By a full name elsewhere, what is called so here: more than one may say the same."""
        self.there: dict[str, str] = {}
        """Where a step is proved."""
        known: dict[str, list[str]] = {}
        for name, mark in self.marks.items():
            known.setdefault(mark, []).append(name)
        for index in sorted(self.folder.glob("*.json")):
            for name, mark in json.loads(index.read_text(encoding="utf-8")).items():
                if mark in known:
                    self.own[f"{index.stem}.{name}"] = known[mark]
                    for here in known[mark]:
                        self.there.setdefault(here, f"{index.stem}.{name}")
        self.file = replace(file, steps=[*self._left(file)])

    def _left(self, file: File) -> Iterator[Step]:
        """The steps that are new, and of the others those that they or the statements name."""
        wanted = {name for names in file.statements.values() for name in names}
        wanted.update(*(_words(step) for step in file.steps if step.name not in self.there))
        for step in file.steps:
            if step.name not in self.there:
                yield step
            elif step.name in wanted:
                yield replace(step, kind="Lemma", lines=[f"exact {self.there[step.name]}."])

    @property
    def text(self) -> str:
        """What is compiled."""
        taken = (self.there[s.name] for s in self.file.steps if s.name in self.there)
        used = sorted({name.partition(".")[0] for name in taken})
        from_ = f"From Symhaptic.{FOLDER} Require {' '.join(used)}.\n" if used else ""
        return from_ + self.file.written(asks=False)

    @property
    def names(self) -> dict[str, list[str]]:
        """By a full name where it is compiled, here or elsewhere, what is called so in the file."""
        return self.own | {f"{self.name}.{step.name}": [step.name] for step in self.file.steps}

    def keep(self) -> None:
        """What was proved here, for others."""
        found = {
            step.name: self.marks[step.name]
            for step in self.file.steps
            if step.name in self.marks and step.name not in self.there
        }
        (self.folder / f"{self.name}.json").write_text(json.dumps(found), encoding="utf-8")


def _words(step: Step) -> list[str]:
    return re.findall(r"[\w']+|[^\w']+", "\n".join([step.statement, *step.lines]))


def _marks(file: File) -> dict[str, str]:
    """Of each step what it shares with one that says the same by the same proof of the same."""
    found: dict[str, str] = {}
    steps = {step.name for step in file.steps}
    for step in file.steps:
        words = _words(step)
        if is_open(step.name) or not steps.intersection(words) <= {*found, step.name}:
            continue  # it rests on what is not checked
        text = "".join(found.get(word, word) for word in words)
        said = f"{step.kind} {step.rule if step.kind == 'Axiom' else ''}\n{text}"
        found[step.name] = hashlib.sha256(said.encode()).hexdigest()
    return found
