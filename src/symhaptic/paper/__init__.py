"""What is printed?  Equations, tables, plots, claims and constants, exactly as they stand.

Hulin, Albu-Schaeffer and Hirzinger, *Passivity and Stability Boundaries for Haptic Systems with
Time Delay*, IEEE Transactions on Control Systems Technology, 2014.  Misprints are kept; nothing is
computed here and nothing is corrected.  ``propositions`` says what each statement claims.  Imports
``notation``; used by ``book``, and never reached from ``model``.
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
