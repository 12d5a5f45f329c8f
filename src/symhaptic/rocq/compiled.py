"""Rocq at work: a chapter's file is compiled, and what it did not accept is said by name.

A file that Rocq accepts whole is compiled once.  Otherwise it is read step by step, the lemmas that
fail become open leaves, and what then is accepted says what each statement rests on.
"""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
import time
from collections.abc import Container, Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any
from uuid import uuid4

from symhaptic.book.chapters import Chapter, run
from symhaptic.book.foreign import INTEGERS, REALS, mark
from symhaptic.rocq.assumptions import axioms, resting, rule_of, told
from symhaptic.rocq.chapter import ALONE, File, printed
from symhaptic.rocq.preludes import PRELUDES, text_mark
from symhaptic.rocq.shared import FOLDER, Seen
from symhaptic.rocq.steps import is_open

INSTALL = "coqc is not found; on Debian: apt install coq libcoq-interval"
SECONDS = 60
"""So long may one lemma take."""
_ROOM = {"OCAMLRUNPARAM": "s=32M,o=1000"}
"""Memory that is collected seldom: terms are large, and Rocq ends soon; some 1.4 GB at most."""


class NoRocq(OSError):
    """No coqc, or one that does not take the prelude; the message is one line."""


@dataclass
class Outcome:
    """What Rocq says of a chapter."""

    chapter: str
    statements: dict[str, str] = field(default_factory=dict)
    """``whole``, or why it is not."""
    rests: dict[str, list[str]] = field(default_factory=dict)
    """What each printed statement rests on: of what ``Print Assumptions`` says of the chapter, all
    of the library, and the axioms and predicates that its lemmas name."""
    steps: dict[str, list[int]] = field(default_factory=dict)
    """Of each rule, how many steps were checked and how many there are."""
    pieces: list[int] = field(default_factory=lambda: [0, 0])
    """Of all boxes, how many pieces were checked and how many there are."""
    open: dict[str, str] = field(default_factory=dict)
    """The leaves that are not checked, and why."""
    leaves: bool = False
    """Whether its leaves alone were asked, and not how they are joined."""
    seconds: float = 0.0
    """So long it took to run, print and compile it."""
    kept: bool = False
    """Whether it was known from before."""
    text: str = ""
    """A mark of the text that was compiled, and of the prelude."""
    says: dict[str, str] = field(default_factory=dict)
    """Of each statement by theorems, a mark of what these say."""

    def rules(self, id: str) -> list[str]:
        """What a statement rests on, by name: rules and axioms, predicates, Rocq's library."""
        named = {rule_of(name) for name in self.rests.get(id, ()) if not is_open(name)}
        return sorted(named, key=lambda name: (name in (REALS, INTEGERS), name))


def coqc() -> str:
    """Where the compiler is; raises :class:`NoRocq`."""
    found = shutil.which("coqc")
    if found is None:
        raise NoRocq(INSTALL)
    return found


def prepared(folder: Path) -> Path:
    """The folder with the preludes in it; one that is new there is not compiled yet."""
    (folder / FOLDER).mkdir(parents=True, exist_ok=True)
    stale = False
    for path in PRELUDES:
        there, text = folder / path.name, path.read_text(encoding="utf-8")
        stale = stale or not there.is_file() or there.read_text(encoding="utf-8") != text
        if stale:
            there.write_text(text, encoding="utf-8")
            there.with_suffix(".vo").unlink(missing_ok=True)
    if stale:
        shutil.rmtree(folder / FOLDER)
        (folder / FOLDER).mkdir()
    return folder


def prelude_compiled(folder: Path) -> None:
    """Compile the preludes; raises :class:`NoRocq` where that fails."""
    for path in PRELUDES:
        if not (folder / path.name).with_suffix(".vo").is_file():
            done = _compiled(folder, path.stem)
            if done.returncode:
                last = (done.stderr.strip().splitlines() or ["no message"])[-1]
                why = "is libcoq-interval installed?"
                raise NoRocq(f"coqc does not take {path.name} ({why}): {last}")


def version() -> str:
    """Of Rocq."""
    told = subprocess.run([coqc(), "--print-version"], capture_output=True, text=True, check=False)
    return told.stdout.split(" ")[0]


def _compiled(folder: Path, name: str) -> subprocess.CompletedProcess[str]:
    limit = f"Default Timeout={SECONDS}"
    command = [coqc(), "-q", "-noglob", "-set", limit, "-Q", ".", "Symhaptic", f"{name}.v"]
    return subprocess.run(
        command, cwd=folder, env=_ROOM | os.environ, capture_output=True, text=True, check=False
    )


