"""Walls that are safe in every hand.

Proved, not sampled: stable for every arm of the range (23), and for none. The steps are the columns
of the proof, the dashed rectangle is the largest in which both numbers may be chosen freely.
"""

from symhaptic import Scene

scene = Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5)
scene.safe_walls().plot()
