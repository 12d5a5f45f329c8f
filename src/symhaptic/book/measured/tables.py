"""A record as tables: plain cells, which Markdown and LaTeX both show."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

Row = dict[str, Any]


@dataclass(frozen=True)
class Table:
    """A table, its first columns words and the others numbers."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int
    says: str
    """What the numbers are."""


def number(value: float | None) -> str:
    """Two digits, or a dash.

    >>> number(0.0123), number(1234567.0), number(35.2), number(0.0), number(None)
    ('0.012', '1.2e6', '35', '0', '-')
    """
    if value is None:
        return "-"
    if value == 0:
        return "0"
    if 0.01 <= abs(value) < 9950:
        return f"{float(f'{value:.2g}'):g}" if abs(value) < 100 else f"{float(f'{value:.2g}'):.0f}"
    mantissa, _, power = f"{value:.1e}".partition("e")
    return f"{mantissa}e{int(power)}"


def share(value: float | None) -> str:
    """In per cent.

    >>> share(0.5), share(0.0), share(0.0012)
    ('50', '0', '0.1')
    """
    if value is None:
        return "-"
    percent = 100 * value
    shown = f"{percent:.0f}" if percent == 0 or abs(percent) >= 9.95 else f"{percent:.1f}"
    return "0" if shown in ("0.0", "-0.0", "-0") else shown


def nanoseconds(seconds: float) -> str:
    """The time in ns, us, ms or s.

    >>> nanoseconds(2.1e-8), nanoseconds(0.0035), nanoseconds(1.5)
    ('21 ns', '3.5 ms', '1.5 s')
    """
    for unit, scale in (("ns", 1e-9), ("us", 1e-6), ("ms", 1e-3)):
        if seconds < 999.5 * scale:
            return f"{float(f'{seconds / scale:.2g}'):g} {unit}"
    return f"{float(f'{seconds:.2g}'):g} s"


def tables(record: dict[str, Any]) -> list[Table]:
    """All tables of a record, in the order of its sections."""
    return [
        calls(record["functions"]),
        judges(record["stability"]),
        _floats(record["functions"]),
        _digits(record["functions"]),
        _boundary(record["boundary"]),
        _times(record["stability"]),
        _wrong(record["stability"]),
        _models(record["models"]),
        _peers(record["peers"]),
    ]


ERRORS = (1e-5, 1e-14, 1e-28, 1e-48)
"""Errors for which the fastest call is listed."""

_OFFERED = {
    ("C", "float64"): "C",
    ("package", "float64"): "symhaptic",
    ("stable", "float32"): "float32",
    ("stable", "float64"): "lambdify",
    ("stable", "30 digits"): "mpmath, 30",
    ("stable", "50 digits"): "mpmath, 50",
    ("package", "30 digits"): "digits=30",
    ("package", "50 digits"): "digits=50",
}
"""Ways to compute in this package, with the name of each in the table."""


def calls(rows: list[Row]) -> Table:
    """For each function and error the fastest call that reaches it at all points."""
    found = []
    for name in _names(rows, "function"):
        cells = [words(name)]
        for most in ERRORS:
            good: list[tuple[float, str]] = []
            for (way, precision), call in _OFFERED.items():
                at = chosen(rows, function=name, way=way, precision=precision)
                if at and all(_keeps(row, most) for row in at):
                    good.append((max(row["seconds"] for row in at), call))
            seconds, call = min(good, default=(0.0, ""))
            cells.append(f"{call}: {nanoseconds(seconds)}" if call else "-")
        found.append(tuple(cells))
    says = (
        "The table gives, for each error, the fastest call that does not exceed it, and the time "
        "per value. The error is the largest one for all ordinary and hard parameters, relative to "
        "the largest term of the result. No result is NaN. C stands for exported C code, and "
        "digits=30 for a call of the package with this argument. The functions for float32 and "
        "mpmath are those of lambdify; for example, mpmath, 30 is mpmath with 30 digits."
    )
    head = ("function", *(f"to {_power(most)}" for most in ERRORS))
    return Table("Fastest call for a given error", head, tuple(found), len(head), says)


def _keeps(row: Row, most: float) -> bool:
    if row["precision"].endswith("digits") and row["last"] > 10 * most:
        return False  # what is asked for counts, not what it happens to be
    return row["missing"] == 0 and row["worst"] is not None and row["worst"] * row["last"] <= most


_JUDGES = {
    "counted": "is_stable",
    "counted, C": "is_stable in exported C",
    "certified": "is_stable, certified=True",
}


