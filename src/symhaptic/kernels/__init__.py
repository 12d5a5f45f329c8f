# Written by `symhaptic kernels` from the stable forms; do not edit.
"""How does a call compute?  The stable forms as generated code, which imports nothing.

`haptic.c` has the functions in C; `ufuncs.cpp`, written by hand, calls them in a loop over arrays,
and `table.h` lists them for it.  ``haptic`` has the same functions for arrays of any library.
`symhaptic kernels` writes all but `ufuncs.cpp` from the routines of `export/routines`.  Imports
nothing; used by ``numeric``.
"""

STAMP = "3def2c0259ffad48"
"""Of the sources in C, as the module that is compiled of them has it."""
