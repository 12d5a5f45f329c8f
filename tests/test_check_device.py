"""Code for a device with further parts, beside the engine: right code agrees, code that forgets a
part or a unit is refused."""

import numpy as np
import pytest
from command import symhaptic
from loops.oracle import device, difference_equation, matrix, under_force

from symhaptic import Lag, LowPass, Measured, Scene, SecondMass
from symhaptic.check.plugin import Agreement

T, M = 0.001, 0.1
GAMMA, DELTA, DELAY, POLE = 0.02, 0.05, 1.4, 0.8
OWN = {
    "mass": M,
    "damping": DELTA * M / T,
    "stiffness": GAMMA * M / T**2,
    "sampling_period": T,
    "delay": DELAY * T,
}
SCENES = {
    "filter": ({"velocity": LowPass(weight=1 - POLE)}, {}, POLE),
    "lag": ({"actuator": Lag(time_constant=2 * T)}, {"lag": 2.0}, 0.0),
    "second mass": (
        {"structure": SecondMass(mass=M / 2, stiffness=0.3 * M / T**2, sensor="handle")},
        {"second": (0.5, 0.3, 0.0, "handle")},
        0.0,
    ),
}
ENOUGH = {"ulp": 1e6, "points": 80}
"""2e-10: NumPy's eigenvalues have twelve digits or so."""


def stable(parts, pole):
    """By eigenvalues."""
    wall, kind = difference_equation([1 - pole], [1.0, -pole])
    own = device(GAMMA, DELTA, **parts)

    def mine(K, B):
        step = matrix(*own, K * T**2 / M, B * T / M, DELAY, wall, kind)
        return bool(np.abs(np.linalg.eigvals(step)).max() < 1)

    return mine


def boundary(parts, pole):
    """K + B V(z) = -1/P(z) on the unit circle, solved."""
    A, b, x, _ = device(GAMMA, DELTA, **parts)
    whole, part = int(DELAY), DELAY % 1
    step, _ = under_force(A, b, 1.0)
    on, early = under_force(A, b, 1 - part)
    late = on @ under_force(A, b, part)[1]

    def mine(hz):
        z = np.exp(2j * np.pi * hz * T)
        held = x @ np.linalg.solve(z * np.eye(len(b)) - step, early + late / z) / z**whole
        V = (1 - pole) * (1 - 1 / z) / (1 - pole / z)
        B = (-1 / held).imag / V.imag
        return ((-1 / held).real - B * V.real) * M / T**2, B * M / T

    return mine


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize(("id", "of"), [("is_stable", stable), ("stability_boundary", boundary)])
def test_right_code_agrees_and_code_without_the_part_differs(id, of, name):
    part, own, pole = SCENES[name]
    agreement = Agreement(id, Scene(**OWN, **part))
    agreement.agrees(of(own, pole), **ENOUGH)
    (forgotten,) = part
    named = f"without {forgotten} the loop gives these" if of is boundary else "wrong answers"
    with pytest.raises(pytest.fail.Exception, match=named):
        agreement.agrees(of({}, 0.0), **ENOUGH)


def test_the_limits_of_a_free_mass_with_measured_velocity():
    """0 < K < 2 B/T for B < 2 m/T without delay; a factor 1 + 1e-6 is refused."""
    scene = Scene(mass=M, sampling_period=T, velocity=Measured())
    agreement, over = Agreement("limit_at", scene), {"B": (1.0, 199.0)}
    agreement.agrees(lambda B: 2 * B / T, points=50, over=over)
    with pytest.raises(pytest.fail.Exception, match="worst error"):
        agreement.agrees(lambda B: 2 * B / T * (1 + 1e-6), points=50, over=over)


def test_passivity_with_a_filter():
    """b > KT/2 + B (1 - f)/(1 + f) for B >= 0, b > KT/2 + |B| below; without f it is refused."""
    scene = Scene(mass=M, damping=5.0, sampling_period=T, velocity=LowPass(weight=1 - POLE))
    agreement = Agreement("is_passive", scene)

    def passive(K, B, pole=POLE):
        need = B * (1 - pole) / (1 + pole) if B > 0 else -B
        return K >= 0 and K * T / 2 + need < 5.0

    agreement.agrees(passive, **ENOUGH)
    with pytest.raises(pytest.fail.Exception, match="wrong answers"):
        agreement.agrees(lambda K, B: passive(K, B, 0.0), **ENOUGH)


def test_the_command_reads_a_device_file(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text(
        f'mass = {M}\nsampling_period = {T}\nstiffness = 10.0\n[velocity]\nkind = "measured"\n'
    )
    listed = symhaptic("check", "--device", str(file), "--list").stdout
    assert listed.splitlines() == [
        "is_stable(K, B) -> stable",
        "limit_at(B) -> K",
        "stability_boundary(frequency_hz) -> K, B",
    ]
    refused = symhaptic("check", "--device", str(tmp_path / "no.toml"), "--list")
    assert refused.returncode == 2
    assert "no.toml: cannot be read" in refused.stderr
