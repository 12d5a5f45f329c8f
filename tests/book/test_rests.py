"""The graph of what rests on what: edges that others say are left out, nothing points backwards."""

import pytest
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.book.figures import style
from symhaptic.book.figures.rests import columns, direct
from symhaptic.book.figures.style import save
from symhaptic.book.report.printed import _graph

CHAIN = {2: frozenset({1}), 3: frozenset({1, 2}), 5: frozenset({3, 4, 1})}


def test_an_edge_is_left_out_that_a_longer_way_says():
    assert direct(CHAIN) == {
        1: frozenset(),
        2: frozenset({1}),
        3: frozenset({2}),
        4: frozenset(),
        5: frozenset({3, 4}),
    }


def test_each_chapter_stands_right_of_all_that_it_applies():
    at = {n: x for x, column in enumerate(columns(direct(CHAIN))) for n in column}
    assert all(at[lower] < at[upper] for upper, under in CHAIN.items() for lower in under)


def test_neighbours_stand_side_by_side():
    # two chains whose upper ends are numbered the other way round
    crossed = {4: frozenset({1}), 3: frozenset({2}), 1: frozenset(), 2: frozenset()}
    low, high = columns(crossed)
    assert [min(crossed[n]) for n in high] == low


@pytest.mark.ci
def test_no_box_of_the_book_covers_another(tmp_path):
    chapters = [chapter(path.stem) for path in shipped()]
    boxes = []

    def drawn(draw, target, height):
        def measured(axes):
            draw(axes)
            axes.figure.draw_without_rendering()
            boxes.extend(t.get_bbox_patch().get_window_extent() for t in axes.texts if t.get_text())

        save(measured, target, height=height)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(style, "save", drawn)
        _graph(chapters, tmp_path, lambda _: None)
    assert len(boxes) > 60
    assert not any(one.overlaps(other) for i, one in enumerate(boxes) for other in boxes[:i])


@pytest.mark.parametrize("name", ["half_circle", "crossing", "sides", "lines_of_angles"])
def test_pictures_of_arguments_are_drawn(name, tmp_path):
    from symhaptic.book.figures import arguments

    panels = (1, 2) if name in ("half_circle", "crossing") else (1, 1)
    save(getattr(arguments, name), tmp_path / f"{name}.svg", panels)
    assert "<svg" in (tmp_path / f"{name}.svg").read_text()


def test_the_crossing_is_where_the_boundary_is():
    """Roots by NumPy's companion matrix agree with the package, and with the drawn boundary."""
    import numpy as np

    from symhaptic.book.figures.arguments import DELAY, DELTA, GAMMA, _roots
    from symhaptic.numeric.stability import is_stable

    for alpha in (0.06, 0.18, 0.3, 0.42, 0.54):
        inside = bool(np.all(np.abs(_roots(alpha, 0.4)) < 1))
        assert inside == bool(is_stable(alpha, 0.4, GAMMA, DELTA, DELAY)) == (alpha < 0.4)


def test_chapters_that_apply_theorems_of_each_other_stand_in_the_order_of_the_book():
    found = direct({1: frozenset({2}), 2: frozenset({1, 3}), 4: frozenset({2, 3})})
    assert found == {1: frozenset(), 2: frozenset({1, 3}), 3: frozenset(), 4: frozenset({2})}
    assert columns(found) == [[1, 3], [2], [4]]
