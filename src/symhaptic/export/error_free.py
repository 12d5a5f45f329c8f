"""Sums, products and quotients with what their floats miss: Knuth's, Dekker's, and so on.

The first result is the nearest float, the second one what it misses: of sums and of products of
two floats exactly, of the wide ones, whose arguments are such pairs, nearly.
T. J. Dekker, Numer. Math. 18 (1971) 224-242.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, Steps, TwoProdError

x, x_low, y, y_low = sp.symbols("x x_low y y_low")


def fast_two_sum() -> Routine:
    """Where the first is not the smaller one."""
    do = Steps()
    total = do("total", x + y)
    back = do("back", total - x)
    return do.routine("FastTwoSum", "x + y and what it misses, for |x| >= |y|", (x, y),
                      {"total": total, "total_low": y - back})  # fmt: skip


def two_diff() -> Routine:
    """Whichever is larger."""
    do = Steps()
    total = do("total", x - y)
    back = do("back", total - x)
    rest = do("rest", total - back)
    one, two = do("one", x - rest), do("two", -y - back)
    return do.routine("TwoDiff", "x - y and what it misses", (x, y),
                      {"total": total, "total_low": one + two})  # fmt: skip


def two_prod() -> Routine:
    """Of floats."""
    do = Steps()
    total = do("total", x * y)
    return do.routine("TwoProd", "x y and what it misses", (x, y),
                      {"total": total, "total_low": TwoProdError(x, y)})  # fmt: skip


def wide_prod() -> Routine:
    """Of a float and a pair."""
    do = Steps()
    total = do("total", x * y)
    return do.routine("WideProd", "x (y + y_low) and what it misses", (x, y, y_low),
                      {"total": total, "total_low": TwoProdError(x, y) + x * y_low})  # fmt: skip


def wide_quot() -> Routine:
    """Of two pairs."""
    do = Steps()
    total = do("total", x / y)
    left = do("left", x - total * y)
    left = do("left", left - TwoProdError(total, y))
    rest = do("rest", x_low - total * y_low)
    left = do("left", left + rest)
    return do.routine("WideQuot", "(x + x_low)/(y + y_low) and what it misses",
                      (x, x_low, y, y_low), {"total": total, "total_low": left / y})  # fmt: skip


ROUTINES = (fast_two_sum, two_diff, two_prod, wide_prod, wide_quot)
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
