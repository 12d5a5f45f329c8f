"""What may be called proved?  Propositions, and the kernel that alone makes theorems of them.

:mod:`symhaptic.notation.proposition` is the language, ``definedness`` says where an expression has
a value, ``kernel`` has the theorem and the rules of logic, ``leaves`` asks the deciders.
``axioms`` are closed propositions with their sources: school mathematics, and what the predicates
mean.  ``analysis``, ``energy``, ``roots`` and ``samples`` hold the theorems of the literature that
are applied and not proved, ``definitions`` what a loop and its energy are.  These are all that has
to be believed beside the deciders of :mod:`symhaptic.proof`.

``familiar`` puts axioms to use, ``tactics`` puts rules together, ``positivity`` finds proofs of
relations, ``derivation`` tells what a theorem rests on and ``judge`` makes verdicts of theorems:
none of them can make a theorem that the others do not allow.  Nothing here knows the paper or a
page.
"""
