"""Pictures of arguments: what turns, what crosses and what stays on its side.

All walls have one period of delay on the device of `LOOP`, which is damped so much more than an
arm that both sides of each picture can be seen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.book.figures.passivity import boundary
from symhaptic.book.figures.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

GAMMA, DELTA, DELAY = 0.05, 0.4, 1
"""The loop of all pictures."""

PLANT, WALL, GREY = COLOURS[0], COLOURS[5], "#8A8A8A"
SHADES = ("#9CC9B4", "#5FA286", "#1B6E4B", "#D9776F", "#B3261E")
"""Of walls on their way out: three are stable."""

HALF = np.linspace(0, np.pi, 2001)
CIRCLE = np.exp(1j * np.linspace(0, 2 * np.pi, 401))


def _device() -> tuple[float, ...]:
    from symhaptic.numeric.plant import discretize  # only where a picture is drawn

    return tuple(float(x) for x in discretize(GAMMA, DELTA))


def _parts(z: Any, alpha: float, beta: float) -> tuple[Any, Any]:
    """The two parts of the characteristic polynomial: of the plant, and of the wall."""
    n1, n0, a, e = _device()
    return z ** (DELAY + 1) * (z**2 - a * z + e), (n1 * z + n0) * ((alpha + beta) * z - beta)


def _roots(alpha: float, beta: float) -> Any:
    n1, n0, a, e = _device()
    plant = np.polymul([1, -a, e], [1] + [0] * (DELAY + 1))
    return np.roots(np.polyadd(plant, np.polymul([n1, n0], [alpha + beta, -beta])))


def _plane(axes: Axes, radius: float = 1.25) -> None:
    """The unit circle in the plane of z."""
    axes.plot(CIRCLE.real, CIRCLE.imag, color=GREY, linewidth=0.6)
    axes.axhline(0, color=GREY, linewidth=0.4, zorder=0)
    axes.set_aspect("equal")
    axes.set_xlim(-radius, radius)
    axes.set_ylim(-radius, radius)
    axes.set_xlabel(r"$\mathrm{Re}\,z$")
    axes.set_ylabel(r"$\mathrm{Im}\,z$")


def half_circle(axes: Any) -> None:
    """Where the wall dominates on the half circle, and how far the polynomial turns on it."""
    left, right = axes
    alpha, beta = 0.55, 0.5
    z = np.exp(1j * HALF)
    plant, wall = _parts(z, alpha, beta)
    leads = np.abs(wall) > np.abs(plant)
    _plane(left)
    for part, colour, label in ((~leads, PLANT, "plant larger"), (leads, WALL, "wall larger")):
        drawn = np.where(part, z, np.nan)
        left.plot(drawn.real, drawn.imag, color=colour, linewidth=2.2, label=label)
    roots = _roots(alpha, beta)
    left.plot(roots.real, roots.imag, "x", color="black", markersize=5, label="roots")
    left.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), handlelength=1.6)
    turns = [np.unwrap(np.angle(part)) / np.pi for part in (plant, wall, plant + wall)]
    curves = (
        (PLANT, (0, (4, 2)), "of the plant's part $f$"),
        (WALL, (0, (1, 1.5)), "of the wall's part $g$"),
        ("black", "solid", "of their sum $p_1$"),
    )
    for turned, (colour, style, label) in zip(turns, curves, strict=True):
        right.plot(HALF / np.pi, turned, color=colour, linestyle=style, label=label)
    for edge in np.flatnonzero(np.diff(leads)):
        right.axvline(HALF[edge] / np.pi, color=GREY, linewidth=0.5)
    right.set_xlim(0, 1)
    right.set_xlabel(r"angle $\theta/\pi$")
    right.set_ylabel(r"argument$/\pi$")
    right.set_ylim(0, 4.1)
    right.legend(loc="lower center", bbox_to_anchor=(0.45, 1.0), handlelength=1.6)


def crossing(axes: Any) -> None:
    """A wall that gets stiffer leaves the stable region where its roots leave the circle."""
    from symhaptic.numeric.boundary import stability_boundary

    left, right = axes
    outline = stability_boundary(np.linspace(0.004, 1.3, 600), GAMMA, DELTA, DELAY)
    alpha, beta = (np.asarray(side) for side in outline)
    kept = (alpha > -GAMMA) & (beta > -DELTA)
    left.plot(alpha[kept], beta[kept], color=COLOURS[0])
    walls = [(x, 0.4) for x in (0.06, 0.18, 0.3, 0.42, 0.54)]
    _plane(right)
    for (x, y), colour in zip(walls, SHADES, strict=True):
        left.plot([x], [y], "o", color=colour, markersize=4)
        roots = _roots(x, y)
        right.plot(roots.real, roots.imag, "o", color=colour, markersize=3.5)
    left.plot(*zip(*walls, strict=True), color=GREY, linewidth=0.5, zorder=0)
    left.set_xlabel(r"virtual stiffness $\alpha$")
    left.set_ylabel(r"virtual damping $\beta$")


def sides(axes: Axes) -> None:
    """Wall and device, each on its side of a vertical line: they meet at no angle."""
    from symhaptic.numeric.passivity import passivity_boundary

    n1, n0, a, e = _device()
    z = np.exp(1j * HALF[10:])
    device = -(z**2 - a * z + e) / ((z - 1) * (n1 * z + n0))
    axes.plot(device.real, device.imag, color=PLANT, label=r"device, $-1/((z-1)P)$")
    stiffness, damping = (float(x) for x in passivity_boundary(np.pi / 5, DELTA, DELAY))
    for share in (0.25, 0.5, 0.75, 1.0):
        wall = share * z**-DELAY * ((stiffness + damping) * z - damping) / (z * (z - 1))
        label = r"walls $yW/(z-1)$, $0<y\leq1$" if share == 1 else None
        axes.plot(wall.real, wall.imag, color=WALL, linewidth=0.4 + 0.8 * share, label=label)
    axes.axvline(-DELTA, color="black", linewidth=0.7, linestyle="dashed")
    axes.text(-DELTA, 1.03, r"$-\delta$", ha="center", transform=axes.get_xaxis_transform())
    axes.axhline(0, color=GREY, linewidth=0.4, zorder=0)
    axes.set_xlim(-1.1, 0.5)
    axes.set_ylim(-4, 1)
    axes.set_xlabel("real part")
    axes.set_ylabel("imaginary part")
    axes.legend(loc="upper left")


def lines_of_angles(axes: Axes) -> None:
    """One line for each angle, on which a wall is just passive there, and what they leave."""
    stiffness = np.array([-0.2, 1.1])
    for angle in np.linspace(0.1, 0.99, 21) * np.pi / (DELAY + 1):
        if abs(np.cos((DELAY + 1) * angle)) > 0.03:
            kernel = np.sin((DELAY + 0.5) * angle) / (2 * np.sin(angle / 2))
            damping = (stiffness * kernel - 1) / np.cos((DELAY + 1) * angle)
            axes.plot(stiffness, damping, color=GREY, linewidth=0.4)
    x, y = boundary(DELAY)
    axes.fill(x, y, color=COLOURS[0], alpha=0.15, linewidth=0)
    axes.plot(np.append(x, x[0]), np.append(y, y[0]), color=COLOURS[0], linewidth=1.6)
    axes.set_xlim(0, 1)
    axes.set_ylim(-1.1, 1.1)
    axes.set_xlabel("virtual stiffness $KT/b$")
    axes.set_ylabel("virtual damping $B/b$")
