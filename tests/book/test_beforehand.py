"""What several chapters want of the package is there before they are run, and nothing of theirs."""

import sys

import pytest

from symhaptic.book.beforehand import Beforehand, prepare
from symhaptic.book.lemmas import softer

HEAD = 'r"""A title.\n\nWords.\n"""\n'
TAKES = "from symhaptic.book.lemmas.softer import within_the_damper\n"


@pytest.fixture
def chapters(tmp_path):
    """Two that take a lemma, and what cannot be read."""
    for name in ("first", "second"):
        (tmp_path / f"{name}.py").write_text(HEAD + TAKES + "raise SystemExit('it was run')\n")
    (tmp_path / "broken.py").write_text("def derive(page:\n")
    return [tmp_path / f"{name}.py" for name in ("first", "second", "broken", "missing")]


@pytest.fixture(autouse=True)
def nothing_derived():
    softer.within_the_damper.cache_clear()


def test_a_lemma_of_two_chapters_is_derived_and_none_of_them_is_run(chapters):
    prepare(chapters)
    assert softer.within_the_damper.cache_info().currsize == 1
    assert not {"first", "derivation_first"} & set(sys.modules)


def test_a_lemma_of_one_chapter_is_its_own_affair(chapters):
    prepare(chapters[1:])
    assert softer.within_the_damper.cache_info().currsize == 0


def test_a_chapter_waits_for_the_lemmas_that_it_shares_and_for_no_others(chapters):
    beforehand = Beforehand(chapters)
    assert [beforehand.ready(i) for i in range(4)] == [False, False, True, True]
    while beforehand.derive():
        pass
    assert all(map(beforehand.ready, range(4)))
