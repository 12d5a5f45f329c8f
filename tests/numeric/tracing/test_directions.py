"""Which way roots cross: no corner of the boxes in which the numbers lie contradicts what is said.

The numbers are random; no device has to have them.
"""

import numpy as np
import pytest

from symhaptic.numeric.crossings import Wall, wall
from symhaptic.numeric.plant import Device, device
from symhaptic.numeric.tracing import directions
from symhaptic.numeric.tracing.bands import Bands, Part, part_of, slopes

COUNT = 60
MIDDLE, CORNERS = np.array([[0]]), np.array([[1 + 1j], [1 - 1j], [-1 + 1j], [-1 - 1j]])


def random_bands(rng, error):
    """Bands whose errors are such a share of the numbers."""
    size = 10 ** rng.uniform(-1.5, 1.5, (23, COUNT)) * rng.choice([-1, 1], (23, COUNT))
    device, wall, slopes, errors = np.split(size, [11, 15, 17])
    y = rng.uniform(0.1, 3.9, COUNT)
    off, reach, away = error * np.abs(errors[4:]).repeat(2, axis=0)[:3]
    part = Part(Device(*device), y, *slopes, *error * np.abs(errors[:4]))
    ends = y + 2 * away, np.sqrt(y * (4 - y)) / 2 + reach
    return Bands(np.arange(COUNT), part, Wall(*wall), y, y, y, y, y, 4 - y, off, reach, away, *ends)


def at_corners(boxes, steps):
    """-Re(h conj(Z)) with the numbers at the centres of their boxes, and at all corners."""
    found = []
    for signs in (MIDDLE, CORNERS):
        values = []
        for k, box in enumerate(boxes):
            near = box.center + signs.real * box.along + 1j * signs.imag * box.across
            values.append(near.reshape([len(signs) if i == k else 1 for i in range(7)] + [COUNT]))
        plant, turned, wall, round_, force, shape, rise = values
        moved = shape / force + round_ / wall - turned / plant - (steps + 2)
        found.append(-(rise / force * moved.conj()).real.reshape(-1, COUNT))
    return found


@pytest.mark.parametrize("error", [1e-3, 0.01, 0.03, 0.1])
def test_a_direction_holds_in_every_corner_and_is_said_where_all_are_clear(error, monkeypatch):
    rng, boxes, made = np.random.default_rng(7), [], directions._box
    monkeypatch.setattr(directions, "_box", lambda *a: boxes.append(made(*a)) or boxes[-1])
    said = clear = 0
    for _ in range(5):
        boxes.clear()
        bands, steps = random_bands(rng, error), np.floor(10 ** rng.uniform(0, 2, COUNT))
        way, until = directions.one_way(bands, steps)
        assert (until[way != 0] >= steps[way != 0]).all()
        for at in (steps, np.minimum(until, 1e6)):
            middle, corners = at_corners(boxes, at)
            assert (corners * way >= -1e-12 * np.abs(middle)).all()
        middle, corners = at_corners(boxes, steps)
        off = np.abs(corners - middle).max(axis=0)
        assert way[off < np.abs(middle[0]) / 8].all()
        said += np.count_nonzero(way)
        clear += np.count_nonzero(off < np.abs(middle[0]) / 8)
    assert said >= clear > 0
    assert said < 5 * COUNT or error < 0.01


def test_a_direction_holds_as_long_as_it_is_said_and_hardly_ever_a_period_longer():
    longer = []
    for seed in range(60):
        bands = random_bands(np.random.default_rng(seed), 0.03)
        way, until = directions.one_way(bands, np.full(COUNT, 20.0))
        some = (way != 0) & np.isfinite(until)
        last, more = (directions.one_way(bands, until + step)[0][some] for step in (0, 1))
        assert last.tolist() == way[some].tolist()
        longer += list(more != 0)
    assert len(longer) > 20
    assert np.mean(longer) < 0.3


def test_the_boxes_are_around_the_numbers_that_the_roots_move_with(monkeypatch):
    """M/z and W at z = exp(j theta), by their coefficients, and their slopes by ln z."""
    rng, boxes, made = np.random.default_rng(8), [], directions._box
    monkeypatch.setattr(directions, "_box", lambda *a: boxes.append(made(*a)) or boxes[-1])
    gamma, delta, alpha, beta = rng.uniform(0.1, 9, (4, COUNT))
    middle, theta, none = rng.uniform(0, 1, COUNT), rng.uniform(0.1, 3, COUNT), np.zeros(COUNT)
    part = part_of(device(gamma, delta), gamma, delta, middle, none)
    y, z = 2 - 2 * np.cos(theta), np.exp(1j * theta)
    bands = Bands(
        np.arange(COUNT), part, wall(alpha, beta), y, y, y, y, y, 4 - y, *[none] * 3, y, z.imag
    )
    directions.one_way(bands, none)
    _, turned, pushed, round_, force, shape, rise = (box.center for box in boxes)
    m2, m1, m0, e = part.x.m2, part.x.m1, part.x.m0, part.x.e
    by_m2, by_m0 = slopes(gamma, delta, middle)
    for found, true in (
        (turned, z - e / z),
        (pushed, (alpha + beta) * z - beta),
        (round_, (alpha + beta) * z),
        (force, m2 * z + m1 + m0 / z),
        (shape, m2 * z - m0 / z),
        (rise, by_m2 * (z - 1) + by_m0 * (1 / z - 1)),
    ):
        assert np.allclose(found, true, rtol=0, atol=1e-12)
