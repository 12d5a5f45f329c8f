"""Parts of a loop as tables of a device file."""

import pytest

from symhaptic import (
    Average,
    Difference,
    Encoder,
    Filter,
    Lag,
    LowPass,
    Measured,
    Scene,
    SecondMass,
    Window,
)
from symhaptic.scene.device_file import BadDevice, read

HEAD = 'mass = "100 g"\nsampling_rate = "1 kHz"\n'

TABLES = {
    '[velocity]\ncutoff = "50 Hz"': {"velocity": LowPass(cutoff=50)},
    '[velocity]\nkind = "low-pass"\ntime_constant = "2 ms"\norder = 2\nmapping = "Tustin"': {
        "velocity": LowPass(time_constant=0.002, order=2, mapping="Tustin")
    },
    '[velocity]\nkind = "average"\nsamples = 5': {"velocity": Average(5)},
    '[velocity]\nkind = "window"\nsamples = 50': {"velocity": Window(50)},
    '[velocity]\nkind = "difference"': {"velocity": Difference()},
    '[velocity]\nkind = "measured"': {"velocity": Measured()},
    '[velocity]\nkind = "filter"\nnumerator = [0.25]\ndenominator = [1, -0.75]': {
        "velocity": Filter([0.25], [1, -0.75])
    },
    '[actuator]\ntime_constant = "1 ms"': {"actuator": Lag(time_constant=0.001)},
    '[structure]\nmass = "20 g"\nstiffness = "20 N/mm"\nsensor = "handle"': {
        "structure": SecondMass(mass=0.02, stiffness=20_000, sensor="handle")
    },
    '[encoder]\nresolution = "20 um"': {"encoder": Encoder(resolution=2e-5)},
    'virtual_mass = "5 g"': {"virtual_mass": 0.005},
    'coulomb_friction = "0.3 N"': {"coulomb_friction": 0.3},
    'integrator = "semi-implicit Euler"': {"integrator": "semi-implicit Euler"},
}


def of(text, tmp_path):
    path = tmp_path / "device.toml"
    path.write_text(HEAD + text + "\n")
    return read(path).scene


@pytest.mark.parametrize("text", TABLES)
def test_each_part_has_its_table(text, tmp_path):
    found = of(text, tmp_path)
    assert found == Scene(mass=0.1, sampling_period=0.001, **TABLES[text])


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('[velocity]\nkind = "lowpass"', ":4: kind = 'lowpass' is not allowed; give one of 'low-"),
        ("[velocity]\nkind = 3", ":4: kind = 3 is not allowed; give one of 'low-pass', "),
        ('[velocity]\ncutoff = "50 N"', ":4: cutoff: '50 N' is not allowed; give a number and a"),
        ("[velocity]\ncutoff = 0", ":4: cutoff: 0 is not allowed; give finite numbers > 0"),
        ("[velocity]", ": cutoff: nothing is not allowed; give exactly one of cutoff, time_const"),
        ("[velocity]\ncutoff = 5\nsamples = 3", ":5: samples does not belong to kind = 'low-pass'"),
        ('[velocity]\nkind = "average"', ": [velocity] needs samples"),
        (
            '[velocity]\nkind = "average"\nsamples = 2.5',
            ":5: samples: 2.5 is not allowed",
        ),
        ('[velocity]\nkind = "filter"\nnumerator = 1', "give 1 to 7 numbers"),
        ('[velocity]\nkind = "filter"\nnumerator = [1]\ndenominator = [1, -2]', "the same sum"),
        ('[velocity]\nkind = "filter"\nnumerator = [-1]\ndenominator = [1, -2]', "a stable filter"),
        ("[velocity]\ncut_off = 5", ":4: cut_off is not known; did you mean 'cutoff'?"),
        ("[actuator]", ": [actuator] needs time_constant"),
        ("[encoder]", ": [encoder] needs resolution"),
        ("[structure]\nmass = 1", ": [structure] needs stiffness"),
        (
            '[structure]\nmass = 1\nstiffness = "2 N m/rad"',
            "do not fit this device",
        ),
        ('integrator = "Euler"', ":3: integrator: 'Euler' is not allowed; give 'hold', 'semi-impl"),
        ('virtual_mass = "1 s"', ":3: virtual_mass: '1 s' is not allowed"),
        ('velocity = "50 Hz"', ":3: velocity is not a table; write [velocity]"),
    ],
)
def test_a_wrong_part_is_refused_on_one_line(text, told, tmp_path):
    with pytest.raises(BadDevice) as caught:
        of(text, tmp_path)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
