"""K = alpha m/T^2, B = beta m/T, f = theta/(2 pi T): walls of a scene in SI units, one or arrays.

What the functions of ``numeric`` answer without units; labels and laziness go with the arrays.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from symhaptic.loops.oversampled import Oversampled
from symhaptic.loops.sensor import quantisation_limit
from symhaptic.loops.trace import LONGEST as LONGEST_TRACED
from symhaptic.loops.trace import Trace
from symhaptic.notation.quantities import decimal, in_unit, number, with_unit
from symhaptic.numeric import arguments, boundary, passivity, stability
from symhaptic.numeric import certified as by_balls
from symhaptic.numeric.containers import kept
from symhaptic.numeric.given import Given
from symhaptic.numeric.tracing import extremes, margin
from symhaptic.numeric.tracing import region as tracing
from symhaptic.numeric.tracing.shape import Shape
from symhaptic.scene.dimensionless import per_unit, units
from symhaptic.scene.limit import Limit, Stiffness
from symhaptic.scene.loop import DeviceLoop, wall_units

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from symhaptic.numeric.extremum import Extremum


def is_stable(scene: DeviceLoop, K: Any, B: Any, certified: bool = False) -> Any:
    """Whether all characteristic roots lie inside the unit circle."""
    if certified:
        from symhaptic.balls.winding import stable

        return _certified(stable, scene, _in_decimals(scene, scene.periods), K, B)
    if scene.further:
        return _of_walls(scene.engine.is_stable, scene, (), K, B, bool)
    return _of_walls(stability.is_stable, scene, scene.dimensionless, K, B, bool)


def is_passive(scene: DeviceLoop, K: Any, B: Any, certified: bool = False) -> Any:
    """Whether no motion extracts energy, by the damping of the device alone (3)."""
    alone = scene.device
    if certified:
        loop = _in_decimals(alone, alone.periods)[1:]
        return _certified(by_balls.passively, alone, loop, K, B)
    if scene.further:
        return _of_walls(alone.engine.is_passive, alone, (), K, B, bool)
    return _of_walls(passivity.is_passive, alone, alone.dimensionless[1:], K, B, bool)


def _in_decimals(scene: DeviceLoop, periods: Fraction) -> tuple[Fraction, ...]:
    """gamma, delta and the delay of the decimals that a scene is made of, not rounded."""
    stiff, damped = _exact_units(scene)
    moved = scene.coupled
    return decimal(moved.stiffness or 0) * stiff, decimal(moved.damping or 0) * damped, periods


def _exact_units(scene: DeviceLoop) -> tuple[Fraction, Fraction]:
    """T^2/m and T/m."""
    period, mass = decimal(scene.sampling_period), decimal(scene.coupled.mass)
    return period**2 / mass, period / mass


def _certified(
    ask: Callable[..., bool | None],
    scene: DeviceLoop,
    loop: tuple[Fraction, ...],
    K: Any,
    B: Any,
) -> Any:
    """A verdict that is right for the decimals that were given, in balls of growing precision."""
    if scene.further:
        raise ValueError(
            "certified: True is not allowed for a loop with a filter, an actuator, a second or a "
            "virtual mass, or another integrator; leave certified out"
        )
    from flint import fmpq

    stiff, damped = _exact_units(scene)

    def verdict(K: Fraction, B: Fraction) -> bool | None:
        numbers = K * stiff, B * damped, *loop
        return ask(*(fmpq(n.numerator, n.denominator) for n in numbers))

    answer = kept(verdict=bool)(partial(by_balls.of_walls, verdict))
    walls = in_unit("K", K, scene.unit("N/m")), in_unit("B", B, scene.unit("N*s/m"))
    return _one(answer(*walls), bool)


def why_not_passive(scene: DeviceLoop) -> str:
    """Why passivity cannot be told of a loop, or nothing if it can."""
    return scene.device.engine.no_passivity if scene.further else ""


def passivity_margin(scene: DeviceLoop, K: Any, B: Any) -> Any:
    """The damping of the device alone (3) in Ns/m minus the damping that a wall needs."""
    alone = scene.device
    unit = units(alone.mass_or_inertia, alone.sampling_period)[1]
    ask: Callable[..., Any] = passivity.passivity_margin
    loop: tuple[float, ...] = alone.dimensionless[1:]
    if scene.further:
        ask, loop = alone.engine.passivity_margin, ()
    return _of_walls(ask, alone, loop, K, B, float, unit, alone.unit("N*s/m"))


def max_delay(scene: DeviceLoop, K: Any, B: Any) -> Any:
    """The largest delay in s up to which a wall is stable."""
    if scene.further:
        ask = scene.engine.max_delay
        return _of_walls(ask, scene, (), K, B, float, scene.sampling_period, "s")
    args = scene, scene.dimensionless[:2], K, B, float, scene.sampling_period, "s"
    return _of_walls(margin.max_delay, *args)


def delay_margin(scene: DeviceLoop, K: Any, B: Any) -> Any:
    """The delay in s that may be added until a wall is unstable."""
    if scene.further:
        ask = scene.engine.delay_margin
        return _of_walls(ask, scene, (), K, B, float, scene.sampling_period, "s")
    args = scene, scene.dimensionless, K, B, float, scene.sampling_period, "s"
    return _of_walls(margin.delay_margin, *args)


def stable_delays(scene: DeviceLoop, K: Any, B: Any, up_to: Any) -> tuple[tuple[float, float], ...]:
    """The windows of the delay in s in which a wall is stable."""
    stiff, damped = wall_units(scene)
    period = scene.sampling_period
    alpha = stiff * number("K", K, scene.unit("N/m"))
    beta = damped * number("B", B, scene.unit("N*s/m"))
    periods = number("up_to", up_to, "s", ">= 0") / period
    if periods > LONGEST_TRACED:
        most = f"{LONGEST_TRACED} periods, {LONGEST_TRACED * period:g} s"
        raise ValueError(f"up_to: {up_to!r} is not allowed; give at most {most}")
    if scene.integrator != "hold":
        raise ValueError(
            f"integrator: {scene.integrator!r} has no windows of the delay, because a simulator "
            "knows its steps only; give integrator='hold'"
        )
    found = scene.engine.stable_delays(alpha, beta, 0.0, periods)
    return tuple((low * period, high * period) for low, high in found)


def _of_walls(
    function: Callable[..., Any],
    scene: DeviceLoop,
    loop: tuple[float, ...],
    K: Any,
    B: Any,
    kind: type,
    size: float = 1.0,
    unit: str = "",
) -> Any:
    """What a function of alpha, beta and ``loop`` tells of walls, times ``size``.

    It has a ``unit`` where it is a number and one of both came with one.
    """
    stiff, damped = wall_units(scene)
    if all(type(x) in (float, int) and -_MOST < x < _MOST for x in (K, B)):
        found = function(K * stiff, B * damped, *loop)
        return bool(found) if kind is bool else float(found) * size

    @kept(**{function.__name__: kind})
    def answer(K: Any, B: Any) -> Any:
        K, B = Given(K=K, B=B).values
        found = function(K * stiff, B * damped, *loop)
        return found if kind is bool else found * size

    walls = in_unit("K", K, scene.unit("N/m")), in_unit("B", B, scene.unit("N*s/m"))
    found = _one(answer(*walls), kind)
    return with_unit(found, unit, K, B) if unit else found


_MOST = 1e15
"""Plain numbers below this size skip the checks of arguments."""


def stability_boundary(scene: DeviceLoop, frequency_hz: Any) -> tuple[Any, Any]:
    """The walls with which the loop swings at these frequencies."""
    gamma, delta, delay = scene.dimensionless
    period = scene.sampling_period
    unit_K, unit_B = units(scene.coupled.mass, period)

    @kept(K=float, B=float)
    def answer(frequency_hz: Any) -> Any:
        given = Given(frequency_hz=frequency_hz)
        (hz,), half = given.values, 0.5 / period
        if not given.traced:
            beyond = (hz <= 0) | (2 * math.pi * period * hz >= math.pi)
            arguments.refuse("frequency_hz", hz, beyond, f"numbers 0 < frequency_hz < {half:g}")
        theta = 2 * math.pi * period * hz
        if scene.further:
            alpha, beta = scene.engine.stability_boundary(theta)
        else:
            alpha, beta = boundary.stability_boundary(theta, gamma, delta, delay)
        return alpha * unit_K, beta * unit_B

    K, B = (_one(found, float) for found in answer(in_unit("frequency_hz", frequency_hz, "Hz")))
    stiff, damped = scene.unit("N/m"), scene.unit("N*s/m")
    return with_unit(K, stiff, frequency_hz), with_unit(B, damped, frequency_hz)


def _one(found: Any, kind: type) -> Any:
    """A number for one wall, not an array without dimensions."""
    return kind(found) if isinstance(found, np.ndarray | np.generic) and not found.ndim else found


def plane(scene: DeviceLoop) -> tuple[str, str]:
    """Labels of K and B with their units."""
    in_K, in_B = scene.printed("N/m"), scene.printed("N*s/m")
    return f"virtual stiffness $K$ in {in_K}", f"virtual damping $B$ in {in_B}"


@dataclass(frozen=True)
class StableWalls(Shape):
    """The walls (K, B) that a scene keeps stable, in N/m and Ns/m, or N m/rad and N m s/rad."""

    scene: DeviceLoop
    region: tracing.Region | Trace
    """The same without units."""
    polygon: Any
    """Shapely's polygon or polygons, in the units of the walls; ``area`` is in N^2 s/m^2."""
    corners: NDArray[np.float64] = field(compare=False)
    """One row (K, B) per corner."""

    @property
    def labels(self) -> tuple[str, str]:
        """What the axes of the plane are."""
        return plane(self.scene)

    @property
    def max_stiffness(self) -> Limit:
        """The rightmost point, and its frequency."""
        return self._limit(self.region.max_stiffness)

    @property
    def max_damping(self) -> Limit:
        """The uppermost point; its frequency is NaN where a real root borders it alone."""
        return self._limit(self.region.max_damping)

    @property
    def min_damping(self) -> Limit:
        """The lowest point, likewise."""
        return self._limit(self.region.min_damping)

    def contains(self, K: ArrayLike, B: ArrayLike) -> Any:
        """Whether walls are stable, by the root count and not by the outline."""
        return is_stable(self.scene, K, B)

    def _limit(self, found: Extremum) -> Limit:
        return self.scene.limit(*found)


