"""What was found, in words, as GitHub's annotation, as JUnit, as JSON and as a table."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from symhaptic.check.checked import FLAT, Checked
from symhaptic.check.compare import Found, Point, points, shown
from symhaptic.check.compare import exact as exact_at


@dataclass(frozen=True)
class Report:
    """What was found of whose function, in how long."""

    found: Found
    of: str
    """As it was asked for, such as ``my.module:f``."""
    seconds: float
    place: tuple[str, int] | None = None
    """File and line."""


def named(found: Found, point: Point) -> str:
    """Arguments by name, as hexadecimal floats and as one reads them."""
    pairs = zip(found.checked.ranges, point, strict=True)
    return ", ".join(f"{name} = {v.hex()} ({v:.6g})" for name, v in pairs)


def values(found: Found) -> str:
    """What it gives there, and what is exact."""
    rows = zip(found.checked.results, found.got, found.right, strict=True)
    return "; ".join(f"{name} is {mine!r}, exact {right}" for name, mine, right in rows)


def lines(report: Report) -> list[str]:
    """What was found, a line each."""
    found = report.found
    worst = f"worst error {found.worst:.3g} ulp of {found.result}"
    out = [
        f"{found.checked.id}: {found.points} points, {len(found.looked)} of them in balls, {worst}"
    ]
    flat = " and ".join(name for name in found.checked.flat if name in found.checked.results)
    coarse = [f"in {flat} a unit is {math.ulp(FLAT):.2g}, half of the digits: a maximum is flat"]
    if found.agrees:
        return [f"{out[0]}; agrees", *(coarse if flat else [])]
    out += [f"at {named(found, found.at)}", values(found)]
    if found.missing:
        out += [f"NaN at {len(found.missing)} points, such as {named(found, found.missing[0])}"]
    return [*out, *(coarse if flat else []), *found.names, "differs"]


def text(report: Report) -> str:
    """For people."""
    return "\n  ".join(lines(report)) + "\n"


def github(report: Report) -> str:
    """An error that GitHub shows beside the line of the function; nothing special if none."""
    if report.found.agrees:
        return text(report)
    given = [("title", f"symhaptic check of {report.of}")]
    if report.place is not None:
        given = [("file", report.place[0]), ("line", str(report.place[1])), *given]
    told = ",".join(f"{name}={_escaped(text, ':,')}" for name, text in given)
    return f"::error {told}::{_escaped(chr(10).join(lines(report)[:-1]))}\n"


def _escaped(text: str, more: str = "") -> str:
    """As GitHub reads it: what ends a line, or a property of it, by its number."""
    for letter in f"%\r\n{more}":
        text = text.replace(letter, f"%{ord(letter):02X}")
    return text


def junit(report: Report) -> str:
    """One test case."""
    found, seconds = report.found, f"{report.seconds:.3f}"
    suite = ET.Element("testsuite", name="symhaptic check", tests="1", time=seconds)
    suite.set("failures", str(int(not found.agrees)))
    case = ET.SubElement(
        suite, "testcase", name=found.checked.id, classname=report.of, time=seconds
    )
    if not found.agrees:
        first, *rest = lines(report)
        ET.SubElement(case, "failure", message=first).text = "\n".join(rest)
    ET.SubElement(case, "system-out").text = text(report)
    ET.indent(suite)
    return ET.tostring(suite, "unicode", xml_declaration=True) + "\n"


def json_text(report: Report) -> str:
    """For programs; floats are hexadecimal, and infinite is null."""
    found = report.found
    data = {
        "formula": found.checked.id,
        "function": report.of,
        "agrees": found.agrees,
        "points": found.points,
        "balls": len(found.looked),
        "worst_ulp": found.worst if found.worst < float("inf") else None,
        "allowed_ulp": found.ulp,
        "at": {name: v.hex() for name, v in zip(found.checked.ranges, found.at, strict=True)},
        "result": found.result,
        "got": [v.hex() for v in found.got],
        "exact": list(found.right),
        "nan": len(found.missing),
        "mistakes": list(found.names),
        "seconds": round(report.seconds, 3),
    }
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def table(report: Report) -> str:
    """The points in balls: arguments and results as hexadecimal floats, exact values, error."""
    found, checked = report.found, report.found.checked
    mine = [f"{name}_got" for name in checked.results]
    out = [",".join((*checked.ranges, *checked.results, *mine, "ulp"))]
    for point, got, off in found.looked:
        out.append(",".join((*_row(checked, point), *(v.hex() for v in got), f"{max(off, 0):.3g}")))
    return "\n".join(out) + "\n"


def exact_table(checked: Checked, count: int) -> str:
    """The same of no function, for tests in a language that this package does not speak."""
    head = ",".join((*checked.ranges, *checked.results))
    rows = (",".join(_row(checked, point)) for point in points(checked, count))
    return "\n".join((head, *rows)) + "\n"


def _row(checked: Checked, point: Point) -> list[str]:
    """Arguments as hexadecimal floats, then 25 digits of each result; ``nan`` where it has none."""
    return [*(v.hex() for v in point), *map(shown, exact_at(checked, point)[0])]


FORMATS: dict[str, Callable[[Report], str]] = {
    "text": text,
    "github": github,
    "junit": junit,
    "json": json_text,
    "table": table,
}
