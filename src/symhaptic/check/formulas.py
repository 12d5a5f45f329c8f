"""All that can be checked, by its name: functions of walls, and the paper's equations in SI units.

Exact values are matrix exponentials, textbook formulas and counted roots in balls, which take
nothing from the package's kernels.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from flint import arb

from symhaptic.bench import implicit, winding
from symhaptic.bench.exact import EXACT
from symhaptic.check.checked import (
    ALPHA,
    ANGLE,
    BETA,
    DELAY,
    DELTA,
    FLAT,
    FRACTION,
    GAMMA,
    MASS,
    PERIOD,
    WHOLE,
    Argument,
    Checked,
    Point,
)
from symhaptic.kernels import haptic
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.compiled import of
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

# -- sizes of the terms that cancel --------------------------------------------------------------


def _swing(gamma: Any, delta: Any) -> Any:
    """How much larger than a rounding of the frequency is that of a sine of it."""
    return 1 + np.sqrt(np.maximum(gamma - delta**2 / 4, 0)) + delta


def _moved(gamma: Any, delta: Any) -> Any:
    """Of what a force moves in a period."""
    return _swing(gamma, delta) / (2 + gamma + delta)


def _plant(gamma: Any, delta: Any, moved: int) -> tuple[Any, ...]:
    size = (_moved(gamma, delta),) * moved
    return *size, 2 * _swing(gamma, delta), np.exp(-delta) * (1 + delta)


def _row(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    wall = (abs(alpha) + abs(beta)) * _moved(gamma, delta)
    return 1.0, 2 * _swing(gamma, delta), 1 + wall, wall, wall


def _curve(theta: Any, gamma: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """Of the stability boundary: A and M as they cancel on the unit circle, and the phase."""
    m2, m1, m0, a, e = discretize_fractional(gamma, delta, d - np.floor(d))
    z = np.exp(1j * theta)
    above, below = abs(z * z - a * z + e), abs(m2 * z * z + m1 * z + m0)
    size, force = 4 * _swing(gamma, delta), _moved(gamma, delta)
    terms = (size + above / below * (force + below * (1 + (d + 1) * theta))) / below
    return terms * (1 + np.tan(theta / 2)), terms / np.sin(theta)


def _wall(alpha: Any, beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    return (np.maximum(np.maximum(abs(alpha) * (d + 1), abs(beta)), delta),)


def _wall_at(theta: Any, alpha: Any, beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    most = np.minimum(d + 1, 1 / np.sin(theta / 2))
    return ((abs(alpha) * most + abs(beta)) * (1 + (d + 1) * theta) + delta,)


def _published_at(theta: Any, alpha: Any, beta: Any, d: Any) -> tuple[Any, ...]:
    """(5) as published divides by 1 - cos(theta)."""
    return ((abs(alpha) * (d + 1) + abs(beta) * (1 + (d + 1) * theta)) * (1 + 1 / theta**2),)


def _published_size(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    size = delta * (1 + 1 / ((d + 1) * theta) ** 2) * (1 + 1 / theta**2)
    return 2 * size, 2 * size


def _envelope(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """(27) as published divides what nearly vanishes at small angles."""
    size = delta * (1 + 1 / ((d + 1) * theta) ** 2)
    return size / (d + 1), size


# -- exact values --------------------------------------------------------------------------------


def _stable(alpha: float, beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    return (winding.stable(alpha, beta, gamma, delta, d) if _turns(gamma, delta) else None,)


def _unstable(alpha: float, beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    return (winding.unstable(alpha, beta, gamma, delta, d) if _turns(gamma, delta) else None,)


def _turns(gamma: float, delta: float) -> bool:
    """Whether a device is told from one that makes whole half swings in a period, undamped.

    Of that one no wall is stable; a rounding of gamma makes it of a device within a few roundings.
    """
    swings = round(math.sqrt(gamma) / math.pi)
    return not swings or abs(gamma / (swings * math.pi) ** 2 - 1) + delta > 1e-14


def _largest_delay(*wall: float) -> tuple[Any, ...]:
    """To 1e-11 of the delay, or of a period where it is shorter."""
    found = winding.largest_delay(*wall, most=1e6)
    if found is None or not found.is_finite() or found == 0:
        return (found,)
    return (found + arb(0, 1e-11 * max(1.0, float(found.mid()))),)


def _passive(alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    (margin,) = implicit.passivity_margin(alpha, beta, delta, d)
    if margin.contains(0):
        raise ArithmeticError
    return (bool(margin > 0),)


def _margin_at(theta: Any, alpha: float, beta: float, delta: float, d: float) -> tuple[Any, ...]:
    """At a fraction of a period for the motion that needs most."""
    whole = math.floor(d)
    wall = arb(alpha), arb(beta), whole, arb(d) - whole
    return (arb(delta) - implicit.required_damping_at(*wall, arb(theta)),)


def _is_simple(gamma: float, delta: float, d: float) -> bool:
    """Whether the first maximum of the boundary is the largest stable stiffness."""
    return gamma <= 9.8 and (d <= 1 or math.sqrt(gamma) * (d + 1) <= math.pi)


def _stiffest(gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """The first maximum of the boundary, whose walls are stable, or a search over all of it."""
    if _is_simple(gamma, delta, d):
        alpha, beta, theta = EXACT["max_stable_stiffness"](gamma, delta, d)
        known = alpha.is_finite() and winding.stable(
            float(alpha - 1e-6 * (alpha + gamma)), float(beta), gamma, delta, d
        )
        return (alpha, beta, theta) if known else (None, None, None)
    if d > 12 or gamma > 1e4:
        return None, None, None
    return winding.stiffest(gamma, delta, d), None, None


def _stiffest_in_si(m: float, b: float, k: float, T: float, d: float) -> tuple[Any, ...]:
    size = arb(m) / arb(T) ** 2
    gamma, delta = arb(k) / size, arb(b) * T / m
    if not _is_simple(float(gamma), float(delta), d):
        return None, None
    alpha, beta, _ = EXACT["max_stable_stiffness"](gamma, delta, d)
    return alpha * size, beta * size * T


def _first_maximum(gamma: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """Of the kernel, which has none elsewhere."""
    return of(haptic.max_stable_stiffness)(gamma, delta, d)


def _polynomial(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    n1, n0, a, e = discretize(gamma, delta)
    wall = alpha + beta
    return np.ones_like(a), -a, e + n1 * wall, n0 * wall - n1 * beta, -n0 * beta


# -- both sides of a boundary --------------------------------------------------------------------


def _beside_curve(
    rng: Any, by: float, alpha: float, beta: float, gamma: float, delta: float, d: float
) -> list[Point]:
    """Two walls beside the curve of stability, or beside a root at 1 or -1."""
    pick, plant = rng.random(), (gamma, delta, d)
    whole = math.floor(d)
    soft = rng.uniform(0, 0.5) / (d + 1)
    if pick < 0.8:
        turns = rng.uniform(0.02, 0.98) * (1 if rng.random() < 0.8 else min(whole + 1, 4))
        theta = turns * math.pi / (d + 1)
        wall = EXACT["stability_boundary"](theta, *plant)
        al, be = (float(x.mid()) for x in wall)
        return [(al * (1 + s), be * (1 + s), *plant) for s in (-by, by)]
    if pick < 0.9:
        left = gamma or soft
        return [(-gamma + s * left, soft, *plant) for s in (-by, by)]
    x = winding.plant(gamma, delta, arb(d) - whole)
    line = float((1 + x.a + x.e) / (x.m2 - x.m1 + x.m0)) * (-1) ** (whole % 2)
    return [(soft, (line * (1 + s) - soft) / 2, *plant) for s in (-by, by)]


def _beside_passive(
    rng: Any, by: float, alpha: float, beta: float, delta: float, d: float
) -> list[Point]:
    """Two dampings beside the one that the wall needs."""
    need = float(implicit.largest_required_damping(abs(alpha), beta, d)[0].mid())
    return [(abs(alpha), beta, need * (1 + s), d) for s in (-by, by)] if need > 0 else []


# -- arguments of what is drawn ----------------------------------------------------------------


def _in_si(at: dict[str, Any]) -> dict[str, Any]:
    """Numbers of a plant turned into stiffness and damping, an angle into a frequency."""
    if "omega" in at:
        at["omega"] = np.clip(at["omega"], _LEAST, 3.14) / at["T"]
    if "k" in at:
        at["k"] = at["k"] * at["m"] / at["T"] ** 2
        at["b"] = at["b"] * at["m"] / at["T"]
    return at


def _on_curve(at: dict[str, Any]) -> dict[str, Any]:
    """Two of three walls on the boundary of a delay of up to 1000 periods."""
    i = np.arange(at["alpha"].size)
    turn, size = (i * 0.6180339887498949) % 1, (i * 0.7548776662466927) % 1
    delay = np.where(i % 2, 8 * size, 10 ** (3 * size))
    theta = np.pi / (delay + 1) * (0.02 + 0.6 * turn)
    alpha, beta = stability_boundary(theta, at["gamma"], at["delta"], delay)
    known = (i % 3 > 0) & np.isfinite(alpha)
    return at | {"alpha": np.where(known, alpha, at["alpha"]),
                 "beta": np.where(known, beta, at["beta"])}  # fmt: skip


def _below_critical(at: dict[str, Any]) -> dict[str, Any]:
    """Damping ratios turned into dampings of devices that swing."""
    return at | {"b": 2 * at["b"] * np.sqrt(at["k"] * at["m"])}


def _softer(at: dict[str, Any]) -> dict[str, Any]:
    """Springs that the delay leaves soft, but for one in 100."""
    gamma, turn = at["gamma" if "gamma" in at else "k"], np.pi / (at["d"] + 1)
    most = np.where(at["d"] <= 1, 9.8, turn**2)
    soft = np.where(gamma < most, gamma, most * np.minimum(gamma / 1e3, 0.999))
    stiff = (np.arange(gamma.size) % 100 == 7) & (at["d"] < 9)
    at["gamma" if "gamma" in at else "k"] = np.where(stiff, gamma, soft)
    return at if "gamma" in at else _in_si(at)


def _published(at: dict[str, Any]) -> dict[str, Any]:
    """The same without angles at which what is published divides 0 by 0."""
    return at | {"theta": np.maximum(_just_passive(at)["theta"], _LEAST)}


def _just_passive(at: dict[str, Any]) -> dict[str, Any]:
    """Angles up to the one at which the boundary ends, for whole delays."""
    name = "theta" if "theta" in at else "omega"
    at[name] = at[name] / (at["d"] + 1)
    return at if name == "theta" else _in_si(at)


# -- functions of walls --------------------------------------------------------------------------

_LOOP = {"alpha": ALPHA, "beta": BETA, "gamma": GAMMA, "delta": DELTA, "d": DELAY}
_SOFT = {
    "alpha": Argument(0.0, 0.3, 1e-8, 1.0, (1e-3,)),
    "beta": Argument(0.0, 0.5, 1e-6, 10.0),
    "gamma": Argument(0.0, 1.0, 1e-8, 100.0),
    "delta": Argument(0.0, 1.0, 1e-8, 10.0),
}
"""Walls of which many are stable without delay."""
_FRACTIONS = "fractional delays: the published equation is for whole ones"

FUNCTIONS = (
    Checked(
        "discretize",
        {"gamma": GAMMA, "delta": DELTA},
        ("n1", "n0", "a", "e"),
        EXACT["discretize"],
        discretize,
        lambda gamma, delta: _plant(gamma, delta, 2),
        printed="eq14",
    ),
    Checked(
        "discretize_fractional",
        {"gamma": GAMMA, "delta": DELTA, "epsilon": FRACTION},
        ("m2", "m1", "m0", "a", "e"),
        EXACT["discretize_fractional"],
        discretize_fractional,
        lambda gamma, delta, epsilon: _plant(gamma, delta, 3),
    ),
    Checked(
        "characteristic_polynomial",
        {"alpha": ALPHA, "beta": BETA, "gamma": GAMMA, "delta": DELTA},
        ("z4", "z3", "z2", "z1", "z0"),
        EXACT["characteristic_polynomial"],
        _polynomial,
        _row,
        printed="eq18",
        open=("delays other than one period, of which the polynomial is",),
    ),
    Checked(
        "is_stable",
        _LOOP,
        ("stable",),
        _stable,
        lambda *wall: (is_stable(*wall),),
        balls=2000,
        border=_beside_curve,
    ),
    Checked(
        "unstable_roots",
        _LOOP,
        ("roots",),
        _unstable,
        lambda *wall: (unstable_roots(*wall),),
        balls=2000,
        border=_beside_curve,
    ),
    Checked(
        "stability_boundary",
        {"theta": ANGLE, "gamma": GAMMA, "delta": DELTA, "d": DELAY},
        ("alpha", "beta"),
        EXACT["stability_boundary"],
        stability_boundary,
        _curve,
    ),
    Checked(
        "max_stable_stiffness",
        {"gamma": replace(GAMMA, most=1e3), "delta": replace(DELTA, most=100.0), "d": DELAY},
        ("alpha", "beta", "theta"),
        _stiffest,
        _first_maximum,
        lambda gamma, delta, d: (gamma + 1 / (d + 1) ** 2, FLAT * (1 + gamma), FLAT + 0 * d),
        balls=300,
        flat=("beta", "theta"),
        derived=_softer,
        precisions=1,
        refused=lambda *plant: not _is_simple(*plant),
        open=("beta and theta where gamma > 9.8, or sqrt(gamma) (d + 1) > pi and d > 1",),
    ),
    *(
        Checked(
            name,
            _SOFT,
            ("d",),
            _largest_delay,
            None,  # of many points it takes longer than most of what is checked
            balls=120,
            derived=_on_curve,
            precisions=1,
            open=("delay margins above 1e+06 periods",),
        )
        for name in ("delay_margin", "max_delay")
    ),
    Checked(
        "is_passive",
        {"alpha": ALPHA, "beta": BETA, "delta": DELTA, "d": DELAY},
        ("passive",),
        _passive,
        lambda *wall: (is_passive(*wall),),
        balls=600,
        border=_beside_passive,
    ),
    Checked(
        "passivity_margin",
        {"alpha": ALPHA, "beta": BETA, "delta": DELTA, "d": DELAY},
        ("margin",),
        EXACT["passivity_margin"],
        lambda *wall: (passivity_margin(*wall),),
        _wall,
        balls=500,
    ),
    Checked(
        "passivity_margin_at",
        {"theta": ANGLE, "alpha": ALPHA, "beta": BETA, "delta": DELTA, "d": DELAY},
        ("margin",),
        _margin_at,
        lambda *wall: (passivity_margin_at(*wall),),
        _wall_at,
    ),
    Checked(
        "passivity_boundary",
        {"theta": ANGLE, "delta": replace(DELTA, special=(0.0, 1e-16, 1.0)), "d": DELAY},
        ("alpha", "beta"),
        EXACT["passivity_boundary"],
        passivity_boundary,
        _envelope,
        printed="eq27",
        derived=_just_passive,
        open=("angles at which no wall is just passive",),
    ),
    Checked(
        "max_passive_stiffness",
        {"delta": DELTA, "d": DELAY},
        ("alpha", "beta", "theta"),
        EXACT["max_passive_stiffness"],
        max_passive_stiffness,
        lambda delta, d: (0.0, delta * (d + 1), 0.0),
        balls=300,
        printed="eq11",
    ),
    Checked(
        "linear_limit",
        {"beta": BETA, "delta": DELTA, "d": DELAY},
        ("alpha",),
        EXACT["linear_limit"],
        lambda *wall: (linear_limit(*wall),),
        lambda beta, delta, d: (np.maximum(abs(beta), abs(delta)) / (d + 0.5),),
        printed="eq25",
    ),
)

# -- the paper's equations -----------------------------------------------------------------------

_B = Argument(0.0, 50.0, 1e-9, 1e6, (0.0, 1.0))
_FORCE = Argument(0.0, 50.0, 1e-9, 1e6, (0.0, 1.0), signed=True)
_K = Argument(0.0, 1e4, 1e-6, 1e9, (0.0, 1.0))
_LATE = Argument(0.0, 0.05, 1e-9, 10.0, (0.0, 1e-3))
_LEAST = 1e-6
"""Angles at which 1 - cos(theta), as published, has four digits."""
_FREQUENCY = replace(ANGLE, top=math.inf)
"""An angle, of which the period makes a frequency."""


def _eq5_near(K: Any, B: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    half = omega * T / 2
    kernel = np.sin((2 * d + 1) * half) / (2 * np.sin(half))
    return (K * T * kernel - B * np.cos(2 * (d + 1) * half),)


def _eq11_near(b: Any, T: Any, d: Any) -> tuple[Any, ...]:
    wall = max_passive_stiffness(b, d)
    return wall.alpha / T, wall.beta


def _eq7_near(b: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    alpha, beta = passivity_boundary(np.minimum(omega * T, 3.1415), b, d)
    return alpha / T, beta


def _eq7_size(b: Any, T: Any, omega: Any, d: Any) -> tuple[Any, ...]:
    alpha, beta = _published_size(omega * T, b, d)
    return alpha / T, beta


def _eq12(b: float, k: float, m: float, T: float) -> tuple[Any, ...]:
    mass, period = arb(m), arb(T)
    n1, n0, a, e = EXACT["discretize"](arb(k) * period**2 / mass, arb(b) * period / mass)
    return n1 * period**2 / mass, n0 * period**2 / mass, a, e


def _eq12_near(b: Any, k: Any, m: Any, T: Any) -> tuple[Any, ...]:
    n1, n0, a, e = discretize(k * T**2 / m, b * T / m)
    return n1 * T**2 / m, n0 * T**2 / m, a, e


def _eq12_size(b: Any, k: Any, m: Any, T: Any) -> tuple[Any, ...]:
    n1, n0, a, e = _plant(k * T**2 / m, b * T / m, 2)
    return n1 * T**2 / m, n0 * T**2 / m, a, e


def _eq28(k: Any, b: Any, m: Any) -> tuple[Any, ...]:
    inside = arb(k) / m - (arb(b) / m / 2) ** 2
    return (inside.sqrt() if inside >= 0 else arb("nan"),)


def _eq28_size(k: Any, b: Any, m: Any) -> tuple[Any, ...]:
    inside = np.maximum(k / m - (b / m / 2) ** 2, 1e-16 * k / m)
    return (k / m / np.sqrt(inside),)


def _stiffest_near(m: Any, b: Any, k: Any, T: Any, d: Any) -> tuple[Any, ...]:
    alpha, beta, _ = _first_maximum(k * T**2 / m, b * T / m, d)
    return alpha * m / T**2, beta * m / T


def _stiffest_size(m: Any, b: Any, k: Any, T: Any, d: Any) -> tuple[Any, ...]:
    return (k * T**2 / m + 1 / (d + 1) ** 2) * m / T**2, FLAT * m / T


EQUATIONS = (
    Checked(
        "eq5",
        {"K": _K, "B": _FORCE, "T": PERIOD, "omega": _FREQUENCY, "d": WHOLE},
        ("b",),
        lambda K, B, T, omega, d: (-_margin_at(arb(omega) * T, arb(K) * T, B, 0.0, d)[0],),
        _eq5_near,
        lambda K, B, T, omega, d: _published_at(np.minimum(omega * T, 3.14), K * T, B, d),
        printed="eq5",
        derived=_in_si,
        open=(_FRACTIONS,),
    ),
    Checked(
        "eq6",
        {"K": _K, "B": _FORCE, "T": PERIOD},
        ("b",),
        lambda K, B, T: (arb(K) * T / 2 + abs(arb(B)),),
        lambda K, B, T: (K * T / 2 + np.abs(B),),
        printed="eq6",
    ),
    Checked(
        "eq7",
        {"b": _B, "T": PERIOD, "omega": _FREQUENCY, "d": WHOLE},
        ("K", "B"),
        lambda b, T, omega, d: _per_period(EXACT["passivity_boundary"](arb(omega) * T, b, d), T),
        _eq7_near,
        _eq7_size,
        printed="eq7",
        derived=_just_passive,
        open=(_FRACTIONS, "frequencies at which no wall is just passive"),
    ),
    Checked(
        "eq9",
        {"b": _B, "B": _FORCE, "T": PERIOD, "d": WHOLE},
        ("K",),
        lambda b, B, T, d: ((arb(b) + B) / ((arb(d) + 0.5) * T),),
        lambda b, B, T, d: ((b + B) / ((d + 0.5) * T),),
        lambda b, B, T, d: ((b + abs(B)) / ((d + 0.5) * T),),
        printed="eq9",
        open=(_FRACTIONS,),
    ),
    Checked(
        "eq11",
        {"b": _B, "T": PERIOD, "d": WHOLE},
        ("K", "B"),
        lambda b, T, d: _per_period(EXACT["max_passive_stiffness"](b, d)[:2], T),
        _eq11_near,
        lambda b, T, d: (b * (d + 1) / T, b * (d + 1)),
        printed="eq11",
        open=(_FRACTIONS,),
    ),
    Checked(
        "eq12",
        {
            "b": replace(DELTA, most=700.0),
            "k": replace(GAMMA, most=1e6),
            "m": MASS,
            "T": PERIOD,
        },
        ("n1", "n0", "a", "e"),
        _eq12,
        _eq12_near,
        _eq12_size,
        printed="eq12",
        derived=_in_si,
    ),
    Checked(
        "eq24",
        {"b": _B, "B": _FORCE, "t_d": _LATE, "T": PERIOD},
        ("K",),
        lambda b, B, t_d, T: ((arb(b) + B) / (t_d + arb(T) / 2),),
        lambda b, B, t_d, T: ((b + B) / (t_d + T / 2),),
        lambda b, B, t_d, T: ((b + abs(B)) / (t_d + T / 2),),
        printed="eq24",
    ),
    Checked(
        "eq28",
        {"k": replace(_K, special=(1.0,)), "b": Argument(0.0, 1.0, 1e-9, 1.2), "m": MASS},
        ("omega",),
        _eq28,
        lambda k, b, m: (np.sqrt(k / m - (b / m / 2) ** 2),),
        _eq28_size,
        printed="eq28",
        derived=_below_critical,
        open=("devices that do not swing, of which it has no value",),
    ),
    Checked(
        "scene.max_stable_stiffness",
        {
            "m": MASS,
            "b": replace(DELTA, most=100.0),
            "k": replace(GAMMA, most=9.8),
            "T": PERIOD,
            "d": DELAY,
        },
        ("K", "B"),
        _stiffest_in_si,
        _stiffest_near,
        _stiffest_size,
        balls=300,
        flat=("B",),
        derived=_softer,
        refused=lambda m, b, k, T, d: not _is_simple(k * T**2 / m, b * T / m, d),
        open=("k T^2/m > 9.8, and sqrt(k/m) T (d + 1) > pi with d > 1",),
    ),
)


def _per_period(wall: Any, T: float) -> tuple[Any, ...]:
    return wall[0] / arb(T), wall[1]


_ALSO = {
    "eq14": "discretize",
    "eq18": "characteristic_polynomial",
    "eq25": "linear_limit",
    "eq27": "passivity_boundary",
}
"""Equations of the paper that a function computes."""

CHECKED: dict[str, Checked] = {c.id: c for c in (*EQUATIONS, *FUNCTIONS)}
CHECKED |= {id: replace(CHECKED[name], id=id) for id, name in _ALSO.items()}
for _id in ("eq25", "eq27"):
    CHECKED[_id] = replace(
        CHECKED[_id],
        derived=_published if _id == "eq27" else dict,
        scale=_published_size if _id == "eq27" else CHECKED[_id].scale,
        arguments=CHECKED[_id].arguments | {"d": WHOLE},
        open=(*CHECKED[_id].open, _FRACTIONS),
    )
