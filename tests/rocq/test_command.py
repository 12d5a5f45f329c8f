"""``symhaptic verify --rocq``: what is written, and what is said without a compiler and with."""

import json
import os
import shutil
import subprocess
import sys

import pytest
from command import symhaptic

from symhaptic.book import foreign, parallel
from symhaptic.cli.rocq import judged, told_of
from symhaptic.rocq import compiled, together
from symhaptic.rocq.outcome import Outcome, longest_first


def test_without_a_compiler_the_files_are_written_and_it_says_what_to_install(tmp_path):
    run = subprocess.run(
        [sys.executable, "-m", "symhaptic", "verify", "--rocq", tmp_path, "eq2"],
        env={**os.environ, "PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0
    assert "apt install coq libcoq-interval" in run.stderr
    assert (tmp_path / "Prelude.v").is_file()
    found = json.loads((tmp_path / "rocq.json").read_text())["statements"]
    assert found["eq2"]["checked"] != "whole"


def test_a_folder_that_cannot_be_is_refused(tmp_path):
    (tmp_path / "file").write_text("")
    run = symhaptic("verify", "--rocq", tmp_path / "file" / "deeper", "eq2")
    assert run.returncode == 2
    assert run.stderr.startswith("symhaptic: error: --rocq")


def test_the_record_is_asked_for_as_json_and_never_as_junit(tmp_path):
    file = tmp_path / "rocq.json"
    without = {**os.environ, "PATH": str(tmp_path)}
    command = [sys.executable, "-m", "symhaptic", "verify", "--rocq", tmp_path / "rocq", "eq2"]
    run = subprocess.run(
        [*command, "--format", "json", "-o", file],
        env=without, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (run.returncode, run.stdout) == (0, "")
    assert file.read_bytes() == (tmp_path / "rocq" / "rocq.json").read_bytes()
    written = json.loads(file.read_text())
    assert written["statements"]["eq2"] == {
        "checked": "not", "why": "not printed: it is settled without a theorem", "rests": [],
        "says": None,
    }  # fmt: skip
    assert "do not edit" in written["generated"]
    refused = symhaptic("verify", "--rocq", tmp_path, "eq2", "--format", "junit")
    assert refused.returncode == 2
    assert "--format junit" in refused.stderr


def test_each_statement_has_a_line_and_each_kind_its_count():
    said = {
        "one": "whole", "two": "whole", "three": "2 steps open: the rule gains",
        "four": "1 step open: the rule gains", "five": "not printed: it is settled by hand",
    }  # fmt: skip
    told = told_of([Outcome("mine", statements=said)], []).splitlines()
    assert told[:3] == ["one: whole", "two: whole", "three: 2 steps open: the rule gains"]
    assert told[4] == "five: not printed: it is settled by hand"
    assert told[5] == "1 not printed, 2 whole, 2 with steps open"
    assert told_of([Outcome("mine", statements=said)], ["two"]).startswith("two: whole\n1 whole\n")


@pytest.mark.parametrize(("given", "used"), [(None, 2), (1, 1), (5, 5)])
def test_chapters_are_compiled_by_so_many_workers(given, used, tmp_path, monkeypatch, capsys):
    """Two where none are given, for each step; and the result ends with one end of line."""
    workers = []

    def each(work, paths, count, told):
        workers.append(count)
        return iter(())

    def asked(taken, folder, known, count, told):
        workers.append(count)
        return {}

    monkeypatch.setattr(parallel, "each", each)
    monkeypatch.setattr(together, "asked", asked)
    monkeypatch.setattr(compiled, "prelude_compiled", lambda folder: None)
    monkeypatch.setattr(compiled, "version", lambda: "9.0")
    assert judged([], [], tmp_path, given, None, False, ()) == 0
    assert workers == [used, used]
    assert capsys.readouterr().out == told_of([], [])
    judged([], [], tmp_path, given, None, True, ())
    assert capsys.readouterr().out == (tmp_path / "rocq.json").read_text(encoding="utf-8")


@pytest.mark.parametrize("others", [[], ["--source", "FOLDER", "--rocq", "DIR"]])
def test_as_recorded_is_for_the_paper_and_a_folder(tmp_path, others):
    (tmp_path / "DIR").mkdir()
    run = symhaptic("verify", "--as-recorded", *others, cwd=tmp_path)
    assert run.returncode == 2
    said = "--as-recorded: is for the paper's statements and --rocq DIR; give that alone"
    assert run.stderr == f"symhaptic: error: {said}\n"


def test_what_took_long_is_begun_first(tmp_path):
    """And what was never compiled before that; else the order is that of the book."""
    paths = [tmp_path / f"{name}.py" for name in ("short", "new", "long", "newer")]
    for name, seconds in (("short", 1.5), ("long", 20.0)):
        kept = {"text": "", "outcome": {"seconds": seconds}}
        (tmp_path / f"{name}.json").write_text(json.dumps(kept))
    (tmp_path / "new.json").write_text("[]")  # not of a chapter, as rocq.json is not
    (tmp_path / "newer.json").write_text("{")  # cut off
    found = longest_first(paths, tmp_path)
    assert [path.stem for path in found] == ["new", "newer", "long", "short"]


CHAPTER = '''r"""Is a spring that is stretched further pulled harder?"""

from sympy import symbols

from symhaptic.notation import k, x
from symhaptic.notation.proposition import ForAll, implied
from symhaptic.proof.theorems.tactics import example, for_all, positive

y = symbols("y")


def derive(page):
    claim = ForAll((k, x, y), implied([x < y, k > 0], k * x < k * y))
    page.state("stretched", "a spring that is stretched further pulls harder", claim=claim)
    harder = page.lemma("It pulls harder", positive(k * x < k * y, [k > 0, x < y]))
    page.settle(
        "stretched",
        for_all((k, x, y), [x < y, k > 0], harder),
        example=example({k: 1, x: 0, y: 1}, [x < y, k > 0]),
    )
'''


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL)
def test_a_chapter_of_ones_own_is_checked_whole_and_known_the_next_time(tmp_path):
    chapter, folder = tmp_path / "mine.py", tmp_path / "rocq"
    chapter.write_text(CHAPTER)
    wanted = ("verify", "--rocq", folder, "stretched", "--derivation", chapter)
    for _ in range(2):
        run = symhaptic(*wanted)
        assert run.returncode == 0, run.stderr
        assert "stretched: whole" in run.stdout
    assert "the slowest chapter" not in run.stdout
    rests = json.loads((folder / "rocq.json").read_text())["statements"]["stretched"]["rests"]
    assert set(rests) <= set(foreign.LIBRARY)
