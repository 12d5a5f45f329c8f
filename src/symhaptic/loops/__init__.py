"""Parts of a loop beyond the paper's, and one engine for all loops that they make.

A part says its physics once, in formulas that take floats, arrays or SymPy's symbols: chapters
derive from the same lines that the engine computes with.  Time is in sampling periods, the mass
of the device is 1, and polynomials are in w = z - 1, the lowest power first: next to z = 1,
where slow loops have their roots, powers of w keep the digits that powers of z lose.

``plant``       how the device moves, and its samples
``velocity``    what the wall takes for the velocity
``actuator``, ``structure``, ``sensor``    further parts, one each
``loop``        p = z^M A + K X + B Y + E of a scene
``circle``, ``count``, ``trace``, ``passive``    the engine
"""
