"""Tables I and II as printed."""

from __future__ import annotations

from symhaptic.notation import TABLE_I
from symhaptic.paper.statement import Statement

TABLES = (
    Statement(
        "tab1",
        "Table I",
        "the normalisation rules",
        tuple(row.dimensionless for row in TABLE_I if row.dimensionless is not None),
    ),
    Statement("tab2", "Table II", "mass, stiffness and damping of human arms in the literature"),
)
