"""What a wall takes for the velocity of the device.

The position is sampled; the paper takes (x_k - x_(k-1))/T.  Most controllers filter that
difference, and the filter is late: it costs stiffness.  Each part says its ratio V(z), the
velocity in units of 1/T over the position, as numerator and denominator.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from symhaptic.loops.number import (
    Number,
    Polynomial,
    all_inside,
    power_of_z,
    product,
    scaled,
    total,
)
from symhaptic.notation.quantities import decimal, nearest, number, shown


class Ratio(NamedTuple):
    """numerator/(z^late denominator), with polynomials in w = z - 1."""

    numerator: Polynomial
    denominator: Polynomial
    late: int = 0

    def times(self, other: Ratio) -> Ratio:
        """The product, nothing cancelled."""
        return Ratio(
            product(self.numerator, other.numerator),
            product(self.denominator, other.denominator),
            self.late + other.late,
        )


DIFFERENCE = Ratio((0, 1), (1,), 1)
"""1 - 1/z, the difference of two samples."""


def exponential_average(pole: Number) -> Ratio:
    """(1 - f) z/(z - f): v_k = f v_(k-1) + (1 - f) times the new difference."""
    return Ratio((1 - pole, 1 - pole), (1 - pole, 1))


def bilinear(tau: Number) -> Ratio:
    """1/(tau s + 1) by Tustin's rule s = 2 (z - 1)/(z + 1), with tau in periods."""
    return Ratio((2, 1), (2, 1 + 2 * tau))


def backward_second_order(tau: Number, damping_ratio: Number) -> Ratio:
    """1/(tau^2 s^2 + 2 D tau s + 1) with s = 1 - 1/z; both times z^2."""
    z, middle = (1, 1), 2 * damping_ratio * tau
    below = total(scaled(tau**2, (0, 0, 1)), scaled(middle, product((0, 1), z)))
    return Ratio(product(z, z), total(below, product(z, z)))


def bilinear_second_order(tau: Number, damping_ratio: Number) -> Ratio:
    """The same with s = 2 (z - 1)/(z + 1), times (z + 1)^2 above and below."""
    sum_, middle = (2, 1), 4 * damping_ratio * tau
    below = total(scaled(4 * tau**2, (0, 0, 1)), scaled(middle, product((0, 1), sum_)))
    return Ratio(product(sum_, sum_), total(below, product(sum_, sum_)))


def average(samples: int) -> Ratio:
    """(1 + 1/z + ... + z^(1-n))/n, the mean of n differences."""
    above: Polynomial = ()
    for each in range(samples):
        above = total(above, power_of_z(each))
    return Ratio(above, (samples,), samples - 1)


class Velocity:
    """What a wall takes for the velocity; the base of the parts in this file."""

    @property
    def over(self) -> int:
        """Of a difference over many samples, how many; 0 of others."""
        return 0

    def sizes(self, period: float) -> dict[str, float]:
        """Dimensionless parameters by their formulas; 0 for one that is absent."""
        return {}

    def ratio(self, period: float) -> Ratio:
        """V(z) for a sampling period in s."""
        raise NotImplementedError

    @property
    def words(self) -> str:
        """What a person reads of it."""
        raise NotImplementedError


@dataclass(frozen=True)
class Difference(Velocity):
    """Difference of two samples over the period, (x_k - x_(k-1))/T, as in the paper."""

    def ratio(self, period: float) -> Ratio:
        """V(z) for a sampling period in s."""
        return DIFFERENCE

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return "difference of two samples"


_MAPPINGS = ("backward Euler", "Tustin", "exact pole")