@dataclass(frozen=True)
class PassiveWalls(Shape):
    """The walls (K, B) from which no motion extracts energy, in N/m and Ns/m."""

    scene: DeviceLoop
    """The device alone."""
    polygon: Any
    """Shapely's polygon, inside the curved border; ``area`` is in N^2 s/m^2."""

    @property
    def labels(self) -> tuple[str, str]:
        """What the axes of the plane are."""
        return plane(self.scene)

    @property
    def max_stiffness(self) -> Stiffness:
        """The passive wall of maximum stiffness."""
        return max_passive_stiffness(self.scene)

    def contains(self, K: ArrayLike, B: ArrayLike) -> Any:
        """Whether walls are passive, by their margin and not by the outline."""
        return is_passive(self.scene, K, B)


def passive_region(scene: DeviceLoop, corners: int = 400) -> PassiveWalls:
    """The passive walls of the (K, B) plane: convex, from (0, -b) to (0, b) and beyond."""
    from shapely import MultiPoint, Polygon

    scene = scene.device
    b, period = scene.damping or 0.0, scene.sampling_period
    if scene.further:
        delta = scene.dimensionless.delta
        low, high = scene.engine.needs.without_stiffness(delta)
        if not low < high:
            return PassiveWalls(scene, Polygon())
        B = np.linspace(low, high, corners)
        K, _ = scene.engine.needs.limits(B, delta)
        own = units(scene.mass_or_inertia, period)
        walls = np.column_stack([np.nan_to_num(K), B]) * own
        return PassiveWalls(scene, MultiPoint([*walls, *(walls * (0, 1))]).convex_hull)
    if b == 0:
        return PassiveWalls(scene, Polygon())
    omega = np.linspace(1e-4, math.pi * (1 - 1e-6), 10 * corners)
    alpha, beta = passivity.passivity_boundary(omega, 1.0, scene.dimensionless.delay)
    known = np.flatnonzero(np.isfinite(alpha) & (alpha >= 0))
    near = known[np.unique(np.linspace(0, len(known) - 1, corners).astype(int))]
    stiffest = max_passive_stiffness(scene)
    walls = np.column_stack([alpha[near] * (b / period), beta[near] * b])
    points = [(0.0, -b), (0.0, b), (stiffest.K, stiffest.B), *walls.tolist()]
    return PassiveWalls(scene, MultiPoint(points).convex_hull)


