"""What holds over a range?  The largest walls of all plants of a box, in balls.

How much each part of a loop costs when a model leaves it out, and the smallest model whose error is
proved to be small enough; in ``safe`` the walls that no arm of a range makes unstable.  Imports
``notation``, ``paper`` (its ranges), ``model``, ``proof``, ``balls`` and ``numeric``; used by
``book`` and ``scene``.
"""
