r"""The force that moves the sampled device, A(z)/(z M(z)) at :math:`z=e^{2j\psi}`.

Both are made of their values at 1 and -1, so that no cosines are subtracted: with cosine c and
sine s of psi, :math:`A/z=A(1)c^2-A(-1)s^2+2jsc(1-e)`, and for a whole delay, over the root of z,
:math:`M=(n_1+n_0)c^2-(n_1-n_0)s^2+2jscn_1`.  A fraction leaves m2 - m0 in place of n1 and
m2 - m1 + m0 in place of n1 - n0.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Expr, cos, sin

from symhaptic.forms.entire import Meant


class Compensated(Meant):
    """A function whose exported routine rounds less than its closed form."""

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The closed form."""
        raise NotImplementedError

    @classmethod
    def terms(cls, *args: Expr) -> tuple[Expr, ...]:
        """Terms of it that its closed form only has in parts: its last place is that of these."""
        return ()


class Response(Compensated, nargs=7):
    """part of (p c^2 - q s^2 + 2 j s c r)/(u c^2 - v s^2 + j s c x), c = cos(psi), s = sin(psi), of
    psi, p, q, r, u, v and x: the force that moves the device by exp(2 j psi k)

    Of psi, A(1), A(-1), 1 - e, n1 + n0, n1 - n0 and 2 n1.  Behind a fraction of m2 + m1 + m0,
    m2 - m1 + m0 and 2 (m2 - m0) in place of the last three.
    """

    @classmethod
    def eval(cls, *args: Expr) -> Expr | None:
        """The closed form of a device without damper, whose A(z)/z is real."""
        return cls.definition(*args) if args[3] == 0 else None


class InPhase(Response):
    """The force in phase with the motion."""

    meaning = f"the real {Response.meaning}"

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The real part."""
        return parts(*args)[0]


class Ahead(Response):
    """The force a quarter turn ahead of the motion."""

    meaning = f"the imaginary {Response.meaning}"

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The imaginary part."""
        psi = args[0]
        return sin(psi) * cos(psi) * parts(*args)[1]


class FractionalNumeratorGap(Compensated, nargs=8):
    """first - last + turned - 2 epsilon (1 - epsilon) (x y + x_low y + x y_low)

    M at z = -1 behind a fraction of a period, whose square the boundary has near pi.  Of epsilon,
    what an impulse moves in the period's rest and in its beginning, each with what its last
    rounding took, and three more terms.
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The sum."""
        epsilon, x, x_low, y, y_low, first, last, turned = args
        both = epsilon * (1 - epsilon) * (x * y + x_low * y + x * y_low)
        return first - last + turned - 2 * both

    @classmethod
    def eval(cls, *args: Expr) -> Expr | None:
        """The sum, for a device that an impulse moves by a mere number."""
        return cls.definition(*args) if args[1].is_number else None


class HalfTurned(Compensated, nargs=4):
    """the first number, which is M(-1) of the device behind a fraction of a period

    Of (found, gamma, delta, epsilon).  Near an odd number of half turns in a period its terms
    cancel; the routine takes the formula :func:`symhaptic.forms.fractional_delay.half_turned`
    there, which is a sum of small terms.
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The number itself."""
        return args[0]


class KickLow(Compensated, nargs=2):
    """what the last rounding of Kick takes"""

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """0."""
        return sp.S.Zero


def parts(
    psi: Expr,
    at_one: Expr,
    at_minus_one: Expr,
    loss: Expr,
    together: Expr,
    apart: Expr,
    across: Expr,
) -> tuple[Expr, Expr]:
    """The real part, and the imaginary part over cos(psi) sin(psi)."""
    c, s = cos(psi), sin(psi)
    above, above_j = at_one * c**2 - at_minus_one * s**2, 2 * loss
    below = together * c**2 - apart * s**2
    flat = (s * c) ** 2  # the imaginary parts are without s c
    size = below**2 + flat * across**2
    real = (above * below + flat * above_j * across) / size
    return real, (above_j * below - above * across) / size


@cache
def closed(expr: Expr) -> Expr:
    """The expression with closed forms in place of these functions."""
    return expr.replace(lambda e: isinstance(e, Compensated), lambda e: e.definition(*e.args))
