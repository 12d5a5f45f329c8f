"""A sweep over two parameters.

The largest stable stiffness over the mass of the device and the delay, at 6000 points with units
and names.
"""

import matplotlib.pyplot as plt
import numpy as np

from symhaptic import Scene, sweep

scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3)
mass, delay = np.geomspace(0.02, 2, 75), np.linspace(0, 4e-3, 80)
found = sweep("max_stable_stiffness", scene, mass=mass, delay=delay)
levels = [500, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5, 2e5, 5e5, 1e6]
plt.contourf(1e3 * delay, mass, found.K, levels, norm="log", cmap="YlGnBu", extend="both")
plt.colorbar(label="largest stable stiffness in N/m", format="%g")
plt.yscale("log")
plt.xlabel("delay in ms, at 1 kHz")
plt.ylabel("mass of the device in kg")
