"""How much work one question may cost: counted in steps, so that the answer is repeatable."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache

from sympy import Expr

STEPS = 10_000_000
"""So many are done for a question of a user's own; some seconds to half a minute."""


class Exhausted(RuntimeError):
    """The steps that were allowed are spent."""


class _Purse:
    def __init__(self, steps: int) -> None:
        self.steps = self.left = steps


_PURSE: ContextVar[_Purse | None] = ContextVar("purse", default=None)


@contextmanager
def budget(steps: int) -> Iterator[None]:
    """Within it, :func:`spend` raises :class:`Exhausted` once so many steps are spent.

    >>> with budget(10):
    ...     spend(8)
    ...     spend(8)
    Traceback (most recent call last):
    symhaptic.proof.budget.Exhausted: more than 10 steps
    """
    token = _PURSE.set(_Purse(steps))
    try:
        yield
    finally:
        _PURSE.reset(token)


def spend(steps: int) -> None:
    """Take what is about to be done off the budget in force, if there is one."""
    purse = _PURSE.get()
    if purse is None:
        return
    purse.left -= steps
    if purse.left < 0:
        raise Exhausted(f"more than {purse.steps} steps")


@lru_cache(maxsize=1 << 14)
def size_of(expr: Expr) -> int:
    """How many parts it has, as often as they occur."""
    return 1 + sum(map(size_of, expr.args))
