"""A device, its arm or a range of arms, its loop and its wall from a TOML file with units."""

from __future__ import annotations

import re
import tomllib
from dataclasses import MISSING, dataclass, fields
from pathlib import Path
from typing import Any

from symhaptic.loops.actuator import Lag
from symhaptic.loops.oversampled import Oversampled
from symhaptic.loops.sensor import Encoder
from symhaptic.loops.structure import Coupling, SecondMass
from symhaptic.loops.velocity import Average, Difference, Filter, LowPass, Measured, Window
from symhaptic.notation.quantities import number, shown
from symhaptic.notation.suggest import suggested
from symhaptic.scene.arms import Arm, ArmRange, checked_range, of_device
from symhaptic.scene.scene import Scene

MOVED = "mass", "inertia", "damping", "stiffness"
SCHEMA = {
    "": (
        *(*MOVED, "sampling_period", "sampling_rate"),
        *("delay", "delay_samples", "coulomb_friction", "virtual_mass", "integrator"),
    ),
    "arm": (*MOVED, "with_device"),
    "arms": (*MOVED, "damping_per_mass", "stiffness_per_mass"),
    "wall": ("K", "B"),
}
PARTS: dict[str, dict[str, type]] = {
    "velocity": {
        "low-pass": LowPass,
        "average": Average,
        "window": Window,
        "filter": Filter,
        "difference": Difference,
        "measured": Measured,
    },
    "actuator": {"": Lag},
    "structure": {"": SecondMass},
    "coupling": {"": Coupling},
    "encoder": {"": Encoder},
}
"""Tables of parts; where there are several kinds, ``kind`` tells which, by default the first."""

SCHEMA |= {
    table: tuple(
        dict.fromkeys(
            [*(["kind"] if len(kinds) > 1 else [])]
            + [each.name for kind in kinds.values() for each in fields(kind) if each.init]
        )
    )
    for table, kinds in PARTS.items()
}
SCHEMA["velocity"] += ("times",)
"""Keys of each table; those of the device and its loop stand at the top."""

NAMED = {"": "device", "arm": "name"}
"""The key of a table that names a published device, or a row of Table II."""

_LARGEST = 2**20
"""Characters of a device file; ``/dev/full`` and the like have no end."""


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
    except OSError as wrong:
        said = f"cannot be read ({wrong.strerror}); give a device file"
        raise BadDevice(f"{path}: {said}") from None
    except UnicodeDecodeError as wrong:
        raise BadDevice(f"{path}: cannot be read ({wrong}); save it as UTF-8") from None
    except RecursionError:
        raise BadDevice(f"{path}: is nested too deeply; give numbers in tables") from None
    except BadDevice:
        raise
    except ValueError as wrong:  # no TOML, or a whole number of more digits than Python reads
        raise BadDevice(f"{path}: {wrong}; give a device file in TOML") from None
    tables = {"": {k: v for k, v in data.items() if not isinstance(v, dict)}}
    for name, table in data.items():
        if isinstance(table, dict):
            if name in (*SCHEMA[""], NAMED[""]):
                place = _place(path, text, "", name)
                raise BadDevice(f"{place}: {shown(table)} is not allowed; give one value, no table")
            if name not in SCHEMA or not name:
                told = suggested(name, [n for n in SCHEMA if n])
                raise BadDevice(f"{_place(path, text, '', name)} is no table; {told}")
            tables[name] = table
    names = {name: tables.get(name, {}).pop(key, None) for name, key in NAMED.items()}
    for name, table in tables.items():
        for key, given in table.items():
            _check(path, text, name, key, given)
    device, arm, ranged, wall = (tables.get(name, {}) for name in ("", "arm", "arms", "wall"))
    if "wall" in tables and wall.keys() != {*SCHEMA["wall"]}:
        raise BadDevice(f"{path}: [wall] needs K and B")
    if names.get("arm") is not None and arm:
        place = _place(path, text, "arm", next(iter(arm)))
        raise BadDevice(f"{place} and name exclude each other; give one of them")
    here = ""
    try:
        known = device if names[""] is None else {**of_device(names[""]), **device}
        for key, instead in (("mass", "inertia"), ("sampling_period", "sampling_rate")):
            if key not in known and instead not in known:
                raise BadDevice(f"{path}: {key} is missing, such as {key} = {_EXAMPLES[key]}")
        for here in PARTS:
            if here in tables:
                known = {**known, here: _part(path, text, here, tables[here])}
        here = ""
        scene = Scene(**known)
        moved = "inertia" if scene.rotary else "mass"
        _, here = scene.dimensionless, "arm"
        if "arm" in tables:
            named = names.get("arm")
            arm = arm if {"mass", "inertia"} & arm.keys() else {moved: 0.0, **arm}
            scene = scene.held_by(Arm(**arm) if named is None else Arm.of(named))
        _, here = scene.dimensionless, "arms"
        arms = checked_range(ArmRange(**ranged), scene.rotary) if "arms" in tables else None
        here = "wall"
        units = {"K": scene.unit("N/m"), "B": scene.unit("N*s/m")}
        numbers = {key: number(key, value, units[key]) for key, value in wall.items()}
    except BadDevice:
        raise
    except ValueError as wrong:
        key, _, said = str(wrong).partition(":")
        raise BadDevice(f"{_place(path, text, here, key)}:{said}") from None
    return Device(scene, (numbers["K"], numbers["B"]) if numbers else None, arms)


