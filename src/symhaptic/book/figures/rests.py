"""The graph of what rests on what: chapters in columns, each right of all that it applies."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import accumulate
from typing import TYPE_CHECKING

from symhaptic.book.figures.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Edges = Mapping[int, frozenset[int]]
"""For each chapter those whose theorems it applies."""

LETTERS = 17
"""Of a line of a chapter's title."""

SWEEPS = 12


def reached(edges: Edges) -> dict[int, frozenset[int]]:
    """All chapters below each."""
    found = {}
    for node in edges:
        seen: set[int] = set()
        ahead = list(edges[node])
        while ahead:
            new = ahead.pop()
            if new not in seen:
                seen.add(new)
                ahead += edges.get(new, ())
        found[node] = frozenset(seen)
    return found


def downwards(edges: Edges) -> Edges:
    """Of chapters that apply theorems of each other, the one that comes first is below."""
    below = reached(edges)
    return {
        node: frozenset(n for n in under if n < node or node not in below.get(n, ()))
        for node, under in edges.items()
    }


def direct(edges: Edges) -> dict[int, frozenset[int]]:
    """Without the edges that a longer way says as well."""
    edges = downwards(edges)
    edges = {**{n: frozenset() for under in edges.values() for n in under}, **edges}
    below = reached(edges)
    return {
        node: frozenset(n for n in under if not any(n in below[m] for m in under))
        for node, under in edges.items()
    }


def columns(edges: Edges) -> list[list[int]]:
    """Chapters by the longest way down, in an order in which neighbours are near each other.

    A chapter that none applies is where behind there the fewest are, so that columns are short.
    """
    depth: dict[int, int] = {}

    def deep(node: int) -> int:
        if node not in depth:
            depth[node] = 1 + max((deep(n) for n in edges[node]), default=-1)
        return depth[node]

    found: list[list[int]] = [[] for _ in range(1 + max(map(deep, edges)))]
    used = {n for under in edges.values() for n in under}
    for node in sorted(edges, key=lambda n: (n not in used, -depth[n], n)):
        behind = found[depth[node] :]
        (behind[0] if node in used else min(behind, key=len)).append(node)
    near = {n: {*edges[n], *(m for m in edges if n in edges[m])} for n in edges}
    for _ in range(SWEEPS):
        at = {n: y for column in found for n, y in _heights(column).items()}
        for column in found:
            column.sort(key=lambda n: (_mean(at[m] for m in near[n]), n))
            at |= _heights(column)
    return found


def _heights(
    column: Sequence[int], size: Callable[[int], int] = lambda node: 1
) -> dict[int, float]:
    """The middles of boxes of these sizes that fill a column, from 0 to 1."""
    ends = list(accumulate(map(size, column)))
    return {n: (end - size(n) / 2) / ends[-1] for n, end in zip(column, ends, strict=True)}


def _mean(values: Iterable[float]) -> float:
    found = list(values)
    return sum(found) / len(found)


def graph(axes: Axes, edges: Edges, titles: Mapping[int, str]) -> None:
    """Titles in columns, joined to what they rest on."""
    edges = direct(edges)
    placed = columns(edges)
    lines = {n: textwrap.wrap(f"{n}  {title}", LETTERS) for n, title in titles.items()}

    def size(node: int) -> int:
        return len(lines[node]) + 1  # a line is between two boxes

    at = {n: (x, -y) for x, column in enumerate(placed) for n, y in _heights(column, size).items()}
    boxes = {
        n: axes.text(
            *at[n],
            "\n".join(lines[n]),
            fontsize=5.5,
            linespacing=1.05,
            ha="center",
            va="center",
            zorder=3,
            bbox={"boxstyle": "round,pad=0.25", "fc": "white", "ec": COLOURS[0], "lw": 0.5},
        )
        for n in at
    }
    for n, under in edges.items():
        for m in under:
            axes.annotate(
                "",
                at[m],
                at[n],
                zorder=1,
                arrowprops={
                    "arrowstyle": "<|-,head_width=0.12,head_length=0.25",
                    "color": COLOURS[2],
                    "linewidth": 0.5,
                    "patchA": boxes[n].get_bbox_patch(),
                    "patchB": boxes[m].get_bbox_patch(),
                    "shrinkA": 0,
                    "shrinkB": 0,
                },
            )
    axes.set_xlim(-0.45, len(placed) - 0.55)
    axes.set_ylim(-1, 0)
    axes.axis("off")
