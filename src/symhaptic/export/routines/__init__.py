"""The numerics of the exports, each routine written once for all languages and precisions.

* ``device``: n1, n0 and the other numbers of the sampled device, with their series near zero
* ``slopes``: the derivatives of these
* ``response``: the device with a delay of a fraction of a period
* ``roots``: the roots outside the unit circle, for `is_stable`
* ``margin``: the delay that may be added
* ``walls``: what is searched for, such as the largest stiffness
* ``arithmetic``: pairs of floats, and the elementary functions made of them
* ``prelude``: what the routines are written with
"""

from symhaptic.export.notation import ROUTINES
from symhaptic.export.routines import arithmetic, device, margin, response, roots, slopes, walls

__all__ = ["ROUTINES", "arithmetic", "device", "margin", "response", "roots", "slopes", "walls"]
