"""The ledger as text for people, as JSON, and as JUnit for a CI."""

from __future__ import annotations

import json
import os
import re
import stat
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from symhaptic.book import foreign
from symhaptic.book.chapters import BadChapter, expected_ledger
from symhaptic.book.committed import places, records
from symhaptic.book.ledger import Entry, counted
from symhaptic.book.sources import STATEMENTS
from symhaptic.proof.verdict import Kind
from symhaptic.version import __version__

_NO_XML = re.compile(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What no document of XML may have in it, not even as an entity."""


@cache
def _places() -> dict[str, str]:
    """The file that settles each statement, as far as the committed ledger tells."""
    return {id: Path(place).name for id, place in places(expected_ledger()).items()}


def needed(ids: list[str], paths: list[Path]) -> list[Path]:
    """The derivations that settle these statements, as far as the ledger knows them; all for none.

    What it does not know is a statement of a user's own derivation.
    """
    if not ids:
        return paths
    names = {_places().get(id) for id in ids}
    return [path for path in paths if path.name in names]


def under_way(path: Path) -> str:
    """What is decided while a derivation runs: its statements, or else its name."""
    ids = [id for id, name in _places().items() if name == path.name]
    return (ids[0] + (f" and {len(ids) - 1} more" if ids[1:] else "")) if ids else path.stem


def statements() -> list[dict[str, str]]:
    """Id, location and content of every statement that is verified, without running anything.

    Those of the paper are read from its transcription, our own from the committed ledger.
    """
    own = [
        {"id": r["id"], "location": r["location"], "says": plain(r["statement"])}
        for r in records(expected_ledger())
        if r["id"] not in STATEMENTS
    ]
    paper = [
        {"id": id, "location": s.location, "says": s.says or s.text} for id, s in STATEMENTS.items()
    ]
    return paper + own


def plain(latex: str) -> str:
    """Words that stand in LaTeX as a whole, or the LaTeX itself."""
    words = latex.removeprefix(r"\text{")
    return words[:-1] if words != latex and latex.endswith("}") else latex


def names(chosen: list[dict[str, str]], as_json: bool) -> str:
    """The statements as a table for people, or as JSON."""
    if as_json:
        data = {"package": "symhaptic", "version": __version__, "statements": chosen}
        return json.dumps(data, indent=1) + "\n"
    widths = [max((len(r[key]) for r in chosen), default=0) for key in ("id", "location")]
    lines = [
        f"{r['id']:{widths[0]}}  {r['location']:{widths[1]}}  {r['says']}".rstrip() for r in chosen
    ]
    return shown("\n".join(lines)) + "\n"


def text(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    bad: Sequence[BadChapter] = (),
    seconds: float | None = None,
    named: bool = False,
) -> str:
    """One line a statement, then what differs from the committed ledger, then the counts.

    Of statements that were ``named`` all is printed: the source's words, our reading, the
    proposition and the verdict.
    """
    width = max((len(e.statement.id) for e in entries), default=0)
    lines = []
    for entry in entries:
        verdict = entry.verdict
        detail = verdict.value or verdict.condition or ""
        if verdict.kind in (Kind.MISPRINT, Kind.REFUTED) and verdict.counterexample:
            detail = "at " + ", ".join(f"{k} = {v}" for k, v in verdict.counterexample.items())
        if verdict.kind is Kind.UNDECIDED and entry.derivation:
            detail = verdict.method
        if entry.derivation:
            detail = f"{detail}  [{entry.derivation}]".strip()
        if named:
            lines += [f"{entry.statement.id}  {entry.statement.location}", *_told(entry)]
            lines += [f"{'verdict':>13}: {verdict.kind}  {detail}".rstrip(), *_right(entry), ""]
            continue
        lines.append(f"{entry.statement.id:{width}}  {verdict.kind:10}  {detail}".rstrip())
        for definition in verdict.definitions:
            lines.append(f"{'':{width}}  {'by':10}  {definition}, defined in {entry.derivation}")
    lines += [f"DIFFERS  {line}" for line in surprises]
    lines += [f"ERROR    {wrong}" for wrong in bad]
    plural = "" if len(entries) == 1 else "s"
    kinds = f": {counted(entries)}" if entries else ""
    lines.append(f"{len(entries)} statement{plural}{kinds}")
    if any(e.rocq.extent != foreign.NOT for e in entries):
        lines.append(f"checked by Rocq, too: {foreign.counted(e.rocq for e in entries)}")
    open_ = [e for e in entries if e.verdict.kind is Kind.UNDECIDED]
    if open_:
        unsettled = any(e.derivation is None for e in open_)
        failing = " (an error, with --strict)" if strict and unsettled else ""
        lines.append(f"{len(open_)} undecided, which is not a pass{failing}")
    return shown("\n".join(lines)) + "\n"


def shown(text: str) -> str:
    """A text without control characters, which a terminal would obey."""
    return re.sub(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", "\ufffd", text)


def told(entry: Entry) -> list[tuple[str, str]]:
    """What stands before the verdict: the source's words, the formula, our reading, the claim."""
    statement = entry.statement
    quote = f'"{statement.quote}"' if statement.quote else ""
    printed = statement.text if statement.latex else ""
    rows = [("quotation", quote), ("formula", printed), ("reading", statement.says)]
    rows.append(("proposition", entry.verdict.proposition or ""))
    return [(name, what) for name, what in rows if what]


def _told(entry: Entry) -> list[str]:
    return [f"{name:>13}: {what}" for name, what in told(entry)]


def _right(entry: Entry) -> list[str]:
    """The definitions that were used, what is right instead, and what shows it."""
    verdict = entry.verdict
    by = [f"{definition}, defined in {entry.derivation}" for definition in verdict.definitions]
    rows = [("by", what) for what in by] + [("right", verdict.corrected)]
    rows += [("shown by", verdict.shows), ("note", verdict.note)]
    return [f"{name:>13}: {what}" for name, what in rows if what]


def json_text(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    bad: Sequence[BadChapter] = (),
    seconds: float | None = None,
    named: bool = False,
) -> str:
    """The JSON form of the ledger, with ``errors`` where a chapter could not be run."""
    data: dict[str, Any] = {
        "package": "symhaptic",
        "version": __version__,
        "statements": [entry.as_json() for entry in entries],
    }
    if bad:
        data["errors"] = [
            {"derivation": str(wrong.path), "line": wrong.line, "message": wrong.what}
            for wrong in bad
        ]
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def junit(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    bad: Sequence[BadChapter] = (),
    seconds: float | None = None,
    named: bool = False,
) -> str:
    """Each statement as a test case: a failure where its verdict is not the committed one.

    The time of a case is that from the verdict before it in its chapter, or the chapter's begin,
    to its own; chapters run side by side, so that the suite's time, which is what passed from the
    first to the last, is less than their sum.  A chapter that cannot be run is a case in error.
    """
    failed = {line.partition(": ")[0]: line for line in surprises}
    suite = ET.Element("testsuite", name="symhaptic verify")
    failures = skipped = 0
    for entry in entries:
        id, verdict = entry.statement.id, entry.verdict
        case = ET.SubElement(
            suite,
            "testcase",
            name=id,
            classname=entry.derivation or "undecided",
            time=f"{entry.seconds:.3f}",
        )
        properties = ET.SubElement(case, "properties")
        ET.SubElement(properties, "property", name="verdict", value=str(verdict.kind))
        for name, value in _rocq(entry.rocq):
            ET.SubElement(properties, "property", name=name, value=value)
        open_ = verdict.kind is Kind.UNDECIDED
        if id in failed or (strict and open_ and entry.derivation is None):
            failures += 1
            ET.SubElement(case, "failure", message=failed.get(id, f"{id}: undecided"))
        elif open_:
            skipped += 1
            ET.SubElement(case, "skipped", message="undecided")
        out = [f"{name}: {what}" for name, what in told(entry)]
        ET.SubElement(case, "system-out").text = "\n".join([*out, f"verdict: {verdict}"])
    for id in sorted(set(failed) - {entry.statement.id for entry in entries}):
        failures += 1
        case = ET.SubElement(suite, "testcase", name=id, classname="missing")
        ET.SubElement(case, "failure", message=failed[id])
    for wrong in bad:
        case = ET.SubElement(suite, "testcase", name=wrong.path.stem, classname=str(wrong.path))
        ET.SubElement(case, "error", message=str(wrong))
    total = sum(entry.seconds for entry in entries) if seconds is None else seconds
    suite.attrib |= {
        "tests": str(len(suite)),
        "failures": str(failures),
        "skipped": str(skipped),
        "errors": str(len(bad)),
        "time": f"{total:.3f}",
    }
    ET.indent(suite)
    written = _NO_XML.sub("\ufffd", ET.tostring(suite, "unicode"))
    return f'<?xml version="1.0" encoding="utf-8"?>\n{written}\n'


def _rocq(found: foreign.Checked) -> list[tuple[str, str]]:
    """How far Rocq has checked a statement, as properties of its case."""
    told = [("rocq", found.extent)]
    told += [("rocq-why", found.why)] if found.why else []
    return told + ([("rocq-rests", ", ".join(found.rests))] if found.rests else [])


def _mode(path: Path) -> int:
    """Who may read the file that is there, or a new one."""
    if path.exists():
        return stat.S_IMODE(path.stat().st_mode)
    masked = os.umask(0)
    os.umask(masked)
    return 0o666 & ~masked


def replace(path: Path, content: str | bytes) -> None:
    """Write a file whole or not at all: beside its place first, then moved there.

    A link stays one, and a device or a pipe, such as /dev/stdout, is written to, not replaced.
    """
    if path.exists() and not path.is_file():  # asked before a link to a nameless pipe is followed
        path.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
        return
    path = path.resolve()
    descriptor, draft = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:40]}-")
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(content.encode("utf-8") if isinstance(content, str) else content)
        os.chmod(draft, _mode(path))
        os.replace(draft, path)
    except OSError:
        os.unlink(draft)
        raise
