"""The claims of the statements, by id."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from symhaptic.notation.proposition import Proposition
from symhaptic.paper.reading import Printed

Claim: TypeAlias = Callable[[Printed], Proposition]

CLAIMED: dict[str, Claim] = {}
"""The claim of each statement, by its id."""


def claims(*ids: str) -> Callable[[Claim], Claim]:
    """Register the claim of these statements; each statement has one claim."""

    def register(claim: Claim) -> Claim:
        for id in ids:
            if id in CLAIMED:
                raise ValueError(f"{id} is claimed twice")
            CLAIMED[id] = claim
        return claim

    return register
