"""Does another kernel agree?  The theorems of a chapter, written for the proof assistant Rocq.

* ``terms``, ``complexes``, ``propositions``: how a theorem's statement is printed
* ``meaning``, ``reading``: it is read back, and compared with the statement
* ``identities``, ``leaves``: how a decider's answer is checked
* ``logic``, ``classical``, ``loops``, ``zeros``, ``energy``: what each rule is in Rocq
* ``steps``, ``chapter``, ``shared``: the file of a chapter
* ``compiled``, ``outcome``: Rocq runs, and what it says is kept
* ``together``, ``assumptions``: the axioms on which each statement rests
* ``record``: `reports/rocq.json`
* ``preludes``: the library `*.v`, which assumes nothing: `Prelude.v` to `Control.v` for all
  chapters, `Boxes.v` for those with a box, `Zeros.v` for those that count zeros

Imports ``notation``, ``model``, ``proof`` and ``book``; used by ``cli``.
"""
