"""Device files: the same text with units as a scene's, of devices that move and that turn."""

import pytest

from symhaptic import Arm, ArmRange, Encoder, Scene
from symhaptic.scene.device_file import SCHEMA, BadDevice, read

KNOB = """inertia = "200 kg mm^2"
damping = "1e-4 N m s/rad"
sampling_rate = "1 kHz"

[arm]
inertia = "1e-5 kg m^2"
stiffness = "0.01 N m/deg"

[wall]
K = "0.5 N m/turn"
B = "2e-6 N m/(deg/s)"
"""

ARM = KNOB[KNOB.index("[arm]") : KNOB.index("[wall]")]


def written(tmp_path, text):
    path = tmp_path / "device.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_rotary_device_has_its_units(tmp_path):
    device = read(written(tmp_path, KNOB))
    arm = Arm(inertia=1e-5, stiffness="0.01 N m/deg")
    assert device.scene == Scene(inertia=2e-4, damping=1e-4, sampling_period=1e-3, arm=arm)
    assert device.wall == pytest.approx((0.5 / 6.283185307179586, 2e-6 * 57.29577951308232))


def test_a_range_of_rotary_arms(tmp_path):
    text = KNOB.partition("[arm]")[0] + '[arms]\ninertia = ["0 kg m^2", "10 g cm^2"]\n'
    assert read(written(tmp_path, text)).arms == ArmRange(inertia=(0, 1e-6))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("inertia", 'mass = "1 kg"\ninertia', "inertia: '200 kg mm^2' and mass='1 kg' excl"),
        ('"0.5 N m/turn"', '"5 N/m"', ":10: K: '5 N/m' is not allowed; give a number and a unit"),
        ("[arm]\ninertia", "[arm]\nmass", ":6: mass: '1e-5 kg m^2' is not allowed; give a number"),
        ('"1 kHz"', '"1000 rad/s"', ":3: sampling_rate: '1000 rad/s' is not allowed; give a freq"),
        ('"1 kHz"', '"0 Hz"', ":3: sampling_rate: '0 Hz' is not allowed; give finite numbers > 0"),
        (ARM, '[arm]\nname = "Hogan"\n', "device.toml: arm: Arm(mass=0.8, damping=5.5, stiffness="),
        (
            "[arm]",
            "[arms]\nmass = 1\n[arm]",
            "inertia: is missing in the range of arms; the device",
        ),
        ("sampling_rate", "sampling_period", ":3: sampling_period: '1 kHz' is not allowed; give "),
        ("sampling_rate", "delay", "device.toml: sampling_period is missing, such as sampling_pe"),
        ("[arm]", 'sampling_period = "1 ms"\n[arm]', ":3: sampling_rate: '1 kHz' and sampling"),
    ],
)
def test_what_does_not_go_together_is_refused_on_one_line(old, new, told, tmp_path):
    assert old in KNOB
    with pytest.raises(BadDevice) as caught:
        read(written(tmp_path, KNOB.replace(old, new, 1)))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("table", ["arm", "arms", "wall", "encoder"])
def test_numbers_without_a_unit_are_in_si_units(table, tmp_path):
    keys = [key for key in SCHEMA[table] if key not in ("inertia", "with_device")]
    keys = [key for key in keys if not key.endswith("_per_mass")]
    text = "mass = 1\nsampling_period = 0.001\n" + f"[{table}]\n"
    device = read(written(tmp_path, text + "".join(f"{key} = 0.25\n" for key in keys)))
    scene, arms = device.scene, device.arms
    found = {"arm": scene.arm, "arms": arms, "wall": device.wall, "encoder": scene.encoder}[table]
    if table == "wall":
        assert found == (0.25, 0.25)
    elif table == "encoder":
        assert found == Encoder(resolution=0.25)
    else:
        alike = Arm if table == "arm" else ArmRange
        assert found == alike(mass=0.25, damping=0.25, stiffness=0.25)


@pytest.mark.parametrize("unit", ["Nm", "V", "N/s", "kgs", "ms2", "N/mm/m", "kg; rm", ""])
def test_another_unit_is_refused(unit, tmp_path):
    text = f'mass = "1 {unit}"\nsampling_period = "1 ms"\n'
    with pytest.raises(BadDevice, match=r"mass: '1 .*' is not allowed; give "):
        read(written(tmp_path, text))


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (
            b"mass: 72 g",
            "device.toml: Expected '=' after a key in a key/value pair (at line 1, col",
        ),
        (b"mass: 72 g", "; give a device file in TOML"),
        (KNOB.encode("utf-16"), "invalid start byte); save it as UTF-8"),
        (KNOB.encode() + b'[""]\ninertia = 1\n', "device.toml: '' is no table; give one of arm, "),
        (b"k" * 9999 + b" = 1\n" + KNOB.encode(), ":1: 'kkkkk"),
        (b"k" * 9999 + b" = 1\n" + KNOB.encode(), "kkk... is not known; give one of mass, "),
        (f'device = "{9999 * "k"}"\n'.encode(), "kkk... is not allowed; give one of "),
    ],
)
def test_what_is_no_device_is_told_with_what_to_do(tmp_path, content, told):
    """A table without a name took the place of the device's own keys."""
    path = tmp_path / "device.toml"
    path.write_bytes(content)
    with pytest.raises(BadDevice) as caught:
        read(path)
    assert told in str(caught.value)
    assert len(str(caught.value)) < 1000


def test_what_cannot_be_read_is_told_with_what_to_do(tmp_path):
    with pytest.raises(BadDevice, match=r"cannot be read \(Is a directory\); give a device file"):
        read(tmp_path)
