"""How fast are the functions, and how wrong?  Measured beside exact values and other tools.

* ``measuring``, ``timing``: what `symhaptic bench` measures, how often, and by which clock
* ``functions``, ``points``: error against time of each function, and the points where
* ``error``, ``exported``, ``terms``: the error of exported C: `benchmarks/accuracy.py`
* ``peers``, ``models``, ``printed``, ``tracing``, ``verdicts``: what is compared with

Nothing here passes or fails.  The errors are kept in `export/accuracy.json` and the times in
`reports/bench.json`, which a chapter of ``book`` shows; `tests/export/test_accuracy.py` fails if an
error grows.  Imports most rooms above; used by ``check`` and ``cli``.
"""
