"""Is somebody's own code right?  A function from outside beside exact values of a formula.

Imports ``bench`` for the exact values, ``numeric`` to know where to look, and ``paper``, ``rules``
and ``proof`` for the mistakes it may be; used by ``cli`` and, as a plugin, by pytest.
"""