@dataclass(frozen=True, kw_only=True)
class LowPass(Velocity):
    """Difference of two samples with a low-pass filter of first or second order.

    Parameters
    ----------
    cutoff : float or str, optional
        Cut-off frequency in Hz, > 0: 1/(2 pi tau).
    time_constant : float or str, optional
        tau in s, >= 0.
    weight : float, optional
        Weight of the new difference in an exponential average, 0 < weight <= 1; the pole of the
        filter is 1 - weight.  Exactly one of the three is given.
    order : int
        1 for 1/(tau s + 1), 2 for 1/(tau^2 s^2 + 2 D tau s + 1).
    damping_ratio : float
        D of the second order, > 0; 1/sqrt(2) is Butterworth's filter.
    mapping : str
        How the filter becomes a difference equation: ``"backward Euler"``, ``"Tustin"`` (without
        prewarping), or, for the first order, ``"exact pole"``, exp(-T/tau).

    Raises
    ------
    ValueError
        If none or several of the first three are given, or a value is out of its range.

    Notes
    -----
    Of first order, backward Euler and the exact pole are the exponential average
    v_k = f v_(k-1) + (1 - f)(x_k - x_(k-1))/T, with f = tau/(tau + T) and f = exp(-T/tau).

    Examples
    --------
    >>> LowPass(weight=0.25).pole(period=0.001)
    0.75
    >>> round(LowPass(cutoff=50).pole(period=0.00035), 6)  # tau = 3.183 ms
    0.900937
    """

    cutoff: float | None = None
    time_constant: float | None = None
    weight: float | None = None
    order: int = 1
    damping_ratio: float = math.sqrt(0.5)
    mapping: str = "backward Euler"

    def __post_init__(self) -> None:
        sizes = {"cutoff": ("Hz", "> 0"), "time_constant": ("s", ">= 0"), "weight": ("", "> 0")}
        given = [name for name in sizes if getattr(self, name) is not None]
        if len(given) != 1:
            said = ", ".join(f"{name}={getattr(self, name)!r}" for name in given) or "nothing"
            raise ValueError(
                f"cutoff: {said} is not allowed; give exactly one of cutoff, time_constant "
                "and weight"
            )
        (name,) = given
        value = number(name, getattr(self, name), *sizes[name])
        object.__setattr__(self, name, value)
        if name == "weight" and value > 1:
            raise ValueError(f"weight: {value!r} is not allowed; give a number 0 < weight <= 1")
        if self.mapping not in _MAPPINGS:
            allowed = ", ".join(map(repr, _MAPPINGS))
            raise ValueError(f"mapping: {shown(self.mapping)} is not allowed; give {allowed}")
        if self.order not in (1, 2) or isinstance(self.order, bool):
            raise ValueError(f"order: {shown(self.order)} is not allowed; give 1 or 2")
        ratio = number("damping_ratio", self.damping_ratio, "", "> 0")
        object.__setattr__(self, "damping_ratio", ratio)
        if self.order == 2 and (self.mapping == "exact pole" or name == "weight"):
            wrong = "mapping" if self.mapping == "exact pole" else "weight"
            raise ValueError(
                f"{wrong}: {getattr(self, wrong)!r} does not fit a filter of second order; "
                "give cutoff or time_constant, and 'backward Euler' or 'Tustin'"
            )
        if name == "weight" and self.mapping != "backward Euler":
            raise ValueError(
                f"mapping: {self.mapping!r} does not fit weight={value!r}; "
                "leave the mapping out: the weight defines the difference equation"
            )

    def tau(self, period: float) -> float:
        """The time constant in sampling periods."""
        if self.weight is not None:
            return (1 - self.weight) / self.weight
        if self.time_constant is not None:
            return self.time_constant / period
        assert self.cutoff is not None
        return 1 / (2 * math.pi * self.cutoff * period)

    def sizes(self, period: float) -> dict[str, float]:
        """tau/T, and the damping ratio of the second order."""
        return {"tau/T": self.tau(period), "D": self.damping_ratio if self.order == 2 else 0.0}

    def pole(self, period: float) -> float:
        """The pole f of the exponential average for a sampling period in s."""
        tau = self.tau(period)
        if self.mapping == "exact pole":
            return math.exp(-1 / tau) if tau else 0.0
        return tau / (1 + tau)

    def ratio(self, period: float) -> Ratio:
        """V(z) for a sampling period in s."""
        tau = self.tau(period)
        if tau == 0:  # where Tustin's rule has a common root at z = -1 above and below
            return DIFFERENCE
        if self.order == 2:
            make = bilinear_second_order if self.mapping == "Tustin" else backward_second_order
            filtered = make(tau, self.damping_ratio)
        elif self.mapping == "Tustin":
            filtered = bilinear(tau)
        else:  # the filter's z cancels the z of the difference
            new = -math.expm1(-1 / tau) if self.mapping == "exact pole" else 1 / (1 + tau)
            return Ratio((0, new), (new, 1))
        if self.mapping == "backward Euler":  # z^2 over z: one z is left
            return Ratio((0, 1, 1), filtered.denominator)
        return DIFFERENCE.times(filtered)

    @property
    def words(self) -> str:
        """What a person reads of it."""
        value, unit = next(
            (v, u)
            for v, u in ((self.cutoff, "Hz"), (self.time_constant, "s"), (self.weight, ""))
            if v is not None
        )
        if self.weight is not None:
            return f"difference filtered by an exponential average of weight {value:g}"
        order = "first" if self.order == 1 else "second"
        return (
            f"difference filtered by a low-pass of {order} order, {value:g} {unit}, {self.mapping}"
        )


