"""Draws walls.png, the picture of README, from the public functions: what one device bears."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from symhaptic import Scene, is_stable, passivity_boundary, stability_boundary

MASS, DAMPING, PERIOD, DELAY = 0.1, 2.0, 1e-3, 1.5e-3
STIFFNESS, VIRTUAL = MASS / PERIOD**2, MASS / PERIOD  # units of K and B


def draw(path: Path) -> None:
    """Stable and passive walls in N/m and Ns/m, with the stiffest of both."""
    delta, d = DAMPING * PERIOD / MASS, DELAY / PERIOD
    figure, axes = plt.subplots(figsize=(7.2, 3.9), layout="constrained")
    B, K = np.meshgrid(np.linspace(-12, 78, 1200), np.linspace(-600, 10800, 900))
    stable = is_stable(K / STIFFNESS, B / VIRTUAL, 0.0, delta, d)
    axes.contourf(B, K, stable, levels=[0.5, 1.5], colors=["#cfe6da"])
    wall = stability_boundary(np.linspace(1e-4, 1.2, 2000), 0.0, delta, d)
    axes.plot(wall[1] * VIRTUAL, wall[0] * STIFFNESS, color="#1b6e4b", lw=1.4)
    edge = passivity_boundary(np.linspace(1e-3, np.pi / (d + 1), 400), delta, d)
    passive = [np.r_[-delta, edge[1]] * VIRTUAL, np.r_[0, edge[0]] * STIFFNESS]
    axes.fill(*passive, color="#c98a1b", alpha=0.75, lw=0)
    scene = Scene(mass=MASS, damping=DAMPING, sampling_period=PERIOD, delay=DELAY)
    most, safe = scene.max_stable_stiffness(), scene.max_passive_stiffness()
    for limit, text, at in (
        (most, f"stiffest stable wall: {most:.0f} N/m with {most.B:.1f} Ns/m", (10, 4)),
        (safe, f"stiffest passive wall: {safe:.0f} N/m", (9, -2)),
    ):
        axes.plot(limit.B, limit, "o", ms=4, color="black")
        axes.annotate(text, (limit.B, limit), xytext=at, textcoords="offset points", fontsize=9)
    axes.text(38, 3600, "stable", fontsize=11, color="#1b6e4b", ha="center")
    axes.set(xlim=(-12, 78), ylim=(-600, 10800))
    axes.set(xlabel="virtual damping $B$ in Ns/m", ylabel="virtual stiffness $K$ in N/m")
    axes.axhline(0, color="black", lw=0.6)
    axes.axvline(0, color="black", lw=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=150)


if __name__ == "__main__":
    draw(Path(__file__).with_name("walls.png"))
