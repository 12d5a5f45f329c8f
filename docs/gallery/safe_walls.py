"""Walls that are stable with every arm.

Proved for every arm of the range (23), and for the device alone. The steps are the columns of the
proof. The dashed rectangle is the largest one inside the region. Within it, stiffness and damping
may be chosen independently.
"""

from symhaptic import Scene

scene = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)
scene.safe_walls().plot()
