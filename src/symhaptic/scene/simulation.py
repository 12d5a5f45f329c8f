"""The motion of a device at a wall over time, in SI units."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from symhaptic.loops.controller import Wall
from symhaptic.loops.simulate import simulate as course
from symhaptic.notation.extras import needed
from symhaptic.notation.quantities import decimal, in_unit, number, shown
from symhaptic.notation.units import said
from symhaptic.scene.loop import DeviceLoop

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

_MEANINGS: dict[str, tuple[str, str]] = {
    "position": ("position at the sensor", "m"),
    "velocity": ("velocity at the sensor", "m/s"),
    "force": ("force of the wall on the device", "N"),
    "measured_position": ("position that the controller has", "m"),
    "device_energy": ("kinetic energy and energy of the springs", "J"),
    "wall_energy": ("energy that the wall has given to the device", "J"),
    "external_energy": ("energy that the external force has given to the device", "J"),
    "damper_energy": ("energy that dampers have dissipated", "J"),
    "friction_energy": ("energy that Coulomb friction has dissipated", "J"),
    "integrator_energy": ("energy that the integrator has added", "J"),
}
"""What the arrays are, and their units for motion along a line."""


@dataclass(frozen=True, eq=False)
class Simulation:
    """Motion of a device at a wall: arrays of shape (n,), one value for each time.

    The units are those of the scene: m, m/s and N, or rad, rad/s and N m for a rotary device.
    Energies are in J and begin with 0 at time 0, except for that of the device.  They balance:
    the change of ``device_energy`` is ``wall_energy + external_energy - damper_energy -
    friction_energy``, and for a simulator's integrator ``+ integrator_energy``.
    """

    scene: DeviceLoop
    K: float
    B: float
    time: Array
    """In s."""
    position: Array
    """At the sensor; positive inside the wall."""
    velocity: Array
    """At the sensor."""
    force: Array
    """Of the wall on the device, behind the delay and the actuator.

    Where it changes, its new value."""
    measured_position: Array
    """At the last sample, in steps of the encoder."""
    device_energy: Array
    """Kinetic energy of all masses and energy of all springs, of device and arm together."""
    wall_energy: Array
    """What the wall has given; positive if the wall is active."""
    external_energy: Array
    """What the external force has given."""
    damper_energy: Array
    """What dampers have dissipated."""
    friction_energy: Array
    """What Coulomb friction has dissipated."""
    integrator_energy: Array | None = None
    """What the steps of a simulator have added; ``None`` for a device under held forces."""

    def __repr__(self) -> str:
        times = f"{len(self.time)} times to {self.time[-1]:g} s"
        return f"Simulation(K={self.K!r}, B={self.B!r}, {times})"

    def to_xarray(self) -> xarray.Dataset:
        """The arrays over ``time``, with their units and meanings as attributes.

        Raises :class:`ModuleNotFoundError` without the extra ``symhaptic[sweep]``.
        """
        needed("Simulation.to_xarray", "xarray", extra="sweep")
        import xarray

        found = {
            name: ("time", getattr(self, name), {"units": self._unit(unit), "long_name": meaning})
            for name, (meaning, unit) in _MEANINGS.items()
            if getattr(self, name) is not None
        }
        time = ("time", self.time, {"units": "s", "long_name": "time"})
        return xarray.Dataset(found, {"time": time}, {"K": self.K, "B": self.B})

    def plot(self, axes: Any = None) -> tuple[Axes, Axes]:
        """Draw the position, with what the encoder reports, and below it the energies.

        Parameters
        ----------
        axes : two of Matplotlib's axes, optional
            Where to draw; a new figure if left out.

        Returns
        -------
        tuple of two Axes
            For the position and for the energies.

        Raises
        ------
        ModuleNotFoundError
            Without Matplotlib.
        """
        if axes is None:
            needed("Simulation.plot", "matplotlib", extra="report")
            from matplotlib import pyplot

            size: dict[str, Any] = {"figsize": (7.2, 5.4), "layout": "constrained"}
            axes = pyplot.subplots(2, sharex=True, **size)[1]
        above, below = axes
        if self.scene.encoder is not None:
            above.step(
                self.time, self.measured_position, where="post", color="0.6", lw=0.8,
                label="measured",
            )  # fmt: skip
        above.plot(self.time, self.position, color="#1b6e4b", lw=1.2, label="position")
        above.axhline(0, color="black", lw=0.6)
        above.set(ylabel=f"position in {self._unit('m')}")
        for name, (_, unit) in _MEANINGS.items():
            energy = getattr(self, name)
            if unit == "J" and energy is not None and np.nan_to_num(energy).any():
                below.plot(self.time, energy, lw=1.2, label=name.removesuffix("_energy"))
        below.set(xlabel="time in s", ylabel="energy in J")
        for one in (above, below):
            one.spines[["top", "right"]].set_visible(False)
            if one.lines:
                one.legend(frameon=False, fontsize=9)
        return above, below

    def _unit(self, linear: str) -> str:
        return said(_unit(self.scene, linear))


def simulate(
    scene: DeviceLoop,
    K: Any,
    B: Any,
    *,
    duration: Any,
    position0: Any,
    velocity0: Any,
    external_force: Any,
    unilateral: bool,
    saturation: Any,
    samples_between: int,
) -> Simulation:
    """The motion from a start, with what the scene and the wall have."""
    mass, period = scene.coupled.mass, scene.sampling_period
    to_force, to_energy = mass / period**2, mass / period**2
    walls = number("K", K, scene.unit("N/m")), number("B", B, scene.unit("N*s/m"))
    count = _periods(number("duration", duration, "s", "> 0"), period)
    start = tuple(
        number(name, value, _unit(scene, unit))
        for name, value, unit in (("position0", position0, "m"), ("velocity0", velocity0, "m/s"))
    )
    if isinstance(samples_between, bool) or not isinstance(samples_between, int):
        raise ValueError(f"samples_between: {shown(samples_between)} is not allowed; give an int")
    simulator = scene.integrator != "hold"
    if samples_between < 0 or (samples_between and simulator):
        allowed = "0: a simulator has no time between its steps" if simulator else "an int >= 0"
        raise ValueError(f"samples_between: {samples_between} is not allowed; give {allowed}")
    most = None
    if saturation is not None:
        most = number("saturation", saturation, scene.unit("N"), ">= 0") / to_force
    engine = scene.engine
    engine.at_delay(engine.delay)  # a simulator refuses delays by a part of a period
    found = course(
        engine,
        Wall(
            walls[0] / to_force,
            walls[1] * period / mass,
            engine.virtual_mass / mass,
            bool(unilateral),
            most,
            None if scene.encoder is None else scene.encoder.resolution,
        ),
        (start[0], start[1] * period),
        _outside(scene, external_force, count) / to_force,
        (scene.coulomb_friction or 0.0) / to_force,
        samples_between,
    )
    with np.errstate(over="ignore", invalid="ignore"):
        energies = [work * to_energy for work in (found.energy, *found.works.values())]
        return Simulation(
            scene,
            *walls,
            found.time * period,
            found.position,
            found.velocity / period,
            found.force * to_force,
            found.measured,
            *energies,
        )


def _unit(scene: DeviceLoop, linear: str) -> str:
    """The unit for a scene; velocities and energies are not among those of :meth:`unit`."""
    return f"{scene.unit('m')}/s" if linear == "m/s" else scene.unit(linear)


def _periods(duration: float, period: float) -> int:
    """The periods that cover a duration; a last one by round-off alone is none."""
    exact = decimal(duration) / decimal(period)
    near = round(exact)
    count = near if near and abs(exact - near) < _NEAR * near else math.ceil(exact)
    if count > _MOST:
        raise ValueError(
            f"duration: {duration!r} s are {count} sampling periods; give at most {_MOST}"
        )
    return count


_NEAR = 1e-9
"""Part of a duration that is round-off of a period such as 1/3000 s."""

_MOST = 10_000_000
"""Sampling periods of a simulation; its arrays have to fit into the memory."""


def _outside(scene: DeviceLoop, force: Any, count: int) -> Array:
    """The external force in each period."""
    unit = scene.unit("N")
    if callable(force):
        call: Callable[[float], Any] = force
        times = (k * scene.sampling_period for k in range(count))
        return np.array([number("external_force", call(t), unit) for t in times])
    if isinstance(force, str) or not np.ndim(force):
        return np.full(count, number("external_force", force, unit))
    found = np.asarray(in_unit("external_force", force, unit), dtype=float)
    if found.shape != (count,) or not np.isfinite(found).all():
        raise ValueError(
            f"external_force: an array of shape {found.shape} is not allowed; give {count} finite "
            "numbers, one for each sampling period"
        )
    return found
