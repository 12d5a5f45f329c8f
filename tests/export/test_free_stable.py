"""Without a spring one quadratic and one angle decide: beside counted roots, and eigenvalues."""

from itertools import product

import numpy as np
import oracle
import pytest
from export.test_targets import run_all

from symhaptic.export import request
from symhaptic.export.language import Refused
from symhaptic.export.targets import TARGETS
from symhaptic.kernels import haptic

SCENES = "no-stiffness", "no-stiffness,no-damping", "no-stiffness,no-virtual-damping"
RNG = np.random.default_rng(73)


def verdict(words, precision=None):
    forms = request.chosen(["is_stable"], request.scene(words), whole_delays=True)
    _, files = request.built(request.target("numpy", precision), forms, vectors=False)
    assert "free_stable(" in files["haptic.py"]
    assert "whole_roots(" not in files["haptic.py"]
    space = {}
    exec(files["haptic.py"], space)
    return space["is_stable"], [symbol.name for symbol in forms[0].arguments]


def walls(count, words):
    """Around the stable region, and a ten-thousandth beside its boundary, of slow and fast arms."""
    d = RNG.choice([0.0, 0.0, 1.0, 2.0, 5.0, 40.0, 1e6], count)
    delta = RNG.choice([0.0, 1.0, 1e-6, 30.0], count) * RNG.uniform(0.1, 1, count)
    delta = 0 * delta if "no-damping" in words else delta
    theta = RNG.choice([1.0, 1e-4, 0.1], count) * RNG.uniform(0.01, 1, count) * np.pi / (d + 1)
    near = np.stack(haptic.stability_boundary(theta, 0.0, delta, d))
    beside = RNG.choice([0.9999, 1.0001], count)  # near the origin the boundary is a ray from it
    near *= np.stack([beside, 1 / beside])
    wide = np.stack([RNG.uniform(-0.3, 3, count), RNG.uniform(-1, 5, count)]) * (1 + delta)
    alpha, beta = np.where(RNG.random(count) < 0.5, near, wide / (d + 1))
    beta = 0 * beta if "no-virtual-damping" in words else beta
    return {"alpha": alpha, "beta": beta, "delta": delta, "d": d}


@pytest.mark.parametrize("words", SCENES)
def test_it_is_the_verdict_of_counted_roots(words):
    """The full scene counts them at three expansions of up to two angles."""
    free, names = verdict(words)
    given = walls(6_000, words)
    counted = haptic.is_stable(given["alpha"], given["beta"], 0.0, given["delta"], given["d"])
    found = free(*(given[name] for name in names))
    assert np.array_equal(found, counted)
    assert 0.05 < np.mean(found) < 0.95


def test_it_is_the_verdict_of_eigenvalues():
    """Among them walls as strong as the device at z = -1, of which the sign of F tells nothing."""
    free, _ = verdict("no-stiffness")
    for wall in zip(*(v[:150] for v in walls(2000, "").values()), strict=True):
        alpha, beta, delta, d = map(float, wall)
        size = oracle.moduli(alpha, beta, 0.0, delta, d).max() if d < 50 else 1.0
        if abs(size - 1) > 1e-9:
            assert bool(free(alpha, beta, delta, d)) == (size < 1), wall


@pytest.mark.parametrize(
    "wall",
    [(0.0, 0.5, 0.3, 1.0), (-1e-9, 0.5, 0.3, 1.0), (0.1, 0.5, 0.3, 1.5), (np.nan, 0.5, 0.3, 1.0),
     (0.1, np.nan, 0.3, 1.0), (0.1, 0.5, -0.1, 1.0), (1e71, 0.5, 0.3, 1.0)],
)  # fmt: skip
def test_it_says_no_of_walls_that_hold_nothing_and_outside_the_domain(wall):
    free, _ = verdict("no-stiffness")
    assert not free(*wall)
    assert free(0.1, 0.5, 0.3, 1.0)


QUICK = ("c", "single"), ("numpy", "double")


@pytest.mark.parametrize(
    ("language", "precision"),
    [pytest.param(*case, marks=[] if case in QUICK else pytest.mark.slow)
     for case in product(TARGETS, ["double", "single"])],
)  # fmt: skip
def test_the_self_test_passes(language, precision, tmp_path):
    """With fractions, too, of which roots are counted."""
    try:
        target = request.target(language, precision)
    except Refused as wrong:
        pytest.skip(str(wrong))
    for whole in (True, False):
        forms = request.chosen(["is_stable"], request.scene(SCENES[0]), whole_delays=whole)
        _, files = request.built(target, forms)
        request.write(files, tmp_path / f"{whole}")
        assert run_all(target, "haptic", tmp_path / f"{whole}").split()[2] == "0"
