"""How do chapters become verdicts, a book and a site?

A chapter is a file in `derivations/`.  `symhaptic verify eq9` prints the verdict of a statement and
the file of its chapter.  Tests in `tests/oracles` that are marked with the name of that file
compute its results by another method.

* ``page``, ``steps``, ``record``: what a chapter calls (`settle`, `lemma`, `step`) and what is kept
* ``following``, ``evidence``: what follows from a page's definitions; the numbers of a theorem
* ``lemmas``, ``certificates``: theorems that several chapters use, and the certificates that
  `make certificates` finds for them
* ``chapters``, ``parallel``: chapters are found and run
* ``processes``: worker processes, which end with the process that started them
* ``sources``, ``formulas``, ``ledger``: statements with their verdicts, and the JSON record of one
* ``listing``, ``committed``: `verify` prints the ledger and compares it with the committed one
* ``rests``, ``rules``: on which theorems and on which rules a statement rests
* ``foreign``: the record of what Rocq has checked
* ``mutation``: each statement with one change, which must be refused
* ``report``, ``figures``, ``parts``, ``plain``: the book, the site and their pictures, whose
  colours are in `book/figures/style.py`; `book/report/pages.py` lists what each statement rests on
* ``consequences``: the order of the errata, and what each means for a device
* ``measured``: the measurements of ``bench`` as a chapter

The verdict itself is computed in ``proof``.  Imports most rooms above; used by the chapters,
``rocq``, ``scene``, ``sweeps``, ``bench`` and ``cli``.
"""

SELDOM = 200_000
"""Objects made after which a process looks for cycles of them; SymPy makes few."""
