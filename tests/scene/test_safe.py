"""Safe walls in SI units: what is proved is what is answered, and nothing beyond it."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from oracle import radius

from symhaptic import Arm, ArmRange, Scene
from symhaptic.scene.picture import EDGE, UNSTABLE
from symhaptic.scene.safe import draw_safe


@cache
def phantom():
    return Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=1.5).safe_walls()


def arms(count, seed=1):
    """Arms of the default range: (23), up to 23 kg, and none at all."""
    rng = np.random.default_rng(seed)
    yield Arm(mass=0.0)
    for _ in range(count):
        mass = 23 * rng.uniform() ** 4
        damping, stiffness = rng.choice([0, 1, rng.uniform()], 2)
        yield Arm(mass=mass, damping=20 * mass * damping, stiffness=1000 * mass * stiffness)


def test_no_arm_makes_a_wall_unstable_that_is_inside():
    safe = phantom()
    rng = np.random.default_rng(2)
    B = rng.uniform(0, 46, 400)
    K = safe.limit_at(B) * rng.choice([1, 0.9, 0.1], 400)
    kept = safe.softest <= K
    assert kept.sum() > 200
    assert np.array_equal(safe.contains(K, B)[kept], np.ones(kept.sum(), bool))
    for arm in arms(20):
        held = safe.scene.held_by(arm)
        assert held.is_stable(K[kept], B[kept]).all(), arm


def test_a_wall_beyond_the_limit_of_some_arm_is_not_inside():
    safe = phantom()
    B = np.linspace(0, 46, 24)
    for arm in arms(8, seed=4):
        held = safe.scene.held_by(arm)
        K = np.array([held.limit_at(float(b)).K for b in B])
        beyond = np.isfinite(K) & (K > 0)
        assert not safe.contains(1.0001 * K[beyond], B[beyond]).any()


def test_the_rectangle_is_inside_and_not_small():
    safe = phantom()
    (low, high), (left, right) = safe.rectangle
    K, B = np.meshgrid(np.linspace(low, high, 30), np.linspace(left, right, 50))
    assert safe.contains(K, B).all()
    assert not safe.contains(high * 1.02, np.linspace(left, right, 50)).all()
    assert (high - low) * (right - left) > 0.4 * safe.area


def test_passive_walls_are_passive_and_nearly_all():
    safe = phantom()
    K, B = np.meshgrid(np.linspace(0, 5, 60), np.linspace(-0.006, 0.006, 60))
    found = safe.is_passive(K, B)
    known = safe.scene.is_passive(K, B)
    assert not (found & ~known).any()
    assert found.sum() > 0.95 * known.sum()


def test_the_best_damping_is_safe_and_bears_the_most():
    safe = phantom()
    best = safe.best_damping(2000.0)
    assert safe.contains(2000.0, np.linspace(*best.safe, 50)).all()
    light = [Arm(mass=m, damping=20 * m, stiffness=1000 * m) for m in (0.0, 0.02)]
    held = [safe.scene.held_by(arm) for arm in light]
    delay = best.delay_margin

    def spare(B):
        return min(scene.delay_margin(K=2000.0, B=float(B)) for scene in held)

    assert spare(best.B) >= 0.98 * delay
    assert all(spare(B) < 1.05 * delay for B in (best.safe[0], best.safe[1]))


@pytest.mark.parametrize("cut", [0.3, 0.7])
def test_of_two_ranges_of_damping_the_longer_is_named_and_nothing_between_them(cut):
    """Without one column, the others are still proved."""
    safe = phantom()
    columns = safe.certificate.columns
    (high,) = np.nonzero(np.array(columns.tops) >= 2000)
    tops = list(columns.tops)
    tops[high[int(cut * len(high))]] = 0.0
    claim = replace(safe.certificate, columns=replace(columns, tops=tuple(tops)))
    parted = replace(safe, certificate=claim)
    low, last = parted.best_damping(2000.0).safe
    assert parted.contains(2000.0, np.linspace(low, last, 500)).all()
    width = columns.edges[high[-1] + 1] - columns.edges[high[0]]
    assert 0.6 * width < last - low < 0.8 * width


def test_it_is_checked_again_and_says_so():
    safe = phantom()
    assert safe.recheck()
    text = str(safe)
    assert "stable up to" in text
    assert "N/m with B" in text
    assert "0 to 23 kg, 0 to 20 Ns/m per kg, 0 to 1000 N/m per kg" in text
    assert safe._repr_html_().startswith("<table>")


@pytest.mark.parametrize("bad", ["1", None, 1j])
def test_what_is_no_number_is_named(bad):
    safe = phantom()
    for name, ask in {
        "K": lambda: safe.contains(bad, 20.0),
        "B": lambda: safe.contains(1000.0, bad),
        "B:": lambda: safe.limit_at(bad),
        "K:": lambda: safe.is_passive(bad, 1.0),
    }.items():
        with pytest.raises(ValueError, match=f"^{name}.* is not allowed; give (real|a) number"):
            ask()


def test_one_wall_gives_a_truth_value_and_nonsense_is_not_safe():
    safe = phantom()
    assert safe.contains(1000.0, 20.0) is True
    assert type(safe.limit_at(20.0)) is float
    assert not safe.contains([np.nan, np.inf, -1.0, 1000.0], [20.0, 20.0, 20.0, np.nan]).any()
    assert np.array_equal(safe.limit_at([np.nan, -1.0]), [np.nan, 0.0], equal_nan=True)
    assert safe.limit_at([-1.0, 1e9]).tolist() == [0.0, 0.0]


def test_a_masked_wall_is_not_said_to_be_safe():
    safe = phantom()
    masked = np.ma.MaskedArray([20.0, 20.0], mask=[True, False])
    assert safe.contains(1000.0, masked).tolist() == [False, True]
    assert safe.contains(50 * masked, 20.0).tolist() == [False, True]
    assert not safe.is_passive(0 * masked, 0.0)[0]
    assert np.isnan(safe.limit_at(masked)).tolist() == [True, False]


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: ArmRange(mass=(2, 1)), r"mass: \(2, 1\) is not allowed; the lowest comes first"),
        (lambda: ArmRange(mass=(1, 2, 3)), "mass: .* a number or"),
        (lambda: ArmRange(damping=1, damping_per_mass=2), "damping_per_mass: 2 and damping=1"),
        (lambda: ArmRange(damping=np.array([1, 2])), r"damping: array\(\[1, 2\]\) is not allowed"),
        (lambda: ArmRange(mass=(0, None)), "mass: None is not allowed; give finite numbers >= 0"),
        (lambda: ArmRange(stiffness=(0, float("inf"))), "stiffness: inf is not allowed"),
        (lambda: ArmRange.around([]), "arms: .* is not allowed"),
        (
            lambda: Scene.of("Phantom Premium 1.5", sampling_period=1).safe_walls(arm=3),
            "arm: 3 is not allowed; give an ArmRange",
        ),
        (
            lambda: Scene.of("Phantom Premium 1.5", sampling_period=1).safe_walls("all"),
            "arm: 'all' is not allowed; give an ArmRange",
        ),
        (lambda: ArmRange.around([Arm.of("Daniel et al.")]), "arms: one was measured together"),
        (lambda: phantom().best_damping(1e5), "K: 100000.0 is not allowed"),
        (lambda: phantom().delay_margin(1e5, 3.0), "K: 100000.0 with B=3.0 is not proved safe"),
    ],
)
def test_what_is_refused_in_one_line(call, told):
    with pytest.raises(ValueError, match="^" + told) as wrong:
        call()
    assert "\n" not in str(wrong.value)


@pytest.mark.parametrize(
    "other",
    [
        {"arms": ArmRange(mass=(0, 24))},
        {"arms": ArmRange(mass=(0, 23), damping=(0, 20))},
        {"scene": Scene.of("Phantom Premium 1.5", sampling_period=1e-3, delay_samples=4)},
        {"scene": Scene(mass=0.03, damping=0.005, sampling_period=1e-3, delay_samples=1.5)},
    ],
)
def test_the_certificate_of_another_device_or_of_other_arms_is_not_confirmed(other):
    """Its walls were stable for other loops."""
    assert not replace(phantom(), **other).recheck()


@pytest.mark.parametrize("damping", [0.05, 0.5, 2.0])
def test_of_a_device_on_a_stiff_spring_little_is_left_out(damping):
    """The boundary turns about its own spring, fifty to a thousand times as stiff as the walls."""
    spring = {"damping": damping, "stiffness": 64989.5, "sampling_period": 1e-3}
    safe = Scene(mass=0.1, delay=3e-3, **spring).safe_walls(arm=Arm(mass=0.0))
    alpha = safe.limit_at(0.0) * 1e-6 / 0.1
    loop = 0.0649895 / 0.1, damping * 1e-3 / 0.1, 3.0  # gamma, delta, d
    assert radius(alpha, 0.0, *loop) < 1 < radius(1.06 * alpha, 0.0, *loop)


@pytest.mark.parametrize("mass", [1e20, 1e300])
def test_an_arm_beside_which_the_device_is_nothing_is_a_free_mass(mass):
    """Behind one period that bears up to alpha = 0.144469; the curve begins next to B = 0."""
    device = Scene(mass=0.1, damping=0.5, sampling_period=1e-3, delay=1e-3)
    safe = device.safe_walls(arm=Arm(mass=mass))
    assert 0.98 * 0.144469 < safe.stiffest[0] / mass * 1e-6 < 0.144469
    assert len(safe.certificate.cuts) < 5000  # 120 013 before


@pytest.mark.parametrize(
    ("wall", "color"), [(None, None), ((100.0, 5.0), EDGE), ((90000.0, 5.0), UNSTABLE)]
)
def test_a_picture_shows_the_rectangle_and_whether_a_wall_is_inside(wall, color):
    pyplot = pytest.importorskip("matplotlib.pyplot", reason="no Matplotlib here")
    axes = pyplot.subplots()[1]
    draw_safe(axes, phantom(), wall)
    drawn = {line.get_label(): line for line in axes.lines}
    (bottom, top), (left, right) = phantom().rectangle
    rectangle = drawn[f"{top:.0f} N/m with {left:.3g} to {right:.3g} Ns/m"]
    assert set(rectangle.get_xdata()) == {bottom, top}
    assert set(rectangle.get_ydata()) == {left, right}
    marked = [line for label, line in drawn.items() if label.startswith("this wall")]
    assert [line.get_color() for line in marked] == ([] if wall is None else [color])
    assert right < axes.get_ylim()[1]
    assert max(top, wall[0] if wall else 0.0) < axes.get_xlim()[1]
    assert phantom().plot(axes) is axes
    assert phantom().plot() is not axes
    pyplot.close("all")
