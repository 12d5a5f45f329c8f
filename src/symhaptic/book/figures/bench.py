"""The plots of a measurement: error against time, as vector graphics."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.book.figures.labels import Panel, place
from symhaptic.book.figures.style import COLOURS
from symhaptic.book.measured.tables import words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

GREY = "#8A8A8A"
_COLOURS = {
    "printed": COLOURS[5],
    "derived": COLOURS[6],
    "stable": COLOURS[0],
    "C": COLOURS[2],
    "package": COLOURS[1],
    "balls": COLOURS[3],
    "grid": COLOURS[5],
    "rays": COLOURS[6],
    "rays, counted": COLOURS[1],
    "explicit": COLOURS[0],
    "eigenvalues": COLOURS[5],
    "(14) as printed": COLOURS[4],
    "Jury table": COLOURS[6],
    "counted": COLOURS[0],
    "counted, C": COLOURS[2],
    "certified": COLOURS[3],
    "linear": COLOURS[5],
    "mass alone": COLOURS[6],
    "no damping": COLOURS[4],
    "no stiffness": COLOURS[2],
    "full": COLOURS[0],
}
_MARKS = {"float32": "v", "float64": "o", "bits": "s", "digits": "D"}
_NOTHING = 3.0
"""Where an error stands that is larger than the largest term."""

_LEAST = 1e-56
_DIGITS = {"float32": 2.0**-23, "float64": 2.0**-52, "30 digits": 1e-29, "50 digits": 1e-49}


def drawings(record: dict[str, Any]) -> dict[str, tuple[Any, tuple[int, int], float]]:
    """Each figure's function, its panels and its height in widths of the text, by name."""
    known = {row["function"] for row in record["functions"]}
    some = [n for n in _CHOSEN if n in known] or sorted(known)[:2]
    return {
        "bench_functions": (partial(_functions, record, some), (len(some), 2), 0.53 * len(some)),
        "bench_boundary": (partial(_boundary, record), (1, 2), 0.48),
        "bench_stability": (partial(_stability, record), (1, 2), 0.5),
        "bench_models": (partial(_models, record), (1, 1), 0.5),
    }


_CHOSEN = ("discretize", "stability_boundary", "passivity_boundary")


def _functions(record: dict[str, Any], names: list[str], panels: Any) -> None:
    placed: list[Panel] = []
    for line, name in zip(np.atleast_2d(panels), names, strict=True):
        rows = [r for r in record["functions"] if r["function"] == name and _shown(r)]
        times = [r["seconds"] for r in rows]
        for axes, which in zip(line, ("ordinary", "hard"), strict=True):
            axes.set(xscale="log", yscale="log", ylim=(_LEAST, 1e10))
            axes.set_xlim(min(times) / 8, max(times) * 40)
            axes.set_yticks([1, 1e-10, 1e-20, 1e-30, 1e-40, 1e-50])
            axes.set_title(f"{words(name)}, {which}", loc="left", fontsize=9)
            axes.set_xlabel("time per evaluation in s")
            axes.set_ylabel("error over largest term")
            for last in _DIGITS.values():
                axes.axhline(last, color=GREY, linewidth=0.3, zorder=0)
            placed.append(_ways(axes, [r for r in rows if r["set"] == which]))
    place(*placed)


def _shown(row: dict[str, Any]) -> bool:
    """All but the derived forms in other than double precision: they crowd the print."""
    return row["worst"] is not None and (row["way"] != "derived" or row["precision"] == "float64")


def _ways(axes: Axes, rows: list[dict[str, Any]]) -> Panel:
    names, bars = [], []
    for row in rows:
        worst, middle = (
            float(np.clip(row[k] * row["last"], 3 * _LEAST, _NOTHING)) for k in ("worst", "median")
        )
        colour, at = _COLOURS[row["way"]], row["seconds"]
        axes.plot([at, at], [middle, worst], color=colour, linewidth=0.6, zorder=2)
        mark = _MARKS[row["precision"].split()[-1]]
        axes.plot(at, worst, mark, color=colour, markersize=3.2, zorder=3)
        missing = f" ({100 * row['missing']:.0f} % NaN)" if row["missing"] else ""
        names.append((at, worst, row["way"] + missing, colour))
        bars.append(([at, at], [middle, worst]))
    return axes, names, bars


