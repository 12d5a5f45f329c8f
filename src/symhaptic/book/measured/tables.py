"""A record as tables: plain cells, which Markdown and LaTeX both show."""

from __future__ import annotations

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
        _floats(record["functions"]),
        _digits(record["functions"]),
        _boundary(record["boundary"]),
        _times(record["stability"]),
        _wrong(record["stability"]),
        _models(record["models"]),
        _peers(record["peers"]),
    ]


def words(name: str) -> str:
    """A function's name in words."""
    return name.replace("_", " ")


def _names(rows: Iterable[Row], field: str) -> list[Any]:
    return list(dict.fromkeys(row[field] for row in rows))


def _units(last: float | None) -> str:
    return "> 1e16" if last is not None and last > 1e16 else number(last)


def _floats(rows: list[Row]) -> Table:
    found = []
    for name in _names(rows, "function"):
        first = True
        for way in _names(rows, "way"):
            at = {
                r["set"]: r
                for r in rows
                if (r["function"], r["way"], r["precision"]) == (name, way, "float64")
            }
            if not at:
                continue
            easy, hard = at["ordinary"], at["hard"]
            found.append(
                (
                    words(name) if first else "",
                    way,
                    nanoseconds(easy["seconds"]),
                    _units(easy["median"]),
                    _units(easy["worst"]),
                    share(easy["missing"]),
                    _units(hard["median"]),
                    _units(hard["worst"]),
                    share(hard["missing"]),
                )
            )
            first = False
    head = ("function", "way", "time", "median", "worst", "NaN", "median", "worst", "NaN")
    says = (
        "Errors in units in the last place of the largest term of the stable form, in double "
        "precision; first on ordinary parameters, inside (23), then on hard ones. Above $10^{16}$ "
        "no digit is left. NaN is the share in per cent of points without a number."
    )
    return Table("Functions in double precision", head, tuple(found), 2, says)


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
        first = True
        for way, precision in _OTHER:
            at = {
                r["set"]: r
                for r in rows
                if (r["function"], r["way"], r["precision"]) == (name, way, precision)
            }
            if not at:
                continue
            cells = [nanoseconds(at["ordinary"]["seconds"])]
            for which in ("ordinary", "hard"):
                row = at[which]
                worst = None if row["worst"] is None else row["worst"] * row["last"]
                cells += [number(worst), share(row["missing"])]
            found.append((words(name) if first else "", f"{way}, {precision}", *cells))
            first = False
    head = ("function", "way", "time", "worst", "NaN", "worst", "NaN")
    says = (
        "Worst error in parts of the largest term, for balls their radius, on ordinary and on hard "
        "parameters. Numbers of 50 digits are mpmath's, balls python-flint's. A stable form whose "
        "value is zero has no 50 digits that could agree, and counts as NaN: beta without delay."
    )
    return Table("Functions in other precisions", head, tuple(found), 2, says)


def _boundary(rows: list[Row]) -> Table:
    limits = [t for t in _names(rows, "threshold") if t is not None]
    ends = (max(limits), min(limits))
    found = []
    for delay in _names(rows, "delay"):
        for i, method in enumerate(_names(rows, "method")):
            some = [r for r in rows if (r["delay"], r["method"]) == (delay, method)]
            cells = []
            for limit in ends:
                for row in some:
                    if row["threshold"] in (limit, None):
                        cells += [nanoseconds(row["seconds"]), number(row["worst"])]
            if len(some) == 1:
                cells = [*cells[:2], "", ""]
            found.append((f"{delay}" if not i else "", method, *cells))
    coarse, fine = (f"{t:.0e}".replace("e-0", "e-") for t in ends)
    head = ("d", "method", f"time, to {coarse}", "worst", f"time, to {fine}", "worst")
    says = (
        "Time per point, and the largest distance of a point from the exact curve, in the plane of "
        "alpha and beta, for two thresholds of the bisection. The explicit form has none."
    )
    return Table("Points of the boundary of stability", head, tuple(found), 2, says)


