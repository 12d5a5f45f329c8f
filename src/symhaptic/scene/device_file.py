"""A device, its arm or a range of arms, its loop and its wall from a TOML file with units."""

from __future__ import annotations

import math
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symhaptic.notation.quantities import decimal, nearest
from symhaptic.notation.quantities import number as finite
from symhaptic.notation.suggest import suggested
from symhaptic.scene.arms import Arm, ArmRange
from symhaptic.scene.arms import device as published
from symhaptic.scene.scene import Scene

UNITS: dict[str, dict[str, float]] = {
    "kg": {"kg": 1.0, "g": 1e-3},
    "Ns/m": {"Ns/m": 1.0, "N s/m": 1.0, "Ns/mm": 1e3, "mNs/m": 1e-3},
    "N/m": {"N/m": 1.0, "N/mm": 1e3, "kN/m": 1e3},
    "s": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "\u00b5s": 1e-6, "\u03bcs": 1e-6},
    "1/s": {"1/s": 1.0, "Ns/m/kg": 1.0},
    "1/s^2": {"1/s^2": 1.0, "1/s²": 1.0, "N/m/kg": 1.0},
    "": {"": 1.0},
}
"""Spellings of each SI unit, and what they are in it; of mu there are two, which look the same."""

MOVED = {"mass": "kg", "damping": "Ns/m", "stiffness": "N/m"}
SCHEMA: dict[str, dict[str, str]] = {
    "": {**MOVED, "sampling_period": "s", "delay": "s", "delay_samples": ""},
    "arm": {**MOVED, "with_device": "true or false"},
    "arms": {**MOVED, "damping_per_mass": "1/s", "stiffness_per_mass": "1/s^2"},
    "wall": {"K": "N/m", "B": "Ns/m"},
}
"""Keys of each table with their units; those of the device and its loop stand at the top."""

NAMED = {"": "device", "arm": "name"}
"""The key of a table that names a published device, or a row of Table II."""

RANGED = "arms"
"""The table whose numbers may be pairs, the lowest and the highest."""

_LARGEST = 2**20
"""Characters of a device file; ``/dev/full`` and the like have no end."""

_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


class BadDevice(ValueError):
    """A device file that cannot be used; the message is one line that names line and key."""


@dataclass(frozen=True)
class Device:
    """The contents of a device file: the loop with its arm, a wall, and a range of arms."""

    scene: Scene
    wall: tuple[float, float] | None
    """K and B."""
    arms: ArmRange | None
    """The range of arms for which walls are proved safe, where the file has one."""


def read(path: Path) -> Device:
    """The device of a file.

    Raises :class:`BadDevice` for what is no TOML, for keys that are not known or missing, for
    numbers with another unit, and for values that a :class:`Scene` refuses.
    """
    try:
        with path.open(encoding="utf-8-sig") as file:
            text = file.read(_LARGEST + 1)
        if len(text) > _LARGEST:
            raise BadDevice(f"{path}: has more than {_LARGEST} characters; give a device file")
        data = tomllib.loads(text)
    except (OSError, UnicodeDecodeError) as wrong:
        raise BadDevice(f"{path}: cannot be read ({wrong})") from None
    except RecursionError:
        raise BadDevice(f"{path}: is nested too deeply") from None
    except BadDevice:
        raise
    except ValueError as wrong:  # no TOML, or a whole number of more digits than Python reads
        raise BadDevice(f"{path}: {wrong}") from None
    tables = {"": {k: v for k, v in data.items() if not isinstance(v, dict)}}
    for name, table in data.items():
        if isinstance(table, dict):
            if name not in SCHEMA:
                told = suggested(name, [n for n in SCHEMA if n])
                raise BadDevice(f"{_place(path, text, '', name)} is no table; {told}")
            tables[name] = table
    names = {name: tables.get(name, {}).pop(key, None) for name, key in NAMED.items()}
    found: dict[str, dict[str, Any]] = {
        name: {key: _given(path, text, name, key, given) for key, given in table.items()}
        for name, table in tables.items()
    }
    device, arm, ranged, wall = (found.get(name, {}) for name in SCHEMA)
    if "wall" in tables and wall.keys() != SCHEMA["wall"].keys():
        raise BadDevice(f"{path}: [wall] needs K and B")
    if names.get("arm") is not None and arm:
        place = _place(path, text, "arm", next(iter(arm)))
        raise BadDevice(f"{place} beside name is not allowed; give one of them")
    table = ""
    try:
        known = device if names[""] is None else {**_published(names[""]), **device}
        for key in ("mass", "sampling_period"):
            if key not in known:
                raise BadDevice(f"{path}: {key} is missing, such as {key} = {_EXAMPLES[key]}")
        scene = Scene(**known)
        _, table = scene.dimensionless, "arm"
        if "arm" in tables:
            named = names.get("arm")
            scene = scene.held_by(Arm(**{"mass": 0.0, **arm}) if named is None else Arm.of(named))
        _, table = scene.dimensionless, RANGED
        arms, table = ArmRange(**ranged) if RANGED in tables else None, "wall"
        for key, value in wall.items():
            finite(key, value, SCHEMA[table][key])
    except BadDevice:
        raise
    except ValueError as wrong:
        key, _, said = str(wrong).partition(":")
        raise BadDevice(f"{_place(path, text, table, key)}:{said}") from None
    return Device(scene, (wall["K"], wall["B"]) if wall else None, arms)


