"""The response to a constant force.

A force of 1 N pushes a device against three walls: 10 % below the stiffness limit, at the limit and
10 % above. At the limit the oscillation neither grows nor decays.
"""

import matplotlib.pyplot as plt

from symhaptic import Scene

scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)
limit = scene.limit_at(B=10.0)
for K in (0.9 * limit.K, limit.K, 1.1 * limit.K):
    motion = scene.simulate(K, 10.0, duration="150 ms", external_force="1 N")
    plt.plot(1e3 * motion.time, 1e3 * motion.position, label=f"{K:.0f} N/m")
plt.xlabel("time in ms")
plt.ylabel("position in mm")
plt.ylim(-0.5, 0.6)
plt.legend(
    loc="lower left",
    ncols=3,
    title=f"at {limit.frequency_hz:.0f} Hz the limit is {limit.K:.0f} N/m",
)
