# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How large is it, bare?  The stable forms as functions of arrays of any library.

Nothing symbolic; written by `symhaptic kernels`.  Imports nothing; used by ``numeric``.
"""

STAMP = "aade294401eb3671"
"""Of the sources in C, as the module that is compiled of them has it."""

OF_NUMBERS = ("discretize", "is_stable", "unstable_roots", "stability_boundary", "passivity_margin")
"""The functions that `scalar` has, too."""