def max_stable_stiffness(scene: DeviceLoop) -> Stiffness:
    """The stable wall of maximum stiffness of any damping."""
    if scene.further:
        return Stiffness(*scene.limit(*scene.engine.trace.max_stiffness))
    return Stiffness(*scene.limit(*extremes.max_stable_stiffness(*scene.dimensionless)))


def max_passive_stiffness(scene: DeviceLoop) -> Stiffness:
    """The passive wall of maximum stiffness of any damping, of the device alone (3)."""
    alone = scene.device
    _, delta, delay = alone.dimensionless
    if scene.further:
        return Stiffness(*alone.limit(*alone.engine.needs.stiffest(delta)))
    return Stiffness(*alone.limit(*passivity.max_passive_stiffness(delta, delay)))


def quantised_limits(scene: DeviceLoop) -> dict[str, Stiffness]:
    """Stiffness up to which a wall without damping is passive with an encoder, by what limits it.

    The position is rounded by at most Delta/2, and so the force is wrong by at most K Delta/2, or
    with a virtual mass M by (K + 4 M/T^2) Delta/2: three positions make a second difference.
    Friction of this size dissipates in each instant what the error gives, and the rest of the loop
    is that without encoder.  Without virtual damping the filter of the velocity does not matter.
    A limit is NaN where a virtual mass alone is too much, so that a wall of K = 0 is not passive.
    """
    if scene.encoder is None:
        raise ValueError("encoder: is left out; give Encoder(resolution=...)")
    of_damping = passive_limit_at(replace(scene, velocity=None), 0.0)
    friction = quantisation_limit(scene.encoder.resolution, scene.coulomb_friction or 0.0)
    friction -= 4 * (scene.virtual_mass or 0.0) / scene.sampling_period**2
    return {
        "damping": Stiffness(of_damping.K, 0.0, of_damping.frequency_hz),
        "friction": Stiffness(friction if friction >= 0 else math.nan, 0.0, math.nan),
    }


