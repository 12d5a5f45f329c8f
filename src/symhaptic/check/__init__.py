"""Is somebody's own code right?  A function from outside beside exact values of a formula.

* ``callers``, ``worker``: the function runs in a process of its own, with limits
* ``formulas``, ``checked``: what can be checked, and its exact values
* ``devices``: the same for a scene with its parts, beside the package's engine
* ``points``, ``compare``: where the function is called, and its worst error
* ``mistakes``: which common error it may be
* ``report``, ``plugin``: the result as text and files, and the fixture for pytest

Imports ``bench`` for the exact values, ``numeric`` and ``scene``, and ``paper``, ``rules`` and
``proof`` for the common errors; used by ``cli`` and, as a plugin, by pytest.
"""
