"""The delay margin of exported C: it may be too small, but no delay up to it is unstable."""

import numpy as np
import oracle
import pytest
from export.test_languages import needs, run
from export.test_request import symhaptic
from export.test_sampled import KINDS, ROOM, Exported, in_floats

from symhaptic.export import request
from symhaptic.export.targets import TARGETS

pytestmark = pytest.mark.ci

LATER = {"double": 1e-6, "single": 0.03}
"""So much later than the margin, of the whole delay and two periods, a loop is unstable."""


@pytest.fixture(scope="module", params=KINDS)
def c(request, tmp_path_factory):
    return Exported(tmp_path_factory.mktemp("margin"), request.param, names=["delay_margin"])


def walls(rng, number):
    """Walls inside the boundary down to roundings, of slow and stiff devices."""
    while number > 0:
        gamma = rng.choice([0, 0, 1e-5, 1e-3, 0.1, 1, 5, 40]) * rng.uniform(0.5, 1)
        delta = rng.choice([0, 1e-6, 1e-3, 0.05, 0.5, 3]) * rng.uniform(0.5, 1)
        delay = rng.choice([0, 0, 1, 2, 3, 0.5, 0.25, 0.9, 1.75, rng.uniform(0, 3)])
        angle = 10 ** rng.uniform(-1.5, 0.49) / (1 + delay)
        alpha, beta = on_the_boundary(angle, gamma, delta, delay)
        inside = 1 - rng.choice([1e-14, 1e-9, 1e-5, 1e-3, 0.1, 0.5, 0.8])
        if np.isfinite(alpha + beta):
            yield alpha * inside * rng.choice([1, 1, 0.9, 0.3]), beta * inside, gamma, delta, delay
            number -= 1


def on_the_boundary(theta, gamma, delta, delay):
    """The wall with a root at exp(j theta), by the oracle's matrices."""
    z = np.exp(1j * theta)
    free, late = oracle.sampled(gamma, delta)
    steps = int(np.floor(delay))
    after, newer = oracle.sampled(gamma, delta, 1 + steps - delay)
    _, older = oracle.sampled(gamma, delta, delay - steps)
    force = newer + after @ older / z if delay > steps else late
    moved = np.linalg.solve(z * np.eye(2) - free, force)[0] * z**-steps
    needed = -1 / moved  # alpha + beta (1 - 1/z)
    beta = needed.imag / (1 - 1 / z).imag
    return needed.real - beta * (1 - 1 / z).real, beta


@pytest.mark.parametrize("number", [300, pytest.param(30000, marks=pytest.mark.slow)])
def test_no_delay_up_to_the_margin_is_unstable(c, number):
    """Beside roots that are counted in balls, on the same floats; and soon after it one is."""
    rng = np.random.default_rng(number)
    told, endless = 0, 0
    for loop in walls(rng, number):
        alpha, beta, gamma, delta, delay = in_floats(c, *loop)
        margin = c.plain("delay_margin", alpha, beta, gamma, delta, delay)
        assert margin >= 0 or np.isnan(margin)
        if not margin > 0:
            continue
        last = min(delay + 6, float(np.nextafter(delay + margin, 0)))
        for at in (last, *rng.uniform(delay, max(last, delay), 3)):
            inside = oracle.all_inside(alpha, beta, gamma, delta, max(float(at), delay))
            assert inside is not False, (loop, margin, at)
        endless += np.isinf(margin)
        if last < delay + 6:
            told += 1
            later = delay + margin + LATER[c.precision] * (delay + margin + 2)
            assert oracle.all_inside(alpha, beta, gamma, delta, later) is False, (loop, margin)
    assert told > number / 5
    assert endless > number / 100


WEAK = [(1e-10, 2e-5, 0.0, 1e-9, 0.0), (1e-9, 1e-4, 0.0, 1e-5, 0.3), (4e-12, 3e-6, 0.0, 0.0, 1e4)]


