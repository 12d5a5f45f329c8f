"""A second mass behind a spring: a handle on a shaft that bends, or a load on a belt."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, field, fields
from typing import Self

from symhaptic.loops.number import Number
from symhaptic.loops.plant import Plant
from symhaptic.notation.quantities import number_in, shown

SENSORS = ("motor", "handle")

_UNITS = {
    "mass": ("kg", "kg*m**2", "> 0"),
    "stiffness": ("N/m", "N*m/rad", "> 0"),
    "damping": ("N*s/m", "N*m*s/rad", ">= 0"),
}

_WORDS = ("kg", "N/m", "Ns/m"), ("kg m^2", "N m/rad", "N m s/rad")


def coupled(plant: Plant, mass: Number, stiffness: Number, damping: Number, at: str) -> Plant:
    """A moving mass with a second one at a spring and a damper, in units of the first.

    The force drives the first mass; the sensor is on the first ("motor") or the second one
    ("handle").
    """
    (_, (gamma, delta)) = plant.state
    k, c = stiffness, damping
    there = (1, 0) if at == "motor" else (0, 1)
    return Plant(
        (
            (0, 1, 0, 0),
            (gamma - k, delta - c, k, c),
            (0, 0, 0, 1),
            (k / mass, c / mass, -k / mass, -c / mass),
        ),
        (0, 1, 0, 0),
        (there[0], 0, there[1], 0),
        (0, there[0], 0, there[1]),
        plant.free or gamma - k == -k,
    )


@dataclass(frozen=True, kw_only=True)
class _Sprung:
    """A part with a spring and a damper, along a line or of a rotation."""

    rotary: bool | None = field(init=False, repr=False, compare=False, default=None)
    """Whether the units were those of a rotation, or ``None`` for plain numbers."""

    def __post_init__(self) -> None:
        given = {}
        for name in (each.name for each in fields(self) if each.name in _UNITS):
            *units, least = _UNITS[name]
            value, given[name] = number_in(name, getattr(self, name), (units[0], units[1]), least)
            object.__setattr__(self, name, value)
        kinds = {_UNITS[name].index(unit) for name, unit in given.items() if unit}
        if len(kinds) > 1:
            said = ", ".join(f"{name} in {unit}" for name, unit in given.items() if unit)
            first = next(iter(given))
            raise ValueError(
                f"{first}: {said} are mixed; give all units for a line or all for a rotation"
            )
        object.__setattr__(self, "rotary", bool(kinds.pop()) if kinds else None)

    @property
    def words(self) -> str:
        """What a person reads of it."""
        raise NotImplementedError

    def fitting(self, part: str, rotary: bool) -> Self:
        """The part of a device that moves along a line, or of one that turns.

        Raises :class:`ValueError` if its units were those of the other one.
        """
        if self.rotary not in (None, rotary):
            raise ValueError(
                f"{part}: {self.words} do not fit this device; give {', '.join(_WORDS[rotary])}"
            )
        found = copy(self)
        object.__setattr__(found, "rotary", rotary)
        return found


@dataclass(frozen=True, kw_only=True)
class SecondMass(_Sprung):
    """A mass that the device moves through a spring and a damper.

    Parameters
    ----------
    mass : float or str
        The second mass in kg, > 0, or moment of inertia in kg m^2 of a rotary device.  The
        device's own is that of the motor's side.
    stiffness : float or str
        Of the spring between both, in N/m or N m/rad, > 0.
    damping : float or str
        Of the damper between both, in Ns/m or N m s/rad, >= 0.
    sensor : str
        ``"motor"``, where the force acts, or ``"handle"``, the second mass.

    Raises
    ------
    ValueError
        If a value is out of its range.

    Examples
    --------
    >>> SecondMass(mass=0.02, stiffness=20_000.0, damping=1.0).words
    '0.02 kg behind 20000 N/m and 1 Ns/m, sensor at the motor'
    """

    mass: float
    stiffness: float
    damping: float = 0.0
    sensor: str = "motor"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.sensor not in SENSORS:
            raise ValueError(
                f"sensor: {shown(self.sensor)} is not allowed; give 'motor' or 'handle'"
            )

    def before(self, plant: Plant, mass: float, period: float) -> Plant:
        """The plant with this mass at it."""
        return coupled(
            plant,
            self.mass / mass,
            self.stiffness * period**2 / mass,
            self.damping * period / mass,
            self.sensor,
        )

    @property
    def words(self) -> str:
        """What a person reads of it."""
        mass, stiffness, damping = _WORDS[bool(self.rotary)]
        return (
            f"{self.mass:g} {mass} behind {self.stiffness:g} {stiffness} and "
            f"{self.damping:g} {damping}, sensor at the {self.sensor}"
        )


@dataclass(frozen=True, kw_only=True)
class Coupling(_Sprung):
    """A virtual coupling: a spring and a damper in series between device and simulated wall.

    Parameters
    ----------
    stiffness : float or str
        K_c in N/m or N m/rad, > 0.
    damping : float or str
        B_c in Ns/m or N m s/rad, >= 0.

    Notes
    -----
    With C = K_c + B_c V and the wall W = K + B V + M (1 - 1/z)^2/T^2, where V makes the velocity,
    the device feels C W/(C + W): what a point without mass between both transmits, computed in the
    same sample.  A virtual mass is then that of the simulated tool, as in admittance control.

    Examples
    --------
    >>> Coupling(stiffness="2 N/mm", damping=5.0).words
    'coupling of 2000 N/m and 5 Ns/m'
    """

    stiffness: float
    damping: float = 0.0

    @property
    def words(self) -> str:
        """What a person reads of it."""
        _, stiffness, damping = _WORDS[bool(self.rotary)]
        return f"coupling of {self.stiffness:g} {stiffness} and {self.damping:g} {damping}"

    def without_units(self, mass: float, period: float) -> tuple[float, float]:
        """Stiffness and damping in units of the mass and the period."""
        return self.stiffness * period**2 / mass, self.damping * period / mass
