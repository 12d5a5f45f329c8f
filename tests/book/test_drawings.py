"""Figures drawn beside the work are those that are drawn at once, byte for byte."""

import multiprocessing

import pytest
from chapters import chapter

from symhaptic.book.figures.drawings import Drawings, figures, take
from symhaptic.book.record import Block


@pytest.mark.parametrize("ending", [pytest.param(".pdf", marks=pytest.mark.ci), ".svg"])
def test_what_is_drawn_beside_is_what_is_drawn_at_once(tmp_path, ending):
    one = chapter("s3b_envelope")
    (block,) = figures([one])
    with Drawings() as drawings:
        drawings.begin(one)
        drawings.take(block, tmp_path / f"beside{ending}")
    take(block, tmp_path / f"here{ending}")
    beside, here = (tmp_path / f"{name}{ending}" for name in ("beside", "here"))
    assert beside.read_bytes() == here.read_bytes()


def test_what_another_process_does_not_find_is_drawn_here(tmp_path):
    drawn = []

    def draw(axes):
        drawn.append(axes)

    with Drawings() as drawings:
        drawings.take(Block("figure", "mine", draw=draw), tmp_path / "mine.svg")
    assert len(drawn) == 1
    assert (tmp_path / "mine.svg").is_file()


def test_what_cannot_be_drawn_is_told_where_it_is_taken(tmp_path):
    class Wrong:
        page = type("Page", (), {"blocks": [Block("figure", "x", draw=take)]})

    with Drawings() as drawings:
        drawings.begin(Wrong)
        with pytest.raises(TypeError):
            drawings.take(Wrong.page.blocks[0], tmp_path / "x.svg")


def test_what_a_killed_process_has_not_drawn_is_drawn_here(tmp_path):
    one = chapter("s3b_envelope")
    (block,) = figures([one])
    with Drawings() as drawings:
        drawings.begin(one)
        (process,) = multiprocessing.active_children()
        process.kill()
        process.join()
        drawings.take(block, tmp_path / "killed.svg")
        drawings.begin(one)
    assert (tmp_path / "killed.svg").is_file()
