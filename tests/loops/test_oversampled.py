"""Two rates, beside a loop that is stepped from reading to reading and from force to force."""

from itertools import pairwise

import numpy as np
import pytest
from loops.oracle import under_force

from symhaptic import Average, Difference, LowPass, Measured, Oversampled, Scene, Window
from symhaptic.loops.engine import Engine
from symhaptic.scene.device_file import BadDevice, read

DICE = 44
AVERAGE = 0.3
"""Weight of the new difference."""


def tustin(tau):
    """A low-pass of second order with Butterworth's damping, by Tustin's rule, as books have it."""
    k = 2 * tau
    lead = k**2 + np.sqrt(2) * k + 1
    above = np.array([1.0, 2.0, 1.0]) / lead
    below = np.array([2 - 2 * k**2, k**2 - np.sqrt(2) * k + 1]) / lead
    return above, below


KINDS = {
    "difference": (Difference(), lambda period: ([1.0], [])),
    "weight": (LowPass(weight=AVERAGE), lambda period: ([AVERAGE], [AVERAGE - 1])),
    "mean": (Average(3), lambda period: ([1 / 3] * 3, [])),
    "second order": (
        LowPass(time_constant=0.8, order=2, mapping="Tustin"),
        lambda period: tustin(0.8 / period),
    ),
}


class Device:
    """State, readings, filter and forces on their way, stepped through one period of the wall."""

    def __init__(self, gamma, delta, delay, times, filtered):
        self.A, self.b = np.array([[0.0, 1.0], [-gamma, -delta]]), np.array([0.0, 1.0])
        self.times, (self.above, self.below) = times, filtered(1 / times)
        self.whole, self.part = int(delay), delay % 1
        self.sizes = np.cumsum([2, 1, len(self.above), len(self.below)])

    @property
    def size(self):
        return self.sizes[-1] + self.whole + 1

    def step(self, state, K, B):
        x, last, differences, speeds, forces = np.split(state, self.sizes)
        now = speeds[0] if len(speeds) else np.dot(self.above, differences)
        forces = [-(K * x[0] + B * now * self.times), *forces]
        times = {n / self.times for n in range(self.times + 1)} | {self.part}
        for begin, end in pairwise(sorted(times)):
            moved, pushed = under_force(self.A, self.b, end - begin)
            x = moved @ x + pushed * forces[self.whole + (begin < self.part)]
            if (end * self.times).is_integer():
                differences = [x[0] - last[0], *differences[:-1]]
                last = x[:1]
                speed = np.dot(self.above, differences) - np.dot(self.below, speeds)
                speeds = [speed, *speeds[:-1]] if len(speeds) else speeds
        return np.concatenate([x, last, differences, speeds, forces[: self.whole + 1]])

    def radius(self, K, B):
        columns = [self.step(unit, K, B) for unit in np.eye(self.size)]
        return np.abs(np.linalg.eigvals(np.transpose(columns))).max()


@pytest.mark.parametrize("times", [2, 4])
@pytest.mark.parametrize("kind", KINDS)
def test_verdicts_and_limits_are_those_of_the_steps(kind, times):
    dice, verdicts = np.random.default_rng(DICE), set()
    velocity, filtered = KINDS[kind]
    for delay in (0.0, 0.25, 0.375, 2.75):
        gamma, delta = 10 ** dice.uniform(-4, 0), 10 ** dice.uniform(-3, 0)
        device = Device(gamma, delta, delay, times, filtered)
        engine = Engine(gamma, delta, delay, 1.0, 1.0, Oversampled(velocity, times))
        K, B = 10 ** dice.uniform(-3, 0.5, (2, 8))
        for at in zip(K, B, engine.is_stable(K, B), strict=True):
            *wall, stable = at
            assert stable == (device.radius(*wall) < 1), (delay, at)
            verdicts.add(bool(stable))
        for c, limit in zip(B / 5, engine.trace.limits(B / 5)[0], strict=True):
            if limit > 0:
                assert device.radius(limit * (1 - 1e-6), c) < 1 < device.radius(limit * 1.000001, c)
    assert verdicts == {True, False}


@pytest.mark.parametrize("kind", KINDS)
def test_a_simulation_follows_the_same_steps(kind):
    velocity, filtered = KINDS[kind]
    for delay, friction in ((0.0, None), (1.375, None), (0.25, 1e-9)):
        device = Device(0.01, 0.1, delay, 4, filtered)
        state = np.zeros(device.size)
        state[0] = state[2] = 1.0
        wanted = [1.0]
        for _ in range(30):
            state = device.step(state, 0.02, 0.03)
            wanted.append(state[0])
        scene = Scene(
            mass=1.0, damping=0.1, stiffness=0.01, sampling_period=1.0, delay_samples=delay,
            velocity=Oversampled(velocity, 4), coulomb_friction=friction,
        )  # fmt: skip
        found = scene.simulate(0.02, 0.03, duration=30.0, position0=1.0, unilateral=False)
        assert found.position[:: len(found.position) // 30] == pytest.approx(wanted, abs=1e-7)


def test_faster_readings_make_the_difference_younger():
    """The difference of two samples is half a period old, that of two readings an eighth."""
    slow = Scene(mass=0.1, damping=0.5, sampling_period=0.001)
    fast = Scene(
        mass=0.1, damping=0.5, sampling_period=0.001, velocity=Oversampled(Difference(), 4)
    )
    assert slow.limit_at(20.0).K < fast.limit_at(20.0).K < 1.5 * slow.limit_at(20.0).K
    assert pytest.approx(slow.limit_at(0.0).K, rel=1e-9) == fast.limit_at(0.0).K


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ((Measured(), 4), "velocity: Measured"),
        ((Oversampled(Difference(), 2), 4), "velocity: Oversampled"),
        (("fast", 4), "velocity: 'fast'"),
        ((Difference(), 1), "times: 1"),
        ((Difference(), 65), "times: 65"),
        ((Difference(), True), "times: True"),
        ((Difference(), 2.0), r"times: 2\.0"),
        ((Window(9), 4), "velocity: Window.*at most 8"),
    ],
)
def test_what_no_sensor_reads_is_refused(given, why):
    with pytest.raises(ValueError, match=why):
        Oversampled(*given)


def test_what_does_not_go_together_is_refused():
    fast = Oversampled(Difference(), 2)
    for other in ({"virtual_mass": 0.01}, {"integrator": "explicit Euler"}):
        with pytest.raises(ValueError, match=next(iter(other))):
            Scene(mass=1.0, sampling_period=0.001, velocity=fast, **other)
    scene = Scene(mass=1.0, damping=1.0, sampling_period=0.001, velocity=fast)
    with pytest.raises(ValueError, match="one rate"):
        scene.is_passive(1.0, 0.0)


def test_a_device_file_has_the_readings(tmp_path):
    file = tmp_path / "fast.toml"
    lines = 'mass = "1 kg"\nsampling_rate = "1 kHz"\n[velocity]\ncutoff = "200 Hz"\ntimes = '
    file.write_text(lines + "4")
    assert read(file).scene.velocity == Oversampled(LowPass(cutoff=200.0), 4)
    file.write_text(lines + '"many"')
    with pytest.raises(BadDevice, match=r"fast.toml:5: times: 'many' is not allowed"):
        read(file)
