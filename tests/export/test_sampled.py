"""A device that is sampled once in exported C, and verdicts that say where they are not certain."""

import ctypes
import subprocess

import numpy as np
import oracle
import pytest
from export.test_languages import needs

from symhaptic.export import request
from symhaptic.export.precision import PRECISIONS
from symhaptic.export.targets import TARGETS
from symhaptic.kernels import haptic

pytestmark = pytest.mark.ci

JUDGES = "is_stable", "unstable_roots", "verdict"
KINDS = {"double": (ctypes.c_double, np.float64), "single": (ctypes.c_float, np.float32)}
ROOM = ctypes.c_double * 32
"""More than the record takes."""


class Exported:
    """The functions of an export, called from here."""

    def __init__(self, folder, precision, words=(), names=("is_stable", "unstable_roots")):
        needs("gcc")
        forms = request.chosen(names, *words)
        language = TARGETS["c"].at(PRECISIONS[precision])
        _, files = request.built(language, forms, vectors=False)
        self.header = files["haptic.h"]
        for name in ("haptic.c", "haptic.h"):
            (folder / name).write_text(files[name])
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Werror", "-fPIC", "-shared"]
        command = ["gcc", *flags, "haptic.c", "-o", "haptic.so", "-lm"]
        subprocess.run(command, cwd=folder, check=True)
        self.library = ctypes.CDLL(str(folder / "haptic.so"))
        self.precision, (self.kind, self.float) = precision, KINDS[precision]

    def function(self, name):
        found = getattr(self.library, f"haptic_{name}")
        found.restype = ctypes.c_bool if name.endswith("is_stable") else self.kind
        return found

    def plain(self, name, *numbers):
        return float(self.function(name)(*map(self.kind, numbers)))

    def device(self, *numbers):
        room = ROOM()
        self.library.haptic_device_init(room, *map(self.kind, numbers))
        return room

    def judged(self, name, device, *wall):
        return float(self.function(f"device_{name}")(device, *map(self.kind, wall)))


@pytest.fixture(scope="module", params=KINDS)
def exported(request, tmp_path_factory):
    return Exported(tmp_path_factory.mktemp("sampled"), request.param)


def devices(rng, count):
    """Slow and stiff, creeping and swinging devices, with whole delays and with fractions."""
    gamma = rng.choice([0.0, 1e-4, 0.3, 5.0, 39.0, 700.0], count) * rng.uniform(0.5, 1, count)
    delta = rng.choice([0.0, 1e-6, 0.05, 2.0, 30.0], count) * rng.uniform(0.5, 1, count)
    delay = rng.choice([0.0, 1.0, 2.0, 5.0], count) + rng.choice([0.0, 0.5, 0.9, 1e-6], count)
    return zip(gamma.tolist(), delta.tolist(), delay.tolist(), strict=True)


def walls(rng, count, *device):
    """Walls at and beside the boundary, which is where roots meet the circle, down to roundings."""
    theta = rng.uniform(0.01, 3.1, count)
    alpha, beta = haptic.stability_boundary(theta, *device)
    size = 10.0 ** rng.uniform(-17, 0, count) * rng.choice([-1, 1], count)
    return zip((alpha * (1 + size)).tolist(), beta.tolist(), strict=True)


def in_floats(exported, *numbers):
    return [float(exported.float(x)) for x in numbers]


def test_a_sampled_device_gets_the_verdicts_of_the_plain_functions(exported):
    rng = np.random.default_rng(45)
    seen = set()
    for device in devices(rng, 300):
        device = in_floats(exported, *device)
        sampled = exported.device(*device)
        for wall in walls(rng, 8, *device):
            wall = in_floats(exported, *wall)
            found = {name: exported.plain(name, *wall, *device) for name in JUDGES}
            assert found == {name: exported.judged(name, sampled, *wall) for name in JUDGES}
            stable, roots, verdict = found.values()
            assert stable == (verdict == 1)
            assert verdict != 1 or roots == 0
            assert roots < 1 or verdict == 0
            seen.add(verdict)
    assert seen == {1.0, 0.0, -1.0}


def hard(exported, rng, number):
    """A wall a few roundings beside the boundary, or beside the line alpha = -gamma."""
    for gamma, delta, delay in devices(rng, number):
        device = in_floats(exported, gamma, delta, delay)
        for alpha, beta in walls(rng, 4, *device):
            yield *in_floats(exported, alpha, beta), *device
        last = float(np.nextafter(exported.float(-device[0]), exported.float(rng.choice([-9, 9]))))
        yield last, float(exported.float(0.1)), *device


@pytest.mark.parametrize("number", [40, pytest.param(1500, marks=pytest.mark.slow)])
def test_a_verdict_next_to_the_boundary_is_right_or_undecided(exported, number):
    """Beside a recursion in balls on the same floats, which shares no formula with it."""
    decided = {True: 0, False: 0}
    for loop in hard(exported, np.random.default_rng(number), number):
        verdict = exported.plain("verdict", *loop)
        if verdict >= 0:
            exact = oracle.all_inside(*loop)
            assert exact if verdict else exact is not True, loop
            decided[verdict == 1] += 1
    assert min(decided.values()) > number / 8


