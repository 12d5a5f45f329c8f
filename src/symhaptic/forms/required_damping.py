r"""What a wall needs at one angle, and how that changes with the angle, without 0/0 at 0.

With :math:`\psi=\theta/2` and :math:`N=2(k+1)` straight motions need, at a whole delay of k
periods, the damping :math:`n=\alpha\sin((2k+1)\psi)/(2\sin\psi)-\beta\cos N\psi`; between whole
delays n is the mean of both and all motions need :math:`b` with
:math:`b^2-bn-\varepsilon(1-\varepsilon)s/4=0`, :math:`s=\alpha^2\cos^2\psi+(\alpha+2\beta)^2
\sin^2\psi`; chapter s6d_fractional_passivity.

Where the walls end that are worst at an angle :math:`\theta=2\psi`: no wall with
:math:`\alpha\ge0` and :math:`\alpha/2+\beta\ge0` needs most beyond the first angle at which mere
damping is in phase with its delay, where :math:`(1-\varepsilon)\sin(\ell+1)\theta+\varepsilon
\sin(\ell+2)\theta` vanishes (s6d_fractional_passivity; a spring is in phase earlier).  This angle
is at most :math:`\pi/(\ell+1)`, and so far mere damping, :math:`\beta=1`, has one maximum.  Its b
is the positive root of :math:`F=b^2+b((1-\varepsilon)\cos(\ell+1)\theta+\varepsilon
\cos(\ell+2)\theta)-\varepsilon(1-\varepsilon)\sin^2\psi`, with
:math:`F_\theta/\sin\theta=-b((\ell+1)(1-\varepsilon)U_\ell+(\ell+2)\varepsilon U_{\ell+1})
-\varepsilon(1-\varepsilon)/2`.  Chebyshev's :math:`U_\ell` and :math:`U_{\ell+1}` of
:math:`\cos\theta` do not rise up to :math:`\pi/(\ell+1)`, so that F first falls and then rises for
every b, and the angles that need more than b are one interval.  Behind that maximum both mere
damping and the wall :math:`\beta=-\alpha/2` need less at larger angles: no wall is found there.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy import Expr, Symbol, cos, sin

from symhaptic.forms.entire import Chord, CosNext, Sinc, SinNext
from symhaptic.forms.response import Compensated, closed
from symhaptic.model import fractional, passivity
from symhaptic.notation import B, K, T, alpha, b, beta, d, delta, epsilon, l, phi, psi, theta, w


def straight(k: Expr) -> Expr:
    """What straight motions need at a whole delay of k periods."""
    order = 2 * k + 1
    kernel = order * Sinc(order * psi) / (2 * Sinc(psi))
    return alpha * kernel - beta * CosNext(k, 2 * psi)


def steepness(k: Expr) -> Expr:
    """The derivative of that with respect to psi, over psi."""
    order = 2 * (k + 1)
    turned = (beta + alpha / 2) * order**2 * Sinc(order * psi)
    return turned - 2 * alpha * Chord(k, 2 * psi) / Sinc(psi) ** 2


def between(early: Expr, late: Expr, share: Expr = epsilon) -> Expr:
    """The mean over the two whole delays."""
    return early + share * (late - early)


class Straight(Compensated, nargs=4):
    """alpha sin((2 k + 1) psi)/(2 sin(psi)) - beta cos(2 (k + 1) psi)

    The need of straight motions, whose products are not rounded one by one.
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The need."""
        stiffness, damping, k, angle = args
        return straight(k).xreplace({alpha: stiffness, beta: damping, psi: angle})


class StraightAt(Compensated, nargs=4):
    """alpha sin((k + 1/2) theta)/(2 sin(theta/2)) - beta cos((k + 1) theta)

    The same at an angle theta of (0, pi), where the delay turns many times as well.
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The need; sin((k + 1/2) theta) is that of 2 k + 1 halves of theta."""
        stiffness, damping, k, angle = args
        kernel = SinNext(2 * k, angle / 2) / (2 * sin(angle / 2))
        return stiffness * kernel - damping * CosNext(k, angle)


class Between(Compensated, nargs=3):
    """early + epsilon (late - early)

    What is needed at the later delay stays one number.
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The mean."""
        share, early, late = args
        return between(early, late, share)


def compensated() -> Expr:
    """What straight motions need between whole delays, of these two."""
    both = (Straight(alpha, beta, k, psi) for k in (l, l + 1))
    return Between(epsilon, *both)


def extra() -> Expr:
    """epsilon (1 - epsilon) s, by which a motion that is not straight gains."""
    square = (alpha * cos(psi)) ** 2 + ((alpha + 2 * beta) * sin(psi)) ** 2
    return epsilon * (1 - epsilon) * square


def rising(need: Expr, steep: Expr) -> Expr:
    """Has the sign of the derivative of the need, at a fraction of a period."""
    return need * steep + 2 * epsilon * (1 - epsilon) * beta * (alpha + beta) * Sinc(2 * psi)


def required(straight_needs: Expr | None = None) -> Expr:
    """The damping that all motions need at an angle, at a fraction of a period."""
    n = between(straight(l), straight(l + 1)) if straight_needs is None else straight_needs
    return (n + sp.sqrt(n * n + extra())) / 2


def straight_at() -> Expr:
    """What straight motions need between two whole delays, of one sine and one cosine.

    With S and C of (l + 1) theta the mean of sin((2 l + 1) psi) and sin((2 l + 3) psi) is
    S cos(psi) + (2 epsilon - 1) C sin(psi).
    """
    sine, cosine = SinNext(l, theta), CosNext(l, theta)
    half = theta / 2
    push = 2 * cos(half) ** 2 * sine / sin(theta) + (2 * epsilon - 1) * cosine
    later = cos(theta) * cosine - sin(theta) * sine
    return alpha * push / 2 - beta * between(cosine, later)


class RequiredAt(Compensated, nargs=5):
    """(n + sqrt(n^2 + epsilon (1 - epsilon) ((alpha cos(theta/2))^2 + ((alpha + 2 beta)
    sin(theta/2))^2)))/2, n = alpha ((1 - epsilon) sin((l + 1/2) theta) + epsilon sin((l + 3/2)
    theta))/(2 sin(theta/2)) - beta ((1 - epsilon) cos((l + 1) theta) + epsilon cos((l + 2)
    theta))

    The damping that all motions need at an angle of (0, pi), at a fraction of a period.  Of
    (alpha, beta, l, epsilon, theta).
    """

    @classmethod
    def definition(cls, *args: Expr) -> Expr:
        """The positive solution b of b^2 - b n - epsilon (1 - epsilon) s/4 = 0."""
        found = required(w).xreplace({psi: theta / 2, w: straight_at()})
        return found.xreplace(cls._known(args))

    @classmethod
    def terms(cls, *args: Expr) -> tuple[Expr, ...]:
        """n, as at a whole delay; its two halves are one of n and one of a root."""
        return (straight_at().xreplace(cls._known(args)),)

    @staticmethod
    def _known(args: tuple[Expr, ...]) -> dict[Expr, Expr]:
        return dict(zip((alpha, beta, l, epsilon, theta), args, strict=True))


def favours(need: Expr) -> Expr:
    """Has the sign of the derivative of the need with respect to beta."""
    along = between(CosNext(l, 2 * psi), CosNext(l + 1, 2 * psi))
    return epsilon * (1 - epsilon) * (alpha + 2 * beta) * sin(psi) ** 2 - need * along


@cache
def derived() -> tuple[tuple[Expr, Expr], ...]:
    """Pairs that are equal: these, and the same from the energy that a motion extracts."""
    units = {K: alpha, B: beta, T: sp.S.One, b: delta, theta: 2 * psi}
    whole, later = (passivity.dirichlet_form().xreplace(units).subs(d, k) for k in (l, l + 1))
    margin = fractional.margin().xreplace(units)
    n, steep = (between(f(l), f(l + 1)) for f in (straight, steepness))
    return (
        (straight(l), whole),
        (closed(compensated()), between(whole, later)),
        (psi * steepness(l), whole.diff(psi)),
        (delta**2 - delta * n - extra() / 4, margin),
        (psi * rising(delta, steep), -margin.diff(psi)),
        (favours(delta), -margin.diff(beta)),
    )


@cache
def derived_at() -> tuple[tuple[Expr, Expr], ...]:
    """Pairs that are equal: n at an angle, and what the need at this angle leaves of the energy."""
    units = {K: alpha, B: beta, T: sp.S.One, b: delta}
    whole, later = (passivity.dirichlet_form().xreplace(units).subs(d, k) for k in (l, l + 1))
    size = extra().xreplace({psi: theta / 2})
    need = required(w).xreplace({psi: theta / 2})
    return (
        (straight_at(), between(whole, later)),
        (delta**2 - delta * straight_at() - size / 4, fractional.margin().xreplace(units)),
        (need**2 - need * w - size / 4, sp.S.Zero),
    )


def of_size_one() -> dict[Symbol, Expr]:
    """The wall with (l + 1) alpha = cos(phi) and beta + alpha/2 = sin(phi)."""
    return {alpha: cos(phi) / (l + 1), beta: sin(phi) - cos(phi) / (l + 1) / 2}


ARGUMENTS: tuple[Symbol, ...] = (alpha, beta, l, epsilon, psi)
"""What these are made of."""
