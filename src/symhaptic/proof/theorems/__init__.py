"""What may be called proved?  Propositions, and the kernel that alone makes theorems of them.

:mod:`symhaptic.notation.proposition` is the language, ``definedness`` says where an expression has
a value, ``kernel`` has the theorem and the rules of logic, ``leaves`` asks the deciders;
``analysis``, ``energy`` and ``roots`` hold the theorems of the literature that are applied and not
proved, and ``definitions`` says what the predicates mean. These are all that has to be believed
beside the deciders of :mod:`symhaptic.proof`; ``judge`` makes verdicts of theorems, ``tactics``
puts rules together and need not be believed. Nothing here knows the paper, the model or a page.
"""
