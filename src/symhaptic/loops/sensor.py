"""A sensor of finite resolution, and the friction that its steps need."""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass, field

from symhaptic.notation.quantities import number_in


def quantisation_limit(resolution: float, friction: float) -> float:
    """2 f_c/Delta in N/m: the stiffness up to which friction takes what the steps give, B = 0."""
    return 2 * friction / resolution if resolution else math.inf


@dataclass(frozen=True, kw_only=True)
class Encoder:
    """A position sensor that rounds to the nearest of equally spaced steps.

    Parameters
    ----------
    resolution : float or str
        Delta in m, or in rad for a rotary device, > 0: one step.

    Raises
    ------
    ValueError
        If the resolution is not a positive number.

    Examples
    --------
    >>> Encoder(resolution="20 um").words
    'steps of 2e-05 m'
    >>> Encoder(resolution="0.9 deg").unit
    'rad'
    """

    resolution: float
    unit: str = field(init=False, repr=False, compare=False, default="")
    """``"m"`` or ``"rad"`` if the resolution was given with a unit, or nothing."""

    def __post_init__(self) -> None:
        value, unit = number_in("resolution", self.resolution, ("m", "rad"), "> 0")
        object.__setattr__(self, "resolution", value)
        object.__setattr__(self, "unit", unit)

    def fitting(self, unit: str) -> Encoder:
        """The encoder of a device that moves in m or rad.

        Raises :class:`ValueError` if the resolution was given in the other unit.
        """
        if self.unit not in ("", unit):
            raise ValueError(
                f"encoder: a resolution in {self.unit} does not fit this device; give it in {unit}"
            )
        found = copy(self)
        object.__setattr__(found, "unit", unit)
        return found

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"steps of {self.resolution:g} {self.unit or 'm'}"
