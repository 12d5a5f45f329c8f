"""A scene in other tools gives what these tools find themselves."""

import numpy as np
import pytest
import sympy as sp
from oracle import sampled
from scipy.signal import cont2discrete, dfreqresp, dstep
from sympy.physics.control import TransferFunction

from symhaptic import Scene

SCENES = {
    "everything": Scene(mass=0.4, damping=2.0, stiffness=30.0, sampling_period=0.02, delay=0.04),
    "critical": Scene(mass=1.0, damping=2.0, stiffness=1.0, sampling_period=0.5),
    "no stiffness": Scene(mass=0.1, damping=0.5, sampling_period=0.001, delay=0.001),
    "no damping": Scene(mass=0.2, stiffness=80.0, sampling_period=0.01),
    "mass": Scene(mass=2.0, sampling_period=0.25, delay=0.75),
}
FRACTIONAL = {
    "everything": Scene(mass=0.4, damping=2.0, stiffness=30.0, sampling_period=0.25, delay=0.3125),
    "mass": Scene(mass=2.0, sampling_period=0.25, delay=0.0625),
    "no stiffness": Scene(mass=0.5, damping=0.5, sampling_period=0.5, delay=1.375),
}


def by_scipy(scene):
    """cont2discrete of the device, then one pole at 0 per period of delay."""
    bottom = [scene.mass, scene.damping or 0.0, scene.stiffness or 0.0]
    top, bottom, _ = cont2discrete(([1.0], bottom), scene.sampling_period, method="zoh")
    steps = round((scene.delay or 0.0) / scene.sampling_period)
    return top[0][1:], np.concatenate([bottom, np.zeros(steps)])


@pytest.mark.parametrize("name", SCENES)
def test_whole_delays_are_those_of_scipy(name):
    system = SCENES[name].to_scipy()
    top, bottom = by_scipy(SCENES[name])
    assert system.num == pytest.approx(top, rel=1e-8)
    assert system.den == pytest.approx(bottom, rel=1e-8, abs=1e-12)
    assert system.dt == SCENES[name].sampling_period


@pytest.mark.parametrize("name", SCENES)
def test_whole_delays_are_those_of_python_control(name):
    control = pytest.importorskip("control", reason="no python-control here: not compared")
    scene = SCENES[name]
    plant = control.tf([1], [scene.mass, scene.damping or 0.0, scene.stiffness or 0.0])
    theirs = control.sample_system(plant, scene.sampling_period, method="zoh")
    steps = round((scene.delay or 0.0) / scene.sampling_period)
    ours = scene.to_control()
    assert ours.dt == scene.sampling_period
    for frequency in (0.3, 1.1, 2.9):
        z = np.exp(1j * frequency)
        assert complex(ours(z)) == pytest.approx(complex(theirs(z)) * z**-steps, rel=1e-8)


@pytest.mark.parametrize("name", FRACTIONAL)
def test_a_fraction_of_a_period_is_exact(name):
    """Step responses beside the device simulated in pieces, by exponentials of its matrix."""
    scene = FRACTIONAL[name]
    gamma, delta, delay = scene.dimensionless
    steps = int(delay)
    part = delay - steps
    first, late = sampled(gamma, delta, part), sampled(gamma, delta, 1 - part)
    state, path = np.zeros(2), []
    for k in range(12):
        path.append(state[0])
        for (free, held), lag in ((first, steps + 1), (late, steps)):
            state = free @ state + held * (k >= lag)
    _, (found,) = dstep(scene.to_scipy(), n=12)
    scale = scene.sampling_period**2 / scene.mass
    assert found[:, 0] == pytest.approx(scale * np.array(path), rel=1e-10, abs=1e-12)


@pytest.mark.parametrize("scene", [*SCENES.values(), *FRACTIONAL.values()])
def test_sympy_has_the_same_response(scene):
    """Its exact values on the unit circle, beside the exponentials of the device's matrix."""
    system = scene.to_sympy()
    assert isinstance(system, TransferFunction)
    assert system.num.free_symbols | system.den.free_symbols == {system.var}
    gamma, delta, delay = scene.dimensionless
    steps = int(delay)
    part = delay - steps
    (free, held), (later, begun) = sampled(gamma, delta), sampled(gamma, delta, 1 - part)
    early = sampled(gamma, delta, part)[1]
    for frequency in (0.4, 2.0):
        z = np.exp(1j * frequency)
        force = begun + later @ early / z if part else held
        state = np.linalg.solve(z * np.eye(2) - free, force)
        expected = state[0] * z**-steps * scene.sampling_period**2 / scene.mass
        exact = system.to_expr().subs(system.var, sp.exp(sp.I * sp.Float(frequency, 40)))
        assert complex(exact.evalf(30)) == pytest.approx(expected, rel=1e-9)


def test_decimals_stay_decimals_in_sympy():
    """3e-4 s are three periods of 1e-4 s: z^3 and no ghost of a fraction; T^2/(2 m) as written."""
    system = Scene(mass=0.3, sampling_period=1e-4, delay=3e-4).to_sympy()
    z = system.var
    assert sp.expand(system.num - sp.Rational(1, 60000000) * (z + 1)) == 0
    assert sp.expand(system.den - z**3 * (z - 1) ** 2) == 0
    assert len(Scene(mass=0.3, sampling_period=1e-4, delay=3e-4).to_scipy().num) == 2


@pytest.mark.filterwarnings("error")
def test_a_heavy_device_at_a_high_rate_keeps_all_coefficients_in_scipy():
    """100 kg at 10 MHz: those of 1e-17 were left out, as of a numerator that begins later."""
    scene = Scene(mass=100.0, damping=5.0, sampling_period=1e-7, delay_samples=1.5)
    _, (late,) = dfreqresp(scene.to_scipy(), [1.0])
    _, (early,) = dfreqresp(Scene(mass=100.0, sampling_period=1e-7).to_scipy(), [1.0])
    z = np.exp(1j)
    held = 1e-14 / 200 * (z + 1) / (z - 1) ** 2
    assert early == pytest.approx(held, rel=1e-9)
    assert late == pytest.approx(held * (z**2 + 6 * z + 1) / (4 * (z + 1) * z**2), rel=1e-6)
