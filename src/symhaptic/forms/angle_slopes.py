"""What the entire functions of a delay and an angle change by with the angle."""

from __future__ import annotations

import sympy as sp
from sympy import Expr, cos, factorial, sin

from symhaptic.forms.entire import Chord, Entire, Spread


class Ripple(Entire):
    """What sin((k + 1) x)/sin(x) changes by: regular at x = 0, and where no sine vanishes."""

    nargs = 2
    meaning = "((k + 1) cos((k + 1) x) sin(x) - sin((k + 1) x) cos(x))/sin(x)^2"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """((k + 1) cos((k + 1) x) sin(x) - sin((k + 1) x) cos(x))/sin(x)^2."""
        turn = (k + 1) * x
        return ((k + 1) * cos(turn) * sin(x) - sin(turn) * cos(x)) / sin(x) ** 2

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """By odd powers of x: those of a quotient of sines, each found from those before it."""
        found: list[Expr] = []
        for j in range(k + 2):
            own = (-1) ** j * (steps + 1) ** (2 * j + 1) / factorial(2 * j + 1)
            rest = ((-1) ** i * found[j - i] / factorial(2 * i + 1) for i in range(1, j + 1))
            found.append(sp.expand(own - sp.Add(*rest)))
        return (2 * k + 2) * found[-1] * x ** (2 * k + 1)


class SpreadSlope(Entire):
    """What Spread(k, x) changes by with x."""

    nargs = 2
    meaning = "(2 k + 2) (cos(x) - cos((2 k + 2) x))/x^3 - 3 Spread(k, x)/x"

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """(2 k + 2) (cos(x) - cos((2 k + 2) x))/x^3 - 3 Spread(k, x)/x."""
        order = 2 * (k + 1)
        return order * (cos(x) - cos(order * x)) / x**3 - 3 * Spread.definition(k, x) / x

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """By odd powers of x."""
        symbol = sp.Dummy()
        return Spread.term(k + 1, steps, symbol).diff(symbol).subs(symbol, x)


class ChordSlope(Entire):
    """What Chord(k, x) changes by with x."""

    nargs = 2
    meaning = (
        "(2 k + 2) ((1 - cos(x)) cos((k + 1) x) + (k + 1) sin(x) sin((k + 1) x))/x^3 "
        "- 3 Chord(k, x)/x"
    )

    @classmethod
    def definition(cls, k: Expr, x: Expr) -> Expr:
        """The derivative of the closed form of Chord."""
        n = k + 1
        own = (1 - cos(x)) * cos(n * x) + n * sin(x) * sin(n * x)
        return 2 * n * own / x**3 - 3 * Chord.definition(k, x) / x

    @classmethod
    def term(cls, k: int, steps: Expr, x: Expr) -> Expr:
        """By odd powers of x."""
        symbol = sp.Dummy()
        return Chord.term(k + 1, steps, symbol).diff(symbol).subs(symbol, x)
