"""The stiffest walls to many digits, by mpmath."""

import mpmath
import pytest
from flint import arb, ctx
from sympy import Rational, S, pi, tan

from symhaptic.bounds.walls import over, passive, undelayed

STIFF, DAMPED = Rational(1, 1000), Rational(1, 50)


def curve(theta, gamma, delta, delay):
    """alpha of the wall that is -z^d/P(z), with P from mpmath's matrix exponential."""
    moved = mpmath.expm(mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]), method="taylor")
    z = mpmath.expj(theta)
    free, push = moved[:2, :2], moved[:2, 2]
    p = mpmath.lu_solve(z * mpmath.eye(2) - free, push)[0]
    q = -(z**delay) / p
    return q.real - q.imag * (1 - mpmath.cos(theta)) / mpmath.sin(theta)


def tip(gamma, delta, delay, near):
    """The maximum of that curve next to an angle, to 40 digits."""
    with mpmath.workdps(60):
        g, dl = mpmath.mpf(gamma.p) / gamma.q, mpmath.mpf(delta.p) / delta.q

        def slope(theta):
            return mpmath.diff(lambda x: curve(x, g, dl, delay), theta)

        return curve(mpmath.findroot(slope, mpmath.mpf(near)), g, dl, delay)


@pytest.mark.parametrize("gamma", [S.Zero, STIFF])
def test_undelayed_is_the_maximum_that_mpmath_finds(gamma):
    value = undelayed(gamma, DAMPED).ball
    with mpmath.workdps(60), ctx.workprec(256):
        there = arb(mpmath.nstr(tip(gamma, DAMPED, 0, 1.154), 45))
        # 1e-30: mpmath's numerical derivative at the tip, squared by the parabola
        assert abs(value - there) < arb("1e-30")
        assert value.rad() < arb("1e-30")


def test_over_keeps_the_digits():
    assert over(passive(DAMPED, 1), tan(pi / 8)).ball.overlaps(arb("0.04"))
