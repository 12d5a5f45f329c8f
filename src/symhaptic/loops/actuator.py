"""An amplifier, or a torque loop, that follows its command with a lag of first order."""

from __future__ import annotations

from dataclasses import dataclass

from symhaptic.loops.number import Number
from symhaptic.loops.plant import Plant
from symhaptic.notation.quantities import number


def lagging(plant: Plant, tau: Number) -> Plant:
    """tau force' = command - force, before the plant; tau in sampling periods."""
    rows = [(*row, enters) for row, enters in zip(plant.state, plant.force, strict=True)]
    nothing = (0,) * len(plant.state)
    return Plant(
        (*rows, (*nothing, -1 / tau)),
        (*nothing, 1 / tau),
        (*plant.position, 0),
        (*plant.velocity, 0),
        plant.free,
    )


@dataclass(frozen=True, kw_only=True)
class Lag:
    """An actuator that follows its command as 1/(tau s + 1).

    Parameters
    ----------
    time_constant : float or str
        tau in s, > 0.

    Raises
    ------
    ValueError
        If the time constant is not a positive number.

    Examples
    --------
    >>> Lag(time_constant=0.001).words
    'lag of first order, 0.001 s'
    """

    time_constant: float

    def __post_init__(self) -> None:
        value = number("time_constant", self.time_constant, "s", "> 0")
        object.__setattr__(self, "time_constant", value)

    def before(self, plant: Plant, mass: float, period: float) -> Plant:
        """The plant behind this actuator."""
        return lagging(plant, self.time_constant / period)

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"lag of first order, {self.time_constant:g} s"
