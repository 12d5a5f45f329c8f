"""Passive walls over the delay.

Fig. 4 of the paper in a few lines: the passive walls in units of the damping of the device, for one
to four periods of delay.
"""

import matplotlib.pyplot as plt
import numpy as np

from symhaptic import max_passive_stiffness, passivity_boundary

for delay in range(1, 5):
    angle = np.linspace(1e-3, np.pi / (delay + 1), 300)
    K, B = passivity_boundary(angle, 1.0, delay)
    plt.fill([0, *K, 0], [-1, *B, 1], alpha=0.3, label=f"$d={delay}$")
    stiffest = max_passive_stiffness(1.0, delay)
    plt.plot(stiffest.alpha, stiffest.beta, "ko", markersize=3)
plt.xlabel("virtual stiffness $KT/b$")
plt.ylabel("virtual damping $B/b$")
plt.legend(title="delay in periods")
