"""Stable and passive walls of a device.

In N/m and Ns/m: what is stable as long as nothing but the device moves, the few walls that no hand
and no surface can make unstable, and how far one wall is from its limit.
"""

from symhaptic import Scene

scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)
scene.plot(K=4000.0, B=20.0)