def _published(name: Any) -> dict[str, float]:
    """Mass and damping of a device, as far as they are published."""
    found = published(name)
    numbers = (("mass", found.mass), ("damping", found.damping))
    return {key: float(value) for key, value in numbers if value is not None}


def _given(path: Path, text: str, table: str, key: str, given: Any) -> Any:
    """A number, or in a table of ranges a pair."""
    if table == RANGED and isinstance(given, list):
        if len(given) != 2:
            place = _place(path, text, table, key)
            raise BadDevice(f"{place} = {given!r} is not allowed; give one number or two")
        return tuple(_value(path, text, table, key, end) for end in given)
    return _value(path, text, table, key, given)


_EXAMPLES = {"mass": '"72 g"', "sampling_period": '"1 ms"'}


def _value(path: Path, text: str, table: str, key: str, given: Any) -> float:
    """A number in SI units, the decimal that it is written as."""
    known = SCHEMA[table]
    if not table and key and key in SCHEMA:
        raise BadDevice(f"{_place(path, text, table, key)} is not allowed; give a table [{key}]")
    if key not in known:
        named = [*known, *([NAMED[table]] if table in NAMED else [])]
        raise BadDevice(f"{_place(path, text, table, key)} is not known; {suggested(key, named)}")
    unit = known[key]
    if unit == "true or false":
        if not isinstance(given, bool):
            place = _place(path, text, table, key)
            raise BadDevice(f"{place} = {given!r} is not allowed; give true or false")
        return given
    if isinstance(given, int | float) and not isinstance(given, bool):
        return float(str(given))  # a whole number that is no float is infinite, as in text
    allowed = f"a number and one of {', '.join(UNITS[unit])}" if unit else "a number without unit"
    match = _NUMBER.fullmatch(given) if isinstance(given, str) else None
    if match is None or match[2] not in UNITS[unit]:
        place = _place(path, text, table, key)
        raise BadDevice(f"{place} = {given!r} is not allowed; give {allowed}")
    size, factor = float(match[1]), UNITS[unit][match[2]]
    return nearest(decimal(size) * decimal(factor)) if math.isfinite(size) else size


def _place(path: Path, text: str, table: str, key: str) -> str:
    """The line in which a key stands, as far as it is found, and the key."""
    here = ""
    for number, line in enumerate(text.splitlines(), 1):
        if head := re.match(r"\s*\[\s*([\w-]+)\s*\]", line):
            here = head[1]
            if not table and here == key:
                return f"{path}:{number}: [{key}]"
        elif here == table and re.match(rf"\s*[\"']?{re.escape(key)}[\"']?\s*=", line):
            return f"{path}:{number}: {key}"
    return f"{path}: {key}"
