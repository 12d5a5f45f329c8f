"""What can be decided?  Zero tests, series, signs, balls, boxes, certificates and theorems.

A decider answers yes, no or undecided; a certificate can be checked again by another routine;
:mod:`symhaptic.proof.theorems` is the kernel that makes theorems of what the deciders know.
Imports ``notation`` and ``model``; used by ``bounds`` and ``book``.
"""
