"""The paper's equations in SI units: exact values in balls."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import arb

from symhaptic.bench.exact import EXACT
from symhaptic.check.checked import DAMPER, DELAY, FEW, FREQUENCY, PERIOD, B, Checked, Range
from symhaptic.numeric.passivity import max_passive_stiffness, passivity_boundary
from symhaptic.numeric.plant import discretize
from symhaptic.numeric.tracing.extremes import max_stable_stiffness

_WALL: Range = (0.0, 1e4, (1.0,))
_FORCE: Range = (-50.0, 50.0, (0.0, 1.0))
_MASS: Range = (0.1, 5.0, (1.0,))
_SPRING: Range = (0.0, 2000.0, (1e-8, 1.0))
_LATE: Range = (0.0, 0.05, (1e-3,))


def _eq5(K: Any, B: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    """The damping that the wall needs at this frequency."""
    (margin,) = EXACT["passivity_margin_at"](arb(omega) * T, arb(K) * T, B, 0.0, d)
    return (-margin,)


def _eq5_near(K: Any, B: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    half = omega * T / 2
    kernel = np.sin((2 * d + 1) * half) / (2 * np.sin(half))
    return (K * T * kernel - B * np.cos(2 * (d + 1) * half),)


def _eq7(b: float, T: float, omega: float, d: float) -> tuple[Any, ...]:
    alpha, beta = EXACT["passivity_boundary"](arb(omega) * T, b, d)
    return alpha / T, beta


def _eq7_near(b: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    alpha, beta = passivity_boundary(omega * T, b, d)
    return alpha / T, beta


def _eq9(b: Any, B: Any, T: Any, d: Any) -> tuple[Any, ...]:
    return ((arb(b) + B) / ((arb(d) + 0.5) * T),)


def _eq24(b: Any, B: Any, t_d: Any, T: Any) -> tuple[Any, ...]:
    return ((arb(b) + B) / (t_d + arb(T) / 2),)


def _eq11(b: float, T: float, d: float) -> tuple[Any, ...]:
    alpha, beta, _ = EXACT["max_passive_stiffness"](b, d)
    return alpha / arb(T), beta


def _eq11_near(b: Any, T: Any, d: Any) -> tuple[Any, ...]:
    wall = max_passive_stiffness(b, d)
    return wall.alpha / T, wall.beta


def _eq12(b: float, k: float, m: float, T: float) -> tuple[Any, ...]:
    mass, period = arb(m), arb(T)
    n1, n0, a, e = EXACT["discretize"](arb(k) * period**2 / mass, arb(b) * period / mass)
    return n1 * period**2 / mass, n0 * period**2 / mass, a, e


def _eq12_near(b: Any, k: Any, m: Any, T: Any) -> tuple[Any, ...]:
    n1, n0, a, e = discretize(k * T**2 / m, b * T / m)
    return n1 * T**2 / m, n0 * T**2 / m, a, e


def _eq12_scale(b: Any, k: Any, m: Any, T: Any) -> tuple[Any, ...]:
    size = T**2 / (2 * m)
    return size, size, 2.0, 0.0


def _eq28(k: Any, b: Any, m: Any) -> tuple[Any, ...]:
    inside = arb(k) / m - (arb(b) / m / 2) ** 2
    return (inside.sqrt() if inside >= 0 else arb("nan"),)


def _eq28_near(k: Any, b: Any, m: Any) -> tuple[Any, ...]:
    return (np.sqrt(k / m - (b / m / 2) ** 2),)


def _stiffest(m: float, b: float, k: float, T: float, d: float) -> tuple[Any, ...]:
    """Of ``Scene.max_stable_stiffness``, for whole delays."""
    size = arb(m) / arb(T) ** 2
    alpha, beta, _ = EXACT["max_stable_stiffness"](k / size, arb(b) * T / m, d)
    return alpha * size, beta * size * T


def _stiffest_near(m: Any, b: Any, k: Any, T: Any, d: Any) -> tuple[Any, ...]:
    wall = max_stable_stiffness(k * T**2 / m, b * T / m, d)
    return wall.alpha * m / T**2, wall.beta * m / T


EQUATIONS = (
    Checked(
        "eq5",
        {"K": _WALL, "B": _FORCE, "T": PERIOD, "omega": FREQUENCY, "d": DELAY},
        ("b",),
        _eq5,
        _eq5_near,
        lambda K, B, T, omega, d: (np.maximum(K * T * (d + 1), np.abs(B)),),
        ("d",),
        printed="eq5",
    ),
    Checked(
        "eq6",
        {"K": _WALL, "B": _FORCE, "T": PERIOD},
        ("b",),
        lambda K, B, T: (arb(K) * T / 2 + abs(B),),
        lambda K, B, T: (K * T / 2 + np.abs(B),),
        printed="eq6",
    ),
    Checked(
        "eq7",
        {"b": B, "T": PERIOD, "omega": FREQUENCY, "d": DELAY},
        ("K", "B"),
        _eq7,
        _eq7_near,
        lambda b, T, omega, d: (b / T, b),
        ("d",),
        printed="eq7",
    ),
    Checked(
        "eq9",
        {"b": B, "B": _FORCE, "T": PERIOD, "d": DELAY},
        ("K",),
        _eq9,
        lambda b, B, T, d: ((b + B) / ((d + 0.5) * T),),
        printed="eq9",
    ),
    Checked(
        "eq11",
        {"b": B, "T": PERIOD, "d": DELAY},
        ("K", "B"),
        _eq11,
        _eq11_near,
        lambda b, T, d: (0.0, b),
        ("d",),
        printed="eq11",
    ),
    Checked(
        "eq12",
        {"b": (0.0, 50.0, (1e-8, 2.0)), "k": _SPRING, "m": _MASS, "T": PERIOD},
        ("n1", "n0", "a", "e"),
        _eq12,
        _eq12_near,
        _eq12_scale,
        printed="eq12",
    ),
    Checked(
        "eq24",
        {"b": B, "B": _FORCE, "t_d": _LATE, "T": PERIOD},
        ("K",),
        _eq24,
        lambda b, B, t_d, T: ((b + B) / (t_d + T / 2),),
        printed="eq24",
    ),
    Checked(
        "eq28",
        {"k": _SPRING, "b": DAMPER, "m": _MASS},
        ("omega",),
        _eq28,
        _eq28_near,
        lambda k, b, m: (np.sqrt(k / m),),
        printed="eq28",
    ),
    Checked(
        "scene.max_stable_stiffness",
        {"m": (0.05, 5.0, (1.0,)), "b": DAMPER, "k": (0.0, 1000.0, (1.0,)), "T": PERIOD, "d": FEW},
        ("K", "B"),
        _stiffest,
        _stiffest_near,
        lambda m, b, k, T, d: (m / T**2, 1e8 * m / T),
        ("d",),
        balls=300,
    ),
)
