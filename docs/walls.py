"""Draws walls.png, the picture of README, and safe.png, that of devices.md."""

from pathlib import Path

import matplotlib.pyplot as plt

from symhaptic import Scene
from symhaptic.scene.picture import draw
from symhaptic.scene.safe import draw_safe

SCENE = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)

PHANTOM = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)

if __name__ == "__main__":
    for name, picture, shown in (
        ("walls.png", draw, SCENE),
        ("safe.png", draw_safe, PHANTOM.safe_walls()),
    ):
        figure, axes = plt.subplots(figsize=(7.2, 4.4), layout="constrained")
        picture(axes, shown)
        figure.savefig(Path(__file__).with_name(name), dpi=150)
