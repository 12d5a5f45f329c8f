"""Is somebody's own code right?  A function from outside beside exact values of a formula.

Imports ``bench`` for the exact values; used by ``cli``
and, as a plugin, by pytest.
"""
