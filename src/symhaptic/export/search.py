"""A root between two ends, as steps of a routine: Chandrupatla's method.

It interpolates where that is safe and halves where it is not, so that it never leaves its
bracket; T. R. Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import And, Expr, Max, Min, Or, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, Search, choose
from symhaptic.export.steps import Steps

MOST = 120
"""At most so many steps; some ten are usual, and halving alone would need sixty."""


def crossing(
    do: Steps,
    f: Callable[[Steps, Expr], Expr],
    low: Expr,
    high: Expr,
    close: Expr,
    wanted: Boolean = sp.true,
) -> Expr:
    """Where ``f`` changes from positive to negative, to the relative distance ``close``.

    An end stands for the root where ``f`` does not change: ``low`` where it is not positive there
    already, ``high`` where it is positive even there.  Nothing is searched where it is not
    ``wanted``.
    """
    low, high = do("low", low), do("high", high)
    inner = Steps(taken=do.taken)
    found = _searched(inner, f, low, high, close, wanted)
    at = do.fresh("at")
    root = do.fresh("root")
    do.done.append(Search(root, at, f(do, at), low, high, close, tuple(inner.done), found))
    return root


def _searched(
    do: Steps,
    f: Callable[[Steps, Expr], Expr],
    low: Expr,
    high: Expr,
    close: Expr,
    wanted: Boolean,
) -> Expr:
    """The same by steps."""

    def first(at: Expr) -> Expr:
        value = f(do, at)
        return value if wanted == sp.true else choose(wanted, value, 0)

    above, below = do("above", first(low)), do("below", first(high))
    start = {"b": low, "fb": above, "a": high, "fa": below, "c": high, "fc": below}
    b, fb, a, fa, _, _ = do.repeat(
        start,
        lambda inner, states: _narrowed(inner, f, states, close),
        lambda states: _over(states, close),
        MOST,
    )
    best = choose(sp.Abs(fa) < sp.Abs(fb), a, b)
    return choose(above <= 0, low, choose(below >= 0, high, best))


def _least(states: tuple[Symbol, ...], close: Expr) -> Expr:
    b, fb, a, fa, *_ = states
    return close * sp.Abs(choose(sp.Abs(fa) < sp.Abs(fb), a, b))


def _over(states: tuple[Symbol, ...], close: Expr) -> Boolean:
    """No change of sign is left between the ends, or they are close."""
    b, fb, a, fa, *_ = states
    same = Or(And(fa >= 0, fb >= 0), And(fa <= 0, fb <= 0))
    return Or(same, sp.Abs(b - a) <= _least(states, close))


def _narrowed(
    do: Steps, f: Callable[[Steps, Expr], Expr], states: tuple[Symbol, ...], close: Expr
) -> tuple[Expr, ...]:
    b, fb, a, fa, _, _ = states
    new = do("new", sp.Function("NextGuess")(*states, close))
    value = do("value", f(do, new))
    same = Or(And(value > 0, fa > 0), And(value < 0, fa < 0))
    same = do("same", choose(same, 1, 0)) > 0
    return (
        choose(same, b, a), choose(same, fb, fa), new, value, choose(same, a, b),
        choose(same, fa, fb),
    )  # fmt: skip


def next_guess() -> Routine:
    """Inverse quadratic interpolation where that is safe, else the middle."""
    do = Steps()
    b, fb, a, fa, c, fc, close = given = sp.symbols("b fb a fa c fc close")
    span, rise = do("span", c - b), do("rise", fc - fb)
    place = do("place", (a - b) / do.nonzero(span))
    height = do("height", (fa - fb) / do.nonzero(rise))
    inner = And(height * height < place, (1 - height) ** 2 < 1 - place)
    safe = do("safe", choose(inner, 1, 0)) > 0
    one = do("one", choose(safe, fb - fa, 1))
    two = do("two", choose(safe, fb - fc, 1))
    three = do("three", choose(safe, fa - fc, 1))
    width = do("width", b - a)
    here, there = do("here", fa / one), do("there", fc / two)
    some = do.nonzero(width)
    other, last = do("other", fa / three), do("last", fb / two)
    ahead, behind = here * there, (c - a) / some * other * last
    guess = do("guess", choose(safe, ahead + behind, sp.S.Half))
    edge = do("edge", _least((b, fb, a, fa, c, fc), close) / sp.Abs(some))
    edge = do("edge", Min(edge, sp.S.Half))
    share = do("share", Min(guess, 1 - edge))
    share = do("share", Max(share, edge))
    return do.routine("NextGuess", "the next point of a search between a and b, where f is fa and "
                      "fb, after c", given, a + share * width)  # fmt: skip


ROUTINES = (next_guess,)
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
