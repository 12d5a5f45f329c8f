"""A virtual coupling, beside a loop that is stepped sample by sample.

The point between coupling and wall has no mass, so that both forces are equal there."""

import numpy as np
import pytest
from loops.oracle import device, difference_equation, low_pass, sizes, under_force
from scipy.signal import cont2discrete

from symhaptic import Coupling, Difference, LowPass, Measured, Scene, Window
from symhaptic.loops.engine import Engine
from symhaptic.scene.device_file import read

DICE = 88
FILTERS = {
    "difference": (Difference(), ([1.0], [1.0])),
    "weight": (LowPass(weight=0.3), ([0.3], [1.0, -0.7])),
    "Tustin": (LowPass(time_constant=1.5, mapping="Tustin"), low_pass(1.5, 1, "Tustin")),
}


def stepped(gamma, delta, delay, filtered, wall, coupling):
    """One period as a matrix: device; for device and point two places and a velocity; forces."""
    (K, B, M), (Kc, Bc) = wall, coupling
    A, b, x, _ = device(gamma, delta)
    whole, part = int(delay), delay % 1
    step, _ = under_force(A, b, 1.0)
    on, early = under_force(A, b, 1 - part)
    late = on @ under_force(A, b, part)[1]
    speed, _ = difference_equation(*filtered)
    unit = np.eye(2 + 2 * 4 + whole + 1)
    place = np.zeros(len(unit))
    place[:2] = x
    memory = [unit[2:6], unit[6:10]]  # places 1, 2, 3 samples ago, and the last velocity

    def moving(now, before):
        return speed([now, *before[:3]], [before[3]])

    # Kc (x - s) + Bc (v_x - v_s) = K s + B v_s + M (s - 2 s' + s''); v_s = lead s + rest
    nothing = np.zeros(len(unit))
    rest = moving(nothing, memory[1])
    lead = filtered[0][0] / filtered[1][0]
    v = moving(place, memory[0])
    known = Kc * place + Bc * v - (Bc + B) * rest + M * (2 * memory[1][0] - memory[1][1])
    point = known / (Kc + K + M + (Bc + B) * lead)
    v_point = moving(point, memory[1])
    command = -(Kc * (place - point) + Bc * (v - v_point))
    forces = [command, *unit[10:]]
    rows = np.outer(early, forces[whole]) + np.outer(late, forces[whole + 1])
    rows[:, :2] += step
    of_device = [place, *memory[0][:2], v]
    of_point = [point, *memory[1][:2], v_point]
    return np.array([*rows, *of_device, *of_point, *forces[: whole + 1]])


@pytest.mark.parametrize("name", FILTERS)
def test_roots_beside_eigenvalues(name, loops):
    dice = np.random.default_rng([DICE, *map(ord, name)])
    velocity, filtered = FILTERS[name]
    found = set()
    for _ in range(loops):
        gamma, delta = (dice.choice([0.0, 10 ** dice.uniform(-3, 0)]) for _ in range(2))
        delay = float(dice.choice([0, 1, 3, dice.uniform(0, 3)]))
        Kc, Bc = 10 ** dice.uniform(-2, 1), dice.choice([0.0, 10 ** dice.uniform(-2, 1)])
        M = dice.choice([0.0, 10 ** dice.uniform(-2, 0.5)])
        coupling = Coupling(stiffness=Kc, damping=Bc)
        engine = Engine(gamma, delta, delay, 1.0, 1.0, velocity, virtual_mass=M, coupling=coupling)
        K, B = 10 ** dice.uniform(-3, 0.7), 10 ** dice.uniform(-3, 0.7) * dice.choice([1, 1, -0.1])
        if dice.random() < 0.5:
            near = engine.stability_boundary(dice.uniform(0, np.pi))
            if max(map(abs, near)) < 10:
                K, B = (float(x) * (1 + 10 ** dice.uniform(-8, -1)) for x in near)
        radii = sizes(stepped(gamma, delta, delay, filtered, (K, B, M), (Kc, Bc)))
        if np.abs(radii - 1).min() > 1e-9:
            mine = float(engine.unstable_roots(K, B))
            assert mine == np.sum(radii > 1), (engine, K, B, radii)
            found.add(mine)
    assert len(found) > 1


def test_a_stiff_coupling_is_none_and_a_soft_one_bounds_the_wall():
    own = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001, "delay": 0.0005}
    plain = Scene(**own).limit_at(B=3.0).K
    stiff = Scene(**own, coupling=Coupling(stiffness=1e12))
    assert pytest.approx(plain) == stiff.limit_at(3.0).K
    soft = Scene(**own, coupling=Coupling(stiffness=0.5 * plain, damping=3.0))
    assert soft.is_stable(np.array([plain, 1e3 * plain]), 3.0).all()
    assert not Scene(**own).is_stable(1.01 * plain, 3.0)


