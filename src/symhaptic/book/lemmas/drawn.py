"""What Fig. 4 draws: the curve (7), the line (8) and the tip (11) of a whole delay."""

from __future__ import annotations

from typing import Any

from symhaptic.book.lemmas.linear_part import on_line
from symhaptic.book.lemmas.passive_boundary import on_boundary
from symhaptic.book.lemmas.stiffest_passive import stiffest_wall
from symhaptic.notation.proposition import conjuncts
from symhaptic.proof.theorems.kernel import (
    Theorem,
    assume,
    conjoined,
    discharged,
    weakened,
)


def drawn(claim: Any) -> Theorem:
    """Each of the three implications of a claim, of which the print comes last."""
    parts = []
    for implication, made in zip(claim.of, (on_boundary, on_line, stiffest_wall), strict=True):
        known = conjuncts(implication.of[0])
        found = weakened(made(*map(assume, known[-2:])), *known)
        parts.append(discharged(found, *known))
    return conjoined(*parts)
