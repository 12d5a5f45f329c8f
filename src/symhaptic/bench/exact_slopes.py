"""Exact derivatives in ball arithmetic: textbook formulas in power series of one argument.

The device's come from the exponential of a block matrix, exp([[A, dA], [0, A]]).  Nothing here
comes from the package's own forms.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import flint
from flint import arb, arb_series

from symhaptic.bench import exact, implicit

Series = Any


def variables(point: dict[str, float], by: str) -> dict[str, Series]:
    """Each argument as a series, to the first power of the one that is varied."""
    return {
        name: arb_series([arb(value), arb(int(name == by))], 2) for name, value in point.items()
    }


def moved(matrix: list[list[Series]]) -> list[list[Series]]:
    """The exponential of a matrix of series, by that of the block matrix."""
    n = len(matrix)
    if all(entry[1] == 0 for row in matrix for entry in row):
        still = flint.arb_mat([[entry[0] for entry in row] for row in matrix]).exp()
        return [[arb_series([still[i, j]], 2) for j in range(n)] for i in range(n)]
    both = [[arb(0)] * (2 * n) for _ in range(2 * n)]
    for i in range(n):
        for j in range(n):
            both[i][j] = both[n + i][n + j] = matrix[i][j][0]
            both[i][n + j] = matrix[i][j][1]
    found = flint.arb_mat(both).exp()
    return [[arb_series([found[i, j], found[i, n + j]], 2) for j in range(n)] for i in range(n)]


def device(gamma: Series, delta: Series) -> tuple[Series, ...]:
    """n1, n0, a and e."""
    none, one = arb_series([0], 2), arb_series([1], 2)
    m = moved([[none, one, none], [-gamma, -delta, one], [none, none, none]])
    return m[0][2], m[0][1] * m[1][2] - m[1][1] * m[0][2], m[0][0] + m[1][1], (-delta).exp()


def polynomial(alpha: Series, beta: Series, gamma: Series, delta: Series) -> tuple[Series, ...]:
    """Coefficients for a delay of one period."""
    n1, n0, a, e = device(gamma, delta)
    al, be = alpha, beta
    return arb_series([1], 2), -a, e + n1 * (al + be), n0 * (al + be) - n1 * be, -n0 * be


def late(gamma: Series, delta: Series, part: Series) -> tuple[Series, ...]:
    """m2, m1, m0, a and e: a force that changes inside the period."""
    none, one = arb_series([0], 2), arb_series([1], 2)
    matrix = [[none, one, none], [-gamma, -delta, one], [none, none, none]]
    whole, rest, begun = (moved([[x * t for x in row] for row in matrix])
                          for t in (one, 1 - part, part))  # fmt: skip
    first, second = rest[0][2], rest[1][2]
    old = [rest[i][0] * begun[0][2] + rest[i][1] * begun[1][2] for i in range(2)]
    return (
        first,
        whole[0][1] * second - whole[1][1] * first + old[0],
        whole[0][1] * old[1] - whole[1][1] * old[0],
        whole[0][0] + whole[1][1],
        (-delta).exp(),
    )


def boundary(theta: Series, gamma: Series, delta: Series, d: Series) -> tuple[Series, ...]:
    """-z^(l+1) A/(m2 z^2 + m1 z + m0) on the unit circle, in real and imaginary parts."""
    whole = math.floor(float(d[0]))
    m2, m1, m0, a, e = late(gamma, delta, d - whole)
    cosine, sine, turn = theta.cos(), theta.sin(), (whole + 1) * theta
    top, low = cosine * (1 + e) - a, (m2 + m0) * cosine + m1
    left, right = 1 - e, m2 - m0  # the imaginary parts over sin(theta)
    size = low * low + (right * sine) * (right * sine)
    ratio = (top * low + left * right * sine * sine) / size
    ahead = (left * low - top * right) / size
    wave = turn.sin() / sine if whole else 1  # so that nothing is divided by zero at pi
    beta = -(turn.cos() * ahead + wave * ratio)
    real = turn.sin() * sine * ahead - turn.cos() * ratio
    return real - beta * (1 - cosine), beta


def margin(theta: Series, alpha: Series, beta: Series, delta: Series, d: Series) -> Any:
    """(5) of the paper in half angles; what all motions leave at a fraction, and by the delay."""
    delay = float(d[0])
    if delay % 1 or d[1] != 0:
        whole = math.floor(delay)
        need = implicit.required_damping_at(alpha, beta, whole, d - whole, theta)
        return (delta - need,)
    n = d + 1
    kernel = ((n - arb(1) / 2) * theta).sin() / (2 * (theta / 2).sin())
    return (delta - alpha * kernel + beta * (n * theta).cos(),)


def passivity_margin(alpha: Series, beta: Series, delta: Series, d: Series) -> tuple[Series, ...]:
    """The margin at its worst angle, which may be held still (envelope theorem)."""
    stiffness, damping, delay = (float(x[0]) for x in (alpha, beta, d))
    if stiffness < 0:
        return (arb_series([arb("nan")] * 2, 2),)
    whole = math.floor(delay)
    part = d - whole if delay % 1 or d[1] != 0 else 0
    _, angle = implicit.largest_required_damping(stiffness, damping, delay)
    return (delta - implicit.required_damping_at(alpha, beta, whole, part, angle),)


def envelope(theta: Series, delta: Series, d: Series) -> tuple[Series, ...]:
    """Where the margin and its slope vanish: two linear equations for whole delays."""
    if float(d[0]) % 1:
        return _scaled(implicit.passive(float(theta[0]), 1.0, float(d[0])), delta)
    t, n = theta, d + 1
    if n[0] * t[0] > arb.pi():
        return (arb_series([arb("nan")] * 2, 2),) * 2
    up, half = (n - arb(1) / 2) * t, t / 2
    k = up.sin() / (2 * half.sin())
    k1 = (n - arb(1) / 2) * up.cos() / (2 * half.sin())
    k1 = k1 - up.sin() * half.cos() / 4 / (half.sin() * half.sin())
    c, c1 = -(n * t).cos(), n * (n * t).sin()
    det = k * c1 - k1 * c
    return delta * c1 / det, -delta * k1 / det


def _scaled(wall: tuple[Any, ...], delta: Series) -> tuple[Series, ...]:
    """The wall that is just passive on a device whose damping is not 1."""
    return tuple(delta * x for x in wall[:2])


def stiffest(delta: Series, d: Series) -> tuple[Series, ...]:
    """(11) of the paper for whole delays."""
    if float(d[0]) % 1:
        *wall, angle = implicit.stiffest_passive(1.0, float(d[0]))
        return *_scaled(tuple(wall), delta), arb_series([angle], 2)
    n = d + 1
    angle = arb.pi() / (2 * n)
    beta = ((angle * d).sin() - d / n) / angle.sin()
    return 2 * delta * (angle / 2).tan(), delta * beta, angle


def stiffest_stable(gamma: Series, delta: Series, d: Series) -> tuple[Series, ...]:
    """The largest stiffness on the boundary, whose angle may be held still (envelope theorem)."""
    theta = exact.stiffest_stable(*(float(x[0]) for x in (gamma, delta, d)))[2]
    if not theta.is_finite():
        return (arb_series([theta] * 2, 2),)
    return boundary(arb_series([theta], 2), gamma, delta, d)[:1]


def line(beta: Series, delta: Series, d: Series) -> tuple[Series, ...]:
    """(25) of the paper."""
    return ((beta + delta) / (d + arb(1) / 2),)


SERIES: dict[str, Callable[..., tuple[Any, ...]]] = {
    "discretize": device,
    "discretize_fractional": lambda gamma, delta, epsilon: late(gamma, delta, epsilon),
    "characteristic_polynomial": polynomial,
    "stability_boundary": boundary,
    "passivity_margin_at": margin,
    "passivity_boundary": envelope,
    "max_passive_stiffness": stiffest,
    "linear_limit": line,
    "passivity_margin": passivity_margin,
    "max_stable_stiffness": stiffest_stable,
}


def slopes(name: str, point: dict[str, float], by: str) -> tuple[Any, ...]:
    """The derivatives of all results of a function, with respect to one argument."""
    return tuple(result[1] for result in SERIES[name](**variables(point, by)))
