"""The numerics of the exports, each routine written once for all languages and precisions."""

from symhaptic.export.notation import ROUTINES
from symhaptic.export.routines import arithmetic, device, response, roots, slopes, walls

__all__ = ["ROUTINES", "arithmetic", "device", "response", "roots", "slopes", "walls"]
