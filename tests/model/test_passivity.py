"""The frequency condition agrees with energy sums over sequences of displacements in time."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from symhaptic.model import passivity, wall

K, B, T, b, d, theta, z = sp.symbols("K B T b d theta z")
ANGLES = np.linspace(1e-4, np.pi - 1e-4, 4001)
MARGIN = sp.lambdify([K, B, T, b, d, theta], passivity.margin(), "numpy")


def energy_form(stiffness, damping, period, device, delay, periods):
    """Matrix of the energy that leaves the hand, per displacements p_0 ... p_(n-1).

    The wall reads x_k, the sum of the displacements before period k, ``delay`` periods late and
    holds its force while the device moves by p_k; the damper burns at least b p_k^2/T.
    """
    position = np.tril(np.ones((periods, periods)), -1)  # x_k from p
    late = np.eye(periods, k=-delay) @ position
    before = np.eye(periods, k=-delay - 1) @ position
    force = stiffness * late + damping * (late - before) / period
    form = force + device / period * np.eye(periods)
    return (form + form.T) / 2


def walls(delay, count=40):
    """Walls around the passive region, with the smallest margin over a grid of angles."""
    draw = np.random.default_rng(100 + delay)
    for _ in range(count):
        period, device = draw.uniform(0.2, 3), draw.uniform(0.3, 2)
        stiffness = draw.uniform(0, 2.4) * device / period / (2 * delay + 1)
        damping = draw.uniform(-1.3, 1.3) * device
        margins = MARGIN(stiffness, damping, period, device, delay, ANGLES)
        yield stiffness, damping, period, device, margins.min() / device


@pytest.mark.parametrize("delay", [0, 1, 2, 5])
def test_walls_with_a_margin_never_give_energy(delay):
    draw = np.random.default_rng(delay)
    tried = 0
    for stiffness, damping, period, device, margin in walls(delay):
        # a margin this far from zero has its sign between the grid's angles too
        if margin < 0.02:
            continue
        tried += 1
        form = energy_form(stiffness, damping, period, device, delay, 80)
        # eigenvalues of symmetric matrices are good to 1e-14 of the largest entry, about 80
        assert np.linalg.eigvalsh(form).min() > -1e-11
        for _ in range(20):
            moves = draw.normal(size=80) * draw.uniform(0, 1, size=80) ** 4
            assert moves @ form @ moves >= 0
    assert tried >= 3


@pytest.mark.parametrize("delay", [0, 1, 2, 5])
def test_walls_without_a_margin_give_energy_to_some_motion(delay):
    tried = 0
    for stiffness, damping, period, device, margin in walls(delay):
        # sequences of n periods see an angle to about 1/n: a margin of -2 % shows within 300
        if margin > -0.02:
            continue
        tried += 1
        form = energy_form(stiffness, damping, period, device, delay, 300)
        energies, motions = np.linalg.eigh(form)
        taken = motions[:, 0] @ form @ motions[:, 0]
        assert taken < 0
        assert np.isclose(taken, energies[0], rtol=1e-6, atol=1e-10)
    assert tried >= 3


def test_steady_push_against_a_negative_spring_gains_energy():
    # K = -1, B = 0, b = T = 1, d = 0: every margin is 1 + 1/2, yet x^2/2 is taken from the wall
    margins = MARGIN(-1.0, 0.0, 1.0, 1.0, 0, ANGLES)
    # 3/2 by hand, rounded in a quotient of sines
    assert np.allclose(margins, 1.5, rtol=0, atol=1e-11)
    moves = np.ones(4)
    # by hand: 4 b/T - (0 + 1 + 2 + 3) = -2
    assert moves @ energy_form(-1.0, 0.0, 1.0, 1.0, 0, 4) @ moves == -2.0


@pytest.mark.parametrize("delay", ["0", "1/4", "1", "27/10", "8"])
@pytest.mark.parametrize("angle", ["0.3", "1.7", "3.1"])
def test_dirichlet_form_is_the_real_part_on_the_circle(delay, angle):
    values = {K: 1.7, B: -0.4, T: 0.9, d: sp.Rational(delay)}
    found = passivity.dirichlet_form().subs(values).subs(theta, sp.Rational(angle)).evalf(30)
    with mpmath.workdps(30):
        # T/2 Re{(1 - 1/z) H(z) z^-d} / (1 - cos), as Colgate and Schenkel have it
        th, late = mpmath.mpf(angle), mpmath.mpf(sp.Rational(delay).p) / sp.Rational(delay).q
        on = mpmath.expj(th)
        response = 1.7 - mpmath.mpf(0.4) * (on - 1) / (mpmath.mpf(0.9) * on)
        response *= mpmath.expj(-late * th)
        need = mpmath.mpf(0.9) / 2 * mpmath.re((1 - 1 / on) * response) / (1 - mpmath.cos(th))
    # 30 digits minus what 1.7, 0.4, 0.9 carry as doubles
    assert abs(float(found) - float(need)) < 1e-14 * max(1, abs(float(need)))


def test_required_damping_is_the_dirichlet_form():
    need = passivity.required_damping(wall.delayed())
    for values in ({d: 0.25, theta: 2.0}, {d: 3, theta: 0.6}):
        at = values | {K: 2.0, B: 0.7, T: 0.5, b: 1.1}
        # rounding of ten operations in double precision
        assert abs(complex((need - passivity.dirichlet_form()).subs(at).evalf(20))) < 1e-14


@pytest.mark.parametrize("delay", [0.25, 1.0, 2.7])
@pytest.mark.parametrize("angle", [0.2, 0.5, 0.8])
def test_envelope_is_where_neighbouring_lines_meet(delay, angle):
    def line(x):
        """Coefficients of K and B, with b = T = 1, of Sec. III-B's line of one frequency."""
        kernel = mpmath.sin((delay + 0.5) * x) / (2 * mpmath.sin(x / 2))
        return mpmath.matrix([[kernel, -mpmath.cos((delay + 1) * x)]])

    with mpmath.workdps(40):
        near = mpmath.mpf(10) ** -12
        system = mpmath.matrix(2, 2)
        for row, x in enumerate((angle - near, angle + near)):
            system[row, 0], system[row, 1] = line(x)[0], line(x)[1]
        meet = mpmath.lu_solve(system, mpmath.matrix([1, 1]))
    at = {d: delay, theta: angle, b: 1, T: 1}
    for found, expected in zip(passivity.envelope(), meet, strict=True):
        # the two lines are 2e-12 apart: their crossing is off by about its square over the
        # curvature, far below the doubles that are compared
        assert abs(float(found.subs(at).evalf(30)) - float(expected)) < 1e-12


def test_on_circle_takes_the_principal_branch():
    point = passivity.on_circle(z**d).subs({d: 0.5, theta: 3.0})
    # z^(1/2) = exp(1.5 j), a rounding away
    assert abs(complex(point.evalf(20)) - np.exp(1.5j)) < 1e-15
