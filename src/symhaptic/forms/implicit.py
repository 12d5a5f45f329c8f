"""Functions whose value is searched for: named here, with their values in many digits.

None has a closed form.  ``exact`` finds the value from its defining condition, by another way than
the exported search does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

import mpmath
import sympy as sp
from mpmath import mpf
from sympy import Expr, cacheit

from symhaptic.forms import max_stiffness_slope
from symhaptic.forms.entire import Meant
from symhaptic.forms.root_count import fractional_outside, fractional_sizes
from symhaptic.notation import alpha, beta, d, delta, gamma

_MANY = 40
"""Angles a half turn of the delay, to look for the largest value at."""

_FAR = 8
"""Half turns of a long delay that are looked at; all of them for a short one."""


@dataclass(frozen=True)
class Leaning:
    """A sum that passes through zero, and what hangs on it."""

    total: Expr
    slope: Expr
    """The derivative by the sum."""
    counts: tuple[Expr, ...]
    """Positive where it matters."""


class ImplicitFunction(Meant):
    """A function without a closed form."""

    exact: ClassVar[Callable[..., mpf]]
    """Its value in the digits that mpmath is set to; raises ArithmeticError if none is found."""

    def leaning(self) -> Leaning | None:
        """The sum that it hangs on where that passes through zero, if there is one."""
        return None


def fraction(delay: mpf) -> tuple[mpf, mpf]:
    """Whole periods and the rest."""
    whole = mpmath.floor(delay)
    return whole, delay - whole


class WholePart(ImplicitFunction, nargs=1):
    """floor(d), the integer part of a delay"""

    exact = staticmethod(mpmath.floor)


class FractionalPart(ImplicitFunction, nargs=1):
    """d - floor(d), the fractional part of a delay"""

    @staticmethod
    def exact(d: mpf) -> mpf:
        """d - floor(d)."""
        return d - mpmath.floor(d)


class SomePart(ImplicitFunction, nargs=1):
    """d - floor(d), or 1/2 if that is 0

    So a branch for fractions is defined for whole delays, too.
    """

    @staticmethod
    def exact(d: mpf) -> mpf:
        """d - floor(d), or 1/2."""
        return d - mpmath.floor(d) or mpf(1) / 2


def need(alpha: mpf, beta: mpf, d: mpf) -> Callable[[mpf], mpf]:
    """The damping that the wall needs at an angle, from the printed (5), twice for a fraction."""
    whole, part = fraction(d)

    def straight(theta: mpf, delay: mpf) -> mpf:
        kernel = mpmath.sin((delay + 0.5) * theta) / (2 * mpmath.sin(theta / 2))
        return alpha * kernel - beta * mpmath.cos((delay + 1) * theta)

    def at(theta: mpf) -> mpf:
        if part == 0:
            return straight(theta, whole)
        n = (1 - part) * straight(theta, whole) + part * straight(theta, whole + 1)
        size = alpha**2 + 4 * beta * (alpha + beta) * mpmath.sin(theta / 2) ** 2
        return (n + mpmath.sqrt(n**2 + part * (1 - part) * size)) / 2

    return at


def largest(f: Callable[[mpf], mpf], turn: mpf, end: mpf) -> tuple[mpf, mpf]:
    """The largest value of f on (0, pi), and where: a fine grid, then a root of the slope.

    ``turn`` is the length on which f swings, ``end`` its limit at 0.
    """
    count = min(int(mpmath.pi / turn), _FAR) * _MANY
    with mpmath.workdps(30):
        grid = [turn * i / _MANY for i in range(1, count)]
        grid = [*grid, mpmath.pi] if count < _FAR * _MANY else grid
        values = [f(theta) for theta in grid]
        peaks = _peaks(values)
        best = max(range(len(grid)), key=peaks.__getitem__)
    if end >= values[best] * (1 - mpf(10) ** -25):
        return +end, mpf(0)
    theta = grid[best]
    if best < len(grid) - 1:
        low = grid[best - 1] if best else turn / _MANY / 1000
        slope = lambda x: mpmath.diff(f, x)  # noqa: E731
        try:
            theta = mpmath.findroot(slope, (low, grid[best + 1]), solver="anderson", verify=False)
        except ZeroDivisionError:
            raise ArithmeticError("no maximum found") from None
    return f(theta), theta


def _peaks(values: list[mpf]) -> list[mpf]:
    """Each value, and where it is the largest of three the peak of the parabola through them."""
    found = list(values)
    for i in range(1, len(values) - 1):
        rise, fall = values[i] - values[i - 1], values[i] - values[i + 1]
        if rise >= 0 and fall >= 0 and rise + fall > 0:
            found[i] += (rise - fall) ** 2 / (8 * (rise + fall))
    return found


class LargestRequiredDamping(ImplicitFunction, nargs=3):
    """the largest damping that the wall (alpha, beta) with a delay d requires at any angle, found
    by a search; infinite for alpha < 0

    Of (alpha, beta, d).
    """

    @staticmethod
    def exact(alpha: mpf, beta: mpf, d: mpf) -> mpf:
        """By a grid and findroot."""
        if alpha < 0:
            return mpf("inf")
        whole, part = fraction(d)
        n = alpha * (d + 0.5) - beta
        end = (n + mpmath.sqrt(n**2 + part * (1 - part) * alpha**2)) / 2 if part else n
        return largest(need(alpha, beta, d), mpmath.pi / (whole + 1), end)[0]


class LargestWholeRequiredDamping(LargestRequiredDamping):
    """the largest damping that the wall (alpha, beta) with an integer delay d requires at any
    angle, found by a search; infinite for alpha < 0
    """


class Lifted(ImplicitFunction, nargs=3):
    """x, times a power of two if the squares of the wall (alpha, beta) would underflow

    Of (x, alpha, beta).
    """

    @staticmethod
    def exact(x: mpf, alpha: mpf, beta: mpf) -> mpf:
        """No square vanishes in many digits."""
        return x


class CriticalAngle(ImplicitFunction, nargs=4):
    """half of the angle at which the wall (alpha, beta) with a delay of l + epsilon periods
    requires the most damping, found by a search

    Of (alpha, beta, l, epsilon).
    """

    @staticmethod
    def exact(alpha: mpf, beta: mpf, whole: mpf, part: mpf) -> mpf:
        """By a grid and findroot."""
        n = alpha * (whole + part + 0.5) - beta
        end = (n + mpmath.sqrt(n**2 + part * (1 - part) * alpha**2)) / 2 if part else n
        return largest(need(alpha, beta, whole + part), mpmath.pi / (whole + 1), end)[1] / 2


def _wall(x: mpf, d: mpf) -> tuple[mpf, mpf]:
    alpha = mpmath.cos(x) / (mpmath.floor(d) + 1)
    return alpha, mpmath.sin(x) - alpha / 2


def _worst_at(theta: mpf, d: mpf) -> mpf:
    """The wall whose need has no slope at theta, as its angle x."""

    def slope(x: mpf) -> mpf:
        return mpmath.diff(need(*_wall(x, d), d), theta)

    low, high = mpf(0), mpmath.pi / 2
    if slope(low) >= 0 or slope(high) <= 0:
        raise ArithmeticError("no wall is worst at this angle")
    return mpmath.findroot(slope, (low, high), solver="anderson", verify=False)


class Touching(ImplicitFunction, nargs=3):
    """the angle x of the wall with (l + 1) alpha = cos(x), beta + alpha/2 = sin(x) that requires
    the most damping at theta, with a delay of l + epsilon periods; NaN if there is none

    Of (theta, l, epsilon).
    """

    @staticmethod
    def exact(theta: mpf, whole: mpf, part: mpf) -> mpf:
        """By findroot."""
        return _worst_at(theta, whole + part)


class PassiveAngle(ImplicitFunction, nargs=2):
    """the worst angle of the passive wall of maximum stiffness for a delay of l + epsilon periods

    Of (l, epsilon).
    """

    @staticmethod
    def exact(whole: mpf, part: mpf) -> mpf:
        """The largest stiffness on the boundary, by findroot."""
        d = whole + part

        def stiffness(theta: mpf) -> mpf:
            alpha, beta = _wall(_worst_at(theta, d), d)
            return alpha / need(alpha, beta, d)(theta)

        turn = mpmath.pi / (d + 1)
        slope = lambda t: mpmath.diff(stiffness, t)  # noqa: E731
        ends = turn * mpf("0.3"), turn * mpf("0.7")
        return mpmath.findroot(slope, ends, solver="anderson", verify=False)


class Pushed(ImplicitFunction, nargs=2):
    """the second number, or infinity where the first is negative"""

    @staticmethod
    def exact(alpha: mpf, value: mpf) -> mpf:
        """The second argument, or infinity."""
        return mpf("inf") if alpha < 0 else value


class Lead(ImplicitFunction, nargs=3):
    """(1 - epsilon) sin((l + 1) theta) + epsilon sin((l + 2) theta) where (l + 1) theta < 4, else
    -1: negative beyond the angle at which mere damping is in phase with its delay

    Of (theta, l, epsilon).
    """

    @staticmethod
    def exact(theta: mpf, whole: mpf, part: mpf) -> mpf:
        """As it says."""
        if (whole + 1) * theta >= 4:
            return mpf(-1)
        early, late = (mpmath.sin((whole + i) * theta) for i in (1, 2))
        return (1 - part) * early + part * late


class Rated(ImplicitFunction, nargs=2):
    """the second number, or NaN where the first is negative"""

    @staticmethod
    def exact(alpha: mpf, value: mpf) -> mpf:
        """The second argument, or none."""
        if alpha < 0:
            raise ArithmeticError("there is none: the wall pulls, or the boundary has ended")
        return value


# -- The angle of the wall of largest stable stiffness, with its value in many digits -------------


MAX_STIFFNESS_SPRING = sp.Rational(98, 10)
"""Up to this gamma, just below pi^2, the first maximum is trusted to be the largest."""

_TRIED = 48
"""Angles at which the first maximum is looked for."""


def _triples(values: Iterable[mpf]) -> Iterator[tuple[mpf, mpf, mpf]]:
    """Each value with the two behind it, no sooner than it is asked for."""
    return ((x, y, z) for (x, y), (_, z) in pairwise(pairwise(values)))


class MaxStiffnessAngle(ImplicitFunction, nargs=12):
    """the first angle at which the stiffness on the boundary is largest, searched for, or the end
    at pi for delays below one period; NaN where that does not border the stable region, for
    gamma > 9.8, and for sqrt(gamma) (d + 1) > pi with d > 1

    Its arguments are gamma, delta, d, l, part, first, last, at_one, at_minus_one, loss, together
    and apart: the plant, the delay and its parts, and n1 and n0, or m2 and m0, with their values at
    1 and -1.
    """

    @property
    def parts(self) -> tuple[sp.Expr, ...]:
        """Its arguments."""
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


class MaxStiffnessWholeAngle(MaxStiffnessAngle, nargs=10):
    """the first angle at which the stiffness on the boundary is largest, searched for; NaN where
    that does not border the stable region, for gamma > 9.8, and for sqrt(gamma) (d + 1) > pi
    with d > 1

    The same for whole delays alone, which have no parts.
    """

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


LOOP = alpha, beta, gamma, delta, d
"""Wall, device and delay."""


class DelayMargin(ImplicitFunction, nargs=6):
    """the delay that may be added to d until a root reaches the unit circle, searched for; 0 where
    verdict < 1

    Of (verdict, alpha, beta, gamma, delta, d).
    """

    @staticmethod
    def exact(verdict: mpf, alpha: mpf, beta: mpf, gamma: mpf, delta: mpf, d: mpf) -> mpf:
        """By the largest root of the polynomial, at delays that are half a period apart first."""
        if verdict < 1:
            return mpf(0)
        motion = mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]])
        whole = mpmath.expm(motion)
        loss = 1 - whole[0, 0] * whole[1, 1] + whole[0, 1] * whole[1, 0]

        def outside(delay: mpf) -> mpf:
            """By how much the largest root is outside."""
            steps, part = fraction(delay)
            rest, begun = mpmath.expm(motion * (1 - part)), mpmath.expm(motion * part)
            late = rest * begun[:, 2] - rest[:, 2]  # what the force of the begin has moved
            m2, m0 = rest[0, 2], whole[0, 1] * late[1] - whole[1, 1] * late[0]
            m1 = late[0] - whole[1, 1] * m2 + whole[0, 1] * rest[1, 2]
            numbers = alpha, beta, steps, m2, m0, gamma, mpf(0), loss, m2 + m1 + m0
            return max(fractional_sizes(*numbers)) - 1

        low = d
        while outside(low + 0.5) < 0:
            low += 0.5
        found: mpf = mpmath.findroot(outside, (low, low + 0.5), tol=1e-40, verify=False)
        return found - d
