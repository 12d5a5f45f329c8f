"""Draws walls.png, the picture of README: which walls one device bears."""

from pathlib import Path

import matplotlib.pyplot as plt

from symhaptic import Scene
from symhaptic.scene.picture import draw

SCENE = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)

if __name__ == "__main__":
    figure, axes = plt.subplots(figsize=(7.2, 4.4), layout="constrained")
    draw(axes, SCENE)
    figure.savefig(Path(__file__).with_name("walls.png"), dpi=150)
