"""The sampled plant is the exact zero-order-hold equivalent, and the model never sees the paper."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.signal import cont2discrete

from symhaptic.model import plant
from symhaptic.model.parts import ALL, Parts

t, gamma, delta, z = sp.symbols("t gamma delta z")

# Chosen: swinging, overdamped, near critical damping (delta^2 = 4 gamma), light, stiff.
CASES = [
    (Parts(), 0.4, 0.3),
    (Parts(), 0.1, 1.7),
    (Parts(), 0.2501, 1.0),
    (Parts(), 1e-3, 2e-2),
    (Parts(), 8.0, 0.05),
    (Parts(stiffness=False), None, 0.6),
    (Parts(damping=False), 1.3, None),
    (Parts(stiffness=False, damping=False), None, None),
]


def continuous(stiffness, damping):
    law = np.array([[0.0, 1.0], [-(stiffness or 0.0), -(damping or 0.0)]])
    return law, np.array([[0.0], [1.0]])


def at(expr, stiffness, damping):
    values = {gamma: stiffness, delta: damping}
    known = {s: sp.Float(repr(v), 40) for s, v in values.items() if v is not None}
    return complex(sp.sympify(expr).subs(known).evalf(40))


@pytest.mark.parametrize(("parts", "stiffness", "damping"), CASES)
def test_sampled_plant_agrees_with_scipy(parts, stiffness, damping):
    found = plant.sampled(plant.normalised(parts))
    law, push = continuous(stiffness, damping)
    system = (law, push, np.array([[1.0, 0.0]]), np.zeros((1, 1)))
    phi, held, *_ = cont2discrete(system, 1.0, method="zoh")
    expected = {
        "a": np.trace(phi),
        "e": np.linalg.det(phi),
        "n1": held[0, 0],
        "n0": phi[0, 1] * held[1, 0] - phi[1, 1] * held[0, 0],
    }
    for name, value in expected.items():
        # scipy's Pade approximation is good to some 1e-14 for matrices of norm below 10
        assert abs(at(getattr(found, name), stiffness, damping) - value) < 1e-13 * max(
            1.0, np.abs(phi).max()
        )


@pytest.mark.parametrize(("parts", "stiffness", "damping"), CASES)
@pytest.mark.parametrize("time", ["1", "0.3", "2.5"])
def test_motion_agrees_with_the_matrix_exponential(parts, stiffness, damping, time):
    device = plant.normalised(parts)
    phi = device.transition(t).subs(t, sp.Rational(time))
    held = device.held(t).subs(t, sp.Rational(time))
    with mpmath.workdps(40):
        # exp of the state matrix with the input as a third, constant state
        law = mpmath.matrix(3, 3)
        law[0, 1], law[1, 2] = 1, 1
        law[1, 0] = -mpmath.mpf(repr(stiffness or 0.0))
        law[1, 1] = -mpmath.mpf(repr(damping or 0.0))
        exact = mpmath.expm(law * mpmath.mpf(time), method="taylor")
        for row in range(2):
            for column, entry in enumerate([phi[row, 0], phi[row, 1], held[row]]):
                # both sides carry 40 digits, a few are lost to cancellation at small gamma
                assert abs(at(entry, stiffness, damping) - complex(exact[row, column])) < 1e-14


def test_physical_plant_in_its_own_units():
    # m = 2 kg, b = 3 Ns/m, k = 5 N/m, T = 0.1 s, chosen
    values = {"m": 2, "b": 3, "k": 5}
    found = plant.sampled(plant.Plant(), sp.Rational(1, 10))
    law = np.array([[0.0, 1.0], [-2.5, -1.5]])
    system = (law, np.array([[0.0], [0.5]]), np.array([[1.0, 0.0]]), np.zeros((1, 1)))
    phi, held, *_ = cont2discrete(system, 0.1, method="zoh")
    ours = [complex(sp.sympify(e).subs(values).evalf(30)) for e in (found.a, found.e, found.n1)]
    # rounding of double precision on values below 2
    assert np.allclose(ours, [np.trace(phi), np.linalg.det(phi), held[0, 0]], rtol=0, atol=1e-14)


def test_static_gain_is_one_over_the_stiffness():
    # a constant unit force stretches the spring by 1/gamma
    found = plant.sampled(plant.normalised(Parts())).transfer.subs(z, 1)
    assert abs(at(found, 0.4, 0.3) - 1 / 0.4) < 1e-14  # 40 digits, rounded to a double


@pytest.mark.parametrize("parts", ALL)
def test_scene_decides_the_symbols(parts):
    device = plant.normalised(parts)
    allowed = ({delta} if parts.damping else set()) | ({gamma} if parts.stiffness else set())
    found = plant.sampled(device)
    numbers = (found.a, found.e, found.n1, found.n0)
    assert {s for e in numbers for s in sp.sympify(e).free_symbols} == allowed


def test_late_force_moves_less():
    # the free mass: (1 - late)^2/2 by Newton's law; with spring and damper by mpmath
    with mpmath.workdps(30):
        law = mpmath.matrix([[0, 1, 0], [-mpmath.mpf("0.4"), -mpmath.mpf("0.3"), 1], [0, 0, 0]])
        exact = mpmath.expm(law * mpmath.mpf("0.75"), method="taylor")[0, 2]
    found = at(plant.normalised(Parts()).held(sp.Rational(3, 4))[0], 0.4, 0.3)
    assert abs(found - complex(exact)) < 1e-15  # rounding to a double of a value below 1
