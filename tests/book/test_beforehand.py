"""What chapters want of the package is there before they are run, and nothing of theirs."""

import sys

import pytest

from symhaptic.book import lemmas
from symhaptic.book.beforehand import Beforehand
from symhaptic.book.lemmas import softer

HEAD = 'r"""A title.\n\nWords.\n"""\n'
TAKES = "from symhaptic.book.lemmas.softer import within_the_damper\n"
BY_MODULE = "from symhaptic.book.lemmas import softer\n\nused = softer.within_the_damper\n"
RUNS = "raise SystemExit('it was run')\n"


@pytest.fixture
def chapters(tmp_path):
    """Two that take a lemma, one of them by its module, and what cannot be read."""
    (tmp_path / "first.py").write_text(HEAD + TAKES + RUNS)
    (tmp_path / "second.py").write_text(HEAD + BY_MODULE + RUNS)
    (tmp_path / "broken.py").write_text("def derive(page:\n")
    return [tmp_path / f"{name}.py" for name in ("first", "second", "broken", "missing")]


@pytest.fixture(autouse=True)
def nothing_derived():
    softer.within_the_damper.cache_clear()


@pytest.mark.parametrize("number", [0, 1])
def test_the_lemma_of_a_chapter_is_derived_and_the_chapter_is_not_run(number, chapters):
    Beforehand(chapters).derive(number)
    assert softer.within_the_damper.cache_info().currsize == 1
    assert not {"first", "derivation_first"} & set(sys.modules)


def test_what_cannot_be_read_wants_nothing(chapters):
    Beforehand(chapters).derive(2)
    Beforehand(chapters).derive(3)
    assert softer.within_the_damper.cache_info().currsize == 0


def test_the_lemmas_below_a_lemma_are_found_by_the_names_in_it():
    from symhaptic.book.chapters import shipped

    paths = shipped()
    found = {f"{x.__module__}.{x.__name__}" for one in Beforehand(paths).lemmas for x in one}
    # `passive_is_stable` of s5a_passive_is_stable.py names `region.at_every_angle`
    assert f"{lemmas.__name__}.region.at_every_angle" in found
    assert len(found) > 150


def test_a_chapter_comes_first_of_which_no_lemma_was_derived_elsewhere(chapters):
    beforehand = Beforehand(chapters)
    (lemma,) = {lemma for lemma in beforehand.lemmas[0] if lemma is softer.within_the_damper}
    assert beforehand.next([0, 1, 2], set(), set()) == 0
    assert beforehand.next([0, 1, 2], set(), {lemma}) == 2
    assert beforehand.next([0, 1, 2], {lemma}, {lemma}) == 0
