"""Rocq at work: a chapter's file is compiled, and what it did not accept is said by name.

A file that Rocq accepts whole is compiled once.  Otherwise it is read step by step, the lemmas that
fail become open leaves, and what then is accepted says what each statement rests on.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import time
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any
from uuid import uuid4

from symhaptic.book import processes
from symhaptic.book.chapters import Chapter, run
from symhaptic.rocq.assumptions import axioms, resting, told
from symhaptic.rocq.chapter import OPEN, File, printed
from symhaptic.rocq.outcome import Outcome, keep, kept, marked, of_file, unasked
from symhaptic.rocq.preludes import PRELUDES, code, text_mark
from symhaptic.rocq.shared import FOLDER, Seen

INSTALL = "coqc is not found; on Debian: apt install coq libcoq-interval"
SECONDS = 300
"""So long may one lemma take."""
TOGETHER = 1800
"""So long may those of a chapter take that are read one by one; the rest is left open."""
_ROOM = {"OCAMLRUNPARAM": "s=32M,o=1000"}
"""Memory that is collected seldom: terms are large, and Rocq ends soon; some 1.4 GB at most."""


class NoRocq(OSError):
    """No coqc, or one that does not take the prelude; the message is one line."""


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
        before = there.read_text(encoding="utf-8") if there.is_file() else ""
        stale = stale or code(before) != code(text)
        if stale:
            there.with_suffix(".vo").unlink(missing_ok=True)
        there.write_text(text, encoding="utf-8")
    if stale:
        shutil.rmtree(folder / FOLDER)
        (folder / FOLDER).mkdir()
    return folder


def prelude_compiled(folder: Path) -> None:
    """Compile the preludes; raises :class:`NoRocq` where that fails."""
    for path in PRELUDES:
        if not (folder / path.name).with_suffix(".vo").is_file():
            done = _compiled(folder, path.stem, SECONDS * 2)
            if done.returncode:
                last = (done.stderr.strip().splitlines() or ["no message"])[-1]
                why = "is libcoq-interval installed?"
                raise NoRocq(f"coqc does not take {path.name} ({why}): {last}")


def version() -> str:
    """Of Rocq."""
    told = subprocess.run([coqc(), "--print-version"], capture_output=True, text=True, check=False)
    return told.stdout.split(" ")[0]


@cache
def reader() -> str:
    """A mark of the compiler, and of the code that asks it and reads what it says."""
    found = hashlib.sha256(version().encode())
    for path in sorted(Path(__file__).parent.glob("*.py")):
        found.update(path.read_bytes())
    return found.hexdigest()[:16]


def _compiled(folder: Path, name: str, seconds: int = SECONDS) -> subprocess.CompletedProcess[str]:
    limit = f"Default Timeout={seconds}"
    command = [coqc(), "-q", "-noglob", "-set", limit, "-Q", ".", "Symhaptic", f"{name}.v"]
    return processes.run(command, cwd=folder, env=_ROOM | os.environ)


def written(path: Path, folder: Path) -> Outcome:
    """A derivation's file, written and not compiled."""
    chapter = run(path)
    file = printed(chapter)
    (folder / f"{file.name}.v").write_text(file.written(), encoding="utf-8")
    return of_file(file, chapter, dict.fromkeys(file.statements, "not compiled"))


def judged(
    path: Path,
    folder: Path,
    leaves: Container[Path] = (),
    recorded: Mapping[str, Any] | None = None,
) -> Outcome | Taken:
    """A derivation's file, written, compiled and read back; known where the text is known.

    ``recorded`` has by their names what a record says of chapters, as :func:`begun` reads it.
    """
    return begun(run(path), folder, path in leaves, (recorded or {}).get(path.stem))


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
        theirs = set[str]().union(*(other.own for other in others)) - self.own.keys()
        rests = resting(self.file, axioms(said) - theirs, self.own)
        found = told(self.file, rests)
        statements = {id: found.get(id, why) for id, why in self.outcome.statements.items()}
        return keep(replace(self.outcome, statements=statements, rests=rests), self.folder)


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


