"""How does it depend on everything?  Any quantity over named axes, on one core or on many.

``quantities`` says what is swept, and in which units; a ``plan`` cuts it into blocks that know
nothing of each other; ``work`` hands these out, ``stores`` keep what is finished, ``charts`` are
drawn with ``drawing``.  Imports ``numeric``, ``scene`` and of ``notation`` and ``book`` nothing
symbolic; used by users.
"""
