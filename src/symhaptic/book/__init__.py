"""How is it told?  Pages, chapters, the ledger, errata, mutants, LaTeX and figures.

A page keeps each step with its proof and each statement with its verdict; ``lemmas`` are what
several chapters apply, ``mutation`` changes what is settled and asks again, ``report`` and
``figures`` print it.  Imports all rooms above; used by the derivations, ``scene``, ``bench`` and
``cli``.
"""

SELDOM = 200_000
"""Objects made after which a process looks for cycles of them; SymPy makes few."""
