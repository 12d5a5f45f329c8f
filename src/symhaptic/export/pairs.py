"""Arithmetic of pairs: a float and what it misses, as calls of the routines in error_free.py."""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.export.steps import Steps

Pair = tuple[Expr, Expr]


def exact(number: Expr) -> Pair:
    """A float that misses nothing."""
    return number, sp.S.Zero


def rounded(number: Pair) -> Expr:
    """The float."""
    return sp.Function("Rounded")(*number)


def fast_two_sum(do: Steps, large: Expr, small: Expr) -> Pair:
    """Sum and its rounding error, where the first is not the smaller one."""
    return _pair(do, "total", "FastTwoSum", large, small)


def two_diff(do: Steps, left: Expr, right: Expr) -> Pair:
    """Difference and its rounding error, whichever is larger."""
    return _pair(do, "diff", "TwoDiff", left, right)


def plus(do: Steps, one: Pair, two: Pair) -> Pair:
    """The sum, whichever is larger."""
    return _pair(do, "total", "PairSum", *one, *two)


def minus(do: Steps, one: Pair, two: Pair) -> Pair:
    """The difference, whichever is larger."""
    return _pair(do, "diff", "PairDiff", *one, *two)


def one_plus(do: Steps, number: Pair) -> Pair:
    """1 and a number of at most this size."""
    return _pair(do, "total", "OnePlus", *number)


def one_minus(do: Steps, number: Pair) -> Pair:
    """1 without a number of at most this size."""
    return _pair(do, "less", "OneMinus", *number)


def scaled(do: Steps, factor: Expr, number: Pair) -> Pair:
    """A float times a pair."""
    if number[1] == 0:
        return _pair(do, "prod", "TwoProd", factor, number[0])
    return _pair(do, "prod", "WideProd", factor, *number)


def times(do: Steps, one: Pair, two: Pair) -> Pair:
    """The product."""
    return _pair(do, "prod", "PairProd", *one, *two)


def squared(do: Steps, number: Pair) -> Pair:
    """The square."""
    return _pair(do, "squared", "PairSquare", *number)


def over(do: Steps, top: Pair, bottom: Pair) -> Pair:
    """The quotient."""
    return _pair(do, "quot", "PairQuot", *top, *bottom)


def _pair(do: Steps, name: str, routine: str, *arguments: Expr) -> Pair:
    high, low = do.several((name, f"{name}_low"), routine, *arguments)
    return high, low
