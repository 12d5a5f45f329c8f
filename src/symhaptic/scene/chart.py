"""How stiff may a wall be, over its damping?  The K-B chart of a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from symhaptic.scene.loop import DeviceLoop
from symhaptic.scene.picture import EDGE, PASSIVE, STABLE, finish, mark
from symhaptic.scene.walls import (
    is_stable,
    limit_at,
    max_stable_stiffness,
    passive_limit_at,
    why_not_passive,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

_BEYOND = 2.25
"""The chart ends at this multiple of the damping of the stiffest wall, or earlier if no wall of
more damping is stable."""


class Chart(NamedTuple):
    """Limits against the damping; NaN where no stiffness is stable or passive."""

    B: NDArray[np.float64]
    """Virtual damping in Ns/m, or N m s/rad of a rotary device."""
    K: NDArray[np.float64]
    """Largest stable stiffness in N/m or N m/rad, of device and arm together."""
    frequency_hz: NDArray[np.float64]
    """The frequency at which the loop oscillates at this limit."""
    passive: NDArray[np.float64]
    """Largest passive stiffness, of the device alone."""


def chart(scene: DeviceLoop, points: int) -> Chart:
    """The chart from B = 0 to beyond the stiffest wall; empty if no wall with B > 0 is stable."""
    most = max_stable_stiffness(scene).B
    if not most > 0:
        return Chart(*np.zeros((4, 0)))
    B = np.linspace(0.0, _BEYOND * most, points)
    K, _, hz = limit_at(scene, B)
    told = scene.damping and not why_not_passive(scene)
    passive = passive_limit_at(scene, B).K if told else np.full(points, np.nan)
    end = 2 + np.flatnonzero(np.isfinite(K)).max(initial=0)
    return Chart(B[:end], K[:end], hz[:end], passive[:end])


def draw_chart(axes: Axes, scene: DeviceLoop, wall: tuple[float, float] | None = None) -> None:
    """Draw the chart, K from left to right and B upwards; ``wall`` (K, B) is marked."""
    found = chart(scene, 200)
    in_K, in_B = scene.printed("N/m"), scene.printed("N*s/m")
    high = {"K": np.nanmax([*found.K, 0.0]), "B": max([*found.B, 0.0])}
    if wall is not None:
        high = {"K": max(high["K"], wall[0]), "B": max(high["B"], wall[1])}
    K, B = np.meshgrid(*(np.linspace(0, 1.05 * high[name], 300) for name in ("K", "B")))
    axes.contourf(K, B, is_stable(scene, K, B), levels=[0.5, 1.5], colors=[STABLE])
    axes.fill([], [], color=STABLE, label="stable walls")
    axes.plot(found.K, found.B, color=EDGE, lw=1.3, label="largest stable stiffness")
    if np.any(found.passive > 0):
        axes.plot(
            found.passive, found.B, "d-", ms=4, color=PASSIVE, clip_on=False, zorder=3,
            label="largest passive stiffness",
        )  # fmt: skip
    if wall is not None:
        mark(axes, scene, wall, bool(is_stable(scene, *wall)))
    axes.set(xlim=(0, 1.05 * high["K"] or 1), ylim=(0, 1.05 * high["B"] or 1))
    finish(axes, in_K, in_B)