def judges(rows: list[Row]) -> Table:
    """For each distance from the boundary the fastest call with a correct verdict for all walls."""
    found = []
    for distance in rows[0]["wrong"]:
        good = []
        for method, call in _JUDGES.items():
            at = chosen(rows, method=method)
            if at and all(r["wrong"][distance] == r["open"][distance] == 0 for r in at):
                good.append((max(r["near"][distance] for r in at), call))
        seconds, call = min(good, default=(0.0, "-"))
        found.append((_power(distance), call, nanoseconds(seconds) if good else "-"))
    says = (
        "The table gives the fastest call whose verdict is correct for all walls at this relative "
        "distance from the boundary. The time is per wall, for the delay at which the call is "
        "slowest."
    )
    head = ("distance", "call", "time")
    return Table("Fastest call for a given distance", head, tuple(found), 2, says)


def words(name: str) -> str:
    """A function's name in words.

    >>> words("max_passive_stiffness"), words("passivity_margin_at")
    ('largest passive stiffness', 'passivity margin at one angle')
    """
    shown = f"{name}_one_angle" if name.endswith("_at") else name
    return shown.replace("max_", "largest_").replace("_", " ")


def chosen(rows: Iterable[Row], **fields: Any) -> list[Row]:
    """The rows that have these values."""
    return [row for row in rows if all(row[field] == is_ for field, is_ in fields.items())]


def _names(rows: Iterable[Row], field: str) -> list[Any]:
    return list(dict.fromkeys(row[field] for row in rows))


def _grouped(rows: Iterable[tuple[str, ...]]) -> tuple[tuple[str, ...], ...]:
    """Rows of which only the first of a group has its name."""
    found: list[tuple[str, ...]] = []
    last = None
    for name, *cells in rows:
        found.append((name if name != last else "", *cells))
        last = name
    return tuple(found)


def _power(threshold: float | str) -> str:
    return f"{float(threshold):.0e}".replace("e-0", "e-")


def _units(last: float | None) -> str:
    return "> 1e16" if last is not None and last > 1e16 else number(last)


def _floats(rows: list[Row]) -> Table:
    found = []
    for name in _names(rows, "function"):
        for way in _names(rows, "way"):
            at = {r["set"]: r for r in chosen(rows, function=name, way=way, precision="float64")}
            if at:
                cells = [words(name), way, nanoseconds(at["ordinary"]["seconds"])]
                for row in (at["ordinary"], at["hard"]):
                    cells += [_units(row["median"]), _units(row["worst"]), share(row["missing"])]
                found.append(tuple(cells))
    head = ("function", "way", "time", "median", "worst", "NaN", "median", "worst", "NaN")
    says = (
        "Errors in units in the last place (ulp) of the largest term of the stable form, in double "
        "precision. The first columns are for ordinary parameters, inside (23), the others for "
        "hard ones. Above $10^{16}$ no digit is correct. NaN is the share of points without a "
        "number, in per cent."
    )
    return Table("Functions in double precision", head, _grouped(found), 2, says)


_OTHER = (
    ("printed", "float32"),
    ("stable", "float32"),
    ("printed", "50 digits"),
    ("stable", "50 digits"),
    ("balls", "53 bits"),
    ("balls", "128 bits"),
)


def _digits(rows: list[Row]) -> Table:
    found = []
    for name in _names(rows, "function"):
        for way, precision in _OTHER:
            at = {r["set"]: r for r in chosen(rows, function=name, way=way, precision=precision)}
            if at:
                seconds = nanoseconds(at["ordinary"]["seconds"])
                cells = [words(name), f"{way}, {precision}", seconds]
                for row in (at["ordinary"], at["hard"]):
                    worst = None if row["worst"] is None else row["worst"] * row["last"]
                    cells += [number(worst), share(row["missing"])]
                found.append(tuple(cells))
    head = ("function", "way", "time", "worst", "NaN", "worst", "NaN")
    says = (
        "Worst error relative to the largest term, for ordinary and for hard parameters; for balls "
        "it is their radius. Numbers with 50 digits are computed by mpmath, and balls by "
        "python-flint. A result of zero, as beta without delay, has no 50 digits to compare and "
        "counts as NaN."
    )
    return Table("Functions in other precisions", head, _grouped(found), 2, says)


def _boundary(rows: list[Row]) -> Table:
    limits = [t for t in _names(rows, "threshold") if t is not None]
    ends = (max(limits), min(limits))
    found = []
    for delay in _names(rows, "delay"):
        for method in _names(rows, "method"):
            points = chosen(rows, delay=delay, method=method)
            cells = [
                cell
                for row in sorted(points, key=lambda r: -(r["threshold"] or 0))
                if row["threshold"] in (*ends, None)
                for cell in (nanoseconds(row["seconds"]), number(row["worst"]))
            ]
            found.append((f"{delay}", method, *cells, *[""] * (4 - len(cells))))
    coarse, fine = map(_power, ends)
    head = ("d", "method", f"time, to {coarse}", "worst", f"time, to {fine}", "worst")
    says = (
        "Time per point, and the largest distance of a point from the exact curve, in the plane of "
        "alpha and beta, for two thresholds of the bisection. The explicit form has none."
    )
    return Table("Points of the boundary of stability", head, _grouped(found), 2, says)


