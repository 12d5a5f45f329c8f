"""Notebooks: valid, small, and when run they give what they say."""

import json
import os
import sys
from pathlib import Path

import nbformat
import pytest

from symhaptic.book.report.notebooks import GUIDES, notebook, notebooks


@pytest.fixture(scope="module")
def made():
    return notebooks()


def test_each_is_valid_small_and_of_no_machine(made):
    assert list(made) == list(GUIDES)
    for text in made.values():
        nbformat.validate(nbformat.reads(text, as_version=4))
        assert len(text) < 40_000
        assert str(Path.home()) not in text
        assert str(Path.cwd()) not in text
        assert "doctest:" not in text
        assert ".md)" not in text


def test_they_are_the_same_from_run_to_run(made):
    assert notebooks() == made


def test_a_block_that_is_only_read_stays_text():
    text = "# A\n\n```yaml\njobs:\n```\n\n    symhaptic limits device.toml\n"
    assert [cell.cell_type for cell in notebook(text).cells] == ["markdown"]
    cells = notebook(text, shell=True).cells
    assert [cell.source for cell in cells][1:] == ["!symhaptic limits device.toml"]


def test_what_is_printed_and_what_is_given_back():
    loop = ">>> for i in range(2):\n...     print(i)\n0\n1\n"
    text = f"```python\n{loop}>>> x = 3\n>>> x, 1\n(3, 1)\n\n```\n"
    printed, given = (cell.outputs[0] for cell in notebook(text).cells)
    assert (printed.output_type, printed.text) == ("stream", "0\n1\n")
    assert (given.output_type, given.data["text/plain"]) == ("execute_result", "(3, 1)")


def test_a_guide_whose_numbers_are_wrong_is_found(tmp_path):
    """The comparison below can fail."""
    wrong = notebook("```python\n>>> 1 + 1\n3\n\n```\n")
    assert told(run(wrong, tmp_path)) != told(wrong)


def run(one, folder):
    """A notebook after all its cells were run, in a folder of its own."""
    from nbclient import NotebookClient

    copy = nbformat.from_dict(json.loads(json.dumps(one)))
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    client = NotebookClient(copy, timeout=1200, resources={"metadata": {"path": str(folder)}})
    client.execute(env=os.environ | {"PATH": path})
    return copy


def told(one):
    """What the cells of Python give, as text; pictures and what commands write aside."""
    found = []
    for cell in one.cells:
        if cell.cell_type == "code" and cell.source[:1] not in "!%":
            found.append("")
            for output in cell.outputs:
                given = output.get("data", {}).get("text/plain", "")
                found[-1] += output.get("text", given) + output.get("evalue", "")
    return [" ".join(text.split()) for text in found]


@pytest.mark.slow
@pytest.mark.parametrize("name", GUIDES)
def test_a_notebook_gives_what_it_says(name, made, tmp_path):
    one = nbformat.reads(made[name], as_version=4)
    done = run(one, tmp_path)
    assert told(done) == told(one)
    if name == "tutorial":
        last = [cell for cell in done.cells if "./controller" in cell.source][-1]
        assert "".join(output.text for output in last.outputs).split() == ["-0.8", "N", "0", "N"]