def written(path: Path, folder: Path) -> Outcome:
    """A derivation's file, written and not compiled."""
    chapter = run(path)
    file = printed(chapter)
    (folder / f"{file.name}.v").write_text(file.written(), encoding="utf-8")
    return _outcome(file, chapter, dict.fromkeys(file.statements, "not compiled"))


def judged(path: Path, folder: Path, leaves: Container[Path] = ()) -> Outcome | Taken:
    """A derivation's file, written, compiled and read back; known where the text is known."""
    return begun(run(path), folder, path in leaves)


def asked(chapter: Chapter, folder: Path, leaves: bool = False) -> Outcome:
    """The same of a chapter that has been run, or of its leaves alone, and on what it rests."""
    found = begun(chapter, folder, leaves)
    return found if isinstance(found, Outcome) else found.alone()


@dataclass
class Taken:
    """A chapter that Rocq has taken, and has not been asked yet on what it rests."""

    file: File
    outcome: Outcome
    folder: Path
    module: str
    """Where it was compiled."""
    own: dict[str, list[str]]
    """By a full name, there or elsewhere, what is called so in its file."""

    def alone(self) -> Outcome:
        """With what Rocq lists for it; where it does not list it, nothing in it is whole."""
        try:
            return self.rests_on(listed(self.folder, [self.module]))
        except NoRocq as wrong:
            unsaid = dict.fromkeys(self.file.statements, str(wrong))
            return replace(self.outcome, statements=self.outcome.statements | unsaid)

    def rests_on(self, said: str, others: Iterable[Taken] = ()) -> Outcome:
        """With what Rocq lists for it, or for it and others together."""
        theirs = set[str]().union(*(other.own for other in others)) - set(self.own)
        rests = resting(self.file, axioms(said) - theirs, self.own)
        found = told(self.file, rests)
        statements = {id: found.get(id, why) for id, why in self.outcome.statements.items()}
        return _kept(replace(self.outcome, statements=statements, rests=rests), self.folder)


def listed(folder: Path, modules: Sequence[str]) -> str:
    """What Rocq says that chapters rest on: ``Print Assumptions`` of all of them at once.

    It needs seconds for a term with ``interval`` in it, and little more for many of them.
    """
    name = f"asked_{uuid4().hex[:12]}"
    text = (
        f"From Symhaptic.{FOLDER} Require {' '.join(modules)}.\nUnset Default Timeout.\n"
        f"Definition all_of_them := ({', '.join(f'{name}.all_of_it' for name in modules)}).\n"
        "Print Assumptions all_of_them.\n"
    )
    (folder / FOLDER / f"{name}.v").write_text(text, encoding="utf-8")
    done = _compiled(folder, f"{FOLDER}/{name}")
    for path in (folder / FOLDER).glob(f"*{name}*"):
        path.unlink()
    if done.returncode:
        why = " ".join(done.stderr.split())[-200:]
        raise NoRocq(f"coqc: does not say on what it rests: {why or done.returncode}")
    return done.stdout


def begun(chapter: Chapter, folder: Path, leaves: bool = False) -> Outcome | Taken:
    """A chapter that has been run, compiled; what is known of it where the text is known."""
    begin = time.perf_counter()
    whole = printed(chapter)
    file = whole.leaves() if leaves else whole
    text = file.written()
    of, before = text_mark(text), _before(file.name, folder)
    if before.get("text") == of:
        return _marked(Outcome(**{**before["outcome"], "kept": True}), chapter, of)
    place = folder / f"{file.name}.v"
    place.write_text(text, encoding="utf-8")
    if not file.steps:
        return _marked(_outcome(whole, chapter, _unasked(whole), leaves), chapter, of)
    seen, done = _asked(file, folder)
    if done.returncode:
        whole = printed(chapter, failing(folder, seen.text))
        file = whole.leaves() if leaves else whole
        place.write_text(file.written(), encoding="utf-8")
        seen, done = _asked(file, folder)
    if done.returncode:
        why = f"coqc: {' '.join(done.stderr.split())[-200:]}"
        outcome = _outcome(whole, chapter, dict.fromkeys(whole.statements, why), leaves)
        outcome.steps = {rule: [0, total] for rule, (_, total) in outcome.steps.items()}
        outcome.pieces[0], outcome.open = 0, {"the file": why}
        return _marked(outcome, chapter, of)
    seen.keep()
    said = _unasked(whole) if leaves else dict.fromkeys(whole.statements, "not asked yet")
    outcome = _marked(_outcome(whole, chapter, said, leaves), chapter, of)
    outcome.seconds = round(time.perf_counter() - begin, 1)
    if leaves or not file.statements:
        return _kept(outcome, folder)
    return Taken(file, outcome, folder, seen.name, seen.names)


