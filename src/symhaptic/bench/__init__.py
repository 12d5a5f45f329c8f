"""How fast, and how wrong?  Every function measured beside exact values and its peers.

Behind the command `symhaptic bench`; what it finds is committed and shown by ``book``.  Imports all
rooms above, and the public functions by their names; used by ``check`` and ``cli``.
"""
