"""Chapters leave nothing behind, nothing is settled twice, and what fails says where."""

import copyreg
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from xml.etree import ElementTree

import pytest
from command import symhaptic

from symhaptic.book.arrivals import arrived, sent
from symhaptic.book.chapters import BadChapter

HEAD = '''r"""A title.

Words.
"""
from sympy import Eq, cos, sin
from symhaptic.notation import theta, x


def derive(page):
    page.step("A step", sin(theta) ** 2, 1 - cos(theta) ** 2)
'''
STATED = '    page.state("{id}", "doubling", r"x = 2\\sin(\\theta)\\cos(\\theta)")\n'
RIGHT = '    page.settle("{id}", Eq(x, sin(2 * theta)))\n'
WRONG = '    page.settle("{id}", Eq(x, sin(3 * theta)))\n'


def verify(*arguments):
    return symhaptic("verify", *arguments)


def chapter(folder, name, *lines, id="my-own"):
    path = folder / f"{name}.py"
    path.write_text(HEAD + "".join(lines).replace("{id}", id), encoding="utf-8")
    return path


# It makes every comparison come out as equal, and every settlement a proof.
PATCH = """
    import symhaptic.proof.settle as settle
    import symhaptic.book.page as package
    from symhaptic.proof.verdict import Kind, Verdict
    settle.Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "because I say so")
"""


@pytest.mark.parametrize("workers", [1, 2])
def test_a_chapter_cannot_patch_the_package_for_the_next(workers, tmp_path):
    first = chapter(tmp_path, "first", PATCH)
    second = chapter(tmp_path, "second", STATED, WRONG)
    run = verify("my-own", "--derivation", first, "--derivation", second, "--workers", workers)
    assert run.returncode == 1, run.stdout
    assert "misprint" in run.stdout


def test_a_process_that_ran_a_chapter_is_not_the_parent_of_one(tmp_path):
    """What ran here may have patched the package; so the next begins from nothing."""
    first = chapter(tmp_path, "first", PATCH)
    second = chapter(tmp_path, "second", STATED, WRONG)
    program = f"""
from pathlib import Path
from symhaptic.book.chapters import run
from symhaptic.book.parallel import settled
if __name__ == "__main__":
    run(Path({str(first)!r}))
    (entry,) = settled([Path({str(second)!r})], 1)
    print(entry.verdict.kind)
"""
    script = tmp_path / "program.py"
    script.write_text(program)
    run = subprocess.run(
        [sys.executable, script], capture_output=True, text=True, check=False, timeout=300
    )
    assert run.stdout == "argued\n", run.stderr


@pytest.mark.parametrize("order", [(WRONG, RIGHT), (RIGHT, RIGHT)])
def test_an_id_is_settled_once_in_a_chapter(order, tmp_path):
    path = chapter(tmp_path, "my", STATED, *order)
    run = verify("my-own", "--derivation", path)
    assert run.returncode == 2
    assert "1 proved" not in run.stdout
    # HEAD has ten lines, the statement is stated in the eleventh
    assert f"{path}:13: 'my-own' is settled twice, in lines 12 and 13" in run.stderr


def test_an_id_is_stated_once_in_a_chapter(tmp_path):
    path = chapter(tmp_path, "my", STATED, STATED, RIGHT)
    run = verify("my-own", "--derivation", path)
    assert run.returncode == 2
    assert "'my-own' is stated twice, in lines 11 and 12" in run.stderr


@pytest.mark.parametrize("last", [RIGHT, ""])
def test_an_id_is_settled_in_one_chapter(last, tmp_path):
    first = chapter(tmp_path, "first", STATED, WRONG)
    second = chapter(tmp_path, "second", STATED, last)
    for one, other in ((first, second), (second, first)):
        run = verify("my-own", "--derivation", one, "--derivation", other)
        assert run.returncode == 2
        assert "proved" not in run.stdout
        (line,) = run.stderr.splitlines()
        assert "'my-own'" in line
        assert "first.py" in line
        assert "second.py" in line


@pytest.mark.parametrize("id", ["eq6", "counting-ignores-delay"])
def test_an_id_of_ours_is_not_settled_by_somebody_else(id, tmp_path):
    stated = "" if id == "eq6" else STATED
    path = chapter(tmp_path, "my", stated, '    page.settle("{id}", Eq(x, x + 0))\n', id=id)
    run = verify("eq1", "--derivation", path)
    assert run.returncode == 2
    (line,) = run.stderr.splitlines()
    assert str(path) in line
    assert "derivations/s" in line
    assert id in line


FAILS = '    wrong = 1 / (len("") * 2)\n'


def test_a_chapter_that_raises_says_in_which_line(tmp_path):
    path = chapter(tmp_path, "my", "    helper()\n\n\ndef helper():\n", FAILS)
    run = verify("eq1", "--derivation", path)
    assert run.returncode == 2
    assert f"--derivation {path}:15: ZeroDivisionError: division by zero" in run.stderr
    assert run.stderr.count("\n") == 1
    assert run.stdout.startswith("eq1  definition")


def test_junit_and_json_have_an_error_for_a_chapter_that_raises(tmp_path):
    path, target = chapter(tmp_path, "my", FAILS), tmp_path / "out"
    run = verify("eq1", "--derivation", path, "--format", "junit", "-o", target)
    assert run.returncode == 2
    suite = ElementTree.parse(target).getroot()
    assert (suite.get("tests"), suite.get("errors")) == ("2", "1")
    cases = {case.get("name"): case for case in suite.iter("testcase")}
    assert f"{path}:11: ZeroDivisionError" in cases["my"].find("error").get("message")
    assert cases["eq1"].find("error") is None
    run = verify("eq1", "--derivation", path, "--format", "json", "-o", target)
    assert run.returncode == 2
    found = json.loads(target.read_text())
    assert [r["verdict"] for r in found["statements"]] == ["definition"]
    (error,) = found["errors"]
    assert (error["derivation"], error["line"]) == (str(path), 11)


