"""Fractional delays.

With a delay of one and a half periods the force changes within a period. No power of $z$ describes
this change. Stable walls for one to two periods of delay, in quarters.
"""

import matplotlib.pyplot as plt

from symhaptic import stable_region

axes = plt.gca()
for delay in (1, 1.25, 1.5, 1.75, 2):
    region = stable_region(gamma=0.001, delta=0.02, delay=delay)
    region.plot(axes, color=plt.cm.viridis(0.9 * (delay - 1.0)), label=f"$t_d={delay:g}\\,T$")
axes.set_xlabel(r"virtual stiffness $KT^2/m$")
axes.set_ylabel(r"virtual damping $BT/m$")
axes.set_xlim(right=0.21)
axes.legend()
