"""What a scene is made of: a device, its arm, its period and its delay, in SI units and without.

gamma = k T^2/m, delta = b T/m, d = t_d/T, and limits back in SI units.
"""

from __future__ import annotations

import copy
import math
import warnings
from dataclasses import InitVar, dataclass, replace
from fractions import Fraction
from functools import lru_cache
from numbers import Real
from typing import Any, Self, TypeVar

from symhaptic.loops.actuator import Lag
from symhaptic.loops.engine import LARGE, SMALL, STEPS, Engine
from symhaptic.loops.loop import SHORT
from symhaptic.loops.oversampled import Oversampled
from symhaptic.loops.sensor import Encoder
from symhaptic.loops.structure import Coupling, SecondMass
from symhaptic.loops.system import LinearDevice
from symhaptic.loops.velocity import Difference, Measured, Velocity
from symhaptic.model.parts import Parts
from symhaptic.notation.quantities import decimal, nearest, number, shown
from symhaptic.notation.sizes import LARGEST, LONGEST, STIFFEST
from symhaptic.notation.units import said
from symhaptic.scene.arms import (
    ROTARY,
    Arm,
    Coupled,
    added,
    checked,
    mass_or_inertia,
    one_of,
    without_defaults,
)
from symhaptic.scene.dimensionless import Dimensionless, per_unit, units
from symhaptic.scene.limit import Limit

UNITS = {
    "mass": "kg",
    "inertia": "kg",
    "sampling_period": "s",
    "damping": "N*s/m",
    "stiffness": "N/m",
    "delay": "s",
    "delay_samples": "",
    "virtual_mass": "kg",
    "coulomb_friction": "N",
}
"""Units for motion along a line; :meth:`DeviceLoop.unit` has those for rotation."""

NOT_GIVEN: Any = None
"""The default of a number that another one may replace."""

_LONG = 100
"""A delay in s of more sampling periods than this is warned of."""

_WIDEST = 1e300
"""The largest unit of stiffness, and its inverse the smallest: beyond, no float holds a wall."""


