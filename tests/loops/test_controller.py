"""The law of a wall in C, beside long division of its filter and beside Scene.simulate."""

import shutil
import subprocess

import numpy as np
import pytest
from command import symhaptic

from symhaptic import Average, Filter, LowPass, Measured, Scene, Window
from symhaptic.scene.controller import files

VELOCITIES = {
    "difference": None,
    "weight": LowPass(weight=0.25),
    "Tustin": LowPass(cutoff=40, mapping="Tustin"),
    "second order": LowPass(cutoff=40, order=2),
    "second order by Tustin": LowPass(cutoff=40, order=2, mapping="Tustin"),
    "window": Window(7),
    "mean": Average(2),
    "filter": Filter([0.5, 0.1], [1.0, -0.7, 0.3]),
}


def scene(velocity=None, **more):
    return Scene(mass=0.1, damping=0.5, sampling_period=0.001, velocity=velocity, **more)


@pytest.mark.parametrize("single", [False, True], ids=["double", "single"])
@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=[pytest.mark.ci] * (i % 3 > 0)) for i, n in enumerate(VELOCITIES)],
)
def test_the_self_test_passes_and_notices(name, single, tmp_path):
    """With the strictest warnings; a tenth of a per cent more stiffness is noticed."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler: cc is not found")
    virtual_mass = 0.001 if name in ("difference", "window") else None
    own = scene(VELOCITIES[name], virtual_mass=virtual_mass)
    for file, text in files(own, 400.0, 1.0, single).items():
        (tmp_path / file).write_text(text)
    compiler = ["cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
    compiler += ["-Wdouble-promotion"]

    def passes():
        subprocess.run([*compiler, "wall.c", "test_wall.c", "-o", "t"], cwd=tmp_path, check=True)
        return subprocess.run(["./t"], cwd=tmp_path, capture_output=True).returncode == 0

    assert passes()
    source = (tmp_path / "wall.c").read_text()
    assert "K = 400.0" in source
    (tmp_path / "wall.c").write_text(source.replace("K = 400.0", "K = 400.4"))
    assert not passes()


@pytest.mark.parametrize("single", [False, True], ids=["double", "single"])
def test_a_position_that_is_not_finite_leaves_no_trace(single, tmp_path):
    """Otherwise NaN stays in the filter, and the wall is gone for ever."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler: cc is not found")
    for file, text in files(scene(LowPass(cutoff=60)), 500.0, 1.5, single).items():
        (tmp_path / file).write_text(text)
    real = "float" if single else "double"
    (tmp_path / "play.c").write_text(
        f"""#include <math.h>
#include "wall.h"
int main(void)
{{
    {real} bad[] = {{({real})NAN, ({real})INFINITY, -({real})INFINITY}};
    wall_state a, b;
    int n, wrong = 0;
    wall_begin(&a, 0);
    wall_begin(&b, bad[0]);
    for (n = 0; n < 30; n++) {{
        {real} x = ({real})(n + 1) / 1000;
        wrong |= n % 7 == 3 && wall(&b, bad[n % 3]) != 0;
        wrong |= wall(&a, x) != wall(&b, x);
    }}
    return wrong;
}}
"""
    )
    subprocess.run(["cc", "wall.c", "play.c", "-o", "play"], cwd=tmp_path, check=True)
    assert subprocess.run(["./play"], cwd=tmp_path, check=False).returncode == 0


@pytest.mark.filterwarnings("error")
def test_single_precision_is_refused_where_it_makes_another_wall():
    """A pole of 1 - 1e-8 is 1 in single precision, and the filter never forgets."""
    slow = scene(LowPass(weight=1e-7))
    assert files(slow, 1.0, 0.01)
    with pytest.raises(
        ValueError, match=r"^velocity: difference filtered by an exponential average of"
    ):
        files(slow, 1.0, 0.01, single=True)
    fast = Scene(mass=1e-15, damping=1e-20, sampling_period=1e-30)
    with pytest.raises(ValueError, match=r"^sampling_period: 1e-30 squared is beyond the range"):
        files(fast, 1e20, 1e-5, single=True)


def test_the_same_forces_as_in_a_simulation(tmp_path):
    """The positions of a simulated motion, put through the C code, give its commands."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler: cc is not found")
    own = scene(LowPass(cutoff=60, order=2))
    found = own.simulate(500.0, 1.5, duration=0.2, position0=1e-3, unilateral=True)
    for file, text in files(own, 500.0, 1.5).items():
        (tmp_path / file).write_text(text)
    positions = ", ".join(repr(float(x)) for x in found.position)
    (tmp_path / "play.c").write_text(
        f"""#include <stdio.h>
#include "wall.h"
int main(void)
{{
    static const double x[] = {{{positions}}};
    wall_state s;
    unsigned n;
    wall_begin(&s, x[0]);
    for (n = 0; n < sizeof x/sizeof x[0]; n++)
        printf("%.17g\\n", wall(&s, x[n]));
    return 0;
}}
"""
    )
    subprocess.run(["cc", "wall.c", "play.c", "-o", "play"], cwd=tmp_path, check=True)
    told = subprocess.run(["./play"], cwd=tmp_path, capture_output=True, text=True, check=True)
    forces = np.array(told.stdout.split(), float)
    commands = found.force[:-1]  # without delay, the force from each sample on is its command
    assert np.abs(forces[: len(commands)] - commands).max() < 1e-12


def test_what_is_no_wall_for_a_controller_is_refused():
    with pytest.raises(ValueError, match="is not stable for this device"):
        files(scene(), 1e6, 0.0)
    with pytest.raises(ValueError, match="give a velocity that is computed"):
        files(scene(Measured()), 100.0, 1.0)


def test_the_command(tmp_path):
    device = tmp_path / "device.toml"
    text = """mass = "100 g"
sampling_rate = "1 kHz"
damping = 0.5
[velocity]
kind = "low-pass"
cutoff = "50 Hz"
[wall]
K = "0.4 N/mm"
B = 1.0
"""
    device.write_text(text)
    run = symhaptic("controller", device, "-o", tmp_path / "wall")
    assert run.returncode == 0, run.stderr
    assert {"wall.h", "wall.c", "test_wall.c"} <= {p.name for p in (tmp_path / "wall").iterdir()}
    device.write_text(text.replace("0.4 N/mm", "400 N/mm"))
    run = symhaptic("controller", device, "-o", tmp_path / "other")
    assert run.returncode == 2
    assert "is not stable" in run.stderr
    assert run.stderr.count("\n") == 1
    assert not (tmp_path / "other").exists()
    device.write_text(text.partition("[wall]")[0])
    run = symhaptic("controller", device)
    assert run.stderr.count(device.name) == 1
    assert "has no wall; give a table [wall] with K and B" in run.stderr


def test_the_code_says_in_which_units_it_counts():
    line = "".join(files(scene(), 400.0, 1.0).values())
    knob = Scene(inertia=1e-4, damping=2e-3, sampling_period=0.001)
    turning = "".join(files(knob, 0.02, 1e-4).values())
    assert "N m" not in line
    assert "rad" not in line
    assert "N m" in turning
    assert "rad" in turning
