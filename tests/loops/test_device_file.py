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
        ("integrator = [1, 2]", ":3: integrator: [1, 2] is not allowed; give 'hold', 'semi-impl"),
        ("virtual_mass = {a = 1}", ":3: virtual_mass: {'a': 1} is not allowed; give one value, no"),
        ("virtual_mass = 1e308", ":3: virtual_mass: 1e+308 with mass=0.1 and sampling_period=0.0"),
        ("[structure]\nmass = 1\nstiffness = 1e-300", ":3: [structure]: stiffness 1e-300 with "),
        ("[structure]\nmass = 1e-320\nstiffness = 1", ":3: [structure]: mass 1e-320 with mass=0"),
        ("[structure]\nmass = 1\nstiffness = 1e16", ":3: [structure]: stiffness 1e+16 with mass="),
        ("[actuator]\ntime_constant = 1e-300", "; give tau/T from 1e-09 to 1e+07"),
        ("[coupling]\nstiffness = 1e300", ":3: [coupling]: stiffness 1e+300 with mass=0.1 and s"),
        (
            '[velocity]\nkind = "filter"\nnumerator = [1e8, -1e8, 1]\ndenominator = [1]',
            ":5: numerator: (100000000.0, -100000000.0, 1.0) is not allowed; give numbers up to",
        ),
        (f'[velocity]\nkind = "{400 * "x"}"', "xxx... is not allowed; give one of 'low-pass', "),
    ],
)
def test_a_wrong_part_is_refused_on_one_line(text, told, tmp_path):
    with pytest.raises(BadDevice) as caught:
        of(text, tmp_path)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "velocity",
    [
        LowPass(time_constant=1e300),
        LowPass(cutoff=1e300, mapping="Tustin"),
        LowPass(weight=1e-300),
        LowPass(cutoff=50, order=2, damping_ratio=1e-300),
    ],
)
def test_a_filter_beyond_all_digits_is_refused_for_stability(velocity):
    """The count of roots never ended, or divided by zero."""
    scene = Scene(mass=0.1, sampling_period=1e-3, velocity=velocity)
    for ask in (lambda: scene.is_stable(1.0, 1.0), scene.max_stable_stiffness):
        with pytest.raises(ValueError, match=r"^velocity: .* for stability; give (tau/T|D) from "):
            ask()


def test_a_filter_of_large_coefficients_is_the_same_filter():
    """All of them times 1e308; the count of roots never ended."""
    scenes = [
        Scene(mass=0.1, sampling_period=1e-3, velocity=Filter([by], [by]))
        for by in (1.0, 1e308, 5e-324)
    ]
    limits = {scene.limit_at(B=3.0).K for scene in scenes}
    assert limits == {scenes[0].limit_at(B=3.0).K}
