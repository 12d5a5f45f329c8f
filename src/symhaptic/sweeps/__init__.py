"""How does it depend on everything?  Any quantity over named axes, on one core or on many.

* ``sweep``, ``axes``, ``quantities``: the call, its arguments, and what can be swept in which units
* ``plan``: independent blocks; arrays of Dask
* ``work``: who computes: threads, processes, a client of Dask's
* ``stores``, ``marks``: finished blocks, and whether they are still valid
* ``charts``, ``drawing``: pictures, and their colours

Worker processes end with their parent by `book/processes.py`.  Imports ``numeric``, ``scene`` and
of ``notation`` and ``book`` nothing symbolic; used by users.
"""
