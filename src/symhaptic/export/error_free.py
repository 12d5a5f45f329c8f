"""Arithmetic of pairs, of a float and what it misses: Knuth's, Dekker's, and so on.

The first result is the nearest float, the second one what it misses: of sums and of products of
two floats exactly, of pairs nearly.
T. J. Dekker, Numer. Math. 18 (1971) 224-242.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.export import pairs
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, TwoProdError
from symhaptic.export.steps import Steps

x, x_low, y, y_low = sp.symbols("x x_low y y_low")
ONE, TWO = (x, x_low), (y, y_low)


def _given(
    do: Steps, name: str, about: str, arguments: tuple[Symbol, ...], total: Expr, low: Expr
) -> Routine:
    return do.routine(name, about, arguments, {"total": total, "total_low": low})


def rounded() -> Routine:
    """Once."""
    return Steps().routine("Rounded", "the float of a pair", ONE, x + x_low)


def fast_two_sum() -> Routine:
    """Where the first is not the smaller one."""
    do = Steps()
    total = do("total", x + y)
    back = do("back", total - x)
    return _given(do, "FastTwoSum", "x + y and what it misses, for |x| >= |y|", (x, y),
                  total, y - back)  # fmt: skip


def two_diff() -> Routine:
    """Whichever is larger."""
    do = Steps()
    total = do("total", x - y)
    back = do("back", total - x)
    rest = do("rest", total - back)
    one, two = do("one", x - rest), do("two", -y - back)
    return _given(do, "TwoDiff", "x - y and what it misses", (x, y), total, one + two)


def two_prod() -> Routine:
    """Of floats."""
    do = Steps()
    total = do("total", x * y)
    return _given(do, "TwoProd", "x y and what it misses", (x, y), total, TwoProdError(x, y))


def wide_prod() -> Routine:
    """Of a float and a pair."""
    do = Steps()
    total = do("total", x * y)
    return _given(do, "WideProd", "x y of a float and a pair", (x, *TWO),
                  total, TwoProdError(x, y) + x * y_low)  # fmt: skip


def pair_sum() -> Routine:
    """Of pairs, whichever is larger."""
    do = Steps()
    total, lost = pairs.two_diff(do, x, -y)
    lost = do("lost", lost + x_low)
    return _given(do, "PairSum", "x + y of pairs", (*ONE, *TWO), total, lost + y_low)


def pair_diff() -> Routine:
    """Of pairs, whichever is larger."""
    do = Steps()
    total, lost = pairs.two_diff(do, x, y)
    lost = do("lost", lost + x_low)
    return _given(do, "PairDiff", "x - y of pairs", (*ONE, *TWO), total, lost - y_low)


def one_plus() -> Routine:
    """Of a pair that is not larger than 1."""
    do = Steps()
    total, lost = pairs.fast_two_sum(do, sp.S.One, x)
    return _given(do, "OnePlus", "1 + x of a pair, for |x| <= 1", ONE, total, lost + x_low)


def one_minus() -> Routine:
    """Of a pair that is not larger than 1."""
    do = Steps()
    total, lost = pairs.fast_two_sum(do, sp.S.One, -x)
    return _given(do, "OneMinus", "1 - x of a pair, for |x| <= 1", ONE, total, lost - x_low)


def pair_prod() -> Routine:
    """Of pairs."""
    do = Steps()
    total, lost = pairs.scaled(do, x, TWO)
    return _given(do, "PairProd", "x y of pairs", (*ONE, *TWO), total, lost + x_low * y)


def pair_square() -> Routine:
    """Of a pair."""
    do = Steps()
    total, lost = pairs.scaled(do, x, (x, 2 * x_low))
    return _given(do, "PairSquare", "x^2 of a pair", ONE, total, lost)


def pair_quot() -> Routine:
    """Of pairs."""
    do = Steps()
    total = do("total", x / y)
    left = do("left", x - total * y)
    left = do("left", left - TwoProdError(total, y))
    rest = do("rest", x_low - total * y_low)
    left = do("left", left + rest)
    return _given(do, "PairQuot", "x/y of pairs", (*ONE, *TWO), total, left / y)


ROUTINES = (
    rounded, fast_two_sum, two_diff, two_prod, wide_prod, pair_sum, pair_diff, one_plus, one_minus,
    pair_prod, pair_square, pair_quot,
)  # fmt: skip
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
