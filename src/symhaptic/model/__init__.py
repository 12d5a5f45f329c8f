"""What does physics say?  Plant, hold, wall, loop and energy balance from first principles.

* ``parts``: which parts the paper's loop has, and so which symbols exist
* ``plant``, ``wall``, ``loop``: the device between two samples, the force, the polynomial
* ``fractional``, ``lag``: delays that are no whole number of periods; delay as a lag
* ``passivity``: the energy of a motion
* ``boundary``, ``linear``: the explicit stability boundary, and its linear part
* ``jury``, ``polynomials``, ``circle``: Jury's inequalities, exact polynomials

Nothing here looks at ``paper``.  Filters, motors that lag and other parts that only computations
need are in ``loops``.  Imports ``notation``; used by ``proof``, ``forms``, ``export``, ``bounds``,
``book``, ``rocq``, ``scene`` and ``cli``.
"""
