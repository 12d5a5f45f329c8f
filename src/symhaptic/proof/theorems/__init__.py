"""What may be called proved?  Propositions, and the kernel that alone makes theorems of them.

``proposition`` is the language, ``definedness`` says where an expression has a value, ``kernel`` has
the theorem and the rules of logic, ``leaves`` asks the deciders, ``classical`` holds the theorems of
the literature that are applied and not proved.  These five are all that has to be believed beside
the deciders of :mod:`symhaptic.proof`; chapters only call them.  Nothing here knows the paper, the
model or a page.
"""
