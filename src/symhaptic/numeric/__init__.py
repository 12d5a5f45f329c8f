"""How large is it?  The public functions of arrays, and the boundaries traced from them.

Arguments are checked and given to the generated kernels; ``tracing`` finds regions, extremes and
delay margins.  Imports ``kernels`` and of ``notation`` nothing symbolic, so that no call ever loads
SymPy; used by ``bounds``, ``book``, ``scene`` and ``bench``.
"""
