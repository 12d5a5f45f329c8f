"""Single numbers in SI units, as somebody wrote them."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from numbers import Rational, Real
from typing import Any

from symhaptic.notation import units


def number(name: str, value: Any, unit: str, least: str = "") -> float:
    """The value in ``unit`` as a float64; text with a unit and quantities of Pint are converted.

    Raises :class:`ValueError` for what is no finite number, or less than ``least`` says
    (``">= 0"``, ``"> 0"`` or nothing), and for units that cannot be converted.
    """
    if getattr(value, "ndim", None) == 0 and not hasattr(value, "units"):
        value = value.to_numpy()[()] if hasattr(value, "to_numpy") else value[()]
    given = value
    value = in_unit(name, value, unit)
    real = isinstance(value, Real) and not isinstance(value, bool)
    found = _float64(value) if real else math.nan
    low = (least and found < 0) or (least == "> 0" and found == 0)
    if low or not math.isfinite(found):
        allowed = f"finite numbers {least}".strip()
        raise ValueError(f"{name}: {shown(given)} is not allowed; give {allowed}")
    return found


def _float64(value: Any) -> float:
    """Of a number with fewer digits, the decimal that it prints as; infinite beyond all."""
    try:
        return float(value) if isinstance(value, Rational) else float(str(value))
    except OverflowError:
        return math.inf


def number_in(name: str, value: Any, units: tuple[str, str], least: str = "") -> tuple[float, str]:
    """The value in the one of two units in which it is given, and which one that is.

    The unit is ``""`` for a plain number, which fits both.
    """
    found = {}
    for unit in units:
        try:
            found[unit] = number(name, value, unit, least)
        except ValueError:
            continue
    if not found:
        number(name, value, units[0], least)
    unit, size = next(iter(found.items()))
    return size, unit if len(found) == 1 else ""


def _converted(name: str, quantity: Any, unit: str) -> Any:
    """Its number in ``unit``, or where ``unit`` is none, that of a quantity without dimension."""
    registry = quantity._REGISTRY
    wanted = registry.Unit(unit)
    if not quantity.is_compatible_with(wanted):
        allowed = f"a quantity that converts to {unit}" if unit else "a number without dimension"
        raise ValueError(f"{name}: {shown(quantity)} is not allowed; give {allowed}")
    root = registry.Quantity(1, quantity.units).to_root_units()
    angle = dict(root.unit_items()).get("radian", 0)
    if unit and not units.angle_fits(angle, unit):
        raise ValueError(f"{name}: {shown(quantity)} is not allowed; {units.other_angle(unit)}")
    return quantity.to(wanted).magnitude


_NUMBER = re.compile(r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(.*)", re.DOTALL)

_LONGEST = 5000
"""Characters of a number that are read; a whole number of more digits is none for Python."""


def _written(name: str, text: str, unit: str) -> float:
    """The number of a text in ``unit``: the decimal as it is written times the exact factor."""
    match = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    digits, written = match.groups() if match else ("nan", text[:_LONGEST])
    try:
        found = units.unit(written.strip(), unit)
    except units.UnknownUnit as wrong:
        raise ValueError(f"{name}: {shown(text)} is not allowed; {wrong}") from None
    size = float(digits)
    # beyond the range of floats the exact decimal may have any number of digits
    return nearest(Fraction(digits) * found.size) if math.isfinite(size) and size else size


def in_unit(name: str, values: Any, unit: str) -> Any:
    """The numbers in ``unit`` of quantities of Pint, also inside xarray's arrays, and of text.

    Others are returned as they are.
    """
    if isinstance(values, str):
        return _written(name, values, unit)
    if isinstance(values, list | tuple) and any(isinstance(value, str) for value in values):
        return [in_unit(name, value, unit) for value in values]
    if _of_pint(values):
        return _converted(name, values, unit)
    if _holds_pint(values):
        return values.copy(data=_converted(name, values.data, unit))
    return values


def with_unit(found: Any, unit: str, *given: Any) -> Any:
    """What was found in ``unit``, as a quantity of Pint's where one of the ``given`` is one.

    So it is inside xarray's arrays; arrays of pandas hold no quantities, and stay as they are.
    """
    library = type(found).__module__.partition(".")[0]
    quantities = [v if _of_pint(v) else v.data for v in given if _of_pint(v) or _holds_pint(v)]
    if not quantities or library == "pandas":
        return found
    quantity = quantities[0]._REGISTRY.Quantity
    if library == "xarray":
        return found.copy(data=quantity(found.data, unit))
    return quantity(found, unit)


def _of_pint(value: Any) -> bool:
    return type(value).__module__.partition(".")[0] == "pint"


def _holds_pint(value: Any) -> bool:
    """Whether an array of xarray's has a quantity inside."""
    of_xarray = type(value).__module__.partition(".")[0] == "xarray"
    return of_xarray and _of_pint(getattr(value, "data", None))


def dimensionless(name: str, quantity: Any) -> Any:
    """The numbers of a quantity of Pint's without dimension; :class:`ValueError` for others."""
    return _converted(name, quantity, "")


def shown(value: object) -> str:
    """The value on one line that fits a message."""
    if getattr(value, "ndim", None) == 0 and hasattr(value, "item"):
        value = value.item()
    try:
        text = " ".join(repr(value).split())
    except ValueError:  # too many digits
        return "an integer of thousands of digits"
    return text if len(text) <= 80 else f"{text[:77]}..."


def decimal(value: float | Fraction) -> Fraction:
    """The decimal that a number prints as: 0.0003 is 3/10000."""
    return Fraction(value) if isinstance(value, int | Fraction) else Fraction(repr(float(value)))


def nearest(value: Fraction) -> float:
    """The nearest float64; infinite beyond all of them."""
    try:
        return float(value)
    except OverflowError:
        return math.inf
