"""A question with one thing changed, and what may excuse its being confirmed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from symhaptic.proof.checks import Check

WIDER = (1, 4, 32, 1024)
"""So many times is an interval or a value enlarged in search of one where the claim is wrong."""


def inexcusable() -> str | None:
    """Nothing speaks for a confirmation."""
    return None


def because(reason: str) -> Callable[[], str | None]:
    """A reason that is known beforehand."""
    return lambda: reason


@dataclass(frozen=True)
class Change:
    """A question with one thing changed; without a ``check`` the excuse says why none is wrong."""

    kind: str
    what: str
    check: Check | None
    excuse: Callable[[], str | None] = inexcusable