def _kept(outcome: Outcome, folder: Path) -> Outcome:
    """What was found, for the next time; what took too long may be quicker then."""
    if not any("Timeout" in why or "not within" in why for why in outcome.open.values()):
        kept = {"text": outcome.text, "outcome": asdict(outcome)}
        name = f"{outcome.chapter}_leaves" if outcome.leaves else outcome.chapter
        (folder / f"{name}.json").write_text(json.dumps(kept, indent=1), encoding="utf-8")
    return outcome


def _unasked(file: File) -> dict[str, str]:
    """What is said of statements where leaves alone were asked: how much is left of each."""
    if not any(step.rule in ALONE for step in file.steps):
        return dict.fromkeys(file.statements, "not asked: each step of its chapter uses others")
    others = {step.name for step in file.steps if step.rule not in ALONE or is_open(step.name)}
    left = {id: len(file.named_by(id) & others) for id in file.statements}
    return {id: f"{n} steps open: its chapter's leaves alone were asked" for id, n in left.items()}


def longest_first(paths: Sequence[Path], folder: Path) -> list[Path]:
    """Derivations in the order of how long each took the last time, those that are new first."""

    def seconds(path: Path) -> float:
        before = _before(path.stem, folder) or _before(f"{path.stem}_leaves", folder)
        return float(before.get("outcome", {}).get("seconds", math.inf))

    return sorted(paths, key=seconds, reverse=True)


def _before(name: str, folder: Path) -> dict[str, Any]:
    """What was found of a chapter the last time; nothing where another file has its name."""
    path = folder / f"{name}.json"
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (FileNotFoundError, json.JSONDecodeError):
        return {}
    return found if isinstance(found, dict) and {"text", "outcome"} <= set(found) else {}


def _asked(file: File, folder: Path) -> tuple[Seen, subprocess.CompletedProcess[str]]:
    """What of a file is new, compiled."""
    seen = Seen(folder, file)
    (folder / FOLDER / f"{seen.name}.v").write_text(seen.text, encoding="utf-8")
    return seen, _compiled(folder, f"{FOLDER}/{seen.name}")


def _marked(outcome: Outcome, chapter: Chapter, text: str) -> Outcome:
    """With what it is of."""
    says = {
        id: mark(one.settlement.judged)
        for id, one in chapter.page.settled.items()
        if one.settlement.judged is not None
    }
    return replace(outcome, text=text, says=says)


_LEMMA = re.compile(r"^(Lemma ([\w']+) : .*?\.)\nProof\.\n.*?^Qed\.\n", re.S | re.M)


def failing(folder: Path, text: str) -> dict[str, str]:
    """The lemmas that Rocq does not accept, each with what it says, read in one go.

    Behind each lemma stands an axiom that says the same: it is taken where the lemma was not.
    """
    names = [found[2] for found in _LEMMA.finditer(text)]

    def doubled(found: re.Match[str]) -> str:
        axiom = found[1].replace("Lemma", "Axiom", 1)
        return f"{found[0]}Abort All.\n{axiom}\n"

    done = subprocess.run(
        ["coqtop", "-q", "-Q", ".", "Symhaptic"],
        input=f"Set Default Timeout {SECONDS}.\n{_LEMMA.sub(doubled, text)}",
        cwd=folder,
        env=_ROOM | os.environ,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    found, said = dict[str, str](), ""
    for line in done.stdout.splitlines():
        declared = re.search(r"([\w']+) is declared", line)
        if declared and declared[1] in names:
            found[declared[1]] = _error(said)
        said = "" if declared or "already exists" in line else f"{said}{line}\n"
    return found


def _error(said: str) -> str:
    """The first of the errors between two lemmas."""
    for error in re.findall(r"(?:Error:|Timeout!)(.*?)(?=\n\n|\Z)", said, re.S):
        line = " ".join(str(error).split())
        if line and not line.startswith(("No focused", "(in proof", "There are pending")):
            return f"coqc: {line[:160]}"
    return f"coqc: not within {SECONDS} s"


def _outcome(file: File, chapter: Chapter, said: dict[str, str], leaves: bool = False) -> Outcome:
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
