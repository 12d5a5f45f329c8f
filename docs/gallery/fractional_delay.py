"""Delays between whole periods.

A force that comes one and a half periods late changes within a period; no power of $z$ says so.
The stable walls from one period of delay to two, in quarters.
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
