"""Draws walls.png (README), model.png (model.md), safe.png (devices.md), simulation.png."""

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
    """Draw motions near the stiffness limit, and with an encoder without and with friction."""
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


BOXES = (
    (2.8, 2.0, 2.2, "device and arm\n$m\\ddot x+b\\dot x+kx=F_h-F$"),
    (5.9, 2.0, 1.2, "sampling\nevery $T$"),
    (5.9, 0.6, 1.2, "wall\n$K+B\\frac{z-1}{Tz}$"),
    (4.1, 0.6, 1.0, "delay\n$t_d=dT$"),
    (2.4, 0.6, 1.0, "hold\nfor $T$"),
)
"""Centre, width and words of each block of the loop."""

ARROWS = (
    ((0.0, 2.0), (0.88, 2.0)), ((1.12, 2.0), (1.7, 2.0)), ((3.9, 2.0), (5.3, 2.0)),
    ((5.9, 1.65), (5.9, 0.95)), ((5.3, 0.6), (4.6, 0.6)), ((3.6, 0.6), (2.9, 0.6)),
    ((1.0, 0.6), (1.0, 1.88)),
)  # fmt: skip

SIGNALS = (
    (0.1, 2.12, "$F_h$"), (0.7, 2.12, "$+$"), (0.75, 1.66, "$-$"), (1.1, 1.2, "$F$"),
    (4.4, 2.12, "$x(t)$"), (6.0, 1.27, "$x_n$"), (4.85, 0.72, "$F_n$"),
)  # fmt: skip


def draw_model(axes):
    """The block diagram of the loop."""
    for x, y, width, text in BOXES:
        axes.add_patch(plt.Rectangle((x - width / 2, y - 0.35), width, 0.7, fill=False))
        axes.text(x, y, text, ha="center", va="center")
    for start, end in ARROWS:
        style = {"arrowstyle": "-|>", "fc": "k", "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", end, start, arrowprops=style)
    axes.plot([1.9, 1.0], [0.6, 0.6], "k", lw=1)
    axes.plot(1.0, 2.0, "o", ms=13, mfc="w", mec="k")
    for x, y, text in SIGNALS:
        axes.text(x, y, text)
    axes.set(xlim=(-0.05, 6.6), ylim=(0.15, 2.5))
    axes.axis("off")


if __name__ == "__main__":
    for name, picture, shown in (
        ("walls.png", draw, SCENE),
        ("safe.png", draw_safe, PHANTOM.safe_walls()),
    ):
        figure, axes = plt.subplots(figsize=(7.2, 4.4), layout="constrained")
        picture(axes, shown)
        figure.savefig(Path(__file__).with_name(name), dpi=150)
    figure, axes = plt.subplots(figsize=(7.2, 2.7), layout="constrained")
    draw_model(axes)
    figure.savefig(Path(__file__).with_name("model.png"), dpi=150)
    figure, axes = plt.subplots(ncols=2, figsize=(9, 3.8), layout="constrained")
    draw_motions(axes)
    figure.savefig(Path(__file__).with_name("simulation.png"), dpi=120)
