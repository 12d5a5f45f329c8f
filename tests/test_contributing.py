"""The recipes run as they stand: a chapter, by README's CI too, and a language; wrong ones fail."""

import importlib.util
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from symhaptic.book.chapters import BadChapter, run
from symhaptic.cli.main import app
from symhaptic.export import targets
from symhaptic.notation.latex import latex

TEXT = (Path(__file__).parents[1] / "CONTRIBUTING.md").read_text(encoding="utf-8")
VERIFY = (Path(__file__).parents[1] / "docs" / "verify.md").read_text(encoding="utf-8")
LANGUAGE = (Path(__file__).parents[1] / "docs" / "language.md").read_text(encoding="utf-8")
EXAMPLE, THEOREM = (block.split("```")[0] for block in TEXT.split("```python\n")[1:3])


def test_the_example_proves_its_statement(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE, encoding="utf-8")
    assert run(path).page.settled["my-drift"].verdict.kind == "proved"


def test_the_theorem_is_qualified_by_its_hypothesis(tmp_path):
    path = tmp_path / "spring.py"
    path.write_text(THEOREM, encoding="utf-8")
    verdict = run(path).page.settled["stretched"].verdict
    assert (verdict.kind, verdict.condition) == ("qualified", "k>0")
    for wrong in ("{k: 1, x: 0, y: 1}", "{k: 0, x: 0, y: 1}"):
        path.write_text(THEOREM.replace(wrong, "{k: 1, x: 1, y: 0}"), encoding="utf-8")
        with pytest.raises(BadChapter):
            run(path)


def test_its_steps_show_something(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE, encoding="utf-8")
    sides = [line for block in run(path).page.blocks for line in block.lines]
    shown = [[s if isinstance(s, str) else latex(s) for s in (a, b)] for a, _, b in sides]
    assert len(shown) == 4
    assert all(left != right for left, right in shown)


def test_a_wrong_step_in_it_is_named(tmp_path):
    path = tmp_path / "drift.py"
    path.write_text(EXAMPLE.replace("-force, name", "-2 * force, name"), encoding="utf-8")
    with pytest.raises(BadChapter, match="It obeys Newton's law") as wrong:
        run(path)
    lines = path.read_text(encoding="utf-8").splitlines()
    assert "page.step(" in lines[wrong.value.line - 1]
    assert str(wrong.value).startswith(f"{path}:{wrong.value.line}: ")


@pytest.mark.slow
@pytest.mark.parametrize("part", VERIFY.split("```yaml\n")[1:], ids=["GitHub", "GitLab"])
def test_the_ci_of_somebody_else_checks_their_chapter(part, tmp_path):
    """In a repository that is not this one: an install from ours, their chapter, their tests."""
    steps = [line.strip(" -").removeprefix("run: ") for line in part.split("```")[0].splitlines()]
    (installed,) = (s for s in steps if s.startswith("pip install"))
    assert shlex.split(installed)[2].startswith("git+$")
    assert "pytest" in steps
    (verified,) = (s for s in steps if s.startswith("symhaptic verify"))
    command = [sys.executable, "-m", *shlex.split(verified)]
    for text, status in ((EXAMPLE, 0), (EXAMPLE.replace("{mv}{b}", "{2mv}{b}"), 1)):
        (tmp_path / "drift.py").write_text(text, encoding="utf-8")
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert run.returncode == status, run.stderr
        assert "my-drift" in (tmp_path / "formulas.xml").read_text(encoding="utf-8")


def test_a_part_of_the_scene_begins_as_a_chapter(tmp_path):
    path = tmp_path / "filtered.py"
    part = TEXT.split("## A part of the scene")[1].split("```python\n")[1].split("```")[0]
    path.write_text(part, encoding="utf-8")
    shown = [block for block in run(path).page.blocks if block.verdict == "proved"]
    assert [block.title for block in shown] == [
        "The filter raises the degree by one",
        "Without the filter",
    ]
    path.write_text(part.replace("(z - 1)),", "z),"), encoding="utf-8")
    with pytest.raises(BadChapter, match="raises the degree"):
        run(path)
    path.write_text(part.replace(".subs(f, 0)", ".subs(f, 1)"), encoding="utf-8")
    with pytest.raises(BadChapter, match="Without the filter"):
        run(path)


@pytest.mark.parametrize("sine", ["sin", "cos"])
def test_a_language_is_one_file_and_one_line(sine, tmp_path, monkeypatch):
    if shutil.which("perl") is None:
        pytest.skip("no perl here: the language of the recipe is not run")
    path, out = tmp_path / "perl.py", tmp_path / "out"
    text = LANGUAGE.split("```python\n")[1].split("```")[0]
    wrong = text.replace('TwoProdError="', f'sin="{sine}({{0}})",\n        TwoProdError="', 1)
    assert wrong != text
    path.write_text(wrong, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("perl", path)
    perl = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(perl)
    monkeypatch.setitem(targets.TARGETS, "perl", perl.TARGET)
    names = ["is_stable", "max_passive_stiffness", "stability_boundary"]
    made = CliRunner().invoke(app, ["export", *names, "--target", "perl", "-o", str(out)])
    assert made.exit_code == 0, made.output
    for command in perl.TARGET.commands("haptic"):
        ran = subprocess.run(command, cwd=out, capture_output=True, text=True, check=False)
    assert (ran.returncode == 0) == (sine == "sin"), ran.stdout + ran.stderr
    assert ("values, 0 missed" in ran.stdout) == (sine == "sin")
