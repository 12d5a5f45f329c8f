"""Rules of thumb and the exact limit.

Stiffness limits of a wall without virtual damping by four rules of thumb, over the delay. Three of
them ignore the delay. The fourth, damping over delay including half a period for the hold, is
within two percent here.
"""

import matplotlib.pyplot as plt
import numpy as np

from symhaptic import Scene

m, b, T = 0.1, 2.0, 1e-3
delay = np.linspace(0, 4e-3, 81)
scenes = [Scene(mass=m, damping=b, sampling_period=T, delay=t) for t in delay]
for rule, name in ((2 * b / T, "$2b/T$"), (2 * m / T**2, "$2m/T^2$"), (4 * m / T**2, "$4m/T^2$")):
    plt.semilogy(1e3 * delay, np.full(81, rule), "--", label=name)
plt.semilogy(1e3 * delay, [s.limit_at(B=0.0).K for s in scenes], "k", lw=3, label="exact limit")
plt.semilogy(1e3 * delay, b / (delay + T / 2), "y", label=r"$b/(t_d+T/2)$")
plt.xlabel("delay in ms, at 1 kHz")
plt.ylabel("stiffness in N/m")
plt.legend(ncols=2)
