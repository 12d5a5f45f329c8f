"""Energy that motions leave to the damper and the wall, over a finite number of periods.

A hand moves the device as it likes.  Between two changes of the held force only the displacement
counts: the force works on it, and the damper burns at least b times its square over the time, at
constant speed.  The wall reads the position once per period and answers ``late`` periods later,
where a fraction means that its force changes inside a period.  All motions start at rest at 0.
"""

import numpy as np


def form(law, b, T, late=0.0, periods=150):
    """Matrix of the energy left, in displacements scaled so that the damper's share is 1.

    ``law`` are the wall's coefficients: the force is law[0] x_k + law[1] x_(k-1) + ...
    """
    assert b > 0, "without a damper every motion that the wall feels delivers energy"
    whole = int(np.floor(late))
    part = late - whole
    times = np.array([part * T, (1 - part) * T] if part else [T])
    pieces = len(times) * periods
    index = np.arange(pieces)
    place = (index < len(times) * np.arange(periods)[:, None]).astype(float)  # x_k of the pieces
    force = np.zeros_like(place)
    for age, coefficient in enumerate(law):
        force[age:] += coefficient * place[: periods - age]
    sample = index // len(times) - whole
    if part:
        sample[::2] -= 1  # the first piece of a period still feels the force before
    felt = np.where((sample >= 0)[:, None], force[np.maximum(sample, 0)], 0.0)
    size = np.sqrt(np.tile(times, periods) / b)
    worked = size[:, None] * felt * size
    return np.eye(pieces) + (worked + worked.T) / 2


def wall(K, B, T):
    """K x_k + B (x_k - x_(k-1))/T."""
    return [K + B / T, -B / T]


def left_of(law, b, T, periods=150):
    """The least share of the damper's losses that is left, over all motions: < 0 is a gain."""
    return np.linalg.eigvalsh(form(law, b, T, periods=periods))[0]


def left(K, B, b=1.0, T=1.0, late=0.0, periods=150):
    """The same for a wall."""
    return np.linalg.eigvalsh(form(wall(K, B, T), b, T, late, periods))[0]


def worst(K, B, b=1.0, T=1.0, late=0.0, periods=150):
    """Angle per period at which the spectrum of the worst motion is largest; integer delays."""
    motion = np.linalg.eigh(form(wall(K, B, T), b, T, late, periods))[1][:, 0]
    spectrum = np.abs(np.fft.rfft(motion, 64 * periods))
    return 2 * np.pi * spectrum.argmax() / (64 * periods)


# -- endless motions ------------------------------------------------------------------------

ANGLES = np.linspace(0, np.pi, 2001)[1:]


def need(K, B, late, angles=ANGLES):
    """Damping that one angle asks for, T = 1: -Re of the wall's transfer function over z - 1.

    For a fraction of a period this is the paper's reading, z^-d on the principal sheet.
    """
    z = np.exp(1j * angles)
    law = (K + B * (1 - 1 / z)) * np.exp(-1j * late * angles)
    return -(law / (z - 1)).real


def determinant(K, B, late, theta):
    """Of the energy of both parts of a period at one angle, b = T = 1, the damper's share 1."""
    whole, part = int(late), late % 1
    z = np.exp(1j * theta)
    law = (K + B * (1 - 1 / z)) * z**-whole / (z - 1)
    felt = np.array([np.sqrt(part) / z, np.sqrt(1 - part)])
    form = law * np.outer(felt, [np.sqrt(part), np.sqrt(1 - part)])
    return np.linalg.det(np.eye(2) + (form + form.conj().T) / 2).real


def bounds(K, B, b, T, late, short=0.99, wide=1.03):
    """The wall lies on the border: a little less cannot deliver energy, a little more does."""
    assert left(short * K, short * B, b, T, late) > -1e-12  # rounding of an eigenvalue
    # 150 periods and d <= 3 miss at most 16 pi^2/150^2 = 0.007 of 0.03
    assert left(wide * K, wide * B, b, T, late) < 0
