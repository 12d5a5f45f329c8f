"""What do I have?  A device in SI units behind a delay, and formulas for it.

:class:`symhaptic.scene.scene.Scene` answers in N/m and Ns/m; ``dimensionless`` takes its units
away, ``walls`` asks ``numeric``, ``systems`` hands it to other tools, ``callables`` gives a formula
as a function.  Imports all rooms above; used by users and ``bench``.
"""
