"""Exact values in ball arithmetic, from matrix exponentials and textbook formulas.

Nothing here comes from the package's own forms: it is what they are measured by.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import flint
from flint import acb, arb

from symhaptic.bench import implicit


def device(gamma: float, delta: float) -> tuple[Any, ...]:
    """n1, n0, a and e, from the exponential of the device's matrix."""
    g, d = arb(gamma), arb(delta)
    moved = flint.arb_mat([[0, 1, 0], [-g, -d, 1], [0, 0, 0]]).exp()
    n1, trace = moved[0, 2], moved[0, 0] + moved[1, 1]
    return n1, moved[0, 1] * moved[1, 2] - moved[1, 1] * n1, trace, (-d).exp()


def late(gamma: float, delta: float, part: Any) -> tuple[Any, ...]:
    """m2, m1, m0, a and e: a force that changes inside the period, by the same exponential."""
    g, d, ep = arb(gamma), arb(delta), arb(part)
    matrix = flint.arb_mat([[0, 1, 0], [-g, -d, 1], [0, 0, 0]])
    whole, rest, begun = ((matrix * t).exp() for t in (arb(1), 1 - ep, ep))
    one, two = rest[0, 2], rest[1, 2]
    old = [rest[i, 0] * begun[0, 2] + rest[i, 1] * begun[1, 2] for i in range(2)]
    return (
        one,
        whole[0, 1] * two - whole[1, 1] * one + old[0],
        whole[0, 1] * old[1] - whole[1, 1] * old[0],
        whole[0, 0] + whole[1, 1],
        (-d).exp(),
    )


def polynomial(alpha: float, beta: float, gamma: float, delta: float) -> tuple[Any, ...]:
    """Coefficients for a delay of one period."""
    n1, n0, a, e = device(gamma, delta)
    al, be = arb(alpha), arb(beta)
    return arb(1), -a, e + n1 * (al + be), n0 * (al + be) - n1 * be, -n0 * be


def boundary(theta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """-z^(l+1) A/(m2 z^2 + m1 z + m0) on the unit circle."""
    whole = math.floor(d)
    m2, m1, m0, a, e = late(gamma, delta, d - whole)
    t = arb(theta)
    z = acb(t.cos(), t.sin())
    turn = (arb(whole) + 1) * t
    q = -acb(turn.cos(), turn.sin()) * (z * z - a * z + e) / ((m2 * z + m1) * z + m0)
    beta = q.imag / t.sin()
    return q.real - beta * (1 - t.cos()), beta


def margin(theta: float, alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """(5) of the paper in half angles; at a fraction what all motions leave."""
    if d % 1:
        whole = math.floor(d)
        wall = arb(alpha), arb(beta), whole, arb(d) - whole
        return (arb(delta) - implicit.required_damping_at(*wall, arb(theta)),)
    t, n = arb(theta), arb(d) + 1
    kernel = ((n - arb(1) / 2) * t).sin() / (2 * (t / 2).sin())
    return (arb(delta) - arb(alpha) * kernel + arb(beta) * (n * t).cos(),)


def envelope(theta: float, delta: float, d: float) -> tuple[Any, ...]:
    """Where the margin and its slope vanish: two linear equations for whole delays.

    Nothing beyond pi/(d + 1), where the paper's extent of (27) ends.
    """
    if d % 1:
        return implicit.passive(theta, delta, d)
    t, n = arb(theta), arb(d) + 1
    if n * t > arb.pi():
        return arb("nan"), arb("nan")
    up, half = (n - arb(1) / 2) * t, t / 2
    k = up.sin() / (2 * half.sin())
    k1 = (n - arb(1) / 2) * up.cos() / (2 * half.sin())
    k1 -= up.sin() * half.cos() / 4 / half.sin() ** 2
    c, c1 = -(n * t).cos(), n * (n * t).sin()
    det = k * c1 - k1 * c
    return arb(delta) * c1 / det, -arb(delta) * k1 / det


def stiffest(delta: float, d: float) -> tuple[Any, ...]:
    """(11) of the paper for whole delays."""
    if d % 1:
        return implicit.stiffest_passive(delta, d)
    n = arb(d) + 1
    angle = arb.pi() / (2 * n)
    beta = ((angle * arb(d)).sin() - arb(d) / n) / angle.sin()
    return 2 * arb(delta) * (angle / 2).tan(), arb(delta) * beta, angle


def line(beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """(25) of the paper."""
    return ((arb(beta) + arb(delta)) / (arb(d) + arb(1) / 2),)


def stiffest_stable(gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """The first maximum of alpha on the boundary."""
    return implicit.stiffest_stable(late(gamma, delta, d % 1), gamma, d)


EXACT: dict[str, Callable[..., tuple[Any, ...]]] = {
    "discretize": device,
    "discretize_fractional": late,
    "characteristic_polynomial": polynomial,
    "stability_boundary": boundary,
    "passivity_margin_at": margin,
    "passivity_boundary": envelope,
    "max_passive_stiffness": stiffest,
    "linear_limit": line,
    "passivity_margin": implicit.passivity_margin,
    "max_stable_stiffness": stiffest_stable,
}


def bits(point: Sequence[float]) -> int:
    """Enough for exponentials of the largest and cubes of the smallest argument."""
    small = max([0.0, *(-math.log2(abs(v)) for v in point if v)])
    large = max(min(abs(v), 700.0) for v in point)
    return int(200 + 3 * small + 7 * large)
