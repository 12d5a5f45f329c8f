"""The linear condition on a wall, (25) of the paper."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from symhaptic.kernels import arguments
from symhaptic.kernels.arguments import Array


def linear_limit(beta: ArrayLike, delta: ArrayLike, delay: ArrayLike) -> Array:
    """alpha = (beta + delta)/(delay + 1/2), the stiffness at which (25) is an equality.

    Damping over delay, half a period of hold included; arrays broadcast.  For whole delays it is
    the straight part of the passivity boundary, -delta <= beta <= delta d/(2d + 3); for a
    fractional one it allows walls there that are not passive (chapter s6e_fractional_region).
    Elsewhere it approximates the stability boundary and can lie on its unstable side.

    Raises :class:`ValueError` for an infinite ``beta`` and for a negative or infinite ``delta``
    or ``delay``; NaN gives NaN.

    >>> float(linear_limit(0.0, 0.02, 1.5))
    0.01
    """
    b = arguments.finite("beta", beta)
    dl, dy = arguments.nonnegative("delta", delta), arguments.nonnegative("delay", delay)
    return np.asarray((b + dl) / (dy + 0.5))
