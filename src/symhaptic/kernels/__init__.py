# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How does a call compute?  The stable forms as generated code, which imports nothing.

`haptic.c` has the functions in C; `ufuncs.cpp`, written by hand, calls them in a loop over arrays,
and `table.h` lists them for it.  `filter.cpp` judges most walls before, and `delay.cpp` finds
most delay margins.  ``haptic`` has the same functions for arrays of any library, ``scalar`` some
for floats.  `symhaptic kernels` writes all but these three and `filter.h` from the routines of
`export/routines`.  Imports nothing; used by ``numeric``.
"""

STAMP = "62020b49d4579f04"
"""Of the sources in C, as the module that is compiled of them has it."""

OF_NUMBERS = ("discretize", "is_stable", "unstable_roots", "stability_boundary", "passivity_margin")
"""The functions that `scalar` has, too."""