def _part(path: Path, text: str, table: str, given: dict[str, Any]) -> Any:
    """A part of the loop; it checks its numbers itself."""
    kinds = PARTS[table]
    name = given.pop("kind", next(iter(kinds)))
    if not isinstance(name, str) or name not in kinds:
        place, allowed = _place(path, text, table, "kind"), ", ".join(map(repr, kinds))
        raise BadDevice(f"{place} = {shown(name)} is not allowed; give one of {allowed}")
    times = given.pop("times", None) if table == "velocity" else None
    wanted = {each.name: each.default is MISSING for each in fields(kinds[name]) if each.init}
    for key in given.keys() - wanted.keys():
        place = _place(path, text, table, key)
        raise BadDevice(f"{place} does not belong to kind = {name!r}; leave it out")
    for key, needed in wanted.items():
        if needed and key not in given:
            raise BadDevice(f"{path}: [{table}] needs {key}")
    part = kinds[name](**given)
    return part if times is None else Oversampled(part, times)


_EXAMPLES = {"mass": '"72 g"', "sampling_period": '"1 ms"'}


def _check(path: Path, text: str, table: str, key: str, given: Any) -> None:
    """Refuse a key that its table has not; numbers are checked where they are used."""
    known = SCHEMA[table]
    if not table and key and key in SCHEMA:
        raise BadDevice(
            f"{_place(path, text, table, key)} is not a table; write [{key}] with its keys below"
        )
    if key not in known:
        named = [*known, *([NAMED[table]] if table in NAMED else [])]
        raise BadDevice(f"{_place(path, text, table, key)} is not known; {suggested(key, named)}")
    if key == "with_device" and not isinstance(given, bool):
        place = _place(path, text, table, key)
        raise BadDevice(f"{place} = {shown(given)} is not allowed; give true or false")


def _place(path: Path, text: str, table: str, key: str) -> str:
    """The line in which a key stands, as far as it is found, and the key."""
    here, plain = "", re.fullmatch(r"[\w-]{1,80}", key)
    said = key if plain else shown(key)
    for at, line in enumerate(text.splitlines(), 1):
        if head := re.match(r"\s*\[\s*([\w-]+)\s*\]", line):
            here = head[1]
            if not table and here == key:
                return f"{path}:{at}: [{said}]"
        elif here == table and re.match(rf"\s*[\"']?{re.escape(key)}[\"']?\s*=", line):
            return f"{path}:{at}: {said}"
    return f"{path}: {said}"
