"""What a measurement says, in sentences: each figure in them is one of its record."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from symhaptic.book.measured.tables import Row, average, chosen, nanoseconds, number, share

_PERCENT = "per cent"


def sentences(record: dict[str, Any]) -> dict[str, str]:
    """Of each section of the chapter; empty where a record has not the rows that it is about."""
    return {
        "formulas": _formulas(record["functions"]),
        "boundary": _boundary(record["boundary"]),
        "stability": _stability(record["stability"]),
        "models": _models(record["models"]),
        "peers": _peers(record["peers"]),
    }


def _range(times: Iterable[float]) -> str:
    times = sorted(times)
    ends = [nanoseconds(times[0]), nanoseconds(times[-1])]
    return ends[0] if ends[0] == ends[1] else " to ".join(ends)


def _formulas(rows: list[Row]) -> str:
    device = chosen(rows, function="discretize", way="printed")
    known = {(row["precision"], row["set"]): row for row in device}
    easy, hard = (known.get(("float64", name)) for name in ("ordinary", "hard"))
    many = known.get(("50 digits", "hard"))
    stable = [row["worst"] for row in chosen(rows, way="stable", precision="float64")]
    stable = [worst for worst in stable if worst is not None]
    if not (easy and hard and many and stable):
        return ""
    return (
        f"For ordinary parameters, the error of the device by (14) in double precision is "
        f"{number(easy['median'])} ulp in the median and {number(easy['worst'])} ulp at most. For "
        f"{share(hard['missing'])} {_PERCENT} of the hard parameters (14) gives no number; with 50 "
        f"digits it gives none for {share(many['missing'])} {_PERCENT}. The error of the stable "
        f"forms is at most {number(max(stable))} ulp for all parameters."
    )


def _boundary(rows: list[Row]) -> str:
    explicit, grid = chosen(rows, method="explicit"), chosen(rows, method="grid")
    if not (explicit and grid):
        return ""
    finest = chosen(grid, threshold=min(row["threshold"] for row in grid))
    told = [
        f"{_range(row['seconds'] for row in some)} per point, with an error of "
        f"{number(max(row['worst'] for row in some))} at most"
        for some in (explicit, finest)
    ]
    return f"For these delays the explicit form takes {told[0]}; the finest grid takes {told[1]}."


def _stability(rows: list[Row]) -> str:
    first, last = (end(row["delay"] for row in rows) for end in (min, max))
    names = {"eigenvalues": "by eigenvalues", "Jury table": "by Jury's table",
             "counted": "by the count"}  # fmt: skip
    times, wrong = [], []
    for method, way in names.items():
        some = {row["delay"]: row for row in chosen(rows, method=method)}
        if first not in some or last not in some:
            return ""
        begin, end = (nanoseconds(some[d]["seconds"]) for d in (first, last))
        times.append(f"{begin} and {end} {way}")
        close = min(rows[0]["wrong"], key=float)
        missed = average([*some.values()], [row["wrong"][close] for row in some.values()])
        wrong.append(f"{share(missed)} {_PERCENT} {way}")
    near = f"{float(close):.0e}".replace("e-0", "e-")
    return (
        f"For d = {first} and d = {last} a test takes {_listed(times)}. At the relative distance "
        f"{near} from the boundary, the share of wrong verdicts is {_listed(wrong)}."
    )


def _listed(words: list[str]) -> str:
    return f"{', '.join(words[:-1])}, and {words[-1]}"


def _models(rows: list[Row]) -> str:
    def farthest(some: list[Row]) -> str:
        return share(max(max(abs(row["most"]), abs(row["least"])) for row in some))

    linear = chosen(rows, model="linear")
    plain = [row for row in linear if row["damping"] == 0]
    damped = [row for row in linear if row["damping"] > 0]
    if not (plain and damped):
        return ""
    told = [
        f"The error of the linear condition (25) is up to {farthest(plain)} {_PERCENT} without "
        f"virtual damping and up to {farthest(damped)} {_PERCENT} with it. It allows up to "
        f"{share(max(0.0, *(row['most'] for row in damped)))} {_PERCENT} more stiffness than is "
        "stable."
    ]
    for model, left_out in (("no stiffness", "stiffness"), ("no damping", "damping")):
        some = chosen(rows, model=model)
        if some:
            told.append(
                f"Leaving out the {left_out} of the arm changes the limit by up to "
                f"{farthest(some)} {_PERCENT}."
            )
    return " ".join(told)


def _peers(rows: list[Row]) -> str:
    told = []
    for task in dict.fromkeys(row["task"] for row in rows):
        some = [row for row in chosen(rows, task=task) if row["installed"]]
        own = [row for row in some if row["tool"] == "symhaptic"]
        others = [row for row in some if row["tool"] != "symhaptic"]
        if not own or not others:
            continue
        one, many = (min(others, key=lambda row: row[which]) for which in ("one", "many"))
        told.append(
            f"{task[:1].upper()}{task[1:]}: the package takes {nanoseconds(own[0]['one'])} for "
            f"one and {nanoseconds(own[0]['many'])} for each of many. The fastest other tool takes "
            f"{number(one['ratio_one'])} times as long for one ({one['tool']}) and "
            f"{number(many['ratio_many'])} times for each of many ({many['tool']})."
        )
    return " ".join(told)