@dataclass(frozen=True, kw_only=True, repr=False)
class DeviceLoop:
    """A device with its sampling period, its delay and its arm."""

    mass: float | None = None
    """m_D of the device in kg, > 0; ``None`` if it turns."""
    inertia: float | None = None
    """Moment of inertia of a rotary device in kg m^2, > 0, instead of the mass."""
    sampling_period: float = NOT_GIVEN
    """T in s, > 0."""
    sampling_rate: InitVar[float | None] = None
    """1/T in Hz, > 0, instead of the sampling period, in which it is kept."""
    damping: float | None = None
    """b_D of the device in Ns/m, >= 0."""
    stiffness: float | None = None
    """Stiffness of the device in N/m, >= 0."""
    delay: float | None = None
    """t_d in s, >= 0."""
    delay_samples: float | None = None
    """d in sampling periods, >= 0, if the delay is not given in s."""
    arm: Arm | None = None
    """The arm that holds the device."""
    dynamics: LinearDevice | None = None
    """Any linear device, instead of mass, damping, stiffness and arm."""
    velocity: Velocity | None = None
    """What the wall uses as the velocity; the difference of two samples if left out."""
    actuator: Lag | None = None
    """What is between the command and the force."""
    structure: SecondMass | None = None
    """A second mass on a spring."""
    integrator: str = "hold"
    """How the device moves: under held forces, or as a simulator moves it."""
    virtual_mass: float | None = None
    """M of the wall in kg, >= 0."""
    coupling: Coupling | None = None
    """A spring and a damper between the device and the wall."""
    encoder: Encoder | None = None
    """The steps of the sensor."""
    coulomb_friction: float | None = None
    """f_c of the device in N, >= 0."""

    def __post_init__(self, sampling_rate: float | None) -> None:
        if self.dynamics is None:
            one_of("mass", self.mass, "inertia", self.inertia)
        one_of("sampling_period", self.sampling_period, "sampling_rate", sampling_rate)
        if sampling_rate is not None:
            rate = decimal(number("sampling_rate", sampling_rate, "Hz", "> 0"))
            object.__setattr__(self, "sampling_period", nearest(1 / rate))
        for name, unit in UNITS.items():
            value = getattr(self, name)
            if value is not None:
                least = "> 0" if name in ("mass", "inertia", "sampling_period") else ">= 0"
                object.__setattr__(self, name, number(name, value, self.unit(unit), least))
        if self.delay is not None and self.delay_samples is not None:
            raise ValueError(
                f"delay_samples: {self.delay_samples!r} and delay={self.delay!r} exclude each "
                "other; give one of them"
            )
        for name, kind in _KINDS.items():
            part = getattr(self, name)
            if part is not None and not isinstance(part, kind):
                raise ValueError(f"{name}: {shown(part)} is not allowed; give {_EXAMPLES[name]}")
        for name in ("mass", "inertia", "damping", "stiffness", "arm", "structure"):
            if self.dynamics is not None and getattr(self, name) is not None:
                raise ValueError(
                    f"{name}: {shown(getattr(self, name))} cannot be used with dynamics, whose "
                    f"matrices describe the whole device; leave {name} out"
                )
        if self.structure is not None:
            fitting = self.structure.fitting("structure", self.rotary)
            object.__setattr__(self, "structure", fitting)
        if self.coupling is not None:
            object.__setattr__(self, "coupling", self.coupling.fitting("coupling", self.rotary))
            self._velocity_of_a_coupling()
        if self.encoder is not None:
            object.__setattr__(self, "encoder", self.encoder.fitting(self.unit("m")))
        if self.dynamics is not None and self.dynamics.jumps and self.velocity == Measured():
            raise ValueError(
                f"velocity: {self.velocity!r} cannot be used with dynamics whose velocity follows "
                "the force without delay; give Difference()"
            )
        if not isinstance(self.integrator, str) or self.integrator not in STEPS:
            allowed = ", ".join(map(repr, STEPS))
            raise ValueError(f"integrator: {shown(self.integrator)} is not allowed; give {allowed}")
        if self.integrator != "hold" and (self.actuator or self.structure or self.dynamics):
            raise ValueError(
                f"integrator: {self.integrator!r} moves one mass; leave out actuator, structure "
                "and dynamics, or give integrator='hold'"
            )
        if isinstance(self.velocity, Oversampled) and (
            self.integrator != "hold" or self.virtual_mass
        ):
            other = "virtual_mass" if self.virtual_mass else "integrator"
            raise ValueError(
                f"{other}: {getattr(self, other)!r} cannot be used with velocity=Oversampled(); "
                "give a velocity of one rate"
            )
        if self.arm is not None:
            checked(self.arm, self.rotary)
            for name, value in self.coupled._asdict().items():
                number(name, value, UNITS[name], "> 0" if name == "mass" else ">= 0")
        if self.delay is not None and self.periods > _LONG:
            warnings.warn(
                f"delay: {self.delay!r} s are {nearest(self.periods):g} sampling periods; "
                f"a delay of {self.delay!r} periods is delay_samples={self.delay!r}",
                stacklevel=3,
            )

    def _velocity_of_a_coupling(self) -> None:
        """Raise :class:`ValueError` for velocities that the point behind the coupling has not."""
        of = self.velocity or Difference()
        if isinstance(of, Measured | Oversampled) or of.over > SHORT:
            raise ValueError(
                f"coupling: {self.coupling!r} with velocity={of!r} is not allowed; give a velocity "
                f"of one rate that is computed from at most {SHORT} samples or by a filter"
            )

    def __repr__(self) -> str:
        return without_defaults(self, "mass", "inertia", *_FURTHER)

    @property
    def further(self) -> tuple[str, ...]:
        """Names of the parts that the paper's loop does not have, in the order of the loop."""
        there = {
            "dynamics": self.dynamics is not None,
            "velocity": self.velocity not in (None, Difference()),
            "actuator": self.actuator is not None,
            "structure": self.structure is not None,
            "integrator": self.integrator != "hold",
            "virtual_mass": bool(self.virtual_mass),
            "coupling": self.coupling is not None,
        }
        return tuple(name for name, is_there in there.items() if is_there)

    def refuse_further(self, question: str, *without: str) -> None:
        """Raise :class:`ValueError` if the loop has parts for which a question has no answer.

        Parts in ``without`` do not matter to it.
        """
        for name in (name for name in self.further if name not in without):
            raise ValueError(
                f"{name}: {shown(getattr(self, name))} is not allowed for {question}; "
                f"leave out {name}"
            )

    def refuse_coupling(self, question: str) -> None:
        """Raise :class:`ValueError` if there is a coupling, for which a question has no answer."""
        self.refuse_further(question, *(name for name in self.further if name != "coupling"))

    @property
    def engine(self) -> Engine:
        """What answers for a loop with further parts; device and arm together."""
        return _engine(self)

    @property
    def rotary(self) -> bool:
        """Whether the device turns; its units are then kg m^2, N m s/rad and N m/rad."""
        return self.inertia is not None

    @property
    def mass_or_inertia(self) -> float:
        """The mass of the device in kg, or its moment of inertia in kg m^2; 1 of any dynamics."""
        return 1.0 if self.dynamics is not None else mass_or_inertia(self)

    def unit(self, linear: str) -> str:
        """The unit for this device that takes the place of one for motion along a line.

        >>> DeviceLoop(inertia=1e-4, sampling_period=1e-3).unit("N/m")
        'N*m/rad'
        """
        return ROTARY.get(linear, linear) if self.rotary else linear

    def printed(self, linear: str) -> str:
        """The same unit as it is printed."""
        return said(self.unit(linear))

    @property
    def device(self) -> Self:
        """The scene of the device without the arm; passivity uses it, (3)."""
        if self.arm is None:
            return self
        alone = copy.copy(self)
        object.__setattr__(alone, "arm", None)
        return alone

    @property
    def coupled(self) -> Coupled:
        """Mass, damping and stiffness of device and arm together; stability uses them, (2)."""
        if self.arm is None:
            return Coupled(self.mass_or_inertia, self.damping, self.stiffness)
        own = Coupled(self.mass_or_inertia, self.damping, self.stiffness)
        return Coupled(*(added(self.arm, name, part) for name, part in own._asdict().items()))

    @property
    def parts(self) -> Parts:
        """Parts of the loop, with the arm's damper and spring."""
        _, damping, stiffness = self.coupled
        return Parts(
            stiffness=stiffness is not None,
            damping=damping is not None,
            delay=self.delay is not None or self.delay_samples is not None,
        )

    @property
    def periods(self) -> Fraction:
        """The delay in sampling periods, exactly; 0 if there is none."""
        if self.delay_samples is not None:
            return decimal(self.delay_samples)
        delay, period = self.delay or 0.0, self.sampling_period
        exact = decimal(delay) / decimal(period)
        # 3 * 1e-4 is not the number that 3e-4 is, but it is what three periods are in floats; nor
        # is a period of 1/3000 s exact, of which 7/3000 s are seven
        whole, rate = Fraction(round(exact)), round(1 / decimal(period))
        of_rate = rate and period == nearest(Fraction(1, rate)) and delay == nearest(whole / rate)
        return whole if of_rate or nearest(whole) * period == delay else exact

    @property
    def dimensionless(self) -> Dimensionless:
        """gamma, delta and the delay d in periods; 0 for what is not modelled.

        gamma and delta are those of device and arm together, (2), for stability.  Passivity uses
        those of the device alone, ``scene.device.dimensionless``.

        Raises
        ------
        ValueError
            If a number is outside the range of the functions.
        """
        return _dimensionless(self)

    def limit(self, alpha: Any, beta: Any, theta: Any) -> Limit:
        """K = alpha m/T^2 in N/m, B = beta m/T in Ns/m, f = theta/(2 pi T) in Hz.

        m is the mass of device and arm together, or for a rotary device the moment of inertia; K
        and B are then in N m/rad and N m s/rad.

        Raises
        ------
        ValueError
            If an argument is not one number.

        Examples
        --------
        >>> limit = DeviceLoop(mass=0.1, sampling_period=0.001).limit(0.5, 0.25, 1.0)
        >>> round(limit.K, 6), round(limit.B, 6), round(limit.frequency_hz, 3)
        (50000.0, 25.0, 159.155)
        """
        given = {"alpha": alpha, "beta": beta, "theta": theta}
        for name, value in given.items():
            if not isinstance(value, Real) and getattr(value, "shape", None) != ():
                raise ValueError(f"{name}: {shown(value)} is not allowed; give one number")
        period = self.sampling_period
        unit_K, unit_B = units(self.coupled.mass, period)
        return Limit(
            float(alpha) * unit_K,
            float(beta) * unit_B,
            float(theta) / (2 * math.pi * period),
        )


