"""What depends on how many digits a float has: one line for each precision."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy import Expr
from sympy.logic.boolalg import Boolean

from symhaptic.forms.form import BELOW_PI, LARGEST, LONGEST, STIFFEST
from symhaptic.notation import sizes

_GUARD = 2.0**-12
"""A truncated series may miss this part of half a last place."""


def _single(value: float) -> str:
    """The decimals of a float32, the same with every NumPy, whose own have changed."""
    kind = np.float32(value)
    size = abs(float(kind))
    if size >= 1e6 or 0 < size < 1e-4:
        return np.format_float_scientific(kind, unique=True, trim="-")
    return np.format_float_positional(kind, unique=True, trim="0")


@dataclass(frozen=True)
class Precision:
    """A binary format of floats."""

    name: str
    bits: int
    """Binary digits, the hidden one among them."""
    kind: type[np.float64] | type[np.float32]
    smallest: float
    """A stiffness or a damping that is next to nothing."""
    tiny: float
    """Results below are not measured: what leads to them may lose its last digits."""
    huge: float
    """The same above."""
    largest: float
    """Size of an argument up to which no sum or product of the formulas overflows."""
    stiffest: float
    """Stiffness of a plant up to which it is known how far it swings in a period: beyond, what the
    last place of its frequency turns it by is no small angle."""
    longest: float
    """Delay up to which a phase is known: beyond, floats have no fractions to speak of."""

    @property
    def last(self) -> sp.Rational:
        """The last place of 1."""
        return sp.Rational(1, 2 ** (self.bits - 1))

    @property
    def close(self) -> sp.Rational:
        """Relative distance of two ends of a bracket that are as good as one."""
        return 2 * self.last

    @property
    def flat(self) -> sp.Rational:
        """The same for the place of a maximum, whose value changes by the square of it."""
        return sp.Rational(1, 2 ** (self.bits // 2 + 5))

    @property
    def below_pi(self) -> float:
        """The largest float that is less than pi."""
        near = self.kind(np.pi)
        return float(
            near if float(near) < np.pi or self.bits == 53 else np.nextafter(near, self.kind(0))
        )

    @property
    def vanishing(self) -> sp.Rational:
        """A power of two below which squares lose digits; its inverse square lifts all above."""
        return sp.Rational(*(sizes.FAINT if self.bits == 53 else 2.0**-40).as_integer_ratio())

    @property
    def split(self) -> sp.Integer:
        """Veltkamp's factor: halves of a float whose products are exact."""
        return sp.Integer(2 ** ((self.bits + 1) // 2) + 1)

    def at(self, condition: Boolean) -> Boolean:
        """A condition on arguments with the numbers of this precision."""
        ends = {
            LARGEST: self.largest,
            STIFFEST: self.stiffest,
            LONGEST: self.longest,
            BELOW_PI: self.below_pi,
        }
        return condition.xreplace({s: sp.Rational(*v.as_integer_ratio()) for s, v in ends.items()})

    def nearest(self, number: float | Expr) -> float:
        """The float nearest to a number.

        >>> SINGLE.nearest(0.1)
        0.10000000149011612
        """
        return float(self.kind(float(number)))

    def parts(self, number: Expr, count: int = 2) -> tuple[sp.Rational, ...]:
        """Floats whose sum is a number: the nearest, the one nearest to the rest, and so on."""
        found, left = [], number
        for _ in range(count):
            near = sp.Rational(*self.nearest(sp.N(left, 60)).as_integer_ratio())
            found.append(near)
            left = left - near
        return tuple(found)

    def written(self, value: float) -> str:
        """The shortest decimals that read back as the same float."""
        text = repr(float(value)) if self.bits == 53 else _single(value)
        text = text if any(c in text for c in ".en") else f"{text}.0"
        power = f"{value:g}"
        return power if "e+" in power and float(power) == value else text

    def ulp(self, size: float) -> float:
        """The last place of a number."""
        return float(np.spacing(self.kind(abs(size))))

    def terms(self, ahead: Callable[[int], Expr]) -> int:
        """How many terms of a series serve, where ``ahead`` bounds all terms from the n-th on.

        >>> DOUBLE.terms(lambda n: 1 / sp.factorial(n)), SINGLE.terms(lambda n: 1 / sp.factorial(n))
        (21, 14)
        """
        n = 1
        while float(ahead(n)) > _GUARD * float(self.last) / 2:
            n += 1
        return n


_SIZES = sizes.LARGEST, sizes.STIFFEST, sizes.LONGEST

DOUBLE = Precision("double", 53, np.float64, 1e-300, 1e-290, 1e290, *_SIZES)
SINGLE = Precision("single", 24, np.float32, 1e-30, 1e-30, 1e30, 1e8, 1e7, 1e6)

PRECISIONS = {p.name: p for p in (DOUBLE, SINGLE)}
