# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How does a call compute?  The stable forms as generated code, which imports nothing.

* `haptic.c`, `haptic_single.c`, `table.h`: the functions in C, in two precisions, and their list
* ``haptic``, ``scalar``: the same functions for arrays of any library, and some for floats
* `ufuncs.cpp`: their loops over arrays; `filtered_loop` is that of `is_stable`
* `filter.cpp`: judges most walls of that loop, in blocks
* `ordinary.cpp`: computes other functions of ordinary arguments in blocks
* `delay.cpp`: finds most delay margins

`symhaptic kernels` writes the first five from the routines of `export/routines`; the others and
their headers are written by hand.  Imports nothing; used by ``numeric``.
"""

STAMP = "74033439a6099cd0"
"""Of the sources in C, as the module that is compiled of them has it."""

OF_NUMBERS = ("discretize", "is_stable", "unstable_roots", "stability_boundary", "passivity_margin")
"""The functions that `scalar` has, too."""