def _times(rows: list[Row]) -> Table:
    methods = _names(rows, "method")
    found = []
    for delay in _names(rows, "delay"):
        at = {r["method"]: r for r in chosen(rows, delay=delay)}
        found.append((f"{delay}", *(nanoseconds(at[m]["seconds"]) for m in methods)))
    says = "Time per wall against the delay in periods, for given parameters of the plant."
    return Table("Time of a stability test", ("d", *methods), tuple(found), 1, says)


def _wrong(rows: list[Row]) -> Table:
    found = []
    for method in _names(rows, "method"):
        judged = chosen(rows, method=method)
        missed = [average(judged, [r["wrong"][eps] for r in judged]) for eps in rows[0]["wrong"]]
        refused = average(judged, [r["refused"] for r in judged])
        found.append((method, *map(share, (*missed, refused))))
    walls = sum(r["walls"] for r in chosen(rows, method=rows[0]["method"]))
    says = (
        f"Share of wrong verdicts at each relative distance from the boundary, and share without a "
        f"verdict, in per cent of {walls} walls with all these delays. One of four plants has no "
        "stiffness, and one has critical damping. The reference is Jury's table in ball arithmetic."
    )
    head = ("method", *map(_power, rows[0]["wrong"]), "refused")
    return Table("Wrong verdicts near the boundary", head, tuple(found), 1, says)


def average(rows: list[Row], shares: Iterable[float]) -> float:
    """The share of all walls, of those of each row."""
    walls = [row["walls"] for row in rows]
    return float(sum(map(operator.mul, shares, walls)) / sum(walls))


def _models(rows: list[Row]) -> Table:
    found = []
    for delay in _names(rows, "delay"):
        for model in _names(rows, "model"):
            limits = chosen(rows, delay=delay, model=model)
            cells = [
                "0" if model == "full" else f"{share(r['least'])} to {share(r['most'])}"
                for r in limits
            ]
            found.append((f"{delay}", model, nanoseconds(limits[0]["seconds"]), *cells))
    head = ("d", "model", "time", *(f"{100 * s:g} %" for s in _names(rows, "damping")))
    says = (
        "Error of the largest stable stiffness of a simpler model, in per cent, from the least to "
        "the most in (23). A positive error allows walls that are not stable. There is one column "
        "for each virtual damping, in per cent of that of the stiffest wall."
    )
    return Table("Simpler models", head, _grouped(found), 2, says)


def _peers(rows: list[Row]) -> Table:
    found = []
    for row in (row for task in _names(rows, "task") for row in chosen(rows, task=task)):
        start = (row["task"], row["tool"])
        if not row["installed"]:
            found.append((*start, "not installed", "", "", "", ""))
            continue
        off = number(row["worst"]) if row["wrong"] is None else f"{share(row['wrong'])} % wrong"
        off += f", {share(row['missing'])} % no answer" if row["missing"] else ""
        one, many = nanoseconds(row["one"]), nanoseconds(row["many"])
        found.append((*start, one, number(row["ratio_one"]), many, number(row["ratio_many"]), off))
    head = ("question", "tool", "one", "ratio", "of many", "ratio", "worst error")
    says = (
        "Time of one call, and time per element of an array of 20 000; a tool without arrays is "
        "called for each element. The ratios are to the package's own time in the same run. Errors "
        "are relative. Walls for a verdict have d = 2 and lie within 1e-12 of the boundary. The "
        "other tools derive a delay margin from the phase margin, which is exact for integer "
        "delays only; this is their error."
    )
    return Table("Beside other tools", head, _grouped(found), 2, says)


def markdown(record: dict[str, Any]) -> str:
    """All tables as Markdown."""
    begin = f"# Speed against error\n\n{about(record)} {record['method']}"
    return "\n".join([begin, *map(in_markdown, tables(record))]) + "\n"


def in_markdown(table: Table, level: str = "##") -> str:
    """A table as Markdown, below its title."""
    lines = [f"\n{level} {table.title}\n\n{table.says}\n", f"| {' | '.join(table.head)} |"]
    lines.append("|" + "---|" * len(table.head))
    lines += [f"| {' | '.join(row)} |" for row in table.rows]
    return "\n".join(lines)


def about(record: dict[str, Any]) -> str:
    """Machine and versions in a sentence."""
    machine = record["machine"]
    tools = ", ".join(f"{k} {v or 'not installed'}" for k, v in record["versions"].items())
    when = [f"on {record['date']}"] if record.get("date") else []
    when += [f"at commit {record['commit']}"] if record.get("commit") else []
    took = f", in {record['seconds']} s" if record.get("seconds") else ""
    return (
        f"Measured {''.join(f'{told}, ' for told in when)}on {machine['processor']}, "
        f"{machine['cores']} cores, {machine['system']}, with {tools}, one thread{took}."
    )