def begun(
    chapter: Chapter, folder: Path, leaves: bool = False, recorded: Mapping[str, Any] | None = None
) -> Outcome | Taken:
    """A chapter that has been run, compiled; what is known of it where the text is known.

    ``recorded`` has what a record says of it: what Rocq did not accept of the same text is left
    open, and is not tried again.
    """
    begin = time.perf_counter()
    whole = printed(chapter)
    file = whole.leaves() if leaves else whole
    of, before = text_mark(file.written()), kept(file.name, folder)
    place = folder / f"{file.name}.v"

    def opened(failed: Mapping[str, str]) -> None:
        nonlocal whole, file
        whole = printed(chapter, failed) if failed else whole
        file = whole.leaves() if leaves else whole
        place.write_text(file.written(), encoding="utf-8")

    if before.get("text") == of and before["outcome"].get("by") == reader():
        opened(refused(before["outcome"]))
        return marked(Outcome(**{**before["outcome"], "kept": True}), chapter, of)
    failed = refused(recorded) if recorded and recorded["text"] == of else {}
    opened(failed)
    if not file.steps:
        return marked(of_file(whole, chapter, unasked(whole), leaves), chapter, of)
    seen, done = _asked(file, folder)
    if done.returncode:
        opened(failed | failing(folder, seen.text))
        seen, done = _asked(file, folder)
    if done.returncode:
        why = f"coqc: {' '.join(done.stderr.split())[-200:]}"
        outcome = of_file(whole, chapter, dict.fromkeys(whole.statements, why), leaves)
        outcome.steps = {rule: [0, total] for rule, (_, total) in outcome.steps.items()}
        outcome.pieces[0], outcome.open = 0, {"the file": why}
        return marked(outcome, chapter, of)
    seen.keep()
    said = unasked(whole) if leaves else dict.fromkeys(whole.statements, "not asked yet")
    outcome = marked(of_file(whole, chapter, said, leaves), chapter, of)
    outcome.by = reader()
    outcome.seconds = round(time.perf_counter() - begin, 1)
    if leaves or not file.statements:
        return keep(outcome, folder)
    return Taken(file, outcome, folder, seen.name, seen.names)


def refused(recorded: Mapping[str, Any]) -> dict[str, str]:
    """The lemmas of a chapter that Rocq did not accept by a record, each with what it said.

    >>> never = {"open_step_2": "not checked: the rule gains"}  # which nobody prints
    >>> refused({"open": never | {"open_step_3": "not checked: coqc: No tactic."}})
    {'step_3': 'coqc: No tactic.'}
    """
    opened = ((name, why.removeprefix(f"{OPEN} ")) for name, why in recorded["open"].items())
    return {name.removeprefix("open_"): why for name, why in opened if why.startswith("coqc: ")}


def _asked(file: File, folder: Path) -> tuple[Seen, subprocess.CompletedProcess[str]]:
    """What of a file is new, compiled."""
    seen = Seen(folder, file)
    (folder / FOLDER / f"{seen.name}.v").write_text(seen.text, encoding="utf-8")
    return seen, _compiled(folder, f"{FOLDER}/{seen.name}")


_LEMMA = re.compile(r"^(Lemma ([\w']+) : .*?\.)\nProof\.\n.*?^Qed\.\n", re.S | re.M)


def failing(folder: Path, text: str) -> dict[str, str]:
    """The lemmas that Rocq does not accept, each with what it says, read in one go.

    Behind each lemma stands an axiom that says the same: it is taken where the lemma was not.
    Those that are not reached in time are not accepted.
    """
    names = [found[2] for found in _LEMMA.finditer(text)]

    def doubled(found: re.Match[str]) -> str:
        axiom = found[1].replace("Lemma", "Axiom", 1)
        return f"{found[0]}Abort All.\n{axiom}\n"

    try:
        told = subprocess.run(
            ["coqtop", "-q", "-Q", ".", "Symhaptic"],
            input=f"Set Default Timeout {SECONDS}.\n{_LEMMA.sub(doubled, text)}".encode(),
            cwd=folder,
            env=_ROOM | os.environ,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=TOGETHER,
            check=False,
        ).stdout
    except subprocess.TimeoutExpired as late:
        told = late.stdout or b""
    found = dict.fromkeys(names, f"coqc: not reached within {TOGETHER} s")
    said = ""
    for line in told.decode(errors="replace").splitlines():
        declared, accepted = (
            re.search(rf"([\w']+) {end}", line) for end in ("is declared", "already exists")
        )
        if declared and declared[1] in names:
            found[declared[1]] = _error(said)
        if accepted:
            found.pop(accepted[1], None)
        said = "" if declared or accepted else f"{said}{line}\n"
    return found


def _error(said: str) -> str:
    """The first of the errors between two lemmas."""
    for error in re.findall(r"(?:Error:|Timeout!)(.*?)(?=\n\n|\Z)", said, re.S):
        line = " ".join(str(error).split())
        if line and not line.startswith(("No focused", "(in proof", "There are pending")):
            return f"coqc: {line[:160]}"
    return f"coqc: not within {SECONDS} s"
