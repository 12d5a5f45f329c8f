"""The result of a comparison as text, as GitHub's annotation, as JUnit, as JSON and as a table."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple
from xml.etree import ElementTree as ET

import numpy as np

from symhaptic.check.checked import FLAT, Checked, Point, exact, shown
from symhaptic.check.compare import Found, error
from symhaptic.check.points import Range, drawn


@dataclass(frozen=True)
class Report:
    """The result of a comparison, with the function and the time."""

    found: Found
    of: str
    """The function, such as ``my.module:f``."""
    seconds: float
    place: tuple[str, int] | None = None
    """File and line."""


def named(found: Found, point: Point) -> str:
    """Arguments by name, as hexadecimal floats and as one reads them."""
    pairs = zip(found.checked.arguments, point, strict=True)
    return ", ".join(f"{name} = {v.hex()} ({v:.6g})" for name, v in pairs)


def lines(report: Report) -> list[str]:
    """What was found, a line each."""
    found = report.found
    head = f"{found.checked.id}: {found.called} points, {len(found.looked)} with exact values, "
    out = [head + _worst(found)]
    if found.agrees:
        out[0] += "; agrees"
    else:
        rows = zip(found.results, found.got, _right(found), strict=True)
        out += [f"at {named(found, found.at)}"]
        out += ["; ".join(f"{name} is {mine!r}, exact {right}" for name, mine, right in rows)]
        if found.checked.refutes and (why := found.checked.refutes(found.at, found.got)):
            out += [why]
    if found.missing and not found.agrees:
        out += [f"NaN at {len(found.missing)} points, such as {named(found, found.missing[0])}"]
    if flat := " and ".join(name for name in found.checked.flat if name in found.results):
        unit = f"{math.ulp(FLAT):.2g}"
        out += [f"in {flat} a unit is {unit}, half of the digits: a maximum is flat"]
    out += _covered(found)
    return out if found.agrees else [*out, *found.names, "differs"]


def _right(found: Found) -> list[str]:
    values, _ = exact(found.checked, found.at)
    return list(map(shown, values[: len(found.results)]))


def _worst(found: Found) -> str:
    """The worst error; for truth values and counts, their distance from the boundary."""
    if found.checked.border is None:
        name = error(found.checked, found.at, found.got)[1]
        return f"worst error {found.worst:.3g} ulp of {name}"
    if found.worst == 0:
        return "no wrong answer"
    if math.isinf(found.worst):
        return "wrong answers that no rounding of the arguments explains"
    away = f"{found.worst:.3g} ulp ({found.worst * 2.0**-52:.1g} relative)"
    return f"wrong answers within {away} of the boundary"


def _covered(found: Found) -> list[str]:
    what = covered(found)
    ranges = (f"{name} {low:.3g} to {high:.3g}" for name, (low, high) in what["ranges"].items())
    out = [f"covered: {', '.join(ranges)}"]
    if what["kinds"]:
        out += ["points with " + ", ".join(f"{words}: {n}" for words, n in what["kinds"].items())]
    if what["beside"]:
        by = ", ".join(f"{n} at {distance}" for distance, n in what["beside"].items())
        out += [f"both sides of the boundary, at relative distances: {by}"]
    return [*out, f"not covered: {'; '.join(what['missing'])}"] if what["missing"] else out


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
    properties = ",".join(f"{name}={_escaped(text, ':,')}" for name, text in given)
    return f"::error {properties}::{_escaped(chr(10).join(lines(report)[:-1]))}\n"


def _escaped(text: str, more: str = "") -> str:
    """As GitHub reads it: what ends a line, or a property of it, by its number."""
    for letter in f"%\r\n{more}":
        text = text.replace(letter, f"%{ord(letter):02X}")
    return text


def junit(report: Report) -> str:
    """One test case, with what was covered as properties."""
    found, seconds = report.found, f"{report.seconds:.3f}"
    suite = ET.Element("testsuite", name="symhaptic check", tests="1", time=seconds)
    suite.set("failures", str(int(not found.agrees)))
    case = ET.SubElement(
        suite, "testcase", name=found.checked.id, classname=report.of, time=seconds
    )
    properties = ET.SubElement(case, "properties")
    counts = {"points": found.called, "exact_values": len(found.looked)}
    for name, value in (counts | covered(found)).items():
        ET.SubElement(properties, "property", name=name, value=json.dumps(value))
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
        "points": found.called,
        "exact_values": len(found.looked),
        "covered": covered(found),
        "worst_ulp": found.worst if found.worst < math.inf else None,
        "allowed_ulp": found.ulp,
        "at": {name: v.hex() for name, v in zip(found.checked.arguments, found.at, strict=True)},
        "got": [v.hex() for v in found.got],
        "exact": _right(found),
        "nan": len(found.missing),
        "mistakes": list(found.names),
        "seconds": round(report.seconds, 3),
    }
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def table(report: Report) -> str:
    """Points with exact values: arguments, exact values, results and the error."""
    found = report.found
    mine = [f"{name}_got" for name in found.results]
    out = [",".join((*found.checked.arguments, *found.results, *mine, "ulp"))]
    for i, got, off in found.looked:
        row = _row(found.checked, found.points.all[i], len(found.results))
        out.append(",".join((*row, *(v.hex() for v in got), f"{max(off, 0):.3g}")))
    return "\n".join(out) + "\n"


def exact_table(checked: Checked, count: int, over: Range | None = None) -> str:
    """The same without a function, for tests in a language that this package does not speak."""
    head = ",".join((*checked.arguments, *checked.results))
    points = drawn(checked, count, over).all
    rows = (",".join(_row(checked, p, len(checked.results))) for p in points)
    return "\n".join((head, *rows)) + "\n"


def _row(checked: Checked, point: Point, results: int) -> list[str]:
    """Arguments as hexadecimal floats, then 25 digits of each result; ``nan`` where it has none."""
    values = exact(checked, point)[0][:results]
    return [*(v.hex() for v in point), *("nan" if v is None else shown(v) for v in values)]


FORMATS: dict[str, Callable[[Report], str]] = {
    "text": text,
    "github": github,
    "junit": junit,
    "json": json_text,
    "table": table,
}


# -- what the points of a comparison cover, and what they do not

_CLOSE = 1e-3


def _beside_multiple(gamma: Any, delta: Any) -> Any:
    swing = np.sqrt(np.maximum(gamma - delta**2 / 4, 0)) / np.pi
    return (swing > 0.5) & (abs(swing - np.round(swing)) <= _CLOSE * swing)


class _Kind(NamedTuple):
    """A kind of points."""

    words: str
    arguments: str
    inside: Callable[..., Any]
    fractional: bool = False
    """Whether they have fractional delays: a formula for integer delays has no such points."""


_KINDS = tuple(_Kind(*kind) for kind in (
    ("no delay", "d", lambda d: d == 0),
    ("integer delays", "d", lambda d: (d > 0) & (d == np.floor(d))),
    ("fractional delays", "d", lambda d: d != np.floor(d), True),
    ("delays next to an integer", "d",
     lambda d: (d != np.floor(d)) & (abs(d - np.round(d)) <= _CLOSE), True),
    ("delays above 100 periods", "d", lambda d: d > 100),
    ("no device stiffness", "gamma", lambda gamma: gamma == 0),
    ("natural frequencies above pi/T", "gamma", lambda gamma: gamma > np.pi**2),
    ("no device damping", "delta", lambda delta: delta == 0),
    ("device damping below 1e-6", "delta", lambda delta: (delta > 0) & (delta < 1e-6)),
    ("damping next to critical", "gamma delta",
     lambda gamma, delta: (gamma > 0) & (abs(delta**2 - 4 * gamma) <= _CLOSE * 4 * gamma)),
    ("omega_d T next to a multiple of pi", "gamma delta", _beside_multiple),
    ("angles below 0.001", "theta", lambda theta: theta < _CLOSE),
    ("angles next to pi", "theta", lambda theta: theta > np.pi - _CLOSE),
    ("negative wall stiffness", "alpha", lambda alpha: alpha < 0),
    ("negative wall damping", "beta", lambda beta: beta < 0),
))  # fmt: skip


def covered(found: Found) -> dict[str, Any]:
    """Ranges of the arguments, numbers of points by kind, and what is missing.

    ``beside`` has the number of points at each relative distance from a boundary.
    """
    checked, asked = found.checked, len(found.points.all)
    columns = np.array(found.points.all[: found.called]).T
    at = dict(zip(checked.arguments, columns, strict=True))
    sizes = _sizes(at)
    delay = checked.arguments.get("d")
    whole = delay is not None and delay.whole
    kinds = {
        kind.words: int(kind.inside(*(sizes[name] for name in kind.arguments.split())).sum())
        for kind in _KINDS
        if sizes.keys() >= set(kind.arguments.split()) and not (whole and kind.fractional)
    }
    seen = {i for i, _, _ in found.looked}
    far = [d for i, d in enumerate(found.points.distance[: found.called]) if i in seen and d == d]
    missing = [*checked.open, *(words for words, count in kinds.items() if not count)]
    known = [i in found.silent or error > -math.inf for i, _, error in found.looked]
    if unknown := known.count(False):
        missing.append(f"{unknown} points of which no exact value is known")
    if found.silent:
        told = f'{checked.no_answer:g} was accepted for "not known"'
        missing.append(f"points at which {told}: {len(found.silent)}")
    if found.called < asked:
        missing.append(f"{asked - found.called} of {asked} points: the function is slow")
    return {
        "ranges": {name: (float(v.min()), float(v.max())) for name, v in at.items()},
        "kinds": {words: count for words, count in kinds.items() if count},
        "beside": {f"{d:.0e}": far.count(d) for d in sorted(set(far))},
        "missing": missing,
    }


def _sizes(at: dict[str, Any]) -> dict[str, Any]:
    """The arguments, and those in SI units as numbers without unit."""
    found = dict(at)
    if {"m", "T"} <= at.keys():
        found["gamma"], found["delta"] = (
            at["k"] * at["T"] ** 2 / at["m"],
            at["b"] * at["T"] / at["m"],
        )
    if "omega" in at:
        found["theta"] = at["omega"] * at["T"]
    return found
