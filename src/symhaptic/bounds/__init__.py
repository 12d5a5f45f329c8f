"""What holds for all plants of a range?  Proved bounds in ball arithmetic.

* ``safe``: the walls that no arm of a range makes unstable
* ``simplest``: the smallest model whose error is proved to be small
* ``walls``, ``linear_points``, ``balls``: what these and the chapters compute in balls

Imports ``notation``, ``model``, ``proof``, ``balls`` and ``numeric``; used by ``book``,
``scene`` and ``cli``.
"""