STIFF = [
    # m2 and m0 are off by as many last places as the device turns in a period
    (1.7312962659634864e-06, 1.9655876602085053e-05, 1531779.9100544637, 0.0, 3.1417663972738494),
    (-571436145.7309575, 303036944.92663866, 1909237320.6258085, 0.3965915062397475,
     3.680838969240091),
    (103589796573117.05, -82136193041102.56, 337498094126724.2, 5.602189849640211e-11,
     0.6899712643194227),
    # half turns: whether device and wall are as strong as each other three times is not certain
    (134.32005310058594, -67.16002655029297, 88.8264389038086, 2.948215360731865e-08,
     0.09000106900930405),
    (30737.251953125, -15368.630859375, 27723.71875, 0.0, 0.5633560419082642),
    (828205843787.5679, -414102921894.18115, 827042583955.6108, 0.0, 5.828692289297919e-08),
]  # fmt: skip
"""Walls within roundings of the boundary, of devices that turn more than once in a period."""


@pytest.mark.parametrize("loop", STIFF, ids=lambda loop: f"gamma={loop[2]:.4g}")
def test_a_verdict_of_a_stiff_device_with_a_fractional_delay_is_right_or_undecided(exported, loop):
    loop = in_floats(exported, *loop)
    verdict, roots = (exported.plain(name, *loop) for name in ("verdict", "unstable_roots"))
    assert verdict == -1 or oracle.all_inside(*loop) == (verdict == 1)
    assert roots == -1 or oracle.certified(*loop) == roots


ON_THE_CIRCLE = [
    (-0.25, 0.1, 0.25, 0.1, 1.0),  # alpha = -gamma: a root at 1
    (0.0, 0.0, 0.25, 0.0, 1.0),  # no damping and no wall
]


@pytest.mark.parametrize("loop", ON_THE_CIRCLE)
def test_a_loop_that_is_known_to_swing_on_is_not_stable(exported, loop):
    assert exported.plain("verdict", *loop) == 0


UNDECIDED = [
    # the limit 12 - 8 sqrt(2) of a free mass, rounded
    (0.6862915010152394, 0.8284271247461901, 0.0, 0.0, 0.0),
    (0.1, 0.1, float(np.pi) ** 2, 0.0, 1.0),  # half a swing in a period, but for the last place
    *(tuple(np.nan if i == bad else 0.1 for i in range(5)) for bad in range(5)),
    (0.1, 0.1, -0.1, 0.1, 1.0),
    (0.1, 0.1, 0.1, np.inf, 1.0),
    (0.1, 0.1, 0.1, 0.1, -1.0),
]


@pytest.mark.parametrize("loop", UNDECIDED, ids=str)
def test_what_floats_cannot_tell_is_undecided(exported, loop):
    assert exported.plain("verdict", *loop) == -1
    assert exported.plain("is_stable", *loop) == 0
    assert exported.judged("verdict", exported.device(*loop[2:]), *loop[:2]) == -1


def test_a_device_that_nobody_sampled_has_no_stable_wall(exported):
    """A record of zeros, as static ones are."""
    for wall in ((0.1, 0.1), (1e-9, 0.0), (0.0, 0.0), (-0.1, 3.0)):
        assert exported.judged("verdict", ROOM(), *wall) < 1
        assert exported.judged("is_stable", ROOM(), *wall) == 0


def test_without_a_spring_the_verdict_is_that_of_one_angle(tmp_path):
    """It comes from another algorithm there; beside roots that are counted in balls."""
    free = Exported(tmp_path, "double", [request.scene("no-stiffness"), None, (), True])
    assert "free_stable" in (tmp_path / "haptic.c").read_text()
    rng = np.random.default_rng(5)
    seen = set()
    for _ in range(60):
        delta, delay = float(rng.choice([0.0, 0.01, 1.0])), float(rng.choice([0.0, 1.0, 4.0]))
        sampled = free.device(delta, delay)
        for alpha, beta in [*walls(rng, 4, 0.0, delta, delay), (-0.1, 0.1), (0.2, 40.0)]:
            verdict = free.plain("verdict", alpha, beta, delta, delay)
            assert verdict == free.judged("verdict", sampled, alpha, beta)
            assert free.plain("is_stable", alpha, beta, delta, delay) == (verdict == 1)
            if verdict >= 0:
                assert oracle.all_inside(alpha, beta, 0.0, delta, delay) in (verdict == 1, None)
            seen.add(verdict)
    assert seen == {1.0, 0.0, -1.0}


def test_a_scene_whose_device_is_a_number_has_nothing_to_sample(tmp_path):
    words = request.scene("no-stiffness,no-damping,no-delay")
    assert "sampled" not in Exported(tmp_path, "double", [words]).header
