"""Stable and passive walls of a device.

In N/m and Ns/m: walls that are stable with the device alone, passive walls, which are stable with
every passive arm, and the distance of one wall from its limit.
"""

from symhaptic import Scene

scene = Scene(mass=0.1, damping=2.0, sampling_period=1e-3, delay=1.5e-3)
scene.plot(K=4000.0, B=20.0)
