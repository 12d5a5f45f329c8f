"""Bands of angles beside the crossings of the loop at many fractions of a period.

The devices are sampled by the exponentials of their matrices, and |A| = |M W| is solved as the
polynomial in z that it is on the unit circle.
"""

import numpy as np
import pytest
from oracle import sampled

from symhaptic.numeric.crossings import wall
from symhaptic.numeric.plant import device
from symhaptic.numeric.tracing.bands import bands, part_of

COUNT = 90
SHARES = np.linspace(-1, 1, 7)


def late(gamma, delta, part):
    """The rows m2, m1, m0 and 1, -a, e of devices behind a fraction of a period."""
    free, _ = sampled(gamma, delta)
    after, newer = sampled(gamma, delta, 1 - part)
    _, older = sampled(gamma, delta, part)
    older = np.einsum("...ij,...j->...i", after, older)
    rows = np.zeros((*np.shape(newer)[:-1], 3))
    for shift, push in ((0, newer), (1, older)):  # (1, 0) adj(z - free) push
        rows[..., shift] += push[..., 0]
        rows[..., shift + 1] += free[..., 0, 1] * push[..., 1] - free[..., 1, 1] * push[..., 0]
    trace, product = np.trace(free, axis1=-2, axis2=-1), np.linalg.det(free)
    return rows, np.stack([np.ones_like(trace), -trace, product], axis=-1)


def crossings(alpha, beta, above, below):
    """The angles in (0, pi) at which |A| = |M W|, and the phases of (M/z) W/(A/z) there."""
    push = np.convolve(above, [alpha + beta, -beta])
    size = np.convolve(push, push[::-1]) - np.pad(np.convolve(below, below[::-1]), 1)
    z = np.roots(size)
    z = z[(np.abs(np.abs(z) - 1) < 1e-9) & (z.imag > 1e-6)]
    return np.angle(z), np.angle(np.polyval(push, z) / np.polyval(below, z))


def loops(rng):
    """Walls beside which devices of all kinds have crossings, and a fraction of a period."""
    gamma = np.choose(
        rng.integers(0, 3, COUNT),
        [rng.uniform(0, 1, COUNT), rng.uniform(1, 60, COUNT), np.pi**2 + rng.normal(size=COUNT)],
    )
    delta = rng.choice([0.02, 1.0, 9.0], COUNT) * rng.random(COUNT)
    size = rng.choice([0.1, 1.0, 10.0], COUNT)
    alpha, beta = rng.normal(size=(2, COUNT)) * size
    return alpha, beta, gamma, delta, rng.uniform(0.05, 0.95, COUNT)


def runs(half):
    """The bands of random walls, and of each the angles and the phases of what is found in it."""
    alpha, beta, gamma, delta, middle = loops(np.random.default_rng(11))
    part = part_of(device(gamma, delta), gamma, delta, middle, np.full(COUNT, half))
    found = bands(part, wall(alpha, beta))
    angles, phases = ([[] for _ in found.at] for _ in range(2))
    for share in SHARES * half:
        for i, rows in enumerate(zip(*late(gamma, delta, middle + share), strict=True)):
            for theta, phase in zip(*crossings(alpha[i], beta[i], *rows), strict=True):
                inside = (found.at == i) & (found.low - 1e-8 < theta) & (theta < found.high + 1e-8)
                (k,) = np.flatnonzero(inside)
                angles[k].append(theta)
                phases[k].append((phase - found.least[k] + 1e-7) % (2 * np.pi))
    return found, angles, phases


@pytest.mark.parametrize(("half", "usual"), [(0.03, 3), (1e-3, 1.1)])
def test_every_crossing_is_in_a_band_that_is_hardly_wider_than_needed(half, usual):
    """`runs` fails if a crossing lies in no band or in two; bands of shorter parts fit closer."""
    found, angles, phases = runs(half)
    width, room = found.high - found.low, found.most - found.least
    assert all(
        max(some, default=0.0) < most + 2e-7 for some, most in zip(phases, room, strict=True)
    )
    through = [k for k, some in enumerate(angles) if len(some) == SHARES.size]
    assert len(through) > COUNT // 3
    for size, exact in ((width, angles), (room, phases)):
        assert np.median([size[k] / np.ptp(exact[k]) for k in through]) < usual


def test_what_a_band_says_of_itself_is_what_its_two_angles_say():
    found, *_ = runs(0.03)
    middle = np.arccos(1 - found.y / 2)
    assert np.allclose(found.rest, 4 - found.y, rtol=0, atol=1e-14)
    assert np.allclose(
        found.off, found.y - 2 * found.part.x.at_one / (1 + found.part.x.e), rtol=0, atol=1e-12
    )
    assert np.allclose(found.reach, np.maximum(found.high - middle, middle - found.low))
    assert np.allclose(found.away, (np.cos(found.low) - np.cos(found.high)) / 2, rtol=1e-6)
    assert np.allclose(found.top, 2 - 2 * np.cos(found.high))
    nearest = np.clip(np.pi / 2, found.low, found.high)
    assert np.allclose(found.sine, np.sin(nearest))


def test_the_device_changes_within_a_part_by_no_more_than_it_says():
    """S = m2 + m0 and D = m2 - m0, and their slopes by differences at a step of 1e-5."""
    _, _, gamma, delta, middle = loops(np.random.default_rng(12))
    half, step = np.minimum(0.03, middle / 2), 1e-5
    part = part_of(device(gamma, delta), gamma, delta, middle, half)

    def sums(share):
        m2, _, m0 = late(gamma, delta, middle + share)[0].T
        return np.array([m2 + m0, m2 - m0])

    def slopes(share):
        return (sums(share + step) - sums(share - step)) / (2 * step)

    assert np.allclose(slopes(0.0), [part.sum_slope, part.gap_slope], rtol=0, atol=1e-9)
    change = np.max([np.abs(sums(s * half) - sums(0.0)) for s in SHARES], axis=0)
    turn = np.max([np.abs(slopes(s * half) - slopes(0.0)) for s in SHARES], axis=0)
    for exact, most in (
        (turn, [part.sum_turn, part.gap_turn]),
        (change, [part.sum_change, part.gap_change]),
    ):
        assert (exact < np.array(most) + 1e-9).all()
