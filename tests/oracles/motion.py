"""The sampled loop in SI units, simulated: nothing is transformed and nothing made dimensionless.

A mass with damper and spring moves under a held force, by the exponential of its state matrix.  The
wall reads the position once per period; its force arrives ``late`` periods later.
"""

import numpy as np
from scipy.linalg import expm


def held(m, b, k, time):
    """Motion of (x, v) over ``time``, and the effect of a unit force that is held."""
    state = np.array([[0, 1, 0], [-k / m, -b / m, 1 / m], [0, 0, 0]])
    moved = expm(state * time)
    return moved[:2, :2], moved[:2, 2]


def positions(K, B, m=1.0, b=0.0, k=0.0, T=1.0, late=0.0, steps=200, speed=1.0):
    """x at the samples; at the first the device is at 0 and leaves with ``speed``."""
    whole = int(np.floor(late))
    part = late - whole
    before, old = held(m, b, k, part * T)
    after, new = held(m, b, k, (1 - part) * T)
    state, place = np.array([0.0, speed]), [0.0]
    forces = [0.0] * (whole + 2)
    for _ in range(steps):
        last = place[-2] if len(place) > 1 else 0.0
        forces.append(-(K * place[-1] + B * (place[-1] - last) / T))
        state = before @ state + old * forces[-2 - whole]
        state = after @ state + new * forces[-1 - whole]
        place.append(state[0])
    return np.array(place)


def grows(place):
    """Whether the second half of a motion goes farther than the first quarter."""
    quarter = len(place) // 4
    return np.abs(place[2 * quarter :]).max() > np.abs(place[:quarter]).max()
