"""What was found by ball arithmetic, in a form that :mod:`symhaptic.proof.recheck` can check again.

A certificate says everything that the check needs and nothing of how it was found.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol, TypeAlias

import sympy as sp
from flint import acb, arb
from sympy import Expr

Box: TypeAlias = Mapping[sp.Symbol, tuple[Expr, Expr]]
"""Closed interval of each symbol; its ends are real numbers."""

Balls: TypeAlias = Mapping[sp.Symbol, acb]


class Given(Protocol):
    """Further symbols: what they mean, in numbers whose balls follow from those of the box."""

    @property
    def of(self) -> Sequence[sp.Symbol]:
        """The symbols of the box on which the numbers depend."""

    @property
    def meanings(self) -> Mapping[sp.Symbol, Expr]:
        """Each symbol as an expression in the numbers and in symbols of the box."""

    def numbers(self, at: Balls) -> Balls:
        """Balls of the numbers."""

    def __call__(self, at: Balls) -> Balls:
        """Balls of the symbols."""


@dataclass(frozen=True)
class Known:
    """Symbols whose balls are the same on every piece of a box."""

    balls: Mapping[sp.Symbol, arb]
    of: Sequence[sp.Symbol] = ()

    def __post_init__(self) -> None:
        _read_once(self, "balls")

    @property
    def meanings(self) -> Mapping[sp.Symbol, Expr]:
        """Each stands for itself."""
        return {symbol: symbol for symbol in self.balls}

    def numbers(self, at: Balls) -> Balls:
        """Their balls."""
        return {symbol: acb(value) for symbol, value in self.balls.items()}

    def __call__(self, at: Balls) -> Balls:
        """Their balls."""
        return self.numbers(at)


@dataclass(frozen=True)
class Positive:
    """``expr > 0`` on a box that was cut into pieces, each decided by one ball.

    ``cuts`` is the tree of pieces, from the whole box on and the lower half first: ``.`` is a
    piece that one ball decides, ``:`` one that its middle and its slopes do, a digit the number of
    the symbol across which a piece is halved.
    """

    expr: Expr
    box: Box
    cuts: str
    bits: int
    given: Given | None = None
    defined: tuple[Expr, ...] = ()
    """What else must be defined and real on every piece: the sides of an inequality, which SymPy
    may have cancelled in their difference."""

    def __post_init__(self) -> None:
        _read_once(self, "box", "defined")

    @property
    def pieces(self) -> int:
        """How many pieces the box was cut into."""
        return self.cuts.count(".") + self.cuts.count(":")


@dataclass(frozen=True)
class Zero:
    """``expr`` has one zero between two numbers, and it lies in a ball."""

    expr: Expr
    variable: sp.Symbol
    between: tuple[Expr, Expr]
    ball: arb
    bits: int
    at: Mapping[Expr, Expr | acb | arb] = field(default_factory=dict)
    """Values of further symbols."""

    def __post_init__(self) -> None:
        _read_once(self, "between", "at")


@dataclass(frozen=True)
class Largest:
    """The largest value on a box is not above ``upper``, and not below ``lower``.

    ``below`` certifies ``upper - expr > 0``; ``where`` is a point of the box with such a value.
    """

    expr: Expr
    below: Positive
    where: Mapping[sp.Symbol, Expr]
    lower: Expr
    upper: Expr

    def __post_init__(self) -> None:
        _read_once(self, "where")


def _read_once(certificate: object, *names: str) -> None:
    """Copy the parts of a certificate: an object of another class may return other values later."""
    for name in names:
        part = getattr(certificate, name)
        if isinstance(part, Mapping):
            object.__setattr__(certificate, name, {s: _tuple(v) for s, v in part.items()})
        else:
            object.__setattr__(certificate, name, _tuple(part))


def _tuple(part: object) -> object:
    return tuple(part) if isinstance(part, Sequence) and not isinstance(part, str) else part


Certificate: TypeAlias = Positive | Zero | Largest
