"""The angle of the wall of largest stable stiffness, with its value in many digits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import cacheit

from symhaptic.forms import max_stiffness_slope
from symhaptic.forms.implicit import ImplicitFunction, Leaning
from symhaptic.forms.root_count import fractional_outside

MAX_STIFFNESS_SPRING = sp.Rational(98, 10)
"""Up to this gamma, just below pi^2, the first maximum is trusted to be the largest."""

MAX_STIFFNESS_ARGUMENTS = sp.symbols(
    "gamma delta d l part first last at_one at_minus_one loss together apart"
)
"""The plant, the delay and its parts, and n1 and n0, or m2 and m0, with the values at 1 and -1."""

_TRIED = 48
"""Angles at which the first maximum is looked for."""


def _triples(values: Iterable[mpf]) -> Iterator[tuple[mpf, mpf, mpf]]:
    """Each value with the two behind it, no sooner than it is asked for."""
    return ((x, y, z) for (x, y), (_, z) in pairwise(pairwise(values)))


class MaxStiffnessAngle(ImplicitFunction):
    """The angle of the wall of largest stable stiffness, of :data:`MAX_STIFFNESS_ARGUMENTS`."""

    nargs = 12
    meaning = (
        "the first angle at which the stiffness on the boundary is largest, searched for, or the "
        "end at pi for delays below one period; NaN where that does not border the stable region, "
        "for gamma > 9.8, and for sqrt(gamma) (d + 1) > pi with d > 1"
    )

    @property
    def parts(self) -> tuple[sp.Expr, ...]:
        """What it is of, as in :data:`MAX_STIFFNESS_ARGUMENTS`."""
        return tuple(self.args)

    @cacheit  # type: ignore[untyped-decorator]
    def leaning(self) -> Leaning:
        """Below one period: the slope next to pi, negative where the angle has left pi."""
        _, _, delay, _, part, _, last, *numbers = self.parts
        known = dict(
            zip(max_stiffness_slope.EARLY, (*numbers, last if part else sp.S.Zero), strict=True)
        )
        slope = max_stiffness_slope.end().xreplace(known)
        return Leaning(slope, max_stiffness_slope.leaning(self, known), (1 - delay, -slope))

    @staticmethod
    def exact(*numbers: mpf) -> mpf:
        """By a grid on -z^(l+1) A/M and findroot, and the roots of the polynomial."""
        gamma, delta, d, whole, part, first, last, at_one, _, loss, together, _ = numbers
        if gamma > 9.8 or (mpmath.sqrt(gamma) * (d + 1) > mpmath.pi and d > 1):
            raise ArithmeticError("outside the domain")
        if delta == 0:
            raise ArithmeticError("a device that may be left swinging")
        m2, m0 = (first, last) if part else (first, mpf(0))
        m1 = together - m2 - m0

        def force(theta: mpf) -> mpf:
            z = mpmath.expj(theta)
            above = z * z - (2 - loss - at_one) * z + 1 - loss
            return -(z ** (whole + 1)) * above / ((m2 * z + m1) * z + m0)

        def stiffness(theta: mpf) -> mpf:
            q = force(theta)
            return q.real - q.imag * mpmath.tan(theta / 2)

        end = mpmath.pi / (d + 1) if d >= 1 else +mpmath.pi
        grid = [end * (i + mpf(1) / 2) / _TRIED for i in range(_TRIED)]
        grid += [end * (1 - mpf(2) ** -k) for k in range(8, 50)] if d < 1 else []
        with mpmath.workdps(20):
            tops = (i for i, (x, y, z) in enumerate(_triples(map(stiffness, grid))) if x < y > z)
            top = next(tops, None)
        if top is None and d >= 1:
            raise ArithmeticError("no first maximum")
        with mpmath.extradps(10):
            if top is None:  # there the imaginary part vanishes with sin(theta)
                theta = +mpmath.pi
                beta = -mpmath.diff(lambda x: force(x).imag, theta)
                alpha = force(theta).real - 2 * beta
            else:
                slope = lambda x: mpmath.diff(stiffness, x)  # noqa: E731
                ends = grid[top], grid[top + 2]
                theta = mpmath.findroot(slope, ends, solver="anderson", verify=False)
                beta = force(theta).imag / mpmath.sin(theta)
                alpha = stiffness(theta)
        if alpha <= -gamma:
            raise ArithmeticError("a device that no wall stops")
        inside = alpha - (alpha + gamma) / 10**6
        if whole <= 12 and fractional_outside(
            inside, beta, whole, m2, m0, gamma, mpf(0), loss, together, mpf(0), mpf(0)
        ):
            raise ArithmeticError("it does not border the region")
        return +theta


class MaxStiffnessWholeAngle(MaxStiffnessAngle):
    """The same for whole delays alone, which have no parts."""

    nargs = 10
    meaning = (
        "the first angle at which the stiffness on the boundary is largest, searched for; NaN "
        "where that does not border the stable region, for gamma > 9.8, and for "
        "sqrt(gamma) (d + 1) > pi with d > 1"
    )

    @property
    def parts(self) -> tuple[sp.Expr, ...]:
        """The delay is its own whole part."""
        return (*self.args[:3], self.args[2], sp.S.Zero, *self.args[3:])

    @staticmethod
    def exact(*numbers: mpf) -> mpf:
        """As with parts."""
        return MaxStiffnessAngle.exact(*numbers[:3], numbers[2], mpf(0), *numbers[3:])


def of_whole(angle: MaxStiffnessAngle) -> MaxStiffnessAngle:
    """The same where the fraction of the delay is 0."""
    return (
        angle
        if angle.args[4:5] != (0,)
        else MaxStiffnessWholeAngle(*angle.args[:3], *angle.args[5:])
    )