def _count(name: str, value: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= _LONGEST:
        raise ValueError(
            f"{name}: {shown(value)} is not allowed; give a whole number from 1 to {_LONGEST}"
        )
    return value


_LONGEST = 200
"""Samples of the longest mean: beyond, the roots of its polynomial are too many to be quick."""


@dataclass(frozen=True)
class Window(Velocity):
    """Difference of two positions that are several periods apart, (x_k - x_(k-n))/(n T).

    Parameters
    ----------
    samples : int
        The number n of periods, >= 1.
    """

    samples: int

    def __post_init__(self) -> None:
        _count("samples", self.samples)

    @property
    def over(self) -> int:
        """How many samples."""
        return self.samples

    def ratio(self, period: float) -> Ratio:
        """V(z) for a sampling period in s."""
        return DIFFERENCE.times(average(self.samples))

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"difference over {self.samples} samples"


@dataclass(frozen=True)
class Average(Window):
    """Mean of the last differences of two samples.

    Parameters
    ----------
    samples : int
        The number of differences, >= 1.

    Notes
    -----
    All but the first and the last position cancel, so it equals :class:`Window`.
    """

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"mean of {self.samples} differences"


@dataclass(frozen=True)
class Filter(Velocity):
    """Difference of two samples with any linear filter, given by its coefficients.

    Parameters
    ----------
    numerator, denominator : sequence of float
        Coefficients in powers of 1/z, as controllers have them.  The filter must be stable, and
        pass a constant as it is: the sums of both are alike.

    Examples
    --------
    >>> Filter([0.25], [1, -0.75]) == Filter((0.25,), (1.0, -0.75))  # LowPass(weight=0.25)
    True
    """

    numerator: Sequence[float]
    denominator: Sequence[float] = (1.0,)

    def __post_init__(self) -> None:
        for name in ("numerator", "denominator"):
            given = getattr(self, name)
            several = hasattr(given, "__len__") and not isinstance(given, str)
            if not several or not 1 <= len(given) <= _TERMS:
                raise ValueError(
                    f"{name}: {shown(given)} is not allowed; give 1 to {_TERMS} numbers"
                )
            object.__setattr__(self, name, tuple(number(name, each, "") for each in given))
        if self.denominator[0] == 0:
            raise ValueError("denominator: its first number is 0; give the factor of v_k there")
        above, below = (sum(map(decimal, each)) for each in (self.numerator, self.denominator))
        if below == 0 or abs(above / below - 1) > 1e-9:
            raise ValueError(
                f"numerator: {shown(self.numerator)} over {shown(self.denominator)} turns a "
                "constant into another one; give coefficients with the same sum"
            )
        if max(map(abs, self.numerator)) > _LARGEST * abs(self.denominator[0]):
            raise ValueError(
                f"numerator: {shown(self.numerator)} is not allowed; give numbers up to "
                f"{_LARGEST:g} times the first of the denominator"
            )
        if not all_inside([*map(decimal, self.denominator)]):
            raise ValueError(
                f"denominator: {shown(self.denominator)} is not allowed; give a stable filter"
            )

    def ratio(self, period: float) -> Ratio:
        """V(z) for a sampling period in s."""
        more = len(self.numerator) - len(self.denominator)
        one = decimal(self.denominator[0])
        above, below = (
            [decimal(each) / one for each in several]
            for several in (self.numerator, self.denominator)
        )
        return DIFFERENCE.times(
            Ratio(_of_delays(above, max(0, -more)), _of_delays(below, 0), max(0, more))
        )

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"difference filtered by {list(self.numerator)}/{list(self.denominator)}"


_TERMS = 7
"""Coefficients of a filter; of longer ones powers of z - 1 lose digits."""


_LARGEST = 1e6
"""Larger coefficients, which nearly cancel in their sum, lose digits."""


def _of_delays(coefficients: Sequence[float | Fraction], more: int) -> Polynomial:
    """(c_0 z^n + ... + c_n) z^more in powers of w.

    The sums are exact, because near z = 1 little is left of large coefficients.
    """
    found: Polynomial = ()
    for power, each in enumerate(reversed(coefficients), more):
        found = total(found, scaled(decimal(each), power_of_z(power)))
    return tuple(map(nearest, found))


@dataclass(frozen=True)
class Measured(Velocity):
    """Velocity of the device itself at the samples, as measured by a tachometer or simulated."""

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return "measured, not differenced"
