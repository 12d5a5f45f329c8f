"""What do people use?  Limits of the stiffness that are in circulation, and a design record.

Sources beside the paper: each rule with who uses it, and what it claims of a wall; a record that
can be read in full; and devices with what is published of them.  Nothing is computed here and
nothing is corrected.  Imports ``notation`` and ``paper``; used by ``book`` and ``scene``, and never
reached from ``model``.
"""

from __future__ import annotations

from symhaptic.rules import coupling
from symhaptic.rules.statements import OTHER_LOOPS, RULES, SOURCE

SOURCES = (SOURCE, coupling.SOURCE)

PLAIN = {s.id: s for s in RULES}
"""Limits of the stiffness for the paper's loop."""

STATEMENTS = PLAIN | {s.id: s for s in OTHER_LOOPS} | coupling.STATEMENTS

__all__ = ["PLAIN", "SOURCES", "STATEMENTS"]
