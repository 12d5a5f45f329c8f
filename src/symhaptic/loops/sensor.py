"""A sensor of finite resolution, and the friction that its steps need."""

from __future__ import annotations

import math
from dataclasses import dataclass

from symhaptic.notation.quantities import number


def quantisation_limit(resolution: float, friction: float) -> float:
    """2 f_c/Delta in N/m: the stiffness up to which friction takes what the steps give, B = 0."""
    return 2 * friction / resolution if resolution else math.inf


@dataclass(frozen=True, kw_only=True)
class Encoder:
    """A sensor that tells the position in steps.

    Parameters
    ----------
    resolution : float or str
        Delta in m, > 0: one step, in which the position is rounded.

    Raises
    ------
    ValueError
        If the resolution is not a positive number.

    Examples
    --------
    >>> Encoder(resolution=2e-5).words
    'steps of 2e-05 m'
    """

    resolution: float

    def __post_init__(self) -> None:
        value = number("resolution", self.resolution, "m", "> 0")
        object.__setattr__(self, "resolution", value)

    @property
    def words(self) -> str:
        """What a person reads of it."""
        return f"steps of {self.resolution:g} m"
