"""The ledger as text for people, as JSON, and as JUnit for a CI."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from xml.etree import ElementTree as ET

from symhaptic import __version__
from symhaptic.ledger import Entry, counted
from symhaptic.library import expected_ledger
from symhaptic.proof.verdict import Kind


@cache
def _places() -> dict[str, str]:
    """The file that settles each statement, as far as the committed ledger tells."""
    records = json.loads(expected_ledger().read_text(encoding="utf-8"))["statements"]
    return {r["id"]: Path(r["derivation"]).name for r in records if r["derivation"]}


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


def text(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    errors: Sequence[str] = (),
    elapsed: float | None = None,
) -> str:
    """One line a statement, then what differs from the committed ledger, then the counts."""
    width = max((len(e.statement.id) for e in entries), default=0)
    lines = []
    for entry in entries:
        verdict = entry.verdict
        detail = verdict.value or verdict.condition or ""
        if verdict.claimed in (Kind.MISPRINT, Kind.REFUTED) and verdict.counterexample:
            detail = "at " + ", ".join(f"{k} = {v}" for k, v in verdict.counterexample.items())
        if entry.derivation:
            detail = f"{detail}  [{entry.derivation}]".strip()
        lines.append(f"{entry.statement.id:{width}}  {verdict.kind:10}  {detail}".rstrip())
    lines += [f"DIFFERS  {line}" for line in surprises]
    lines += [f"FAILED   {line}" for line in errors]
    plural = "" if len(entries) == 1 else "s"
    lines.append(f"{len(entries)} statement{plural}: {counted(entries)}")
    argued = sum(e.verdict.kind is Kind.ARGUED for e in entries)
    if argued:
        lines.append(f"{argued} argued: words join what was checked, which is not a pass")
    open_ = [e for e in entries if e.verdict.kind is Kind.UNDECIDED]
    if open_:
        failing = " (an error, with --strict)" if strict else ""
        lines.append(f"{len(open_)} undecided, which is not a pass{failing}")
    return "\n".join(lines) + "\n"


def json_text(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    errors: Sequence[str] = (),
    elapsed: float | None = None,
) -> str:
    """The JSON form of the ledger; chapters that ended in an error are listed beside."""
    data = {
        "package": "symhaptic",
        "version": __version__,
        "statements": [entry.as_json() for entry in entries],
    } | ({"errors": list(errors)} if errors else {})
    return json.dumps(data, indent=1) + "\n"


def junit(
    entries: list[Entry],
    surprises: list[str],
    strict: bool,
    errors: Sequence[str] = (),
    elapsed: float | None = None,
) -> str:
    """Each statement as a test case: a failure where its verdict is not the committed one.

    A chapter that ends in an error is a test case, too.  The time of a case is what its chapter
    took for it, in its own process; that of the suite is what passed on the clock, for several
    chapters run side by side.
    """
    failed = {line.partition(":")[0]: line for line in surprises}
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
        open_ = verdict.kind is Kind.UNDECIDED
        if id in failed or (strict and open_):
            failures += 1
            ET.SubElement(case, "failure", message=failed.get(id, f"{id}: undecided"))
        elif open_:
            skipped += 1
            ET.SubElement(case, "skipped", message="undecided")
        ET.SubElement(case, "system-out").text = str(verdict)
    for id in sorted(set(failed) - {entry.statement.id for entry in entries}):
        failures += 1
        case = ET.SubElement(suite, "testcase", name=id, classname="missing")
        ET.SubElement(case, "failure", message=failed[id])
    for line in errors:
        place, _, message = line.partition(": ")
        case = ET.SubElement(suite, "testcase", name=place, classname="derivation")
        ET.SubElement(case, "error", message=message)
    seconds = sum(e.seconds for e in entries) if elapsed is None else elapsed
    suite.attrib |= {
        "tests": str(len(suite)),
        "failures": str(failures),
        "skipped": str(skipped),
        "errors": str(len(errors)),
        "time": f"{seconds:.3f}",
    }
    ET.indent(suite)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(suite, "unicode") + "\n"


def replace(path: Path, content: str | bytes) -> None:
    """Write a file whole or not at all: beside its place first, then moved there.

    A link stays one, and a device or a pipe, such as /dev/stdout, is written to, not replaced.
    """
    path = path.resolve()
    if path.exists() and not path.is_file():
        path.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
        return
    descriptor, draft = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}-")
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(content.encode("utf-8") if isinstance(content, str) else content)
        os.chmod(draft, 0o644)
        os.replace(draft, path)
    except OSError:
        os.unlink(draft)
        raise
