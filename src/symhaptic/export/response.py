"""The force that moves the sampled device, as routines: the differences in A/z and M are exact.

That is, rounded once: what the boundary of stability loses there it magnifies.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr, Symbol, tan

from symhaptic.export.routine import ProductError, Routine, Steps, difference, fast_sum, product
from symhaptic.notation import psi

_DEVICE = sp.symbols("at_one at_minus_one loss together apart across")


def less(do: Steps, one: Expr, factor: Expr, square: Expr, low: Expr) -> Symbol:
    """one - factor (square + low)."""
    taken = do("taken", factor * square)
    total, lost = difference(do, one, taken)
    missed = do("missed", ProductError(factor, square) + factor * low)
    lost = do("lost", lost - missed)
    return do("left", total + lost)


def _force(do: Steps) -> tuple[Expr, ...]:
    """A/z and M, real and imaginary part, over cos(psi)^2, and the squared size of M."""
    at_one, at_minus_one, loss, together, apart, across = _DEVICE
    t = do("t", tan(psi))
    square, low = do("square", t * t), do("low", ProductError(t, t))
    above = less(do, at_one, at_minus_one, square, low)
    below = less(do, together, apart, square, low)
    above_j, below_j = do("above_j", 2 * t * loss), do("below_j", t * across)
    size = do("size", below * below + below_j * below_j)
    return above, above_j, below, below_j, size


def in_phase() -> Routine:
    """The real part."""
    do = Steps()
    above, above_j, below, below_j, size = _force(do)
    found = (above * below + above_j * below_j) / size
    return do.routine("InPhase", "the real part of A/(z M) at z = exp(2 j psi)",
                      (psi, *_DEVICE), found)  # fmt: skip


def ahead() -> Routine:
    """The imaginary part."""
    do = Steps()
    above, above_j, below, below_j, size = _force(do)
    found = (above_j * below - above * below_j) / size
    return do.routine("Ahead", "the imaginary part of A/(z M) at z = exp(2 j psi)",
                      (psi, *_DEVICE), found)  # fmt: skip


def late_apart() -> Routine:
    """A sum of four, one of them a product of four, rounded once."""
    do = Steps()
    given = sp.symbols("epsilon x x_low y y_low first last turned")
    epsilon, x, x_low, y, y_low, first, last, turned = given
    late, lost = fast_sum(do, sp.S.One, -epsilon)
    share, share_low = product(do, epsilon, late, lost)
    both, both_low = product(do, x, y, y_low)
    both_low = do("both_low", both_low + x_low * y)
    found, low = product(do, share, both, both_low)
    low = do("low", low + both * share_low)
    left, one = difference(do, first, 2 * found)
    left, two = difference(do, left, last)
    left, three = difference(do, left, -turned)
    rest = do("rest", one + two)
    rest = do("rest", rest + three)
    rest = do("rest", rest - 2 * low)
    about = "m2 - m1 + m0, M at z = -1 behind a fraction of a period"
    return do.routine("LateApart", about, given, left + rest)


ROUTINES = (in_phase, ahead, late_apart)
PRECISE = ()