AnyLoop = TypeVar("AnyLoop", bound=DeviceLoop)


@lru_cache(maxsize=256)
def _dimensionless(loop: DeviceLoop) -> Dimensionless:
    moved = loop.coupled
    period, mass = decimal(loop.sampling_period), decimal(moved.mass)
    heavy = f"{'inertia' if loop.rotary else 'mass'}={moved.mass!r}"
    if not all(1 / _WIDEST <= size <= _WIDEST for size in (period**2, mass / period**2)):
        raise ValueError(
            f"sampling_period: {loop.sampling_period!r} with {heavy} is not allowed; "
            f"give T^2 and m/T^2 from {1 / _WIDEST:g} to {_WIDEST:g}, in s^2 and "
            f"{loop.printed('N/m')}"
        )
    found = Dimensionless(
        gamma=nearest(decimal(moved.stiffness or 0) * period**2 / mass),
        delta=nearest(decimal(moved.damping or 0) * period / mass),
        delay=nearest(loop.periods),
    )
    late = "delay" if loop.delay_samples is None else "delay_samples"
    for name, own, formula, value, most in (
        ("stiffness", moved.stiffness, "k T^2/m", found.gamma, STIFFEST),
        ("damping", moved.damping, "b T/m", found.delta, LARGEST),
        (late, getattr(loop, late), "t_d/T", found.delay, LONGEST),
    ):
        if value > most:
            of = f"with {heavy} and sampling_period={loop.sampling_period!r}"
            given = f"{name}: {own!r} {of}"
            raise ValueError(f"{given} is not allowed; give {formula} <= {most:g}")
    _check_parts(loop, heavy)
    return found


