"""A second mass behind a spring: a handle on a shaft that bends, or a load on a belt."""

from __future__ import annotations

from dataclasses import dataclass

from symhaptic.loops.number import Number
from symhaptic.loops.plant import Plant
from symhaptic.notation.quantities import number, shown

SENSORS = ("motor", "handle")


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
    )


@dataclass(frozen=True, kw_only=True)
class SecondMass:
    """A mass that the device moves through a spring and a damper.

    Parameters
    ----------
    mass : float or str
        The second mass in kg, > 0; the device's own is that of the motor's side.
    stiffness : float or str
        Of the spring between both, in N/m, > 0.
    damping : float or str
        Of the damper between both, in Ns/m, >= 0.
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
        sizes = {"mass": ("kg", "> 0"), "stiffness": ("N/m", "> 0"), "damping": ("N*s/m", ">= 0")}
        for name, (unit, least) in sizes.items():
            object.__setattr__(self, name, number(name, getattr(self, name), unit, least))
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
        return (
            f"{self.mass:g} kg behind {self.stiffness:g} N/m and {self.damping:g} Ns/m, "
            f"sensor at the {self.sensor}"
        )