def test_what_is_wrong_arrives_beside_packages_that_send_errors_in_their_way(monkeypatch):
    # dask.distributed has tblib register a way for every class of errors that is there
    wrong = BadChapter(Path("wrong.py"), "proves nothing", 7)
    monkeypatch.setitem(copyreg.dispatch_table, BadChapter, lambda error: (print, error.args))
    found = arrived(sent(wrong), Path("other.py"))
    assert (type(found), found.args) == (BadChapter, wrong.args)


def test_a_chapter_whose_process_dies_is_told(tmp_path):
    path = chapter(tmp_path, "my", "    import os\n    os._exit(0)\n")
    run = verify("eq1", "--derivation", path)
    assert run.returncode == 2
    assert "its process ended without a result (exit status 0)" in run.stderr


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('"""A title."""\n\n\ndef derive(page)\n    pass\n', ":4: SyntaxError: expected ':'"),
        ("def derive(page):\n    pass\n", "has no docstring"),
        ('"""A title."""\n', "has no function derive"),
    ],
)
def test_a_given_file_is_looked_at_before_anything_is_run(text, said, tmp_path, monkeypatch):
    from symhaptic.book import parallel
    from symhaptic.cli import main as cli

    path = tmp_path / "my.py"
    path.write_text(text)
    monkeypatch.setattr(parallel, "settled", lambda *_: pytest.fail("something was run"))
    monkeypatch.setattr(sys, "argv", ["symhaptic", "verify", "--derivation", str(path)])
    said_ = []
    monkeypatch.setattr(cli.typer, "echo", lambda line, **_: said_.append(line))
    with pytest.raises(SystemExit) as left:
        cli.main()
    assert left.value.code == 2
    assert said in said_[0]
    assert str(path) in said_[0]


@pytest.mark.parametrize(("ids", "behind"), [([], 0), (["mine", "eq1"], 1)])
def test_the_given_chapters_are_run_first(tmp_path, monkeypatch, ids, behind):
    from symhaptic.book import parallel
    from symhaptic.cli import main as cli

    asked = []
    monkeypatch.setattr(parallel, "settled", lambda paths, *_: asked.extend(paths) or [])
    path = chapter(tmp_path, "my", STATED, RIGHT)
    monkeypatch.setattr(sys, "argv", ["symhaptic", "verify", *ids, "--derivation", str(path)])
    with pytest.raises(SystemExit):
        cli.main()
    assert asked[0] == path
    assert len(asked) == 1 + behind  # the paper's that are named come behind


def test_the_time_of_the_suite_is_the_one_that_passed():
    from symhaptic.book import ledger, listing

    entries = ledger.ledger([])
    suite = ElementTree.fromstring(listing.junit(entries, [], False, (), 1.5))
    assert suite.get("time") == "1.500"


def test_list_names_the_statements_and_runs_nothing(monkeypatch, capsys):
    from symhaptic.book import parallel
    from symhaptic.cli import main as cli

    monkeypatch.setattr(parallel, "settled", lambda *_: pytest.fail("something was run"))
    monkeypatch.setattr("symhaptic.book.chapters.run", lambda *_: pytest.fail("something was run"))
    monkeypatch.setattr(sys, "argv", ["symhaptic", "verify", "--list", "--format", "json"])
    with pytest.raises(SystemExit) as left:
        cli.main()
    assert left.value.code == 0
    records = {r["id"]: r for r in json.loads(capsys.readouterr().out)["statements"]}
    assert records["eq11"]["location"] == "Sec. III-C"
    assert records["s3a-mass-free"]["says"]
    assert "counting-ignores-delay" in records
    assert verify("--list", "eq11").stdout.startswith("eq11  Sec. III-C  ")


def test_a_report_says_what_is_found_of_each_chapter_alone(tmp_path):
    """They are run side by side there; none may patch the package for the next, or for itself."""
    names = "--chapter", "first", "--chapter", "second", "-o", tmp_path / "out", "--format", "tex"
    for before, last in ((PATCH, WRONG), ("", PATCH + WRONG)):
        first = chapter(tmp_path, "first", before)
        second = chapter(tmp_path, "second", STATED, last)
        run = symhaptic("report", "--derivation", first, "--derivation", second, *names)
        assert run.returncode == 2, run.stdout
        assert "my-own" in run.stderr
        assert not (tmp_path / "out").exists()
    second = chapter(tmp_path, "second", STATED, RIGHT)
    run = symhaptic("report", "--derivation", first, "--derivation", second, *names)
    assert run.returncode == 0, run.stderr


def test_who_interrupts_is_left_alone_by_all_processes(tmp_path):
    """The process of the chapter and its reader end with that one, which alone says so."""
    begun = tmp_path / "begun"
    path = chapter(
        tmp_path,
        "my",
        f"    import os, time\n    open({str(begun)!r}, 'w').write(str(os.getpid()))\n"
        "    time.sleep(200)\n",
    )
    program = (  # interrupted as in a terminal, also where tests run in the background
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
        "from symhaptic.cli.main import main; main()"
    )
    run = subprocess.Popen(
        [sys.executable, "-c", program, "verify", "eq1", "--derivation", path],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    until = time.monotonic() + 100
    while not (begun.exists() and begun.read_text()) and time.monotonic() < until:
        time.sleep(0.1)
    os.killpg(run.pid, signal.SIGINT)
    assert run.communicate(timeout=60)[1] == b"symhaptic: interrupted\n"
    assert run.returncode == 130
    with pytest.raises(ProcessLookupError):
        os.kill(int(begun.read_text()), 0)
