"""Where the arguments of a form may be: each said once, for people and for code.

Every argument is a finite number; how large it may be depends on the floats that compute with it.
"""

from __future__ import annotations

import sympy as sp
from sympy import And, Symbol
from sympy.logic.boolalg import Boolean

from symhaptic.notation import alpha, beta, d, delta, epsilon, gamma, theta

LARGEST, STIFFEST, LONGEST, BELOW_PI = sp.symbols("LARGEST STIFFEST LONGEST BELOW_PI")
"""The largest size of a number, the stiffest plant, the longest delay, the last float before pi."""

_RANGES: dict[Symbol, tuple[str, Boolean]] = {
    alpha: ("", sp.Abs(alpha) <= LARGEST),
    beta: ("", sp.Abs(beta) <= LARGEST),
    gamma: ("gamma >= 0", And(gamma >= 0, gamma <= STIFFEST)),
    delta: ("delta >= 0", And(delta >= 0, delta <= LARGEST)),
    d: ("d >= 0", And(d >= 0, d <= LONGEST)),
    epsilon: ("0 <= epsilon < 1", And(epsilon >= 0, epsilon < 1)),
    theta: ("0 < theta < pi", And(theta > 0, theta <= BELOW_PI)),
}
"""In words, where not every finite number is allowed, and as what is true inside alone.

NaN makes a comparison false: a condition is never to be turned round into what is true outside.
"""


def domain(symbols: tuple[Symbol, ...], *more: str) -> tuple[str, ...]:
    """Where these symbols may be, and more conditions."""
    return (*(_RANGES[s][0] for s in symbols if _RANGES[s][0]), *more)


def within(symbol: Symbol) -> Boolean:
    """What is true of an argument inside its range, and false for NaN and infinities.

    >>> within(alpha)
    Abs(alpha) <= LARGEST
    """
    return _RANGES[symbol][1]
