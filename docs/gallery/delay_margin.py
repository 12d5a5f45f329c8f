"""Delay margins of walls.

The delay that may be added to a loop without delay, in sampling periods, for the walls of a device
without a spring. Outside the coloured region no wall is stable without delay.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import BoundaryNorm

from symhaptic import delay_margin, is_stable

alpha, beta = np.meshgrid(np.linspace(0.004, 0.5, 75), np.linspace(0, 1.6, 75))
margin = np.where(is_stable(alpha, beta, 0, 0.02, 0), delay_margin(alpha, beta, 0, 0.02), 0)
levels = [0.01, 0.5, 1, 2, 4, 8, 16, 32]
steps = BoundaryNorm(levels, 256, extend="max")
plt.contourf(alpha, beta, margin, levels, norm=steps, cmap="YlGnBu", extend="max")
plt.colorbar(label="delay margin in sampling periods", format="%g")
plt.xlabel(r"virtual stiffness $KT^2/m$")
plt.ylabel(r"virtual damping $BT/m$")
