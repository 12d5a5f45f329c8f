"""Stability of walls close to the boundary: eigenvalues, Jury's table and root counts."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symhaptic.balls import winding
from symhaptic.bench.exported import compiled
from symhaptic.bench.points import Array
from symhaptic.bench.printed import function
from symhaptic.bench.timing import seconds
from symhaptic.export import request
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.plant import discretize
from symhaptic.numeric.stability import is_stable, unstable_roots

DISTANCES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-14)
"""Relative distances from the boundary, towards alpha = beta = 0 and away from it."""

_SIZES = {"eigenvalues": 2, "(14) as printed": 2, "Jury table": 200, "certified": 2000}
"""Number of walls that slow methods are timed with."""

_ALIKE = ("eigenvalues", "(14) as printed", "Jury table")
"""Methods whose time does not depend on the distance."""

Walls = tuple[Array, Array, Array, Array]
"""alpha, beta, gamma and delta."""

Plant = Callable[[Array, Array], Sequence[Array]]
"""n1, n0, a and e from gamma and delta."""


def near(delay: int, distance: float, count: int, seed: int = 5) -> tuple[Walls, NDArray[np.bool_]]:
    """Walls on both sides of the boundary of as many plants, and whether they are stable.

    Two of four plants are ordinary ones inside (23), one has no stiffness, one critical damping.
    Points whose two sides are both unstable are no border of the stable region, and are left out.
    """
    rng = np.random.default_rng(seed)
    rows: list[tuple[float, ...]] = []
    truth: list[bool] = []
    while len(rows) < 2 * count:
        gamma, delta = rng.uniform(0, 1e-3), rng.uniform(0, 0.02)
        kind = len(rows) // 2 % 4
        gamma = 0.0 if kind == 2 else delta * delta / 4 if kind == 3 else gamma
        theta = rng.uniform(0.02, 1) * np.pi / (2 * delay + 2)
        alpha, beta = (float(v) for v in stability_boundary(theta, gamma, delta, delay))
        sides = [(alpha * (1 + s), beta * (1 + s), gamma, delta) for s in (-distance, distance)]
        found = [winding.stable(*side, delay) for side in sides]
        if found == [True, False]:
            rows += sides
            truth += [True, False]
    columns = np.array(rows).T
    return (columns[0], columns[1], columns[2], columns[3]), np.array(truth)


def coefficients(walls: Walls, delay: int, plant: Plant = discretize) -> Array:
    """Characteristic polynomials, a row each, the highest power first."""
    al, be, gamma, delta = walls
    n1, n0, a, e = plant(gamma, delta)
    rows = np.zeros((al.size, delay + 4))
    rows[:, 0], rows[:, 1], rows[:, 2] = 1.0, -a, e
    rows[:, -3] += n1 * (al + be)
    rows[:, -2] += n0 * (al + be) - n1 * be
    rows[:, -1] += -n0 * be
    return rows


def by_roots(rows: Array) -> Array:
    """``numpy.roots`` of one polynomial after the other; NaN if a coefficient is not finite."""
    known = np.isfinite(rows.sum(axis=1))
    return np.array(
        [np.abs(np.roots(r)).max() < 1 if k else np.nan for r, k in zip(rows, known, strict=True)]
    )


def by_jury(rows: Array) -> NDArray[np.bool_]:
    """Jury's table, reduced row by row, of all polynomials side by side."""
    inside = np.ones(len(rows), dtype=bool)
    while rows.shape[1] > 1:
        share = rows[:, -1:] / rows[:, :1]
        inside &= np.abs(share[:, 0]) < 1
        rows = rows[:, :-1] - share * rows[:, :0:-1]
    return inside


def known(stable: Any, outside: Any) -> Any:
    """Verdicts as numbers, NaN where the count of the roots is not certain."""
    return np.where(np.asarray(outside) < 0, np.nan, np.asarray(stable, dtype=float))


Way = Callable[[Walls, int], Any]


def _certified(walls: Walls, delay: int) -> Any:
    alpha, beta, gamma, delta = walls
    return is_stable(alpha, beta, gamma, delta, delay, certified=True)


def methods(folder: Path) -> dict[str, tuple[Way, Way]]:
    """The verdicts of each method (NaN: refused), and the function that is timed."""
    (plant,) = request.chosen(["discretize"])
    paper = function(plant, "printed", "numpy")

    def printed(gamma: Array, delta: Array) -> Sequence[Array]:
        return [np.real(v) for v in paper(gamma + 0j, delta + 0j)]

    found: dict[str, Way] = {
        "eigenvalues": lambda walls, d: by_roots(coefficients(walls, d)),
        "(14) as printed": lambda walls, d: by_roots(coefficients(walls, d, printed)),
        "Jury table": lambda walls, d: by_jury(coefficients(walls, d)),
    }
    ways = {name: (way, way) for name, way in found.items()}
    ways["counted"] = (
        lambda walls, d: known(is_stable(*walls, d), unstable_roots(*walls, d)),
        lambda walls, d: is_stable(*walls, d),
    )
    ways["certified"] = _certified, _certified
    if shutil.which("gcc"):
        calls = [compiled(form, folder) for form in request.chosen(["is_stable", "unstable_roots"])]

        def told(walls: Walls, delay: int) -> list[Any]:
            return [*map(np.ascontiguousarray, walls), np.full(walls[0].size, float(delay))]

        ways["counted, C"] = (
            lambda walls, d: known(*(call(told(walls, d))[0] for call in calls)),
            lambda walls, d: calls[0](told(walls, d))[0],
        )
    return ways


def measured(
    delays: tuple[int, ...], count: int, most: float, timed: int = 20_000
) -> Iterator[dict[str, Any]]:
    """One row for each delay and method, with the share of wrong verdicts for each distance.

    Beyond the delay ``most`` the number of plants falls with its square, down to one.
    """
    with tempfile.TemporaryDirectory() as place:
        ways = methods(Path(place))
        for delay in delays:
            plants = count if delay <= most else max(1, round(count * (most / delay) ** 2))
            tried = {eps: near(delay, eps, plants) for eps in DISTANCES}
            for name, (verdicts, timed_way) in ways.items():
                wrong, unsure, near_by = {}, {}, {}
                size = _SIZES.get(name, timed)
                for eps, (walls, truth) in tried.items():
                    with np.errstate(all="ignore"):
                        said = np.asarray(verdicts(walls, delay), dtype=float)
                    key = f"{eps:g}"
                    unsure[key] = float(np.mean(np.isnan(said)))
                    wrong[key] = float(np.mean((said != truth) & ~np.isnan(said)))
                    if name in _ALIKE and near_by:
                        near_by[key] = next(iter(near_by.values()))
                        continue
                    al, be, gamma, delta = (np.resize(a, size) for a in walls)
                    timed_here = partial(timed_way, (al, be, gamma, delta), delay)
                    near_by[key] = seconds(timed_here, 1 if size < timed else 3) / size
                row = {"delay": delay, "method": name, "walls": int(truth.size)}
                took = {"seconds": near_by[f"{DISTANCES[0]:g}"], "near": near_by}
                refused = float(np.mean([*unsure.values()]))
                yield {**row, **took, "wrong": wrong, "open": unsure, "refused": refused}
