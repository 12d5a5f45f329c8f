"""Draws walls.png (README), safe.png (devices.md) and simulation.png (simulation.md)."""

from pathlib import Path

import matplotlib.pyplot as plt

from symhaptic import Encoder, Scene
from symhaptic.scene.picture import draw
from symhaptic.scene.safe import draw_safe

SCENE = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)

PHANTOM = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)

COURSE = {"mass": 0.04, "damping": 0.8, "sampling_period": 1e-3}
STEP, K = 61.4e-6, 400.0


def draw_motions(axes):
    """Walls around their limit, and a wall behind an encoder without and with friction."""
    limit = SCENE.limit_at(B=10.0).K
    for share, color in ((0.9, "#1b6e4b"), (1.0, "0.5"), (1.1, "#b3261e")):
        found = SCENE.simulate(
            share * limit, 10.0, duration="0.15 s", position0="1 mm", samples_between=9
        )
        label = f"{share * limit:.0f} N/m"
        axes[0].plot(1e3 * found.time, 1e3 * found.position, color=color, label=label)
    axes[0].set(ylabel="position in mm", ylim=(-1.7, 2.4), title=f"limit: {limit:.0f} N/m")
    encoder = Encoder(resolution=STEP)
    for friction, color in ((0.0, "#b3261e"), (K * STEP / 2, "#1b6e4b")):
        scene = Scene(**COURSE, encoder=encoder, coulomb_friction=friction)
        found = scene.simulate(
            K, 0.0, duration="0.6 s", position0=9 * STEP, external_force=10.5 * K * STEP,
            samples_between=9,
        )  # fmt: skip
        label = f"friction {1e3 * friction:.3g} mN"
        axes[1].plot(1e3 * found.time, found.position / STEP, color=color, lw=1, label=label)
    axes[1].set(ylabel="position in steps of the encoder", ylim=(8.8, 13), title="with an encoder")
    for each in axes:
        each.set(xlabel="time in ms")
        each.spines[["top", "right"]].set_visible(False)
        each.legend(frameon=False, fontsize=9, loc="upper left")


if __name__ == "__main__":
    for name, picture, shown in (
        ("walls.png", draw, SCENE),
        ("safe.png", draw_safe, PHANTOM.safe_walls()),
    ):
        figure, axes = plt.subplots(figsize=(7.2, 4.4), layout="constrained")
        picture(axes, shown)
        figure.savefig(Path(__file__).with_name(name), dpi=150)
    figure, axes = plt.subplots(ncols=2, figsize=(9, 3.8), layout="constrained")
    draw_motions(axes)
    figure.savefig(Path(__file__).with_name("simulation.png"), dpi=120)
