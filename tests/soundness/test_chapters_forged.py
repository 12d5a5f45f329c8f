"""Chapters cannot hide a verdict, reach each other, or forge a theorem for the ledger."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from typer.testing import CliRunner

from symhaptic.cli import app
from symhaptic.commands.shared import Unusable
from symhaptic.library import BadChapter, looked_at, run
from symhaptic.parallel import settled

JSON = ("--format", "json")
HEAD = '"""A title\n\nAn introduction.\n"""\n'


def chapter(folder: Path, name: str, body: str) -> Path:
    path = folder / f"{name}.py"
    path.write_text(HEAD + body, encoding="utf-8")
    return path


RIGHT = """
from sympy import sin, cos, symbols
def derive(page):
    x = symbols("x")
    page.state("{id}", "a formula", r"\\sin 2x = 2 \\sin x \\cos x")
    page.settle("{id}", __import__("sympy").Eq(sin(2*x), 2*sin(x)*cos(x)))
"""

WRONG = RIGHT.replace("= 2 ", "= 3 ")


def test_the_same_id_twice_in_one_chapter_is_an_error(tmp_path: Path) -> None:
    body = RIGHT.format(id="mine")
    path = chapter(tmp_path, "twice", body + body.split("def derive(page):")[1])
    with pytest.raises(BadChapter, match=r"twice\.py:\d+: mine is stated twice"):
        run(path)


def test_the_same_id_in_two_chapters_is_told(tmp_path: Path) -> None:
    one = chapter(tmp_path, "one", WRONG.format(id="mine"))
    two = chapter(tmp_path, "two", RIGHT.format(id="mine"))
    told = CliRunner().invoke(
        app, ["verify", "mine", "--derivation", str(one), "--derivation", str(two)]
    )
    assert told.exit_code == 1
    assert "settled twice, in one.py and two.py" in told.output


def test_a_wrong_verdict_on_the_papers_statement_is_not_covered(tmp_path: Path) -> None:
    body = """
from sympy import Eq, symbols
def derive(page):
    K, B, T, z = symbols("K B T z")
    page.settle("eq15", *[Eq(s, 2*s) for s in symbols("c_1 c_2 c_3")])
"""
    path = chapter(tmp_path, "again", body)
    told = CliRunner().invoke(app, ["verify", "eq15", "--derivation", str(path)])
    assert told.exit_code == 1


def test_an_error_names_its_line_and_leaves_a_file(tmp_path: Path) -> None:
    path = chapter(tmp_path, "bad", "def derive(page):\n    raise KeyError('boo')\n")
    out = tmp_path / "out.xml"
    told = CliRunner().invoke(
        app,
        ["verify", "eq5", "--derivation", str(path), "--format", "junit", "-o", str(out)],
    )
    assert isinstance(told.exception, Unusable)
    suite = ET.parse(out).getroot()
    assert suite.get("errors") == "1"
    assert [case.get("name") for case in suite if case.find("error") is not None] == [f"{path}:6"]
    assert "eq5" in {case.get("name") for case in suite}


def test_given_files_are_looked_at_before_anything_is_run(tmp_path: Path) -> None:
    for name, body, wrong in (
        ("syntax", "def derive(page:\n", r"syntax\.py:5"),
        ("without", "x = 1\n", "no function derive"),
    ):
        with pytest.raises(BadChapter, match=wrong):
            looked_at(chapter(tmp_path, name, body))


def test_one_chapter_does_not_patch_the_package_for_the_next(tmp_path: Path) -> None:
    patch = """
import symhaptic.proof.decide as decide
import symhaptic.record as record
from symhaptic.proof.decide import Comparison
yes = lambda left, right: Comparison(True, "patched")
decide.compare = record.compare = yes
"""
    first = chapter(tmp_path, "first", patch + RIGHT.format(id="first"))
    second = chapter(
        tmp_path,
        "second",
        "from sympy import symbols\ndef derive(page):\n    x = symbols('x')\n"
        "    page.step('false', x, 2*x)\n",
    )
    outcomes = settled([first, second], 1)
    assert outcomes[0].error is None
    assert "is false" in (outcomes[1].error or "")


def test_a_process_that_dies_is_told_of(tmp_path: Path) -> None:
    path = chapter(tmp_path, "gone", "import os\ndef derive(page):\n    os._exit(3)\n")
    [outcome] = settled([path], 2)
    assert "ended with status 3" in (outcome.error or "")


FORGED = """
import symhaptic.proof.theorems.kernel as kernel
from symhaptic.notation.proposition import TRUE
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper import STATEMENTS
def derive(page):
    claim = CLAIMED["s5a-proportional"](())
    forged = object.__new__(kernel.Theorem)
    object.__setattr__(forged, "hypotheses", frozenset())
    object.__setattr__(forged, "conclusion", claim)
    object.__setattr__(forged, "_rule", "assume")
    object.__setattr__(forged, "_given", ((claim,), ()))
    from symhaptic.proof.theorems.judge import Judged
    Judged._check_example = lambda self, conclusion: None
    page.settle("s5a-proportional", forged)
"""


def test_a_forged_theorem_is_found_where_it_arrives(tmp_path: Path) -> None:
    """The chapter patches its judge and builds a theorem; the ledger derives and judges again."""
    path = chapter(tmp_path, "forged", FORGED)
    out = tmp_path / "out.json"
    told = CliRunner().invoke(
        app,
        ["verify", "s5a-proportional", "--derivation", str(path), "-o", str(out), *JSON],
    )
    assert told.exit_code == 1
    assert json.loads(out.read_text())["statements"]
