"""The loop in closed form, from matrix exponentials and textbook formulas, in ball arithmetic.

Each argument is a ball or a power series, so that the same formula gives values and derivatives.
Nothing here comes from the package's own forms: it is what they are measured by.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from flint import arb, arb_mat, arb_series

HALF = arb(1) / 2

SHORT = 4
"""Delays up to which the kernel of (5) is a sum of cosines, which no quotient makes wider."""


def ball(x: Any) -> Any:
    """A number as a ball; a power series as it is."""
    return x if isinstance(x, arb_series) else arb(x)


def value(x: Any) -> Any:
    """A number, or the first coefficient of a power series, as a ball."""
    return x[0] if isinstance(x, arb_series) else arb(x)


def periods(d: Any) -> int:
    """The whole periods of a delay, which is a number or one of flint's rational ones."""
    return math.floor(d) if isinstance(d, int | float) else int(d.floor())


def split(d: Any) -> tuple[int, Any]:
    """A delay as whole periods and the fraction that is left."""
    whole = math.floor(float(value(d)))
    return whole, ball(d) - whole


def exponential(rows: list[list[Any]]) -> list[list[Any]]:
    """The exponential of a matrix; of series by that of the block matrix [[A, dA], [0, A]]."""
    n = len(rows)
    if not any(isinstance(x, arb_series) for row in rows for x in row):
        found = arb_mat(rows).exp()
        return [[found[i, j] for j in range(n)] for i in range(n)]
    block = arb_mat(2 * n, 2 * n)
    for i, row in enumerate(rows):
        for j, x in enumerate(row):
            block[i, j] = block[n + i, n + j] = value(x)
            block[i, n + j] = x[1] if isinstance(x, arb_series) else 0
    found = block.exp()
    return [[arb_series([found[i, j], found[i, n + j]], 2) for j in range(n)] for i in range(n)]


def device(gamma: Any, delta: Any) -> tuple[Any, ...]:
    """n1, n0, a and e of the sampled device."""
    g, dl = ball(gamma), ball(delta)
    m = exponential([[0, 1, 0], [-g, -dl, 1], [0, 0, 0]])
    return m[0][2], m[0][1] * m[1][2] - m[1][1] * m[0][2], m[0][0] + m[1][1], (-dl).exp()


def delayed(gamma: Any, delta: Any, part: Any) -> tuple[Any, ...]:
    """m2, m1, m0, a and e of the device whose force changes inside the period."""
    g, dl, part = ball(gamma), ball(delta), ball(part)
    rows = [[0, 1, 0], [-g, -dl, 1], [0, 0, 0]]
    full, rest, begun = (exponential([[x * t for x in row] for row in rows])
                         for t in (arb(1), 1 - part, part))  # fmt: skip
    one, two = rest[0][2], rest[1][2]
    old = [rest[i][0] * begun[0][2] + rest[i][1] * begun[1][2] for i in range(2)]
    return (
        one,
        full[0][1] * two - full[1][1] * one + old[0],
        full[0][1] * old[1] - full[1][1] * old[0],
        full[0][0] + full[1][1],
        (-dl).exp(),
    )


def polynomial(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    """Coefficients of the characteristic polynomial for a delay of one period."""
    n1, n0, a, e = device(gamma, delta)
    al, be = ball(alpha), ball(beta)
    return arb(1), -a, e + n1 * (al + be), n0 * (al + be) - n1 * be, -n0 * be


def boundary(theta: Any, gamma: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """alpha and beta of the wall with a root at the angle theta."""
    whole, part = split(d)
    return curve(theta, delayed(gamma, delta, part), whole)


def curve(theta: Any, numbers: tuple[Any, ...], whole: int) -> tuple[Any, ...]:
    """The same from the numbers of the device: -z^(l+1) A/(m2 z^2 + m1 z + m0) on the circle."""
    m2, m1, m0, a, e = numbers
    theta = ball(theta)
    cosine, sine, turn = theta.cos(), theta.sin(), (whole + 1) * theta
    top, low = cosine * (1 + e) - a, (m2 + m0) * cosine + m1
    left, right = 1 - e, m2 - m0  # the imaginary parts over sin(theta)
    size = low * low + (right * sine) * (right * sine)
    ratio = (top * low + left * right * sine * sine) / size
    ahead = (left * low - top * right) / size
    wave = turn.sin() / sine if whole else 1  # so that nothing is divided by zero at pi
    beta = -(turn.cos() * ahead + wave * ratio)
    return turn.sin() * sine * ahead - turn.cos() * ratio - beta * (1 - cosine), beta


def required_damping(alpha: Any, beta: Any, whole: Any, part: Any) -> Callable[[Any], Any]:
    """(5) of the paper as a function of the angle; with a fraction, of the worst motion."""

    def straight(t: Any, d: Any) -> Any:
        if isinstance(d, int) and d <= SHORT:
            kernel = sum(((k * t).cos() for k in range(1, d + 1)), HALF)
        else:
            kernel = ((d + HALF) * t).sin() / (t * HALF).sin() * HALF
        return alpha * kernel - beta * ((d + 1) * t).cos()

    def at(t: Any) -> Any:
        if part == 0:
            return straight(t, whole)
        n = (1 - part) * straight(t, whole) + part * straight(t, whole + 1)
        sine = (t * HALF).sin()
        extra = part * (1 - part) * (alpha * alpha + 4 * beta * (alpha + beta) * sine * sine)
        return (n + (n * n + extra).sqrt()) * HALF

    return at


def required_damping_at(alpha: Any, beta: Any, whole: int, part: Any, theta: Any) -> Any:
    """The damping that (5) requires at an angle, or its limit at the angle 0."""
    if theta != 0:
        return required_damping(alpha, beta, whole, part)(theta)
    n = alpha * (part + whole + HALF) - beta
    return (n + (n * n + part * (1 - part) * alpha * alpha).sqrt()) / 2 if part != 0 else n


def margin(theta: Any, alpha: Any, beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """The damping of the device minus the damping that the wall requires at an angle."""
    wall = ball(alpha), ball(beta)
    return (ball(delta) - required_damping_at(*wall, *split(d), ball(theta)),)


def envelope(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """(27) for whole delays: where the margin and its slope vanish, two linear equations.

    NaN beyond pi/(d + 1), where the paper's extent of (27) ends.
    """
    t, n = ball(theta), ball(d) + 1
    if value(n) * value(t) > arb.pi():
        return arb("nan"), arb("nan")
    up, half = (n - HALF) * t, t / 2
    k = up.sin() / (2 * half.sin())
    k1 = (n - HALF) * up.cos() / (2 * half.sin())
    k1 = k1 - up.sin() * half.cos() / 4 / (half.sin() * half.sin())
    c, c1 = -(n * t).cos(), n * (n * t).sin()
    det = k * c1 - k1 * c
    return ball(delta) * c1 / det, -ball(delta) * k1 / det


def max_passive(delta: Any, d: Any) -> tuple[Any, ...]:
    """(11) of the paper, for whole delays."""
    n = ball(d) + 1
    angle = arb.pi() / (2 * n)
    beta = ((angle * d).sin() - d / n) / angle.sin()
    return 2 * ball(delta) * (angle / 2).tan(), ball(delta) * beta, angle


def line(beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """(25) of the paper."""
    return ((ball(beta) + ball(delta)) / (ball(d) + HALF),)
