"""The chapter that CONTRIBUTING shows runs as it stands, and a wrong step in it is found."""

from pathlib import Path

import pytest

from symhaptic.latex import latex
from symhaptic.library import BadChapter, run

TEXT = (Path(__file__).parents[1] / "CONTRIBUTING.md").read_text(encoding="utf-8")
EXAMPLE = TEXT.split("```python\n")[1].split("```")[0]


def test_the_example_proves_its_statement(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE, encoding="utf-8")
    assert run(path).page.settled["my-drift"].verdict.kind == "proved"


def test_its_steps_show_something(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE, encoding="utf-8")
    sides = [line for block in run(path).page.blocks for line in block.lines]
    shown = [[s if isinstance(s, str) else latex(s) for s in (a, b)] for a, _, b in sides]
    assert len(shown) == 4
    assert all(left != right for left, right in shown)


def test_a_wrong_step_in_it_is_named(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE.replace("-b * speed", "-2 * b * speed"), encoding="utf-8")
    with pytest.raises(BadChapter, match="It obeys Newton's law"):
        run(path)
