"""What do people use?  Limits of the stiffness that are in circulation, and a design record.

* ``statements``, ``claims``: rules for the paper's loop, with who uses them and what they claim
* ``other_loops``: rules for loops with filters and other parts
* ``coupling``: a design record that can be read in full
* ``devices``: devices as they are published

These are sources beside the paper: nothing is computed or corrected here.  The rules of the kernel
are in `proof/theorems`.  Imports ``notation`` and ``paper``; used by ``book``, ``scene`` and
``check``, and never reached from ``model``.
"""

from __future__ import annotations

from symhaptic.rules import coupling
from symhaptic.rules.statements import OTHER_LOOPS, RULES, SOURCE

SOURCES = (SOURCE, coupling.SOURCE)

PLAIN = {s.id: s for s in RULES}
"""Limits of the stiffness for the paper's loop."""

STATEMENTS = PLAIN | {s.id: s for s in OTHER_LOOPS} | coupling.STATEMENTS

__all__ = ["PLAIN", "SOURCES", "STATEMENTS"]
