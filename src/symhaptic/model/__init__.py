"""What does physics say?  Plant, hold, wall, loop and energy balance from first principles.

The device between two samples, the wall's force, the energy of a motion, the characteristic
polynomial, the explicit boundary, Jury's inequalities, delays that are no whole number of periods.
Imports ``notation`` and never looks at ``paper``; used by ``proof``, ``forms``, ``bounds`` and
``book``.
"""
