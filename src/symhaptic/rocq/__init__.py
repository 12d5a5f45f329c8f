"""Does somebody else's kernel believe it?  The theorems of a chapter, written for Rocq.

A file says each theorem that a chapter hands over and proves it from its leaves: ``terms``,
``complexes`` and ``propositions`` print what is said, ``identities`` and ``leaves`` how a decider's
answer is checked, ``logic`` and ``classical`` what a rule is there, ``steps`` and ``chapter`` make
the file of it; ``compiled`` has it checked, ``outcome`` says what was found, ``together`` asks on
what chapters rest, and ``assumptions`` lays the axioms that Rocq lists to the statements.
``preludes`` is the library: ``Prelude.v`` to ``Control.v``, which all files use, ``Boxes.v``, those
with a box, and ``Zeros.v``, those that count zeros.  It assumes nothing.
Imports ``notation``, ``proof`` and ``book``; used by ``cli``.
"""
