r"""Entire functions of the device's two parameters: what a sampled mass with spring and damper has.

With :math:`w=\delta^2/4-\gamma` and both poles p, q, where p + q = delta and p q = gamma.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr, cosh, exp, factorial, sinh, sqrt

from symhaptic.forms.entire import Entire


def _motion(gamma: Expr, delta: Expr) -> tuple[Expr, Expr]:
    """C(w) and S(w) of w = delta^2/4 - gamma, written with c = sqrt(delta^2 - 4 gamma)."""
    half = sqrt(delta**2 - 4 * gamma) / 2
    return cosh(half), sinh(half) / half


def _complete(k: int, gamma: Expr, delta: Expr) -> Expr:
    """Sum of p^i q^(k-i), for p + q = delta and p q = gamma."""
    before, now = sp.S.Zero, sp.S.One
    for _ in range(k):
        before, now = now, delta * now - gamma * before
    return sp.expand(now)


class PlantN1(Entire):
    """n_1: where a unit force, held for a period, has moved the device; never negative.

    It and n_0 nearly vanish where a device with little damping has swung k turns, at
    gamma = (2 pi k)^2; export/routines/device.py has their form there.
    """

    nargs = 2
    meaning = "(1 - exp(-delta/2) (C(w) + delta/2 S(w)))/gamma, w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """(1 - exp(-delta/2) (C(w) + delta/2 S(w)))/gamma."""
        even, odd = _motion(gamma, delta)
        return (1 - exp(-delta / 2) * (even + delta / 2 * odd)) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The complete symmetric polynomial of degree k in both poles, over (k+2)!."""
        return _complete(k, gamma, -delta) / factorial(k + 2)


class PlantN0(Entire):
    """n_0 = exp(-delta) PlantN1(gamma, -delta): the same device, its time reversed."""

    nargs = 2
    meaning = "exp(-delta) PlantN1(gamma, -delta)"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta) PlantN1(gamma, -delta)."""
        return exp(-delta) * PlantN1.definition(gamma, -delta)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The product of two power series, by total degree in both poles."""
        parts = (
            (-delta) ** j / factorial(j) * PlantN1.term(k - j, gamma, -delta) for j in range(k + 1)
        )
        return sp.expand(sp.Add(*parts))


class NumeratorAtOne(Entire):
    """n_1 + n_0 = exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4)."""

    nargs = 2
    meaning = (
        "exp(-delta/2) sinhc((delta + c)/4) sinhc((delta - c)/4), sinhc(x) = sinh(x)/x, "
        "c = sqrt(delta^2 - 4 gamma)"
    )

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """4 exp(-delta/2) sinh((delta + c)/4) sinh((delta - c)/4)/gamma."""
        c = sqrt(delta**2 - 4 * gamma)
        return 4 * exp(-delta / 2) * sinh((delta + c) / 4) * sinh((delta - c) / 4) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The sum of those of PlantN1 and PlantN0."""
        return sp.expand(PlantN1.term(k, gamma, delta) + PlantN0.term(k, gamma, delta))


class NumeratorGap(Entire):
    """(n_1 - n_0)/delta: exp(-delta/2) times the divided difference of S at delta^2/4 and w."""

    nargs = 2
    meaning = "exp(-delta/2) (S(delta^2/4) - S(w))/gamma, w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """exp(-delta/2) (S(delta^2/4) - S(w))/gamma, where sinh(delta/2)/(delta/2) is S(..)."""
        whole = sinh(delta / 2) / (delta / 2)
        return exp(-delta / 2) * (whole - _motion(gamma, delta)[1]) / gamma

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """By total degree in both poles, from the difference of PlantN1 and PlantN0."""
        apart = PlantN1.term(k + 1, gamma, delta) - PlantN0.term(k + 1, gamma, delta)
        return sp.expand(sp.cancel(apart / delta))


class PlantTrace(Entire):
    """a = 2 exp(-delta/2) C(w), the sum of the poles of the sampled device."""

    nargs = 2
    meaning = "2 exp(-delta/2) C(w), w = delta^2/4 - gamma"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """2 exp(-delta/2) C(w)."""
        return 2 * exp(-delta / 2) * _motion(gamma, delta)[0]

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """The sum of the k-th powers of both poles, over k!."""
        sums = [sp.S(2), -delta]
        for _ in range(k - 1):
            sums.append(-delta * sums[-1] - gamma * sums[-2])
        return sp.expand(sums[k]) / factorial(k)


class DenominatorAtMinusOne(Entire):
    """1 + a + e = 4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4)."""

    nargs = 2
    meaning = "4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4), c = sqrt(delta^2 - 4 gamma)"

    @classmethod
    def definition(cls, gamma: Expr, delta: Expr) -> Expr:
        """4 exp(-delta/2) cosh((delta + c)/4) cosh((delta - c)/4)."""
        c = sqrt(delta**2 - 4 * gamma)
        return 4 * exp(-delta / 2) * cosh((delta + c) / 4) * cosh((delta - c) / 4)

    @classmethod
    def term(cls, k: int, gamma: Expr, delta: Expr) -> Expr:
        """1 + a + e, term by term."""
        first = 1 if k == 0 else 0
        return sp.expand(first + PlantTrace.term(k, gamma, delta) + (-delta) ** k / factorial(k))
