"""Walls that are stable with every arm.

Proved for every arm of the range (23), and for the device alone. The steps are the columns of the
proof. In the dashed rectangle, the largest one, stiffness and damping may be chosen freely.
"""

from symhaptic import Scene

scene = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)
scene.safe_walls().plot()
