"""All that can be checked, by its name: functions of walls, and the paper's equations in SI units.

Exact values are matrix exponentials, textbook formulas and counted roots in balls, which take
nothing from the package's kernels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from flint import arb

from symhaptic.balls import implicit, winding
from symhaptic.balls.exact import EXACT
from symhaptic.check.checked import FLAT, Argument, Checked, Point
from symhaptic.kernels import haptic
from symhaptic.numeric import passivity
from symhaptic.numeric.arguments import IN_ORDER
from symhaptic.numeric.boundary import stability_boundary
from symhaptic.numeric.compiled import of
from symhaptic.numeric.linear import linear_limit
from symhaptic.numeric.plant import discretize, discretize_fractional
from symhaptic.numeric.stability import is_stable, unstable_roots
from symhaptic.numeric.tracing.extremes import limit_at

At = dict[str, Any]
_NO_FRACTION = "fractional delays: the published equation is for integer ones"
_LEAST = 1e-6
"""Angles at which 1 - cos(theta), as published, has four digits."""

ARGUMENTS = {
    "alpha": Argument(0.0, 3.0, 1e-20, 1e8, (0.0, 1e-8, 1.0), signed=True),
    "beta": Argument(0.0, 2.0, 1e-20, 1e8, (0.0, 1e-8, 1.0), signed=True),
    "gamma": Argument(0.0, 1.0, 1e-20, 1e15, (0.0, 1e-300, 1e-8, 1.0, 2.25)),
    # critical damping is at (1, 2) and (2.25, 3)
    "delta": Argument(0.0, 1.0, 1e-20, 1e4, (0.0, 1e-300, 1e-16, 1e-8, 2.0, 3.0)),
    "d": Argument(0.0, 8.0, 1e-12, 1e15, (0.0, 0.5, 1.0)),
    "epsilon": Argument(0.0, 0.99, 1e-16, 1.0 - 2.0**-53, (0.0, 0.5), top=1.0 - 2.0**-53),
    "theta": Argument(1e-3, 3.14, 1e-9, math.pi - 1e-9, (math.pi / 2,), top=math.pi),
    "omega": Argument(1e-3, 3.14, 1e-9, math.pi - 1e-9, (math.pi / 2,)),
    "T": Argument(1e-4, 1e-2, 1e-7, 10.0, (1e-3,)),
    "m": Argument(0.05, 5.0, 1e-6, 1e4, (1.0,)),
    "b": Argument(0.0, 50.0, 1e-9, 1e6, (0.0, 1.0)),
    "B": Argument(0.0, 50.0, 1e-9, 1e6, (0.0, 1.0), signed=True),
    "K": Argument(0.0, 1e4, 1e-6, 1e9, (0.0, 1.0)),
    "k": Argument(0.0, 1e4, 1e-6, 1e9, (1.0,)),
    "t_d": Argument(0.0, 0.05, 1e-9, 10.0, (0.0, 1e-3)),
}
"""Where each argument lies; for a frequency omega an angle is drawn, which is divided by T."""
WHOLE = Argument(0.0, 8.0, 1.0, 1e4, (0.0, 1.0), whole=True)
"""Delays of the published formulas, which lose digits with (d + 1)^2."""


def _args(names: str, **other: Argument) -> dict[str, Argument]:
    return {name: other.get(name, ARGUMENTS[name]) for name in names.split()}


# -- sizes of the terms that cancel --------------------------------------------------------------


def _swing(gamma: Any, delta: Any) -> Any:
    """How much larger than a rounding of the frequency is that of a sine of it."""
    return 1 + np.sqrt(np.maximum(gamma - delta**2 / 4, 0)) + delta


def _moved(gamma: Any, delta: Any) -> Any:
    """Of what a force moves in a period."""
    return _swing(gamma, delta) / (2 + gamma + delta)


def _plant(gamma: Any, delta: Any, moved: int = 2) -> tuple[Any, ...]:
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


def _published_at(theta: Any, alpha: Any, beta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """(5) as published divides by 1 - cos(theta)."""
    return ((abs(alpha) * (d + 1) + abs(beta) * (1 + (d + 1) * theta)) * (1 + 1 / theta**2),)


def _envelope(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    """The boundary divides what nearly vanishes at small angles."""
    size = delta * (1 + 1 / ((d + 1) * theta) ** 2)
    return size / (d + 1), size


def _published_envelope(theta: Any, delta: Any, d: Any) -> tuple[Any, ...]:
    return (2 * _envelope(theta, delta, d)[1] * (1 + 1 / theta**2),) * 2


# -- exact values --------------------------------------------------------------------------------


def _if_damped(count: Callable[..., Any]) -> Callable[..., tuple[Any, ...]]:
    """Nothing of a device that makes whole half oscillations in a period, to a rounding, undamped.

    Of that one no wall is stable.
    """

    def exact(*at: float) -> tuple[Any, ...]:
        gamma, delta = at[2:4]
        swings = round(math.sqrt(gamma) / math.pi)
        away = abs(gamma / (swings * math.pi) ** 2 - 1) + delta if swings else 1.0
        return (count(*at) if away > 1e-14 else None,)

    return exact


def _is_fast_and_undamped(alpha: float, beta: float, gamma: float, delta: float, d: float) -> bool:
    """Devices without damping that swing faster than pi/T: "not stable" is accepted for them."""
    return delta <= 1e-10 and gamma > 9.8


@cache
def _largest_delay(alpha: float, beta: float, gamma: float, delta: float) -> tuple[Any, ...]:
    """To 1e-11 of the delay, or of a period where it is shorter."""
    found = winding.largest_delay(alpha, beta, gamma, delta, most=1e6)
    if found is None or not found.is_finite() or found == 0:
        return (found,)
    return (found + arb(0, 1e-11 * max(1.0, float(found.mid()))),)


def _passive(*wall: float) -> tuple[Any, ...]:
    (margin,) = implicit.passivity_margin(*wall)
    return (None if margin.contains(0) else bool(margin > 0),)


def _is_simple(gamma: float, delta: float, d: float) -> bool:
    """Whether the first maximum of the boundary is the largest stable stiffness."""
    return gamma <= 9.8 and (d <= 1 or math.sqrt(gamma) * (d + 1) <= math.pi)


def _stiffest(gamma: Any, delta: Any, d: float) -> tuple[Any, ...]:
    """The first maximum of the boundary, whose walls are stable."""
    plant = float(gamma), float(delta), d
    if _is_simple(*plant):
        found = EXACT["max_stable_stiffness"](gamma, delta, d)
        inside = found[0] - (found[0] + gamma) * _INSIDE
        if found[0].is_finite() and winding.stable(float(inside), float(found[1]), *plant):
            return found
    return None, None, None


_INSIDE = 1e-6
"""A wall by so much softer than the largest stable stiffness has to be stable."""


@cache
def _limit(beta: float, gamma: float, delta: float, d: float) -> tuple[Any, ...]:
    """The largest stable stiffness with a damping, on the boundary or on the line of a root at -1.

    Softer walls are stable, stiffer ones are not.
    """
    nothing, plant = (None, None), (gamma, delta, d)
    rough, angle = map(float, limit_at(beta, *plant))
    if not (_is_simple(*plant) and math.isfinite(rough)):
        return nothing
    if angle == math.pi:
        whole = math.floor(d)
        x = winding.plant(gamma, delta, arb(d) - whole)
        found = (-1) ** (whole % 2) * (1 + x.a + x.e) / (x.m2 - x.m1 + x.m0) - 2 * arb(beta)
        theta = arb.pi()
    else:
        theta = _angle_of(beta, plant, angle)
        found = arb("nan") if theta is None else EXACT["stability_boundary"](theta, *plant)[0]
    if not found.is_finite():
        return nothing
    size = float(found) + gamma
    walls = (float(found) + by * size for by in (-_INSIDE, _INSIDE, 0.3, 1.0, 4.0, 20.0))
    softer, *stiffer = (winding.stable(wall, beta, *plant) for wall in walls)
    return nothing if not softer or any(one is not False for one in stiffer) else (found, theta)


def _angle_of(beta: float, plant: Point, angle: float) -> arb | None:
    """The angle near a given one at which the boundary has a damping, by secants, then enclosed."""

    def over(theta: arb) -> arb:
        return EXACT["stability_boundary"](theta, *plant)[1] - beta

    one, two = arb(angle), arb(angle) * (1 - arb(2) ** -30)
    for _ in range(6):
        rise = over(two) - over(one)
        if rise.contains(0):
            break
        one, two = two, (two - over(two) * (two - one) / rise).mid()
    near = two * arb(2) ** -90
    at_low, at_high = over(two - near), over(two + near)
    return two + arb(0, near) if at_low * at_high < 0 else None


def _limit_sizes(beta: float, gamma: float, delta: float, d: float) -> tuple[float, float]:
    """Sizes of the terms of the boundary, and what an error of its damping does to the rest."""
    plant = gamma, delta, d
    alpha, theta = map(float, limit_at(beta, *plant))
    if not theta < math.pi:
        return abs(alpha) + abs(beta) + gamma, 1.0
    ends = theta * (1 - 1e-6), theta * (1 + 1e-6)
    (low_K, low_B), (high_K, high_B) = (stability_boundary(end, *plant) for end in ends)
    of_K, of_B = _curve(theta, *plant)
    per_B = abs(of_B / (high_B - low_B))
    return of_K + abs(high_K - low_K) * per_B, theta + 2e-6 * theta * per_B


def _not_stiffest(point: Point, got: Sequence[float]) -> str:
    """Why a stiffness is not the largest stable one of a stiff spring or behind a long delay.

    No exact value is known there.  A stable wall that is stiffer refutes the stiffness, and so does
    a softer one that no damping makes stable.
    """
    (gamma, _, d), alpha = point, got[0]
    if _is_simple(*point) or d > 12 or gamma > 1e4 or not math.isfinite(alpha):
        return ""
    step = (alpha + gamma) * _INSIDE
    found = winding.stiff_wall(*point)
    if found is not None and alpha + step < found[0]:
        return f"the wall alpha = {found[0]:.9g}, beta = {found[1]:.9g} is stable, and stiffer"
    try:
        if winding.damping_at(alpha - step, *point) is None:
            return f"no damping makes a wall of alpha = {alpha - step:.9g} stable"
    except winding.Undecided:
        pass
    return ""


def _not_stiffest_in_si(point: Point, got: Sequence[float]) -> str:
    m, b, k, T, d = point
    return _not_stiffest((k * T**2 / m, b * T / m, d), [got[0] * T**2 / m])


# -- nearly the same, fast -----------------------------------------------------------------------


def _first_maximum(gamma: Any, delta: Any, d: Any) -> Any:
    """Of the kernel, which has none elsewhere."""
    return of(haptic.max_stable_stiffness)(gamma, delta, d)


def _polynomial(alpha: Any, beta: Any, gamma: Any, delta: Any) -> tuple[Any, ...]:
    n1, n0, a, e = discretize(gamma, delta)
    wall = alpha + beta
    return np.ones_like(a), -a, e + n1 * wall, n0 * wall - n1 * beta, -n0 * beta


def _one(function: Callable[..., Any]) -> Callable[..., tuple[Any, ...]]:
    return lambda *at: (function(*at),)


# -- both sides of a boundary --------------------------------------------------------------------


def _beside_curve(rng: Any, by: float, *at: float) -> list[Point]:
    """Two walls beside the curve of stability, or beside a root at 1 or -1."""
    gamma, delta, d = plant = at[2:]
    pick, whole, soft = rng.random(), math.floor(d), rng.uniform(0, 0.5) / (d + 1)
    if pick < 0.8:
        turns = rng.uniform(0.02, 0.98) * (1 if rng.random() < 0.8 else min(whole + 1, 4))
        wall = EXACT["stability_boundary"](turns * math.pi / (d + 1), *plant)
        alpha, beta = (float(x.mid()) for x in wall)
        return [(alpha * (1 + s), beta * (1 + s), *plant) for s in (-by, by)]
    if pick < 0.9:
        return [(-gamma + s * (gamma or soft), soft, *plant) for s in (-by, by)]
    x = winding.plant(gamma, delta, arb(d) - whole)
    line = float((1 + x.a + x.e) / (x.m2 - x.m1 + x.m0)) * (-1) ** (whole % 2)
    return [(soft, (line * (1 + s) - soft) / 2, *plant) for s in (-by, by)]


def _beside_passive(rng: Any, by: float, *at: float) -> list[Point]:
    """Two dampings beside the one that the wall needs."""
    alpha, beta, d = abs(at[0]), at[1], at[3]
    need = float(implicit.largest_required_damping(alpha, beta, d)[0].mid())
    return [(alpha, beta, need * (1 + s), d) for s in (-by, by)] if need > 0 else []


# -- arguments of what is drawn ------------------------------------------------------------------


def _in_si(at: At) -> At:
    """Numbers of a plant turned into stiffness and damping, an angle into a frequency."""
    if "omega" in at:
        at["omega"] = np.clip(at["omega"], _LEAST, 3.14) / at["T"]
    if "k" in at:
        at |= {"k": at["k"] * at["m"] / at["T"] ** 2, "b": at["b"] * at["m"] / at["T"]}
    return at


def _on_curve(at: At) -> At:
    """Two of three walls on the boundary of a delay of up to 1e5 periods."""
    i = np.arange(at["alpha"].size)
    turn, size = (i * 0.6180339887498949) % 1, (i * 0.7548776662466927) % 1
    delay = np.where(i % 2, 8 * size, 10 ** (5 * size))
    theta = np.pi / (delay + 1) * (0.02 + 0.6 * turn)
    wall = stability_boundary(theta, at["gamma"], at["delta"], delay)
    known = (i % 3 > 0) & np.isfinite(wall[0])
    names = zip(("alpha", "beta"), wall, strict=True)
    return at | {name: np.where(known, v, at[name]) for name, v in names}


def _below_critical(at: At) -> At:
    """Damping ratios turned into dampings of devices that swing."""
    return at | {"b": 2 * at["b"] * np.sqrt(at["k"] * at["m"])}


def _softer(at: At) -> At:
    """Springs that the delay leaves soft, but for one in 100."""
    name = "gamma" if "gamma" in at else "k"
    gamma, most = at[name], np.where(at["d"] <= 1, 9.8, (np.pi / (at["d"] + 1)) ** 2)
    soft = np.where(gamma < most, gamma, most * np.minimum(gamma / 1e3, 0.999))
    stiff = (np.arange(gamma.size) % 100 == 7) & (at["d"] < 9)
    return _in_si(at | {name: np.where(stiff, gamma, soft)})


def _just_passive(at: At) -> At:
    """Angles up to the one at which the boundary ends, for integer delays."""
    name = "theta" if "theta" in at else "omega"
    return _in_si(at | {name: at[name] / (at["d"] + 1)})


def _published(at: At) -> At:
    """The same without angles at which what is published divides 0 by 0."""
    return at | {"theta": np.maximum(_just_passive(at)["theta"], _LEAST)}


# -- functions of walls --------------------------------------------------------------------------

_SOFT = {
    "alpha": Argument(0.0, 0.3, 1e-8, 1.0, (1e-3,)),
    "beta": Argument(0.0, 0.5, 1e-6, 10.0),
    "gamma": Argument(0.0, 1.0, 1e-8, 100.0),
    "delta": Argument(0.0, 1.0, 1e-8, 10.0),
}
"""Walls of which many are stable without delay."""

_STIFF = (
    "beta and theta where gamma > 9.8, or sqrt(gamma) (d + 1) > pi and d > 1; a wrong alpha is "
    "refuted there by walls whose roots are counted"
)

# fmt: off
FUNCTIONS = (
    Checked("discretize", _args("gamma delta"), ("n1", "n0", "a", "e"), EXACT["discretize"],
            discretize, _plant, printed="eq14"),
    Checked("discretize_fractional", _args("gamma delta epsilon"), ("m2", "m1", "m0", "a", "e"),
            EXACT["discretize_fractional"], discretize_fractional, lambda g, d, _: _plant(g, d, 3)),
    Checked("characteristic_polynomial", _args("alpha beta gamma delta"),
            ("z4", "z3", "z2", "z1", "z0"), EXACT["characteristic_polynomial"], _polynomial, _row,
            printed="eq18", open=("delays other than one period, of which the polynomial is",)),
    Checked("is_stable", _args("alpha beta gamma delta d"), ("stable",),
            _if_damped(winding.stable), _one(is_stable), balls=2000, border=_beside_curve,
            no_answer=0.0, hard=_is_fast_and_undamped),
    Checked("unstable_roots", _args("alpha beta gamma delta d"), ("roots",),
            _if_damped(winding.unstable), _one(unstable_roots), balls=2000, border=_beside_curve,
            no_answer=-1.0),
    Checked("stability_boundary", _args("theta gamma delta d"), ("alpha", "beta"),
            EXACT["stability_boundary"], stability_boundary, _curve),
    Checked("max_stable_stiffness",
            {"gamma": replace(ARGUMENTS["gamma"], most=1e3),
             "delta": replace(ARGUMENTS["delta"], most=100.0), "d": ARGUMENTS["d"]},
            ("alpha", "beta", "theta"), _stiffest, _first_maximum,
            lambda g, dl, d: (g + 1 / (d + 1) ** 2, FLAT * (1 + g), FLAT + 0 * d), balls=300,
            flat=("beta", "theta"), derived=_softer, precisions=1,
            refused=lambda *plant: not _is_simple(*plant), refutes=_not_stiffest, open=(_STIFF,)),
    Checked("limit_at",
            _args("beta gamma delta d",
                  beta=replace(ARGUMENTS["beta"], least=1e-8, most=2.0),
                  gamma=replace(ARGUMENTS["gamma"], most=1e3),
                  delta=replace(ARGUMENTS["delta"], most=100.0),
                  d=replace(ARGUMENTS["d"], most=1e3)), ("alpha", "theta"), _limit, None,
            _limit_sizes, balls=120, derived=_softer, precisions=1,
            refused=lambda *at: _limit(*at)[0] is None,
            open=(_STIFF.partition(";")[0].replace("beta and theta", "limits"),
                  "dampings at which no wall is stable")),
    *(Checked(name, _SOFT, ("d",), _largest_delay, None, balls=120, derived=_on_curve,
              precisions=1, open=("delay margins above 1e+06 periods",))
      for name in ("delay_margin", "max_delay")),
    Checked("is_passive", _args("alpha beta delta d"), ("passive",), _passive,
            _one(passivity.is_passive), balls=600, border=_beside_passive),
    Checked("passivity_margin", _args("alpha beta delta d"), ("margin",),
            EXACT["passivity_margin"], _one(passivity.passivity_margin), _wall, balls=500),
    Checked("passivity_margin_at", _args("theta alpha beta delta d"), ("margin",),
            EXACT["passivity_margin_at"], _one(passivity.passivity_margin_at), _wall_at),
    Checked("passivity_boundary",
            _args("theta delta d", delta=replace(ARGUMENTS["delta"], special=(0.0, 1e-16, 1.0))),
            ("alpha", "beta"), EXACT["passivity_boundary"], passivity.passivity_boundary,
            _envelope, printed="eq27", derived=_just_passive,
            open=("angles at which no wall is just passive",)),
    Checked("max_passive_stiffness", _args("delta d"), ("alpha", "beta", "theta"),
            EXACT["max_passive_stiffness"], passivity.max_passive_stiffness,
            lambda delta, d: (0.0, delta * (d + 1), 0.0), balls=300, printed="eq11"),
    Checked("linear_limit", _args("beta delta d"), ("alpha",), EXACT["linear_limit"],
            _one(linear_limit), lambda beta, delta, d: ((abs(beta) + delta) / (d + 0.5),),
            printed="eq25"),
)
# fmt: on

# -- the paper's equations -----------------------------------------------------------------------

_BY_NAME = {one.id: one for one in FUNCTIONS}


def _unit(
    id: str,
    name: str,
    arguments: dict[str, Argument],
    results: tuple[str, ...],
    into: Callable[..., tuple[Any, ...]],
    out: Callable[..., tuple[Any, ...]],
    scale: Callable[..., tuple[Any, ...]] | None = None,
    **given: Any,
) -> Checked:
    """An equation in SI units: a function of numbers without unit, ``into`` which they are turned.

    ``out`` turns its results, and the sizes of their errors, into SI units.
    """
    function = _BY_NAME[name]
    size = scale or function.scale
    assert function.near is not None
    assert size is not None
    near = function.near

    def exact(*at: float) -> tuple[Any, ...]:
        names = zip(arguments, at, strict=True)
        balls = [v if name == "d" else arb(v) for name, v in names]
        values = function.exact(*into(*balls))
        return (None,) * len(results) if values[0] is None else out(values, *balls)

    return Checked(
        id,
        arguments,
        results,
        exact,
        lambda *at: out(near(*into(*at)), *at),
        lambda *at: tuple(map(abs, out(size(*into(*at)), *at))),
        **given,
    )


def _closed(
    id: str,
    names: str,
    result: str,
    value: Callable[..., Any],
    size: Callable[..., Any],
    **given: Any,
) -> Checked:
    """An equation in closed form, of balls and of arrays alike."""
    given = {"printed": id, "arguments": _args(names, d=WHOLE), "results": (result,)} | given
    exact = _one(lambda *at: value(*map(arb, at)))
    return Checked(id, exact=exact, near=_one(value), scale=_one(size), **given)


def _swings(k: Any, b: Any, m: Any) -> Any:
    inside = k / m - (b / m / 2) ** 2
    if isinstance(inside, arb):
        return inside.sqrt() if inside >= 0 else arb("nan")
    return np.sqrt(inside)


# fmt: off
EQUATIONS = (
    _unit("eq5", "passivity_margin_at", _args(IN_ORDER["eq5"], d=WHOLE), ("b",),
          lambda K, B, T, omega, d: (omega * T, K * T, B, 0.0, d), lambda v, *_: (-v[0],),
          _published_at, printed="eq5", derived=_in_si, open=(_NO_FRACTION,)),
    _closed("eq6", IN_ORDER["eq6"], "b", lambda K, B, T: K * T / 2 + abs(B),
            lambda K, B, T: K * T / 2 + abs(B)),
    _unit("eq7", "passivity_boundary", _args(IN_ORDER["eq7"], d=WHOLE), ("K", "B"),
          lambda b, T, omega, d: (omega * T, b, d), lambda v, b, T, *_: (v[0] / T, v[1]),
          _published_envelope, printed="eq7", derived=_just_passive,
          open=(_NO_FRACTION, "frequencies at which no wall is just passive")),
    _closed("eq9", IN_ORDER["eq9"], "K", lambda b, B, T, d: (b + B) / ((d + 0.5) * T),
            lambda b, B, T, d: (b + abs(B)) / ((d + 0.5) * T), open=(_NO_FRACTION,)),
    _unit("eq11", "max_passive_stiffness", _args(IN_ORDER["eq11"], d=WHOLE), ("K", "B"),
          lambda b, T, d: (b, d), lambda v, b, T, d: (v[0] / T, v[1]),
          lambda delta, d: (delta * (d + 1),) * 2, printed="eq11", open=(_NO_FRACTION,)),
    _unit("eq12", "discretize",
          {"b": replace(ARGUMENTS["delta"], most=700.0), "k": replace(ARGUMENTS["gamma"], most=1e6),
           "m": ARGUMENTS["m"], "T": ARGUMENTS["T"]}, ("n1", "n0", "a", "e"),
          lambda b, k, m, T: (k * T**2 / m, b * T / m),
          lambda v, b, k, m, T: (v[0] * T**2 / m, v[1] * T**2 / m, v[2], v[3]),
          printed="eq12", derived=_in_si),
    _closed("eq24", IN_ORDER["eq24"], "K", lambda b, B, t_d, T: (b + B) / (t_d + T / 2),
            lambda b, B, t_d, T: (b + abs(B)) / (t_d + T / 2)),
    _closed("eq28", IN_ORDER["eq28"], "omega", _swings,
            lambda k, b, m: k / m / np.sqrt(np.maximum(k / m - (b / m / 2) ** 2, 1e-16 * k / m)),
            arguments=_args(IN_ORDER["eq28"], b=Argument(0.0, 0.999, 1e-9, 1 - 1e-6)),
            derived=_below_critical,
            open=("devices that do not swing, of which it has no value",)),
    _unit("scene.max_stable_stiffness", "max_stable_stiffness",
          {"m": ARGUMENTS["m"], "b": replace(ARGUMENTS["delta"], most=100.0),
           "k": replace(ARGUMENTS["gamma"], most=9.8), "T": ARGUMENTS["T"], "d": ARGUMENTS["d"]},
          ("K", "B"), lambda m, b, k, T, d: (k * T**2 / m, b * T / m, d),
          lambda v, m, b, k, T, d: (v[0] * m / T**2, None if v[1] is None else v[1] * m / T),
          balls=300, flat=("B",), derived=_softer, precisions=1,
          refused=lambda m, b, k, T, d: not _is_simple(k * T**2 / m, b * T / m, d),
          refutes=_not_stiffest_in_si, open=(_STIFF.replace("gamma", "k T^2/m"),)),
)
# fmt: on

CHECKED = {one.id: one for one in (*EQUATIONS, *FUNCTIONS)}
_ALSO: dict[str, tuple[str, dict[str, Any]]] = {
    "eq14": ("discretize", {}),
    "eq18": ("characteristic_polynomial", {}),
    "eq25": ("linear_limit", {}),
    "eq27": ("passivity_boundary", {"derived": _published, "scale": _published_envelope}),
}
"""Equations of the paper that a function computes, with what is other in them."""
for _id, (_name, _other) in _ALSO.items():
    _found = replace(CHECKED[_name], id=_id, **_other)
    if "d" in _found.arguments:
        _found = replace(
            _found, arguments={**_found.arguments, "d": WHOLE}, open=(*_found.open, _NO_FRACTION)
        )
    CHECKED[_id] = _found
