"""A question with one thing changed, and what may excuse that it is answered with yes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol


class Check(Protocol):
    """A question that a checker answers."""

    def holds(self) -> bool:
        """Whether the checker says yes."""
        ...


def inexcusable() -> str | None:
    """Nothing excuses it."""
    return None


def because(reason: str) -> Callable[[], str | None]:
    """A reason that is known beforehand."""
    return lambda: reason


@dataclass(frozen=True)
class Change:
    """A question with one thing changed."""

    kind: str
    what: str
    check: Check
    excuse: Callable[[], str | None] = inexcusable
