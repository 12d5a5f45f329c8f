"""What else is in real loops?  Parts beyond the paper's, and one engine for all loops of them.

To add a part, write its physics in a file here, let ``engine`` or ``loop`` use it, and give it a
field in `scene/loop.py` and a table in `scene/device_file.py`.  A part with proved formulas and
exports, like those of the paper, begins in `model/parts.py` instead.

A part says its physics once, in formulas for floats, arrays and SymPy's symbols: chapters derive
from the lines that the engine computes with.  Time is in sampling periods and the mass is 1.
Polynomials are in w = z - 1, the lowest power first: slow loops have their roots near z = 1, where
powers of w keep the digits that powers of z lose.

* ``plant``, ``system``: how the device moves, and its samples
* ``number``: polynomials of floats, arrays or symbols
* ``velocity``, ``oversampled``: what the wall takes for the velocity
* ``actuator``, ``structure``, ``sensor``: further parts, one each
* ``loop``: p = z^M A + K X + B Y + E of a scene
* ``engine``: the questions that may be asked, without units
* ``circle``, ``count``, ``trace``, ``passive``: how they are answered
* ``simulate``, ``motion``, ``controller``: the motion over time

Imports ``notation`` and ``numeric``; used by ``bounds``, ``scene`` and chapters.
"""
