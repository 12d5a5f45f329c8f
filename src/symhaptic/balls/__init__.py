"""How large is it to any number of digits?  Values and root counts in ball arithmetic.

* ``closed``: the sampled device and what is explicit, from matrix exponentials
* ``implicit``: largest and smallest values, each enclosed on all of its range
* ``winding``: roots outside the unit circle, and the limits where one crosses it
* ``exact``: these by the names of the functions
* ``zeros``: zeros of functions

Nothing here comes from the package's own formulas: it is what they are measured by.  Imports
nothing; used by ``numeric``, ``scene``, ``bounds``, ``bench`` and ``check``.
"""
