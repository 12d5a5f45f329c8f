"""The response to a push.

A device leans with 1 N on three walls, a tenth below the limit, on it, and a tenth above. At the
limit the oscillation stays; its frequency is told beside the limit.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.signal import dstep

from symhaptic import Scene

scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)
device, limit = scene.to_scipy().to_tf(), scene.limit_at(B=10.0)
for K in (0.9 * limit.K, limit.K, 1.1 * limit.K):
    wall = [K + 10.0 / device.dt, -10.0 / device.dt]  # times z: K + B (z - 1)/(T z)
    loop = np.polyadd(np.polymul(device.den, [1, 0]), np.polymul(device.num, wall))
    t, (x,) = dstep((np.polymul(device.num, [1, 0]), loop, device.dt), n=150)
    plt.plot(1e3 * t, 1e3 * x, label=f"{K:.0f} N/m")
plt.xlabel("time in ms")
plt.ylabel("position in mm")
plt.ylim(-0.5, 0.6)
plt.legend(
    loc="lower left",
    ncols=3,
    title=f"at {limit.frequency_hz:.0f} Hz the limit is {limit.K:.0f} N/m",
)
