"""Every chapter has an oracle, and every oracle a chapter."""

import numpy as np
import pytest
from oracles.guarding import guarded
from oracles.subject import altered, number, only
from sympy import cos, sin

from symhaptic.book.chapters import shipped
from symhaptic.notation import a, theta


def test_every_chapter_has_an_oracle():
    oracles = guarded()
    missing = [path.stem for path in shipped() if path.stem not in oracles]
    assert not missing, f'no oracle in tests/oracles says @guards("{missing[0]}"); all: {missing}'


def test_no_oracle_guards_a_chapter_that_is_not_there():
    chapters = {path.stem for path in shipped()}
    strangers = {name: tests for name, tests in guarded().items() if name not in chapters}
    assert not strangers


def test_oracles_are_found_by_their_mark(tmp_path):
    text = "@guards('s1_a', 's1_b')\ndef test_one(): ...\n\ndef test_two(): ...\n"
    (tmp_path / "test_section_1.py").write_text(text)
    one = ["test_section_1.py::test_one"]
    assert guarded(tmp_path) == {"s1_a": one, "s1_b": one}


def test_an_oracle_that_accepts_a_wrong_formula_is_refused():
    formula = a * cos(theta)

    def agrees(expr):
        assert number(expr, a=2, theta=1.1) == pytest.approx(2 * np.cos(1.1))

    only(agrees, formula)
    with pytest.raises(AssertionError, match="accepts"):
        only(lambda _: None, formula)
    with pytest.raises(AssertionError):
        only(agrees, 1.01 * formula)
    assert list(altered(a * theta, 0.5)) == [1.5 * a * theta] * 3
    changed = altered(theta - sin(a), 1, kept=("theta",))
    wrong = {2.0 * theta - 2.0 * sin(a), theta - sin(2.0 * a), theta + sin(a), theta - cos(a)}
    assert set(changed) == wrong