def _times(rows: list[Row]) -> Table:
    methods = _names(rows, "method")
    found = []
    for delay in _names(rows, "delay"):
        at = {r["method"]: r for r in rows if r["delay"] == delay}
        found.append((f"{delay}", *(nanoseconds(at[m]["seconds"]) for m in methods)))
    says = "Time per wall, its plant's parameters given, over the delay in periods."
    return Table("Time of a stability test", ("d", *methods), tuple(found), 1, says)


def _wrong(rows: list[Row]) -> Table:
    found = []
    for method in _names(rows, "method"):
        some = [r for r in rows if r["method"] == method]
        cells = [share(_average(some, eps)) for eps in some[0]["wrong"]]
        refused = sum(r["refused"] * r["walls"] for r in some) / sum(r["walls"] for r in some)
        found.append((method, *cells, share(float(refused))))
    distances = [f"{float(e):.0e}".replace("e-0", "e-") for e in rows[0]["wrong"]]
    walls = sum(r["walls"] for r in rows if r["method"] == rows[0]["method"])
    says = (
        f"Share in per cent of {walls} walls, of all these delays, that are judged wrongly at a "
        "relative distance from the boundary, and share that gets no verdict; one plant of four "
        "has no stiffness, one critical damping. The truth is Jury's table in balls."
    )
    return Table(
        "Wrong verdicts near the boundary", ("method", *distances, "refused"), tuple(found), 1, says
    )


def _average(rows: list[Row], eps: str) -> float:
    return float(sum(r["wrong"][eps] * r["walls"] for r in rows) / sum(r["walls"] for r in rows))


def _models(rows: list[Row]) -> Table:
    shares = _names(rows, "damping")
    found = []
    for delay in _names(rows, "delay"):
        for i, model in enumerate(_names(rows, "model")):
            some = [r for r in rows if (r["delay"], r["model"]) == (delay, model)]
            cells = [
                f"{share(r['least'])} to {share(r['most'])}" if model != "full" else "0"
                for r in some
            ]
            found.append(
                (f"{delay}" if not i else "", model, nanoseconds(some[0]["seconds"]), *cells)
            )
    head = ("d", "model", "time", *(f"{100 * s:g} %" for s in shares))
    says = (
        "Error in per cent of the largest stable stiffness that a simpler model gives, from least "
        "to most over (23): above zero it allows walls that are not stable. One column for each "
        "virtual damping, in parts of that of the stiffest wall."
    )
    return Table("Simpler models", head, tuple(found), 2, says)


def _peers(rows: list[Row]) -> Table:
    found = []
    for task in _names(rows, "task"):
        for i, row in enumerate(r for r in rows if r["task"] == task):
            start = (task if not i else "", row["tool"])
            if not row["installed"]:
                found.append((*start, "not installed", "", "", "", ""))
                continue
            off = number(row["worst"]) if row["wrong"] is None else f"{share(row['wrong'])} % wrong"
            if row["missing"]:
                off += f", {share(row['missing'])} % no answer"
            one, many = nanoseconds(row["one"]), nanoseconds(row["many"])
            ratios = number(row["ratio_one"]), number(row["ratio_many"])
            found.append((*start, one, ratios[0], many, ratios[1], off))
    head = ("question", "tool", "one", "ratio", "of many", "ratio", "worst error")
    says = (
        "Time of one call, and per element on arrays of 20 000, one after the other where a tool "
        "has no arrays; each beside the package's own in the same run. Errors are relative; walls "
        "to be judged have d = 2 and lie within 1e-12 of the boundary. A phase margin is a delay "
        "only where that is whole: the others' error of a delay margin is that of their question."
    )
    return Table("Beside other tools", head, tuple(found), 2, says)


def markdown(record: dict[str, Any]) -> str:
    """All tables as Markdown."""
    lines = [f"# Speed against error\n\n{about(record)} {record['method']}"]
    for table in tables(record):
        lines += [f"\n## {table.title}\n\n{table.says}\n", f"| {' | '.join(table.head)} |"]
        lines.append("|" + "---|" * len(table.head))
        lines += [f"| {' | '.join(row)} |" for row in table.rows]
    return "\n".join(lines) + "\n"


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
