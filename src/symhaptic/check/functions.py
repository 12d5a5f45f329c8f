"""The package's own functions, in dimensionless parameters: exact values in balls."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from flint import acb_poly, arb

from symhaptic.bench import verdicts
from symhaptic.bench.exact import EXACT
from symhaptic.check.checked import (
    ANGLE,
    DAMPER,
    DAMPING,
    DELAY,
    DELTA,
    FEW,
    FLAT,
    FRACTION,
    GAMMA,
    SPRING,
    STIFFNESS,
    Checked,
)
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.linear import linear_limit
from symhaptic.numeric.passivity import (
    is_passive,
    max_passive_stiffness,
    passivity_boundary,
    passivity_margin,
    passivity_margin_at,
)
from symhaptic.numeric.plant import discretize, discretize_fractional
from symhaptic.numeric.stability import is_stable, unstable_roots
from symhaptic.numeric.tracing.extremes import max_stable_stiffness
from symhaptic.numeric.tracing.margin import delay_margin


def _stable(alpha: float, beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """Jury's table in balls; None where they cannot tell."""
    return (verdicts.table(verdicts.polynomial(alpha, beta, gamma, delta, int(d))),)


def _roots(alpha: float, beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """All roots in balls, counted where they are told from the unit circle."""
    row = verdicts.polynomial(alpha, beta, gamma, delta, int(d))
    try:
        roots = acb_poly([c.mid() for c in reversed(row)]).roots()
    except ValueError:  # a double root has no ball of its own
        return (None,)
    sizes = [abs(root) for root in roots]
    told = all(size > 1 or size < 1 for size in sizes)
    return (arb(sum(size > 1 for size in sizes)) if told else None,)


def _polynomial_near(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    n1, n0, a, e = discretize(gamma, delta)
    wall = alpha + beta
    return np.ones_like(a), -a, e + n1 * wall, n0 * wall - n1 * beta, -n0 * beta


def _polynomial_size(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    wall = abs(alpha) + abs(beta)
    return 1.0, 2.0, 1 + wall, wall, abs(beta)


def _passive(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    (margin,) = EXACT["passivity_margin"](alpha, beta, delta, d)
    return (True if margin >= 0 else False if margin < 0 else None,)


def _wall_size(alpha: Any, beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    return (np.maximum(np.maximum(abs(alpha) * (d + 1), abs(beta)), delta),)


_LONGEST = 12
"""Periods up to which a delay margin is looked at: a table in balls grows with them."""

_BESIDE = 1e-11


def _delay_margin(alpha: float, beta: float, gamma: float, delta: float) -> tuple[Any, ...]:
    """Around the package's own margin: stable just before, by balls, and not just behind."""
    if not all(delayed_stable(alpha, beta, gamma, delta, 0.0)):
        return (None,)
    at = float(delay_margin(alpha, beta, gamma, delta))
    if not 1e-6 < at < _LONGEST:
        return (None,)
    before = delayed_stable(alpha, beta, gamma, delta, at * (1 - _BESIDE))
    behind = delayed_stable(alpha, beta, gamma, delta, at * (1 + _BESIDE))
    return (arb(at, at * _BESIDE) if before == (True,) and behind == (False,) else None,)


def delayed_stable(
    alpha: float, beta: float, gamma: float, delta: float, delay: float
) -> tuple[bool | None, ...]:
    """Whether the loop is stable at a delay of any length, as :func:`verdicts.table` tells."""
    whole = math.floor(delay)
    m2, m1, m0, a, e = EXACT["discretize_fractional"](gamma, delta, delay - whole)
    wall, moved = (arb(alpha) + beta, -arb(beta)), (m2, m1, m0)
    row = [arb(1), -a, e, *[arb(0)] * (whole + 2)]
    for i, force in enumerate(wall):
        for j, way in enumerate(moved):
            row[len(row) - 4 + i + j] += force * way
    return (verdicts.table(row),)


FUNCTIONS = (
    Checked(
        "discretize",
        {"gamma": GAMMA, "delta": DELTA},
        ("n1", "n0", "a", "e"),
        EXACT["discretize"],
        discretize,
        lambda gamma, delta: (0.5, 0.5, 2.0, 0.0),
        printed="eq14",
    ),
    Checked(
        "discretize_fractional",
        {"gamma": GAMMA, "delta": DELTA, "epsilon": FRACTION},
        ("m2", "m1", "m0", "a", "e"),
        EXACT["discretize_fractional"],
        discretize_fractional,
        lambda gamma, delta, epsilon: (0.5, 1.0, 0.5, 2.0, 0.0),
    ),
    Checked(
        "characteristic_polynomial",
        {"alpha": STIFFNESS, "beta": DAMPING, "gamma": GAMMA, "delta": DELTA},
        ("z4", "z3", "z2", "z1", "z0"),
        EXACT["characteristic_polynomial"],
        _polynomial_near,
        _polynomial_size,
        printed="eq18",
    ),
    Checked(
        "is_stable",
        {"alpha": STIFFNESS, "beta": DAMPING, "gamma": SPRING, "delta": DAMPER, "d": FEW},
        ("stable",),
        _stable,
        lambda *wall: (is_stable(*wall),),
        whole=("d",),
    ),
    Checked(
        "unstable_roots",
        {"alpha": STIFFNESS, "beta": DAMPING, "gamma": SPRING, "delta": DAMPER, "d": FEW},
        ("roots",),
        _roots,
        lambda *wall: (unstable_roots(*wall),),
        whole=("d",),
        balls=500,
    ),
    Checked(
        "stability_boundary",
        {"theta": ANGLE, "gamma": SPRING, "delta": DAMPER, "d": DELAY},
        ("alpha", "beta"),
        EXACT["stability_boundary"],
        stability_boundary,
        lambda theta, gamma, delta, d: ((4 + gamma) * (d + 1) / np.sin(theta),) * 2,
        balls=1000,
    ),
    Checked(
        "max_stable_stiffness",
        {"gamma": (0.0, 0.5, (1e-3,)), "delta": DAMPER, "d": FEW},
        ("alpha", "beta", "theta"),
        EXACT["max_stable_stiffness"],
        max_stable_stiffness,
        lambda gamma, delta, d: (1.0, FLAT, FLAT),
        ("d",),
        balls=300,
        flat=("beta", "theta"),
    ),
    Checked(
        "delay_margin",
        {"alpha": (1e-4, 1.0, ()), "beta": (0.0, 1.0, ()), "gamma": SPRING, "delta": DAMPER},
        ("d",),
        _delay_margin,
        None,  # of many points it takes longer than most of what is checked
        balls=60,
    ),
    Checked(
        "is_passive",
        {"alpha": STIFFNESS, "beta": DAMPING, "delta": DAMPER, "d": DELAY},
        ("passive",),
        _passive,
        lambda *wall: (is_passive(*wall),),
        whole=("d",),
        balls=1000,
    ),
    Checked(
        "passivity_margin",
        {"alpha": (0.0, 3.0, (1e-8,)), "beta": DAMPING, "delta": DAMPER, "d": DELAY},
        ("margin",),
        EXACT["passivity_margin"],
        lambda *wall: (passivity_margin(*wall),),
        _wall_size,
        whole=("d",),
        balls=1000,
    ),
    Checked(
        "passivity_margin_at",
        {"theta": ANGLE, "alpha": STIFFNESS, "beta": DAMPING, "delta": DAMPER, "d": DELAY},
        ("margin",),
        EXACT["passivity_margin_at"],
        lambda *wall: (passivity_margin_at(*wall),),
        lambda theta, *wall: _wall_size(*wall),
        whole=("d",),
    ),
    Checked(
        "passivity_boundary",
        {"theta": ANGLE, "delta": DAMPER, "d": DELAY},
        ("alpha", "beta"),
        EXACT["passivity_boundary"],
        passivity_boundary,
        lambda theta, delta, d: (delta, delta),
        ("d",),
        printed="eq27",
    ),
    Checked(
        "max_passive_stiffness",
        {"delta": DELTA, "d": DELAY},
        ("alpha", "beta", "theta"),
        EXACT["max_passive_stiffness"],
        max_passive_stiffness,
        lambda delta, d: (0.0, delta, 0.0),
        ("d",),
        printed="eq11",
    ),
    Checked(
        "linear_limit",
        {"beta": (-4.0, 4.0, ()), "delta": DELTA, "d": DELAY},
        ("alpha",),
        EXACT["linear_limit"],
        lambda *wall: (linear_limit(*wall),),
        lambda beta, delta, d: (np.maximum(abs(beta), abs(delta)) / (d + 0.5),),
        printed="eq25",
    ),
)
