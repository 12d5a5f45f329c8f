"""How much stiffness does an arm add?

The stiffness limit of one device with 5 Ns/m of virtual damping, alone and with the arms of Table
II. Every arm raises the limit. Without an arm, as when the user lets go, the limit is lower.
"""

import matplotlib.pyplot as plt

from symhaptic import Arm, Scene

scene = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay=1.5e-3)
held = {"no arm": scene} | {name: scene.held_by(Arm.of(name)) for name in Arm.names()}
limits = {name: one.limit_at(B=5.0).K for name, one in held.items()}
plt.barh(list(limits), list(limits.values()), color=["#B3261E"] + ["#33558B"] * 11)
plt.gca().invert_yaxis()
plt.xlabel("largest stable stiffness in N/m")
