"""What else is in real loops?  Parts beyond the paper's, and one engine for all loops of them.

A part says its physics once, in formulas for floats, arrays and SymPy's symbols: chapters derive
from the lines that the engine computes with.  Time is in sampling periods and the mass is 1.
Polynomials are in w = z - 1, the lowest power first: slow loops have their roots near z = 1, where
powers of w keep the digits that powers of z lose.  Imports ``notation`` and ``numeric``; used by
``scene`` and by chapters.

``plant``       how the device moves, and its samples
``velocity``    what the wall takes for the velocity
``actuator``, ``structure``, ``sensor``    further parts, one each
``loop``        p = z^M A + K X + B Y + E of a scene
``circle``, ``count``, ``trace``, ``passive``, ``engine``    the questions, without units
"""
