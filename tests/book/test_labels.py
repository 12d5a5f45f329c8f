"""Names beside points: none over another, over a point, or beyond the axes."""

import itertools

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from symhaptic.book.figures.labels import place


def test_names_of_a_crowd_do_not_collide():
    figure, axes = plt.subplots(figsize=(3, 3))
    axes.set(xscale="log", yscale="log", xlim=(1e-8, 1e-1), ylim=(1e-20, 1e3))
    rng = np.random.default_rng(3)
    points = 10.0 ** np.column_stack([rng.uniform(-6, -3, 10), rng.uniform(-15, -2, 10)])
    place((axes, [(x, y, f"name {i}", "black") for i, (x, y) in enumerate(points)], ()))
    renderer = figure.canvas.get_renderer()
    boxes = [text.get_window_extent(renderer) for text in axes.texts]
    assert len(boxes) == 10
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
    frame = axes.get_window_extent(renderer)
    assert all(frame.x0 <= b.x0 and b.x1 <= frame.x1 + 2 for b in boxes)
    places = axes.transData.transform(points)
    assert not any(box.count_contains(places) for box in boxes)
    plt.close(figure)
