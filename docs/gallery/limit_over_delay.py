"""The stiffness limit over the delay.

For a device of 100 g with three dampings, at the virtual damping with the largest limit. The delay
matters far more than the damping of the device.
"""

import matplotlib.pyplot as plt
import numpy as np

from symhaptic import max_stable_stiffness

m, T = 0.1, 1e-3
delay = np.linspace(0, 6, 241)
for b in (0.5, 2.0, 8.0):
    stiffest = max_stable_stiffness(gamma=0, delta=b * T / m, delay=delay)
    plt.semilogy(delay, stiffest.alpha * m / T**2, label=f"$b={b:g}$ Ns/m")
plt.xlabel("delay in sampling periods of 1 ms")
plt.ylabel("largest stable stiffness in N/m")
plt.legend()
