"""Units of a device file, beside those of Pint."""

import pytest

from symhaptic.scene.device_file import SCHEMA, UNITS, BadDevice, read

pint = pytest.importorskip("pint", reason="no Pint here: units are not compared with another's")
THEIRS = pint.UnitRegistry()

BASE = {"": {"mass": '"1 kg"', "sampling_period": '"1 ms"'}}
SHORT = {"Ns": "N*s", "N s": "N*s", "mNs": "mN*s", "²": "**2", "^": "**", "/m/kg": "/(m*kg)"}
"""What Pint spells in another way."""

CASES = [
    (table, key, unit)
    for table, keys in SCHEMA.items()
    for key, si in keys.items()
    for unit in UNITS.get(si, {})
    if unit
]


def number_of(device, table, key):
    if table == "wall":
        return dict(zip(("K", "B"), device.wall, strict=True))[key]
    if table == "arms":
        return getattr(device.arms, key)[0]
    return getattr(device.scene.arm if table == "arm" else device.scene, key)


@pytest.mark.parametrize(("table", "key", "unit"), CASES)
def test_each_unit_is_what_pint_says(table, key, unit, tmp_path):
    given = {name: dict(keys) for name, keys in BASE.items()}
    if table == "wall":
        given[table] = {"K": '"1 N/m"', "B": '"1 Ns/m"'}
    given.setdefault(table, {})[key] = f'"0.0625 {unit}"'
    lines = [f"{k} = {v}" for k, v in given.pop("").items()]
    for name, keys in given.items():
        lines += [f"[{name}]", *(f"{k} = {v}" for k, v in keys.items())]
    path = tmp_path / "device.toml"
    path.write_text("\n".join(lines), encoding="utf-8")
    spelled = unit
    for short, long in SHORT.items():
        spelled = spelled.replace(short, long)
    si = SCHEMA[table][key].replace("Ns", "N*s").replace("^", "**")
    theirs = THEIRS.Quantity(0.0625, spelled).to(si).magnitude
    assert number_of(read(path), table, key) == pytest.approx(theirs, rel=1e-15)


@pytest.mark.parametrize("unit", ["Nm", "lb", "N/s", "kgs", "ms2", "N/mm/m"])
def test_another_unit_is_refused(unit, tmp_path):
    path = tmp_path / "device.toml"
    path.write_text(f'mass = "1 {unit}"\nsampling_period = "1 ms"\n', encoding="utf-8")
    with pytest.raises(BadDevice, match="mass = "):
        read(path)