def _boundary(record: dict[str, Any], panels: Any) -> None:
    rows = record["boundary"]
    delays = [min(r["delay"] for r in rows), max(r["delay"] for r in rows)]
    times = [r["seconds"] for r in rows]
    placed: list[Panel] = []
    for axes, delay in zip(panels, delays, strict=True):
        axes.set(xscale="log", yscale="log", ylim=(1e-19, 1e-1))
        axes.set_xlim(min(times) / 3, max(times) * 10)
        axes.set_title(f"$d={delay}$", loc="left", fontsize=9)
        axes.set_xlabel("time per point in s")
        axes.set_ylabel("largest distance from the curve")
        names, lines = [], []
        for method in dict.fromkeys(r["method"] for r in rows):
            some = [r for r in rows if (r["delay"], r["method"]) == (delay, method)]
            x, y = [r["seconds"] for r in some], [max(r["worst"], 1e-18) for r in some]
            colour = _COLOURS[method]
            axes.plot(x, y, "o-", color=colour, markersize=2.6, linewidth=0.8)
            names.append((x[-1], y[-1], method, colour))
            lines.append((x, y))
        placed.append((axes, names, lines))
    place(*placed)


def _stability(record: dict[str, Any], panels: Any) -> None:
    rows = record["stability"]
    methods = list(dict.fromkeys(r["method"] for r in rows))
    delays = sorted({r["delay"] for r in rows})
    left, right = panels
    left.set(xscale="log", yscale="log", xlim=(0.8, 60 * (max(delays) + 1)))
    left.set_xlabel("delay $d+1$ in sampling periods")
    left.set_ylabel("time per wall in s")
    left.set_ylim(min(r["seconds"] for r in rows) / 3, max(r["seconds"] for r in rows) * 3)
    names, lines = [], []
    for method in methods:
        some = [r for r in rows if r["method"] == method]
        x, y = [r["delay"] + 1 for r in some], [r["seconds"] for r in some]
        left.plot(x, y, "o-", color=_COLOURS[method], markersize=2.6, linewidth=0.8)
        names.append((x[-1], y[-1], method, _COLOURS[method]))
        lines.append((x, y))
    left_panel: Panel = (left, names, lines)
    right.set(xscale="log", xlim=(3e-3, 3e-16), ylim=(-4, 64))
    right.set_xlabel("relative distance from the boundary")
    right.set_ylabel("share of wrong verdicts in %")
    names, lines = [], []
    last: list[float] = []
    for method in methods:
        some = [r for r in rows if r["method"] == method]
        walls = sum(r["walls"] for r in some)
        x = [float(e) for e in some[0]["wrong"]]
        y = [100 * sum(r["wrong"][e] * r["walls"] for r in some) / walls for e in some[0]["wrong"]]
        right.plot(x, y, "o-", color=_COLOURS[method], markersize=2.6, linewidth=0.8)
        lines.append((x, y))
        if method == "counted, C" and y == last:
            names[-1] = (*names[-1][:2], "counted, also in C", names[-1][3])
            continue
        last = y
        top = len(x) - 1 if max(y) else len(x) // 2
        names.append((x[top], y[top], method, _COLOURS[method]))
    place(left_panel, (right, names, lines))


def _models(record: dict[str, Any], axes: Axes) -> None:
    rows = record["models"]
    last = max(r["damping"] for r in rows if r["damping"] <= 0.25)
    axes.set(xscale="log", yscale="log")
    ends = {min(r["delay"] for r in rows), max(r["delay"] for r in rows)}
    some = [r for r in rows if r["damping"] == last and r["delay"] in ends]
    some = [r for r in some if r["model"] != "full"]
    times = [r["seconds"] for r in some]
    axes.set_xlim(min(times) / 3, max(times) * 30)
    axes.set_ylim(1e-4, 1)
    axes.set_xlabel("time per limit in s")
    axes.set_ylabel("median relative error of the stiffness")
    names = []
    for row in some:
        colour = _COLOURS[row["model"]]
        axes.plot(row["seconds"], row["median"], "o", color=colour, markersize=3.2)
        names.append((row["seconds"], row["median"], f"{row['model']}, $d={row['delay']}$", colour))
    place((axes, names, ()))