def _check_parts(loop: DeviceLoop, heavy: str) -> None:
    """Raise :class:`ValueError` if a further part is too small or too large beside the device.

    What is exactly 0 is no part.
    """
    mass, period = loop.coupled.mass, loop.sampling_period
    stiff, damped = per_unit(mass, period)
    per = {
        "mass": (1 / mass, "M/m"),
        "stiffness": (stiff, "k T^2/m"),
        "damping": (damped, "b T/m"),
        "time_constant": (1 / period, "tau/T"),
    }
    sizes = [("virtual_mass", "", loop.virtual_mass or 0.0, *per["mass"])]
    for part in ("actuator", "structure", "coupling"):
        own = getattr(loop, part)
        sizes += [(part, name, getattr(own, name, 0.0), *by) for name, by in per.items()]
    for part, name, value, unit, formula in sizes:
        least = 0.0 if part == "virtual_mass" else SMALL  # it vanishes with its size
        if value and not least <= value * unit <= LARGE:
            given = f"{part}: {name} {value!r}" if name else f"{part}: {value!r}"
            raise ValueError(
                f"{given} with {heavy} and sampling_period={period!r} is not allowed; "
                f"give {formula} from {least:g} to {LARGE:g}"
            )


_FURTHER = (
    *("dynamics", "velocity", "actuator", "structure", "integrator", "virtual_mass"),
    *("coupling", "encoder", "coulomb_friction"),
)
"""Parts that are shown only if they are there."""

_KINDS: dict[str, type] = {
    "dynamics": LinearDevice,
    "velocity": Velocity,
    "actuator": Lag,
    "structure": SecondMass,
    "coupling": Coupling,
    "encoder": Encoder,
}

_EXAMPLES = {
    "dynamics": "LinearDevice(A, B, C) or LinearDevice.of(system)",
    "velocity": 'a velocity such as LowPass(cutoff="50 Hz")',
    "actuator": 'Lag(time_constant="1 ms")',
    "structure": 'SecondMass(mass="20 g", stiffness="20 N/mm")',
    "coupling": 'Coupling(stiffness="2 N/mm")',
    "encoder": 'Encoder(resolution="20 um")',
}


@lru_cache(maxsize=256)
def _engine(loop: DeviceLoop) -> Engine:
    gamma, delta, delay = loop.dimensionless
    return Engine(
        gamma,
        delta,
        delay,
        loop.coupled.mass,
        loop.sampling_period,
        loop.velocity or Difference(),
        tuple(part for part in (loop.dynamics, loop.structure, loop.actuator) if part is not None),
        loop.integrator,
        loop.virtual_mass or 0.0,
        loop.coupling,
    )


@lru_cache(maxsize=256)
def wall_units(loop: DeviceLoop) -> tuple[float, float]:
    """T^2/m and T/m of device and arm together."""
    stiff, damped = per_unit(loop.coupled.mass, loop.sampling_period)
    return stiff, damped


def together(loop: AnyLoop) -> AnyLoop:
    """The loop of device and arm as one mass, damper and spring.

    Only stability may be asked of it: passivity would count the arm's damping.
    """
    if loop.arm is None:
        return loop
    mass, damping, stiffness = loop.coupled
    one = replace(loop.device, damping=damping, stiffness=stiffness)
    return replace(one, inertia=mass) if loop.rotary else replace(one, mass=mass)