def binding(limits: dict[str, Stiffness]) -> str:
    """The name of the smallest limit; NaN, which leaves no wall, is less than any number."""
    return min(limits, key=lambda name: -math.inf if math.isnan(limits[name]) else limits[name])


def max_quantised_stiffness(scene: DeviceLoop) -> Stiffness:
    """The smaller one of both."""
    limits = quantised_limits(scene)
    return limits[binding(limits)]


def limit_at(scene: DeviceLoop, B: Any) -> Limit:
    """The largest stable stiffness at a damping, or at each of many."""
    gamma, delta, delay = scene.dimensionless
    _, scale = wall_units(scene)

    def rows(damping: NDArray[np.float64]) -> NDArray[np.float64]:
        betas = arguments.unitless("B", damping, damping * scale).flat
        if scene.further:
            unit, _ = units(scene.coupled.mass, scene.sampling_period)
            K, theta = scene.engine.trace.limits(np.array(betas))
            hz = theta / (2 * math.pi * scene.sampling_period)
            return np.stack([K * unit, hz]).reshape(2, *damping.shape)
        found = [scene.limit(*extremes.stiffest_at(float(b), gamma, delta, delay)) for b in betas]
        table = np.array([(one.K, one.frequency_hz) for one in found]).reshape(-1, 2).T
        return table.reshape(2, *damping.shape)

    return _limits(rows, B, scene)


def passive_limit_at(scene: DeviceLoop, B: Any) -> Limit:
    """The largest passive stiffness at a damping, or at each of many, of the device alone (3)."""
    scene = scene.device
    _, delta, delay = scene.dimensionless
    period = scene.sampling_period
    _, scale = per_unit(scene.mass_or_inertia, period)

    def rows(damping: NDArray[np.float64]) -> NDArray[np.float64]:
        beta = arguments.unitless("B", damping, damping * scale)
        if scene.further:
            found = scene.engine.needs.limits(beta.ravel(), delta)
            alpha, theta = (each.reshape(beta.shape) for each in found)
        else:
            alpha, _, theta = passivity.stiffest_passive_at(beta, delta, delay)
        unit_K, _ = units(scene.mass_or_inertia, period)
        return np.stack([alpha * unit_K, theta / (2 * math.pi * period)])

    return _limits(rows, B, scene)


