"""The committed kernels are what the exporter writes, and a stale one is told."""

from functools import cache

import numpy as np
import pytest
from scipy.linalg import expm

from symhaptic.cli.main import main
from symhaptic.export import kernels
from symhaptic.export.precision import DOUBLE
from symhaptic.kernels import haptic
from symhaptic.notation import sizes
from symhaptic.numeric.boundary import point
from symhaptic.numeric.plant import device


def run(monkeypatch, *words):
    monkeypatch.setattr("sys.argv", ["symhaptic", *words])
    try:
        main()
    except SystemExit as left:
        return left.code
    return 0


@pytest.fixture(autouse=True, scope="module")
def exported():
    """What the exporter writes, written once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kernels, "files", cache(kernels.files))
        yield


def test_the_committed_kernels_are_not_stale():
    assert kernels.differences() == ""


def test_checks_and_kernels_end_at_the_same_sizes():
    here = sizes.LARGEST, sizes.STIFFEST, sizes.LONGEST, sizes.FAINT
    assert here == (DOUBLE.largest, DOUBLE.stiffest, DOUBLE.longest, float(DOUBLE.vanishing))


def test_a_stale_kernel_is_told_and_written_anew(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(kernels, "FOLDER", tmp_path / "kernels")
    kernels.write(kernels.FOLDER)
    monkeypatch.setattr(kernels.differences, "__defaults__", (kernels.FOLDER,))
    assert run(monkeypatch, "kernels", "--check") == 0
    path = kernels.FOLDER / "haptic.py"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("0.25*", "0.26*", 1), encoding="utf-8")
    (kernels.FOLDER / "left_over.py").write_text("x = 1\n", encoding="utf-8")
    assert run(monkeypatch, "kernels", "--check") == 1
    shown = capsys.readouterr()
    assert "-" + next(ln for ln in path.read_text().splitlines() if "0.26*" in ln) in shown.out
    assert "-x = 1" in shown.out
    assert "`symhaptic kernels` writes them" in shown.err
    kernels.write(kernels.FOLDER)
    assert path.read_text(encoding="utf-8") == text
    assert not (kernels.FOLDER / "left_over.py").exists()


@pytest.mark.parametrize("plants", [1, 400])
def test_another_implementation(plants):
    """The hand-written forms that serve fractional delays; both are right to their last digits."""
    rng = np.random.default_rng(4)
    gamma, delta = rng.uniform(0, 6, (2, plants))
    theta = rng.uniform(0.05, 3, 400)
    x, two = device(gamma, delta), np.array(2.0)
    whole = point(x, theta, two)
    pairs = [
        (haptic.discretize(gamma, delta), (x.m2, x.m1, x.a, x.e)),
        (haptic.stability_boundary(theta, gamma, delta, 2.0), whole),
    ]
    for ours, theirs in pairs:
        for one, other in zip(ours, theirs, strict=True):
            assert one == pytest.approx(other, rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("size", [0, 1, haptic.BLOCK - 1, haptic.BLOCK, 2 * haptic.BLOCK + 1])
def test_pieces_are_put_together(size):
    """An array is what its elements are, one by one, whatever branch they take."""
    rng = np.random.default_rng(5)
    gamma, delta = 12 * rng.random(size), 6 * rng.random(size)
    many = np.stack(haptic.discretize(gamma, delta))
    assert many.shape == (4, size)
    for k in range(0, size, max(size // 20, 1)):
        assert np.array_equal(many[:, k], np.stack(haptic.discretize(gamma[k], delta[k])))
    grid = np.stack(haptic.discretize(gamma[:100, None], delta[:7]))
    assert grid.shape == (4, min(size, 100), min(size, 7))
    if size > 7:
        assert np.array_equal(grid[:, 5, 6], np.stack(haptic.discretize(gamma[5], delta[6])))


def test_nan_gives_nan():
    some, none = np.array([0.1, np.nan]), np.array([0.2, 0.3])
    for given in ((some, none), (none, some)):
        assert np.isnan(np.stack(haptic.discretize(*given))).tolist() == [[False, True]] * 4
    assert haptic.unstable_roots(np.nan, 0.1, 0.1, 0.1, 1.0) == -1
    assert haptic.is_stable([np.nan, 0.1], 0.1, 0.1, 0.1, 1.0).tolist() == [False, True]


def sampled(alpha, beta, gamma, delta, late):
    """The loop of a unit mass over a period, its force late by a part of it, by scipy's expm."""
    motion = np.zeros((3, 3))
    motion[:2] = (0, 1, 0), (-gamma, -delta, 1)
    whole, rest = expm(motion), expm(motion * (1 - late))
    loop = np.zeros((4, 4))  # position, speed, the last position, the force of before
    loop[:2, :2] = whole[:2, :2]
    loop[:2, 3] = whole[:2, 2] - rest[:2, 2]
    wall = np.array([-alpha - beta, 0, beta, 0])
    loop[:2] += np.outer(rest[:2, 2], wall)
    loop[2, 0] = 1
    loop[3] = wall
    return loop


def stable(*numbers):
    return max(abs(np.linalg.eigvals(sampled(*numbers)))) < 1


@pytest.mark.parametrize(
    "device",
    [(0, 5, 1e-3), (0, 20, 0.1), (1, 3.5, 1e-3), (7, 11, 0.05), (7, 11, 0.2), (7.62, 1.44, 1e-3),
     (0, 5, 0.3), (2, 0.5, 0.9)],
    ids=str,
)  # fmt: skip
def test_below_one_period_no_stable_wall_is_stiffer(device):
    """Heavily damped devices end at theta = pi, where the search found nothing before."""
    alpha, beta, theta = (float(x) for x in haptic.max_stable_stiffness(*device))
    assert 0 < theta <= np.pi
    gamma = device[0]
    assert stable(alpha - 1e-4 * (alpha + gamma), beta, *device)
    stiffer = alpha + 1e-4 * (alpha + gamma)
    others = beta + 0.3 * (alpha + gamma) * np.linspace(-1, 1, 401)
    assert not any(stable(stiffer, other, *device) for other in (beta, *others))
