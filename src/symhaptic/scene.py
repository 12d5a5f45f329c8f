"""What is in the loop, and so which symbols exist at all.

A part that a scene leaves out is not set to zero: the model is derived without it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from itertools import product
from numbers import Real
from typing import TYPE_CHECKING, Any, NamedTuple

from symhaptic.suggest import suggested

if TYPE_CHECKING:
    from symhaptic.simplest.choose import Simplest


@dataclass(frozen=True)
class Parts:
    """The parts of the loop beside the mass and the virtual spring, which are always there.

    >>> Parts(delay=False).name
    'stiffness, damping, virtual damping'
    """

    stiffness: bool = True
    """Physical stiffness k (dimensionless gamma)."""
    damping: bool = True
    """Physical damping b (dimensionless delta)."""
    virtual_damping: bool = True
    """Damping B of the wall (dimensionless beta)."""
    delay: bool = True
    """A delay of d sampling periods."""

    @property
    def name(self) -> str:
        """The parts that are there, in words."""
        present = [f.name.replace("_", " ") for f in fields(self) if getattr(self, f.name)]
        return ", ".join(present) or "mass and virtual spring only"

    def without(self, part: str) -> Parts:
        """The same loop with one part left out."""
        kept = {f.name: getattr(self, f.name) for f in fields(self)} | {part: False}
        return Parts(**kept)

    def present(self) -> list[str]:
        """Names of the parts that are there and could be left out."""
        return [f.name for f in fields(self) if getattr(self, f.name)]


FULL = Parts()


def left(words: str) -> Parts:
    """The loop that is left without what words say, such as ``"no-stiffness,no-delay"``.

    Raises :class:`ValueError` for a word that names no part.

    >>> left("no-stiffness,no-delay").name
    'damping, virtual damping'
    """
    parts = FULL
    allowed = [f"no-{part.replace('_', '-')}" for part in FULL.present()]
    for word in filter(None, (w.strip() for w in words.split(","))):
        if word == "no-mass":
            raise ValueError("no-mass: a loop without a mass has no motion to sample")
        if word not in allowed:
            raise ValueError(f"{word}: is not known; {suggested(word, allowed)}")
        parts = parts.without(word.removeprefix("no-").replace("-", "_"))
    return parts


ALL = tuple(Parts(*choice) for choice in product((True, False), repeat=4))
"""All sixteen scenes, the full one first."""


class Dimensionless(NamedTuple):
    """The plant and the delay in units of the mass and the sampling period (Table I)."""

    gamma: float
    """k T^2/m."""
    delta: float
    """b T/m."""
    delay: float
    """t_d/T."""


@dataclass(frozen=True, kw_only=True)
class Scene:
    """A device in SI units; a part that is left out (``None``) is not modelled.

    Raises :class:`ValueError` for a mass or period that is not positive, a negative damping,
    stiffness or delay, and for anything infinite or NaN.

    >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.001)
    >>> scene.dimensionless
    Dimensionless(gamma=0.0, delta=0.005, delay=1.0)
    >>> scene.parts.name
    'damping, virtual damping, delay'
    """

    mass: float
    """m in kg, device and arm together."""
    sampling_period: float
    """T in s."""
    damping: float | None = None
    """b in Ns/m."""
    stiffness: float | None = None
    """k in N/m."""
    delay: float | None = None
    """t_d in s."""

    def __post_init__(self) -> None:
        for field in fields(self):
            value = _plain(getattr(self, field.name))
            if value is None:
                continue
            object.__setattr__(self, field.name, value)
            least = "> 0" if field.name in ("mass", "sampling_period") else ">= 0"
            real = isinstance(value, Real) and math.isfinite(value)
            if not real or value < 0 or (least == "> 0" and value == 0):
                raise ValueError(
                    f"{field.name}: {value!r} is not allowed; finite numbers {least} are"
                )

    @property
    def parts(self) -> Parts:
        """What is in the loop."""
        return Parts(
            stiffness=self.stiffness is not None,
            damping=self.damping is not None,
            delay=self.delay is not None,
        )

    @property
    def dimensionless(self) -> Dimensionless:
        """gamma, delta and the delay in periods; 0 for what is not there."""
        period = self.sampling_period
        return Dimensionless(
            gamma=(self.stiffness or 0.0) * period**2 / self.mass,
            delta=(self.damping or 0.0) * period / self.mass,
            delay=(self.delay or 0.0) / period,
        )

    def max_stable_stiffness(self) -> float:
        """Largest stiffness in N/m of a stable wall, with the damping that allows it.

        >>> scene = Scene(mass=0.1, sampling_period=0.001)  # 4 (2 - r)(r - 1)/r m/T^2, r = sqrt 2
        >>> round(scene.max_stable_stiffness(), 3)
        68629.15
        """
        from symhaptic.tracer.extremes import max_stable_stiffness

        found = max_stable_stiffness(*self.dimensionless)
        return float(found.alpha) * self.mass / self.sampling_period**2

    def max_passive_stiffness(self) -> float:
        """Largest stiffness in N/m of a passive wall, with the damping that allows it.

        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
        >>> round(scene.max_passive_stiffness(), 6)  # 2 b/T
        1000.0
        """
        from symhaptic.numeric.passivity import max_passive_stiffness

        _, delta, delay = self.dimensionless
        found = max_passive_stiffness(delta, delay)
        return float(found.alpha) * self.mass / self.sampling_period**2

    def simplest(
        self,
        rtol: float,
        *,
        mass: float | tuple[float, float] | None = None,
        damping: float | tuple[float, float] | None = None,
        stiffness: float | tuple[float, float] | None = None,
        B: float | tuple[float, float] | None = None,
    ) -> Simplest:
        """The smallest model whose stiffness limit is proved to be within ``rtol`` of the scene's.

        The limit is :meth:`max_stable_stiffness`, or the largest stable stiffness of walls with
        the virtual damping ``B`` (Ns/m) where that is given; the error is |K_model/K - 1|.  Models
        are, the smallest first: the linear limit (25) (only with ``B``, as it grows with it), the
        loop without spring and damper, without spring, without damper, and all of it.

        ``mass``, ``damping``, ``stiffness`` and ``B`` take the scene's place: a number, or a range
        (lowest, highest) over which the bound holds.  Numbers are the decimals that they print as.
        Bounds are proved by ball arithmetic, for whole delays; what is not proved is infinite,
        with its reason, and does not count.

        Raises :class:`ValueError` for an ``rtol`` that is not > 0 and for an impossible range.

        >>> arm = Scene(mass=1.0, damping=2.0, stiffness=50.0, sampling_period=0.001, delay=0.001)
        >>> print(arm.simplest(0.01, damping=(0.0, 20.0)))
          linear limit: not proved: it has no largest stiffness, but grows with B; give B
          without stiffness and damping: below 6.66 %
        * without stiffness: below 0.0169 %
          without damping: below 6.68 %
          full: exact
        """
        from symhaptic.simplest.choose import simplest

        over = {"mass": mass, "damping": damping, "stiffness": stiffness, "B": B}
        return simplest(self, rtol, over)

    def to_control(self) -> Any:
        """The sampled device behind its delay, from N to m, for python-control.

        Raises :class:`ModuleNotFoundError` where that is not installed.
        """
        from symhaptic.systems import control_system

        return control_system(self)

    def to_scipy(self) -> Any:
        """The sampled device behind its delay, from N to m, as a ``scipy.signal.dlti``.

        >>> system = Scene(mass=1.0, sampling_period=1.0, delay=0.5).to_scipy()
        >>> system.num.tolist(), system.den.tolist()
        ([0.125, 0.75, 0.125], [1.0, -2.0, 1.0, 0.0])
        """
        from symhaptic.systems import scipy_system

        return scipy_system(self)

    def to_sympy(self) -> Any:
        """The sampled device behind its delay, from N to m, as SymPy's ``TransferFunction``."""
        from symhaptic.systems import sympy_system

        return sympy_system(self)

    def delay_margin(self, K: float, B: float) -> float:
        """Largest delay in s up to which the wall of stiffness ``K`` (N/m), ``B`` (Ns/m) is stable.

        The scene's own delay does not count.

        >>> scene = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
        >>> round(1000 * scene.delay_margin(K=1000.0, B=5.0), 3)  # ms
        4.401
        """
        from symhaptic.tracer.margin import delay_margin

        K, B = _plain(K), _plain(B)
        for name, value in (("K", K), ("B", B)):
            if not isinstance(value, Real) or not math.isfinite(value):
                raise ValueError(f"{name}: {value!r} is not allowed; finite numbers are")
        gamma, delta, _ = self.dimensionless
        scale = self.sampling_period / self.mass
        found = delay_margin(K * scale * self.sampling_period, B * scale, gamma, delta)
        return float(found) * self.sampling_period


def _plain(value: Any) -> Any:
    """A number that comes as an array without axes, or as NumPy's own kind, as Python's."""
    return value.item() if getattr(value, "ndim", None) == 0 else value