def test_a_limit_is_a_supremum_and_margins_are_found():
    own = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001, "delay": 0.0015}
    scene = Scene(**own, coupling=Coupling(stiffness=6000.0, damping=8.0), virtual_mass=0.05)
    found = scene.limit_at(B=1.0)
    assert scene.is_stable(found.K * (1 - 1e-9), 1.0)
    assert not scene.is_stable(found.K * (1 + 1e-9), 1.0)
    K = found.K / 2
    margin = scene.delay_margin(K, 1.0)
    for by, stable in ((1 - 1e-9, True), (1 + 1e-9, False)):
        own["delay"] = 0.0015 + margin * by
        other = Scene(**own, coupling=scene.coupling, virtual_mass=0.05)
        assert other.is_stable(K, 1.0) == stable
    assert scene.damping_for(K).delay_margin >= margin


@pytest.mark.parametrize("virtual_mass", [0.0, 0.05])
def test_behind_a_coupling_that_is_stable_with_a_rigid_wall_there_is_no_limit(virtual_mass):
    """A rigid wall makes the coupling itself the wall: K < 2 B/T and below the device's limit."""
    own = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001}
    soft = Coupling(stiffness=2000.0, damping=5.0)
    scene = Scene(**own, coupling=soft, virtual_mass=virtual_mass)
    assert Scene(**own).is_stable(2000.0, 5.0)
    assert scene.is_stable(1e12, 1e8)
    assert "no upper limit, because" in scene.describe()
    for ask in (
        scene.max_stable_stiffness,
        scene.stable_region,
        lambda: scene.limit_at(5.0),
        lambda: scene.damping_for(100.0),
    ):
        with pytest.raises(ValueError, match=r"^coupling: .* so the stiffness has no upper limit"):
            ask()


def test_no_upper_limit_does_not_make_every_stiffness_stable():
    """A rigid wall is stable and a softer one is not, by SciPy's hold and NumPy's roots."""
    m, b, T, periods, Kc, Bc = 0.1, 0.01, 0.001, 3, 2000.0, 10.0
    num, den, _ = cont2discrete(([1.0], [m, b, 0.0]), T, method="zoh")
    between = np.array([Kc + Bc / T, -Bc / T])  # times 1/z

    def largest(K):
        plant = np.polymul(
            np.polymul(den, between + np.array([K, 0.0])), [1.0] + [0.0] * (periods + 1)
        )
        loop = np.polyadd(plant, np.polymul(num.ravel(), np.polymul(between, [K, 0.0])))
        return abs(np.roots(loop)).max()

    assert largest(1e12) < 0.998
    assert largest(2000.0) > 1.008
    coupling = Coupling(stiffness=Kc, damping=Bc)
    scene = Scene(mass=m, damping=b, sampling_period=T, delay_samples=periods, coupling=coupling)
    assert scene.is_stable([1e12, 2000.0], 0.0).tolist() == [True, False]
    assert "a softer wall may be unstable" in scene.describe()
    with pytest.raises(ValueError, match=r"no upper limit, but a softer wall may be unstable"):
        scene.limit_at(0.0)


def test_what_it_does_not_answer_it_refuses(tmp_path):
    coupling = Coupling(stiffness="2 N/mm", damping=1.0)
    own = {"mass": 0.1, "damping": 0.5, "sampling_period": 0.001, "coupling": coupling}
    for velocity in (Measured(), Window(9)):
        with pytest.raises(ValueError, match=r"^coupling: .* give a velocity of one rate"):
            Scene(**own, velocity=velocity)
    scene = Scene(**own)
    with pytest.raises(ValueError, match=r"coupling: .* passivity is not computed"):
        scene.is_passive(1.0, 1.0)
    with pytest.raises(ValueError, match=r"^coupling: .* for a simulation"):
        scene.simulate(1.0, 1.0, duration=1.0)
    with pytest.raises(ValueError, match="do not fit this device; give kg m"):
        Scene(inertia=1e-4, sampling_period=0.001, coupling=Coupling(stiffness="2 N/m"))
    assert "coupling of 2000 N/m and 1 Ns/m" in scene.describe()
    file = tmp_path / "mine.toml"
    file.write_text(
        'mass = 0.1\ndamping = 0.5\nsampling_period = 0.001\n[coupling]\nstiffness = "2 N/mm"\n'
        "damping = 1.0\n"
    )
    assert read(file).scene == scene