@pytest.mark.parametrize("loop", WEAK, ids=str)
def test_a_long_margin_is_that_of_the_continuous_loop(c, loop):
    """Of a wall for which a period is short, x'' + delta x' = -(alpha x + beta x') after the delay:
    at the angle where both sides are equally strong."""
    alpha, beta, _, delta, delay = loop = in_floats(c, *loop)
    lead = beta**2 - delta**2
    angle = np.sqrt((lead + np.hypot(lead, 2 * alpha)) / 2)
    latest = (np.arctan2(beta * angle, alpha) + np.arctan2(delta, angle)) / angle
    assert delay + c.plain("delay_margin", *loop) == pytest.approx(latest, rel=1e-3)


def test_a_sampled_device_has_the_margins_of_the_plain_function(c):
    rng = np.random.default_rng(5)
    for loop in walls(rng, 100):
        loop = in_floats(c, *loop)
        sampled = c.judged("delay_margin", c.device(*loop[2:]), *loop[:2])
        np.testing.assert_equal(sampled, c.plain("delay_margin", *loop))


def test_a_loop_that_is_stable_again_later_is_lost_at_its_first_margin(c):
    """A delay of half an oscillation turns the wall's damping round, a whole one turns it back."""
    loop = in_floats(c, 0.002, 0.03, 0.1, 0.01)
    assert [oracle.all_inside(*loop, at) for at in (0.0, 9.0, 17.5)] == [True, False, True]
    for begin in (0.0, 17.5):
        margin = c.plain("delay_margin", *loop, begin)
        assert 0 < margin < 9
        assert oracle.all_inside(*loop, begin + margin * 0.9999)
        assert not oracle.all_inside(*loop, begin + margin * 1.01)


def test_an_unstable_loop_has_none(c):
    assert c.plain("delay_margin", 0.5, 0.1, 0.0, 0.01, 3.0) == 0
    assert c.plain("delay_margin", -0.5, 0.1, 0.25, 0.01, 0.0) == 0


def test_a_wall_that_is_weaker_everywhere_has_an_infinite_one(c):
    """A spring that is weaker than the device's, behind friction: no delay destabilises it."""
    assert c.plain("delay_margin", 0.01, 0.02, 5.0, 0.5, 0.0) == np.inf


@pytest.mark.parametrize("bad", range(5))
@pytest.mark.parametrize("value", [np.nan, np.inf, -1e300])
def test_outside_the_domain_it_is_not_a_number(c, bad, value):
    loop = [0.1, 0.3, 0.1, 0.1, 1.0]
    loop[bad] = value
    assert np.isnan(c.plain("delay_margin", *loop))


def test_a_device_that_nobody_sampled_has_none(c):
    assert not c.judged("delay_margin", ROOM(), 0.1, 0.1) > 0


@pytest.mark.parametrize("scene", ["", "no-stiffness", "no-stiffness,no-damping"])
@pytest.mark.parametrize("target", ["c", "microcontroller"])
def test_the_self_test_passes(target, scene, tmp_path):
    needs("gcc")
    forms = request.chosen(["delay_margin"], request.scene(scene))
    _, files = request.built(TARGETS[target], forms)
    assert files["vectors.txt"].count("delay_margin 0x") > 4
    request.write(files, tmp_path / "out")
    *_, told = (run(command, tmp_path / "out") for command in TARGETS[target].commands("haptic"))
    assert ", 0 missed" in told


REFUSED = {
    "--target rust": "delay_margin: is exported in C only",
    "--target c --whole-delays": "--whole-delays: delay_margin: needs fractional delays",
    "--target c --scene no-delay": "delay_margin: is about a delay, and the scene has none",
    "--target c --derivative delta": "--derivative: delay_margin: has no derivative",
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_has_none_is_refused(words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    code, _, err = symhaptic(monkeypatch, capsys, "export", "delay_margin", *words.split())
    assert code == 2
    assert REFUSED[words] in err