def _limits(
    rows: Callable[[NDArray[np.float64]], NDArray[np.float64]], B: Any, scene: DeviceLoop
) -> Limit:
    """K and the frequency at a damping, or at each of many, labelled as these are."""
    stiff, damped = scene.unit("N/m"), scene.unit("N*s/m")
    if not (isinstance(B, list | tuple) or getattr(B, "ndim", None)):
        one = number("B", B, damped)
        K, hz = rows(np.asarray(one))
        return Limit(float(K), one, float(hz))

    def finite(damping: NDArray[np.float64]) -> NDArray[np.float64]:
        arguments.refuse("B", damping, ~np.isfinite(damping), "finite numbers")
        return rows(damping)

    @kept(K=float, B=float, frequency_hz=float)
    def answer(B: Any) -> Any:
        given = Given(B=B)
        K, hz = given.by_numpy(finite, 2)
        return K, given.values[0], hz

    K, damping, hz = answer(in_unit("B", B, damped))
    units = ((K, stiff), (damping, damped), (hz, "Hz"))
    return Limit(*(with_unit(found, unit, B) for found, unit in units))


_STEP = 1e-4
"""By this part the parameters are changed to see what comes of it."""


def sensitivity(scene: DeviceLoop, B: float | None = None) -> dict[str, float]:
    """Change of the stiffness limit in per cent for a 1 % increase of each parameter."""
    here, found = _limit(scene, B), {}
    for name, value in _parameters(scene).items():
        # forward: at an integer delay the slope to the left is another one
        step = -_STEP if name == "velocity_weight" else _STEP  # a weight may be 1, which is most
        more, most = (_limit(_changed(scene, name, value * (1 + n * step)), B) for n in (1, 2))
        found[name] = (4 * more - 3 * here - most) / (2 * step * here)
    return found


_OF_PARTS = ("velocity", "actuator", "structure", "coupling")


def _parameters(scene: DeviceLoop) -> dict[str, float]:
    """The parameters that are not 0, by their names; those of arm and parts with theirs before."""
    own = "mass", "inertia", "damping", "stiffness"
    owners: list[tuple[str, Any, Iterable[str]]] = [("", scene, own)]
    if scene.arm is not None:
        owners.append(("arm_", scene.arm, own))
    late = ("delay", "delay_samples") if scene.integrator == "hold" else ()
    owners.append(("", scene, ("sampling_period", *late, "virtual_mass")))
    for part in _OF_PARTS:
        of: Any = getattr(scene, part)
        of = of.velocity if isinstance(of, Oversampled) else of
        if of is not None:
            without = "damping_ratio" if getattr(of, "order", 2) == 1 else ""
            names = [each.name for each in fields(of) if each.init and each.name != without]
            owners.append((f"{part}_", of, names))
    found = {f"{part}{name}": getattr(of, name) for part, of, names in owners for name in names}
    return {name: value for name, value in found.items() if isinstance(value, float) and value}


def _limit(scene: DeviceLoop, B: float | None) -> float:
    return float(max_stable_stiffness(scene) if B is None else limit_at(scene, B).K)


def _changed(scene: DeviceLoop, name: str, value: Any) -> DeviceLoop:
    """The scene with another value of a parameter, of its own or of its arm or of a part."""
    owner, _, own = name.partition("_")
    if owner in ("arm", *_OF_PARTS):
        part: Any = getattr(scene, owner)
        if isinstance(part, Oversampled):
            inner: Any = part.velocity
            own, value = "velocity", replace(inner, **{own: value})
        return replace(scene, **{owner: replace(part, **{own: value})})
    changed: dict[str, Any] = {name: value}
    if name == "sampling_period" and scene.integrator != "hold" and scene.delay:
        changed |= {"delay": None, "delay_samples": float(scene.periods)}
    return replace(scene, **changed)


def stable_region(scene: DeviceLoop) -> StableWalls:
    """The region of the (K, B) plane."""
    from shapely.affinity import scale

    found = scene.engine.trace if scene.further else tracing.stable_region(*scene.dimensionless)
    own = units(scene.coupled.mass, scene.sampling_period)
    return StableWalls(scene, found, scale(found.polygon, *own, origin=(0, 0)), found.corners * own)
