"""How large is it?  The public functions of numbers and arrays, none of which loads SymPy.

* ``stability``, ``passivity``, ``linear``, ``boundary``, ``plant``: the functions, by subject
* ``tracing``: regions, largest stiffnesses and, in `margin`, delay margins
* ``given``, ``arguments``: arguments are checked and made arrays
* ``containers``: arrays of xarray, Dask, pandas and Pint
* ``compiled``: chooses between the compiled kernels and those for arrays
* ``certified``, ``digits``: verdicts and values in balls, where they are asked for
* ``slopes``: derivatives in JAX
* ``crossings``, ``cubic``, ``extremum``: what root counts and searches need
* ``renamed``, ``column``: old names of arguments; pictures of the width of a column

`Scene` gives these functions units: see ``scene``.  Imports ``kernels``, ``balls`` and of
``notation`` nothing symbolic; used by ``loops``, ``bounds``, ``book``, ``scene``, ``sweeps``,
``bench``, ``check`` and ``cli``.
"""
