# Written by `symhaptic kernels` from the stable forms; do not edit.
"""The stable forms as functions of arrays of any library; nothing symbolic."""
