# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How large is it, bare?  The stable forms as functions of arrays of any library.

Nothing symbolic; written by `symhaptic kernels`.  Imports nothing; used by ``numeric``.
"""

STAMP = "3def2c0259ffad48"
"""Of the sources in C, as the module that is compiled of them has it."""
