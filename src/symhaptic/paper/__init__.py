"""What does the paper say?  Its statements exactly as published, misprints included.

Hulin, Albu-Schaeffer and Hirzinger, *Passivity and Stability Boundaries for Haptic Systems with
Time Delay*, IEEE Transactions on Control Systems Technology, 2014.  Nothing is computed here and
nothing is corrected; what is right instead is part of the verdict, in a chapter (see ``book``).

* ``equations``, ``tables``, ``figures``: what has a number
* ``claims``, ``claims_compared``, ``slips``: sentences, with their numbers such as 17.8; wrong
  words
* ``statement``, ``quoted``, ``ranges``: what these are made of
* ``reading``: reads a published formula
* ``propositions``: what each statement claims

Imports ``notation``; used by ``rules``, ``proof``, ``book``, ``scene``, ``bench``, ``check`` and
``cli``, and never reached from ``model``.
"""

from __future__ import annotations

from symhaptic.paper.claims import CLAIMS
from symhaptic.paper.claims_compared import CLAIMS_COMPARED
from symhaptic.paper.equations import EQUATIONS
from symhaptic.paper.figures import FIGURES
from symhaptic.paper.slips import SLIPS
from symhaptic.paper.statement import Statement
from symhaptic.paper.tables import TABLES

STATEMENTS: dict[str, Statement] = {
    s.id: s for s in (*EQUATIONS, *TABLES, *FIGURES, *CLAIMS, *CLAIMS_COMPARED, *SLIPS)
}

__all__ = ["STATEMENTS", "Statement"]
