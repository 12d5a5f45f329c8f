"""Pictures of the stable and the passive walls of a loop, in N/m and Ns/m or N m/rad."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from symhaptic.notation.extras import needed
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.column import STYLE, column_figure, legend_below
from symhaptic.numeric.passivity import passivity_boundary
from symhaptic.numeric.stability import is_stable
from symhaptic.scene import walls
from symhaptic.scene.dimensionless import units
from symhaptic.scene.loop import DeviceLoop, together
from symhaptic.scene.walls import (
    limit_at,
    max_passive_stiffness,
    max_stable_stiffness,
    why_not_passive,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from symhaptic.scene.limit import Stiffness

STABLE, EDGE, PASSIVE, UNSTABLE = "#cfe6da", "#1b6e4b", "#c98a1b", "#b3261e"


def draw(axes: Axes, scene: DeviceLoop, wall: tuple[float, float] | None = None) -> None:
    """Draw stable walls of device and arm, passive walls of the device, and both maxima of K.

    K from left to right and B upwards, as in the paper; ``wall`` (K, B) is marked, too.
    """
    held, alone = together(scene), scene.device
    most = max_stable_stiffness(held)
    high = {"K": 1.1 * max(most.K, wall[0] if wall else 0.0), "B": 2.25 * most.B}
    high["B"] = max(high["B"], 1.3 * wall[1] if wall else 0.0)
    low = {"K": -0.06 * high["K"], "B": -0.16 * high["B"]}
    if scene.further:
        for ring in walls.stable_region(held).outline:
            axes.fill(ring[:, 0], ring[:, 1], color=STABLE, lw=0)
            axes.plot(ring[:, 0], ring[:, 1], color=EDGE, lw=1.3)
    else:
        _traced(axes, held, low, high)
    axes.fill([], [], color=STABLE, label="stable walls")
    in_K, in_B = scene.printed("N/m"), scene.printed("N*s/m")
    marks = [(most, _said("stable", most, scene))]
    if alone.damping and not why_not_passive(alone):
        marks.append(_passive(axes, alone))
    for (limit, text), shape in zip(marks, "od", strict=False):
        axes.plot(limit.K, limit.B, shape, ms=5, color="black", zorder=3, label=text)
    if wall is not None:
        good = bool(walls.is_stable(held, *wall))
        top = limit_at(held, wall[1]).K
        if good and wall[0] < top:
            axes.plot(
                [wall[0], top], [wall[1], wall[1]],
                ":", color=EDGE, label=f"to its limit: {digits(top - wall[0])} {in_K} more",
            )  # fmt: skip
        mark(axes, scene, wall, good)
    axes.axhline(0, color="black", lw=0.6)
    axes.axvline(0, color="black", lw=0.6)
    axes.set(xlim=(low["K"], high["K"]), ylim=(low["B"], high["B"]))
    finish(axes, in_K, in_B)


def mark(axes: Axes, scene: DeviceLoop, wall: tuple[float, float], good: bool) -> None:
    """A cross at a wall, with its numbers in the legend."""
    in_K, in_B = scene.printed("N/m"), scene.printed("N*s/m")
    text = f"this wall: {wall[0]:.4g} {in_K}, {wall[1]:.4g} {in_B}"
    axes.plot(*wall, "x", ms=9, mew=2, color=EDGE if good else UNSTABLE, label=text)


def explicit_boundary(loop: DeviceLoop) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """K and B of the walls on the explicit boundary, up to its first return or two."""
    n = loop.dimensionless
    per_K, per_B = units(loop.mass_or_inertia, loop.sampling_period)
    theta = np.linspace(1e-4, min(np.pi, 2.2 * np.pi / (n.delay + 1)), 4000)
    alpha, beta = stability_boundary(theta, n.gamma, n.delta, n.delay)[:2]
    return alpha * per_K, beta * per_B


def finish(axes: Axes, in_K: str, in_B: str) -> None:
    """Labels with units, and the legend."""
    axes.set(xlabel=f"virtual stiffness $K$ in {in_K}", ylabel=f"virtual damping $B$ in {in_B}")
    axes.spines[["top", "right"]].set_visible(False)
    legend_below(axes)


def _traced(axes: Axes, held: DeviceLoop, low: dict[str, float], high: dict[str, float]) -> None:
    """The stable walls by their verdicts, and the explicit boundary."""
    n = held.dimensionless
    per_K, per_B = units(held.mass_or_inertia, held.sampling_period)
    K, B = np.meshgrid(np.linspace(low["K"], high["K"], 900), np.linspace(low["B"], high["B"], 700))
    stable = is_stable(K / per_K, B / per_B, n.gamma, n.delta, n.delay)
    axes.contourf(K, B, stable, levels=[0.5, 1.5], colors=[STABLE])
    K, B = explicit_boundary(held)
    inside = (1.5 * high["K"] > K) & (3 * low["K"] < K) & (1.5 * high["B"] > B) & (3 * low["B"] < B)
    axes.plot(np.where(inside, K, np.nan), np.where(inside, B, np.nan), color=EDGE, lw=1.3)


def new_axes(caller: str) -> Axes:
    """Axes of a new figure that fits a column of a journal and is saved with Type 42 fonts."""
    needed(caller, "matplotlib", extra="report")
    from matplotlib import pyplot

    with pyplot.rc_context(STYLE):
        axes: Axes = pyplot.figure(FigureClass=column_figure()).subplots()
    return axes


def _passive(axes: Axes, alone: DeviceLoop) -> tuple[Stiffness, str]:
    """The passive walls, and the stiffest of them with what is said of it."""
    safe = max_passive_stiffness(alone)
    if alone.further:
        for ring in walls.passive_region(alone).outline:
            axes.fill(
                ring[:, 0], ring[:, 1], color=PASSIVE, alpha=0.75, lw=0, label="passive walls"
            )
        return safe, _said("passive", safe, alone)
    _, own, delay = alone.dimensionless
    per_K, per_B = units(alone.mass_or_inertia, alone.sampling_period)
    angles = np.linspace(1e-3, np.pi / (delay + 1), 400)
    alpha, beta = passivity_boundary(angles, own, delay)[:2]
    known = np.isfinite(alpha) & (alpha >= 0)
    axes.fill(
        np.r_[0, alpha[known]] * per_K, np.r_[-own, beta[known]] * per_B,
        color=PASSIVE, alpha=0.75, lw=0, label="passive walls",
    )  # fmt: skip
    return safe, _said("passive", safe, alone)


def _said(kind: str, wall: Stiffness, scene: DeviceLoop) -> str:
    """A limit in words."""
    in_K, in_B = scene.printed("N/m"), scene.printed("N*s/m")
    return f"max. {kind} stiffness: {digits(wall.K)} {in_K}, {wall.B:.3g} {in_B}"


def digits(K: float) -> str:
    """A stiffness without a power of ten if it is large."""
    return f"{K:.0f}" if K >= 1000 else f"{K:.3g}"
