"""m = m_D + m_H, b = b_D + b_H, k = k_H: a device coupled to an arm, by (2) of the paper."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeAlias

from symhaptic.notation.quantities import decimal, nearest, number, shown
from symhaptic.notation.suggest import suggested
from symhaptic.notation.units import said

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

    from symhaptic.rules.devices import Device

UNITS = {"mass": "kg", "inertia": "kg", "damping": "N*s/m", "stiffness": "N/m"}
ROTARY = {"kg": "kg*m**2", "N*s/m": "N*m*s/rad", "N/m": "N*m/rad", "N": "N*m", "m": "rad"}
"""Units of motion along a line, and those of rotation that take their place."""


@dataclass(frozen=True, kw_only=True, repr=False)
class Arm:
    """Mass-spring-damper model of the arm that holds the device, eq. (2).

    Parameters
    ----------
    mass : float or str
        m_H in kg, >= 0.
    inertia : float or str
        Moment of inertia of a rotary arm in kg m^2, >= 0, instead of the mass.
    damping : float or str, optional
        b_H in Ns/m, >= 0; for a rotary arm in N m s/rad.
    stiffness : float or str, optional
        k_H in N/m, >= 0; for a rotary arm in N m/rad.
    with_device : bool, optional
        Whether the numbers are those of an arm and its device together.

    Raises
    ------
    ValueError
        If a value is negative, infinite, NaN or of the wrong dimension.

    Notes
    -----
    Numbers become float64; text with a unit and quantities of Pint are converted.  :meth:`of`
    returns an arm of Table II.

    Examples
    --------
    >>> Arm.of("Hogan")
    Arm(mass=0.8, damping=5.5, stiffness=568.0, with_device=False)
    """

    mass: float | None = None
    """m_H in kg, >= 0."""
    inertia: float | None = None
    """Moment of inertia in kg m^2, >= 0, instead of the mass."""
    damping: float = 0.0
    """b_H in Ns/m, >= 0."""
    stiffness: float = 0.0
    """k_H in N/m, >= 0."""
    with_device: bool = False
    """Whether the numbers are those of an arm and its device together."""

    def __post_init__(self) -> None:
        one_of("mass", self.mass, "inertia", self.inertia)
        for name, unit in UNITS.items():
            value = getattr(self, name)
            if value is not None:
                own = ROTARY[unit] if self.rotary else unit
                object.__setattr__(self, name, number(name, value, own, ">= 0"))

    @property
    def rotary(self) -> bool:
        """Whether the arm turns."""
        return self.inertia is not None

    @classmethod
    def of(cls, name: str) -> Arm:
        """The arm in a row of Table II of the paper.

        Parameters
        ----------
        name : str
            One of :meth:`names`.

        Returns
        -------
        Arm
            With the published mass, damping and stiffness.

        Raises
        ------
        ValueError
            If the table has no such row.

        Examples
        --------
        >>> Arm.of("Lawrence and Chapel").mass
        0.5
        """
        from symhaptic.paper.tables import TABLE_II

        row = _named("name", name, {row.authors: row for row in TABLE_II})
        return cls(
            mass=float(row.mass),
            damping=float(row.damping),
            stiffness=float(row.stiffness),
            with_device=row.with_device,
        )

    def __repr__(self) -> str:
        return without_defaults(self, "mass", "inertia")

    def __str__(self) -> str:
        """In words, with units."""
        numbers = mass_or_inertia(self), self.damping, self.stiffness
        words = ", ".join(
            f"{value:g} {said(ROTARY[unit] if self.rotary else unit)}"
            for value, unit in zip(numbers, ("kg", "N*s/m", "N/m"), strict=True)
        )
        return f"{words}, measured with its device" if self.with_device else words

    @staticmethod
    def names() -> list[str]:
        """The authors of the rows of Table II.

        Returns
        -------
        list of str
            In the order of the table.

        Examples
        --------
        >>> len(Arm.names()), Arm.names()[0]
        (11, 'Daniel et al.')
        """
        from symhaptic.paper.tables import TABLE_II

        return [row.authors for row in TABLE_II]


def checked(arm: Any, rotary: bool) -> Arm:
    """The argument, which has to be an :class:`Arm` that turns or moves as the device does."""
    if not isinstance(arm, Arm):
        raise ValueError(f"arm: {shown(arm)} is not allowed; give an Arm")
    if arm.rotary != rotary:
        allowed = "Arm(inertia=...) for a rotary device" if rotary else "Arm(mass=...)"
        raise ValueError(f"arm: {shown(arm)} is not allowed; give {allowed}")
    return arm


def one_of(name: str, value: Any, other: str, instead: Any) -> None:
    """Raise :class:`ValueError` unless exactly one of two arguments is given."""
    if value is None and instead is None:
        raise ValueError(f"{name}: is missing; give {name} or {other}")
    if value is not None and instead is not None:
        given = f"{shown(instead)} and {name}={shown(value)}"
        raise ValueError(f"{other}: {given} exclude each other; give one of them")


def without_defaults(part: DataclassInstance, *names: str) -> str:
    """As a dataclass is shown, without the fields of these names that have their defaults."""
    values = ((field, getattr(part, field.name)) for field in fields(part))
    given = (
        f"{field.name}={value!r}"
        for field, value in values
        if field.name not in names or value != field.default
    )
    return f"{type(part).__qualname__}({', '.join(given)})"


class _Moved(Protocol):
    """A device or an arm."""

    @property
    def mass(self) -> float | None: ...
    @property
    def inertia(self) -> float | None: ...


def mass_or_inertia(of: _Moved) -> float:
    """The mass, or the moment of inertia of what turns."""
    return next(value for value in (of.mass, of.inertia) if value is not None)


class Coupled(NamedTuple):
    """Device and arm together, (2): the sums of their masses, dampings and stiffnesses."""

    mass: float
    """m in kg; of a rotary device the moment of inertia in kg m^2."""
    damping: float | None
    """b in Ns/m or N m s/rad; ``None`` if neither has a damper."""
    stiffness: float | None
    """k in N/m or N m/rad; ``None`` if neither has a spring."""


def added(arm: Arm, name: str, own: float | None) -> float:
    """The device's ``own`` mass, damping or stiffness and the arm's, summed as decimals."""
    of_device = Fraction(0) if arm.with_device else decimal(own or 0)
    of_arm = mass_or_inertia(arm) if name == "mass" else getattr(arm, name)
    return nearest(decimal(of_arm) + of_device)


Range: TypeAlias = float | tuple[float, float]
"""One number, or the lowest and the highest."""

_HEAVIEST = 23.0
"""kg: the heaviest arm of Table II and 30 % more, as (23) extends the others."""


@dataclass(frozen=True, kw_only=True, repr=False)
class ArmRange:
    """Range of arms: a number, or (lowest, highest), for each parameter.

    Parameters
    ----------
    mass : float or (float, float), optional
        m_H in kg.  The default is 0 (no arm) to 23, the heaviest arm of Table II plus 30 %.
    inertia : float or (float, float), optional
        Moment of inertia of rotary arms in kg m^2, instead of the mass.
    damping : float or (float, float), optional
        b_H in Ns/m or N m s/rad, whatever the mass.
    stiffness : float or (float, float), optional
        k_H in N/m or N m/rad, whatever the mass.
    damping_per_mass : float or (float, float), optional
        b_H/m_H in 1/s, instead of the damping.  The default is 0 to 20, by (23) of the paper.
    stiffness_per_mass : float or (float, float), optional
        k_H/m_H in 1/s^2, instead of the stiffness.  The default is 0 to 1000, by (23) of the paper.

    Raises
    ------
    ValueError
        If a value is negative, infinite or in the wrong order, or if one parameter has two ranges.

    Notes
    -----
    (23) of the paper has delta <= 0.02 and gamma <= 0.001.  At 1 kHz these are b_H/m_H <= 20/s and
    k_H/m_H <= 1000/s^2, which then hold at any sampling rate.

    Examples
    --------
    >>> ArmRange(mass=(0.5, 2), damping=6, stiffness=(0, 600)).hands
    ((0.5, 2.0), (6.0, 6.0), (0.0, 600.0))
    """

    mass: Range | None = None
    inertia: Range | None = None
    damping: Range | None = None
    stiffness: Range | None = None
    damping_per_mass: Range | None = None
    stiffness_per_mass: Range | None = None

    def __post_init__(self) -> None:
        for part, default in (("damping", (0.0, 20.0)), ("stiffness", (0.0, 1000.0))):
            per = f"{part}_per_mass"
            both = getattr(self, part), getattr(self, per)
            if all(given is not None for given in both):
                given = f"{both[1]!r} and {part}={both[0]!r}"
                raise ValueError(f"{per}: {given} exclude each other; give one of them")
            elif all(given is None for given in both):
                object.__setattr__(self, per, default)
        if self.mass is None and self.inertia is None:
            object.__setattr__(self, "mass", (0.0, _HEAVIEST))
        one_of("mass", self.mass, "inertia", self.inertia)
        for name, unit in _RANGED.items():
            value = getattr(self, name)
            if value is not None:
                own = ROTARY.get(unit, unit) if self.rotary else unit
                object.__setattr__(self, name, _ends(name, value, own))

    @property
    def rotary(self) -> bool:
        """Whether the arms turn."""
        return self.inertia is not None

    @classmethod
    def around(cls, arms: Iterable[Arm]) -> ArmRange:
        """The smallest range that contains all the arms.

        Parameters
        ----------
        arms : iterable of Arm
            At least one arm.

        Returns
        -------
        ArmRange
            With ranges of mass, damping and stiffness.

        Examples
        --------
        >>> ArmRange.around([Arm.of("Hogan"), Arm.of("Lee et al.")]).mass
        (0.15, 0.8)
        """
        some = list(arms) if isinstance(arms, Iterable) else []
        if not some or not all(isinstance(arm, Arm) for arm in some):
            raise ValueError(f"arms: {shown(arms)} is not allowed; give one or more Arm(...)")
        if any(arm.with_device for arm in some):
            raise ValueError(
                "arms: one was measured together with its device; give arms without a device"
            )
        if len({arm.rotary for arm in some}) > 1:
            raise ValueError("arms: some have a mass and some an inertia; give all of one kind")
        names = ("inertia" if some[0].rotary else "mass", "damping", "stiffness")
        ends = {
            name: (min(getattr(a, name) for a in some), max(getattr(a, name) for a in some))
            for name in names
        }
        return cls(**ends)

    def __repr__(self) -> str:
        return without_defaults(self, "mass", "inertia")

    @property
    def by_mass(self) -> tuple[bool, bool]:
        """Whether damping and stiffness are given per mass."""
        return self.damping is None, self.stiffness is None

    @property
    def hands(self) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
        """Ranges of mass, damping and stiffness; the last two per mass if ``by_mass``."""
        damping = self.damping_per_mass if self.damping is None else self.damping
        stiffness = self.stiffness_per_mass if self.stiffness is None else self.stiffness
        mass = self.mass if self.inertia is None else self.inertia
        return mass, damping, stiffness  # type: ignore[return-value]

    def __str__(self) -> str:
        """In words, with units."""
        own = ROTARY if self.rotary else {}
        units = (said(own.get(unit, unit)) for unit in ("kg", "N*s/m", "N/m"))
        per = f" per {said(ROTARY['kg'] if self.rotary else 'kg')}"
        return ", ".join(
            (f"{low:g}" if low == high else f"{low:g} to {high:g}")
            + f" {unit}"
            + (per if by else "")
            for (low, high), unit, by in zip(self.hands, units, (False, *self.by_mass), strict=True)
        )


def checked_range(arms: ArmRange, rotary: bool) -> ArmRange:
    """The range, which has to be of arms that turn or move as the device does."""
    if arms.rotary != rotary:
        name, range_ = ("inertia", "[0, 1e-4]") if rotary else ("mass", "[0, 5]")
        raise ValueError(
            f"{name}: is missing in the range of arms; the device has the {name}, so give the "
            f"arms theirs, such as {name} = {range_}"
        )
    return arms


_RANGED = {
    "mass": "kg",
    "inertia": "kg",
    "damping": "N*s/m",
    "stiffness": "N/m",
    "damping_per_mass": "1/s",
    "stiffness_per_mass": "1/s**2",
}


def _ends(name: str, value: Any, unit: str) -> tuple[float, float]:
    pair = value if isinstance(value, tuple | list) else (value, value)
    if len(pair) != 2:
        raise ValueError(f"{name}: {shown(value)} is not allowed; give a number or (low, high)")
    low, high = (number(name, end, unit, ">= 0") for end in pair)
    if low > high:
        raise ValueError(f"{name}: {shown(value)} is not allowed; the lowest comes first")
    return low, high


def device(name: str) -> Device:
    """A published device by its name.

    Raises :class:`ValueError` for a name that is not there.

    >>> device("novint falcon").K
    '3000'
    """
    from symhaptic.rules.devices import DEVICES

    found: Device = _named("device", name, {each.name: each for each in DEVICES})
    return found


def of_device(name: str) -> dict[str, float]:
    """Mass and damping of a published device, as far as they are published."""
    found = device(name)
    numbers = (("mass", found.mass), ("damping", found.damping))
    return {key: float(value) for key, value in numbers if value is not None}


def published() -> dict[str, dict[str, float | str | None]]:
    """What :meth:`symhaptic.scene.scene.Scene.devices` returns."""
    from symhaptic.rules.devices import DEVICES

    numbers = ("mass", "damping", "K", "B")
    return {
        each.name: {
            **{n: None if (v := getattr(each, n)) is None else float(v) for n in numbers},
            "source": each.source,
        }
        for each in DEVICES
    }


def _named(argument: str, name: str, known: dict[str, Any]) -> Any:
    """By its name, whatever its capitals."""
    folded = {each.casefold(): value for each, value in known.items()}
    if not isinstance(name, str) or name.casefold() not in folded:
        told = suggested(str(name), known)
        raise ValueError(f"{argument}: {shown(name)} is not allowed; {told}")
    return folded[name.casefold()]
